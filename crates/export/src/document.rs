//! `plan.json`: everything that a player needs besides the trajectory.

use nalgebra::SMatrix;
use plan::records::{AdmittanceRecord, ImpedanceRecord};
use plan::{ArmCourse, PlannerError, Problem};
use robot::{Joint, JointKind, JointVector};
use scene::Robot;
use serde::Serialize;
use simulation::Reference;
use store::{CoverageRecord, StoredPlan};
use task::{Limits, Pose};

use crate::expectation::{Expectation, PhaseGuards};
use crate::frames::Frames;
use crate::free::FreeAir;
use crate::joints::{Held, course, largest_torque_step, tracking_error};
use crate::smooth::SmoothReference;
use crate::text::plain;
use crate::trial::TrialRecord;

/// Version of the file; players refuse others.
const FORMAT: u32 = 2;
/// Speeds of players on the path to the start (m/s, rad/s).
const APPROACH: [f64; 2] = [0.02, 0.1];

/// Everything that a player needs besides the trajectory. Poses are position (m) and unit quaternion (w x y z).
#[derive(Debug, Clone, Serialize)]
pub struct Document {
    /// Version of this file.
    pub format: u32,
    /// Title of the scene.
    pub scene: String,
    /// Name of the start.
    pub start: String,
    /// Hash of what the plan was made from.
    pub problem: String,
    /// Hash of the plan's `result.json`.
    pub result: String,
    /// Status of the plan, in words.
    pub status: String,
    /// Whether the plan is done.
    pub done: bool,
    /// Whether it was exported although it should not be played.
    pub anyway: bool,
    /// Rollouts of the exported reference with hard contact.
    pub trial: TrialRecord,
    /// Warnings that a player prints before it moves.
    pub warnings: Vec<String>,
    /// Offset magnitude that was planned for (m).
    pub delta_m: f64,
    /// Which offsets the plan covers.
    pub coverage: CoverageRecord,
    /// Largest rotation error in the gripper that was planned for (rad).
    pub turn_rad: f64,
    /// Samples per second of `trajectory.csv`.
    pub rate_hz: f64,
    /// Frame of the trajectory: `robot base` or `world`.
    pub frame: &'static str,
    /// The robot's base in the world.
    pub base: Pose,
    /// The part in the tool, as the robot believes it.
    pub grasp: Pose,
    /// Goal of the part in the world.
    pub goal: Pose,
    /// Largest final distance of a success (m).
    pub position_tolerance_m: Option<f64>,
    /// Largest final angle of a success (rad).
    pub angle_tolerance_rad: f64,
    /// The controller of the plan, which acts at the part.
    pub impedance: ImpedanceRecord,
    /// The admittance law, if the robot is commanded by position or force.
    pub admittance: Option<AdmittanceRecord>,
    /// The same at the tool point, at the goal: rows along and about the axes of the frame.
    pub tool_stiffness: [[f64; 6]; 6],
    /// Damping at the tool point, at the goal, in the same rows.
    pub tool_damping: [[f64; 6]; 6],
    /// Largest values in the plan.
    pub expected: Expectation,
    /// Values beyond which a player stops.
    pub guards: PhaseGuards,
    /// Regions of free air.
    pub free: FreeAir,
    /// Largest step of a joint torque between two references a millisecond apart (Nm), if an arm is commanded torques.
    pub torque_step_nm_per_ms: Option<f64>,
    /// The arm, if the scene has one.
    pub arm: Option<ArmRecord>,
}

/// An arm as a chain of joints.
#[derive(Debug, Clone, Serialize)]
pub struct ArmRecord {
    /// Link of the URDF file that is the base.
    pub root: String,
    /// Link of it that is the tool.
    pub tip: String,
    /// Name of the URDF file.
    pub urdf: String,
    /// From the base to the tool.
    pub joints: Vec<JointRecord>,
    /// The tool in the frame of the last joint's link.
    pub tool: Pose,
    /// Joint positions at the start of the reference (rad or m).
    pub start_configuration: Vec<f64>,
    /// Time between two commands of the controller (s).
    pub control_period_s: f64,
}

/// A joint with the frame in which it moves its link.
#[derive(Debug, Clone, Serialize)]
pub struct JointRecord {
    /// Name.
    pub name: String,
    /// Whether the joint is prismatic.
    pub slides: bool,
    /// Its frame in that of the link before, at position zero.
    pub frame: Pose,
    /// Its axis in that frame.
    pub axis: [f64; 3],
    /// Lowest position (rad or m), if there is one.
    pub lower: Option<f64>,
    /// Highest position (rad or m), if there is one.
    pub upper: Option<f64>,
    /// Largest speed (rad/s or m/s), if there is one.
    pub speed: Option<f64>,
    /// Largest torque (Nm or N), if there is one.
    pub torque: Option<f64>,
}

/// A plan that is exported, and all that was made of it.
pub struct Exported<'plan> {
    /// The plan.
    pub plan: &'plan StoredPlan,
    /// Hash of its `result.json`.
    pub result: String,
    /// Its problem.
    pub problem: &'plan Problem,
    /// Its reference.
    pub reference: &'plan Reference,
    /// The same with continuous velocities.
    pub smooth: &'plan SmoothReference,
    /// How it does.
    pub trial: TrialRecord,
    /// Whether it is exported although it should not be played.
    pub anyway: bool,
}

