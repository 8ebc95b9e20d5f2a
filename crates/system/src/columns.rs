//! The columns of a table.

use std::fmt;
use std::sync::Arc;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// Time.
    Time,
    /// A number of the state.
    State,
    /// An observable that moves.
    Signal,
    /// An observable that ought to stay constant with the parameters of this run.
    Invariant,
}

/// A column of a trajectory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name, as on the card.
    pub name: String,
    /// Unit; empty for a pure number.
    pub unit: String,
    /// What it holds.
    pub kind: ColumnKind,
}

/// Columns in order, made when somebody asks for one: a run may have millions.
#[derive(Clone)]
pub struct Columns {
    count: usize,
    make: Arc<dyn Fn(usize) -> Column + Send + Sync>,
}

impl Columns {
    /// So many, each made from its number.
    pub fn new(count: usize, make: impl Fn(usize) -> Column + Send + Sync + 'static) -> Self {
        Self { count, make: Arc::new(make) }
    }
    /// How many.
    pub fn len(&self) -> usize {
        self.count
    }
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }
    /// One of them.
    pub fn get(&self, k: usize) -> Column {
        (self.make)(k)
    }
    /// All, one after another.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Column> + '_ {
        (0..self.count).map(|k| self.get(k))
    }
    /// The first ones.
    #[must_use]
    pub fn first(&self, count: usize) -> Self {
        Self { count, ..self.clone() }
    }
    /// How many at the beginning are of some kinds, after which none is.
    pub fn count_leading(&self, fits: impl Fn(ColumnKind) -> bool) -> usize {
        let (mut low, mut high) = (0, self.count);
        while low < high {
            let middle = usize::midpoint(low, high);
            if fits(self.get(middle).kind) { low = middle + 1 } else { high = middle }
        }
        low
    }
}

impl From<Vec<Column>> for Columns {
    fn from(columns: Vec<Column>) -> Self {
        Self::new(columns.len(), move |k| columns[k].clone())
    }
}
impl FromIterator<Column> for Columns {
    fn from_iter<I: IntoIterator<Item = Column>>(columns: I) -> Self {
        columns.into_iter().collect::<Vec<_>>().into()
    }
}
impl Default for Columns {
    fn default() -> Self {
        vec![].into()
    }
}
impl PartialEq for Columns {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}
impl fmt::Debug for Columns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}
