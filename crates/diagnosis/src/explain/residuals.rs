//! The largest violations of constraints.

use kkt::Owner;
use ocp::Residual;
use plan::or_null;
use plan::records::GraspRecord;
use serde::{Deserialize, Serialize};
use task::AssemblyTask;

use crate::explain::words::{ConstraintName, constraint};

/// Violations that are not worth a word (in the unit of the row): Ipopt's own tolerance by default.
const NEGLIGIBLE: f64 = 1e-4;

/// The largest violation of one kind of constraint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ResidualRecord {
    /// Kind of the constraint; limits have the name of their key.
    pub kind: String,
    /// How far its value is outside of its bounds.
    #[serde(with = "or_null")]
    pub violation: f64,
    /// Unit of the violation.
    pub unit: String,
    /// Component of a position, velocity or quaternion; null for contacts.
    pub axis: Option<String>,
    /// Scenario, from 1; null for the reference.
    pub scenario: Option<usize>,
    /// Its offset.
    pub offset_m: Option<[f64; 3]>,
    /// Its rotation error.
    pub turn_rad: Option<[f64; 3]>,
    /// Time.
    pub time_s: f64,
    /// Body and environment part, for contacts.
    pub pair: Option<String>,
}

/// The largest violation of each kind, the largest first.
pub fn largest(task: &AssemblyTask, residuals: &[Residual]) -> Vec<ResidualRecord> {
    let mut found: Vec<ResidualRecord> = Vec::new();
    for residual in residuals.iter().filter(|residual| residual.violation() > NEGLIGIBLE) {
        let record = record(task, residual);
        match found.iter_mut().find(|known| (&known.kind, &known.unit) == (&record.kind, &record.unit)) {
            Some(known) if known.violation >= record.violation => {}
            Some(known) => *known = record,
            None => found.push(record),
        }
    }
    found.sort_by(|one, other| other.violation.total_cmp(&one.violation));
    found
}

fn record(task: &AssemblyTask, residual: &Residual) -> ResidualRecord {
    let member = &residual.member;
    let ConstraintName { kind, unit, axis } = constraint(member, task);
    let scenario = match member.owner {
        Owner::Reference => None,
        Owner::Scenario(index) => Some(index),
    };
    let grasp = scenario.map(|index| task.grasps[index % task.grasps.len()]);
    ResidualRecord {
        kind: kind.to_owned(),
        violation: residual.violation(),
        unit: unit.to_owned(),
        axis: axis.map(str::to_owned),
        scenario: scenario.map(|index| index + 1),
        offset_m: grasp.map(|grasp| grasp.offset),
        turn_rad: grasp.map(|grasp| grasp.rotation),
        time_s: member.stage as f64 * task.horizon.time_step,
        pair: member.pair.map(|pair| task.pairs[pair].to_string()),
    }
}

impl std::fmt::Display for ResidualRecord {
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(formatter, "{}", self.kind)?;
        if let Some(axis) = &self.axis {
            write!(formatter, " ({axis})")?;
        }
        if let Some(pair) = &self.pair {
            write!(formatter, " of {pair}")?;
        }
        if let (Some(scenario), Some(offset_m), Some(turn_rad)) = (self.scenario, self.offset_m, self.turn_rad) {
            write!(formatter, " in scenario {scenario} ({})", GraspRecord { offset_m, turn_rad })?;
        }
        write!(formatter, " at {:.2} s, by {}", self.time_s, self.amount())
    }
}

impl ResidualRecord {
    /// The violation with its unit; lengths in millimetres.
    fn amount(&self) -> String {
        match self.unit.as_str() {
            "m" => format!("{:.3} mm", 1e3 * self.violation),
            unit => format!("{:.2e} {unit}", self.violation).trim_end().to_owned(),
        }
    }
}
