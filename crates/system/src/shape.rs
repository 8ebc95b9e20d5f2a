//! Sizes of a state, and what stands where in it.

/// Which coordinates have a velocity: are of second order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Second {
    /// Every one.
    All,
    /// These, in order.
    These(Vec<usize>),
}

impl Second {
    /// From the order of each coordinate: whether it is the second.
    pub fn of(each: impl Iterator<Item = bool> + Clone) -> Self {
        if each.clone().all(|second| second) {
            return Self::All;
        }
        Self::These(each.enumerate().filter(|(_, second)| *second).map(|(i, _)| i).collect())
    }
    /// How many of so many coordinates.
    #[inline(always)]
    pub fn count(&self, coordinates: usize) -> usize {
        match self {
            Self::All => coordinates,
            Self::These(these) => these.len(),
        }
    }
    /// The coordinate to which velocity number `k` belongs.
    #[inline(always)]
    pub fn coordinate(&self, k: usize) -> usize {
        match self {
            Self::All => k,
            Self::These(these) => these[k],
        }
    }
    /// Whether coordinate number `i` has a velocity.
    pub fn contains(&self, i: usize) -> bool {
        match self {
            Self::All => true,
            Self::These(these) => these.binary_search(&i).is_ok(),
        }
    }
}

/// Sizes of a state: what a method needs to know of a system.
///
/// A state is the coordinates, then the velocities of the second-order ones, then the modes (the discrete part of a hybrid
/// system, which rests between events; and what a system integrates behind the scenes). Several states that are stepped together are rows: first the coordinates of
/// all rows, then all velocities, then all modes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Number of coordinates of a row.
    pub coordinates: usize,
    /// Those of them that have a velocity.
    pub second: Second,
    /// The coordinates of a row at which a unit quaternion begins (four numbers that turn body axes into space).
    pub attitudes: Vec<usize>,
    /// Number of modes of a row.
    pub modes: usize,
    /// Number of observables.
    pub observables: usize,
    /// Number of event functions.
    pub events: usize,
    /// Number of rows.
    pub rows: usize,
}

impl Shape {
    /// Number of velocities of a row.
    #[inline(always)]
    pub fn velocities(&self) -> usize {
        self.second.count(self.coordinates)
    }
    /// Numbers that are reported as the state: coordinates and velocities.
    pub fn state(&self) -> usize {
        self.coordinates + self.velocities()
    }
    /// Numbers that are integrated: the state and the modes.
    pub fn full(&self) -> usize {
        self.state() + self.modes
    }
    /// Numbers of all rows.
    pub fn size(&self) -> usize {
        self.rows * self.full()
    }
    /// The same system with several states side by side.
    #[must_use]
    pub fn with_rows(&self, rows: usize) -> Self {
        Self { rows, ..self.clone() }
    }
    /// Where number `j` of a row's full state stands.
    pub fn place(&self, row: usize, j: usize) -> usize {
        let (coordinates, state) = (self.coordinates, self.state());
        match j {
            j if j < coordinates => row * coordinates + j,
            j if j < state => self.rows * coordinates + row * self.velocities() + (j - coordinates),
            j => self.rows * state + row * self.modes + (j - state),
        }
    }
    /// Where the numbers of each row's full state stand.
    pub fn places(&self) -> Vec<Vec<usize>> {
        (0..self.rows).map(|row| (0..self.full()).map(|j| self.place(row, j)).collect()).collect()
    }
    /// The row that each number belongs to.
    pub fn row_of_each(&self) -> Vec<usize> {
        let mut row_of_each = vec![0; self.size()];
        for (row, places) in self.places().into_iter().enumerate() {
            for place in places {
                row_of_each[place] = row;
            }
        }
        row_of_each
    }
    /// Pairs of all rows: where a second-order coordinate stands, and where its velocity.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let firsts = (0..self.rows).map(|row| row * self.coordinates);
        let coordinates = firsts
            .flat_map(move |first| (0..self.velocities()).map(move |k| first + self.second.coordinate(k)));
        coordinates.zip(self.rows * self.coordinates..)
    }
    /// What is in no pair: first-order coordinates, and modes.
    pub fn singles(&self) -> impl Iterator<Item = usize> + '_ {
        let first_order = (0..self.coordinates).filter(|i| !self.second.contains(*i));
        let of_row: Vec<usize> = first_order.chain(self.state()..self.full()).collect();
        (0..self.rows).flat_map(move |row| of_row.clone().into_iter().map(move |j| self.place(row, j)))
    }
    /// Whether every coordinate has a velocity.
    pub fn is_second_order(&self) -> bool {
        self.velocities() == self.coordinates
    }
}
