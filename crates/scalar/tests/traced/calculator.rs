//! What a reader's calculator makes of the printed text.

use precess_scalar::Scalar;

/// The value of a text in which these names have these values.
pub fn value(text: &str, names: &[(String, f64)]) -> f64 {
    let mut reader = Reader { rest: text, names };
    let x = reader.sum().unwrap_or_else(|| panic!("cannot read {text:?}"));
    assert!(reader.rest.trim().is_empty(), "{:?} is left of {text:?}", reader.rest);
    x
}

#[derive(Clone, Copy)]
struct Reader<'a> {
    rest: &'a str,
    names: &'a [(String, f64)],
}

impl<'a> Reader<'a> {
    fn take(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(token);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }
    fn word(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest.trim_start();
        let (word, rest) = rest.split_at(rest.find(|c| !belongs(c)).unwrap_or(rest.len()));
        self.rest = rest;
        word
    }
    fn sum(&mut self) -> Option<f64> {
        let mut sum = if self.take("-") { -self.product()? } else { self.product()? };
        loop {
            if self.take("+") {
                sum += self.product()?;
            } else if self.take("-") {
                sum -= self.product()?;
            } else {
                return Some(sum);
            }
        }
    }
    fn product(&mut self) -> Option<f64> {
        let mut product = self.power()?;
        loop {
            if self.take("*") {
                product *= self.power()?;
            } else if self.take("/") {
                product /= self.power()?;
            } else {
                return Some(product);
            }
        }
    }
    fn power(&mut self) -> Option<f64> {
        let base = self.atom()?;
        if !self.take("^") {
            return Some(base);
        }
        let n = self.atom()?;
        Some(if n.trunc() == n && n.abs() < 100.0 {
            Scalar::powi(base, n as i32)
        } else {
            Scalar::powf(base, n)
        })
    }
    fn atom(&mut self) -> Option<f64> {
        if self.take("(") {
            let inner = self.sum()?;
            return self.take(")").then_some(inner);
        }
        if self.rest.trim_start().starts_with(|c: char| c.is_ascii_digit()) {
            let before = *self;
            let mantissa = self.word(|c| c.is_ascii_digit() || c == '.');
            let length = if self.rest.starts_with('e') {
                self.rest = &self.rest[1..];
                mantissa.len() + 1 + self.word(|c| c.is_ascii_digit() || c == '-').len()
            } else {
                mantissa.len()
            };
            return before.rest.trim_start()[..length].parse().ok();
        }
        let name = self.word(|c| c.is_alphanumeric() || c == '_' || c == '\'');
        if self.take("(") { self.call(name) } else { self.symbol(name) }
    }
    fn symbol(&self, name: &str) -> Option<f64> {
        match name {
            "pi" => Some(std::f64::consts::PI),
            "inf" => Some(f64::INFINITY),
            "NaN" => Some(f64::NAN),
            _ => self.names.iter().find(|known| known.0 == name).map(|known| known.1),
        }
    }
    fn call(&mut self, name: &str) -> Option<f64> {
        let holds = if name == "if" { self.either().filter(|_| self.take(","))? } else { true };
        let x = self.sum()?;
        let y = if self.take(",") { self.sum()? } else { f64::NAN };
        if !self.take(")") {
            return None;
        }
        Some(match name {
            "if" => f64::select(holds, x, y),
            "sqrt" => Scalar::sqrt(x),
            "sin" => Scalar::sin(x),
            "cos" => Scalar::cos(x),
            "tan" => Scalar::tan(x),
            "asin" => Scalar::asin(x),
            "acos" => Scalar::acos(x),
            "exp" => Scalar::exp(x),
            "ln" => Scalar::ln(x),
            "sinh" => Scalar::sinh(x),
            "cosh" => Scalar::cosh(x),
            "tanh" => Scalar::tanh(x),
            "cbrt" => Scalar::cbrt(x),
            "abs" => Scalar::abs(x),
            "sign" => Scalar::sign(x),
            "atan2" => Scalar::atan2(x, y),
            "hypot" => Scalar::hypot(x, y),
            "max" => Scalar::larger(x, y),
            "min" => Scalar::smaller(x, y),
            _ => return None,
        })
    }
    fn either(&mut self) -> Option<bool> {
        let mut holds = self.both()?;
        while self.take("or ") {
            holds |= self.both()?;
        }
        Some(holds)
    }
    fn both(&mut self) -> Option<bool> {
        let mut holds = self.comparison()?;
        while self.take("and ") {
            holds &= self.comparison()?;
        }
        Some(holds)
    }
    fn comparison(&mut self) -> Option<bool> {
        // A parenthesis opens a number or a condition: what follows it tells.
        let before = *self;
        if let Some(x) = self.sum() {
            match self.word(|c| "<>=".contains(c)) {
                "<" => return Some(x < self.sum()?),
                "<=" => return Some(x <= self.sum()?),
                ">" => return Some(x > self.sum()?),
                ">=" => return Some(x >= self.sum()?),
                _ => {}
            }
        }
        *self = before;
        let holds = self.take("(").then(|| self.either())??;
        self.take(")").then_some(holds)
    }
}
