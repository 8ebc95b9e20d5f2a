//! Bodies against other ways to their mass, centre and inertia: points thrown at random, slices, sums, turns.

use precess_models::bodies::{Matrix, SHAPES, Solid, Vector, convex, named, turned};
use precess_scalar::Scalar;

/// Splitmix64 (G. Steele, D. Lea, C. Flood 2014): evenly spread numbers in [0, 1).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn shape(id: &str, sizes: &[(&str, f64)]) -> Solid {
    named(id, sizes, &[]).expect("a sound body")
}

/// Mass, first moments and second moments of what a predicate holds to be inside, at a density of 1, each with its
/// standard error.
fn thrown(low: Vector, high: Vector, inside: impl Fn(Vector) -> bool) -> Vec<(f64, f64)> {
    const POINTS: usize = 400_000;
    let mut random = Random(20);
    let volume = (0..3).fold(1.0, |volume, i| volume * (high[i] - low[i]));
    let mut sums = vec![(0.0, 0.0); 10];
    for _ in 0..POINTS {
        let p: Vector = std::array::from_fn(|i| low[i] + (high[i] - low[i]) * random.next());
        if inside(p) {
            let [x, y, z] = p;
            for (sum, f) in sums.iter_mut().zip([1.0, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z]) {
                sum.0 += f;
                sum.1 += f * f;
            }
        }
    }
    let n = POINTS as f64;
    let error = |(sum, squares): (f64, f64)| volume * ((squares / n - (sum / n) * (sum / n)) / n).sqrt();
    sums.into_iter().map(|sum| (volume * sum.0 / n, error(sum))).collect()
}

/// The same moments from a body's mass, centre and inertia.
fn moments(solid: &Solid) -> Vec<f64> {
    let about = solid.inertia_about([0.0; 3]);
    let half_trace = (about[0][0] + about[1][1] + about[2][2]) / 2.0;
    let first = solid.centre.map(|c| solid.mass * c);
    let second = [0, 1, 2].map(|i| half_trace - about[i][i]);
    let products = [-about[0][1], -about[0][2], -about[1][2]];
    [&[solid.mass], &first[..], &second, &products].concat()
}

#[test]
fn points_thrown_at_random_find_mass_centre_and_inertia() {
    let of = |id: &str, sizes: &[(&str, f64)]| shape(id, &[&[("density", 1.0)], sizes].concat());
    let square = |[x, y, _]: Vector| x * x + y * y;
    let check = |solid: Solid, low: Vector, high: Vector, inside: &dyn Fn(Vector) -> bool| {
        for (k, ((found, error), exact)) in
            thrown(low, high, inside).into_iter().zip(moments(&solid)).enumerate()
        {
            // The error itself must be small, or the bound would hold for anything.
            assert!(
                error < 0.02 * solid.mass && (found - exact).abs() <= 4.5 * error,
                "{k}: {found} is not {exact}"
            );
        }
    };
    let one = [1.0; 3];
    check(of("sphere", &[("radius", 1.0)]), one.map(|x| -x), one, &|p| square(p) + p[2] * p[2] < 1.0);
    let cylinder = of("cylinder", &[("radius", 0.6), ("length", 1.4)]);
    check(cylinder, [-0.6, -0.6, -0.7], [0.6, 0.6, 0.7], &|p| square(p) < 0.36);
    let cone = of("cone", &[("radius", 0.5), ("height", 1.5)]);
    check(cone, [-0.5, -0.5, 0.0], [0.5, 0.5, 1.5], &|p| square(p) < p[2] * p[2] / 9.0);
    let cut = of("truncated_sphere", &[("radius", 1.0), ("cut", 0.75)]);
    check(cut, one.map(|x| -x), [1.0, 1.0, 0.25], &|p| square(p) + p[2] * p[2] < 1.0);
    let (a, b, c) = (1.2, 0.7, 0.5);
    let ellipsoid = of("ellipsoid", &[("a", a), ("b", b), ("c", c)]);
    let within = |[x, y, z]: Vector| (x / a).squared() + (y / b).squared() + (z / c).squared() < 1.0;
    check(ellipsoid, [-a, -b, -c], [a, b, c], &within);
    let egg = of("egg", &[("radius", 0.8), ("blunt", 0.7), ("sharp", 1.3)]);
    let within = |p: Vector| square(p) / 0.64 + (p[2] / if p[2] < 0.0 { 0.7 } else { 1.3 }).squared() < 1.0;
    check(egg, [-0.8, -0.8, -0.7], [0.8, 0.8, 1.3], &within);
    // A sum off the axis: products of inertia count too.
    let ball = of("sphere", &[("radius", 0.3)]).moved([0.5, -0.4, 0.6]);
    let sum = of("sphere", &[("radius", 0.2)]).moved([-0.6, 0.3, 0.1]).with(ball);
    let near = |p: Vector, q: Vector| (0..3).fold(0.0, |sum, i| sum + (p[i] - q[i]).squared());
    let within = |p: Vector| near(p, [0.5, -0.4, 0.6]) < 0.09 || near(p, [-0.6, 0.3, 0.1]) < 0.04;
    check(sum, [-0.8, -0.7, -0.1], [0.8, 0.5, 0.9], &within);
}

