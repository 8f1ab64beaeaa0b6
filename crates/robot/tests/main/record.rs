//! An arm and what MuJoCo computes for it, as `scripts/lab record arm` writes it.

use std::path::Path;

use nalgebra::{Isometry3, Matrix3, Quaternion, UnitQuaternion, Vector3};
use robot::{Arm, Jacobian, JointMatrix, JointVector, RigidInertia};
use serde_json::Value;

pub struct Record {
    pub arm: Arm,
    pub joints: Vec<String>,
    /// Gravity (m/s^2).
    pub field: Vector3<f64>,
    pub states: Vec<State>,
}

/// What MuJoCo computes at one state.
pub struct State {
    pub position: JointVector,
    pub velocity: JointVector,
    pub part: Isometry3<f64>,
    pub jacobian: Jacobian,
    pub velocity_product: [f64; 6],
    pub mass_matrix: JointMatrix,
    pub bias: JointVector,
    pub gravity: JointVector,
}

impl Record {
    /// Of the arm in a URDF file.
    pub fn read(urdf: &Path, file: &Path) -> Self {
        let content: Value = serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap();
        let payload = &content["payload"];
        let [xx, yy, zz, xy, xz, yz] = array(&payload["inertia"]);
        let inertia = RigidInertia::new(
            payload["mass"].as_f64().unwrap(),
            Vector3::from(array(&payload["centre"])),
            Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
        );
        let frame = |name: &str| pose(&array(&content[name]["position"]), &array(&content[name]["orientation"]));
        let arm = Arm::read(urdf, content["tip"].as_str().unwrap())
            .unwrap()
            .with_base(&frame("base"))
            .with_grasp(&frame("grasp"))
            .with_payload(inertia.unwrap())
            .with_rotor_inertia(&numbers(&content["rotor_inertia"]))
            .unwrap();
        let joints = content["joints"].as_array().unwrap();
        Self {
            arm,
            joints: joints.iter().map(|name| name.as_str().unwrap().to_owned()).collect(),
            field: Vector3::from(array(&content["field"])),
            states: content["states"].as_array().unwrap().iter().map(State::read).collect(),
        }
    }

    /// Largest differences between the arm and MuJoCo, relative to the largest entry of each quantity or to one.
    pub fn differences(&self) -> Vec<(&'static str, f64)> {
        let mut differences: Vec<(&'static str, f64)> = Vec::new();
        for state in &self.states {
            for (name, difference) in state.differences(&self.arm, &self.field) {
                match differences.iter_mut().find(|(known, _)| *known == name) {
                    Some((_, largest)) => *largest = largest.max(difference),
                    None => differences.push((name, difference)),
                }
            }
        }
        differences
    }
}

impl State {
    fn read(content: &Value) -> Self {
        let [x, y, z, quaternion @ ..]: [f64; 7] = array(&content["part"]);
        let rows = |name: &str| -> Vec<Vec<f64>> { content[name].as_array().unwrap().iter().map(numbers).collect() };
        let (jacobian, mass_matrix) = (rows("jacobian"), rows("mass_matrix"));
        let entry = |rows: &[Vec<f64>], row: usize, column: usize| rows.get(row)?.get(column).copied();
        let joints = |name: &str| {
            let numbers = numbers(&content[name]);
            JointVector::from_fn(|joint, _| numbers.get(joint).copied().unwrap_or(0.0))
        };
        Self {
            position: joints("position"),
            velocity: joints("velocity"),
            part: pose(&[x, y, z], &quaternion),
            jacobian: Jacobian::from_fn(|row, column| entry(&jacobian, row, column).unwrap_or(0.0)),
            velocity_product: array(&content["velocity_product"]),
            mass_matrix: JointMatrix::from_fn(|row, column| {
                entry(&mass_matrix, row, column).unwrap_or(if row == column { 1.0 } else { 0.0 })
            }),
            bias: joints("bias"),
            gravity: joints("gravity"),
        }
    }

    fn differences(&self, arm: &Arm, field: &Vector3<f64>) -> Vec<(&'static str, f64)> {
        let configured = arm.at(&self.position);
        let pose = configured.pose();
        let velocity_product = configured.velocity_product(&self.velocity);
        vec![
            ("position", largest(&self.part.translation.vector, &pose.translation.vector)),
            ("orientation", self.part.rotation.angle_to(&pose.rotation)),
            ("jacobian", largest(&self.jacobian, &configured.jacobian())),
            ("velocity product", largest(&self.velocity_product.into(), &velocity_product)),
            ("mass matrix", largest(&self.mass_matrix, &configured.mass_matrix())),
            ("bias", largest(&self.bias, &configured.bias(&self.velocity))),
            ("gravity", largest(&self.gravity, &configured.gravity(field))),
        ]
    }
}

/// Largest difference of two matrices, relative to the largest entry or to one.
fn largest<const R: usize, const C: usize>(
    expected: &nalgebra::SMatrix<f64, R, C>,
    actual: &nalgebra::SMatrix<f64, R, C>,
) -> f64 {
    (expected - actual).amax() / expected.amax().max(1.0)
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn array<const N: usize>(value: &Value) -> [f64; N] {
    numbers(value).try_into().unwrap()
}

fn pose(position: &[f64; 3], [w, x, y, z]: &[f64; 4]) -> Isometry3<f64> {
    let turn = UnitQuaternion::new_normalize(Quaternion::new(*w, *x, *y, *z));
    Isometry3::from_parts(Vector3::from(*position).into(), turn)
}
