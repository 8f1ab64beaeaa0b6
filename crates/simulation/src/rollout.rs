//! Closed-loop rollouts of plans under injected errors.

use std::sync::Arc;

use admittance::PositionRobot;
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use robot::JointVector;
use task::{AssemblyTask, Limits, Pose};
use workers::Workers;

use crate::admittance_dynamics::AdmittanceStepper;
use crate::arm_dynamics::ArmStepper;
use crate::arm_model::{ArmModel, ArmModelError};
use crate::body::Body;
use crate::bounds::LIMIT_SLACK;
use crate::contact::{ContactFinder, Shapes};
use crate::contact_solver::ContactSolver;
use crate::disturbance::Injection;
use crate::dynamics::Stepper;
use crate::loads::{LoadMeter, Loads};
use crate::overshoot::Overshoot;
use crate::plant::Plant;
use crate::reference::Reference;
use crate::rollout_state::RolloutState;
use crate::settings::Settings;
use crate::step_length::{STEADY, Steps};
use crate::success::Success;
use crate::timed_state::TimedState;

/// The state of a rollout, kept to continue from.
pub(crate) type Snapshot<'rollout> = Arc<RolloutState<'rollout>>;

/// The rollout of another reference that begins in the same way.
pub(crate) struct SharedStart<'start, 'rollout> {
    /// Of that rollout.
    pub snapshots: &'start [Snapshot<'rollout>],
    /// Number of the first intervals on which the references are the same.
    pub intervals: usize,
}

/// Contact forces beyond this (N) are those of no parts that a robot assembles, but of a solver without a solution: between walls
/// without clearance, impulses grow from step to step.
const LARGEST_FORCE: f64 = 1e6;

/// Largest number of snapshots of a rollout.
const SNAPSHOTS: usize = 10;

/// A task that is ready to be simulated.
#[derive(Debug, Clone)]
pub struct Rollout {
    pub(crate) task: AssemblyTask,
    pub(crate) settings: Settings,
    shapes: Shapes,
    /// Whether all steps have the same length.
    has_even_steps: bool,
    /// The acceleration (m/s^2) up to which steps may be longer.
    steady: f64,
    /// Whether contact forces count friction as reversed.
    reverses_friction: bool,
    /// The orientation of the part for which the gains are set, where the arm is controlled as by players.
    set_for: Option<UnitQuaternion<f64>>,
    /// Where the robot believes the part at the beginning, if not at the start of the reference.
    begins_at: Option<Pose>,
    pub(crate) holder: Holder,
}

/// What holds the body.
#[derive(Debug, Clone)]
pub(crate) enum Holder {
    /// Nothing but the impedance of the task: the body moves freely.
    Impedance,
    /// An arm, and its joint positions at the task's start.
    Arm(Box<ArmModel>, JointVector),
    /// A robot that is commanded by position or force.
    Position(Box<PositionRobot>),
}

/// How a rollout ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Final pose of the body (position m, unit quaternion w x y z).
    pub pose: Pose,
    /// Distance of the final position from the goal (m).
    pub position_error: f64,
    /// Angle between the final orientation and the goal (rad).
    pub orientation_error: f64,
    /// Deepest penetration of a pair (m) after any time step, or at the start.
    pub max_penetration: f64,
    /// Largest contact force, and largest wrench of the controller.
    pub loads: Loads,
    /// Where the contact force is largest.
    pub overshoot: Overshoot,
    /// From the final position to the goal (m, world frame).
    pub remaining: Vector3<f64>,
    /// The part of this that no contact blocks (m, world frame).
    pub unblocked: Vector3<f64>,
    /// Whether the state ceased to be finite, a contact force is larger than any that parts stand, as between walls without
    /// clearance, or the rollout could not be computed at all. The other fields are then meaningless.
    pub diverged: bool,
}

impl Outcome {
    /// Whether the rollout succeeds: it ends at the goal and keeps the limits of contact forces and of the controller's wrench.
    pub fn succeeds(&self, success: &Success, limits: &Limits) -> bool {
        self.reaches_goal(success) && self.loads.excess(limits) <= LIMIT_SLACK
    }

