//! Links and joints of a URDF file.
//!
//! `urdf-rs` would read these files too, but through three XML parsers and without the lines that errors need; of a URDF,
//! only a few elements matter here.

use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3, Unit, Vector3};
use roxmltree::{Document, Node};

use crate::error::{Fault, suggest};
use crate::inertia::RigidInertia;

/// The content of a file.
#[derive(Debug, Clone)]
pub struct Urdf {
    pub links: Vec<UrdfLink>,
    pub joints: Vec<UrdfJoint>,
}

/// Content that an arm may never use: only its use reports the fault.
pub type Used<T> = Result<T, Fault>;

#[derive(Debug, Clone)]
pub struct UrdfLink {
    pub name: String,
    pub line: usize,
    /// In the frame of the link; zero where the file gives none. Links that no joint moves do not use it.
    pub inertia: Used<RigidInertia>,
}

#[derive(Debug, Clone)]
pub struct UrdfJoint {
    pub name: String,
    pub line: usize,
    pub kind: Used<UrdfKind>,
    /// Indices of links.
    pub parent: usize,
    pub child: usize,
    /// The joint in the frame of its parent.
    pub frame: IsometryMatrix3<f64>,
    /// In the frame of the joint. Fixed and floating joints do not use it.
    pub axis: Used<Unit<Vector3<f64>>>,
    pub limits: Used<UrdfLimits>,
    /// Moves as another joint does.
    pub is_mimic: bool,
}

/// Types of joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UrdfKind {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    Floating,
    Planar,
}

/// Limits of a joint (rad or m, rad/s or m/s, Nm or N).
#[derive(Debug, Clone, Copy, Default)]
pub struct UrdfLimits {
    pub lower: Option<f64>,
    pub upper: Option<f64>,
    pub velocity: Option<f64>,
    pub effort: Option<f64>,
}

const KINDS: [(&str, UrdfKind); 6] = [
    ("revolute", UrdfKind::Revolute),
    ("continuous", UrdfKind::Continuous),
    ("prismatic", UrdfKind::Prismatic),
    ("fixed", UrdfKind::Fixed),
    ("floating", UrdfKind::Floating),
    ("planar", UrdfKind::Planar),
];

impl UrdfKind {
    /// Its name in files.
    pub fn name(self) -> &'static str {
        KINDS.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }
}

impl Urdf {
    /// Links and joints of the text of a file.
    pub fn parse(text: &str) -> Result<Self, Fault> {
        let document = Document::parse(text)
            .map_err(|error| Fault::at(error.pos().row as usize, format!("this is not valid XML: {error}")))?;
        let robot = document.root_element();
        refuse_xacro(&robot)?;
        if robot.tag_name().name() != "robot" {
            let name = robot.tag_name().name();
            return Err(Fault::at(line(&robot), format!("a URDF begins with <robot>, this file with <{name}>")));
        }
        let mut links: Vec<UrdfLink> = Vec::new();
        for node in children(&robot, "link") {
            let link = read_link(&node)?;
            unused(&link.name, link.line, "link", links.iter().map(|link| (link.name.as_str(), link.line)))?;
            links.push(link);
        }
        let names: Vec<&str> = links.iter().map(|link| link.name.as_str()).collect();
        let mut joints: Vec<UrdfJoint> = Vec::new();
        for node in children(&robot, "joint") {
            let joint = read_joint(&node, &names)?;
            unused(&joint.name, joint.line, "joint", joints.iter().map(|joint| (joint.name.as_str(), joint.line)))?;
            joints.push(joint);
        }
        Ok(Self { links, joints })
    }
}

fn refuse_xacro(robot: &Node) -> Result<(), Fault> {
    let is_xacro = |node: &Node| node.tag_name().namespace().is_some_and(|namespace| namespace.contains("xacro"));
    match robot.descendants().find(is_xacro) {
        Some(node) => Err(Fault::at(
            line(&node),
            "this is a xacro file: expand it first, with `xacro FILE.urdf.xacro > FILE.urdf` in a ROS environment",
        )),
        None => Ok(()),
    }
}

fn unused<'name>(
    name: &str,
    line: usize,
    element: &str,
    mut others: impl Iterator<Item = (&'name str, usize)>,
) -> Result<(), Fault> {
    match others.find(|(other, _)| *other == name) {
        Some((_, first)) => Err(Fault::at(
            line,
            format!("there is another {element} `{name}` in line {first}: give each {element} its own name"),
        )),
        None => Ok(()),
    }
}

fn read_link(node: &Node) -> Result<UrdfLink, Fault> {
    let (name, line) = (required(node, "name", "")?.to_owned(), line(node));
    let owner = format!("link `{name}`: ");
    let inertia = match child(node, "inertial", &owner)? {
        Some(inertial) => read_inertial(&inertial, &owner),
        None => Ok(RigidInertia::zero()),
    };
    Ok(UrdfLink { name, line, inertia })
}

fn read_inertial(node: &Node, owner: &str) -> Result<RigidInertia, Fault> {
    let frame = read_origin(node, owner)?;
    let mass = required_child(node, "mass", owner)?;
    let mass = number(&mass, "value", owner)?;
    let inertia = required_child(node, "inertia", owner)?;
    let entry = |name: &str| number(&inertia, name, owner);
    let [xx, yy, zz] = [entry("ixx")?, entry("iyy")?, entry("izz")?];
    let [xy, xz, yz] = [entry("ixy")?, entry("ixz")?, entry("iyz")?];
    let rotational = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let body = RigidInertia::new(mass, Vector3::zeros(), rotational)
        .map_err(|error| Fault::at(line(node), format!("{owner}{error}")))?;
    Ok(body.seen_from(&frame))
}

