//! A validated scene.

use admittance::PositionRobot;
use task::{
    AssemblyTask, ContactPair, Coverage, GraspError, HomotopySettings, Horizon, Impedance, Inertia, Limits, Pose,
    TrajectoryCost,
};

use crate::carried::CarriedShapes;
use crate::chosen;
use crate::facets::Fit;
use crate::keys::key;
use crate::limits::{OutOfReach, check_reach};
use crate::mesh::MeshPart;
use crate::motion_region::MotionRegion;
use crate::part::{Extent, Part};
use crate::pose::StartPose;
use crate::robot::Robot;
use crate::task_error::TaskError;
use crate::touching::Gap;
use crate::words::nearest;

/// What a robust plan must tolerate besides offsets. Errors are relative, in both directions.
#[derive(Debug, Clone, PartialEq)]
pub struct RobustnessSpec {
    /// Coulomb coefficients of contacts, at least one.
    pub frictions: Vec<f64>,
    /// Turn of the body in the gripper, about any axis (rad).
    pub rotation_error: f64,
    /// Error of the inertia.
    pub inertia_error: f64,
    /// Error of the stiffness.
    pub stiffness_error: f64,
    /// Delay beyond that of the controller (s).
    pub delay: f64,
    /// Error of every component of a measured wrench (N, Nm).
    pub bias: [f64; 2],
    /// Largest radius of edges (m); chosen from the clearance where the scene does not give it.
    pub edge_radius: Option<f64>,
}

impl Default for RobustnessSpec {
    fn default() -> Self {
        Self {
            frictions: vec![0.0, 0.1, 0.3],
            rotation_error: 0.0,
            inertia_error: 0.0,
            stiffness_error: 0.0,
            delay: 0.0,
            bias: [0.0; 2],
            edge_radius: None,
        }
    }
}

/// A validated scene.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Title, by default the file's name.
    pub title: String,
    /// Convex parts of the moved body, in its frame.
    pub body: Vec<Part>,
    /// Convex parts of the environment, in the world frame.
    pub environment: Vec<Part>,
    /// Parts of the body whose shape is a mesh.
    pub body_meshes: Vec<MeshPart>,
    /// Parts of the environment whose shape is a mesh.
    pub environment_meshes: Vec<MeshPart>,
    /// The tightest fit of a round part in a round hole when the body is at its goal, whichever of both has the hole.
    pub fit: Option<Fit>,
    /// Region that the body can reach: only pieces of environment meshes with surface in it are parts. `None` without
    /// such meshes.
    pub region: Option<MotionRegion>,
    /// How far convex parts and the shapes as they are given are apart along the straight way, if there are meshes.
    pub gaps: Vec<Gap>,
    /// Pairs that may touch, as indices into body and environment.
    pub pairs: Vec<(usize, usize)>,
    /// Pairs that are left out because no motion from start to goal comes near to them.
    pub culled_pairs: Vec<(usize, usize)>,
    /// Coulomb's coefficients of friction in plans, at least one.
    pub frictions: Vec<f64>,
    /// Start poses; the first is the default.
    pub starts: Vec<StartPose>,
    /// Goal pose.
    pub goal: Pose,
    /// Largest final distance (m) from the goal of a success, if the scene gives it.
    pub position_tolerance: Option<f64>,
    /// Largest final angle (rad) to the goal of a success.
    pub angle_tolerance: f64,
    /// Mass and inertia of the body.
    pub inertia: Inertia,
    /// The arm that moves the body, if the scene has a URDF file.
    pub robot: Option<Robot>,
    /// What the robot is like if it is commanded by position or force; the impedance is then that of its admittance law.
    pub position_robot: Option<PositionRobot>,
    /// The robot's controller.
    pub impedance: Impedance,
    /// `delta-hat` (m).
    pub offset_magnitude: f64,
    /// Which offsets are covered.
    pub coverage: Coverage,
    /// Directions of the planned offsets; zero is the nominal scenario.
    pub offset_directions: Vec<[f64; 3]>,
    /// Axes of the rotation errors of the same scenarios; zero is no rotation.
    pub rotation_axes: Vec<[f64; 3]>,
    /// What a robust plan must tolerate besides offsets.
    pub robustness: RobustnessSpec,
    /// Time grid.
    pub horizon: Horizon,
    /// Weights.
    pub cost: TrajectoryCost,
    /// Limits that every plan must satisfy.
    pub limits: Limits,
    /// The homotopy that the scene names or contains, if any.
    pub homotopy: Option<HomotopySettings>,
    /// Defaults that were chosen for the scene, each as `key = value`.
    pub chosen: Vec<String>,
    /// Remarks on what looks like a mistake, each with file, line and column.
    pub warnings: Vec<String>,
    /// Parts of the gripper in the frame of the arm's tip, as convex hulls.
    pub gripper: Vec<Part>,
    /// Shapes that move with the arm besides the body.
    pub carried: CarriedShapes,
}

