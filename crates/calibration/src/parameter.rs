//! The parameters of a fit.

use std::ops::RangeInclusive;

use plan::Problem;
use simulation::{ArmModel, Settings};

use crate::commanded;
use crate::run::Run;

/// A parameter of the robot or of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// Inertia of the velocity of a body without joints, relative to the scene's.
    TranslationalInertia,
    /// Inertia of its angular velocity, relative to the scene's.
    RotationalInertia,
    /// Rotor inertia of a joint; without an index the mean of all, in the proportions of the scene.
    RotorInertia(Option<usize>),
    /// Joint friction, in the same way.
    JointFriction(Option<usize>),
    /// Time from a sample of the controller to its torques (s).
    Delay,
    /// The robot's stiffness relative to that which was set.
    Stiffness,
    /// The robot's damping relative to that which was set.
    Damping,
    /// Time by which the motion of a robot that is commanded by position or force follows its commands: delay and servo (s).
    Lag,
    /// Frequency at which that motion is 3 dB smaller than its command (Hz).
    Bandwidth,
    /// Speed that a difference between commanded and measured wrench causes in a force mode (m/s per N, rad/s per Nm).
    Gain {
        /// 0 for translations, 1 for rotations.
        part: usize,
    },
    /// A component of the error of the measured force (N, world frame) or torque (Nm, body frame), in the run of an index.
    Bias {
        /// Index of the run.
        run: usize,
        /// 0 for forces, 1 for torques.
        part: usize,
        /// 0 to 2: along x, y or z.
        axis: usize,
    },
    /// Coulomb's coefficient of contacts.
    Friction,
    /// A component of the offset of the part in the gripper, in the run of an index.
    Offset {
        /// Index of the run.
        run: usize,
        /// 0 to 2: along x, y or z of the part.
        axis: usize,
    },
    /// A component of its rotation error.
    Rotation {
        /// Index of the run.
        run: usize,
        /// 0 to 2: about x, y or z of the part.
        axis: usize,
    },
}

/// A parameter with the settings of its search.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Which.
    pub parameter: Parameter,
    /// Its value in the scene, from which the search starts.
    pub before: f64,
    /// Its typical error: the unit of the search.
    pub scale: f64,
    /// Allowed values.
    pub range: RangeInclusive<f64>,
    /// Largest standard error with which it counts as identified.
    pub resolution: f64,
}

/// Step of finite differences, as a fraction of a quantity's scale. Contacts and dry friction respond to smaller
/// changes with jumps or not at all.
pub const DIFFERENCE: f64 = 0.02;
/// The same of motions without either: parameters with similar effects need accurate derivatives.
pub const SMOOTH_DIFFERENCE: f64 = 1e-3;

impl Quantity {
    /// From all of its fields.
    pub fn new(parameter: Parameter, before: f64, scale: f64, range: RangeInclusive<f64>, resolution: f64) -> Self {
        Self { parameter, before, scale, range, resolution }
    }

    /// A factor relative to the scene, or to what was set.
    fn factor(parameter: Parameter, scale: f64, resolution: f64) -> Self {
        Self::new(parameter, 1.0, scale, 0.05..=20.0, resolution)
    }

    /// All parameters that logs of a scene may determine; with `per_joint`, rotor inertia and friction of each joint.
    pub fn all(problem: &Problem, runs: &[Run], per_joint: bool) -> Vec<Self> {
        let mut quantities = match (&problem.scene().position_robot, problem.arm()) {
            (Some(robot), _) => commanded::quantities(robot, runs),
            (None, None) => vec![
                Self::factor(Parameter::TranslationalInertia, 0.5, 0.1),
                Self::factor(Parameter::RotationalInertia, 0.5, 0.1),
                Self::factor(Parameter::Damping, 0.3, 0.1),
            ],
            (None, Some(arm)) => Self::of_arm(&arm, per_joint),
        };
        if runs.iter().any(Run::has_contact) {
            quantities.push(Self::new(Parameter::Friction, 0.1, 0.3, 0.0..=*Settings::FRICTIONS.end(), 0.05));
        }
        for (index, run) in runs.iter().enumerate().filter(|(_, run)| run.has_contact()) {
            quantities.extend(Self::of_grasp(index, run));
        }
        quantities
    }

