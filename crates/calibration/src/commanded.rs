//! Robots that are commanded by position or force: what is fitted of them, and their entries.

use admittance::{Feedback, Gains, PositionRobot, Sensor};
use plan::records::{AdmittanceRecord, ImpedanceRecord};
use serde::Deserialize;
use task::Impedance;

use crate::parameter::{Parameter, Quantity};
use crate::run::Run;

/// Allowed bandwidths (Hz), lags (s), gains (m/s per N, rad/s per Nm) and biases (N, Nm).
const BANDWIDTHS: [f64; 2] = [0.5, 1e3];
const LAGS: [f64; 2] = [5e-4, 0.2];
const GAINS: [[f64; 2]; 2] = [[1e-7, 1.0], [1e-6, 1e3]];
const BIASES: [f64; 2] = [100.0, 10.0];
/// Typical biases (N, Nm), and largest errors of known ones.
const TYPICAL_BIASES: [f64; 2] = [1.0, 0.1];
const BIAS_ERRORS: [f64; 2] = [0.25, 0.025];

/// What the spring of a law acts on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum SpringActsOn {
    /// The pose that the law commands.
    #[serde(rename = "commanded pose")]
    Commanded,
    /// The pose that the robot measures.
    #[serde(rename = "measured pose")]
    Measured,
}

/// The law of a log.
#[derive(Debug, Clone)]
pub struct Law {
    /// As the plan has it.
    pub record: AdmittanceRecord,
    /// How it was computed.
    pub spring: SpringActsOn,
}

impl Law {
    /// The robot of a scene under this law with the gains that were set. Its sensor neither is noisy nor rounds: rollouts shall
    /// depend smoothly on the parameters.
    pub fn on(&self, robot: &PositionRobot, set: &ImpedanceRecord) -> PositionRobot {
        let set = Impedance::from(set);
        let damping = [set.translational_damping[(0, 0)], set.rotational_damping[(0, 0)]];
        let stiffness = [set.translational_stiffness, set.rotational_stiffness];
        let own = Gains { stiffness, ..robot.gains };
        let (gains, feedback) = match self.spring {
            // The force mode has its own damping, that which was set moves it with the reference.
            _ if robot.force_mode.is_some() => (own, Feedback::ForceMode { damping }),
            SpringActsOn::Commanded => (Gains { mass: self.record.mass, damping, ..own }, Feedback::Commanded),
            SpringActsOn::Measured => (Gains { mass: self.record.mass, damping, ..own }, Feedback::MeasuredPose),
        };
        let sensor = Sensor { noise: [0.0; 2], resolution: [0.0; 2], ..robot.sensor };
        PositionRobot { gains, feedback, sensor, period: self.record.period_s, ..robot.clone() }
    }
}

/// All parameters that logs of such a robot may determine, besides those of contacts.
pub fn quantities(robot: &PositionRobot, runs: &[Run]) -> Vec<Quantity> {
    let mut quantities = vec![
        Quantity::new(Parameter::Lag, robot.lag(), 5e-3, LAGS[0]..=LAGS[1], 1e-3),
        Quantity::new(
            Parameter::Bandwidth,
            robot.bandwidth,
            0.3 * robot.bandwidth,
            BANDWIDTHS[0]..=BANDWIDTHS[1],
            0.25 * robot.bandwidth,
        ),
    ];
    for (part, gain) in robot.force_mode.map(|mode| mode.gain).into_iter().flatten().enumerate() {
        let [low, high] = GAINS[part];
        quantities.push(Quantity::new(Parameter::Gain { part }, gain, 0.3 * gain, low..=high, 0.1 * gain));
    }
    for (index, run) in runs.iter().enumerate() {
        for component in 0..6 {
            let (part, axis, before) = (component / 3, component % 3, run.bias[component]);
            let parameter = Parameter::Bias { run: index, part, axis };
            let range = -BIASES[part]..=BIASES[part];
            quantities.push(Quantity::new(parameter, before, TYPICAL_BIASES[part], range, BIAS_ERRORS[part]));
        }
    }
    quantities
}

/// The robot with another gain (m/s per N, rad/s per Nm) of its force mode, for translations (0) or rotations (1). Its mass
/// follows within a period.
pub fn set_gain(robot: &mut PositionRobot, part: usize, gain: f64) {
    robot.gains.damping[part] = 1.0 / gain;
    robot.gains.mass[part] = robot.period / gain;
    if let Some(mode) = &mut robot.force_mode {
        mode.gain[part] = gain;
    }
}

/// The biases (N, Nm) that hold the part on average as far from its reference as it was in free air (m, rad).
pub fn biases(robot: &PositionRobot, sag: [f64; 6]) -> [f64; 6] {
    std::array::from_fn(|component| {
        let part = component / 3;
        let deadband = robot.force_mode.map_or(0.0, |mode| mode.deadband[part]);
        let held = robot.gains.stiffness[part] * sag[component];
        // What the deadband hides is not known: none is the best guess.
        let bias = if held.abs() > 0.2 * deadband { held + deadband.copysign(held) } else { 0.0 };
        bias.clamp(-BIASES[part], BIASES[part])
    })
}