    /// Whether the rollout ends at the goal.
    pub fn reaches_goal(&self, success: &Success) -> bool {
        !self.diverged && success.reached(self.position_error, self.orientation_error)
    }
}

impl Rollout {
    /// Prepares the shapes of a task. Callers validate the settings ([`Settings::validate_for`]).
    pub fn new(task: &AssemblyTask, settings: Settings) -> Self {
        let shapes = Shapes::new(&task.pairs);
        Self {
            task: task.clone(),
            settings,
            shapes,
            has_even_steps: false,
            steady: STEADY,
            reverses_friction: false,
            set_for: None,
            begins_at: None,
            holder: Holder::Impedance,
        }
    }

    /// With an arm that holds the body. The arm then determines the inertia; the time step becomes the largest divisor
    /// of the control period that is not longer than that of the settings.
    ///
    /// # Errors
    /// When a number of the settings or of the model is out of its range, or the arm does not reach goal,
    /// start and the straight path between them on one IK branch.
    pub fn with_arm(mut self, model: &ArmModel) -> Result<Self, ArmModelError> {
        self.settings.validate()?;
        let start = model.start(&self.task)?;
        self.settings.time_step = self.settings.divide(model.control_period).0;
        self.holder = Holder::Arm(Box::new(model.clone()), start);
        Ok(self)
    }

    /// With a robot that is commanded by position or force and determines inertia and impedance. The time step becomes the
    /// largest divisor of its control period that is not longer than that of the settings.
    pub fn with_position_robot(mut self, robot: &PositionRobot) -> Self {
        self.settings.time_step = self.settings.divide(robot.period).0;
        self.holder = Holder::Position(Box::new(robot.clone()));
        self
    }

    /// With longer steps that change the velocity of no point by more than this acceleration (m/s^2) does in the
    /// shortest step; the default is 1.
    pub fn with_steady(self, acceleration: f64) -> Self {
        Self { steady: acceleration, ..self }
    }

    /// Reports contact forces with the friction of all other contacts reversed, an upper estimate for compliant
    /// contacts. Motions do not change.
    pub fn with_reversed_friction(self) -> Self {
        Self { reverses_friction: true, ..self }
    }

    /// With steps of equal length, so that motions depend smoothly on the parameters of task and arm.
    pub fn with_even_steps(self) -> Self {
        Self { has_even_steps: true, ..self }
    }

    /// With an arm that is controlled as by players. Its gains are set once, for the part at this orientation: their
    /// axes do not rotate with the part. Coriolis and centrifugal torques are not balanced.
    pub fn with_gains_set_for(self, orientation: UnitQuaternion<f64>) -> Self {
        Self { set_for: Some(orientation), ..self }
    }

    /// At rest at the beginning where the robot believes the part at this pose, beside the start of the reference.
    pub fn with_beginning(self, believed: Pose) -> Self {
        Self { begins_at: Some(believed), ..self }
    }

    /// One rollout of a reference per injection, grasp error or offset (m, body frame). Outcomes have their order and
    /// do not depend on the number of threads.
    pub fn simulate<G: Copy + Into<Injection> + Sync>(
        &self,
        reference: &Reference,
        injections: &[G],
        workers: &Workers,
    ) -> Vec<Outcome> {
        workers.map(injections.iter(), |&injection| self.play(reference, injection, |_, _| {}))
    }

