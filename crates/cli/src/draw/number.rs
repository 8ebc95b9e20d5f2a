//! Numbers at ticks: a true minus, as many decimals as the step needs, powers of ten raised.

/// An integer in superscript, such as `⁻¹²`.
pub fn superscript(value: i32) -> String {
    let raise = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    value.to_string().chars().map(raise).collect()
}

/// A fixed number of decimals, with a minus sign and no negative zero.
pub fn decimal(value: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", value.abs());
    let zero = text.bytes().all(|b| b == b'0' || b == b'.');
    if value < 0.0 && !zero { format!("−{text}") } else { text }
}

/// Decimals that tell multiples of `step` apart.
pub fn decimals(step: f64) -> usize {
    (-(step.log10() + 1e-9).floor()).max(0.0) as usize
}

/// The exponent of the leading digit; zero for zero.
pub fn exponent(value: f64) -> i32 {
    if value == 0.0 { 0 } else { (value.abs().log10() + 1e-12).floor() as i32 }
}

/// The step 1, 2 or 5 times a power of ten that is not below `least`.
pub fn nice_step(least: f64) -> f64 {
    let power = 10f64.powi(exponent(least));
    let lead = [1.0, 2.0, 5.0, 10.0].into_iter().find(|m| m * power >= least * (1.0 - 1e-9));
    lead.unwrap_or(10.0) * power
}

/// The step after `step` in 1, 2, 5, 10.
pub fn next_step(step: f64) -> f64 {
    nice_step(step * 1.5)
}

/// A whole number as short as it can be said: plain, or with a power of ten when very long.
pub fn plain(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e15).contains(&size) {
        let text = format!("{size:e}");
        let (lead, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{lead}×10{}", superscript(power.parse().unwrap_or(0)));
    }
    format!("{size}")
}
