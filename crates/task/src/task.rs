//! The planning task: one body, one environment, one start, one goal, several grasp errors.

use crate::grasp_error::GraspError;
use crate::impedance::Impedance;
use crate::inertia::Inertia;
use crate::limits::Limits;
use crate::pose::Pose;

/// The moved body, its environment, and everything else that defines the optimal control problem.
#[derive(Debug, Clone)]
pub struct AssemblyTask {
    /// Apparent inertia `M` of the body under impedance control.
    pub inertia: Inertia,
    /// Pairs `Pi` of body and environment parts that may touch.
    pub pairs: Vec<ContactPair>,
    /// Coulomb's coefficients of friction of all pairs in the plan, 0 to 2, each for scenarios of its own; 0 is the
    /// frictionless contact of the paper.
    pub frictions: Vec<f64>,
    /// Start pose of the reference, with a unit quaternion.
    pub start: Pose,
    /// Goal pose of the body, with a unit quaternion.
    pub goal: Pose,
    /// The Cartesian impedance controller that tracks the reference (Eq. impedancewrench).
    pub impedance: Impedance,
    /// Grasp errors `q^(l)` (Sec. ocp:ocp).
    pub grasps: Vec<GraspError>,
    /// Time grid.
    pub horizon: Horizon,
    /// Weights of the cost (Sec. ocp:cost).
    pub cost: TrajectoryCost,
    /// Limits that the reference and all scenarios must satisfy.
    pub limits: Limits,
}

/// The conditions of one planned motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scenario {
    /// Where the body sits in the gripper.
    pub grasp: GraspError,
    /// Coulomb's coefficient of friction.
    pub friction: f64,
}

impl AssemblyTask {
    /// Every grasp error with every friction: first all with the first friction.
    pub fn scenarios(&self) -> Vec<Scenario> {
        let of = |&friction| self.grasps.iter().map(move |&grasp| Scenario { grasp, friction });
        self.frictions.iter().flat_map(of).collect()
    }

    /// Smallest exact distance of all pairs (m) at a pose, negative where parts penetrate; infinite without pairs.
    pub fn clearance(&self, pose: &Pose) -> f64 {
        self.pairs.iter().map(|pair| pair.shapes.exact_distance(pose)).fold(f64::INFINITY, f64::min)
    }

    /// Offsets of all grasp errors (m, body frame).
    pub fn offsets(&self) -> Vec<[f64; 3]> {
        self.grasps.iter().map(|grasp| grasp.offset).collect()
    }

    /// Smoothing gap bound of `tau`: largest penetration of shapes of any pair whose smoothed distance is zero
    /// (m).
    pub fn smoothing_gap(&self, tau: f64) -> f64 {
        let most = self.pairs.iter().map(|pair| pair.shapes.row_count()).max().unwrap_or(0);
        tau * most as f64
    }
}

/// One pair of parts that may touch.
#[derive(Debug, Clone)]
pub struct ContactPair {
    /// Name of the part of the moved body.
    pub body: String,
    /// Name of the part of the environment.
    pub environment: String,
    /// The two shapes, placed in the body frame and in the world frame.
    pub shapes: collision::Pair,
}

impl std::fmt::Display for ContactPair {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}/{}", self.body, self.environment)
    }
}

/// `N` steps of `time_step` seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Horizon {
    /// Number of steps `N`, at least one.
    pub steps: usize,
    /// Length of a step, `Delta t` (s).
    pub time_step: f64,
}

/// Weights of the reference and of every compliant trajectory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrajectoryCost {
    /// `beta_r`.
    pub reference: CostWeights,
    /// `beta_c`.
    pub compliant: CostWeights,
}

/// Weights `beta_1 .. beta_4` of one trajectory (Sec. ocp:cost).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CostWeights {
    /// Weight of `|nu|^2` in every step.
    pub translational_velocity: f64,
    /// Weight of `|omega|^2` in every step.
    pub rotational_velocity: f64,
    /// Weight of the squared terminal position error.
    pub terminal_position: f64,
    /// Weight of the squared terminal rotation matrix error.
    pub terminal_orientation: f64,
}
