//! URDF, and what all formats agree on.

use crate::support::{assert_pose, names, refusal, shapes};
use link::Geometry;
use nalgebra::{Isometry3, UnitQuaternion};
use proptest::prelude::*;

fn model(inside: &str) -> String {
    format!("<robot name='r'><link name='bare'/><link name='tool'>\n{inside}\n</link></robot>")
}

#[test]
fn shapes_have_their_poses_and_sizes() {
    let text = model(
        "<visual><geometry><sphere radius='1'/></geometry></visual>
         <collision name='a'><origin rpy='0 0 1.5707963267948966' xyz='1 2 3'/>
            <geometry><box size='0.1 0.2 0.3'/></geometry></collision>
         <collision><origin xyz='0 0 1'/><geometry><cylinder length='0.5' radius='0.1'/></geometry></collision>
         <collision><geometry><mesh filename='../c.obj' scale='0.001 0.001 0.001'/></geometry></collision>",
    );
    assert_eq!(names(&text), ["tool"]);
    let found = shapes(&text, "tool").unwrap();
    assert_eq!(found.iter().map(|shape| shape.name.as_str()).collect::<Vec<_>>(), ["a", "collision 2", "collision 3"]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    assert_pose(&found[0].pose, [1.0, 2.0, 3.0], [half, 0.0, 0.0, half], "a");
    assert_pose(&found[1].pose, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0], "collision 2");
    assert_eq!(found[2].geometry, Geometry::Mesh { file: "folder/../c.obj".into(), scale: 0.001 });
}

#[test]
fn what_is_not_read_is_refused_at_its_place() {
    let geometry = |shape: &str| model(&format!("<collision><geometry>{shape}</geometry></collision>"));
    let origin =
        |origin: &str| model(&format!("<collision>{origin}<geometry><box size='1 1 1'/></geometry></collision>"));
    for (text, words) in [
        (geometry("<sphere radius='1'/>"), "sphere is not supported: use boxes, cylinders"),
        (geometry("<capsule radius='1' length='1'/>"), "capsule is not supported"),
        (geometry(""), "<collision> has no geometry"),
        (
            geometry("<box size='1 1 1'/><box size='2 2 2'/>"),
            "a second shape in one <geometry>: give it a <collision> of its own",
        ),
        (origin("<origin/><origin xyz='1 0 0'/>"), "a second <origin> in one <collision>: only one can be meant"),
        (geometry("<box/>"), "<box> has no `size`"),
        (geometry("<box size='1 1 ${w}'/>"), "size \"1 1 ${w}\" must be numbers with blanks between them"),
        (geometry("<box size='1 1 1 1'/>"), "must have 3 numbers, not 4"),
        (geometry("<cylinder radius='0' length='1'/>"), "radius \"0\" must be positive"),
        (geometry("<cylinder radius='1'/>"), "<cylinder> has no `length`"),
        (geometry("<mesh/>"), "<mesh> has no `filename`"),
        (geometry("<mesh filename='a.stl' scale='1 1 -1'/>"), "stretch or mirror the mesh in its file"),
        (geometry("<mesh filename='package://nowhere/a.stl'/>"), "is not found: no folder above"),
        (origin("<origin xyz='1 2'/>"), "xyz \"1 2\" must have 3 numbers, not 2"),
        (origin("<origin rpy='a b c'/>"), "rpy \"a b c\" must be numbers"),
        (model("<x:macro xmlns:x='http://www.ros.org/wiki/xacro'/>"), "xacro is not expanded here: run `xacro`"),
    ] {
        let (line, message) = refusal(&text, "tool");
        assert!(message.contains(words) && line == 2, "{text}: {line} {message}");
    }
}