impl Scene {
    /// Whether the limits let the body reach the goal from a start with every offset of a magnitude (m).
    ///
    /// # Errors
    /// The limit that is too small.
    pub(crate) fn check_reach(&self, start: &StartPose, magnitude: f64) -> Result<(), OutOfReach> {
        self.grasps_of(magnitude).iter().try_for_each(|grasp| {
            let start = StartPose { name: start.name.clone(), pose: grasp.actual(&start.pose) };
            check_reach(&self.limits, &start, &self.goal, self.horizon)
        })
    }

    /// The disc of offsets across the insertion, also where the scene covers something else.
    pub fn disc(&self) -> Coverage {
        match self.coverage {
            Coverage::Disc { .. } => self.coverage,
            Coverage::Hull | Coverage::Ball => {
                Coverage::Disc { axis: chosen::insertion_axis(&self.starts[0].pose, &self.goal) }
            }
        }
    }

    /// The planned grasp errors with offsets of a magnitude (m), one per scenario.
    ///
    /// # Errors
    /// When the magnitude is out of range.
    pub fn grasps(&self, magnitude: f64) -> Result<Vec<GraspError>, TaskError> {
        let range = key("robustness", "offset_magnitude").bounds();
        if !range.contains(magnitude) {
            return Err(TaskError::OffsetMagnitude { value: magnitude, most: range.high });
        }
        Ok(self.grasps_of(magnitude))
    }

    pub(crate) fn grasps_of(&self, magnitude: f64) -> Vec<GraspError> {
        let scaled = |direction: &[f64; 3], length: f64| direction.map(|component| length * component);
        let grasp = |(offset, rotation): (&[f64; 3], &[f64; 3])| GraspError {
            offset: scaled(offset, magnitude),
            rotation: scaled(rotation, self.robustness.rotation_error),
        };
        let grasps = self.offset_directions.iter().zip(&self.rotation_axes).map(grasp);
        match self.coverage {
            // As the scene gives them.
            Coverage::Hull => grasps.collect(),
            // Without a magnitude, all are one.
            Coverage::Disc { .. } | Coverage::Ball => GraspError::distinct(grasps),
        }
    }

    /// Whether any scenario has a rotation error.
    pub fn has_rotated_scenarios(&self) -> bool {
        self.robustness.rotation_error > 0.0 && self.rotation_axes.iter().any(|direction| *direction != [0.0; 3])
    }

    /// The start of a given name, or the first.
    ///
    /// # Errors
    /// When there is no start of this name. The error lists all names.
    pub fn start(&self, name: Option<&str>) -> Result<&StartPose, TaskError> {
        let Some(name) = name else { return Ok(&self.starts[0]) };
        self.starts.iter().find(|start| start.name == name).ok_or_else(|| {
            let known: Vec<&str> = self.starts.iter().map(|start| start.name.as_str()).collect();
            TaskError::UnknownStart {
                name: name.to_owned(),
                suggestion: nearest(name, &known).map(str::to_owned),
                known: known.into_iter().map(str::to_owned).collect(),
            }
        })
    }

    /// The planning task of a start and an offset magnitude (m), by default the first start and the scene's magnitude.
    ///
    /// # Errors
    /// When the start is unknown, the magnitude is out of range, or the limits are too tight for it.
    pub fn task(&self, start: Option<&str>, offset_magnitude: Option<f64>) -> Result<AssemblyTask, TaskError> {
        let start = self.start(start)?;
        let magnitude = offset_magnitude.unwrap_or(self.offset_magnitude);
        let grasps = self.grasps(magnitude)?;
        self.check_reach(start, magnitude)
            .map_err(|reason| TaskError::OutOfReach { magnitude, reason: Box::new(reason) })?;
        let (inertia, impedance) = self.planned_dynamics();
        Ok(AssemblyTask {
            inertia,
            pairs: self.pairs.iter().map(|&(part, other)| self.pair(part, other)).collect(),
            frictions: self.frictions.clone(),
            start: start.pose,
            goal: self.goal,
            impedance,
            grasps,
            horizon: self.horizon,
            cost: self.cost,
            limits: self.limits,
        })
    }

    /// Inertia and impedance of the planned motion: those of body and controller, or of an admittance law behind its lag.
    pub fn planned_dynamics(&self) -> (Inertia, Impedance) {
        match &self.position_robot {
            Some(robot) => robot.gains.planned(robot.contact_loop().lag()),
            None => (self.inertia.clone(), self.impedance.clone()),
        }
    }

    /// Longest edge of the box around the body, along the axes of its frame (m).
    pub fn body_size(&self) -> f64 {
        Extent::of(&self.body).size()
    }

    /// All pairs of a body part and an environment part, including those that the scene leaves out.
    pub fn all_pairs(&self) -> Vec<ContactPair> {
        let others = 0..self.environment.len();
        (0..self.body.len()).flat_map(|part| others.clone().map(move |other| self.pair(part, other))).collect()
    }

    fn pair(&self, part: usize, other: usize) -> ContactPair {
        let (body, environment) = (&self.body[part], &self.environment[other]);
        ContactPair {
            body: body.name.clone(),
            environment: environment.name.clone(),
            shapes: collision::Pair::new(body.shape.clone(), environment.shape.clone()),
        }
    }
}
