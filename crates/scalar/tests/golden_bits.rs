//! The very bits of the elementary functions: the same on every platform, and not those of another library.

mod support;

use precess_scalar::elementary as e;
use support::Random;

type Golden = (&'static str, fn(f64, f64) -> f64, u64);

const GOLDEN: [Golden; 15] = [
    ("sin", |x, _| e::sin_cos(x).0, 0x1dfbc3dba88c25e5),
    ("cos", |x, _| e::sin_cos(x).1, 0xfb1d146028f4877f),
    ("tan", |x, _| e::tan(x), 0xa566bf8f5bf14898),
    ("exp", |x, _| e::exp(x), 0xf31088a0064cbf22),
    ("ln", |x, _| e::ln(x.abs()), 0xa9cdf24fe4ead233),
    ("atan2", |x, y| e::atan2(x, y), 0x77a32fe9524e4074),
    ("asin", |x, _| e::asin(x), 0xcd169997d63fafe9),
    ("acos", |x, _| e::acos(x), 0x655d15fbc65b00ec),
    ("sinh", |x, _| e::sinh(x), 0xf9c22dfafd982447),
    ("cosh", |x, _| e::cosh(x), 0x9162574e03dc024c),
    ("tanh", |x, _| e::tanh(x), 0xfcf13c12a66a174c),
    ("cbrt", |x, _| e::cbrt(x), 0xa506145b2891e5a9),
    ("hypot", |x, y| e::hypot(x, y), 0x206e8ccda3d31219),
    ("powf", |x, y| e::powf(x.abs(), y), 0x9ebd71161d151adf),
    ("powi", |x, y| e::powi(x, y as i32), 0xd28924db23e0ffc0),
];

/// Exponents of all sizes, the numbers of a laboratory, and the unit interval, in turn.
fn arguments() -> impl Iterator<Item = (f64, f64)> {
    let mut random = Random(2026);
    (0..100_000).map(move |i| match i % 3 {
        0 => (random.finite(), random.finite()),
        1 => (random.between(-20.0, 20.0), random.between(-20.0, 20.0)),
        _ => (random.between(-1.0, 1.0), random.between(-1.0, 1.0)),
    })
}

/// FNV-1a over the values as 64-bit words; every NaN counts as the same.
fn checksum(function: fn(f64, f64) -> f64) -> u64 {
    arguments().fold(0xcbf2_9ce4_8422_2325, |hash, (x, y)| {
        let value = function(x, y);
        let bits = if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() };
        (hash ^ bits).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[test]
fn bits_are_golden() {
    let changed: Vec<String> = GOLDEN
        .iter()
        .map(|(name, function, golden)| (name, checksum(*function), golden))
        .filter(|(_, found, golden)| found != *golden)
        .map(|(name, found, golden)| format!("{name}: {found:#018x}, not {golden:#018x}"))
        .collect();
    assert!(changed.is_empty(), "other bits than recorded:\n{}", changed.join("\n"));
}
