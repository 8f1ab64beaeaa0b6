//! Rollouts of one plan with random errors that are the same in all comparisons.

use std::sync::Arc;

use collision::PolytopeError;
use nalgebra::Vector3;
use plan::{PlannerError, Problem, Session, short};
use scene::Scene;
use serde::{Deserialize, Serialize};
use simulation::{Reference, Rollout, Settings, offsets};
use task::{AssemblyTask, Coverage, GraspError};
use workers::Workers;

use crate::chamfer::chamfered;
use crate::clearance::widened;
use crate::conditions::Conditions;
use crate::mouth::Mouth;
use crate::quantity::Quantity;

/// What is asked of a plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ToleranceRequest {
    /// Success rate that the rollouts must reach.
    pub rate: f64,
    /// Coulomb's coefficients, of which the rollouts have one each in turn.
    pub frictions: Vec<f64>,
    /// Largest number of rollouts with different errors.
    pub cases: usize,
    /// Seed of the errors.
    pub seed: u64,
}

impl Default for ToleranceRequest {
    fn default() -> Self {
        Self { rate: 0.99, frictions: vec![0.0, 0.1, 0.3], cases: 2000, seed: 1 }
    }
}

impl ToleranceRequest {
    /// Numbers of rollouts that are of use.
    pub const CASES: std::ops::RangeInclusive<usize> = 20..=1_000_000;

    /// Checks all values.
    ///
    /// # Errors
    /// With the first that is out of its range.
    pub fn validate(&self) -> Result<(), PlannerError> {
        let refuse = |name, problem: &str| Err(PlannerError::Choice { name, problem: problem.to_owned() });
        if !(0.5 <= self.rate && self.rate < 1.0) {
            return refuse("rate", "must be at least 0.5 and below 1: no number of rollouts shows a rate of 1");
        }
        if !Self::CASES.contains(&self.cases) {
            return refuse("cases", "must lie between 20 and 1000000");
        }
        let is_friction = |friction: &f64| (0.0..=10.0).contains(friction);
        match self.frictions.is_empty() || !self.frictions.iter().all(is_friction) {
            true => refuse("friction", "must be at least one number, each between 0 and 10"),
            false => Ok(()),
        }
    }
}

/// The directions of the errors of one rollout, whose sizes are those of [`Conditions`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case {
    /// Of the part in the gripper (body frame); at most 1 long.
    offset: Vector3<f64>,
    /// Unit axis of its rotation (body frame).
    axis: Vector3<f64>,
    /// Unit direction of the environment's error (world frame).
    hole: Vector3<f64>,
    /// Index of the friction.
    friction: usize,
}

/// Rollouts of one plan with random errors. Conditions only scale these, so that comparisons have no noise of their own.
pub struct Trials<'problem> {
    problem: &'problem Problem,
    reference: Reference,
    /// What is asked of the plan.
    pub(crate) request: ToleranceRequest,
    cases: Vec<Case>,
    pub(crate) workers: Workers,
}

/// The cases under some conditions.
pub(crate) struct Player {
    conditions: Conditions,
    /// One per friction.
    rollouts: Vec<Arc<Rollout>>,
}

impl<'problem> Trials<'problem> {
    /// Of a plan's reference.
    ///
    /// # Errors
    /// When a value of the request is out of its range.
    pub fn new(
        problem: &'problem Problem,
        reference: Reference,
        request: ToleranceRequest,
        session: &Session,
    ) -> Result<Self, PlannerError> {
        request.validate()?;
        for &friction in &request.frictions {
            Settings { friction, ..Settings::default() }.validate_for(&reference)?;
        }
        let cases = cases(problem, &request);
        Ok(Self { problem, reference, request, cases, workers: Workers::new(session.threads) })
    }

    /// The same of another reference.
    ///
    /// # Errors
    /// When it cannot be played.
    pub fn of(&self, reference: Reference, session: &Session) -> Result<Self, PlannerError> {
        Self::new(self.problem, reference, self.request.clone(), session)
    }

