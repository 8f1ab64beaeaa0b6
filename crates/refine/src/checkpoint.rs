//! The checkpoint of an unfinished refinement, from which another one resumes its best plan.

use std::collections::BTreeMap;

use plan::records::GraspRecord;
use plan::{IterationRecord, Keeper, PlannerError, RobustParameters, Round, SuccessRates, Unusable, seal, unseal};
use serde::{Deserialize, Serialize};
use simulation::{Disturbance, FrictionIndex, TestCase};
use task::{CostWeights, GraspError, HomotopySettings, State};

use crate::evaluation::Drawn;
use crate::origin::{Marks, Origin};

/// Name of the record.
const REFINEMENT: &str = "refinement.json";

/// The best plan so far of a refinement, with its training set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RefinementCheckpoint {
    /// [`Problem::identity`](plan::Problem::identity) of the problem.
    pub identity: String,
    /// Coulomb coefficients that it must tolerate.
    pub frictions: Vec<f64>,
    /// Largest rotation error of the grasp that it must tolerate.
    pub turn_rad: f64,
    /// Largest relative error of the inertia that it must tolerate.
    pub inertia_error: f64,
    /// Largest relative error of the stiffness that it must tolerate.
    pub stiffness_error: f64,
    /// Largest delay of the controller that it must tolerate.
    pub delay_s: f64,
    /// Largest bias of the sensor that it must tolerate (N, Nm).
    #[serde(default)]
    pub bias: [f64; 2],
    /// Largest radius of edges that it must tolerate.
    pub edge_radius_m: f64,
    /// Parameters of the search.
    pub parameters: RobustParameters,
    /// Tolerances of success: distance (m) and angle (rad).
    pub tolerance: [f64; 2],
    /// Wall time so far.
    pub elapsed_s: f64,
    /// Evaluations so far: the next ones need other seeds.
    pub evaluations: u64,
    /// Success rates of the plan without refinement.
    pub before: SuccessRates,
    /// The training set.
    pub training: Vec<TestCaseRecord>,
    /// Rounds so far, including the unfinished one.
    pub rounds: Vec<Round>,
    /// Names and hashes of the tables of its homotopy steps, where they are not those of the scene.
    pub tables: BTreeMap<String, String>,
    /// The best plan.
    pub best: BestRecord,
}

/// The best plan so far.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BestRecord {
    /// Its origin.
    pub origin: Origin,
    /// Its processing since.
    pub marks: Marks,
    /// Its planned grasp errors.
    pub scenarios: Vec<GraspRecord>,
    /// Coulomb coefficients of its scenarios.
    pub planned_frictions: Vec<f64>,
    /// Its horizon.
    pub steps: usize,
    /// Its horizon.
    pub time_step_s: f64,
    /// Weights of its reference.
    pub reference_weights: WeightsRecord,
    /// Weights of its compliant motions.
    pub compliant_weights: WeightsRecord,
    /// Its homotopy.
    pub homotopy: HomotopyRecord,
    /// Its homotopy steps.
    pub iterations: Vec<IterationRecord>,
    /// States (pose, twist) of its reference.
    pub reference: Vec<State>,
    /// Its success rates.
    pub rates: SuccessRates,
    /// Whether they reach the target, as an evaluation has shown.
    pub reached: bool,
    /// The evaluation that they are of.
    pub evaluation: Drawn,
    /// Rollouts that were not played.
    pub unplayed: usize,
    /// Test cases that it fails.
    pub failing: Vec<TestCaseRecord>,
    /// Number of its round.
    pub round: usize,
    /// Homotopy step whose reference was refined.
    pub chosen_stage: usize,
    /// Accepted perturbations of that reference.
    pub perturbations: usize,
}

/// Weights of the cost of one trajectory.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WeightsRecord {
    /// Weight of the squared velocity.
    pub translational_velocity: f64,
    /// Weight of the squared angular velocity.
    pub rotational_velocity: f64,
    /// Weight of the squared position error at the end.
    pub terminal_position: f64,
    /// Weight of the squared rotation error at the end.
    pub terminal_orientation: f64,
}

