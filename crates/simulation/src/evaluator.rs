//! Evaluation of references by rollouts.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use admittance::PositionRobot;
use nalgebra::{Isometry3, Vector3};
use task::{AssemblyTask, GraspError, Limits};
use workers::Workers;

use crate::arm_model::{ArmModel, ArmModelError};
use crate::bounds::Bounds;
use crate::disturbance::{Disturbance, Injection};
use crate::overshoot::Overshoot;
use crate::reference::Reference;
use crate::rollout::{Holder, Outcome, Rollout, SharedStart, Snapshot};
use crate::settings::Settings;
use crate::success::Success;

/// Index of a friction coefficient among those of an [`Evaluator`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct FrictionIndex(pub usize);

/// One rollout that a reference has to pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TestCase {
    /// Which friction there is.
    pub friction: FrictionIndex,
    /// Injected grasp error.
    pub grasp: GraspError,
    /// How robot, controller and parts differ from their models.
    pub disturbance: Disturbance,
}

impl TestCase {
    /// All errors that it injects.
    pub fn injection(&self) -> Injection {
        Injection { grasp: self.grasp, disturbance: self.disturbance }
    }
}

/// The result of a reference in a test case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TestResult {
    /// Whether the rollout ends at the goal, and contact forces and the controller's wrench keep the task's limits.
    pub passed: bool,
    /// Distance from passing, 0 when passed: the final position error with the length of the unblocked shift, and the
    /// orientation error, each as a multiple of its tolerance, plus the excess of forces and torques as fractions of
    /// their limits. At most 60.
    pub violation: f64,
    /// Largest contact force (N), the mean over 10 ms.
    pub contact_force: f64,
    /// From the end of the body to its goal (m, world frame); zero when passed.
    pub remaining_shift: Vector3<f64>,
    /// The part of this shift that no contact blocks (m, world frame); zero when passed.
    pub unblocked_shift: Vector3<f64>,
    /// Rotation vector from the end of the body to its goal (rad, body frame); zero when passed.
    pub remaining_rotation: Vector3<f64>,
    /// The part of the reference to take back where the contact force is largest, so that a spring would push with the
    /// limit; `None` within the limit.
    pub overshoot: Option<Overshoot>,
}

impl TestResult {
    const PASSED: Self = Self {
        passed: true,
        violation: 0.0,
        contact_force: 0.0,
        remaining_shift: Vector3::new(0.0, 0.0, 0.0),
        unblocked_shift: Vector3::new(0.0, 0.0, 0.0),
        remaining_rotation: Vector3::new(0.0, 0.0, 0.0),
        overshoot: None,
    };
}

/// A result, and snapshots from which rollouts of similar references continue.
#[derive(Debug, Clone)]
pub(crate) struct Record<'evaluator> {
    pub result: TestResult,
    /// Unknown where only the result is known.
    snapshots: Option<Vec<Snapshot<'evaluator>>>,
}

impl Record<'_> {
    /// Whether there are snapshots.
    pub fn has_snapshots(&self) -> bool {
        self.snapshots.is_some()
    }
}

impl From<TestResult> for Record<'_> {
    fn from(result: TestResult) -> Self {
        Self { result, snapshots: None }
    }
}

/// Evaluates references in test cases.
#[derive(Debug, Clone)]
pub struct Evaluator {
    rollouts: Vec<Rollout>,
    success: Success,
    goal: Isometry3<f64>,
    limits: Limits,
    bounds: Bounds,
    workers: Workers,
}

/// Steps of an arm's rollouts (s). They halve the time; of 720 rollouts of `peg1` with a UR5e, 4 end differently than
/// with steps of 1 ms, as many in one direction as in the other.
const ARM_TIME_STEP: f64 = 2e-3;
/// The acceleration (m/s^2) up to which these may be longer.
const ARM_STEADY: f64 = 4.0;
/// Steps of a robot that is commanded by position, in its lag.
const LAG_SHARE: f64 = 0.1;
/// Cap of the violation: where a lost part comes to rest does not matter.
const LARGEST_VIOLATION: f64 = 60.0;

impl Evaluator {
    /// For a task and several friction coefficients, with the default time step and settling time. Callers validate
    /// coefficients ([`Settings::validate`]) and tolerances ([`Success::validate`]).
    pub fn new(task: &AssemblyTask, frictions: &[f64], success: Success) -> Self {
        let rollout = |&friction: &f64| Rollout::new(task, Settings { friction, ..Settings::default() });
        let bounds = Bounds::new(task.limits);
        let rollouts = frictions.iter().map(rollout).collect();
        Self { rollouts, success, goal: task.goal.isometry(), limits: task.limits, bounds, workers: Workers::default() }
    }

    /// With references that stay near some others: [`Bounds::near`].
    pub fn near(self, references: &[&Reference], margin: f64, haste: f64, radius: f64) -> Self {
        Self { bounds: self.bounds.near(references, margin, haste, radius), ..self }
    }

    /// With threads that share the test cases; they do not affect results. The default is one.
    pub fn with_workers(self, workers: Workers) -> Self {
        Self { workers, ..self }
    }

    /// With a limit of contact forces that is a share of the task's.
    pub fn with_force_share(mut self, share: f64) -> Self {
        self.limits.contact_force *= share;
        self
    }

    /// In a hardened environment: friction coefficients times a factor, and contact forces that count friction of other
    /// contacts as reversed ([`Rollout::with_reversed_friction`]).
    pub fn hardened(self, friction_factor: f64) -> Self {
        let rollouts = self.rollouts.into_iter().map(|mut rollout| {
            rollout.settings.friction *= friction_factor;
            rollout.with_reversed_friction()
        });
        Self { rollouts: rollouts.collect(), ..self }
    }

