//! What the eye would see: pixels, letters, and points that thinning left out.

use precess::figure::Figure;

use super::{curve, figure, panel, sine, values};
use crate::draw::thin::thinned;
use crate::draw::{png, svg, text};

/// Pixels of a PNG darker than the paper, within the given part of the picture's height.
fn ink(bytes: &[u8], part: std::ops::Range<f64>) -> (u32, u32, usize) {
    let mut reader = ::png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let rows: Vec<&[u8]> = pixels.chunks(info.line_size).collect();
    let at = |s: f64| (s * rows.len() as f64) as usize;
    let dark = rows[at(part.start)..at(part.end)].iter().flat_map(|r| r.chunks(3)).filter(|p| p[0] < 140);
    (info.width, info.height, dark.count())
}

#[test]
fn a_png_has_its_size_and_its_ink_without_any_font_installed() {
    let figure = figure(vec![panel(vec![sine(500)])]);
    let drawn = svg(&figure);
    let size = |a: &str| values(&drawn, a)[0].parse::<u32>().unwrap();
    let (wide, high, all) = ink(&png(&figure).unwrap(), 0.0..1.0);
    assert_eq!((wide, high), (2 * size("width"), 2 * size("height")));
    assert!(all > 5000, "{all}");
    let words = Figure { title: "θψφω ²³⁻¹ °′".into(), ..Figure::default() };
    let (.., letters) = ink(&png(&words).unwrap(), 0.0..1.0);
    assert!(letters > 600, "{letters}: the letters are missing");
}

#[test]
fn the_embedded_face_has_the_letters_of_mechanics() {
    for c in "θψφωαβγΔΩλμπσ²³⁴⁻¹⁰₀₁₂₉°′″·×−≈∞ħ∂√é–".chars()
    {
        let once = text::width(&c.to_string(), 20);
        assert!(once > 0.0 && text::has(c), "{c}");
    }
}

#[test]
fn thinning_keeps_extremes_within_a_pixel() {
    let noise = |i: u32| f64::from(i.wrapping_mul(2654435761) >> 8) / f64::from(1u32 << 24);
    let wave: Vec<(f64, f64)> = (0..400_000).map(|i| (f64::from(i) / 500.0, 300.0 * noise(i))).collect();
    let loops: Vec<(f64, f64)> = (0..400_000)
        .map(|i| (f64::from(i) * 0.31).sin_cos())
        .zip(0..)
        .map(|((s, c), i)| (400.0 + 300.0 * noise(i) * s, 400.0 + 300.0 * noise(i) * c))
        .collect();
    for (points, most) in [(wave, 8_000), (loops, 400_000)] {
        let kept: Vec<_> = thinned(&points).into_iter().flatten().collect();
        assert!(kept.len() < most, "{}", kept.len());
        let ends = |v: &[(f64, f64)], f: fn(&(f64, f64)) -> f64| {
            let values = v.iter().map(f);
            (values.clone().fold(1e9, f64::min), values.fold(-1e9, f64::max))
        };
        for f in [|p: &(f64, f64)| p.0, |p: &(f64, f64)| p.1] {
            let (before, after) = (ends(&points, f), ends(&kept, f));
            assert!((before.0 - after.0).abs() < 1.0 && (before.1 - after.1).abs() < 1.0);
        }
    }
}

#[test]
fn a_million_points_make_a_small_file() {
    let wave = curve("", (0..1_000_000).map(|i| f64::from(i) * 1e-3).map(|t| (t, (17.0 * t).sin())));
    let drawn = svg(&figure(vec![panel(vec![wave])]));
    assert!(drawn.len() < 200_000, "{}", drawn.len());
}
