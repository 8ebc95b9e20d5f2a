//! The point at which an equation is evaluated.

use crate::Values;

/// Time, coordinates, velocities, modes and parameters, as an equation sees them.
///
/// A model takes them apart in the order of its card:
///
/// ```ignore
/// let ([theta], [theta_dot], [m, l, g]) = (s.q(), s.v(), s.p());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct State<'a, S> {
    /// Time.
    pub t: S,
    /// The coordinates.
    pub coordinates: &'a [S],
    /// The velocities of the second-order coordinates.
    pub velocities: &'a [S],
    /// The modes of a hybrid system.
    pub modes: &'a [S],
    /// The parameters.
    pub values: &'a Values<S>,
}

/// The first `N` numbers; the laws run every equation, so a model that asks for too many is caught there.
#[inline(always)]
fn first<S: Copy, const N: usize>(numbers: &[S]) -> [S; N] {
    *numbers.first_chunk().expect("a model asks for no more numbers than its card declares")
}

impl<S: Copy> State<'_, S> {
    /// The first `N` coordinates.
    #[inline(always)]
    pub fn q<const N: usize>(&self) -> [S; N] {
        first(self.coordinates)
    }
    /// The first `N` velocities.
    #[inline(always)]
    pub fn v<const N: usize>(&self) -> [S; N] {
        first(self.velocities)
    }
    /// The first `N` modes.
    #[inline(always)]
    pub fn m<const N: usize>(&self) -> [S; N] {
        first(self.modes)
    }
    /// The first `N` numeric parameters.
    #[inline(always)]
    pub fn p<const N: usize>(&self) -> [S; N] {
        first(&self.values.numbers)
    }
    /// The `k`-th list parameter.
    #[inline(always)]
    pub fn list(&self, k: usize) -> &[S] {
        &self.values.lists[k].items
    }
    /// The `k`-th list parameter, in items of `W` numbers.
    #[inline(always)]
    pub fn rows<const W: usize>(&self, k: usize) -> &[[S; W]] {
        self.values.lists[k].items.as_chunks().0
    }
    /// The `k`-th choice, as an index into its options.
    #[inline(always)]
    pub fn choice(&self, k: usize) -> usize {
        self.values.choices[k]
    }
}
