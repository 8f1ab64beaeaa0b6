//! A model for MuJoCo, which plays the plan as it is.

use std::fmt::Write;

use nalgebra::{Isometry3, Matrix3};
use plan::PlannerError;
use robot::{JointKind, RigidInertia};

use crate::model::mjcf_reference::{MovingReference, POSE, POSITION};
use crate::model::piece::Piece;
use crate::model::xml::{comment, escaped};
use crate::model::{Carrier, Content, Model, ModelArm, numbers, position_and_quaternion};

/// Time step (s).
const TIME_STEP: f64 = 5e-4;
/// Stiffness of contacts: those of MuJoCo's defaults let a peg sink in deeper than its clearance.
const CONTACT: &str = "solref=\"0.004 1\" solimp=\"0.95 0.99 0.0001 0.5 2\"";
/// Dry friction of joints that holds: with MuJoCo's defaults a joint creeps.
const JOINT_FRICTION: &str = "solreffriction=\"0.001 1\" solimpfriction=\"0.9999 0.9999 0.001 0.5 2\"";
/// Site at the body's frame.
const PART: &str = "part";

/// The file.
///
/// # Errors
/// When the reference rotates too far.
pub fn file(model: &Model) -> Result<Content, PlannerError> {
    let shown = geoms(&model.body, "body", "shown");
    let reference = MovingReference::new(&model.reference, &shown)?;
    let held = geoms(&model.body, "body", "body");
    let carried = match &model.carrier {
        Carrier::Free(inertia) => free_body(&model.start_pose(), inertia, &held),
        Carrier::Arm(arm) => links(arm, &held),
    };
    let contact = match model.friction > 0.0 {
        true => format!("condim=\"3\" friction=\"{} 0.005 0.0001\" {CONTACT}", model.friction),
        false => format!("condim=\"1\" {CONTACT}"),
    };
    let text = format!(
        "<mujoco model=\"{title}\">\n  {remark}\n  <compiler angle=\"radian\"/>\n  \
         <option timestep=\"{TIME_STEP}\" gravity=\"0 0 0\" integrator=\"implicitfast\" cone=\"elliptic\">\n    \
         <flag autoreset=\"disable\" multiccd=\"disable\"/>\n  </option>\n  <default>\n    \
         <geom type=\"mesh\" {contact}/>\n    \
         <default class=\"body\"><geom contype=\"1\" conaffinity=\"2\" rgba=\"0.85 0.5 0.2 1\"/></default>\n    \
         <default class=\"environment\"><geom contype=\"2\" conaffinity=\"1\" rgba=\"0.6 0.65 0.7 0.5\"/></default>\n    \
         <default class=\"shown\"><geom contype=\"0\" conaffinity=\"0\" group=\"1\" rgba=\"0.2 0.6 1 0.25\"/></default>\n  \
         </default>\n  <asset>\n{meshes}  </asset>\n  <worldbody>\n{environment}{carried}{bodies}  </worldbody>\n  \
         <tendon>\n{tendons}  </tendon>\n  <actuator>\n{control}{actuators}  </actuator>\n</mujoco>\n",
        title = escaped(&model.title),
        remark = comment(&format!(
            "Plan of {}, start {}: {}. The blue part is the reference. The part follows it as the impedance controller of the plan \
             does; move the site `{PART}` to give it an error in the gripper.",
            model.title, model.start, model.status
        )),
        meshes = meshes("body", &model.body) + &meshes("environment", &model.environment),
        environment = geoms(&model.environment, "environment", "environment"),
        bodies = reference.bodies,
        tendons = reference.tendons,
        control = control(model),
        actuators = reference.actuators,
    );
    Ok(("plan.xml".to_owned(), text.into_bytes()))
}

fn meshes(parent: &str, pieces: &[Piece]) -> String {
    let mesh = |piece: &Piece| {
        let vertices = numbers(piece.vertices.iter().flatten().copied());
        format!("    <mesh name=\"{parent}/{}\" inertia=\"convex\" vertex=\"{vertices}\"/>\n", escaped(&piece.name))
    };
    pieces.iter().map(mesh).collect()
}

/// Geoms of the pieces of a parent, in a class. Those in the class of their parent touch, and have names.
fn geoms(pieces: &[Piece], parent: &str, class: &str) -> String {
    let geom = |piece: &Piece| {
        let name = escaped(&piece.name);
        let named = if class == parent { format!("name=\"{parent}/{name}\" ") } else { String::new() };
        format!("      <geom {named}mesh=\"{parent}/{name}\" class=\"{class}\"/>\n")
    };
    pieces.iter().map(geom).collect()
}