#[test]
fn thin_bodies_are_limits_of_the_cylinder() {
    let near = |a: &Solid, b: &Solid, part: f64| {
        for (x, y) in moments(a).into_iter().zip(moments(b)) {
            assert!((x - y).abs() <= part * (1e-300 + x.abs()), "{x} is not {y}");
        }
    };
    let disc = shape("cylinder", &[("mass", 2.0), ("radius", 0.3), ("length", 1e-9)]);
    let sizes = [("mass", 2.0), ("radius", 0.3)];
    let thin = moments(&shape("disc", &sizes));
    assert!((moments(&disc)[4] - thin[4]).abs() < 1e-14 && thin[6].abs() < 1e-16);
    near(&shape("disc", &sizes), &Solid { surface: disc.surface.clone(), ..shape("disc", &sizes) }, 0.0);
    let bar = moments(&shape("bar", &[("mass", 2.0), ("length", 0.6)]));
    assert!((bar[6] - 2.0 * 0.36 / 12.0).abs() < 1e-16 && bar[4].abs() < 1e-17);
    // A sphere without a cap, an egg with equal ends and an even ellipsoid are the sphere.
    let sphere = shape("sphere", &[("density", 3.0), ("radius", 0.2)]);
    near(&sphere, &shape("truncated_sphere", &[("density", 3.0), ("radius", 0.2), ("cut", 0.0)]), 1e-14);
    let ends = [("density", 3.0), ("radius", 0.2), ("blunt", 0.2), ("sharp", 0.2)];
    near(&sphere, &shape("egg", &ends), 1e-14);
    let axes = [("density", 3.0), ("a", 0.2), ("b", 0.2), ("c", 0.2)];
    near(&sphere, &shape("ellipsoid", &axes), 1e-14);
}

/// The radii of N slices of a profile.
fn radii(n: usize, height: f64, r: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..n).map(|i| r((i as f64 + 0.5) * height / n as f64)).collect()
}

#[test]
fn slices_converge_with_order_two() {
    let cone = moments(&shape("cone", &[("density", 1.0), ("height", 1.5), ("radius", 0.5)]));
    let sizes = [("density", 1.0), ("height", 1.5)];
    let errors = |n: usize| -> Vec<f64> {
        let sliced = named("profile", &sizes, &radii(n, 1.5, |z| z / 3.0)).expect("a profile");
        moments(&sliced).iter().zip(&cone).map(|(a, b)| (a - b).abs()).collect()
    };
    for (coarse, fine) in errors(50).into_iter().zip(errors(100)) {
        if coarse > 0.0 {
            let ratio = coarse / fine;
            assert!((ratio - 4.0).abs() < 0.01, "twice the slices make the error {ratio} times smaller");
        }
    }
}

