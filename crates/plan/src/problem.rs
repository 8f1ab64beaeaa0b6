//! A planning problem after defaults and choices: the one gate that every command and the library go through.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use scene::{RobustnessSpec, Scene, StartPose, TaskError, resolved, resolved_settings, resolved_world};
use simulation::{ArmModel, Evaluator, Reference, Rollout, Settings, Success};
use task::{AssemblyTask, HomotopySettings, Horizon, LinearSolver, Trajectory};

use crate::digest::{hash, reference_hash};
use crate::engagement::{Engagement, engagement};
use crate::error::PlannerError;
use crate::ranges::require_rotation_error;
use crate::tolerance::ChosenTolerance;

/// The version whose plans these are, bit for bit: it is raised with every change that moves a bit of a plan, so that
/// unfinished work of other plans is not resumed.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Choices for a scene; the default is the scene's own.
#[derive(Debug, Clone, Default)]
pub struct Choices {
    /// Name of the start pose; the scene's first where none is given.
    pub start: Option<String>,
    /// Offset magnitude `delta-hat` (m).
    pub offset_magnitude: Option<f64>,
    /// Largest rotation error of the part in the gripper (rad).
    pub rotation_error: Option<f64>,
    /// Homotopy file; the scene's own homotopy, else the built-in one where none is given.
    pub homotopy: Option<PathBuf>,
    /// Linear solver instead of the homotopy's.
    pub linear_solver: Option<LinearSolver>,
    /// Largest final distance from the goal of a success (m); the scene's where none is given.
    pub position_tolerance: Option<f64>,
    /// Largest final angle to the goal of a success (rad).
    pub angle_tolerance: Option<f64>,
}

/// One start and one offset magnitude of a scene, with the homotopy that solves it. All of it is valid: whoever has a
/// problem can solve it.
#[derive(Debug, Clone)]
pub struct Problem {
    scene: Scene,
    start: StartPose,
    offset_magnitude: f64,
    engagement: OnceLock<Engagement>,
    success: Success,
    chosen_tolerance: Option<ChosenTolerance>,
    edge_radius: f64,
    task: AssemblyTask,
    homotopy: HomotopySettings,
    resolved: String,
    identity: String,
    earlier: Option<Reference>,
    guess: Option<Reference>,
}

impl Problem {
    /// Reads a scene file and the files it names.
    ///
    /// # Errors
    /// The first thing that is wrong with a file or a choice, with its place.
    pub fn load(file: &Path, choices: &Choices) -> Result<Self, PlannerError> {
        Self::choose(Scene::load(file)?, file, choices)
    }

    /// From a scene that was read from `file`, which messages name.
    ///
    /// # Errors
    /// The first wrong choice.
    pub fn choose(mut scene: Scene, file: &Path, choices: &Choices) -> Result<Self, PlannerError> {
        if let Some(rotation_error) = choices.rotation_error {
            require_rotation_error(rotation_error)?;
            scene.robustness.rotation_error = rotation_error;
        }
        let homotopy = homotopy(&scene, choices.homotopy.as_deref(), choices.linear_solver)?;
        scene.position_tolerance = choices.position_tolerance.or(scene.position_tolerance);
        scene.angle_tolerance = choices.angle_tolerance.unwrap_or(scene.angle_tolerance);
        let size = scene.body_size();
        Self::new(scene, choices.start.as_deref(), choices.offset_magnitude, homotopy).map_err(|error| match error {
            PlannerError::Task(source @ TaskError::OutOfReach { magnitude, .. }) if magnitude > size => {
                let question =
                    format!("an offset of {magnitude} m is larger than the body, {size:.3} m: is it in metres?");
                PlannerError::file(file, format!("{source}; {question}"))
            }
            PlannerError::Task(source @ TaskError::OffsetMagnitude { .. }) => {
                PlannerError::Choice { name: "delta", problem: source.to_string() }
            }
            PlannerError::Task(source) => PlannerError::file(file, source.to_string()),
            other => other,
        })
    }

