//! MJCF, compared with the poses and sizes that MuJoCo 3.17 makes of the same file.

use std::path::Path;

use crate::support::{assert_pose, names, refusal, shapes};
use link::Geometry;

const MODEL: &str = r#"<mujoco>
  <compiler angle="degree" eulerseq="zyX" meshdir="meshes"/>
  <default>
    <geom contype="1" size="0.01 0.02 0.03"/>
    <mesh scale="0.01 0.01 0.01"/>
    <default class="plate">
      <geom type="box" size="0.03 0.04 0.005"/>
      <default class="thin"><geom size="0.03 0.04 0.001" euler="0 90 0"/></default>
    </default>
    <default class="seen"><geom contype="0" conaffinity="0"/></default>
  </default>
  <asset><mesh file="wedge.obj"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1" class="seen"/>
    <body name="tool" childclass="plate" pos="1 2 3" euler="10 20 30">
      <geom name="class"/>
      <geom name="inner" class="thin" pos="0.1 0 0"/>
      <geom name="own" class="thin" quat="0.5 0.5 0.5 -0.5"/>
      <geom name="euler" euler="10 20 30" pos="0.01 0.02 0.03"/>
      <geom name="axisangle" axisangle="1 2 3 40"/>
      <geom name="xyaxes" xyaxes="0 1 0.2 -1 0.3 0"/>
      <geom name="zaxis" zaxis="0.3 -0.2 -1"/>
      <geom name="down" zaxis="0 0 -2"/>
      <geom name="rod" type="cylinder" fromto="0.1 0.2 0.3 0.2 0.1 0.35" size="0.004"/>
      <geom name="bar" fromto="0 0.01 0.05 0.02 0.03 -0.04" size="0.004"/>
      <geom name="wedge" type="mesh" mesh="wedge" pos="0.1 0.2 0.3" axisangle="0 0 1 90"/>
      <geom name="picture" class="seen" type="sphere"/>
      <frame pos="0.5 0 0" euler="0 0 90">
        <geom name="framed" pos="0 0.1 0"/>
        <frame name="second" axisangle="0 1 0 90" childclass="seen">
          <geom class="plate" pos="0 0 0.2"/>
        </frame>
      </frame>
      <body name="other"><geom name="elsewhere"/></body>
    </body>
  </worldbody>
</mujoco>"#;