    /// One rollout of a reference with an injection, grasp error or offset (m, body frame). The body starts at rest
    /// where it really is when the robot believes it to be at the reference's start; at its end the reference is held
    /// for the settling time. `observe` gets the state after every time step, and the normal impulse (Ns) of every pair
    /// since the last knot. Within time steps that are taken as one, states are interpolated, and impulses are those at
    /// its end.
    ///
    /// A reference that [`Settings::validate_for`] refuses, a disturbance out of its range, an inertia that is not
    /// positive definite, or a start that the arm does not reach cannot be simulated: the outcome has diverged at its
    /// start.
    pub fn play(
        &self,
        reference: &Reference,
        injection: impl Into<Injection>,
        mut observe: impl FnMut(&TimedState, &[f64]),
    ) -> Outcome {
        let injection = injection.into();
        let Some(state) = self.begin(reference, &injection) else { return self.impossible(reference, &injection) };
        self.finish(state, reference, &injection, &mut observe, |_| true)
    }

    /// Number of first intervals of a reference in which the body touches nothing, whatever the injection; 0 where a rollout
    /// cannot begin.
    pub fn intervals_in_free_air<G: Copy + Into<Injection>>(&self, reference: &Reference, injections: &[G]) -> usize {
        let free = injections.iter().map(|&injection| self.first_contact(reference, &injection.into()));
        free.fold(reference.intervals(), usize::min)
    }

    /// Number of intervals before the one in which the body touches something for the first time.
    fn first_contact(&self, reference: &Reference, injection: &Injection) -> usize {
        let Some(state) = self.begin(reference, injection) else { return 0 };
        let mut free = 0;
        self.finish(state, reference, injection, &mut |_, _| {}, |state| {
            let touches = state.impulses.iter().any(|impulse| *impulse > 0.0);
            free = if touches { free } else { state.intervals };
            !touches && state.is_finite()
        });
        free
    }