    /// From a scene, by default with its first start and its own offset magnitude (m). A position tolerance that the
    /// scene does not give is chosen.
    ///
    /// # Errors
    /// When the scene has no such start, the magnitude or a tolerance is not possible, or the installed Ipopt
    /// cannot run these settings.
    pub fn new(
        mut scene: Scene,
        start: Option<&str>,
        offset_magnitude: Option<f64>,
        homotopy: HomotopySettings,
    ) -> Result<Self, PlannerError> {
        let start = scene.start(start)?.clone();
        // The sum has no sign where it is zero: 0 and -0 are one problem.
        let offset_magnitude = offset_magnitude.unwrap_or(scene.offset_magnitude) + 0.0;
        let task = scene.task(Some(&start.name), Some(offset_magnitude))?;
        ocp::check_settings(&homotopy)?;
        let found = OnceLock::new();
        let chosen_tolerance = scene.position_tolerance.is_none().then(|| {
            let engagement = found.get_or_init(|| engagement(&task));
            ChosenTolerance::new(&scene, &task, engagement)
        });
        let stated = scene.position_tolerance.or(chosen_tolerance.map(|chosen| chosen.position()));
        let success = Success { position: stated.unwrap_or(f64::NAN), orientation: scene.angle_tolerance };
        success.validate()?;
        let edge_radius = *scene.robustness.edge_radius.get_or_insert_with(|| edge_radius(&task));
        // Tolerances and requirements of refinement do not change how the problem is solved, except for rotation errors
        // of scenarios.
        let rotation_error = if scene.has_rotated_scenarios() { scene.robustness.rotation_error } else { 0.0 };
        let spec = RobustnessSpec { rotation_error, ..RobustnessSpec::default() };
        let solved = Scene { position_tolerance: None, angle_tolerance: 0.0, robustness: spec, ..scene.clone() };
        let solved = resolved(&solved, &start, offset_magnitude, &homotopy);
        let identity = hash(format!("{VERSION}\n{solved}").as_bytes());
        (scene.position_tolerance, scene.angle_tolerance) = (Some(success.position), success.orientation);
        let resolved = resolved(&scene, &start, offset_magnitude, &homotopy);
        Ok(Self {
            scene,
            start,
            offset_magnitude,
            engagement: found,
            success,
            chosen_tolerance,
            edge_radius,
            task,
            homotopy,
            resolved,
            identity,
            earlier: None,
            guess: None,
        })
    }

    /// The same problem with the [moved](crate::moved) reference of an earlier plan, which is tried before anything is solved.
    pub fn with_earlier(self, reference: Reference) -> Self {
        Self { earlier: Some(reference), ..self }
    }

    /// The reference of an earlier plan, if it has one.
    pub fn earlier(&self) -> Option<&Reference> {
        self.earlier.as_ref()
    }

    /// The same problem whose homotopy starts from the motions that a reference leads to.
    pub fn with_guess(self, guess: Reference) -> Self {
        let content = format!("{}\n{}", self.identity, reference_hash(&guess));
        Self { identity: hash(content.as_bytes()), guess: Some(guess), ..self }
    }

    /// The reference from which its homotopy starts, if not from rest.
    pub fn guess(&self) -> Option<&Reference> {
        self.guess.as_ref()
    }

    /// Whether the homotopy is the built-in one, apart from the linear solver.
    pub fn has_default_homotopy(&self) -> bool {
        let default = default_homotopy(&self.scene);
        HomotopySettings { linear_solver: default.linear_solver, ..self.homotopy.clone() } == default
    }

    /// The same problem with another homotopy.
    pub fn with_homotopy(&self, homotopy: HomotopySettings) -> Self {
        let resolved = resolved(&self.scene, &self.start, self.offset_magnitude, &homotopy);
        Self { homotopy, resolved, ..self.clone() }
    }

