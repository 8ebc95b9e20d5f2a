//! Which final positions can be compared, and how far two programs are apart.
//!
//! Some starts pass so close to a saddle that a rounding decides where they end. Where a peer is given twice, compiled
//! in two ways, only the points where it agrees with itself are held against ours.

use crate::Peer;

/// Two final positions this close are the same.
const SAME: f64 = 1e-12;

/// A peer and the same one compiled otherwise: `c` and `c-strict`.
pub fn twins(peers: &[Peer]) -> Option<(usize, usize)> {
    (0..peers.len()).find_map(|one| {
        let prefix = format!("{}-", peers[one].name);
        peers.iter().position(|other| other.name.starts_with(&prefix)).map(|other| (one, other))
    })
}

/// The points where both agree.
pub fn settled(one: &[[f64; 2]], other: &[[f64; 2]]) -> Vec<bool> {
    one.iter().zip(other).map(|(a, b)| apart(*a, *b) <= SAME).collect()
}

/// The largest distance among some of the points; infinite where a position is no number.
pub fn largest_distance(ours: &[[f64; 2]], theirs: &[[f64; 2]], counted: &[bool]) -> f64 {
    let pairs = ours.iter().zip(theirs).zip(counted).filter(|(_, counted)| **counted);
    pairs.fold(0.0, |largest, ((a, b), _)| match apart(*a, *b) {
        far if far > largest => far,
        far if far.is_nan() => f64::INFINITY,
        _ => largest,
    })
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_settled_points_count_and_a_nan_is_infinitely_far() {
        let one = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
        let counted = settled(&one, &[[0.0, 1e-13], [1.0, 1.1], [2.0, f64::NAN]]);
        assert_eq!(counted, [true, false, false]);
        assert_eq!(largest_distance(&[[3.0, 4.0], [9.0, 9.0], [9.0, 9.0]], &one, &counted), 5.0);
        for nan in [[f64::NAN, 0.0], [0.0, f64::NAN]] {
            assert_eq!(largest_distance(&[nan, one[1], one[2]], &one, &counted), f64::INFINITY);
        }
    }

    #[test]
    fn twins_share_a_name() {
        let peers = |names: &[&str]| -> Vec<Peer> {
            names.iter().map(|name| Peer::parse(&format!("{name}=true")).expect("a peer")).collect()
        };
        assert_eq!(twins(&peers(&["numba", "c", "c-strict"])), Some((1, 2)));
        assert_eq!(twins(&peers(&["c", "cc", "numba"])), None);
    }
}