/// Straight and parabolic profiles are their own smooth curve; on others it converges faster than slices do.
#[test]
fn a_smooth_profile_is_exact_where_the_curve_is() {
    let exact = moments(&shape("cone", &[("density", 1.0), ("height", 1.5), ("radius", 0.5)]));
    let sizes = [("density", 1.0), ("height", 1.5)];
    let smooth = named("smooth_profile", &sizes, &radii(5, 1.5, |z| z / 3.0)).expect("a profile");
    for (a, b) in moments(&smooth).iter().zip(&exact) {
        assert!((a - b).abs() <= 1e-14, "{a} is not {b}");
    }
    let bump = |z: f64| 0.3 + 0.1 * Scalar::sin(3.0 * z);
    let error = |id: &str, n: usize| {
        let fine = named("smooth_profile", &sizes, &radii(3000, 1.5, bump)).expect("a profile");
        let coarse = named(id, &sizes, &radii(n, 1.5, bump)).expect("a profile");
        (coarse.inertia[0][0] - fine.inertia[0][0]).abs() / fine.inertia[0][0]
    };
    assert!(error("profile", 40) < 1e-3 && error("smooth_profile", 40) < 0.02 * error("profile", 40));
}

#[test]
fn hollow_profiles_are_told_from_convex_ones() {
    assert!(convex(&[0.1, 0.3, 0.4, 0.3]).is_ok());
    assert!(convex(&[0.1, 0.2, 0.3]).is_ok(), "a cone is convex");
    let why = convex(&[0.1, 0.3, 0.2, 0.4]).expect_err("hollow");
    assert!(why.contains("radius 3"), "{why}");
}

/// `R I R^T` by its columns, and the principal axes lead back.
#[test]
fn inertia_turns_and_is_made_diagonal_again() {
    let inertia: Matrix = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.5]];
    let quarter = std::f64::consts::PI / 2.0;
    let tipped = turned(inertia, [0.0, quarter, 0.0]);
    for (i, moment) in [1.0, 2.5, 2.0].into_iter().enumerate() {
        assert!((tipped[i][i] - moment).abs() < 1e-15, "theta turns axis 2 into axis 3");
    }
    let moved = turned(inertia, [0.4, 1.1, -2.0]);
    let sizes = [("mass", 1.0), ("radius", 0.1)];
    let (moments, axes) = Solid { inertia: moved, ..shape("sphere", &sizes) }.principal();
    for (k, moment) in [1.0, 2.0, 2.5].into_iter().enumerate() {
        assert!((moments[k] - moment).abs() < 1e-14);
        for row in 0..3 {
            let image: f64 = (0..3).map(|column| moved[row][column] * axes[k][column]).sum();
            assert!((image - moment * axes[k][row]).abs() < 1e-14, "axis {k}");
        }
    }
}

/// The support function is the reach of the farthest point, and no farther point lies on the surface.
#[test]
fn the_support_function_is_the_largest_reach() {
    let samples: Vec<(&str, Vec<(&str, f64)>)> = vec![
        ("sphere", vec![("radius", 0.3)]),
        ("cylinder", vec![("radius", 0.3), ("length", 0.5), ("edge", 0.02)]),
        ("cone", vec![("radius", 0.3), ("height", 0.5), ("tip", 0.01)]),
        ("disc", vec![("radius", 0.3)]),
        ("egg", vec![("radius", 0.3), ("blunt", 0.25), ("sharp", 0.5)]),
        ("ellipsoid", vec![("a", 0.4), ("b", 0.3), ("c", 0.2), ("lower", 0.05)]),
    ];
    let mut random = Random(7);
    for (id, sizes) in samples {
        let solid = shape(id, &[&[("mass", 1.0)], &sizes[..]].concat()).moved([0.1, 0.0, -0.2]);
        let directions: Vec<Vector> = (0..40).map(|_| [0, 1, 2].map(|_| random.next() - 0.5)).collect();
        let dot = |a: Vector, b: Vector| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        for n in &directions {
            let reach = solid.support(*n);
            assert!((dot(solid.farthest(*n), *n) - reach).abs() < 1e-15, "{id}");
            assert!((solid.support(n.map(|x| 3.0 * x)) - 3.0 * reach).abs() < 1e-14, "{id} is homogeneous");
            for m in &directions {
                assert!(dot(solid.farthest(*m), *n) <= reach + 1e-15, "{id}: a point beyond the support");
            }
        }
    }
}