/// Settings of a homotopy that variants change.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HomotopyRecord {
    /// Number of homotopy steps, if all of them run.
    pub iterations: usize,
    /// Number of first ones with half of the time steps and merged pieces.
    pub coarse_iterations: usize,
    /// First smoothing of the distances (N m).
    pub tau_nm: f64,
    /// First relaxation of complementarity (N m).
    pub sigma_nm: f64,
    /// First barrier parameter of Ipopt.
    pub mu_init: f64,
}

/// A test case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TestCaseRecord {
    /// Index into the frictions.
    pub friction: usize,
    /// Grasp error.
    pub grasp: GraspRecord,
    /// Relative error of the inertia.
    pub inertia_error: f64,
    /// Relative error of the stiffness.
    pub stiffness_error: f64,
    /// Delay of the controller.
    pub delay_s: f64,
    /// Bias of the sensor (N, Nm).
    #[serde(default)]
    pub bias: [f64; 6],
    /// Radius of edges.
    pub edge_radius_m: f64,
}

impl From<CostWeights> for WeightsRecord {
    fn from(weights: CostWeights) -> Self {
        let CostWeights { translational_velocity, rotational_velocity, terminal_position, terminal_orientation } =
            weights;
        Self { translational_velocity, rotational_velocity, terminal_position, terminal_orientation }
    }
}

impl From<WeightsRecord> for CostWeights {
    fn from(record: WeightsRecord) -> Self {
        let WeightsRecord { translational_velocity, rotational_velocity, terminal_position, terminal_orientation } =
            record;
        Self { translational_velocity, rotational_velocity, terminal_position, terminal_orientation }
    }
}

impl From<&HomotopySettings> for HomotopyRecord {
    fn from(settings: &HomotopySettings) -> Self {
        let &HomotopySettings { iterations, coarse_iterations, tau, sigma, mu_init, .. } = settings;
        Self { iterations, coarse_iterations, tau_nm: tau, sigma_nm: sigma, mu_init }
    }
}

impl HomotopyRecord {
    /// These settings with the values of the record.
    pub fn applied_to(self, settings: HomotopySettings) -> HomotopySettings {
        let Self { iterations, coarse_iterations, tau_nm: tau, sigma_nm: sigma, mu_init } = self;
        HomotopySettings { iterations, coarse_iterations, tau, sigma, mu_init, ..settings }
    }
}

impl From<&TestCase> for TestCaseRecord {
    fn from(case: &TestCase) -> Self {
        let TestCase { friction, grasp, disturbance } = *case;
        Self {
            friction: friction.0,
            grasp: GraspRecord::from(&grasp),
            inertia_error: disturbance.inertia,
            stiffness_error: disturbance.stiffness,
            delay_s: disturbance.delay,
            bias: disturbance.bias,
            edge_radius_m: disturbance.edge_radius,
        }
    }
}

impl From<&TestCaseRecord> for TestCase {
    fn from(record: &TestCaseRecord) -> Self {
        let disturbance = Disturbance {
            inertia: record.inertia_error,
            stiffness: record.stiffness_error,
            delay: record.delay_s,
            joint_friction: 0.0,
            bias: record.bias,
            edge_radius: record.edge_radius_m,
        };
        Self { friction: FrictionIndex(record.friction), grasp: GraspError::from(&record.grasp), disturbance }
    }
}

impl RefinementCheckpoint {
    /// The stored checkpoint, if there is one; `Err` with the reason where it or a table is truncated or modified, or belongs
    /// to another problem.
    pub fn load(keeper: &dyn Keeper, identity: &str) -> Result<Option<Self>, Unusable> {
        let Some(text) = keeper.record(REFINEMENT) else { return Ok(None) };
        let checkpoint: Self = unseal(&text, Unusable::DamagedRefinement)?;
        if checkpoint.identity != identity {
            return Err(Unusable::OtherProblem);
        }
        match checkpoint.tables.iter().all(|(name, hash)| keeper.is_unchanged(name, hash)) {
            true => Ok(Some(checkpoint)),
            false => Err(Unusable::DamagedRefinementTables),
        }
    }

    /// Keeps the checkpoint.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn save(&self, keeper: &dyn Keeper) -> Result<(), PlannerError> {
        keeper.keep_record(REFINEMENT, &seal(self)?)
    }
}