    fn of_arm(arm: &ArmModel, per_joint: bool) -> Vec<Self> {
        /// Typical values of arm joints (kg m^2, Nm), the order of magnitude where the scene gives none.
        const ROTOR_INERTIA: f64 = 0.1;
        const JOINT_FRICTION: f64 = 0.5;
        let joints = arm.joint_friction.len();
        let which: Vec<Option<usize>> = if per_joint { (0..joints).map(Some).collect() } else { vec![None] };
        let rotors: Vec<f64> = arm.arm.joints().iter().map(|joint| joint.rotor_inertia).collect();
        let quantity = |parameter, values: &[f64], joint: Option<usize>, typical: f64, most: f64| {
            let before = joint.map_or_else(|| mean(values), |joint| values[joint]);
            let scale = before.max(typical);
            Self::new(parameter, before, scale, 0.0..=most, 0.25 * scale)
        };
        let mut quantities = Vec::new();
        for &joint in &which {
            quantities.push(quantity(Parameter::RotorInertia(joint), &rotors, joint, ROTOR_INERTIA, 1e3));
        }
        for &joint in &which {
            let most = *ArmModel::JOINT_FRICTIONS.end();
            let parameter = Parameter::JointFriction(joint);
            quantities.push(quantity(parameter, &arm.joint_friction, joint, JOINT_FRICTION, most));
        }
        quantities.push(Self::new(Parameter::Delay, arm.delay, 5e-3, 0.0..=*ArmModel::DELAYS.end(), 1e-3));
        quantities.push(Self::factor(Parameter::Stiffness, 0.1, 0.05));
        quantities.push(Self::factor(Parameter::Damping, 0.3, 0.1));
        quantities
    }

    fn of_grasp(run: usize, Run { grasp, .. }: &Run) -> impl Iterator<Item = Self> {
        let offset = |axis: usize| {
            let parameter = Parameter::Offset { run, axis };
            Self::new(parameter, grasp.offset[axis], 2e-3, -0.1..=0.1, 1e-3)
        };
        let rotation = |axis: usize| {
            let parameter = Parameter::Rotation { run, axis };
            Self::new(parameter, grasp.rotation[axis], 0.02, -1.0..=1.0, 0.01)
        };
        (0..3).map(offset).chain((0..3).map(rotation)).collect::<Vec<_>>().into_iter()
    }
}

impl Parameter {
    /// Whether a run depends on it.
    pub fn acts_on(self, index: usize, run: &Run) -> bool {
        match self {
            Self::Friction => run.has_contact(),
            Self::Offset { run, .. } | Self::Rotation { run, .. } | Self::Bias { run, .. } => run == index,
            _ => true,
        }
    }

    /// Whether motions in free air do not depend on it.
    pub fn is_of_contact(self) -> bool {
        matches!(self, Self::Friction | Self::Offset { .. } | Self::Rotation { .. })
    }

    /// Whether it is proportional to the forces: multiplying all of these and the masses by one factor leaves the
    /// motion in free air the same.
    pub fn is_of_forces(self) -> bool {
        matches!(
            self,
            Self::TranslationalInertia
                | Self::RotationalInertia
                | Self::RotorInertia(_)
                | Self::JointFriction(_)
                | Self::Stiffness
                | Self::Damping
        )
    }

    /// Smallest standard error of a value that counts. Robots sample, interpolate and hold differently from rollouts.
    pub fn least_error(self, value: f64) -> f64 {
        match self {
            Self::Lag => 5e-5,
            Self::Bandwidth | Self::Gain { .. } => 0.01 * value,
            Self::Bias { part, .. } => [0.01, 0.001][part],
            _ => 0.0,
        }
    }