#[test]
fn poses_and_sizes_are_those_of_mujoco() {
    type Expected = (&'static str, [f64; 3], [f64; 4], [f64; 3]);
    let right_angle = std::f64::consts::FRAC_1_SQRT_2;
    // Positions, quaternions and sizes of the compiled model; a cylinder has radius and half length.
    let expected: [Expected; 13] = [
        ("class", [0.0; 3], [1.0, 0.0, 0.0, 0.0], [0.03, 0.04, 0.005]),
        ("inner", [0.1, 0.0, 0.0], [right_angle, 0.0, right_angle, 0.0], [0.03, 0.04, 0.001]),
        ("own", [0.0; 3], [0.5, 0.5, 0.5, -0.5], [0.03, 0.04, 0.001]),
        ("euler", [0.01, 0.02, 0.03], [0.951548525, 0.239298338, 0.144878125, 0.127679441], [0.03, 0.04, 0.005]),
        ("axisangle", [0.0; 3], [0.939692621, 0.091408728, 0.182817457, 0.274226185], [0.03, 0.04, 0.005]),
        ("xyaxes", [0.0; 3], [0.705408827, 0.048973327, -0.090319755, 0.701314724], [0.03, 0.04, 0.005]),
        ("zaxis", [0.0; 3], [0.172161453, 0.546417827, 0.81962674, 0.0], [0.03, 0.04, 0.005]),
        ("down", [0.0; 3], [0.0, 1.0, 0.0, 0.0], [0.03, 0.04, 0.005]),
        ("rod", [0.15, 0.15, 0.325], [0.577350269, -0.577350269, -0.577350269, 0.0], [0.004, 0.075, 0.0]),
        ("bar", [0.01, 0.02, 0.005], [0.988432621, 0.107240277, -0.107240277, 0.0], [0.004, 0.004, 0.047169906]),
        // MuJoCo moves the mesh into its principal axes and the geom back.
        ("wedge", [0.1, 0.2, 0.3], [right_angle, 0.0, 0.0, right_angle], [0.0; 3]),
        ("framed", [0.5, 0.0, 0.1], [right_angle, right_angle, 0.0, 0.0], [0.03, 0.04, 0.005]),
        ("geom 14", [0.7, 0.0, 0.0], [0.5, 0.5, 0.5, 0.5], [0.03, 0.04, 0.005]),
    ];
    let found = shapes(MODEL, "tool").unwrap();
    let names: Vec<&str> = found.iter().map(|shape| shape.name.as_str()).collect();
    assert_eq!(names, expected.map(|(name, ..)| name));
    for (shape, (name, position, quaternion, size)) in found.iter().zip(expected) {
        assert_pose(&shape.pose, position, quaternion, name);
        let near = |one: f64, other: f64| assert!((one - 2.0 * other).abs() < 1e-8, "{name}: {one} {other}");
        match &shape.geometry {
            Geometry::Box { edges } => (0..3).for_each(|axis| near(edges[axis], size[axis])),
            Geometry::Cylinder { radius, length } => {
                near(2.0 * radius, size[0]);
                near(*length, size[1]);
            }
            Geometry::Mesh { file, scale } => {
                assert_eq!((file.to_str(), *scale), (Some("folder/meshes/wedge.obj"), 0.01));
            }
        }
    }
}

#[test]
fn the_world_is_a_body_and_what_is_only_seen_is_no_shape() {
    let of = |geoms: &str| format!("<mujoco><worldbody>{geoms}<body name='empty'/></worldbody></mujoco>");
    let found = shapes(&of("<geom type='box' size='1 1 1'/>"), "world").unwrap();
    assert_eq!((found.len(), found[0].name.as_str()), (1, "geom 1"));
    let seen = of("<geom type='sphere' size='1' contype='0' conaffinity='0'/>");
    assert!(names(&seen).is_empty());
    let half_seen = of("<geom type='box' size='1 1 1' contype='0'/>");
    assert_eq!(names(&half_seen), ["world"]);
}

#[test]
fn bodies_without_names_are_counted() {
    let geom = "<geom type='box' size='1 1 1'/>";
    let text = format!(
        "<mujoco><worldbody><body/><body>{geom}<body name='tip'>{geom}</body></body><body>{geom}</body></worldbody></mujoco>"
    );
    assert_eq!(names(&text), ["#2", "tip", "#4"]);
    assert_eq!(shapes(&text, "#4").unwrap().len(), 1);
}

#[test]
fn folders_of_mesh_files_are_stripped_where_the_compiler_says_so() {
    let file = |strip: &str| {
        let text = format!(
            "<mujoco><compiler meshdir='meshes' {strip}/><asset><mesh name='m' file='far/away/m.stl'/></asset>\
             <worldbody><geom type='mesh' mesh='m'/></worldbody></mujoco>"
        );
        match &shapes(&text, "world").unwrap()[0].geometry {
            Geometry::Mesh { file, .. } => file.clone(),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(file("strippath='true'"), Path::new("folder/meshes/m.stl"));
    assert_eq!(file("strippath='false'"), Path::new("folder/meshes/far/away/m.stl"));
    assert_eq!(file(""), Path::new("folder/meshes/far/away/m.stl"));
}

#[test]
fn what_is_not_read_is_refused_at_its_place() {
    let of = |inside: &str| {
        format!(
            "<mujoco>\n<asset><mesh name='m' file='m.stl'/><mesh name='n' file='n.stl' refpos='1 0 0'/><mesh name='v' vertex='0 0 0'/><mesh name='s' file='s.stl' scale='1 1 -1'/></asset><worldbody><body name='tool'>\n{inside}\n</body></worldbody></mujoco>"
        )
    };
    for (inside, words) in [
        ("<geom/>", "sphere is not supported: use boxes, cylinders or STL or OBJ meshes in its place"),
        ("<geom type='capsule' size='1 1'/>", "capsule is not supported"),
        ("<geom type='ellipsoid' size='1 1 1'/>", "ellipsoid is not supported"),
        ("<geom type='plane' size='1 1 1'/>", "plane is not supported"),
        ("<geom type='hfield' hfield='h'/>", "hfield is not supported"),
        ("<geom type='sdf' mesh='m'/>", "a sdf fitted to a mesh is not supported"),
        ("<geom type='box' mesh='m'/>", "a box fitted to a mesh is not supported"),
        ("<geom type='mesh'/>", "a geom of type mesh must name its `mesh`"),
        ("<geom type='mesh' mesh='q'/>", "mesh \"q\" is not a mesh of <asset>"),
        ("<geom type='mesh' mesh='n'/>", "refpos \"1 0 0\" is not supported: move the mesh"),
        ("<geom type='mesh' mesh='v'/>", "a mesh without a file is not supported"),
        ("<geom type='mesh' mesh='s'/>", "scale \"1 1 -1\" must be positive and the same along all axes"),
        ("<geom type='box'/>", "a box must have its `size`"),
        ("<geom type='box' size='1 2'/>", "size \"1 2\" must have 3 numbers, not 2"),
        ("<geom type='box' size='1 2 0'/>", "size \"1 2 0\" must be positive"),
        ("<geom type='box' size='1 2 nan'/>", "size \"1 2 nan\" must have finite numbers below 1e6"),
        ("<geom type='box' size='1 2 a'/>", "size \"1 2 a\" must be numbers with blanks between them"),
        ("<geom type='box' size='1 2 3' pos='1 2'/>", "pos \"1 2\" must have 3 numbers, not 2"),
        ("<geom type='box' size='1 2 3' quat='0 0 0 0'/>", "quat \"0 0 0 0\" must have a quaternion, not zero"),
        ("<geom type='box' size='1 2 3' quat='1 0 0 0' euler='9 0 0'/>", "euler \"9 0 0\" is a second orientation"),
        ("<geom type='box' size='1 2 3' zaxis='0 0 0'/>", "zaxis \"0 0 0\" must be a direction, not zero"),
        ("<geom type='box' size='1 2 3' xyaxes='1 0 0 2 0 0'/>", "must be a direction, not zero"),
        ("<geom type='cylinder' size='1' fromto='1 1 1 1 1 1'/>", "must be a direction, not zero"),
        ("<geom type='box' size='1 2 3' contype='a'/>", "contype \"a\" must be numbers"),
        ("<geom class='c'/>", "class \"c\" is not a class of <default>"),
        ("<replicate count='2'><geom type='box' size='1 1 1'/></replicate>", "replicate is not supported"),
        ("<composite type='grid'/>", "composite is not supported"),
        ("<include file='a.xml'/>", "<include> is not followed"),
    ] {
        let (line, message) = refusal(&of(inside), "tool");
        assert!(message.contains(words), "{inside}: {message}");
        let is_asset = ["'n'", "'v'", "'s'"].iter().any(|name| inside.contains(name)) && inside.contains("mesh=");
        assert_eq!(line, if is_asset { 2 } else { 3 }, "{inside}: {message}");
    }
    let compiler = |attributes: &str| {
        format!("<mujoco>\n<compiler {attributes}/><worldbody><geom type='box' size='1 1 1'/></worldbody></mujoco>")
    };
    for (attributes, words) in [
        ("angle='turn'", "angle \"turn\" must be degree or radian"),
        ("eulerseq='xyw'", "eulerseq \"xyw\" must be three of x, y, z, X, Y, Z"),
        ("eulerseq='xy'", "eulerseq \"xy\" must be three of x, y, z, X, Y, Z"),
        ("coordinate='global'", "coordinate \"global\" is not supported"),
    ] {
        let (line, message) = refusal(&compiler(attributes), "world");
        assert!(message.contains(words) && line == 2, "{attributes}: {line} {message}");
    }
}