    /// As [`play`](Self::play), but continues from the last applicable snapshot of another reference's rollout. Returns
    /// the outcome and new snapshots. `None` when `stop` returned true before an interval.
    pub(crate) fn replay<'rollout>(
        &'rollout self,
        reference: &Reference,
        injection: &Injection,
        start: SharedStart<'_, 'rollout>,
        stop: &dyn Fn() -> bool,
    ) -> Option<(Outcome, Vec<Snapshot<'rollout>>)> {
        let mut snapshots: Vec<Snapshot> =
            start.snapshots.iter().filter(|snapshot| snapshot.intervals <= start.intervals).cloned().collect();
        let state = match snapshots.last() {
            Some(snapshot) => Some(RolloutState::clone(snapshot)),
            None => self.begin(reference, injection),
        };
        let Some(state) = state else { return Some((self.impossible(reference, injection), snapshots)) };
        let (first, last) = (state.intervals, reference.intervals());
        let apart = last.div_ceil(SNAPSHOTS).max(1);
        let mut is_whole = true;
        let outcome = self.finish(state, reference, injection, &mut |_, _| {}, |state| {
            if state.intervals > first && state.intervals < last && state.intervals % apart == 0 {
                snapshots.push(Arc::new(state.clone()));
            }
            is_whole = !stop();
            is_whole
        });
        is_whole.then_some((outcome, snapshots))
    }

    /// The rollout before its first step. `None` if it cannot be simulated.
    fn begin(&self, reference: &Reference, injection: &Injection) -> Option<RolloutState<'_>> {
        let Injection { grasp, disturbance } = injection;
        let pose = grasp.actual(&self.begins_at.unwrap_or_else(|| reference.start())).isometry();
        let mut finder = ContactFinder::new(&self.shapes, disturbance.edge_radius);
        let pairs = self.task.pairs.len();
        Some(RolloutState {
            plant: self.plant(reference, &pose, injection)?,
            body: Body { pose, velocity: Vector3::zeros(), angular_velocity: Vector3::zeros() },
            max_penetration: (-finder.find(&pose, 0.0)).max(0.0),
            finder,
            impedance: disturbance.impedance(self.task.impedance.clone()),
            grasp: grasp.pose(),
            steps: self.settings.divide(reference.time_step()),
            intervals: 0,
            loads: LoadMeter::new(pairs),
            overshoot: Overshoot::NONE,
            step_impulses: vec![0.0; pairs],
            impulses: vec![0.0; pairs],
        })
    }

    /// Runs a rollout to its end. `keep_going` is called after every interval; returning false stops it.
    fn finish<'rollout>(
        &'rollout self,
        mut state: RolloutState<'rollout>,
        reference: &Reference,
        injection: &Injection,
        observe: &mut impl FnMut(&TimedState, &[f64]),
        mut keep_going: impl FnMut(&RolloutState<'rollout>) -> bool,
    ) -> Outcome {
        let of_part = reference.of_part(&injection.grasp);
        let intervals = reference.intervals() + self.settings.settling_intervals(reference.time_step());
        while state.intervals < intervals && state.is_finite() {
            state.follow(reference, &of_part, observe);
            if !keep_going(&state) {
                break;
            }
        }
        let RolloutState { body, max_penetration, loads, overshoot, finder, .. } = &state;
        // Comparisons are false for what is no number.
        let diverged = !(state.is_finite() && loads.largest().contact_force <= LARGEST_FORCE);
        let loads = if diverged { Loads::UNBOUNDED } else { loads.largest() };
        let outcome = self.outcome(&body.pose, *max_penetration, loads, *overshoot);
        Outcome { unblocked: finder.unblocked(&outcome.remaining), diverged, ..outcome }
    }

    /// The plant with the body at rest at a pose; `None` if it cannot be simulated.
    fn plant(&self, reference: &Reference, start: &Isometry3<f64>, injection: &Injection) -> Option<Plant<'_>> {
        let Injection { grasp, disturbance } = injection;
        self.settings.validate_for(reference).ok().and(disturbance.validate().ok())?;
        let impedance = disturbance.impedance(grasp.impedance(&self.task.impedance));
        let as_set = disturbance.impedance(self.task.impedance.clone()).rotational_damping;
        let (time_step, substeps) = self.settings.divide(reference.time_step());
        let solver = ContactSolver::new(self.settings.friction, self.reverses_friction);
        let most = if self.has_even_steps { 1 } else { substeps };
        let steps = Steps { time_step, most, steady: self.steady };
        let offset = Vector3::from(grasp.offset);
        match &self.holder {
            Holder::Impedance => {
                let inertia = disturbance.inertia(&self.task.inertia);
                let stepper = Stepper::new(&steps, &inertia, &impedance, offset, solver);
                stepper.map(|stepper| Plant::Body(Box::new(stepper)))
            }
            Holder::Position(robot) => {
                let stepper = AdmittanceStepper::new(robot, start, offset, disturbance, &steps, solver);
                let beside = self.begins_at.map(|_| reference.of_part(grasp).at(0, 0.0).pose);
                let stepper = stepper.map(|stepper| match beside {
                    Some(reference) => stepper.beside(reference),
                    None => stepper,
                });
                stepper.map(|stepper| Plant::Admittance(Box::new(stepper)))
            }
            Holder::Arm(model, near) => {
                let stepper = ArmStepper::new(model, near, start, injection, impedance, &steps, solver);
                let set = self.set_for.map(|orientation| (orientation, as_set));
                stepper.map(|stepper| Plant::Arm(Box::new(stepper.with_damping_set_for(set))))
            }
        }
    }

    /// The outcome of a rollout that cannot be simulated.
    fn impossible(&self, reference: &Reference, injection: &Injection) -> Outcome {
        let pose = injection.grasp.actual(&reference.start()).isometry();
        Outcome { diverged: true, ..self.outcome(&pose, 0.0, Loads::UNBOUNDED, Overshoot::NONE) }
    }

    fn outcome(&self, pose: &Isometry3<f64>, max_penetration: f64, loads: Loads, overshoot: Overshoot) -> Outcome {
        let remaining = self.task.goal.isometry().translation.vector - pose.translation.vector;
        let pose = Pose::from(pose);
        let error = pose.error(&self.task.goal);
        Outcome {
            pose,
            position_error: error.position,
            orientation_error: error.orientation,
            max_penetration,
            loads,
            overshoot,
            remaining,
            unblocked: Vector3::zeros(),
            diverged: false,
        }
    }
}
