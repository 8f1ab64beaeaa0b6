//! The data of a page, as the JSON that is embedded in it. Lengths in m, angles in rad, forces in N, times in s; the
//! page itself converts them for display.

use serde::Serialize;
use store::{PlanResult, SimulationRecord, SuccessRow, Versions};
use task::Pose;
use tolerance::ToleranceRecord;

/// The data of one page.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum PageData {
    /// Of a plan.
    Plan(Box<PlanData>),
    /// Of two plans of the same parts.
    Beside(Box<BesideData>),
    /// Of a batch.
    Batch(BatchData),
    /// Of a simulation.
    Simulation(SimulationData),
    /// Of the tolerances of plans.
    Tolerance(Box<ToleranceData>),
}

/// Two plans of the same parts.
#[derive(Debug, Clone, Serialize)]
pub struct BesideData {
    /// Names by which to tell them apart.
    pub names: [String; 2],
    /// The plans.
    pub plans: [PlanData; 2],
}

/// A plan, its homotopy and its rollouts.
#[derive(Debug, Clone, Serialize)]
pub struct PlanData {
    /// `result.json`, without the hashes of files.
    pub result: PlanResult,
    /// Goal of the body: position, unit quaternion w x y z.
    pub goal: Pose,
    /// Tolerances of success: distance (m) and angle (rad).
    pub tolerance: [f64; 2],
    /// Steps of the horizon and parts, in words.
    pub made_from: Vec<[String; 2]>,
    /// Convex parts of the body, in its frame.
    pub body: Vec<PartData>,
    /// Convex parts of the environment, in the world frame.
    pub environment: Vec<PartData>,
    /// Names of all pairs, `BODY PART/ENVIRONMENT PART`.
    pub pairs: Vec<String>,
    /// The plan in the smoothed model, rollouts with hard contact, the homotopy steps, and executions. A robust plan
    /// starts with the rollouts: it has no other model.
    pub motions: Vec<MotionData>,
    /// Joints of the scene's arm; none without one.
    pub joints: Vec<JointData>,
    /// Engagement depth (m); null where nothing guides the body at its goal.
    pub engagement_depth: Option<f64>,
    /// Errors that rollouts vary besides offsets.
    pub errors: ErrorsData,
    /// Warnings, and why the plan is not done: sentences without full stops.
    pub notes: Vec<String>,
    /// The largest losses of a plan that is not robust, each in a line.
    pub weakest: Vec<String>,
    /// Success rates of the last `simulate` in this folder.
    pub simulation: Option<SimulationData>,
    /// `tolerance.json` of this folder, if it is of this plan.
    pub tolerated: Option<ToleranceRecord>,
}

/// Errors of the execution that rollouts of a plan vary besides offsets, and those that they do not.
#[derive(Debug, Clone, Serialize)]
pub struct ErrorsData {
    /// Errors that the scene requires to be tolerated, with their size.
    pub varied: Vec<String>,
    /// The names of the others.
    pub left_out: Vec<String>,
}

/// A convex part.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PartData {
    /// Its name.
    pub name: String,
    /// Coordinates of its corners, three each.
    pub vertices: Vec<f64>,
    /// Corners of each facet, counter-clockwise as seen from outside.
    pub facets: Vec<Vec<usize>>,
}

/// Origin of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "source", rename_all = "snake_case")]
pub enum Source {
    /// The plan in the smoothed model.
    Plan,
    /// A homotopy step, counted from 1, with its smoothing.
    Iteration {
        /// Its number.
        number: usize,
        /// Its smoothing (N m).
        tau: f64,
    },
    /// Rollouts with hard contact.
    Rollouts {
        /// Coulomb's coefficient.
        friction: f64,
    },
    /// An execution, beside a rollout with the same grasp error.
    Executed,
}

/// A reference and the motions of the body that tracks it.
#[derive(Debug, Clone, Serialize)]
pub struct MotionData {
    /// Its origin.
    #[serde(flatten)]
    pub source: Source,
    /// Time between two knots (s).
    pub time_step: f64,
    /// Poses of the reference, seven numbers each.
    pub reference: Vec<f64>,
    /// One per grasp error; of what a robot did, the robot and a rollout.
    pub scenarios: Vec<ScenarioData>,
    /// Joints of the arm in each scenario; none without an arm, where it does not reach, and where that is not known.
    pub courses: Vec<JointCourse>,
    /// Details of an execution, from its log.
    pub execution: Option<ExecutionData>,
}

/// Details of an execution.
#[derive(Debug, Clone, Serialize)]
pub struct ExecutionData {
    /// Name of the log's file.
    pub log: String,
    /// Friction of the rollout.
    pub friction: f64,
    /// Time at which the robot was stopped, if it was.
    pub stopped: Option<f64>,
    /// Ending, grasp error and distance from the rollout: sentences without full stops.
    pub sentences: Vec<String>,
    /// Distance between where robot and rollout believe the body, at each knot until the robot's end.
    pub distances: Vec<f64>,
}

