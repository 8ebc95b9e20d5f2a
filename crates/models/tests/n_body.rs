//! Any number of bodies: what lists and names make of the layout, what is refused, a closed form.

mod common;
use common::{Ready, given, ready};

fn bodies(masses: &[f64], starts: &[(&str, f64)]) -> Ready {
    let mut bodies = ready("n_body");
    bodies.values.lists[0].items = masses.to_vec();
    bodies.layout = bodies.system.layout(&bodies.values, &given(starts));
    bodies
}

#[test]
fn the_list_of_masses_makes_the_bodies() {
    let three = bodies(&[100.0, 1.0, 0.01], &[("x2", 1.1)]);
    let names: Vec<String> = three.layout.state().into_iter().map(|q| q.name).collect();
    let expected =
        ["x0", "y0", "x1", "y1", "x2", "y2", "x0_dot", "y0_dot", "x1_dot", "y1_dot", "x2_dot", "y2_dot"];
    assert_eq!(names, expected);
    let y = three.start(&[("x2", 1.1)]).expect("a sound start");
    assert_eq!(y, [-1.0, 0.0, 1.0, 0.0, 1.1, 0.0, 0.0, 1.8, 0.0, -0.18, 0.0, 0.0]);
}

#[test]
fn a_start_that_names_a_z_makes_space() {
    for name in ["z1", "z0_dot"] {
        let names: Vec<String> =
            bodies(&[1.0, 1.0], &[(name, 0.5)]).layout.state().into_iter().map(|q| q.name).collect();
        assert_eq!(names[..6], ["x0", "y0", "z0", "x1", "y1", "z1"]);
        assert_eq!(names.len(), 12);
    }
    assert_eq!(bodies(&[1.0, 1.0], &[("y0", 0.5)]).layout.coordinates.len(), 4);
}

#[test]
fn bodies_in_the_same_place_are_refused_by_name() {
    let mut four = bodies(&[1.0; 4], &[]);
    let refusal = four.start(&[]).expect_err("bodies 2 and 3 start at the origin");
    assert!(refusal.contains("bodies 2 and 3"), "{refusal}");
    four.set("softening", 0.1);
    four.start(&[]).expect("a softened force is finite there");
    let heavy = bodies(&[1.0, -1.0], &[]).start(&[]).expect_err("a negative mass");
    assert!(heavy.contains("body 1"), "{heavy}");
    bodies(&[0.0, 0.0], &[]).start(&[]).expect_err("nothing attracts");
    bodies(&[], &[]).start(&[]).expect_err("nothing at all");
}

/// Two equal masses on a circle about their centre: v^2 = k m / (4 r), whatever the plane.
#[test]
fn two_bodies_go_round_on_a_circle() {
    for axis in ["y", "z"] {
        let (first, second) = (format!("{axis}0_dot"), format!("{axis}1_dot"));
        let starts = [("y0_dot", 0.0), ("y1_dot", 0.0), (first.as_str(), 1.0), (second.as_str(), -1.0)];
        let pair = bodies(&[4.0, 4.0], &starts);
        let rate = pair.rate(&pair.start(&starts).expect("a sound start"));
        let dimensions = pair.layout.coordinates.len() / 2;
        // Both at distance 1 from the centre, drawn towards it by v^2 / r = 1.
        assert_eq!([rate[2 * dimensions], rate[3 * dimensions]], [1.0, -1.0]);
    }
}
