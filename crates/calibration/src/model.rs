//! Rollouts with other parameters, compared with runs.

use std::ops::RangeInclusive;

use admittance::PositionRobot;
use faer::Mat;
use nalgebra::{Isometry3, Matrix6};
use plan::Problem;
use simulation::{ArmModel, Disturbance, Injection, Rollout, Settings};
use task::{AssemblyTask, GraspError, Inertia};
use workers::Workers;

use crate::commanded::set_gain;
use crate::deviation::{COMPONENTS, deviation};
use crate::least_squares::Model;
use crate::parameter::{DIFFERENCE, Parameter, Quantity, SMOOTH_DIFFERENCE, mean};
use crate::run::Run;

/// Residuals of some runs: differences of the believed poses of rollouts and robot, at the same times.
#[derive(Debug, Clone)]
pub struct Comparison<'work> {
    /// The arm of the scene; without one, a body moves freely.
    pub arm: Option<ArmModel>,
    /// All runs.
    pub runs: &'work [Run],
    /// Indices of those that are compared.
    pub compared: Vec<usize>,
    /// All parameters.
    pub quantities: &'work [Quantity],
    /// Standard deviations of a component of the position (m) and of the orientation (rad).
    pub noise: [f64; 2],
    /// Standard error of the delay (s), once its valley is known.
    pub delay_error: Option<f64>,
    /// Threads that play rollouts.
    pub workers: &'work Workers,
}

/// Robot and run with parameters applied.
struct Played {
    arm: Option<ArmModel>,
    robot: Option<PositionRobot>,
    task: AssemblyTask,
    friction: f64,
    grasp: GraspError,
    disturbance: Disturbance,
}

impl<'work> Comparison<'work> {
    /// For all runs of a problem.
    pub fn new(problem: &Problem, runs: &'work [Run], quantities: &'work [Quantity], workers: &'work Workers) -> Self {
        /// Weights of deviations until their noise is estimated.
        const NOISE: [f64; 2] = [1e-3, 5e-3];
        let compared = (0..runs.len()).collect();
        Self { arm: problem.arm(), runs, compared, quantities, noise: NOISE, delay_error: None, workers }
    }

    /// Deviations in a run (m, rad), one after the other; `None` where the rollout diverges.
    pub fn deviations(&self, index: usize, values: &[f64]) -> Option<Vec<[f64; COMPONENTS]>> {
        let run = &self.runs[index];
        let Played { arm, robot, task, friction, grasp, disturbance } = self.played(index, values)?;
        let settings = Settings { friction, settling_time: 0.0, ..Settings::default() };
        let mut rollout = Rollout::new(&task, settings).with_even_steps();
        if let Some(arm) = &arm {
            rollout = rollout.with_arm(arm).ok()?.with_gains_set_for(task.goal.isometry().rotation);
        }
        if let Some(robot) = &robot {
            rollout = rollout.with_position_robot(robot).with_beginning(run.beginning);
        }
        let believed = grasp.believed();
        let mut deviations = Vec::with_capacity(run.samples.len());
        let outcome = rollout.play(&run.reference, Injection { grasp, disturbance }, |state, _| {
            /// Times of steps are sums.
            const ROUNDING: f64 = 1e-7;
            if let Some((time, measured)) = run.samples.get(deviations.len())
                && state.time >= time - ROUNDING
            {
                let pose = match state.flange {
                    Some(flange) => Isometry3::from_parts(flange.translation, flange.rotation * believed.rotation),
                    None => state.pose.isometry() * believed,
                };
                deviations.push(deviation(&pose, measured));
            }
        });
        (!outcome.diverged && deviations.len() == run.samples.len()).then_some(deviations)
    }