/// T's cone rests on its tip, the truncated sphere on its complete sphere; form and surface agree where both hold.
#[test]
fn the_form_is_the_lowest_part_of_the_surface() {
    let cone = shape("cone", &[("density", 100.0), ("height", 0.15), ("radius", 0.05)]);
    let form = cone.form().expect("a tip");
    assert_eq!((form.radius, form.axes), (0.0, [0.0; 3]));
    assert!((form.point[2] + 0.1125).abs() < 1e-16);
    let top = shape("truncated_sphere", &[("density", 700.0), ("radius", 0.02), ("cut", 0.015)]);
    let form = top.form().expect("a sphere");
    assert_eq!(form.radius, 0.02);
    assert!((form.point[2] - 0.75 * 0.015 * 0.015 / 0.035).abs() < 1e-17);
    assert!(shape("egg", &[("mass", 1.0), ("radius", 0.3), ("blunt", 0.2), ("sharp", 0.4)]).form().is_none());
    let rattleback =
        shape("ellipsoid", &[("mass", 1.0), ("a", 0.2), ("b", 0.03), ("c", 0.02), ("lower", 0.01)]);
    let (form, n) = (rattleback.form().expect("an ellipsoid"), [0.3, -0.5, -0.8]);
    let axes = form.axes;
    let reach = (0..3).fold(0.0, |sum, i| sum + (axes[i] * n[i]).squared()).sqrt() + form.point[2] * n[2];
    assert!((rattleback.support(n) - reach).abs() < 1e-16);
}

#[test]
fn what_makes_no_body_is_said() {
    let refusal =
        |id: &str, sizes: &[(&str, f64)], radii: &[f64]| named(id, sizes, radii).expect_err("no body");
    assert!(refusal("cube", &[], &[]).contains("sphere, cylinder"));
    assert!(refusal("sphere", &[("radius", 0.1)], &[]).contains("density or a mass"));
    assert!(refusal("sphere", &[("radius", 0.1), ("mass", 0.0)], &[]).contains("above zero"));
    assert!(refusal("sphere", &[("radius", 0.1), ("density", -1.0)], &[]).contains("above zero"));
    assert!(refusal("sphere", &[("radius", 0.1), ("mass", 1.0), ("density", 1.0)], &[]).contains("both"));
    assert!(refusal("sphere", &[("mass", 1.0)], &[]).contains("radius"));
    assert!(refusal("sphere", &[("radius", f64::NAN), ("mass", 1.0)], &[]).contains("finite"));
    assert!(refusal("sphere", &[("radius", 1e200), ("density", 1.0)], &[]).contains("finite"));
    assert!(refusal("bar", &[("length", 1.0), ("density", 1.0)], &[]).contains("no volume"));
    assert!(
        refusal("cone", &[("height", 1.0), ("radius", 0.5), ("tip", 0.6), ("mass", 1.0)], &[])
            .contains("rounded")
    );
    assert!(
        refusal("truncated_sphere", &[("radius", 0.1), ("cut", 0.2), ("mass", 1.0)], &[]).contains("cap")
    );
    assert!(refusal("profile", &[("height", 1.0), ("mass", 1.0)], &[]).contains("radii"));
    assert!(refusal("profile", &[("height", 1.0), ("mass", 1.0)], &[0.1, -0.1]).contains("radius 2"));
    assert!(refusal("profile", &[("height", 1.0), ("mass", 1.0)], &[0.0, 0.0]).contains("zero"));
    assert!(refusal("sphere", &[("radius", 0.1), ("mass", 1.0)], &[0.1]).contains("no list"));
    for card in SHAPES {
        assert!(
            !card.title.0.is_empty() && !card.title.1.is_empty() && !card.source.is_empty(),
            "{}",
            card.id
        );
    }
}

/// A tippe top inverts where `1 - alpha^2 < I1 / I3 < 1`; a homogeneous truncated sphere does so only beyond a cut of 1.486 radii.
#[test]
fn a_truncated_sphere_inverts_only_with_a_deep_cut() {
    let margin = |cut: f64| {
        let top = shape("truncated_sphere", &[("density", 700.0), ("radius", 1.0), ("cut", cut)]);
        let alpha = -top.centre[2];
        top.inertia[0][0] / top.inertia[2][2] - (1.0 - alpha * alpha)
    };
    let (mut low, mut high) = (0.1, 1.9);
    assert!(margin(low) < 0.0 && margin(high) > 0.0);
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        if margin(middle) < 0.0 { low = middle } else { high = middle }
    }
    assert!((low - 1.486).abs() < 5e-4, "the cut is {low} radii");
    assert!(margin(0.75) < 0.0, "T's own top, cut by 0.75 R, cannot");
}
