//! Entries of a scene after a calibration.

use std::path::Path;

use admittance::PositionRobot;
use nalgebra::Matrix6;
use plan::{PlannerError, Problem};
use scene::{Robot, Scene, Source};
use store::{read_text, write_new_scene};
use task::Inertia;
use toml_edit::{Array, DocumentMut, Item, Table, TableLike, Value};

use crate::calibration::{Calibration, Estimate};
use crate::model::{scaled, set};
use crate::parameter::Parameter;

/// A key of a scene with its new value.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Table that it stands in; the names of nested tables have points between them.
    pub table: &'static str,
    /// Its name there.
    pub key: &'static str,
    /// Its value.
    pub value: Value,
}

/// All entries that a calibration changes.
#[derive(Debug, Clone)]
pub struct Entries(Vec<Entry>);

/// Number of standard errors to be tolerated.
const TOLERATED: f64 = 2.0;
/// Largest relative error that a scene can have.
const LARGEST_ERROR: f64 = 0.9;
/// Largest delay (s) that a scene can have.
const LARGEST_DELAY: f64 = 0.1;
/// Smallest uncertainty of contact friction: it varies from place to place.
const FRICTION_SPREAD: f64 = 0.02;

impl Entries {
    /// Entries for the parameters that were identified.
    pub fn new(calibration: &Calibration, problem: &Problem) -> Self {
        let known = Known(calibration.estimates.iter().filter(|estimate| estimate.standard_error.is_some()).collect());
        let mut entries = Self(Vec::new());
        match (&problem.scene().position_robot, &problem.scene().robot) {
            (Some(robot), _) => entries.add_commanded(&known, robot),
            (None, Some(robot)) => entries.add_arm(&known, robot),
            (None, None) => entries.add_body(&known, problem),
        }
        if let Some(estimate) = known.estimate(Parameter::Stiffness) {
            // Gain errors that the player does not correct must be tolerated.
            let left = if estimate.is_off() { 0.0 } else { (estimate.value - 1.0).abs() };
            let error = left + TOLERATED * estimate.standard_error.unwrap_or_default();
            entries.add("robustness", "stiffness_error", rounded_up(error, 0.01).min(LARGEST_ERROR).into());
        }
        if let Some((delay, error)) = known.find(Parameter::Delay) {
            entries.add("robustness", "delay", rounded_up(delay + TOLERATED * error, 1e-4).min(LARGEST_DELAY).into());
        }
        if let Some((friction, error)) = known.find(Parameter::Friction) {
            let spread = TOLERATED * error.max(FRICTION_SPREAD);
            let mut frictions =
                [(friction - spread).max(0.0), friction, friction + spread].map(|value| rounded(value, 0.01));
            frictions.sort_by(f64::total_cmp);
            let mut list = frictions.to_vec();
            list.dedup();
            entries.add("robustness", "friction", numbers(&list));
        }
        entries
    }

    fn add(&mut self, table: &'static str, key: &'static str, value: Value) {
        self.0.push(Entry { table, key, value });
    }

    /// Rotor inertia and friction of joints, and the error of the apparent inertia that follows from the former.
    fn add_arm(&mut self, known: &Known, robot: &Robot) {
        let before = robot.rotor_inertia();
        let (mut rotors, mut heavier) = (before.clone(), before.clone());
        let mut joint_friction = robot.joint_friction.clone();
        for Estimate { quantity, value, standard_error, .. } in &known.0 {
            let error = standard_error.unwrap_or_default();
            match quantity.parameter {
                Parameter::RotorInertia(joint) => {
                    set(&mut rotors, joint, *value);
                    set(&mut heavier, joint, value + TOLERATED * error);
                }
                Parameter::JointFriction(joint) => set(&mut joint_friction, joint, *value),
                _ => {}
            }
        }
        if known.0.iter().any(|estimate| matches!(estimate.quantity.parameter, Parameter::RotorInertia(_))) {
            self.add("robot", "rotor_inertia", one_or_list(&rotors));
            if let Some(error) = inertia_error(robot, &rotors, &heavier) {
                self.add("robustness", "inertia_error", rounded_up(error, 0.01).min(LARGEST_ERROR).into());
            }
        }
        if known.0.iter().any(|estimate| matches!(estimate.quantity.parameter, Parameter::JointFriction(_))) {
            self.add("robot", "joint_friction", one_or_list(&joint_friction));
        }
    }

    /// Inertia of a body without an arm. As an apparent inertia it holds wherever the scene has taken its own from.
    fn add_body(&mut self, known: &Known, problem: &Problem) {
        let parts =
            [Parameter::TranslationalInertia, Parameter::RotationalInertia].map(|parameter| known.find(parameter));
        if parts == [None, None] {
            return;
        }
        let inertia = scaled(&problem.scene().inertia, parts.map(|part| part.map_or(1.0, |(factor, _)| factor)));
        self.add("robot", "apparent_inertia", matrix(&inertia));
        let errors = parts.iter().flatten().map(|(factor, error)| TOLERATED * error / factor);
        let error = errors.fold(0.0, f64::max);
        self.add("robustness", "inertia_error", rounded_up(error, 0.01).min(LARGEST_ERROR).into());
    }

