//! A calibration as JSON.

use std::collections::BTreeMap;

use plan::Problem;
use serde::Serialize;

use crate::calibration::{Calibration, Covariance, Estimate, Misfit, RunResult};
use crate::entries::Entries;
use crate::parameter::Parameter;

/// A calibration in units of the SI.
#[derive(Debug, Clone, Serialize)]
pub struct CalibrationRecord {
    /// Title of the scene.
    pub scene: String,
    /// Whether the search ended by itself.
    pub converged: bool,
    /// All logs.
    pub logs: Vec<RunRecord>,
    /// All parameters.
    pub parameters: Vec<ParameterRecord>,
    /// Of those that are known.
    pub covariance: CovarianceRecord,
    /// What the scene should say, by table and key.
    pub entries: BTreeMap<&'static str, BTreeMap<&'static str, serde_json::Value>>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// Covariance of the parameters that are known: squares of standard errors on its diagonal.
#[derive(Debug, Clone, Serialize)]
pub struct CovarianceRecord {
    /// Names, in the order of rows and columns.
    pub parameters: Vec<String>,
    /// Their units, in the same order; `1` for a parameter without a unit.
    pub units: Vec<&'static str>,
    /// The rows: an entry is in the unit of its row times that of its column.
    pub matrix: Vec<Vec<f64>>,
}

/// What a log says. Distances and angles are root mean squares.
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
    /// Distance between robot and reference.
    pub lag_m: f64,
    /// Distance between robot and a rollout of the scene; null where it diverges.
    pub before_m: Option<f64>,
    /// Likewise with the fitted parameters.
    pub after_m: f64,
    /// Angle between robot and a rollout of the scene.
    pub before_rad: Option<f64>,
    /// Likewise with the fitted parameters.
    pub after_rad: f64,
}

/// What is known of a parameter.
#[derive(Debug, Clone, Serialize)]
pub struct ParameterRecord {
    /// Its name.
    pub name: String,
    /// Unit of the table on the terminal.
    #[serde(skip)]
    pub unit: (&'static str, f64),
    /// As the scene says it, or the end of a log.
    pub before: f64,
    /// As it was fitted, or held.
    pub value: f64,
    /// Its standard error; null where the logs do not tell it.
    pub standard_error: Option<f64>,
    /// What to do with it, or which run would tell it.
    pub remark: String,
}

/// Rollouts that leave more than this part of the lag do not explain a log, unless it is less than this distance (m).
const UNEXPLAINED: f64 = 0.1;
const SMALL: f64 = 2e-4;
/// Parameters that are more correlated than this cannot be told apart.
const ALIKE: f64 = 0.95;

impl CalibrationRecord {
    /// Of a calibration of a problem.
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
            lag_m: run.lag.distance,
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
        let alike = partner
            .filter(|(_, correlation)| correlation.abs() > ALIKE)
            .map(|(other, correlation)| format!("hard to tell from {} (correlation {correlation:.2})", other.name()));
        let reason = alike.unwrap_or_else(|| parameter.advice().to_owned());
        return format!("not known: {reason}");
    }
    let flag = match parameter {
        Parameter::Stiffness if estimate.is_off() => Some("--stiffness-factor"),
        Parameter::Damping if estimate.is_off() => Some("--damping-factor"),
        _ => None,
    };
    flag.map(|flag| format!("play with {flag} {:.2}", 1.0 / value)).unwrap_or_default()
}

fn warnings(calibration: &Calibration) -> Vec<String> {
    let mut warnings = Vec::new();
    if !calibration.converged {
        warnings
            .push("the search was still improving when it was ended: calibrate again from the scene it writes".into());
    }
    for RunResult { name, end, after, lag, .. } in &calibration.runs {
        warnings.extend(end.iter().map(|end| format!("{name}: {end}")));
        let Misfit { distance, .. } = after;
        if *distance > SMALL.max(UNEXPLAINED * lag.distance) {
            warnings.push(format!(
                "{name}: the fitted model is still {:.2} mm from the robot, which was {:.2} mm from its reference: something \
                 else acts, such as a wrong payload, a controller with dynamics of its own, or contact in free air",
                1e3 * distance,
                1e3 * lag.distance
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
