//! Where every variable and constraint of the transcription stands (Eq. discretizedOCP).
//!
//! Stages are numbered 1 to N. A stage's variables are the reference state, then for every scenario the compliant
//! state and one force per pair. Its constraints are the step that leads to it: reference kinematics (7) and limited
//! accelerations, then for every scenario pose dynamics (7), velocity dynamics (6), gaps (P), complementarity products
//! (P), limited accelerations and limited wrenches. The initial states are data.

use task::{POSE, STATE, TWIST};

/// Number of components of the contact information `W = (Phi_tau, n~_tau)`.
pub const CONTACT: usize = 1 + TWIST;

/// Sizes of a transcription and the index of everything in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// Number of steps `N`.
    pub steps: usize,
    /// Number of scenarios `n_s`.
    pub scenarios: usize,
    /// Number of contact pairs `|Pi|`.
    pub pairs: usize,
    /// Number of axes whose acceleration is limited.
    pub accelerations: usize,
    /// Number of axes whose wrench is limited.
    pub wrenches: usize,
}

impl Layout {
    /// Number of decision variables.
    pub fn variable_count(&self) -> usize {
        self.steps * self.stage_variables()
    }

    /// Number of constraints.
    pub fn constraint_count(&self) -> usize {
        self.steps * self.stage_constraints()
    }

    /// Index of the first of 13 coordinates of the reference state of a stage.
    pub fn reference(&self, stage: usize) -> usize {
        (stage - 1) * self.stage_variables()
    }

    /// Index of the first of 13 coordinates of a scenario's compliant state.
    pub fn compliant(&self, stage: usize, scenario: usize) -> usize {
        self.reference(stage) + STATE + scenario * self.scenario_variables()
    }

    /// Index of the first of 13 coordinates of the state of trajectory 0, the reference, or 1 + scenario.
    pub fn state(&self, stage: usize, trajectory: usize) -> usize {
        match trajectory {
            0 => self.reference(stage),
            _ => self.compliant(stage, trajectory - 1),
        }
    }

    /// Index of the contact force of a pair in the step that leads to a stage.
    pub fn contact_force(&self, stage: usize, scenario: usize, pair: usize) -> usize {
        self.compliant(stage, scenario) + STATE + pair
    }

    /// First of 7 rows of the reference kinematics.
    pub fn reference_kinematics(&self, stage: usize) -> usize {
        (stage - 1) * self.stage_constraints()
    }

    /// First of 7 rows of a scenario's pose dynamics (Eq. ts1).
    pub fn pose_dynamics(&self, stage: usize, scenario: usize) -> usize {
        self.reference_kinematics(stage) + POSE + self.accelerations + scenario * self.scenario_constraints()
    }

    /// First of 6 rows of a scenario's velocity dynamics (Eq. ts).
    pub fn velocity_dynamics(&self, stage: usize, scenario: usize) -> usize {
        self.pose_dynamics(stage, scenario) + POSE
    }

    /// Row of a pair's linearised gap `a >= 0` (Eq. ts3).
    pub fn gap(&self, stage: usize, scenario: usize, pair: usize) -> usize {
        self.velocity_dynamics(stage, scenario) + TWIST + pair
    }

    /// Row of a pair's complementarity product `a lambda_n` (Eq. ts3).
    pub fn complementarity(&self, stage: usize, scenario: usize, pair: usize) -> usize {
        self.gap(stage, scenario, pair) + self.pairs
    }

    /// First row of the limited accelerations of trajectory 0, the reference, or 1 + scenario.
    pub fn acceleration(&self, stage: usize, trajectory: usize) -> usize {
        match trajectory {
            0 => self.reference_kinematics(stage) + POSE,
            _ => self.complementarity(stage, trajectory - 1, 0) + self.pairs,
        }
    }

    /// First row of a scenario's limited wrenches.
    pub fn wrench(&self, stage: usize, scenario: usize) -> usize {
        self.acceleration(stage, 1 + scenario) + self.accelerations
    }

    /// Every stage, 1 to N.
    pub fn stages(&self) -> std::ops::RangeInclusive<usize> {
        1..=self.steps
    }

    /// Every stage with every scenario, scenarios running fastest.
    pub fn stages_and_scenarios(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let scenarios = self.scenarios;
        self.stages().flat_map(move |stage| (0..scenarios).map(move |scenario| (stage, scenario)))
    }

    /// Every stage with every trajectory, the reference first.
    pub fn stages_and_trajectories(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let trajectories = self.scenarios + 1;
        self.stages().flat_map(move |stage| (0..trajectories).map(move |trajectory| (stage, trajectory)))
    }

    fn scenario_variables(&self) -> usize {
        STATE + self.pairs
    }

    fn stage_variables(&self) -> usize {
        STATE + self.scenarios * self.scenario_variables()
    }

    fn scenario_constraints(&self) -> usize {
        STATE + 2 * self.pairs + self.accelerations + self.wrenches
    }

    fn stage_constraints(&self) -> usize {
        POSE + self.accelerations + self.scenarios * self.scenario_constraints()
    }
}