fn read_joint(node: &Node, links: &[&str]) -> Result<UrdfJoint, Fault> {
    let (name, line) = (required(node, "name", "")?.to_owned(), line(node));
    let owner = format!("joint `{name}`: ");
    let link = |element: &str| -> Result<usize, Fault> {
        let node = required_child(node, element, &owner)?;
        let name = required(&node, "link", &owner)?;
        let unknown = || format!("{owner}{element} link `{name}` does not exist{}", suggest(name, links));
        links.iter().position(|link| *link == name).ok_or_else(|| Fault::at(self::line(&node), unknown()))
    };
    Ok(UrdfJoint {
        kind: read_kind(node, &owner),
        parent: link("parent")?,
        child: link("child")?,
        frame: read_origin(node, &owner)?,
        axis: read_axis(node, &owner),
        limits: read_limits(node, &owner),
        is_mimic: children(node, "mimic").next().is_some(),
        name,
        line,
    })
}

fn read_kind(node: &Node, owner: &str) -> Result<UrdfKind, Fault> {
    let written = required(node, "type", owner)?;
    let kind = KINDS.iter().find(|(name, _)| *name == written).map(|(_, kind)| *kind);
    kind.ok_or_else(|| {
        let names: Vec<&str> = KINDS.iter().map(|(name, _)| *name).collect();
        Fault::at(line(node), format!("{owner}unknown type `{written}`{}", suggest(written, &names)))
    })
}

fn read_origin(node: &Node, owner: &str) -> Result<IsometryMatrix3<f64>, Fault> {
    let Some(origin) = child(node, "origin", owner)? else { return Ok(IsometryMatrix3::identity()) };
    if let Some(other) = origin.attributes().find(|attribute| !["xyz", "rpy"].contains(&attribute.name())) {
        let message = format!("{owner}<origin> has xyz and rpy, and no `{}`", other.name());
        return Err(Fault::at(line(&origin), message));
    }
    let vector = |name: &str| optional_vector(&origin, name, owner).map(Option::unwrap_or_default);
    let (position, [roll, pitch, yaw]) = (vector("xyz")?, vector("rpy")?);
    Ok(IsometryMatrix3::from_parts(Translation3::from(position), Rotation3::from_euler_angles(roll, pitch, yaw)))
}

fn read_axis(node: &Node, owner: &str) -> Result<Unit<Vector3<f64>>, Fault> {
    let Some(axis) = child(node, "axis", owner)? else { return Ok(Vector3::x_axis()) };
    let vector = Vector3::from(optional_vector(&axis, "xyz", owner)?.unwrap_or([1.0, 0.0, 0.0]));
    Unit::try_new(vector, 1e-6).ok_or_else(|| Fault::at(line(&axis), format!("{owner}the axis has no length")))
}

fn read_limits(node: &Node, owner: &str) -> Result<UrdfLimits, Fault> {
    let Some(limit) = child(node, "limit", owner)? else { return Ok(UrdfLimits::default()) };
    let entry = |name: &str| limit.attribute(name).map(|_| number(&limit, name, owner)).transpose();
    Ok(UrdfLimits {
        lower: entry("lower")?,
        upper: entry("upper")?,
        velocity: entry("velocity")?,
        effort: entry("effort")?,
    })
}

fn line(node: &Node) -> usize {
    node.document().text_pos_at(node.range().start).row as usize
}

fn children<'node, 'text>(node: &Node<'node, 'text>, name: &str) -> impl Iterator<Item = Node<'node, 'text>> {
    node.children().filter(move |child| child.has_tag_name(name))
}

/// The only child of a name, if there is one.
fn child<'node, 'text>(
    node: &Node<'node, 'text>,
    name: &str,
    owner: &str,
) -> Result<Option<Node<'node, 'text>>, Fault> {
    let mut found = children(node, name);
    let first = found.next();
    match found.next() {
        Some(second) => Err(Fault::at(line(&second), format!("{owner}a second <{name}>: remove one of them"))),
        None => Ok(first),
    }
}

fn required_child<'node, 'text>(
    node: &Node<'node, 'text>,
    name: &str,
    owner: &str,
) -> Result<Node<'node, 'text>, Fault> {
    let missing = || format!("{owner}<{}> needs <{name}>", node.tag_name().name());
    child(node, name, owner)?.ok_or_else(|| Fault::at(line(node), missing()))
}

fn required<'node>(node: &Node<'node, '_>, name: &str, owner: &str) -> Result<&'node str, Fault> {
    let missing = || format!("{owner}<{}> needs the attribute `{name}`", node.tag_name().name());
    node.attribute(name).filter(|value| !value.is_empty()).ok_or_else(|| Fault::at(line(node), missing()))
}

fn number(node: &Node, name: &str, owner: &str) -> Result<f64, Fault> {
    let written = required(node, name, owner)?;
    in_range(written).ok_or_else(|| {
        let element = node.tag_name().name();
        Fault::at(line(node), format!("{owner}`{name}` of <{element}> is `{written}`: give a number from -1e9 to 1e9"))
    })
}

fn optional_vector(node: &Node, name: &str, owner: &str) -> Result<Option<[f64; 3]>, Fault> {
    let Some(written) = node.attribute(name) else { return Ok(None) };
    let numbers: Option<Vec<f64>> = written.split_whitespace().map(in_range).collect();
    let vector = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    vector.map(Some).ok_or_else(|| {
        let element = node.tag_name().name();
        Fault::at(
            line(node),
            format!("{owner}`{name}` of <{element}> is `{written}`: give three numbers from -1e9 to 1e9"),
        )
    })
}

/// Larger numbers are a mistake.
const LARGEST: f64 = 1e9;

fn in_range(written: &str) -> Option<f64> {
    written.trim().parse().ok().filter(|number: &f64| number.abs() <= LARGEST)
}
