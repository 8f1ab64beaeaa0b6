//! Constraints that depend on each other or contradict each other.
//!
//! The constraints that are active at a point restrict a small change `d` of it by `a_i d = b_i`, or `>=`, or `<=`. Where
//! weights `y` make `sum y_i a_i = 0`, the constraints with weights depend on each other. Where `sum y_i b_i` is not zero
//! and all inequalities push the same way, they contradict: no change can satisfy all of them (Farkas' lemma).

use std::collections::BTreeSet;

use kkt::Owner;
use ocp::{Activity, ConstraintIndex, Residual, Transcription};
use serde::{Deserialize, Serialize};
use task::AssemblyTask;

use crate::explain::factorisation::{Column, factorise};
use crate::explain::words::constraint_at;

/// Largest numbers of dependencies that are examined, and that are reported.
const MOST: usize = 50;
const KEPT: usize = 3;
/// Constraints of a dependency that are named.
const NAMED: usize = 8;
/// Weights below this share of the largest are ignored.
const MINOR: f64 = 0.05;
/// A contradiction leaves a violation of at least this share of the largest one.
const CONTRADICTION: f64 = 1e-3;
/// Without a sparse factorisation, knots near this number of largest violations are examined.
const VIOLATIONS: usize = 3;

/// Constraints that depend on each other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DependencyRecord {
    /// The constraints with the largest weights, the largest first.
    pub constraints: Vec<String>,
    /// How many more there are.
    pub more: usize,
    /// Whether they cannot all hold.
    pub contradict: bool,
}

/// The dependencies among the active constraints of a point `x`, those that contradict most first. Without the feature `spqr`,
/// only near the largest violations. `None` where a distance has no value.
pub fn find(transcription: &mut Transcription, x: &[f64], residuals: &[Residual]) -> Option<Vec<DependencyRecord>> {
    let active: Vec<&Residual> = residuals.iter().filter(|residual| residual.activity().is_some()).collect();
    let looked_at = if cfg!(feature = "spqr") { active } else { near_violations(&active) };
    let indices: Vec<ConstraintIndex> = looked_at.iter().map(|residual| residual.index).collect();
    let gradients = transcription.gradients(x, &indices).ok()?;
    let (columns, active): (Vec<Column>, Vec<ActiveConstraint>) = looked_at
        .iter()
        .zip(gradients)
        .filter_map(|(residual, gradient)| ActiveConstraint::new(residual, gradient))
        .unzip();
    let vectors = factorise(x.len(), &columns)?.null_vectors(MOST);
    let mut found: Vec<Dependency> = vectors.iter().map(|weights| Dependency::new(&active, weights)).collect();
    found.sort_by(|one, other| other.left.total_cmp(&one.left).then(one.weighed.len().cmp(&other.weighed.len())));
    let records = found.iter().take(KEPT).map(|dependency| dependency.record(transcription.task()));
    Some(records.collect())
}

/// An active constraint whose gradient is scaled to unit length.
struct ActiveConstraint {
    residual: Residual,
    activity: Activity,
    /// Change of the scaled constraint that brings it to its bound.
    missing: f64,
}

impl ActiveConstraint {
    /// With its gradient scaled to unit length; `None` without a gradient.
    fn new(residual: &Residual, gradient: Column) -> Option<(Column, Self)> {
        let activity = residual.activity()?;
        let norm = gradient.iter().map(|(_, value)| value * value).sum::<f64>().sqrt();
        let scaled = gradient.into_iter().map(|(column, value)| (column, value / norm)).collect();
        let constraint = Self { residual: *residual, activity, missing: residual.missing() / norm };
        (norm > 0.0 && norm.is_finite()).then_some((scaled, constraint))
    }
}

/// The constraints of the reference and of the scenarios with the largest violations, at their stages and the next ones.
fn near_violations<'point>(active: &[&'point Residual]) -> Vec<&'point Residual> {
    let mut violated = active.to_vec();
    violated.sort_by(|one, other| other.violation().total_cmp(&one.violation()));
    violated.truncate(VIOLATIONS);
    let stages: BTreeSet<usize> = violated
        .iter()
        .flat_map(|residual| residual.member.stage.saturating_sub(1)..=residual.member.stage + 1)
        .collect();
    let owners: BTreeSet<Owner> =
        violated.iter().map(|residual| residual.member.owner).chain([Owner::Reference]).collect();
    let is_near =
        |residual: &&&Residual| stages.contains(&residual.member.stage) && owners.contains(&residual.member.owner);
    active.iter().filter(is_near).copied().collect()
}

/// Constraints whose gradients, with weights, sum up to zero.
struct Dependency<'point> {
    /// Those with significant weights, the largest first.
    weighed: Vec<(&'point ActiveConstraint, f64)>,
    /// Smallest remaining violation after any small change; 0 where they do not contradict.
    left: f64,
}

impl<'point> Dependency<'point> {
    fn new(active: &'point [ActiveConstraint], weights: &[f64]) -> Self {
        let largest = weights.iter().fold(0.0, |largest: f64, weight| largest.max(weight.abs()));
        let mut weighed: Vec<(&ActiveConstraint, f64)> = active.iter().zip(weights.iter().copied()).collect();
        weighed.retain(|(_, weight)| weight.abs() > MINOR * largest);
        weighed.sort_by(|(_, one), (_, other)| other.abs().total_cmp(&one.abs()));
        let left = violation_left(&weighed);
        Self { weighed, left }
    }

    fn record(&self, task: &AssemblyTask) -> DependencyRecord {
        let named = self.weighed.iter().take(NAMED);
        DependencyRecord {
            constraints: named.map(|(constraint, _)| constraint_at(&constraint.residual.member, task)).collect(),
            more: self.weighed.len().saturating_sub(NAMED),
            contradict: self.left > 0.0,
        }
    }
}

/// The largest violation, at least, that some dependent constraints have after any small change.
fn violation_left(weighed: &[(&ActiveConstraint, f64)]) -> f64 {
    let sum: f64 = weighed.iter().map(|(constraint, weight)| weight * constraint.missing).sum();
    let total: f64 = weighed.iter().map(|(_, weight)| weight.abs()).sum();
    let worst = weighed.iter().fold(0.0, |worst: f64, (constraint, _)| worst.max(constraint.missing.abs()));
    let pushes = |(constraint, weight): &(&ActiveConstraint, f64)| match constraint.activity {
        Activity::Equality => true,
        Activity::Lower => weight * sum > 0.0,
        Activity::Upper => weight * sum < 0.0,
    };
    let left = sum.abs() / total;
    if left > CONTRADICTION * worst && weighed.iter().all(pushes) { left } else { 0.0 }
}

impl std::fmt::Display for DependencyRecord {
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        let what = if self.contradict { "cannot all hold" } else { "depend on each other" };
        write!(formatter, "these constraints {what}: {}", self.constraints.join(", "))?;
        match self.more {
            0 => Ok(()),
            more => write!(formatter, ", and {more} more"),
        }
    }
}
