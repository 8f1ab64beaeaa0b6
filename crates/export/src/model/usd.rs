//! A model in OpenUSD with its physics schema, as text.

use std::fmt::Write;

use nalgebra::{Isometry3, Matrix3, Rotation3, UnitQuaternion, Vector3};
use robot::{JointKind, RigidInertia};

use crate::model::piece::Piece;
use crate::model::{Carrier, Content, Model, ModelArm, position_and_quaternion};

/// The file.
pub fn file(model: &Model) -> Content {
    let held = meshes(&model.body, "body", &Isometry3::identity());
    let (carried, of_body) = match &model.carrier {
        Carrier::Free(inertia) => (rigid("body", &model.start_pose(), inertia, &held), "/World/body".to_owned()),
        Carrier::Arm(arm) => (links(arm, model), format!("/World/arm/link_{}", arm.links.len() - 1)),
    };
    let friction = model.friction;
    let text = format!(
        "#usda 1.0\n(\n    defaultPrim = \"World\"\n    metersPerUnit = 1\n    kilogramsPerUnit = 1\n    upAxis = \"Z\"\n    doc = {}\n)\n\n\
         def Xform \"World\"\n{{\n\
         def PhysicsScene \"physics\"\n{{\n    vector3f physics:gravityDirection = (0, 0, -1)\n    float physics:gravityMagnitude = 0\n}}\n\
         def Material \"contact\" (\n    prepend apiSchemas = [\"PhysicsMaterialAPI\"]\n)\n{{\n    \
         float physics:staticFriction = {friction}\n    float physics:dynamicFriction = {friction}\n    float physics:restitution = 0\n}}\n\
         def Xform \"environment\"\n{{\n{}}}\n{carried}{}{}}}\n",
        quoted(&format!("Plan of {}, start {}.", model.title, model.start)),
        meshes(&model.environment, "environment", &Isometry3::identity()),
        group("environment_group", "/World/environment"),
        group("body_group", &of_body),
    );
    ("plan.usda".to_owned(), text.into_bytes())
}

/// A group of colliders that do not touch each other.
fn group(name: &str, path: &str) -> String {
    format!(
        "def PhysicsCollisionGroup \"{name}\" (\n    prepend apiSchemas = [\"CollectionAPI:colliders\"]\n)\n{{\n    \
         rel collection:colliders:includes = <{path}>\n    rel physics:filteredGroups = </World/{name}>\n}}\n"
    )
}

/// Convex colliders, at a pose in their parent.
fn meshes(pieces: &[Piece], parent: &str, at: &Isometry3<f64>) -> String {
    let mesh = |(index, piece): (usize, &Piece)| {
        let points: Vec<String> = piece.vertices.iter().map(|[x, y, z]| format!("({x}, {y}, {z})")).collect();
        let counts: Vec<String> = piece.faces.iter().map(|face| face.len().to_string()).collect();
        let corners: Vec<String> = piece.faces.iter().flatten().map(usize::to_string).collect();
        format!(
            "def Mesh \"{parent}_{index}\" (\n    \
             prepend apiSchemas = [\"PhysicsCollisionAPI\", \"PhysicsMeshCollisionAPI\", \"MaterialBindingAPI\"]\n    displayName = {}\n)\n{{\n    \
             point3f[] points = [{}]\n    int[] faceVertexCounts = [{}]\n    int[] faceVertexIndices = [{}]\n    \
             uniform token subdivisionScheme = \"none\"\n    uniform token physics:approximation = \"convexHull\"\n    \
             rel material:binding:physics = </World/contact>\n{}}}\n",
            quoted(&piece.name),
            points.join(", "),
            counts.join(", "),
            corners.join(", "),
            placed(at),
        )
    };
    pieces.iter().enumerate().map(mesh).collect()
}

/// A rigid body with what it carries.
fn rigid(name: &str, at: &Isometry3<f64>, inertia: &RigidInertia, content: &str) -> String {
    let (moments, axes) = principal(&inertia.rotational());
    format!(
        "def Xform \"{name}\" (\n    prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n)\n{{\n    \
         float physics:mass = {}\n    point3f physics:centerOfMass = {}\n    float3 physics:diagonalInertia = {}\n    \
         quatf physics:principalAxes = {}\n{}{content}}}\n",
        inertia.mass(),
        tuple(inertia.centre().iter().copied()),
        tuple(moments),
        quaternion(&axes),
        placed(at),
    )
}