    /// With an arm that holds the body. Steps are longer then: 2 ms, or a control period if that is shorter.
    ///
    /// # Errors
    /// As [`Rollout::with_arm`].
    pub fn with_arm(self, model: &ArmModel) -> Result<Self, ArmModelError> {
        let rollouts = self.rollouts.into_iter().map(|mut rollout| {
            rollout.settings.time_step = ARM_TIME_STEP;
            rollout.with_steady(ARM_STEADY).with_arm(model)
        });
        Ok(Self { rollouts: rollouts.collect::<Result<_, _>>()?, ..self })
    }

    /// With a robot that is commanded by position or force. Steps are longer then: a tenth of its lag, or a control period if that
    /// is shorter.
    pub fn with_position_robot(self, robot: &PositionRobot) -> Self {
        let rollouts = self.rollouts.into_iter().map(|mut rollout| {
            rollout.settings.time_step = LAG_SHARE * robot.contact_loop().lag();
            rollout.with_position_robot(robot)
        });
        Self { rollouts: rollouts.collect(), ..self }
    }

    /// What counts as success.
    pub fn success(&self) -> &Success {
        &self.success
    }

    /// Whether contact forces have a limit.
    pub fn limits_contact_forces(&self) -> bool {
        self.limits.contact_force.is_finite()
    }

    /// Smallest distance of an arm's joints from the ends of their ranges (rad or m) along a reference; infinite
    /// without an arm. `None` if the arm cannot follow it.
    pub(crate) fn room(&self, reference: &Reference) -> Option<f64> {
        match self.rollouts.first().map(|rollout| &rollout.holder) {
            Some(Holder::Arm(model, _)) => model.room(reference),
            _ => Some(f64::INFINITY),
        }
    }

    /// Bounds on the motion of references; by default the task's limits alone.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Simulates one test case.
    ///
    /// # Panics
    /// When the evaluator has no friction coefficient of the test case's index.
    pub fn evaluate(&self, reference: &Reference, case: &TestCase) -> TestResult {
        self.result(&self.rollouts[case.friction.0].play(reference, case.injection(), |_, _| {}))
    }

    /// Turns the outcome of a rollout into a result.
    fn result(&self, outcome: &Outcome) -> TestResult {
        let (excess, contact_force) = (outcome.loads.excess(&self.limits), outcome.loads.contact_force);
        if outcome.succeeds(&self.success, &self.limits) {
            return TestResult { contact_force, ..TestResult::PASSED };
        }
        let shift = outcome.position_error + outcome.unblocked.norm();
        let violation = shift / self.success.position + outcome.orientation_error / self.success.orientation + excess;
        let end = outcome.pose.isometry();
        let surplus = 1.0 - self.limits.contact_force / contact_force;
        TestResult {
            passed: false,
            // The comparison is false for NaN, which becomes the largest violation.
            violation: if violation < LARGEST_VIOLATION { violation } else { LARGEST_VIOLATION },
            contact_force,
            remaining_shift: outcome.remaining,
            unblocked_shift: outcome.unblocked,
            remaining_rotation: (end.rotation.inverse() * self.goal.rotation).scaled_axis(),
            overshoot: (surplus > 0.0).then(|| outcome.overshoot.scaled(surplus)),
        }
    }

    /// Simulates all test cases. Results have the order of the test cases; `None` when `stop` returned true before the
    /// last of them began.
    ///
    /// # Panics
    /// When the evaluator has no friction coefficient of a test case's index.
    pub fn evaluate_all(
        &self,
        reference: &Reference,
        cases: &[TestCase],
        stop: &(dyn Fn() -> bool + Sync),
    ) -> Option<Vec<TestResult>> {
        let evaluate = |case: &TestCase| (!stop()).then(|| self.evaluate(reference, case));
        self.workers.map(cases.iter(), evaluate).into_iter().collect()
    }

    /// As [`evaluate_all`](Self::evaluate_all), but every test case has a record of another reference that is the same
    /// on the first `same` intervals, and only the rest is simulated; results are the same. `keep_going` gets the
    /// results in the order of the test cases; when it returns false, `None` is returned.
    pub(crate) fn record_all<'evaluator, 'record>(
        &'evaluator self,
        reference: &Reference,
        cases: impl Iterator<Item = (TestCase, &'record Record<'evaluator>)>,
        same: usize,
        stop: &(dyn Fn() -> bool + Sync),
        mut keep_going: impl FnMut(&TestResult) -> bool,
    ) -> Option<Vec<Record<'evaluator>>>
    where
        'evaluator: 'record,
    {
        // Once the result is known, threads need not finish their rollouts.
        let is_decided = AtomicBool::new(false);
        let is_over = || is_decided.load(Ordering::Relaxed) || stop();
        let record = |(case, known): (TestCase, &Record<'evaluator>)| {
            let snapshots = known.snapshots.as_deref().unwrap_or_default();
            let injection = case.injection();
            let replayed = self.rollouts[case.friction.0].replay(
                reference,
                &injection,
                SharedStart { snapshots, intervals: same },
                &is_over,
            )?;
            let (outcome, snapshots) = replayed;
            Some(Record { result: self.result(&outcome), snapshots: Some(snapshots) })
        };
        let (mut records, mut is_whole) = (Vec::new(), true);
        self.workers.in_order(cases, record, |new| match new {
            Some(new) if keep_going(&new.result) => {
                records.push(new);
                ControlFlow::Continue(())
            }
            _ => {
                is_decided.store(true, Ordering::Relaxed);
                is_whole = false;
                ControlFlow::Break(())
            }
        });
        is_whole.then_some(records)
    }
}
