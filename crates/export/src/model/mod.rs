//! Models of a scene for simulators: its exact convex pieces, masses, start pose, and the arm if it has one.
//!
//! | file | what it writes |
//! |---|---|
//! | `piece` | convex pieces with their faces |
//! | `mjcf` | MuJoCo, with the controller |
//! | `mjcf_reference` | a reference that moves by itself in MuJoCo |
//! | `sdf` | SDF, with a mesh for each piece |
//! | `usd` | OpenUSD with its physics schema |

mod mjcf;
mod mjcf_reference;
mod piece;
mod sdf;
mod usd;
mod xml;

use nalgebra::{Isometry3, Matrix3, Vector3};
use plan::{PlannerError, Problem};
use robot::{Joint, RigidInertia};
use scene::Scene;
use simulation::Reference;
use store::StoredPlan;
use task::{Impedance, Inertia};

use crate::joints::course;
use crate::model::piece::Piece;
use crate::target::Target;
use crate::text::{filled, plain};
use crate::write::README;

/// Name and content of a file.
pub type Content = (String, Vec<u8>);

/// How far the coupling of a free body's inertia may be from that of a centre of mass, relative to its mass.
const ROUNDING: f64 = 1e-9;

/// A scene for simulators. Lengths in m, masses in kg.
pub struct Model {
    title: String,
    start: String,
    status: String,
    body: Vec<Piece>,
    environment: Vec<Piece>,
    /// Coulomb's coefficient of all contacts.
    friction: f64,
    impedance: Impedance,
    reference: Reference,
    carrier: Carrier,
}

/// What moves the body.
enum Carrier {
    /// Nothing: it is a free body with this inertia.
    Free(RigidInertia),
    /// An arm; the body belongs to its last link.
    Arm(ModelArm),
}

/// A serial arm.
struct ModelArm {
    base: Isometry3<f64>,
    links: Vec<Link>,
    /// The body in the frame of the last link.
    part: Isometry3<f64>,
}

/// A link of an arm, with the joint that moves it.
struct Link {
    joint: Joint,
    inertia: RigidInertia,
    /// Position of the joint at the start (rad or m).
    position: f64,
    /// Friction of the joint (Nm or N).
    friction: f64,
}

impl Link {
    /// Frame of the link in that of the link before, at a position of the joint (rad or m).
    fn frame(&self, position: f64) -> Isometry3<f64> {
        nalgebra::convert(self.joint.link_frame(position))
    }
}

impl Model {
    /// Of a plan.
    ///
    /// # Errors
    /// When no free body has the inertia of the scene, or its arm cannot follow the reference.
    pub fn new(plan: &StoredPlan, problem: &Problem) -> Result<Self, PlannerError> {
        let (scene, reference) = (problem.scene(), plan.reference()?);
        let pieces =
            |parts: &[scene::Part]| parts.iter().map(|part| Piece::new(plain(&part.name), &part.shape)).collect();
        Ok(Self {
            title: plain(&scene.title),
            start: plain(&problem.start().name),
            status: plain(&plan.result.status),
            body: pieces(&scene.body),
            environment: pieces(&scene.environment),
            friction: scene.frictions.iter().copied().fold(0.0, f64::max),
            impedance: problem.task().impedance.clone(),
            carrier: carrier(plan, scene, &reference)?,
            reference,
        })
    }

    /// The files for a target.
    ///
    /// # Errors
    /// When the target cannot express the reference.
    pub fn files(&self, target: Target) -> Result<Vec<Content>, PlannerError> {
        let mut files = match target {
            Target::Mjcf => vec![mjcf::file(self)?],
            Target::Sdf => sdf::files(self),
            Target::Usd => vec![usd::file(self)],
            _ => Vec::new(),
        };
        let values = [
            ("scene", self.title.clone()),
            ("start", self.start.clone()),
            ("status", self.status.clone()),
            ("friction", self.friction.to_string()),
            ("stiffness", self.impedance.translational_stiffness.to_string()),
            ("turning_stiffness", self.impedance.rotational_stiffness.to_string()),
            ("configuration", self.configuration()),
        ];
        files.push((README.to_owned(), filled(target.readme(), &values).into_bytes()));
        Ok(files)
    }

