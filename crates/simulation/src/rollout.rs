//! Closed-loop rollouts of plans under injected errors.

use nalgebra::{Isometry3, Vector3};
use robot::JointVector;
use task::AssemblyTask;
use workers::Workers;

use crate::arm_dynamics::ArmStepper;
use crate::arm_model::{ArmModel, ArmModelError};
use crate::body::Body;
use crate::contact::{ContactFinder, Shapes};
use crate::disturbance::Injection;
use crate::dynamics::Stepper;
use crate::loads::{LoadMeter, Loads};
use crate::pressed::Pressed;
use crate::reference::{Knot, Reference, coordinates, isometry};
use crate::settings::Settings;
use crate::success::Success;

/// A task that is ready to be simulated.
#[derive(Debug, Clone)]
pub struct Rollout {
    pub(crate) task: AssemblyTask,
    pub(crate) settings: Settings,
    shapes: Shapes,
    /// Whether all steps have the same length.
    has_even_steps: bool,
    /// What holds the body, and its joint positions at the task's start; without it, the body moves freely.
    arm: Option<(ArmModel, JointVector)>,
}

/// What moves.
enum Plant<'arm> {
    Body(Box<Stepper>),
    Arm(Box<ArmStepper<'arm>>),
}

impl Plant<'_> {
    /// Moves the body by one step; as [`Stepper::step`].
    fn step(
        &mut self,
        body: &mut Body,
        (done, count): (usize, usize),
        target: impl Fn(f64) -> Knot,
        finder: &mut ContactFinder,
        impulses: &mut [f64],
    ) -> (usize, f64) {
        match self {
            Self::Body(stepper) => stepper.step(body, (done, count), target, finder, impulses),
            Self::Arm(stepper) => stepper.step(body, (done, count), target, finder, impulses),
        }
    }
}

/// How a rollout ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Final pose of the body (position m, unit quaternion w x y z).
    pub pose: [f64; 7],
    /// Distance of the final position from the goal (m).
    pub position_error: f64,
    /// Angle between the final orientation and the goal (rad).
    pub orientation_error: f64,
    /// Deepest overlap of a pair (m) after any time step, or at the start.
    pub max_penetration: f64,
    /// Largest contact force, and largest wrench of the controller.
    pub loads: Loads,
    /// Where the contact force is largest.
    pub pressed: Pressed,
    /// Whether the state ceased to be finite, or the rollout could not be computed at all. The other fields then mean
    /// nothing.
    pub diverged: bool,
}

impl Outcome {
    /// Whether the rollout ends at the goal.
    pub fn reaches_goal(&self, success: &Success) -> bool {
        !self.diverged && success.reached(self.position_error, self.orientation_error)
    }
}

/// State of the body at one time of a rollout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedState {
    /// Time since the start (s).
    pub time: f64,
    /// Pose of the body (position m, unit quaternion w x y z).
    pub pose: [f64; 7],
    /// Velocity in the world frame (m/s).
    pub velocity: [f64; 3],
    /// Angular velocity in the body frame (rad/s).
    pub angular_velocity: [f64; 3],
}

impl TimedState {
    fn new(time: f64, body: &Body) -> Self {
        let (velocity, angular_velocity) = (body.velocity.into(), body.angular_velocity.into());
        Self { time, pose: coordinates(&body.pose), velocity, angular_velocity }
    }

    /// Pose and twist in the order of tables and transcriptions.
    pub fn state(&self) -> [f64; 13] {
        let ([x, y, z, w, i, j, k], [vx, vy, vz], [p, q, r]) = (self.pose, self.velocity, self.angular_velocity);
        [x, y, z, w, i, j, k, vx, vy, vz, p, q, r]
    }
}

impl Rollout {
    /// Prepares the shapes of a task. Callers validate the settings ([`Settings::validate_for`]).
    pub fn new(task: &AssemblyTask, settings: Settings) -> Self {
        Self { task: task.clone(), settings, shapes: Shapes::new(&task.pairs), has_even_steps: false, arm: None }
    }

    /// With an arm that holds the body. The inertia is that of the arm then, not that of the task; the time step becomes
    /// the largest divisor of the control period that is not longer than that of the settings.
    ///
    /// # Errors
    /// When a number of the settings or of the model is out of its range, or the arm does not reach goal, start and the straight way between
    /// them on one branch.
    pub fn with_arm(mut self, model: &ArmModel) -> Result<Self, ArmModelError> {
        self.settings.validate()?;
        let start = model.start(&self.task)?;
        self.settings.time_step = self.settings.divide(model.control_period).0;
        self.arm = Some((model.clone(), start));
        Ok(self)
    }

    /// With steps that are all of the same length, so that motions depend smoothly on the parameters of task and arm.
    pub fn with_even_steps(self) -> Self {
        Self { has_even_steps: true, ..self }
    }

    /// One rollout of a reference per injection, grasp error or offset (m, body frame). Outcomes are in
    /// the order of these and do not depend on the number of threads.
    pub fn simulate<G: Copy + Into<Injection> + Sync>(
        &self,
        reference: &Reference,
        injections: &[G],
        workers: &Workers,
    ) -> Vec<Outcome> {
        workers.map(injections.iter(), |&injection| self.play(reference, injection, |_, _| {}))
    }

