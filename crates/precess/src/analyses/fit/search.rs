//! A fit on its way.

use super::{Data, Fit, Fitted};
use crate::analyses::Progress;
use crate::analyses::numbers::unit_of;
use crate::analyses::sensitivity::sensitivities;
use crate::error::Error;
use crate::plan::Plan;
use precess_analysis::{Model, Outcome, quantile};

/// A fit on its way.
pub(super) struct Search<'a> {
    pub plan: Plan,
    pub data: &'a Data,
    pub columns: Vec<usize>,
    pub free: &'a [String],
    pub progress: Progress<'a>,
}

impl Search<'_> {
    /// The plan at a point. An error where it makes no sense.
    pub fn at(&self, point: &[f64]) -> Result<Plan, Error> {
        let mut plan = self.plan.clone();
        for (name, x) in self.free.iter().zip(point) {
            plan.set(name, *x)?;
        }
        Ok(plan)
    }

    /// Residuals and slopes at a point; none outside of what makes sense, or where no motion gets to the end.
    pub fn model(&mut self, point: &[f64], weights: &[f64]) -> Result<Option<Model>, Error> {
        let Ok(plan) = self.at(point) else { return Ok(None) };
        let found = match sensitivities(&plan, self.free, &self.data.times, self.progress) {
            Ok(found) => found,
            Err(Error::Failed(why)) if !why.starts_with("interrupted") => return Ok(None),
            Err(other) => return Err(other),
        };
        let width = plan.width() - 1;
        let mut model = Model { residuals: vec![], slopes: vec![vec![]; self.free.len()] };
        for ((column, (_, values)), weight) in self.columns.iter().zip(&self.data.columns).zip(weights) {
            let rows = found.values.chunks(width).zip(found.slopes.chunks(width * self.free.len()));
            for ((row, slopes), measured) in rows.zip(values) {
                model.residuals.push((row[column - 1] - measured) / weight);
                for (along, list) in model.slopes.iter_mut().enumerate() {
                    list.push(slopes[along * width + column - 1] / weight);
                }
            }
        }
        Ok(Some(model))
    }

    /// The measured columns along the motion, and the scatter about them.
    pub fn scatter(&mut self) -> Result<(Vec<Vec<f64>>, Vec<f64>), Error> {
        let found = sensitivities(&self.plan, self.free, &self.data.times, self.progress)?;
        let width = self.plan.width() - 1;
        let (mut model, mut scatter) = (vec![], vec![]);
        for (column, (_, values)) in self.columns.iter().zip(&self.data.columns) {
            let fitted: Vec<f64> = found.values.chunks(width).map(|row| row[column - 1]).collect();
            let squares = fitted.iter().zip(values).fold(0.0, |sum, (a, b)| sum + (a - b) * (a - b));
            scatter.push((squares / values.len() as f64).sqrt());
            model.push(fitted);
        }
        Ok((model, scatter))
    }

    pub fn finish(self, found: &Outcome, model: Vec<Vec<f64>>, scatter: Vec<f64>, known: bool) -> Fit {
        let freedom = self.data.times.len() * self.columns.len() - self.free.len();
        // Without uncertainties the scatter about the motion tells them.
        let variance = if known { 1.0 } else { found.squares / freedom as f64 };
        let wide = quantile((!known).then_some(freedom));
        let error = |k: usize| (variance * found.covariance[k][k]).sqrt();
        let fitted = self.free.iter().enumerate().map(|(k, name)| {
            let (value, error) = (found.parameters[k], error(k));
            let interval = (value - wide * error, value + wide * error);
            Fitted { name: name.clone(), unit: unit_of(&self.plan, name), value, error, interval }
        });
        let scale: Vec<f64> = (0..self.free.len()).map(|k| found.covariance[k][k].sqrt()).collect();
        let row = |j: usize| scale.iter().enumerate().map(move |(k, s)| (j, k, *s));
        let correlation = scale
            .iter()
            .enumerate()
            .map(|(j, sj)| row(j).map(|(j, k, sk)| found.covariance[j][k] / (sj * sk)).collect::<Vec<f64>>());
        Fit {
            fitted: fitted.collect(),
            correlation: correlation.collect(),
            scatter,
            chi2: found.squares,
            freedom,
            models: found.models,
            model,
            plan: self.plan,
        }
    }
}