    fn played(&self, index: usize, values: &[f64]) -> Option<Played> {
        let run = &self.runs[index];
        let mut played = Played {
            arm: self.arm.clone(),
            robot: run.robot.clone(),
            task: run.task.clone(),
            friction: 0.0,
            grasp: GraspError::default(),
            disturbance: Disturbance::default(),
        };
        let (mut rotors, mut blocks) = (self.rotor_inertia(), [1.0; 2]);
        let impedance = &mut played.task.impedance;
        let friction = played.arm.as_mut().map(|arm| &mut arm.joint_friction);
        let mut joint_friction = friction.map(std::mem::take).unwrap_or_default();
        let (mut delay, mut lag, mut bandwidth) = (0.0, 0.0, 0.0);
        for (quantity, &value) in self.quantities.iter().zip(values) {
            match quantity.parameter {
                Parameter::TranslationalInertia => blocks[0] = value,
                Parameter::RotationalInertia => blocks[1] = value,
                Parameter::RotorInertia(joint) => set(&mut rotors, joint, value),
                Parameter::JointFriction(joint) => set(&mut joint_friction, joint, value),
                Parameter::Delay => delay = value,
                Parameter::Stiffness => {
                    impedance.translational_stiffness *= value;
                    impedance.rotational_stiffness *= value;
                }
                Parameter::Damping => {
                    impedance.translational_damping *= value;
                    impedance.rotational_damping *= value;
                }
                Parameter::Lag => lag = value,
                Parameter::Bandwidth => bandwidth = value,
                Parameter::Gain { part } => {
                    played.robot.iter_mut().for_each(|robot| set_gain(robot, part, value));
                }
                Parameter::Bias { run, part, axis } if run == index => played.disturbance.bias[3 * part + axis] = value,
                Parameter::Friction => played.friction = value,
                Parameter::Offset { run, axis } if run == index => played.grasp.offset[axis] = value,
                Parameter::Rotation { run, axis } if run == index => played.grasp.rotation[axis] = value,
                Parameter::Offset { .. } | Parameter::Rotation { .. } | Parameter::Bias { .. } => {}
            }
        }
        played.task.inertia = scaled(&played.task.inertia, blocks);
        played.robot = played.robot.map(|robot| robot.with_lag(lag, bandwidth));
        if let Some(arm) = &mut played.arm {
            arm.arm = arm.arm.clone().with_rotor_inertia(&rotors).ok()?;
            (arm.joint_friction, arm.delay) = (joint_friction, delay);
        }
        Some(played)
    }

    fn rotor_inertia(&self) -> Vec<f64> {
        let joints = self.arm.iter().flat_map(|arm| arm.arm.joints());
        joints.map(|joint| joint.rotor_inertia).collect()
    }

    /// Deviations in standard deviations, one component after the other.
    fn weighted(&self, deviations: &[[f64; COMPONENTS]]) -> impl Iterator<Item = f64> {
        let noise = self.noise;
        deviations.iter().flat_map(move |deviation| {
            std::array::from_fn::<f64, COMPONENTS, _>(|component| deviation[component] / noise[component / 3])
        })
    }
}

impl Model for Comparison<'_> {
    fn residuals(&self, values: &[f64]) -> Option<Vec<f64>> {
        let played = self.workers.map(self.compared.iter(), |&run| self.deviations(run, values));
        let mut residuals = Vec::new();
        for deviations in played {
            residuals.extend(self.weighted(&deviations?));
        }
        Some(residuals)
    }

    fn jacobian(&self, values: &[f64], residuals: &[f64], free: &[usize]) -> Mat<f64> {
        let mut pieces = Vec::new();
        for (column, &index) in free.iter().enumerate() {
            let mut row = 0;
            for &run in &self.compared {
                if self.quantities[index].parameter.acts_on(run, &self.runs[run]) {
                    pieces.push((column, index, run, row));
                }
                row += COMPONENTS * self.runs[run].samples.len();
            }
        }
        let changed = self.workers.map(pieces.iter(), |&(_, index, run, _)| {
            let quantity = &self.quantities[index];
            let most = quantity.range.end() - values[index];
            let played = &self.runs[run];
            let is_smooth = played.robot.is_some() && !played.has_contact();
            let difference = if is_smooth { SMOOTH_DIFFERENCE } else { DIFFERENCE };
            let step = difference * if most > difference * quantity.scale { 1.0 } else { -1.0 };
            let mut values = values.to_vec();
            values[index] += step * quantity.scale;
            self.deviations(run, &values).map(|deviations| (step, deviations))
        });
        let mut jacobian = Mat::zeros(residuals.len(), free.len());
        for ((column, _, _, first), changed) in pieces.iter().zip(&changed) {
            // Where the model cannot be computed, the derivative is taken as zero.
            let Some((step, deviations)) = changed else { continue };
            for (row, residual) in (*first..).zip(self.weighted(deviations)) {
                jacobian[(row, *column)] = (residual - residuals[row]) / step;
            }
        }
        jacobian
    }

    fn scale(&self, index: usize) -> f64 {
        self.quantities[index].scale
    }

    fn range(&self, index: usize) -> RangeInclusive<f64> {
        self.quantities[index].range.clone()
    }
}

/// Sets the value of a joint, or the mean of all: then in their proportions, or the same for all where there are none.
pub fn set(values: &mut [f64], joint: Option<usize>, value: f64) {
    match (joint, mean(values)) {
        (Some(joint), _) => values[joint] = value,
        (None, 0.0) => values.fill(value),
        (None, mean) => values.iter_mut().for_each(|own| *own *= value / mean),
    }
}

/// Inertia whose parts for velocities and angular velocities are multiplied by factors.
pub fn scaled(inertia: &Inertia, [translational, rotational]: [f64; 2]) -> Inertia {
    let factors: [f64; 6] = std::array::from_fn(|axis| if axis < 3 { translational.sqrt() } else { rotational.sqrt() });
    let matrix = inertia.matrix();
    Inertia::from_matrix(Matrix6::from_fn(|row, column| factors[row] * matrix[(row, column)] * factors[column]))
}