    /// Delay and bandwidth, gains of a force mode, and what is to be tolerated of delay and sensor.
    fn add_commanded(&mut self, known: &Known, robot: &PositionRobot) {
        let bandwidth = known.find(Parameter::Bandwidth);
        if let Some((lag, error)) = known.find(Parameter::Lag) {
            // With the bandwidth of the scene where that is not known: together they have the lag that was found.
            let fitted = robot.clone().with_lag(lag, bandwidth.map_or(robot.bandwidth, |(bandwidth, _)| bandwidth));
            self.add("robot", "delay", rounded(fitted.delay.min(LARGEST_DELAY), 1e-5).into());
            // Less than the servo of the scene lags: then it is faster.
            if bandwidth.is_some() || fitted.delay == 0.0 {
                self.add("robot", "bandwidth", rounded_to_digits(fitted.bandwidth).into());
            }
            let tolerated = rounded_up(TOLERATED * error, 1e-4).min(LARGEST_DELAY);
            self.add("robustness", "delay", tolerated.into());
        }
        for (part, key) in ["translational_gain", "rotational_gain"].into_iter().enumerate() {
            if let Some((gain, _)) = known.find(Parameter::Gain { part }) {
                self.add("robot.force_mode", key, rounded_to_digits(gain).into());
            }
        }
        for (part, (key, unit)) in [("force_bias", 0.01), ("torque_bias", 0.001)].into_iter().enumerate() {
            let of_part = known.0.iter().filter(
                |estimate| matches!(estimate.quantity.parameter, Parameter::Bias { part: of, .. } if of == part),
            );
            let largest = of_part
                .map(|estimate| estimate.value.abs() + TOLERATED * estimate.standard_error.unwrap_or_default())
                .reduce(f64::max);
            if let Some(largest) = largest {
                self.add("robustness", key, rounded_up(largest, unit).into());
            }
        }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &Entry> {
        self.0.iter()
    }

    /// Whether there is nothing to change.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// As a part of a scene file.
    pub fn fragment(&self) -> String {
        self.applied(DocumentMut::new()).to_string()
    }

    /// Writes a copy of a scene file with the entries replaced; comments and order stay. An existing file is replaced
    /// only if `replaces`.
    ///
    /// # Errors
    /// When there is a file that must not be replaced, the copy would not be a scene, or it cannot be written.
    pub fn write(&self, scene: &Path, out: &Path, replaces: bool) -> Result<(), PlannerError> {
        let text = read_text(scene)?;
        let document: DocumentMut =
            text.parse().map_err(|error| PlannerError::file(scene, format!("cannot be copied: {error}")))?;
        let text = self.applied(document).to_string();
        if let Err(error) = Scene::parse(Source { file: out, text: &text }) {
            let advice =
                "the copy would not be a scene; its file names are relative to its folder: name a file in that of";
            return Err(PlannerError::file(out, format!("{advice} {}: {error}", scene.display())));
        }
        write_new_scene(out, &text, replaces)
    }

    fn applied(&self, mut document: DocumentMut) -> DocumentMut {
        'entries: for Entry { table, key, value } in &self.0 {
            let mut place: &mut dyn TableLike = document.as_table_mut();
            for name in table.split('.') {
                match place.entry(name).or_insert(Item::Table(Table::new())).as_table_like_mut() {
                    Some(within) => place = within,
                    None => continue 'entries,
                }
            }
            let mut value = value.clone();
            // The decoration of the old value, such as a trailing comment, stays.
            if let Some(old) = place.get(key).and_then(Item::as_value) {
                *value.decor_mut() = old.decor().clone();
            }
            place.insert(key, Item::Value(value));
        }
        document
    }
}

/// Estimates of identified parameters.
struct Known<'estimate>(Vec<&'estimate Estimate>);

impl Known<'_> {
    fn estimate(&self, parameter: Parameter) -> Option<&Estimate> {
        self.0.iter().find(|estimate| estimate.quantity.parameter == parameter).copied()
    }

    /// Value and standard error.
    fn find(&self, parameter: Parameter) -> Option<(f64, f64)> {
        self.estimate(parameter).and_then(|found| Some((found.value, found.standard_error?)))
    }
}

/// Largest relative change of the apparent inertia at the goal along and about an axis.
fn inertia_error(robot: &Robot, rotors: &[f64], heavier: &[f64]) -> Option<f64> {
    let inertia = |rotors: &[f64]| -> Option<Matrix6<f64>> {
        let arm = robot.arm.clone().with_rotor_inertia(rotors).ok()?;
        arm.at(&robot.configuration).apparent_inertia()
    };
    let (before, after) = (inertia(rotors)?.diagonal(), inertia(heavier)?.diagonal());
    Some(after.component_div(&before).add_scalar(-1.0).amax())
}

/// One number where all are the same.
fn one_or_list(values: &[f64]) -> Value {
    let values: Vec<f64> = values.iter().map(|value| rounded_to_digits(*value)).collect();
    match values.first() {
        Some(first) if values.iter().all(|value| value == first) => (*first).into(),
        _ => numbers(&values),
    }
}

fn numbers<'value>(values: impl IntoIterator<Item = &'value f64>) -> Value {
    Value::Array(values.into_iter().map(|value| rounded_to_digits(*value)).collect::<Array>())
}

fn matrix(inertia: &Inertia) -> Value {
    Value::Array(inertia.matrix().row_iter().map(|row| numbers(row.iter())).collect())
}

/// Three significant digits: fits are no more accurate.
fn rounded_to_digits(value: f64) -> f64 {
    const DIGITS: f64 = 1e3;
    if value == 0.0 {
        return 0.0;
    }
    let unit = 10f64.powf(value.abs().log10().ceil()) / DIGITS;
    rounded(value, unit)
}

/// The nearest multiple of a unit, without rounding errors in its digits.
fn rounded(value: f64, unit: f64) -> f64 {
    let per_unit = (1.0 / unit).round();
    if per_unit >= 1.0 { (value * per_unit).round() / per_unit } else { (value / unit).round() * unit }
}

/// The next multiple of a unit, at least one.
fn rounded_up(value: f64, unit: f64) -> f64 {
    let per_unit = (1.0 / unit).round();
    (value * per_unit).ceil().max(1.0) / per_unit
}
