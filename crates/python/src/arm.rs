//! The arm of a scene: kinematics and inertia at many joint positions, and its joints along motions.

use ::scene::Robot;
use nalgebra::{DMatrix, Matrix6};
use planner::{ArmCourse, PlannerError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use robot::{JointMatrix, JointVector};
use serde_json::json;
use task::{GraspError, Pose, State, Wrench};

use crate::arrays::{bytes, rows};
use crate::background;
use crate::errors::exception;

/// An arm that holds the body.
#[pyclass(frozen, module = "assembly_plan._planner")]
pub struct Arm(Box<Robot>);

/// An arm of n joints at K joint positions.
#[derive(IntoPyObject)]
pub struct Kinematics<'py> {
    /// Shape (K, 7).
    poses: Bound<'py, PyBytes>,
    /// Shape (K, 6, n).
    jacobians: Bound<'py, PyBytes>,
    /// Shape (K, n, n).
    mass_matrices: Bound<'py, PyBytes>,
    /// Shape (K, 6, 6); not numbers where the arm is singular.
    apparent_inertias: Bound<'py, PyBytes>,
}

/// The joints of n along a motion of N steps.
#[derive(IntoPyObject)]
pub struct Course<'py> {
    /// Shape (N + 1, n).
    positions: Bound<'py, PyBytes>,
    /// Shape (N + 1, n).
    torques: Bound<'py, PyBytes>,
}

impl Arm {
    pub fn new(robot: Robot) -> Self {
        Self(Box::new(robot))
    }

    fn joints(&self) -> usize {
        self.0.arm.joints().len()
    }

    /// Joint positions, one list per row.
    fn configurations(&self, bytes: &[u8]) -> Vec<JointVector> {
        let numbers: Vec<[f64; 1]> = rows(bytes);
        let vector = |row: &[[f64; 1]]| JointVector::from_fn(|joint, _| row.get(joint).map_or(0.0, |value| value[0]));
        numbers.chunks_exact(self.joints()).map(vector).collect()
    }

    fn numbers<'a>(&self, vectors: impl IntoIterator<Item = &'a JointVector>) -> Vec<f64> {
        vectors.into_iter().flat_map(|vector| vector.iter().take(self.joints()).copied()).collect()
    }
}

#[pymethods]
impl Arm {
    /// Joints and joint positions at the goal, as JSON; null for no limit.
    fn content(&self) -> String {
        let limit = |value: f64| value.is_finite().then_some(value);
        let joints = self.0.arm.joints().iter().map(|joint| {
            json!({
                "name": joint.name, "unit": joint.kind.unit(), "lower": limit(joint.lower), "upper": limit(joint.upper),
                "velocity": limit(joint.velocity), "effort": limit(joint.effort),
            })
        });
        let configuration = self.numbers([&self.0.configuration]);
        json!({ "joints": joints.collect::<Vec<_>>(), "configuration": configuration }).to_string()
    }

    /// Poses of the body, Jacobians and inertias at joint positions.
    fn kinematics<'py>(&self, py: Python<'py>, configurations: &[u8]) -> PyResult<Kinematics<'py>> {
        let (joints, mut poses, mut jacobians) = (self.joints(), Vec::new(), Vec::new());
        let (mut masses, mut inertias) = (Vec::new(), Vec::new());
        for configuration in self.configurations(configurations) {
            let configured = self.0.arm.at(&configuration);
            poses.extend(Pose::from(&configured.pose()).0);
            // Matrices are stored by columns, arrays by rows.
            jacobians.extend(configured.jacobian().columns(0, joints).transpose().iter());
            let mass: JointMatrix = configured.mass_matrix();
            masses.extend(DMatrix::from(mass.view((0, 0), (joints, joints))).iter());
            inertias.extend(configured.apparent_inertia().unwrap_or(Matrix6::repeat(f64::NAN)).iter());
        }
        Ok(Kinematics {
            poses: bytes(py, &poses)?,
            jacobians: bytes(py, &jacobians)?,
            mass_matrices: bytes(py, &masses)?,
            apparent_inertias: bytes(py, &inertias)?,
        })
    }

    /// Joint positions at which the body has a pose, on the branch of some others.
    fn inverse<'py>(&self, py: Python<'py>, pose: [f64; 7], near: &[u8]) -> PyResult<Bound<'py, PyBytes>> {
        let solve = || {
            let pose = Pose::given(pose).map_err(|rule| PlannerError::value("pose", format!("{pose:?}"), rule))?;
            let near = self.configurations(near).first().copied().unwrap_or(self.0.configuration);
            let found = self.0.arm.inverse_kinematics(&pose.isometry(), &near);
            found.map_err(|error| PlannerError::Choice { name: "pose", problem: error.to_string() })
        };
        bytes(py, &self.numbers([&solve().map_err(|error| exception(&error))?]))
    }

    /// The joints while the body moves through states under wrenches, held with a grasp error.
    fn course<'py>(
        &self,
        py: Python<'py>,
        time_step: f64,
        grasp: [[f64; 3]; 2],
        states: &[u8],
        wrenches: &[u8],
    ) -> PyResult<Course<'py>> {
        let states: Vec<State> = rows(states).into_iter().map(State).collect();
        let wrenches: Vec<Wrench> = rows(wrenches).into_iter().map(Wrench).collect();
        let (robot, [offset, rotation]) = ((*self.0).clone(), grasp);
        let course = background::run(py, None, move |_| {
            ArmCourse::new(&robot, time_step, &GraspError { offset, rotation }, &states, &wrenches)
                .map_err(|error| PlannerError::Choice { name: "motion", problem: error.to_string() })
        })?;
        let ArmCourse { configurations, torques } = course;
        Ok(Course {
            positions: bytes(py, &self.numbers(&configurations))?,
            torques: bytes(py, &self.numbers(&torques))?,
        })
    }
}