/// The links of an arm at the start of the reference, side by side, and the joints between them.
fn links(arm: &ModelArm, model: &Model) -> String {
    let mut text = "def Xform \"arm\" (\n    prepend apiSchemas = [\"PhysicsArticulationRootAPI\"]\n)\n{\n".to_owned();
    let mut at = arm.base;
    for (index, link) in arm.links.iter().enumerate() {
        at *= link.frame(link.position);
        let content = if index + 1 == arm.links.len() { meshes(&model.body, "body", &arm.part) } else { String::new() };
        text += &rigid(&format!("link_{index}"), &at, &link.inertia, &content);
        // Joints move along or about the z axis of both of their frames.
        let align = Isometry3::from_parts(
            Vector3::zeros().into(),
            UnitQuaternion::rotation_between(&Vector3::z(), &link.joint.axis())
                .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI)),
        );
        let (kind, scale) = match link.joint.kind {
            JointKind::Prismatic => ("PhysicsPrismaticJoint", 1.0),
            JointKind::Revolute => ("PhysicsRevoluteJoint", 180.0 / std::f64::consts::PI),
        };
        let before = if index == 0 { arm.base * link.frame(0.0) } else { link.frame(0.0) };
        let parent = match index {
            0 => String::new(),
            _ => format!("    rel physics:body0 = </World/arm/link_{}>\n", index - 1),
        };
        let limit = |name: &str, value: f64| match value.is_finite() {
            true => format!("    float physics:{name} = {}\n", scale * value),
            false => String::new(),
        };
        let ((first, turned), (second, aligned)) =
            (position_and_quaternion(&(before * align)), position_and_quaternion(&align));
        let _ = write!(
            text,
            "def {kind} \"joint_{index}\" (\n    displayName = {}\n)\n{{\n    uniform token physics:axis = \"Z\"\n{parent}    \
             rel physics:body1 = </World/arm/link_{index}>\n    point3f physics:localPos0 = {}\n    quatf physics:localRot0 = {}\n    \
             point3f physics:localPos1 = {}\n    quatf physics:localRot1 = {}\n{}{}}}\n",
            quoted(&crate::text::plain(&link.joint.name)),
            tuple(first),
            tuple(turned),
            tuple(second),
            tuple(aligned),
            limit("lowerLimit", link.joint.lower),
            limit("upperLimit", link.joint.upper),
        );
    }
    text + "}\n"
}

/// Principal moments and the rotation from their axes to those of the body.
fn principal(moments: &Matrix3<f64>) -> ([f64; 3], UnitQuaternion<f64>) {
    let mut eigen = moments.symmetric_eigen();
    if eigen.eigenvectors.determinant() < 0.0 {
        let third = -eigen.eigenvectors.column(2);
        eigen.eigenvectors.set_column(2, &third);
    }
    let rotation = Rotation3::from_matrix_unchecked(eigen.eigenvectors);
    (eigen.eigenvalues.into(), UnitQuaternion::from_rotation_matrix(&rotation))
}

fn placed(pose: &Isometry3<f64>) -> String {
    let (position, rotation) = position_and_quaternion(pose);
    format!(
        "    double3 xformOp:translate = {}\n    quatd xformOp:orient = {}\n    \
         uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]\n",
        tuple(position),
        tuple(rotation)
    )
}

fn quaternion(rotation: &UnitQuaternion<f64>) -> String {
    tuple([rotation.w, rotation.i, rotation.j, rotation.k])
}

fn tuple(values: impl IntoIterator<Item = f64>) -> String {
    format!("({})", values.into_iter().map(|value| value.to_string()).collect::<Vec<_>>().join(", "))
}

/// A string of the format.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_moments_make_the_inertia() {
        let inertia = Matrix3::new(0.02, 0.001, 0.0, 0.001, 0.03, -0.002, 0.0, -0.002, 0.025);
        let (moments, axes) = principal(&inertia);
        let rotation = axes.to_rotation_matrix();
        let again = rotation * Matrix3::from_diagonal(&moments.into()) * rotation.inverse();
        assert!((again - inertia).amax() < 1e-15);
    }

    #[test]
    fn a_name_ends_no_string() {
        assert_eq!(quoted(r#"a"b\"#), r#""a\"b\\""#);
    }
}
