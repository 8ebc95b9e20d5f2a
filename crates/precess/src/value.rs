//! Values as people write them: `0.1`, `0,1`, `49*pi/50`, `2^-10`, `30 deg`, `[10; 1]`.

use crate::error::{Error, input, quoted};
use precess_scalar::{Dimension, Scalar};
use precess_system::parse_unit;

/// A value that has been read but not yet held against the quantity it is for.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number, in SI units, with the dimension of the unit written after it.
    Number {
        /// The number, in the SI unit.
        x: f64,
        /// The dimension of the unit, where one was written.
        dimension: Option<Dimension>,
    },
    /// A list of values.
    List(Vec<Value>),
    /// A word: one of a parameter's choices.
    Word(String),
}

impl Value {
    /// A number without a unit.
    pub fn number(x: f64) -> Self {
        Self::Number { x, dimension: None }
    }

    /// The number in the unit of the quantity it is for (empty: a pure number).
    ///
    /// # Errors
    /// Where the value is no finite number or its unit does not fit.
    pub fn in_unit(&self, unit: &str) -> Result<f64, Error> {
        let Self::Number { x, dimension } = self else {
            return input("a number is needed here");
        };
        let (size, wanted) = parse_unit(unit).map_err(|e| Error::Input(e.to_string()))?;
        match dimension {
            Some(d) if *d != wanted => input(match unit {
                "" => format!("a pure number is needed here, not one in {d}"),
                unit => format!("a value in {unit} is needed here, not one in {d}"),
            }),
            Some(_) => Ok(*x / size),
            None => Ok(*x),
        }
    }
}

/// Nesting beyond this is a mistake, or an attack on the stack.
const DEEPEST: usize = 32;