/// A shape in the words of each format: SDF, URDF, MJCF.
fn in_all_formats(sizes: [f64; 3], kind: usize, [x, y, z]: [f64; 3], [roll, pitch, yaw]: [f64; 3]) -> [String; 3] {
    let [a, b, c] = sizes;
    let [sdf, urdf, mjcf] = match kind {
        0 => [
            format!("<box><size>{a} {b} {c}</size></box>"),
            format!("<box size='{a} {b} {c}'/>"),
            format!("type='box' size='{} {} {}'", 0.5 * a, 0.5 * b, 0.5 * c),
        ],
        1 => [
            format!("<cylinder><radius>{a}</radius><length>{b}</length></cylinder>"),
            format!("<cylinder radius='{a}' length='{b}'/>"),
            format!("type='cylinder' size='{a} {}'", 0.5 * b),
        ],
        _ => [
            format!("<mesh><uri>part.stl</uri><scale>{a} {a} {a}</scale></mesh>"),
            format!("<mesh filename='part.stl' scale='{a} {a} {a}'/>"),
            "type='mesh' mesh='part'".to_owned(),
        ],
    };
    let sdf = format!(
        "<sdf><model><link name='tool'><collision name='s'><pose>{x} {y} {z} {roll} {pitch} {yaw}</pose>
         <geometry>{sdf}</geometry></collision></link></model></sdf>"
    );
    let urdf = format!(
        "<robot><link name='tool'><collision name='s'><origin xyz='{x} {y} {z}' rpy='{roll} {pitch} {yaw}'/>
         <geometry>{urdf}</geometry></collision></link></robot>"
    );
    let mjcf = format!(
        "<mujoco><compiler angle='radian' eulerseq='XYZ'/><asset><mesh file='part.stl' scale='{a} {a} {a}'/></asset>
         <worldbody><body name='tool'><geom name='s' pos='{x} {y} {z}' euler='{roll} {pitch} {yaw}' {mjcf}/></body>
         </worldbody></mujoco>"
    );
    [sdf, urdf, mjcf]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn all_formats_agree_on_a_shape(
        sizes in prop::array::uniform3(1e-3f64..10.0),
        kind in 0usize..3,
        position in prop::array::uniform3(-10.0f64..10.0),
        angles in prop::array::uniform3(-7.0f64..7.0),
    ) {
        let [roll, pitch, yaw] = angles;
        // Independent of the reader: about the fixed axes x, y, z one after the other.
        let turn = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
        let [x, y, z] = [nalgebra::Vector3::x_axis(), nalgebra::Vector3::y_axis(), nalgebra::Vector3::z_axis()];
        let rotation = turn(z, yaw) * turn(y, pitch) * turn(x, roll);
        let pose = Isometry3::from_parts(position.into(), rotation);
        let geometry = match kind {
            0 => Geometry::Box { edges: sizes },
            1 => Geometry::Cylinder { radius: sizes[0], length: sizes[1] },
            _ => Geometry::Mesh { file: "folder/part.stl".into(), scale: sizes[0] },
        };
        for text in in_all_formats(sizes, kind, position, angles) {
            let found = shapes(&text, "tool").unwrap();
            prop_assert_eq!(found.len(), 1);
            prop_assert_eq!(&found[0].name, "s");
            prop_assert_eq!(&found[0].geometry, &geometry);
            prop_assert!((found[0].pose.inverse() * pose).rotation.angle() < 1e-7, "{}", text);
            prop_assert_eq!(found[0].pose.translation, pose.translation);
        }
    }

    #[test]
    fn nothing_makes_the_reader_panic(start in 0usize..3, place in 0usize..600, written in "[ -~]{0,12}") {
        let mut text = in_all_formats([1.0; 3], start, [0.0; 3], [0.0; 3])[start].clone();
        let place = place.min(text.len());
        let end = (place + written.len()).min(text.len());
        text.replace_range(place..end, &written);
        if let Ok(model) = link::Model::parse("model".as_ref(), &text) {
            for link in model.links().unwrap_or_default() {
                let _ = link.shapes();
            }
        }
    }
}