    /// The problem of the plan.
    pub fn problem(&self) -> &'problem Problem {
        self.problem
    }

    /// The conditions for which the plan was made.
    pub fn nominal(&self) -> Conditions {
        Conditions {
            offset: self.problem.offset_magnitude(),
            rotation: self.problem.scene().robustness.rotation_error,
            hole: 0.0,
            friction: None,
            clearance: None,
            chamfer: None,
        }
    }

    /// The clearance of the scene (m).
    ///
    /// # Errors
    /// When nothing guides the body at its goal.
    pub fn clearance(&self) -> Result<f64, PlannerError> {
        self.problem.engagement().clearance_m.ok_or_else(|| PlannerError::Choice {
            name: "clearance",
            problem: "nothing guides the body at its goal on both sides, so that there is no clearance to change"
                .to_owned(),
        })
    }

    /// The scene with another clearance (m).
    ///
    /// # Errors
    /// When nothing guides the body at its goal, or nothing would be left of a part.
    pub fn scene_with_clearance(&self, clearance: f64) -> Result<Scene, PlannerError> {
        let more = clearance - self.clearance()?;
        widened(self.problem.scene(), &self.out(), more).map_err(nothing_left("clearance", clearance))
    }

    /// The mouth of the hole around the body at its goal.
    ///
    /// # Errors
    /// When the body is in no hole, or in one that cannot have a chamfer.
    pub fn mouth(&self) -> Result<Mouth, PlannerError> {
        Mouth::of(self.problem.scene(), &self.out()).ok_or_else(|| PlannerError::Choice {
            name: "chamfer",
            problem: "the hole cannot be given a chamfer: it needs a convex section, sides along the insertion and a flat, sharp \
                      rim; remove an existing chamfer from the scene"
                .to_owned(),
        })
    }

    /// Refuses a quantity that the parts do not have.
    pub(crate) fn require(&self, quantity: Quantity) -> Result<(), PlannerError> {
        match quantity {
            Quantity::Clearance => self.clearance().map(drop),
            Quantity::Chamfer => self.mouth().map(drop),
            _ => Ok(()),
        }
    }

    /// The scene with a chamfer of some width (m) at the mouth of its hole.
    ///
    /// # Errors
    /// When there is no such mouth, the chamfer is too large for it, or nothing would be left of a part.
    pub fn scene_with_chamfer(&self, width: f64) -> Result<Scene, PlannerError> {
        let mouth = self.mouth()?;
        if !(0.0..=mouth.most).contains(&width) {
            let rule = format!("must lie between 0 and {} m, half of the smallest side or rim", short(mouth.most));
            return Err(PlannerError::value("chamfer", width, &rule));
        }
        chamfered(self.problem.scene(), &mouth, width).map_err(nothing_left("chamfer", width))
    }

    /// Direction in which the body leaves its goal.
    fn out(&self) -> Vector3<f64> {
        self.problem.engagement().out.into()
    }

    /// The reference of the plan.
    pub fn reference(&self) -> &Reference {
        &self.reference
    }

    /// The first cases.
    pub(crate) fn cases(&self, count: usize) -> &[Case] {
        &self.cases[..count.min(self.cases.len())]
    }

    /// The cases under conditions; what `last` has prepared for the same shapes and frictions is used again.
    pub(crate) fn player(&self, conditions: Conditions, last: Option<&Player>) -> Result<Player, PlannerError> {
        let shapes = |conditions: &Conditions| (conditions.friction, conditions.clearance, conditions.chamfer);
        if let Some(last) = last.filter(|last| shapes(&last.conditions) == shapes(&conditions)) {
            return Ok(Player { conditions, rollouts: last.rollouts.clone() });
        }
        let world = self.world(&conditions)?;
        let frictions = conditions.friction.map_or_else(|| self.request.frictions.clone(), |friction| vec![friction]);
        let rollout = |friction| {
            let settings = Settings { friction, ..Settings::default() };
            self.problem.rollout_in(&world, settings).map(Arc::new)
        };
        Ok(Player { conditions, rollouts: frictions.into_iter().map(rollout).collect::<Result<_, _>>()? })
    }

    /// All shapes, with the clearance and the chamfer of some conditions.
    fn world(&self, conditions: &Conditions) -> Result<AssemblyTask, PlannerError> {
        let world = self.problem.world();
        let body = conditions.clearance.map(|clearance| self.scene_with_clearance(clearance)).transpose()?;
        let hole = conditions.chamfer.map(|width| self.scene_with_chamfer(width)).transpose()?;
        let pairs = match (body, hole) {
            (None, None) => return Ok(world),
            (Some(scene), None) | (None, Some(scene)) => scene.all_pairs(),
            (Some(body), Some(hole)) => Scene { body: body.body, ..hole }.all_pairs(),
        };
        Ok(AssemblyTask { pairs, ..world })
    }

    /// Whether a case ends at the goal within the limits of the task.
    pub(crate) fn passes(&self, player: &Player, case: &Case) -> bool {
        let Conditions { offset, rotation, hole, .. } = player.conditions;
        let grasp = GraspError { offset: (case.offset * offset).into(), rotation: (case.axis * rotation).into() };
        let rollout = &player.rollouts[case.friction % player.rollouts.len()];
        let outcome = match hole == 0.0 {
            true => rollout.play(&self.reference, grasp, |_, _| {}),
            // An error of the hole is the opposite error of the robot.
            false => rollout.play(&self.reference.shifted(&(case.hole * -hole)), grasp, |_, _| {}),
        };
        outcome.succeeds(&self.problem.success(), &self.problem.task().limits)
    }
}

/// The error of a size (m) of a part with which nothing is left of it.
fn nothing_left(name: &'static str, size: f64) -> impl FnOnce((String, PolytopeError)) -> PlannerError {
    move |(part, error)| PlannerError::Choice {
        name,
        problem: format!("{:.3} mm leaves nothing of `{part}`: {error}", 1e3 * size),
    }
}

/// Random directions. Offsets on the rim and inside of what is covered alternate, so that the first cases stand for all.
fn cases(problem: &Problem, request: &ToleranceRequest) -> Vec<Case> {
    let (scene, count, seed) = (problem.scene(), request.cases, request.seed);
    let directions = match scene.coverage {
        Coverage::Hull => &scene.offset_directions[..],
        Coverage::Disc { .. } | Coverage::Ball => &[],
    };
    let drawn = offsets::covered(&scene.coverage, directions, 1.0, count, seed);
    let (rim, inside) = drawn.split_at(offsets::rim_count(count));
    let out = Vector3::from(problem.engagement().out);
    let unit = |vector: Vector3<f64>| vector.try_normalize(0.0).unwrap_or_else(Vector3::x);
    let axes = offsets::rotations(1.0, count, seed);
    // Independent of the others.
    let holes = offsets::rotations(1.0, count, seed.wrapping_add(1));
    (0..count)
        .map(|index| {
            let [axis, hole] = [axes[index], holes[index]].map(Vector3::from);
            let side = if index % 2 == 0 { rim } else { inside };
            Case {
                offset: side[index / 2].into(),
                axis: unit(axis),
                hole: unit(hole - out * out.dot(&hole)),
                friction: index,
            }
        })
        .collect()
}
