//! The rings of P, exercise 10: 135 asteroids, and what its program adds to their velocities.

mod common;
use common::{given, ready};
use precess_system::Bind;

#[test]
fn there_are_135_asteroids_on_125_places() {
    let cluster = ready("cluster");
    let y = cluster.start(&[]).expect("a start");
    assert_eq!(y.len(), 4 * 137);
    let mut places: Vec<[u64; 2]> =
        y[4..274].as_chunks().0.iter().map(|p: &[f64; 2]| p.map(f64::to_bits)).collect();
    assert_eq!(places.len(), 135);
    // 6.28 is no whole turn: the ten that come round once more stand a hair beside the first ones.
    places.sort_unstable();
    places.dedup();
    assert_eq!(places.len(), 135);
    let near = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 0.2;
    let all: &[[f64; 2]] = y[4..274].as_chunks().0;
    let doubled = all.iter().enumerate().filter(|(k, a)| all[..*k].iter().any(|b| near(a, b)));
    assert_eq!(doubled.count(), 10);
    // The first one of P's program: i = 2.
    assert_eq!([y[4], y[5], y[274 + 4], y[274 + 5]], [205.0, 220.0, -0.5, -0.8 - 2.4]);
}

#[test]
fn the_rings_go_with_their_body() {
    let cluster = ready("cluster");
    let moved = cluster.start(&[("x1", 0.0), ("y1_dot", 1.0), ("x5", 7.0)]).expect("a start");
    let plain = cluster.start(&[]).expect("a start");
    for body in 2..137 {
        let expected = if body == 5 { 7.0 } else { plain[2 * body] - 200.0 };
        assert_eq!(moved[2 * body], expected);
        assert_eq!(moved[2 * body + 1], plain[2 * body + 1]);
        assert_eq!(moved[274 + 2 * body + 1], plain[274 + 2 * body + 1] + 1.8);
    }
}

/// As printed: the velocities take the acceleration of body 1 once more, the positions do not.
#[test]
fn the_printed_program_adds_an_acceleration_to_the_velocities() {
    let mut cluster = ready("cluster");
    let y = cluster.start(&[]).expect("a start");
    let plain = cluster.rate(&y);
    cluster.values.choices[0] = 1;
    let printed = cluster.rate(&y);
    let mut drift = vec![0.0; y.len()];
    let field = Bind::<f64>::bind(cluster.system, cluster.values.clone(), &cluster.layout);
    assert!(field.drift(0.0, &y, &mut drift));
    assert_eq!(drift[274..], plain[274..]);
    let of_body_1 = [plain[276], plain[277]];
    for j in 278..548 {
        assert_eq!(printed[j], plain[j] + of_body_1[j % 2]);
    }
    assert_eq!(printed[274..278], plain[274..278]);
}

#[test]
fn nonsense_is_refused() {
    for (ring, word) in [
        ([1.5, 4.0, 5.0, 1.0], "asteroids"),
        ([-1.0, 4.0, 5.0, 1.0], "asteroids"),
        ([4.0, 0.0, 5.0, 1.0], "places"),
        ([4.0, 4.0, 0.0, 1.0], "radius"),
        ([1e7, 4.0, 5.0, 1.0], "asteroids"),
        ([f64::NAN, 4.0, 5.0, 1.0], "asteroids"),
    ] {
        let mut cluster = ready("cluster");
        cluster.values.lists[1].items = ring.to_vec();
        cluster.layout = cluster.system.layout(&cluster.values, &given(&[]));
        let refusal = cluster.start(&[]).expect_err("no start");
        assert!(refusal.contains(word), "{refusal}");
    }
    let cluster = ready("cluster");
    cluster.start(&[("x1", -100.0), ("y1", 0.0)]).expect_err("two bodies at one place");
}