/// Reads a value.
///
/// # Errors
/// One sentence with the text and the place where it stops making sense.
pub fn parse(text: &str) -> Result<Value, Error> {
    let mut reader = Reader { text, at: 0, depth: 0, commas: false };
    let value = reader.value().and_then(|value| {
        reader.skip_spaces();
        if reader.at == text.len() { Ok(value) } else { Err(reader.unexpected()) }
    });
    value.map_err(|e| match e {
        Error::Input(why) => Error::Input(format!("{} is no value: {why}", quoted(text))),
        other => other,
    })
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
    /// Inside brackets a comma separates; outside it is a decimal comma.
    commas: bool,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.text[self.at..].chars().next()
    }
    fn skip_spaces(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
    }
    /// Takes the character if it comes next, spaces aside.
    fn take(&mut self, wanted: char) -> bool {
        self.skip_spaces();
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }
    fn unexpected(&self) -> Error {
        Error::Input(match self.peek() {
            None => "it ends too early".into(),
            Some(_) => format!("{} is not understood", quoted(&self.text[self.at..])),
        })
    }
    fn deeper<T>(&mut self, f: impl FnOnce(&mut Self) -> Result<T, Error>) -> Result<T, Error> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return input("it is nested too deeply");
        }
        let outcome = f(self);
        self.depth -= 1;
        outcome
    }

    fn value(&mut self) -> Result<Value, Error> {
        self.skip_spaces();
        match self.peek() {
            Some('[') => self.deeper(Self::list),
            Some(c) if c.is_alphabetic() && !self.word().eq_ignore_ascii_case("pi") && self.word() != "π" => {
                let word = self.word().to_string();
                self.at += word.len();
                Ok(Value::Word(word))
            }
            _ => self.number_with_unit(),
        }
    }

    fn list(&mut self) -> Result<Value, Error> {
        let outside = std::mem::replace(&mut self.commas, true);
        self.take('[');
        let mut items = vec![];
        let mut separator = None;
        while !self.take(']') {
            if !items.is_empty() {
                self.skip_spaces();
                let found = self.peek().filter(|c| [';', ','].contains(c));
                let Some(found) = found else { return Err(self.unexpected()) };
                if *separator.get_or_insert(found) != found {
                    return input("inside brackets ';' separates and the decimal point is a point");
                }
                self.at += 1;
                if self.take(']') {
                    break;
                }
            }
            items.push(self.value()?);
        }
        self.commas = outside;
        Ok(Value::List(items))
    }

    fn number_with_unit(&mut self) -> Result<Value, Error> {
        let x = self.sum()?;
        self.skip_spaces();
        let end = self.text[self.at..].find([']', ';', '[']).map_or(self.text.len(), |n| self.at + n);
        let end =
            if self.commas { self.text[self.at..end].find(',').map_or(end, |n| self.at + n) } else { end };
        let unit = self.text[self.at..end].trim();
        if unit.is_empty() {
            return finite(x).map(Value::number);
        }
        if !unit.starts_with(|c: char| c.is_alphabetic() || c == '°' || c == '%') {
            return Err(self.unexpected());
        }
        let (size, dimension) = parse_unit(unit).map_err(|e| Error::Input(e.to_string()))?;
        self.at = end;
        Ok(Value::Number { x: finite(x * size)?, dimension: Some(dimension) })
    }

    fn sum(&mut self) -> Result<f64, Error> {
        let mut x = self.product()?;
        loop {
            if self.take('+') {
                x += self.product()?;
            } else if self.take('-') || self.take('−') {
                x -= self.product()?;
            } else {
                return Ok(x);
            }
        }
    }
    fn product(&mut self) -> Result<f64, Error> {
        let mut x = self.signed()?;
        loop {
            if self.take('*') || self.take('·') {
                x *= self.signed()?;
            } else if self.take('/') {
                x /= self.signed()?;
            } else {
                return Ok(x);
            }
        }
    }
    fn signed(&mut self) -> Result<f64, Error> {
        if self.take('-') || self.take('−') {
            return self.deeper(Self::signed).map(|x| -x);
        }
        if self.take('+') {
            return self.deeper(Self::signed);
        }
        self.power()
    }
    /// `-2^2` is -4 and `2^-10` is 2^(-10), as on paper.
    fn power(&mut self) -> Result<f64, Error> {
        let base = self.atom()?;
        if !self.take('^') {
            return Ok(base);
        }
        let exponent = self.deeper(Self::signed)?;
        let whole = exponent.trunc() == exponent && exponent.abs() < 1e6;
        Ok(if whole { Scalar::powi(base, exponent as i32) } else { Scalar::powf(base, exponent) })
    }
    fn atom(&mut self) -> Result<f64, Error> {
        if self.take('(') {
            let x = self.deeper(Self::sum)?;
            return if self.take(')') { Ok(x) } else { Err(self.unexpected()) };
        }
        let word = self.word();
        if word.eq_ignore_ascii_case("pi") || word == "π" {
            self.at += word.len();
            return Ok(std::f64::consts::PI);
        }
        self.literal()
    }
    /// The letters, digits and underscores that come next.
    fn word(&self) -> &str {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        &rest[..end]
    }

    /// Digits with a decimal point (or comma) and an exponent.
    fn literal(&mut self) -> Result<f64, Error> {
        let rest = &self.text.as_bytes()[self.at..];
        let digits = |from: usize| rest[from..].iter().take_while(|b| b.is_ascii_digit()).count();
        let mut end = digits(0);
        let mut any = end > 0;
        if end < rest.len() && (rest[end] == b'.' || (rest[end] == b',' && !self.commas)) {
            let fraction = digits(end + 1);
            any |= fraction > 0;
            end += 1 + fraction;
        }
        if !any {
            return Err(self.unexpected());
        }
        if end < rest.len() && rest[end].eq_ignore_ascii_case(&b'e') {
            let sign = usize::from(matches!(rest.get(end + 1), Some(b'+' | b'-')));
            let exponent = digits((end + 1 + sign).min(rest.len()));
            // `2 e` without digits is a number followed by a word.
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        let literal = self.text[self.at..self.at + end].replace(',', ".");
        self.at += end;
        literal.parse().or_else(|_| input("a number is not understood"))
    }
}

fn finite(x: f64) -> Result<f64, Error> {
    if x.is_finite() { Ok(x) } else { input("it is not a finite number") }
}

/// The shortest text that reads back to the same bits; a whole number has no point.
pub fn shortest(x: f64) -> String {
    let text = format!("{x:?}");
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_string)
}