fn free_body(start: &Isometry3<f64>, inertia: &RigidInertia, geoms: &str) -> String {
    format!(
        "    <body name=\"body\" {}>\n      <freejoint name=\"body\"/>\n      {}\n      <site name=\"{PART}\"/>\n{geoms}    </body>\n",
        placed(start),
        inertial(inertia)
    )
}

/// The links of an arm at the start, one in the other, with the body in the last one.
fn links(arm: &ModelArm, geoms: &str) -> String {
    let mut text = format!("    <body name=\"arm\" {}>\n", placed(&arm.base));
    for link in &arm.links {
        let (name, joint) = (escaped(&link.joint.name), &link.joint);
        let kind = if joint.kind == JointKind::Prismatic { "slide" } else { "hinge" };
        let limits = match joint.lower.is_finite() && joint.upper.is_finite() {
            true => format!(" limited=\"true\" range=\"{} {}\"", joint.lower, joint.upper),
            false => String::new(),
        };
        let effort = match joint.effort.is_finite() && joint.effort > 0.0 {
            true => format!(" actuatorfrclimited=\"true\" actuatorfrcrange=\"-{0} {0}\"", joint.effort),
            false => String::new(),
        };
        let _ = writeln!(
            text,
            "    <body name=\"arm/{name}\" {}>\n      {}\n      <joint name=\"arm/{name}\" type=\"{kind}\" axis=\"{}\" ref=\"{}\" \
             armature=\"{}\" frictionloss=\"{}\" {JOINT_FRICTION}{limits}{effort}/>",
            placed(&link.frame(link.position)),
            inertial(&link.inertia),
            numbers(joint.axis().iter().copied()),
            link.position,
            joint.rotor_inertia,
            link.friction,
        );
    }
    let _ = writeln!(
        text,
        "    <body name=\"body\" {}>\n      <site name=\"{PART}\"/>\n{geoms}    </body>",
        placed(&arm.part)
    );
    text + &"    </body>\n".repeat(arm.links.len() + 1)
}

/// The impedance controller: forces between the sites of part and reference. Damping acts along its principal axes.
fn control(model: &Model) -> String {
    let impedance = &model.impedance;
    let blocks = [
        ("force", POSITION, impedance.translational_stiffness, &impedance.translational_damping),
        ("torque", POSE, impedance.rotational_stiffness, &impedance.rotational_damping),
    ];
    let mut text = String::new();
    for (index, (name, reference, stiffness, damping)) in blocks.into_iter().enumerate() {
        let principal = principal_axes(damping);
        for (axis, (direction, damping)) in principal.iter().enumerate() {
            let zeros = "0 0 0";
            let direction = numbers(direction.iter().copied());
            let gear = if index == 0 { format!("{direction} {zeros}") } else { format!("{zeros} {direction}") };
            let _ = writeln!(
                text,
                "    <general name=\"{name}{axis}\" site=\"{PART}\" refsite=\"{reference}\" gear=\"{gear}\" gainprm=\"0\" \
                 biastype=\"affine\" biasprm=\"0 {} {}\" group=\"3\"/>",
                -stiffness, -damping
            );
        }
    }
    text
}

/// Orthonormal axes of a symmetric matrix with its values along them; those of the frame where these are axes.
fn principal_axes(matrix: &Matrix3<f64>) -> [([f64; 3], f64); 3] {
    let is_diagonal = *matrix == Matrix3::from_diagonal(&matrix.diagonal());
    let eigen = matrix.symmetric_eigen();
    std::array::from_fn(|axis| match is_diagonal {
        true => (Matrix3::identity().column(axis).into_owned().into(), matrix[(axis, axis)]),
        false => (eigen.eigenvectors.column(axis).into_owned().into(), eigen.eigenvalues[axis]),
    })
}

fn placed(pose: &Isometry3<f64>) -> String {
    let (position, quaternion) = position_and_quaternion(pose);
    format!("pos=\"{}\" quat=\"{}\"", numbers(position), numbers(quaternion))
}

fn inertial(inertia: &RigidInertia) -> String {
    let moments = inertia.rotational();
    let [xx, yy, zz] = [0, 1, 2].map(|axis| moments[(axis, axis)]);
    let [xy, xz, yz] = [(0, 1), (0, 2), (1, 2)].map(|entry| moments[entry]);
    let full = numbers([xx, yy, zz, xy, xz, yz]);
    let centre = numbers(inertia.centre().iter().copied());
    format!("<inertial pos=\"{centre}\" mass=\"{}\" fullinertia=\"{full}\"/>", inertia.mass())
}