impl Document {
    /// Of an exported plan, with `rate` samples per second.
    ///
    /// # Errors
    /// When a table of the plan is missing or wrong, or the arm cannot follow the reference.
    pub fn new(exported: Exported, rate: f64) -> Result<Self, PlannerError> {
        let Exported { plan, result, problem, reference, smooth, trial, anyway } = exported;
        let (scene, frames) = (problem.scene(), Frames::of(problem.scene()));
        let (impedance, states) = (&scene.impedance, reference.states());
        let robot = scene.robot.as_ref();
        let course = robot.map(|robot| {
            course(robot, reference.time_step(), &states).map_err(|error| {
                let advice = "the arm cannot follow the reference; check base, grasp and configuration of [robot]";
                PlannerError::file(&plan.folder, format!("{advice}: {error}"))
            })
        });
        let course = course.transpose()?;
        let moved = robot.zip(course.as_ref());
        // Joint friction holds an arm that is commanded torques, and no servo.
        let torques = moved.filter(|_| scene.position_robot.is_none());
        let held = torques.map_or_else(Held::default, |(robot, course)| Held::along(robot, impedance, course));
        let expected = Expectation::of(plan, &frames, held)?;
        let kept: Limits = reference.limits_kept();
        let error_at = |speed: f64, turning: f64| match &scene.position_robot {
            Some(robot) => {
                Held { distance: robot.contact_loop().lag() * speed, angle: robot.contact_loop().lag() * turning }
            }
            None => tracking_error(impedance, speed, turning),
        };
        let error_of_plan = error_at(kept.translational_velocity, kept.rotational_velocity);
        let error_of_approach = error_at(APPROACH[0], APPROACH[1]);
        let gains = frames.tool_gains(&scene.goal.isometry(), impedance);
        Ok(Self {
            format: FORMAT,
            scene: plain(&scene.title),
            start: plain(&problem.start().name),
            problem: plain(&plan.result.made_from.problem),
            result,
            status: plain(&plan.result.status),
            done: plan.result.done,
            anyway,
            warnings: warnings(plan, &trial, anyway, robot.is_some()),
            delta_m: problem.offset_magnitude(),
            coverage: CoverageRecord::from(problem),
            turn_rad: scene.robustness.rotation_error,
            rate_hz: rate,
            frame: if robot.is_some() { "robot base" } else { "world" },
            base: Pose::from(&frames.base),
            grasp: Pose::from(&frames.grasp),
            goal: scene.goal,
            position_tolerance_m: scene.position_tolerance,
            angle_tolerance_rad: scene.angle_tolerance,
            impedance: ImpedanceRecord::from(impedance),
            admittance: scene.position_robot.as_ref().map(AdmittanceRecord::from),
            tool_stiffness: rows(&gains.stiffness),
            tool_damping: rows(&gains.damping),
            expected,
            guards: expected.guards(problem.task().limits.contact_force, error_of_approach, error_of_plan),
            free: FreeAir::new(problem, &states, reference.time_step(), &frames.grasp),
            torque_step_nm_per_ms: torques.map(|(robot, course)| largest_torque_step(robot, impedance, smooth, course)),
            arm: moved.map(|(robot, course)| ArmRecord::new(robot, course)),
            trial,
        })
    }
}

/// Warnings before the plan is executed.
fn warnings(plan: &StoredPlan, trial: &TrialRecord, anyway: bool, has_arm: bool) -> Vec<String> {
    let not_done = (!plan.result.done).then(|| format!("the plan is not done: {}", plain(&plan.result.status)));
    let wanted = anyway.then(|| "the plan was exported with --anyway".to_owned());
    let no_arm = (!has_arm).then(|| {
        "the scene has no arm: poses are those of the part in the world, not of a tool in a robot's base".to_owned()
    });
    not_done.into_iter().chain(trial.low_rates()).chain(trial.excess()).chain(wanted).chain(no_arm).collect()
}

impl ArmRecord {
    fn new(robot: &Robot, course: &ArmCourse) -> Self {
        let positions = |configuration: &JointVector| configuration.as_slice()[..robot.arm.joints().len()].to_vec();
        Self {
            root: plain(robot.arm.root()),
            tip: plain(&robot.tip),
            urdf: plain(&robot.urdf.file_name().unwrap_or_default().to_string_lossy()),
            joints: robot.arm.joints().iter().map(JointRecord::new).collect(),
            tool: Pose::from(&robot.arm.tip_frame()),
            start_configuration: course.configurations.first().map_or_else(Vec::new, positions),
            control_period_s: robot.control_period,
        }
    }
}

impl JointRecord {
    fn new(joint: &Joint) -> Self {
        let finite = |value: f64| Some(value).filter(|value| value.is_finite());
        Self {
            name: joint.name.clone(),
            slides: joint.kind == JointKind::Prismatic,
            frame: Pose::from(&joint.frame()),
            axis: joint.axis().into(),
            lower: finite(joint.lower),
            upper: finite(joint.upper),
            speed: finite(joint.velocity),
            torque: finite(joint.effort),
        }
    }
}

/// Rows of a square matrix.
fn rows<const N: usize>(matrix: &SMatrix<f64, N, N>) -> [[f64; N]; N] {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[(row, column)]))
}
