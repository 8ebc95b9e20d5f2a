//! What is known of a physical quantity besides its value.

use crate::Text;

/// The values a quantity may take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
    /// The smallest value itself is excluded.
    pub open: bool,
}

impl Range {
    /// Any finite number.
    pub const ANY: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY, open: true };

    /// Whether a finite value lies inside.
    pub fn contains(self, x: f64) -> bool {
        x.is_finite() && (if self.open { self.low < x } else { self.low <= x }) && x <= self.high
    }
}

/// Name, symbol, unit and meaning of a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// ASCII identifier (`theta1`).
    pub name: String,
    /// LaTeX symbol (`\theta_1`).
    pub symbol: String,
    /// Unit as text (`kg m^2`); empty for a pure number.
    pub unit: String,
    /// What it is, in a few words.
    pub text: Text,
    /// The values that make sense.
    pub range: Range,
}

const GREEK: [&str; 23] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu",
    "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "Omega", "Gamma",
];

/// `theta1` to `\theta_1`, `L_A3` to `L_{A3}`, `dry` to `\mathrm{dry}`, `x_dot` to `\dot{x}`.
pub(crate) fn default_symbol(name: &str) -> String {
    if let Some(stem) = name.strip_suffix("_dot") {
        return dotted(&default_symbol(stem), 1);
    }
    if let Some((letter, index)) = name.split_once('_').filter(|(letter, _)| letter.len() == 1) {
        return format!("{letter}_{{{index}}}");
    }
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let index = &name[stem.len()..];
    let letter = if GREEK.contains(&stem) {
        format!("\\{stem}")
    } else if stem.len() == 1 {
        stem.to_string()
    } else {
        let words = stem.replace('_', "\\,");
        format!("\\mathrm{{{words}}}")
    };
    match index.len() {
        0 => letter,
        1 => format!("{letter}_{index}"),
        _ => format!("{letter}_{{{index}}}"),
    }
}

/// The symbol of a time derivative: `\theta_1` to `\dot{\theta}_1`.
pub(crate) fn dotted(symbol: &str, times: usize) -> String {
    let (letter, index) = symbol.split_once('_').map_or((symbol, None), |(l, i)| (l, Some(i)));
    let accent = if times == 1 { "dot" } else { "ddot" };
    let dotted = format!("\\{accent}{{{letter}}}");
    index.map_or(dotted.clone(), |i| format!("{dotted}_{i}"))
}

/// A quantity with the symbol that its name suggests.
pub fn quantity(name: &str, unit: &str, en: &str, fr: &str) -> Quantity {
    Quantity {
        name: name.into(),
        symbol: default_symbol(name),
        unit: unit.into(),
        text: Text::new(en, fr),
        range: Range::ANY,
    }
}

/// The value a parameter has when nobody sets it.
#[derive(Clone, Debug, PartialEq)]
pub enum Default {
    /// A number.
    Number(f64),
    /// Items of `width` numbers each (1: a plain list), written `[a; b]` or `[[x; y]; [x; y]]`.
    List {
        /// Names of the numbers of an item; one for a plain list.
        fields: &'static [&'static str],
        /// All numbers, item by item.
        items: Vec<f64>,
    },
    /// One of several words; the first is the default.
    Choice(&'static [&'static str]),
}

/// Something about a system that stays the same during a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name, unit and meaning.
    pub quantity: Quantity,
    /// Its default.
    pub default: Default,
    /// The longest list that makes sense.
    pub longest: usize,
    /// Its items decide how many coordinates there are.
    pub structural: bool,
}

/// A list longer than this is a mistake, unless a card says otherwise.
const LONGEST: usize = 100_000;

/// A numeric parameter.
pub fn number(name: &str, unit: &str, default: f64, en: &str, fr: &str) -> Parameter {
    Parameter {
        quantity: quantity(name, unit, en, fr),
        default: Default::Number(default),
        longest: 1,
        structural: false,
    }
}

/// A list of numbers.
pub fn list(name: &'static str, unit: &str, default: &[f64], en: &str, fr: &str) -> Parameter {
    let default = Default::List { fields: &["item"], items: default.to_vec() };
    Parameter { quantity: quantity(name, unit, en, fr), default, longest: LONGEST, structural: false }
}

/// A list of items that are several numbers each.
pub fn rows<const W: usize>(
    name: &str,
    fields: &'static [&'static str; W],
    default: &[[f64; W]],
    en: &str,
    fr: &str,
) -> Parameter {
    let default = Default::List { fields, items: default.concat() };
    Parameter { quantity: quantity(name, "", en, fr), default, longest: LONGEST, structural: false }
}

/// One of several words.
pub fn choice(name: &str, options: &'static [&'static str], en: &str, fr: &str) -> Parameter {
    Parameter {
        quantity: quantity(name, "", en, fr),
        default: Default::Choice(options),
        longest: 1,
        structural: false,
    }
}

impl Parameter {
    /// Only values above zero make sense.
    #[must_use]
    pub fn positive(mut self) -> Self {
        self.quantity.range = Range { low: 0.0, high: f64::INFINITY, open: true };
        self
    }
    /// Only zero and above make sense.
    #[must_use]
    pub fn not_negative(mut self) -> Self {
        self.quantity.range = Range { low: 0.0, high: f64::INFINITY, open: false };
        self
    }
    /// Only values between two bounds make sense.
    #[must_use]
    pub fn within(mut self, low: f64, high: f64) -> Self {
        self.quantity.range = Range { low, high, open: false };
        self
    }
    /// A list of no more than so many items.
    #[must_use]
    pub fn at_most(mut self, items: usize) -> Self {
        self.longest = items;
        self
    }
    /// Its items decide how many coordinates there are.
    #[must_use]
    pub fn structural(mut self) -> Self {
        self.structural = true;
        self
    }
    /// A LaTeX symbol other than the one the name suggests.
    #[must_use]
    pub fn symbol(mut self, symbol: &str) -> Self {
        self.quantity.symbol = symbol.into();
        self
    }
}