/// How the body moves with one grasp error.
#[derive(Debug, Clone, Serialize)]
pub struct ScenarioData {
    /// Its offset in the gripper (m, body frame).
    pub offset: [f64; 3],
    /// Its rotation error in the gripper (rad, rotation vector).
    pub rotation: [f64; 3],
    /// How robot and controller differ from what they are taken for, in words.
    pub disturbances: Vec<String>,
    /// Final distance (m) from the goal and angle (rad) to it.
    pub errors: [f64; 2],
    /// Whether these are within the tolerances.
    pub success: bool,
    /// Poses, seven numbers each.
    pub poses: Vec<f64>,
    /// Wrenches of the impedance controller from the first step on, six numbers each: force (world), torque (body); empty
    /// for homotopy steps.
    pub wrenches: Vec<f64>,
    /// Smallest distance of all pairs at each knot; null where it is not known.
    pub distances: Vec<f64>,
    /// Normal force of the pair that pushes most in each step; empty where it is not known.
    pub forces: Vec<f64>,
    /// Largest contact force; null where it is not known.
    pub max_force: f64,
    /// Measurements at the robot's tool point in each step, along the axes of its base: force, torque; six numbers
    /// each. Empty without measurements.
    pub measured: Vec<f64>,
    /// Contact forces in each step: pair, force, point (m, world frame) and direction of the force on the body; eight
    /// numbers each; empty for homotopy steps.
    pub contacts: Vec<Vec<f64>>,
}

/// A joint and its limits; null where it has none.
#[derive(Debug, Clone, Serialize)]
pub struct JointData {
    /// Its name in the URDF file.
    pub name: String,
    /// `rad` or `m`.
    pub unit: &'static str,
    /// Lowest and highest position.
    pub range: [Option<f64>; 2],
    /// Largest speed.
    pub speed: Option<f64>,
    /// Largest torque (Nm, N for a slide).
    pub torque: Option<f64>,
}

/// Positions, speeds and torques of all joints: one list per joint, one number per knot.
#[derive(Debug, Clone, Serialize)]
pub struct JointCourse {
    /// Positions (rad or m).
    pub positions: Vec<Vec<f64>>,
    /// Speeds (rad/s or m/s) since the knot before.
    pub speeds: Vec<Vec<f64>>,
    /// Torques (Nm or N) of the impedance controller and against gravity.
    pub torques: Vec<Vec<f64>>,
    /// Points of the arm at each knot: its base, the origins of its joints and that of the body where it is believed;
    /// three numbers each (m, world frame).
    pub skeletons: Vec<Vec<f64>>,
}

/// All cells of a batch.
#[derive(Debug, Clone, Serialize)]
pub struct BatchData {
    /// Name of its folder.
    pub title: String,
    /// All cells.
    pub cells: Vec<CellData>,
    /// Success rates of the last `simulate` of the whole batch.
    pub simulation: Option<SimulationData>,
}

/// A cell of a batch.
#[derive(Debug, Clone, Serialize)]
pub struct CellData {
    /// Its number, from 0.
    pub index: usize,
    /// Name of its scene file, without the ending.
    pub scene: String,
    /// Name of its start.
    pub start: String,
    /// Offset magnitude (m).
    pub delta: f64,
    /// Name of its homotopy file, without the ending.
    pub homotopy: Option<String>,
    /// `done`, `failed`, `running` or `to do`.
    pub state: &'static str,
    /// Its status in words, or why it failed.
    pub status: String,
    /// Where its page is, as seen from the batch's.
    pub page: Option<String>,
    /// Largest final distance (m) and angle (rad) of all scenarios.
    pub errors: Option<[f64; 2]>,
    /// Iterations of Ipopt and wall time (s).
    pub effort: Option<(usize, f64)>,
    /// Success rate of a robust plan.
    pub rate: Option<f64>,
    /// Largest rotation error of the part in the gripper (rad).
    pub rotation_error: Option<f64>,
    /// Versions of the programs that planned it.
    pub versions: Option<Versions>,
}

/// The rates of success of a simulation.
#[derive(Debug, Clone, Serialize)]
pub struct SimulationData {
    /// Name of its folder.
    pub title: String,
    /// Settings of the simulation; unknown for tables of older versions.
    pub record: Option<SimulationRecord>,
    /// `success.csv`.
    pub groups: Vec<SuccessRow>,
}

/// Which errors plans tolerate, in a folder without a plan.
#[derive(Debug, Clone, Serialize)]
pub struct ToleranceData {
    /// `tolerance.json`.
    pub record: ToleranceRecord,
    /// Success rates of the last `simulate` in this folder.
    pub simulation: Option<SimulationData>,
}
