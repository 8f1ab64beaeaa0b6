//! A model in SDF, with a mesh beside it for each piece.

use std::fmt::Write;

use nalgebra::Isometry3;
use robot::{JointKind, RigidInertia};

use crate::model::piece::Piece;
use crate::model::xml::{comment, escaped};
use crate::model::{Carrier, Content, Model, ModelArm, numbers};

/// Groups of contact: body and environment touch each other, and nothing else.
const BODY: [&str; 2] = ["1", "2"];
const ENVIRONMENT: [&str; 2] = ["2", "1"];

/// The files.
pub fn files(model: &Model) -> Vec<Content> {
    let held = shapes(&model.body, "body", BODY, model.friction);
    let carried = match &model.carrier {
        Carrier::Free(inertia) => free_body(&model.start_pose(), inertia, &held),
        Carrier::Arm(arm) => links(arm, &held),
    };
    let text = format!(
        "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\" xmlns:drake=\"http://drake.mit.edu\">\n{}\n<world name=\"{}\">\n  \
         <gravity>0 0 0</gravity>\n  <model name=\"environment\">\n    <static>true</static>\n    <link name=\"environment\">\n{}    \
         </link>\n  </model>\n{carried}</world>\n</sdf>\n",
        comment(&format!("Plan of {}, start {}. The joints of an arm are at zero.", model.title, model.start)),
        escaped(&model.title),
        shapes(&model.environment, "environment", ENVIRONMENT, model.friction),
    );
    let meshes =
        [("body", &model.body), ("environment", &model.environment)].into_iter().flat_map(|(parent, pieces)| {
            let file = move |(index, piece): (usize, &Piece)| (mesh(parent, index), piece.obj().into_bytes());
            pieces.iter().enumerate().map(file)
        });
    std::iter::once(("plan.sdf".to_owned(), text.into_bytes())).chain(meshes).collect()
}

/// Name of the mesh of a piece.
fn mesh(parent: &str, index: usize) -> String {
    format!("{parent}_{index}.obj")
}

/// Collisions and visuals of pieces.
fn shapes(pieces: &[Piece], parent: &str, [own, others]: [&str; 2], friction: f64) -> String {
    let shape = |(index, piece): (usize, &Piece)| {
        let (name, file) = (escaped(&piece.name), mesh(parent, index));
        format!(
            "      <collision name=\"{name}\">\n        \
             <geometry><mesh><uri>{file}</uri><drake:declare_convex/></mesh></geometry>\n        \
             <surface>\n          <friction><ode><mu>{friction}</mu><mu2>{friction}</mu2></ode></friction>\n          \
             <contact><category_bitmask>{own}</category_bitmask><collide_bitmask>{others}</collide_bitmask></contact>\n        \
             </surface>\n        <drake:proximity_properties>\n          <drake:mu_static>{friction}</drake:mu_static>\n          \
             <drake:mu_dynamic>{friction}</drake:mu_dynamic>\n        </drake:proximity_properties>\n      </collision>\n      \
             <visual name=\"{name}\"><geometry><mesh><uri>{file}</uri></mesh></geometry></visual>\n"
        )
    };
    pieces.iter().enumerate().map(shape).collect()
}

fn free_body(start: &Isometry3<f64>, inertia: &RigidInertia, shapes: &str) -> String {
    format!(
        "  <model name=\"body\">\n    <pose rotation_format=\"quat_xyzw\">{}</pose>\n    <link name=\"body\">\n{}{shapes}    </link>\n  </model>\n",
        pose(start),
        inertial(inertia)
    )
}

/// An arm whose joints are at zero, with the body in its last link.
fn links(arm: &ModelArm, shapes: &str) -> String {
    let mut text = "  <model name=\"arm\">\n    <static>false</static>\n".to_owned();
    let mut placed = arm.base;
    let mut parent = "world".to_owned();
    let last = arm.links.len() - 1;
    for (index, link) in arm.links.iter().enumerate() {
        placed *= link.frame(0.0);
        let (joint, name) = (&link.joint, escaped(&link.joint.name));
        let kind = if joint.kind == JointKind::Prismatic { "prismatic" } else { "revolute" };
        let infinite = |value: f64, stand_in: f64| if value.is_finite() { value } else { stand_in };
        // The format knows no other word for none.
        let (lower, upper) = (infinite(joint.lower, -1e16), infinite(joint.upper, 1e16));
        let _ = write!(
            text,
            "    <link name=\"{name}_link\">\n      <pose rotation_format=\"quat_xyzw\">{}</pose>\n{}",
            pose(&placed),
            inertial(&link.inertia)
        );
        if index == last {
            let in_body = shapes.replace(
                "<geometry>",
                &format!("<pose rotation_format=\"quat_xyzw\">{}</pose><geometry>", pose(&arm.part)),
            );
            text += &in_body;
        }
        let _ = write!(
            text,
            "    </link>\n    <joint name=\"{name}\" type=\"{kind}\">\n      <parent>{parent}</parent>\n      <child>{name}_link</child>\n      \
             <axis>\n        <xyz>{}</xyz>\n        <dynamics><friction>{}</friction></dynamics>\n        \
             <limit><lower>{lower}</lower><upper>{upper}</upper>{}{}</limit>\n      </axis>\n    </joint>\n",
            numbers(joint.axis().iter().copied()),
            link.friction,
            optional("effort", joint.effort),
            optional("velocity", joint.velocity),
        );
        parent = format!("{name}_link");
    }
    text + "  </model>\n"
}

/// An element, unless its value is infinite.
fn optional(name: &str, value: f64) -> String {
    if value.is_finite() { format!("<{name}>{value}</{name}>") } else { String::new() }
}

/// Position and quaternion (x y z w).
fn pose(pose: &Isometry3<f64>) -> String {
    let quaternion = pose.rotation.quaternion();
    let position: [f64; 3] = pose.translation.vector.into();
    numbers(position.into_iter().chain([quaternion.i, quaternion.j, quaternion.k, quaternion.w]))
}

fn inertial(inertia: &RigidInertia) -> String {
    let moments = inertia.rotational();
    let entries = [("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2)];
    let entries: String =
        entries.iter().map(|(name, row, column)| format!("<{name}>{}</{name}>", moments[(*row, *column)])).collect();
    let centre = numbers(inertia.centre().iter().copied());
    format!(
        "      <inertial><pose>{centre} 0 0 0</pose><mass>{}</mass><inertia>{entries}</inertia></inertial>\n",
        inertia.mass()
    )
}