    /// The same problem on twice as many steps of half the length.
    pub fn with_half_the_time_step(&self) -> Self {
        let mut problem = self.clone();
        for horizon in [&mut problem.scene.horizon, &mut problem.task.horizon] {
            *horizon = Horizon { steps: 2 * horizon.steps, time_step: 0.5 * horizon.time_step };
        }
        problem.resolved = resolved(&problem.scene, &problem.start, problem.offset_magnitude, &problem.homotopy);
        problem
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The start pose.
    pub fn start(&self) -> &StartPose {
        &self.start
    }

    /// Offset magnitude `delta-hat` (m).
    pub fn offset_magnitude(&self) -> f64 {
        self.offset_magnitude
    }

    /// How the environment guides the body at its goal, and the engagement depth; found when it is asked for first.
    pub fn engagement(&self) -> &Engagement {
        self.engagement.get_or_init(|| engagement(&self.task))
    }

    /// Why the position tolerance is what it is, where the scene does not state it.
    pub fn chosen_tolerance(&self) -> Option<&ChosenTolerance> {
        self.chosen_tolerance.as_ref()
    }

    /// Defaults that were chosen for the scene, each as `key = value`.
    pub fn chosen(&self) -> Vec<String> {
        let tolerance = self.chosen_tolerance.iter().map(ToString::to_string);
        self.scene.chosen.iter().cloned().chain(tolerance).collect()
    }

    /// Tolerances of success.
    pub fn success(&self) -> Success {
        self.success
    }

    /// How round edges may be (m).
    pub fn edge_radius(&self) -> f64 {
        self.edge_radius
    }

    /// How deep the exact shapes may penetrate in a plan that is done (m): half of the clearance at the goal, and at least
    /// what rounding explains.
    pub fn allowed_penetration(&self) -> f64 {
        PENETRATION.max(OVERLAP_IN_CLEARANCES * self.task.clearance(&self.task.goal))
    }

    /// The task to be planned.
    pub fn task(&self) -> &AssemblyTask {
        &self.task
    }

    /// The task with all pairs, also those that the plan leaves out.
    pub fn world(&self) -> AssemblyTask {
        AssemblyTask { pairs: self.scene.all_pairs(), ..self.task.clone() }
    }

    /// Rollouts in reality: of the arm that holds the body, if the scene has one.
    ///
    /// # Errors
    /// When the arm does not reach the start.
    pub fn rollout(&self, settings: Settings) -> Result<Rollout, PlannerError> {
        self.rollout_in(&self.world(), settings)
    }

    /// The same in a world with another time grid.
    pub fn rollout_in(&self, world: &AssemblyTask, settings: Settings) -> Result<Rollout, PlannerError> {
        let rollout = Rollout::new(world, settings);
        if let Some(robot) = &self.scene.position_robot {
            return Ok(rollout.with_position_robot(robot));
        }
        match self.arm() {
            Some(arm) => Ok(rollout.with_arm(&arm)?),
            None => Ok(rollout),
        }
    }

    /// The motion of every scenario of a world in rollouts of a reference; distances are smoothed by `tau`.
    pub fn motions(&self, world: &AssemblyTask, reference: &Reference, tau: f64) -> Result<Trajectory, PlannerError> {
        let mut motions = Vec::with_capacity(world.frictions.len());
        for &friction in &world.frictions {
            let rollout = self.rollout_in(world, Settings { friction, ..Settings::default() })?;
            motions.push(rollout.trajectory(reference, &world.grasps, tau));
        }
        let all = motions.into_iter().reduce(|mut all, next| {
            all.scenarios.extend(next.scenarios);
            all
        });
        all.ok_or(PlannerError::Internal("a plan without a friction"))
    }

    /// Number of first intervals of a reference in which the body touches nothing in rollouts of any scenario.
    ///
    /// # Errors
    /// When the arm does not reach the start.
    pub fn intervals_in_free_air(&self, reference: &Reference) -> Result<usize, PlannerError> {
        let world = self.world();
        let mut free = reference.intervals();
        for &friction in &world.frictions {
            let rollout = self.rollout_in(&world, Settings { friction, ..Settings::default() })?;
            free = free.min(rollout.intervals_in_free_air(reference, &world.grasps));
        }
        Ok(free)
    }

    /// Evaluates references in reality, at some friction coefficients.
    ///
    /// # Errors
    /// When the arm does not reach the start.
    pub fn evaluator(&self, frictions: &[f64]) -> Result<Evaluator, PlannerError> {
        let evaluator = Evaluator::new(&self.world(), frictions, self.success);
        if let Some(robot) = &self.scene.position_robot {
            return Ok(evaluator.with_position_robot(robot));
        }
        match self.arm() {
            Some(arm) => Ok(evaluator.with_arm(&arm)?),
            None => Ok(evaluator),
        }
    }

    /// The arm that holds the body, if the scene has one and commands its torques.
    pub fn arm(&self) -> Option<ArmModel> {
        let robot = self.scene.robot.as_ref().filter(|_| self.scene.position_robot.is_none())?;
        let joints = robot.arm.joints().len();
        Some(ArmModel {
            arm: robot.arm.clone(),
            configuration: robot.configuration.iter().take(joints).copied().collect(),
            joint_friction: robot.joint_friction.clone(),
            control_period: robot.control_period,
            delay: 0.0,
        })
    }

    /// How it is solved.
    pub fn homotopy(&self) -> &HomotopySettings {
        &self.homotopy
    }

    /// `resolved.toml`: everything that the plan depends on, shapes included.
    pub fn resolved(&self) -> &str {
        &self.resolved
    }

    /// The identity of the problem: a hash (hexadecimal) of its `resolved.toml` and of the program's version. Comments,
    /// file names, tolerances and requirements of refinement do not change it, a mesh's content does.
    pub fn identity(&self) -> &str {
        &self.identity
    }

    /// Hash (hexadecimal) of the world: shapes, start and goal.
    pub fn shapes_hash(&self) -> String {
        hash(resolved_world(&self.scene, &self.start).as_bytes())
    }

    /// Hash (hexadecimal) of everything else: inertia, impedance, friction, grasp errors, horizon, cost, limits, homotopy,
    /// what the joints and the controller of an arm do.
    pub fn settings_hash(&self) -> String {
        hash(resolved_settings(&self.scene, self.offset_magnitude, &self.homotopy).as_bytes())
    }
}

/// Largest smoothing gap bound of the first homotopy step, in sizes of the body: beyond that, everything penetrates and
/// the step is useless.
const FIRST_REACH: f64 = 1.2;

/// The built-in homotopy; for small parts and for many facets with less smoothing.
fn default_homotopy(scene: &Scene) -> HomotopySettings {
    let settings = scene::default_homotopy();
    let rows = |&(part, other): &(usize, usize)| {
        scene.body[part].shape.normals().len() + scene.environment[other].shape.normals().len()
    };
    let most = scene.pairs.iter().map(rows).max().unwrap_or(1);
    let tau = settings.tau.min(FIRST_REACH * scene.body_size() / most as f64);
    HomotopySettings { tau, ..settings }
}

/// Largest radius of edges that is chosen (m), also in clearances at the goal.
const EDGE_RADIUS: f64 = 1e-4;
const EDGE_RADIUS_IN_CLEARANCES: f64 = 0.5;

/// The radius of edges that is chosen for a task: a plan must not depend on edges that just catch.
fn edge_radius(task: &AssemblyTask) -> f64 {
    let chosen = EDGE_RADIUS.min(EDGE_RADIUS_IN_CLEARANCES * task.clearance(&task.goal).max(0.0));
    (1e6 * chosen).round() / 1e6
}

/// Penetration of exact shapes (m) that a plan may have: at least, and in clearances at the goal.
const PENETRATION: f64 = 5e-5;
const OVERLAP_IN_CLEARANCES: f64 = 0.5;

/// The homotopy of a file, else of the scene, else the built-in one.
///
/// # Errors
/// What is wrong with the file.
pub fn homotopy(
    scene: &Scene,
    file: Option<&Path>,
    linear_solver: Option<LinearSolver>,
) -> Result<HomotopySettings, PlannerError> {
    let mut homotopy = match file {
        Some(file) => scene::load_homotopy(file)?,
        None => scene.homotopy.clone().unwrap_or_else(|| default_homotopy(scene)),
    };
    homotopy.linear_solver = linear_solver.unwrap_or(homotopy.linear_solver);
    Ok(homotopy)
}
