//! Who runs in the lanes of a block: where starts come from, and who is told of states.

use precess_scalar::Lanes;

/// Hands out starts, and is told what becomes of them.
pub trait Roster<S: Lanes> {
    /// Puts the next start, a full state, into `start` and gives its number; none where all have been handed out.
    fn next(&mut self, start: &mut [f64]) -> Option<usize>;

    /// A sample of a member, the start being number 0; false where the member need go no further.
    fn sample(&mut self, sample: u64, member: usize, y: &[f64]) -> bool;

    /// Looks at adaptive steps: bit i of the answer ends the trajectory in lane i where it is.
    fn watch(&mut self, _stepped: &Stepped<S>) -> u32 {
        0
    }
}

/// Lanes that have stepped.
pub struct Stepped<'a, S> {
    /// The member in each lane.
    pub members: &'a [Option<usize>],
    /// Bit i tells whether lane i holds a member whose step was accepted.
    pub accepted: u32,
    /// The time that each lane has reached.
    pub t: &'a S,
    /// The full states.
    pub y: &'a [S],
}

/// Starts from a list, all of which run to the end.
pub(crate) struct Listed<'a, 'r> {
    pub starts: std::iter::Enumerate<std::slice::Chunks<'a, f64>>,
    pub record: &'r mut dyn FnMut(u64, usize, &[f64]),
}

impl<S: Lanes> Roster<S> for Listed<'_, '_> {
    fn next(&mut self, start: &mut [f64]) -> Option<usize> {
        let (member, state) = self.starts.next()?;
        start.copy_from_slice(state);
        Some(member)
    }
    fn sample(&mut self, sample: u64, member: usize, y: &[f64]) -> bool {
        (self.record)(sample, member, y);
        true
    }
}