    /// Its name in messages.
    pub fn name(self) -> String {
        let of_joint = |name: &str, joint: Option<usize>| match joint {
            Some(joint) => format!("{name} of joint {}", joint + 1),
            None => name.to_owned(),
        };
        let axis = |axis: usize| ["x", "y", "z"][axis];
        match self {
            Self::TranslationalInertia => "inertia of translations".to_owned(),
            Self::RotationalInertia => "inertia of rotations".to_owned(),
            Self::RotorInertia(joint) => of_joint("rotor inertia", joint),
            Self::JointFriction(joint) => of_joint("joint friction", joint),
            Self::Delay => "delay".to_owned(),
            Self::Stiffness => "stiffness factor".to_owned(),
            Self::Damping => "damping factor".to_owned(),
            Self::Lag => "lag of the motion".to_owned(),
            Self::Bandwidth => "bandwidth".to_owned(),
            Self::Gain { part } => format!("gain of {}", ["translations", "rotations"][part]),
            Self::Bias { run, part, axis: along } => {
                format!("{} bias {} in log {}", ["force", "torque"][part], axis(along), run + 1)
            }
            Self::Friction => "contact friction".to_owned(),
            Self::Offset { run, axis: along } => format!("offset {} in log {}", axis(along), run + 1),
            Self::Rotation { run, axis: about } => format!("rotation error {} in log {}", axis(about), run + 1),
        }
    }

    /// Its unit, and the number of these per SI unit.
    pub fn unit(self) -> (&'static str, f64) {
        match self {
            Self::RotorInertia(_) => ("kg m^2", 1.0),
            Self::JointFriction(_) => ("Nm", 1.0),
            Self::Delay | Self::Lag => ("ms", 1e3),
            Self::Bandwidth => ("Hz", 1.0),
            Self::Gain { part: 0 } => ("mm/s/N", 1e3),
            Self::Gain { .. } => ("rad/s/Nm", 1.0),
            Self::Bias { part: 0, .. } => ("N", 1.0),
            Self::Bias { .. } => ("Nm", 1.0),
            Self::Offset { .. } => ("mm", 1e3),
            Self::Rotation { .. } => ("rad", 1.0),
            _ => ("", 1.0),
        }
    }

    /// Its SI unit; 1 where it has none.
    pub fn si_unit(self) -> &'static str {
        match self {
            Self::Delay | Self::Lag => "s",
            Self::Gain { part: 0 } => "m/s/N",
            Self::Offset { .. } => "m",
            other if other.unit().0.is_empty() => "1",
            other => other.unit().0,
        }
    }

    /// A run that would determine it.
    pub fn advice(self) -> &'static str {
        match self {
            Self::RotorInertia(_) | Self::TranslationalInertia | Self::RotationalInertia => {
                "make a run with faster motion and the self-test of the frames"
            }
            Self::JointFriction(_) => "make a run with the self-test of the frames, in which joints reverse",
            Self::Delay => "make a run with faster motion or higher gains",
            Self::Lag => "make a run with faster motion and the self-test of the frames",
            Self::Bandwidth => "motions are too slow to separate it from the delay: together they are the lag",
            Self::Gain { .. } => "make a run with the self-test of the frames",
            Self::Bias { .. } => {
                "make a longer run in free air; a bias below the deadband of a force mode has no effect"
            }
            Self::Stiffness => {
                "only runs in which joint friction or the known masses of links matter separate it from inertia"
            }
            Self::Damping => "make a run with faster motion",
            Self::Friction => "make a run in which the parts touch and slide (without --dry-run)",
            Self::Offset { .. } | Self::Rotation { .. } => "contacts in the logs do not depend on it",
        }
    }
}

/// Mean of some numbers; 0 for none.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}