    /// Pose of the body at the start of the reference, in the world.
    fn start_pose(&self) -> Isometry3<f64> {
        self.reference.states()[0].pose().isometry()
    }

    /// Joint positions at the start, in words.
    fn configuration(&self) -> String {
        let Carrier::Arm(arm) = &self.carrier else {
            return "the scene has no arm, the part is a free body".to_owned();
        };
        let positions = arm.links.iter().map(|link| format!("`{}` {:.4}", plain(&link.joint.name), link.position));
        positions.collect::<Vec<_>>().join(", ")
    }
}

fn carrier(plan: &StoredPlan, scene: &Scene, reference: &Reference) -> Result<Carrier, PlannerError> {
    let refuse = |problem: String| PlannerError::file(&plan.folder, problem);
    let Some(robot) = &scene.robot else {
        let free = free_body(&scene.inertia, &scene.goal.isometry()).ok_or_else(|| {
            let advice = "name the arm's file with robot.urdf and solve again";
            refuse(format!("no free body has the apparent inertia that the scene gives: {advice}"))
        })?;
        return Ok(Carrier::Free(free));
    };
    let course = course(robot, reference.time_step(), &reference.states())
        .map_err(|error| refuse(format!("the arm cannot follow the reference: {error}")))?;
    let inertias = robot.arm.link_inertias();
    let links = robot.arm.joints().iter().zip(inertias).enumerate().map(|(index, (joint, inertia))| Link {
        joint: joint.clone(),
        inertia,
        position: course.configurations[0][index],
        friction: robot.joint_friction[index],
    });
    let part = robot.arm.tip_frame() * robot.grasp.isometry();
    Ok(Carrier::Arm(ModelArm { base: robot.base.isometry(), links: links.collect(), part }))
}

/// The free body that has an inertia when it is at a pose, if there is one: with its centre of mass `c`, momentum per angular
/// velocity is `-m R [c]x`.
fn free_body(inertia: &Inertia, at: &Isometry3<f64>) -> Option<RigidInertia> {
    let (masses, mass) = (inertia.translational(), inertia.mean_mass());
    let lever: Matrix3<f64> = at.rotation.to_rotation_matrix().inverse() * inertia.coupling() / -mass;
    let size = inertia.matrix().amax();
    if (masses - Matrix3::from_diagonal_element(mass)).amax() > ROUNDING * size
        || (lever + lever.transpose()).amax() > ROUNDING
    {
        return None;
    }
    let centre = Vector3::new(lever[(2, 1)], lever[(0, 2)], lever[(1, 0)]);
    RigidInertia::new(mass, centre, inertia.rotational() + lever * lever * mass).ok()
}

/// Numbers with spaces between them.
fn numbers(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(|value| value.to_string()).collect::<Vec<_>>().join(" ")
}

/// Position (m) and unit quaternion (w x y z) of a pose.
fn position_and_quaternion(pose: &Isometry3<f64>) -> ([f64; 3], [f64; 4]) {
    let quaternion = pose.rotation.quaternion();
    (pose.translation.vector.into(), [quaternion.w, quaternion.i, quaternion.j, quaternion.k])
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix6, UnitQuaternion};

    use super::*;

    #[test]
    fn a_free_body_has_the_inertia_that_it_was_found_for() {
        let at = Isometry3::from_parts(
            Vector3::new(0.1, 0.2, 0.3).into(),
            UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.2, 0.5)),
        );
        let (mass, centre) = (2.0, Vector3::new(0.01, -0.02, 0.03));
        let about_centre = Matrix3::new(0.02, 0.001, 0.0, 0.001, 0.03, -0.002, 0.0, -0.002, 0.025);
        let lever = centre.cross_matrix();
        let mut matrix = Matrix6::zeros();
        matrix.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(mass);
        let coupling = at.rotation.to_rotation_matrix() * lever * -mass;
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&coupling);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&coupling.transpose());
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&(about_centre - lever * lever * mass));
        let found = free_body(&Inertia::from_matrix(matrix), &at).unwrap();
        assert!((found.mass() - mass).abs() < 1e-12 && (found.centre() - centre).norm() < 1e-12);
        assert!((found.rotational() - about_centre).amax() < 1e-12);
        matrix[(0, 0)] = 3.0;
        assert!(free_body(&Inertia::from_matrix(matrix), &at).is_none());
    }
}