    /// One rollout of a reference with an injection, grasp error or offset (m, body frame). The body starts at rest where it really
    /// is when the robot believes it to be at the reference's start; at its end the reference is held for the settling
    /// time. `observe` gets the state after every time step, and the normal impulse (Ns) of every pair since the last
    /// knot. Within time steps that are taken as one, states are interpolated, and impulses are those at its end.
    ///
    /// A reference that [`Settings::validate_for`] refuses, a disturbance out of its range, an inertia that is not positive
    /// definite, or a start that the arm does not reach cannot be simulated: the outcome has diverged at its start.
    pub fn play(
        &self,
        reference: &Reference,
        injection: impl Into<Injection>,
        mut observe: impl FnMut(&TimedState, &[f64]),
    ) -> Outcome {
        let injection = injection.into();
        let mut body = Body {
            pose: isometry(&injection.grasp.actual(&reference.start())),
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
        };
        let Some(mut plant) = self.plant(reference, &body.pose, &injection) else {
            return Outcome { diverged: true, ..self.outcome(&body, 0.0, &LoadMeter::new(0), Pressed::NONE) };
        };
        let Injection { grasp, disturbance } = &injection;
        let (impedance, grasp) = (disturbance.impedance(self.task.impedance.clone()), grasp.pose());
        let believed = reference;
        let reference = &reference.of_part(&injection.grasp);
        let (time_step, substeps) = self.settings.divide(reference.time_step());
        let mut finder = ContactFinder::new(&self.shapes, disturbance.edge_radius);
        let mut max_penetration = (-finder.find(&body.pose, 0.0)).max(0.0);
        let (mut loads, mut pressed) = (LoadMeter::new(self.task.pairs.len()), Pressed::NONE);
        // Of a step, and since the last knot.
        let mut step_impulses = vec![0.0; self.task.pairs.len()];
        let mut impulses = step_impulses.clone();
        for interval in 0..reference.intervals() + self.settings.settling_intervals(reference.time_step()) {
            impulses.fill(0.0);
            let mut done = 0;
            while done < substeps {
                let target = |count: f64| reference.at(interval, count / substeps as f64);
                let before = body;
                step_impulses.fill(0.0);
                let (taken, overlap) = plant.step(&mut body, (done, substeps), target, &mut finder, &mut step_impulses);
                max_penetration = max_penetration.max(overlap);
                impulses.iter_mut().zip(&step_impulses).for_each(|(sum, impulse)| *sum += impulse);
                let tracked = believed.at(interval, (done + taken) as f64 / substeps as f64);
                let wrench = impedance.wrench(&tracked.state(), &TimedState::new(0.0, &body).state(), &grasp);
                if loads.add(taken as f64 * time_step, &step_impulses, &wrench) {
                    let part = (done + taken) as f64 / substeps as f64;
                    let fraction = (interval as f64 + part) / reference.intervals() as f64;
                    pressed = Pressed::new(fraction, &reference.at(interval, part).pose, &body.pose);
                }
                for moment in 1..=taken {
                    let time = (interval * substeps + done + moment) as f64 * time_step;
                    let state = before.towards(&body, moment as f64 / taken as f64);
                    observe(&TimedState::new(time, &state), &impulses);
                }
                done += taken;
            }
            if !is_finite(&body) {
                break;
            }
        }
        self.outcome(&body, max_penetration, &loads, pressed)
    }

    /// What moves from a pose of the body at rest; `None` if it cannot be simulated.
    fn plant(&self, reference: &Reference, start: &Isometry3<f64>, injection: &Injection) -> Option<Plant<'_>> {
        let Injection { grasp, disturbance } = injection;
        self.settings.validate_for(reference).ok().and(disturbance.validate().ok())?;
        let impedance = disturbance.impedance(grasp.impedance(&self.task.impedance));
        let (time_step, substeps) = self.settings.divide(reference.time_step());
        let friction = self.settings.friction;
        let most = if self.has_even_steps { 1 } else { substeps };
        match &self.arm {
            None => {
                let inertia = disturbance.inertia(&self.task.inertia);
                let offset = Vector3::from(grasp.offset);
                let stepper = Stepper::new((time_step, most), &inertia, &impedance, offset, friction);
                stepper.map(|stepper| Plant::Body(Box::new(stepper)))
            }
            Some((model, near)) => {
                let control = (impedance, disturbance);
                let stepper =
                    ArmStepper::new(model, near, (start, grasp.believed()), control, (time_step, most), friction);
                stepper.map(|stepper| Plant::Arm(Box::new(stepper)))
            }
        }
    }

    fn outcome(&self, body: &Body, max_penetration: f64, loads: &LoadMeter, pressed: Pressed) -> Outcome {
        let pose = coordinates(&body.pose);
        let (position_error, orientation_error) = task::pose::errors(&pose, &self.task.goal);
        let diverged = !is_finite(body);
        Outcome { pose, position_error, orientation_error, max_penetration, loads: loads.largest(), pressed, diverged }
    }
}

fn is_finite(body: &Body) -> bool {
    let pose = coordinates(&body.pose);
    pose.iter().chain(&body.velocity).chain(&body.angular_velocity).all(|component| component.is_finite())
}
