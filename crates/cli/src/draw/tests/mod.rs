//! What a drawing must never do, over figures that invite it.

mod pixels;

use precess::figure::{Curve, Figure, Map, Mark, Panel, Sign, Stroke};

use crate::draw::png::KEYWORD;
use crate::draw::{png, svg};

fn curve(label: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Curve {
    let (x, y) = points.into_iter().unzip();
    Curve { label: label.to_owned(), x, y, ..Curve::default() }
}

fn panel(curves: Vec<Curve>) -> Panel {
    Panel { x_label: "t [s]".into(), y_label: "θ [rad]".into(), curves, ..Panel::default() }
}

fn figure(panels: Vec<Panel>) -> Figure {
    let scenario = "a = \"<&>\"\r\n# θ̇ ]]> \"quoted\"\n\ttail".to_owned();
    Figure { title: "A & <b>".into(), subtitle: "1 < 2 $x^2$ $".into(), panels, scenario }
}

fn sine(n: u32) -> Curve {
    curve("sine", (0..n).map(|i| f64::from(i) * 0.01).map(|t| (t, t.sin())))
}

/// Points that have broken plots before.
fn nasty() -> Vec<Vec<(f64, f64)>> {
    let nan = f64::NAN;
    let circle = std::f64::consts::TAU;
    vec![
        vec![],
        vec![(3.0, -2.0)],
        vec![(0.0, 0.0); 4],
        vec![(0.0, 1.5), (1.0, 1.5)],
        vec![(1.0, 0.0), (1.0, 5.0)],
        vec![(nan, nan), (nan, 1.0)],
        vec![(0.0, f64::INFINITY), (1.0, f64::NEG_INFINITY)],
        vec![(-1e300, -1e300), (1e300, 1e300)],
        vec![(0.0, -f64::MAX), (f64::MAX, f64::MAX)],
        vec![(0.0, 1e305), (1.0, 1e305)],
        vec![(5e-324, 5e-324), (1e-323, 2e-320)],
        vec![(0.0, circle), (1.0, circle.next_up()), (2.0, circle.next_down())],
        vec![(1e15, -1e-14), (1e15 + 1.0, 1e-14)],
        vec![(0.0, -1.0), (1.0, 0.0), (2.0, -0.0)],
        vec![(0.0, 1e-300), (1.0, 1e300)],
        vec![(1e-12, 3e5), (2e-12, 4e9)],
    ]
}

fn variants(points: &[(f64, f64)]) -> Vec<Figure> {
    let mut figures = Vec::new();
    for (equal_scales, logarithmic) in [(false, false), (true, false), (false, true), (true, true)] {
        let marks =
            points.iter().map(|&(x, y)| Mark { label: "m".into(), x, y, ..Mark::default() }).collect();
        let bare = panel(vec![curve("c", points.iter().copied())]);
        let one = Panel { equal_scales, logarithmic, ..bare };
        let marked = Panel { marks, curves: Vec::new(), ..one.clone() };
        figures.push(figure(vec![one.clone()]));
        figures.push(figure(vec![one, marked]));
    }
    figures
}

/// The values of an attribute, in order.
fn values<'a>(svg: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    svg.split(&start).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// The paths of the curves.
fn paths(svg: &str) -> Vec<&str> {
    values(svg, "d")
}

#[test]
fn nothing_breaks_a_drawing() {
    for points in nasty() {
        for figure in variants(&points) {
            let drawn = svg(&figure);
            for forbidden in ["NaN", "inf", "e-"] {
                let hidden = values(&drawn, "x1").iter().chain(&paths(&drawn)).any(|v| v.contains(forbidden));
                assert!(!hidden, "{forbidden} for {points:?}");
            }
            let tree = resvg::usvg::Tree::from_str(&drawn, &resvg::usvg::Options::default());
            assert!(tree.is_ok(), "not an SVG for {points:?}: {:?}", tree.err());
        }
    }
    assert!(png(&Figure::default()).is_ok());
}

#[test]
fn everything_drawn_stays_on_the_page() {
    for points in nasty() {
        for figure in variants(&points) {
            let drawn = svg(&figure);
            let size = |a: &str| values(&drawn, a)[0].parse::<f64>().unwrap();
            let (wide, high) = (size("width"), size("height"));
            let within = |a: &str, end: f64| {
                values(&drawn, a).iter().all(|v| (0.0..=end).contains(&v.parse::<f64>().unwrap()))
            };
            assert!(within("x1", wide) && within("x2", wide) && within("cx", wide), "{points:?}");
            assert!(within("y1", high) && within("y2", high) && within("cy", high), "{points:?}");
        }
    }
}

#[test]
fn every_label_appears() {
    let mut panels: Vec<Panel> = (0..9).map(|_| panel(vec![sine(100)])).collect();
    for (i, panel) in panels.iter_mut().enumerate() {
        panel.title = format!("title <{i}>");
        panel.x_label = format!("abscissa {i}");
        panel.y_label = format!("ordinate {i}");
        panel.marks = vec![Mark { label: format!("mark {i}"), x: 0.5, y: 0.5, ..Mark::default() }];
    }
    for count in 1..=panels.len() {
        let drawn = svg(&figure(panels[..count].to_vec()));
        for i in 0..count {
            for label in [format!("title &lt;{i}&gt;"), format!("abscissa {i}"), format!("ordinate {i}")] {
                assert!(drawn.contains(&format!(">{label}</text>")), "{label} of {count}");
            }
            assert!(drawn.contains(&format!(">mark {i}</text>")));
        }
    }
    assert!(svg(&figure(Vec::new())).contains("1 &lt; 2 $x^2$ $"));
}

#[test]
fn names_appear_only_where_curves_must_be_told_apart() {
    let named = |n: usize| vec![sine(50); n].into_iter().enumerate();
    let curves = |n| named(n).map(|(i, c)| Curve { label: format!("curve {i}"), ..c }).collect();
    assert!(!svg(&figure(vec![panel(curves(1))])).contains("curve 0"));
    let two = svg(&figure(vec![panel(curves(2))]));
    assert!(two.contains(">curve 0</text>") && two.contains(">curve 1</text>"));
    assert!(svg(&figure(vec![panel(curves(300))])).contains(" more</text>"));
}

#[test]
fn a_point_that_is_not_finite_interrupts_the_curve() {
    let whole = sine(400);
    let mut broken = whole.clone();
    broken.y[200] = f64::NAN;
    let moves = |c: Curve| paths(&svg(&figure(vec![panel(vec![c])])))[0].matches('M').count();
    assert_eq!((moves(whole.clone()), moves(broken)), (1, 2));
    let negative = Panel { logarithmic: true, ..panel(vec![whole]) };
    assert_eq!(paths(&svg(&figure(vec![negative])))[0].matches('M').count(), 1);
}

#[test]
fn a_circle_is_round_where_scales_are_equal() {
    let circle = curve(
        "",
        (0..=360).map(|i| (3e-9 * f64::from(i).to_radians().cos(), 3e-9 * f64::from(i).to_radians().sin())),
    );
    let plane = Panel { equal_scales: true, ..panel(vec![circle]) };
    for panels in [vec![plane.clone()], vec![plane.clone(), panel(vec![sine(300)])], vec![plane; 5]] {
        let drawn = svg(&figure(panels));
        let numbers: Vec<f64> = paths(&drawn)[0]
            .split(['M', 'L', ' '])
            .filter(|s| !s.is_empty())
            .map(|s| s.parse().unwrap())
            .collect();
        let extent = |offset: usize| {
            let values = numbers.iter().skip(offset).step_by(2);
            values.clone().fold(0.0f64, |a, &b| a.max(b)) - values.fold(1e9f64, |a, &b| a.min(b))
        };
        assert!((extent(0) - extent(1)).abs() < 0.1 && extent(0) > 100.0, "{} {}", extent(0), extent(1));
    }
}

#[test]
fn ticks_say_what_the_data_are() {
    let ticks = |points: &[(f64, f64)]| svg(&figure(vec![panel(vec![curve("", points.iter().copied())])]));
    let drift = ticks(&[(0.0, -2e-12), (1.0, 2e-12)]);
    assert!(drift.contains(">−1.0×10⁻¹²<") && drift.contains(">0<") && !drift.contains(">-"));
    let turn = ticks(&[(0.0, 5.2831853 - 1e-14), (1.0, 5.2831853 + 1e-14)]);
    assert!(turn.contains("θ [rad] − 5.2831853<") && turn.contains("×10⁻¹⁴<"), "{turn}");
    let late = ticks(&[(1e6, 0.0), (1e6 + 3.0, 1.0)]);
    assert!(late.contains("t [s] − 1000000<"));
    let huge = ticks(&[(0.0, 0.0), (1.0, 1e300)]);
    assert!(huge.contains(">1.0×10³⁰⁰<"));
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let figure = figure(vec![panel(vec![sine(500), sine(80)]), panel(vec![sine(9)])]);
    assert_eq!(svg(&figure), svg(&figure));
    assert_eq!(png(&figure).unwrap(), png(&figure).unwrap());
}

#[test]
fn the_scenario_comes_back_out_of_both() {
    let figure = figure(vec![panel(vec![sine(50)])]);
    let drawn = svg(&figure);
    let metadata = drawn.split("<metadata id=\"precess-scenario\">").nth(1).unwrap();
    let metadata = metadata.split("</metadata>").next().unwrap();
    let read =
        metadata.replace("&lt;", "<").replace("&gt;", ">").replace("&#13;", "\r").replace("&amp;", "&");
    assert_eq!(read, figure.scenario);
    let bytes = png(&figure).unwrap();
    let reader = ::png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let chunk = reader.info().utf8_text.iter().find(|c| c.keyword == KEYWORD).unwrap();
    assert_eq!(chunk.get_text().unwrap(), figure.scenario);
}

#[test]
fn control_characters_do_not_reach_the_file() {
    let hostile = Figure { title: "a\u{0}\u{1b}[31m\u{ffff}b".into(), ..figure(vec![panel(vec![sine(50)])]) };
    let drawn = svg(&hostile);
    assert!(drawn.contains(">a[31mb</text>") && !drawn.contains(['\u{0}', '\u{1b}', '\u{ffff}']));
    assert!(png(&hostile).is_ok());
}

#[test]
fn a_range_cuts_the_curve_at_its_border() {
    // A straight line from corner to corner of twice the range: it enters and leaves half-way.
    let long = curve("", [(-2.0, -2.0), (2.0, 2.0)]);
    let range = Some((-1.0, 1.0));
    let cut =
        Panel { x_range: range, y_range: range, ..panel(vec![long, curve("", [(-1.0, -1.0), (1.0, 1.0)])]) };
    let drawn = svg(&figure(vec![cut.clone()]));
    let drawn = paths(&drawn);
    assert_eq!(drawn.len(), 2);
    assert_eq!(drawn[0], drawn[1]);
    let outside = Panel { curves: vec![curve("", [(3.0, 3.0), (4.0, 5.0)])], ..cut };
    assert!(paths(&svg(&figure(vec![outside]))).is_empty());
}

#[test]
fn the_cells_of_a_map_fill_the_box_without_a_gap() {
    let classes: Vec<i32> = (0..30).map(|k| k % 3 - 1).collect();
    let map = Map { x: (0.0, 9.0), y: (0.0, 2.0), columns: 10, classes, names: vec![] };
    let drawn = svg(&figure(vec![Panel { map: Some(map), ..panel(vec![]) }]));
    let numbers =
        |d: &str| d.split(['M', 'h', 'v', 'z', ' ']).filter_map(|n| n.parse().ok()).collect::<Vec<f64>>();
    let area: f64 = paths(&drawn)
        .iter()
        .flat_map(|d| numbers(d).chunks(5).map(|cell| (cell[2] * cell[3]).abs()).collect::<Vec<_>>())
        .sum();
    // Sides in hundredths of a pixel: thirty cells are right to a part in a thousand.
    let (wide, high) = extent_of(&paths(&drawn).iter().flat_map(|d| numbers(d)).collect::<Vec<_>>());
    assert!((area / (wide * high) - 1.0).abs() < 1e-3, "{area} {wide} {high}");
}

#[test]
fn the_classes_of_a_map_are_shown_with_their_patterns() {
    let map = |names: &[&str]| Map {
        x: (0.0, 9.0),
        y: (0.0, 2.0),
        columns: 10,
        classes: vec![0; 30],
        names: names.iter().map(|name| (*name).into()).collect(),
    };
    let drawn = |names: &[&str]| svg(&figure(vec![Panel { map: Some(map(names)), ..panel(vec![]) }]));
    let named = drawn(&["left", "right"]);
    assert!(named.contains(">left</text>") && named.contains(">right</text>"));
    // The map has one plain colour; of the samples the first has it, too, and the second two shades.
    assert_eq!((paths(&drawn(&[])).len(), paths(&named).len()), (1, 4));
}

#[test]
fn the_texts_of_marks_do_not_lie_on_one_another() {
    let marked = |places: &[(f64, f64)]| {
        let mark = |&(x, y): &(f64, f64)| Mark { x, y, label: "a saddle".into(), ..Mark::default() };
        svg(&figure(vec![Panel { marks: places.iter().map(mark).collect(), ..panel(vec![sine(50)]) }]))
    };
    let texts = |drawn: &str| drawn.matches(">a saddle</text>").count();
    assert_eq!(texts(&marked(&[(1.0, 0.0), (3.0, 0.0)])), 2);
    // About one place there is room for four; whoever comes then has a sign alone.
    assert_eq!(texts(&marked(&[(3.0, 0.0); 4])), 4);
    assert_eq!(texts(&marked(&[(3.0, 0.0); 9])), 4);
}

/// Width and height that cells (x, y, width, height, -width) cover.
fn extent_of(cells: &[f64]) -> (f64, f64) {
    let of = |at: usize, side: usize| {
        let ends = || cells.chunks(5).flat_map(move |c| [c[at], c[at] + c[side]]);
        ends().fold(f64::MIN, f64::max) - ends().fold(f64::MAX, f64::min)
    };
    (of(0, 2), of(1, 3))
}

#[test]
fn strokes_and_signs_differ() {
    let styled = |stroke| Curve { stroke, ink: Some(3), label: String::new(), ..sine(200) };
    let drawn =
        svg(&figure(vec![panel(vec![styled(Stroke::Line), styled(Stroke::Thin), styled(Stroke::Dashed)])]));
    let widths: Vec<&str> = values(&drawn, "stroke-width").into_iter().rev().take(3).collect();
    assert!(widths.contains(&"0.55"), "{widths:?}");
    assert_eq!(values(&drawn, "stroke-dasharray"), ["5 4"]);
    let dots = svg(&figure(vec![panel(vec![styled(Stroke::Dots)])]));
    assert!(paths(&dots)[0].matches('M').count() > 150);
    let mark = |sign| Mark { sign, x: 1.0, y: 0.5, ..Mark::default() };
    let signs = [Sign::Dot, Sign::Ring, Sign::Cross, Sign::Ball].map(mark).to_vec();
    let marked = svg(&figure(vec![Panel { marks: signs, ..panel(vec![sine(10)]) }]));
    assert_eq!(values(&marked, "r"), ["4", "4", "8"]);
}
