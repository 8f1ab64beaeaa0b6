//! A calibration as JSON.

use std::collections::BTreeMap;

use plan::Problem;
use serde::Serialize;

use crate::calibration::{Calibration, Covariance, Estimate, Misfit, RunResult};
use crate::entries::Entries;
use crate::parameter::Parameter;

/// A calibration in SI units.
#[derive(Debug, Clone, Serialize)]
pub struct CalibrationRecord {
    /// Title of the scene.
    pub scene: String,
    /// Whether the search converged.
    pub converged: bool,
    /// All logs.
    pub logs: Vec<RunRecord>,
    /// All parameters.
    pub parameters: Vec<ParameterRecord>,
    /// Covariance of the identified parameters.
    pub covariance: CovarianceRecord,
    /// New entries of the scene, by table and key.
    pub entries: BTreeMap<&'static str, BTreeMap<&'static str, serde_json::Value>>,
    /// Warnings for the user.
    pub warnings: Vec<String>,
}

/// Covariance of the identified parameters: squares of standard errors on its diagonal.
#[derive(Debug, Clone, Serialize)]
pub struct CovarianceRecord {
    /// Names, in the order of rows and columns.
    pub parameters: Vec<String>,
    /// Their units, in the same order; `1` for a parameter without a unit.
    pub units: Vec<&'static str>,
    /// The rows: an entry is in the unit of its row times that of its column.
    pub matrix: Vec<Vec<f64>>,
}

/// The result of a log. Distances and angles are root mean squares.
#[derive(Debug, Clone, Serialize)]
pub struct RunRecord {
    /// Its file.
    pub log: String,
    /// Whether the parts could touch.
    pub has_contact: bool,
    /// Why only a part of it is used; null where all is.
    pub end: Option<String>,
    /// Length of what is used.
    pub duration_s: f64,
    /// Tracking error of the position.
    #[serde(rename = "lag_m")]
    pub tracking_error_m: f64,
    /// Distance between robot and a rollout of the scene; null where it diverges.
    pub before_m: Option<f64>,
    /// The same with the fitted parameters.
    pub after_m: f64,
    /// Angle between robot and a rollout of the scene.
    pub before_rad: Option<f64>,
    /// The same with the fitted parameters.
    pub after_rad: f64,
}

/// The estimate of a parameter.
#[derive(Debug, Clone, Serialize)]
pub struct ParameterRecord {
    /// Its name.
    pub name: String,
    /// Unit of the table on the terminal.
    #[serde(skip)]
    pub unit: (&'static str, f64),
    /// Its value in the scene, or from the end of a log.
    pub before: f64,
    /// Its fitted value, or that at which it was held.
    pub value: f64,
    /// Its standard error; null where the logs do not determine it.
    pub standard_error: Option<f64>,
    /// What to do with it, or a run that would determine it.
    pub remark: String,
}

/// Rollouts with a misfit above this fraction of the tracking error do not explain a log, unless it is less than this
/// distance (m).
const UNEXPLAINED: f64 = 0.05;
const SMALL: f64 = 2e-4;
/// Parameters with a larger correlation cannot be separated.
const ALIKE: f64 = 0.95;

impl CalibrationRecord {
    /// From a calibration of a problem.
    pub fn new(calibration: &Calibration, entries: &Entries, problem: &Problem) -> Self {
        let mut by_table: BTreeMap<&str, BTreeMap<&str, serde_json::Value>> = BTreeMap::new();
        for entry in entries.iter() {
            by_table.entry(entry.table).or_default().insert(entry.key, json(&entry.value));
        }
        Self {
            scene: problem.scene().title.clone(),
            converged: calibration.converged,
            logs: calibration.runs.iter().map(RunRecord::new).collect(),
            parameters: calibration.estimates.iter().map(ParameterRecord::new).collect(),
            covariance: CovarianceRecord::new(calibration),
            entries: by_table,
            warnings: warnings(calibration),
        }
    }
}

impl RunRecord {
    fn new(run: &RunResult) -> Self {
        Self {
            log: run.name.clone(),
            has_contact: run.has_contact,
            end: run.end.clone(),
            duration_s: run.duration,
            tracking_error_m: run.tracking_error.distance,
            before_m: run.before.map(|misfit| misfit.distance),
            after_m: run.after.distance,
            before_rad: run.before.map(|misfit| misfit.angle),
            after_rad: run.after.angle,
        }
    }
}

impl CovarianceRecord {
    fn new(calibration: &Calibration) -> Self {
        let Covariance { parameters, rows } = &calibration.covariance;
        Self {
            parameters: parameters.iter().map(|parameter| parameter.name()).collect(),
            units: parameters.iter().map(|parameter| parameter.si_unit()).collect(),
            matrix: rows.clone(),
        }
    }
}

impl ParameterRecord {
    fn new(estimate: &Estimate) -> Self {
        let parameter = estimate.quantity.parameter;
        Self {
            name: parameter.name(),
            unit: parameter.unit(),
            before: estimate.quantity.before,
            value: estimate.value,
            standard_error: estimate.standard_error,
            remark: remark(estimate),
        }
    }
}

/// What to do about a parameter.
fn remark(estimate: &Estimate) -> String {
    let Estimate { quantity, value, standard_error, partner } = estimate;
    let parameter = quantity.parameter;
    if standard_error.is_none() {
        let alike = partner.filter(|(_, correlation)| correlation.abs() > ALIKE).map(|(other, correlation)| {
            format!("hard to separate from {} (correlation {correlation:.2})", other.name())
        });
        let reason = alike.unwrap_or_else(|| parameter.advice().to_owned());
        return format!("not identified: {reason}");
    }
    let flag = match parameter {
        Parameter::Stiffness if estimate.is_off() => Some("--stiffness-factor"),
        Parameter::Damping if estimate.is_off() => Some("--damping-factor"),
        _ => None,
    };
    flag.map(|flag| format!("run the player with {flag} {:.2}", 1.0 / value)).unwrap_or_default()
}

fn warnings(calibration: &Calibration) -> Vec<String> {
    let mut warnings = Vec::new();
    if !calibration.converged {
        warnings.push("the search stopped before it converged: calibrate again from the scene it writes".into());
    }
    for RunResult { name, end, after, tracking_error, is_unexplained, .. } in &calibration.runs {
        warnings.extend(end.iter().map(|end| format!("{name}: {end}")));
        if *is_unexplained {
            warnings.push(format!(
                "{name}: rollouts ring otherwise than the robot, so nothing is identified: leave this log out"
            ));
            continue;
        }
        let Misfit { distance, .. } = after;
        if *distance > SMALL.max(UNEXPLAINED * tracking_error.distance) {
            warnings.push(format!(
                "{name}: the fitted model is still {:.2} mm from the robot, which was {:.2} mm from its reference: something \
                 else acts, such as a wrong payload, a controller with dynamics of its own, or contact in free air, or the \
                 search ended at a wrong minimum; standard errors do not hold",
                1e3 * distance,
                1e3 * tracking_error.distance
            ));
        }
    }
    for Estimate { quantity, value, standard_error, .. } in &calibration.estimates {
        let (low, high) = (quantity.range.start(), quantity.range.end());
        if standard_error.is_some() && (value == high || (value == low && *low > 0.0)) {
            warnings.push(format!("{} is at the end of its range: do not trust it", quantity.parameter.name()));
        }
    }
    warnings
}

/// A number or nested lists of numbers.
fn json(value: &toml_edit::Value) -> serde_json::Value {
    match value {
        toml_edit::Value::Array(values) => values.iter().map(json).collect(),
        other => other.as_float().into(),
    }
}
