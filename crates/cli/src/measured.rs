//! Measured points from a CSV file: names, then a line for each time.

use crate::failure::{Failure, reason};
use crate::subject::assignment;
use precess::analyses::Data;
use precess::{Error, unknown};
use std::path::Path;

/// Reads times and columns; a semicolon between the fields makes a comma a decimal one.
pub fn read(path: &Path, columns: &[String], uncertainties: &[String]) -> Result<Data, Failure> {
    let name = path.display().to_string();
    let text = std::fs::read_to_string(path)
        .map_err(|e| Failure::Wrong(format!("cannot read '{name}': {}", reason(&e))))?;
    let (names, mut table) = table(&text).map_err(|e| e.at(&name))?;
    let place = |wanted: &str| {
        let found = names.iter().position(|n| n == wanted);
        found.ok_or_else(|| unknown("column", wanted, names.iter().map(String::as_str)).at(&name))
    };
    let times = std::mem::take(&mut table[place("t")?]);
    let used: Vec<&String> = match columns {
        [] => names.iter().filter(|n| *n != "t").collect(),
        some => some.iter().collect(),
    };
    let mut data = Data { times, ..Data::default() };
    for name in &used {
        data.columns.push(((*name).clone(), std::mem::take(&mut table[place(name)?])));
    }
    let given = uncertainties.iter().map(|text| {
        let (name, value) = assignment(text)?;
        if !used.iter().any(|n| *n == name) {
            return Err(unknown("column that is used", name, used.iter().map(|n| n.as_str())).into());
        }
        Ok((name, value))
    });
    let given = given.collect::<Result<Vec<_>, Failure>>()?;
    for name in used.iter().filter(|_| !given.is_empty()) {
        let Some((_, value)) = given.iter().find(|(n, _)| n == name) else {
            return Err(Failure::Wrong(format!(
                "{name} has no uncertainty: either every column has one, or none"
            )));
        };
        let precess::value::Value::Number { x, .. } = value else {
            return Err(Failure::Wrong(format!("the uncertainty of {name} is a number")));
        };
        data.uncertainties.push(*x);
    }
    Ok(data)
}

/// Names and columns.
fn table(text: &str) -> Result<(Vec<String>, Vec<Vec<f64>>), Error> {
    let wrong = |sentence: String| Error::Input(sentence);
    let first = text.lines().next().unwrap_or_default();
    let semicolons = first.contains(';');
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(if semicolons { b';' } else { b',' })
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let head = reader.headers().map_err(|e| wrong(e.to_string()))?;
    // A unit may follow in brackets: `theta [rad]`.
    let names: Vec<String> =
        head.iter().map(|n| n.split('[').next().unwrap_or(n).trim().to_string()).collect();
    let mut columns = vec![vec![]; names.len()];
    for record in reader.records() {
        let record = record.map_err(|e| wrong(e.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line);
        for ((field, name), column) in record.iter().zip(&names).zip(&mut columns) {
            let number = if semicolons { field.replace(',', ".") } else { field.to_string() };
            column.push(number.parse().map_err(|_| {
                wrong(format!(
                    "line {line}: {name} is no number ('{field}'): leave out lines that have a gap"
                ))
            })?);
        }
    }
    Ok((names, columns))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_units_commas() {
        let wanted = (vec!["t".to_string(), "theta".to_string()], vec![vec![0.0, 0.5], vec![1.0, -2.5e-3]]);
        assert_eq!(table("t,theta [rad]\n0, 1\n0.5,-2.5e-3\n"), Ok(wanted.clone()));
        assert_eq!(table("t;theta\n0;1\n0,5;-0,0025\n"), Ok(wanted));
    }

    #[test]
    fn a_gap_says_where() {
        let gap = table("t,theta\n0,1\n0.5,\n").expect_err("a gap").to_string();
        assert!(gap.starts_with("line 3: theta is no number ('')"), "{gap}");
        assert!(table("t,theta\n0\n").is_err());
    }
}
