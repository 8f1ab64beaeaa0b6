//! The joints between the root of a URDF and its tip, with everything else as part of the links that carry it.

use nalgebra::IsometryMatrix3;

use crate::error::{Fault, suggest};
use crate::inertia::RigidInertia;
use crate::joint::{Joint, JointKind, MOST_JOINTS};
use crate::urdf::{Urdf, UrdfJoint, UrdfKind, UrdfLink};

/// A link that some joint of the chain moves.
#[derive(Debug, Clone, PartialEq)]
pub struct MovedLink {
    /// Its name in the file.
    pub name: String,
    /// Index of the last joint of the chain that moves it.
    pub joint: usize,
    /// Its frame in that of the link behind the joint.
    pub(crate) frame: IsometryMatrix3<f64>,
}

/// Moving joints from the root to the tip, and the tip in the frame of the last one's link.
#[derive(Debug)]
pub struct Chain {
    /// Name of the link that no joint moves.
    pub root: String,
    pub joints: Vec<Joint>,
    /// Lines of the links behind the joints.
    pub lines: Vec<usize>,
    pub tip: IsometryMatrix3<f64>,
    /// All links that move.
    pub moved: Vec<MovedLink>,
    /// Unusual properties of the file that an arm may have.
    pub remarks: Vec<Fault>,
}

impl Chain {
    /// For the link of a name.
    pub fn to_tip(urdf: &Urdf, tip: &str) -> Result<Self, Fault> {
        let names: Vec<&str> = urdf.links.iter().map(|link| link.name.as_str()).collect();
        if names.is_empty() {
            return Err(Fault::somewhere("the file has no <link>: an arm needs links and joints"));
        }
        let unknown = || Fault::somewhere(format!("there is no link `{tip}`{}", suggest(tip, &names)));
        let tip = names.iter().position(|name| *name == tip).ok_or_else(unknown)?;
        let parents = parent_joints(urdf)?;
        let root = root(urdf, &parents)?;
        let moving = moving_joints(urdf, &parents, root, tip)?;
        let mut remarks = Vec::new();
        let read = |&index: &usize| joint(&urdf.joints[index], &mut remarks);
        let joints = moving.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let lines = moving.iter().map(|&index| urdf.links[urdf.joints[index].child].line).collect();
        let name = urdf.links[root].name.clone();
        let mut chain =
            Self { root: name, joints, lines, tip: IsometryMatrix3::identity(), moved: Vec::new(), remarks };
        chain.place_links(urdf, root, tip, &moving)?;
        Ok(chain)
    }

    /// Adds the inertia of each link to the moving link that carries it, and finds the frames between moving links.
    fn place_links(&mut self, urdf: &Urdf, root: usize, tip: usize, moving: &[usize]) -> Result<(), Fault> {
        // Links to visit: index, its moving link (none for the base), its frame in that link's.
        let mut links: Vec<(usize, Option<usize>, IsometryMatrix3<f64>)> =
            vec![(root, None, IsometryMatrix3::identity())];
        while let Some((link, carrier, frame)) = links.pop() {
            if let Some(carrier) = carrier {
                let inertia = urdf.links[link].inertia.clone()?;
                self.remarks.extend(impossible_shape(&urdf.links[link], &inertia));
                let joint = &mut self.joints[carrier];
                joint.link_inertia = joint.link_inertia.joined(&inertia.seen_from(&frame));
                let name = urdf.links[link].name.clone();
                self.moved.push(MovedLink { name, joint: carrier, frame });
            }
            if link == tip {
                self.tip = frame;
            }
            for (index, joint) in urdf.joints.iter().enumerate().filter(|(_, joint)| joint.parent == link) {
                let before = frame * joint.frame;
                match moving.iter().position(|&moving| moving == index) {
                    Some(next) => {
                        self.joints[next].before = before;
                        links.push((joint.child, Some(next), IsometryMatrix3::identity()));
                    }
                    None => links.push((joint.child, carrier, before * held(joint))),
                }
            }
        }
        Ok(())
    }
}

/// The joint above each link.
fn parent_joints(urdf: &Urdf) -> Result<Vec<Option<usize>>, Fault> {
    let mut parents: Vec<Option<usize>> = vec![None; urdf.links.len()];
    for (index, joint) in urdf.joints.iter().enumerate() {
        if let Some(first) = parents[joint.child].replace(index) {
            let (child, first) = (&urdf.links[joint.child].name, &urdf.joints[first].name);
            let message = format!(
                "joint `{}`: its child link `{child}` hangs on joint `{first}` already; links and joints must form a tree",
                joint.name
            );
            return Err(Fault::at(joint.line, message));
        }
    }
    Ok(parents)
}

fn root(urdf: &Urdf, parents: &[Option<usize>]) -> Result<usize, Fault> {
    let mut roots = (0..parents.len()).filter(|&link| parents[link].is_none());
    match (roots.next(), roots.next()) {
        (Some(root), None) => Ok(root),
        (Some(one), Some(other)) => {
            let [one, other] = [&urdf.links[one], &urdf.links[other]];
            let message = format!(
                "link `{}` and link `{}` (line {}) both have no parent: connect them with joints",
                one.name, other.name, other.line
            );
            Err(Fault::at(one.line, message))
        }
        (None, _) => Err(Fault::somewhere("the joints form a loop: no link is without a parent, so there is no base")),
    }
}

/// Indices of the moving joints from the root to the tip.
fn moving_joints(urdf: &Urdf, parents: &[Option<usize>], root: usize, tip: usize) -> Result<Vec<usize>, Fault> {
    let mut above: Vec<usize> = Vec::new();
    let mut link = tip;
    while let Some(index) = parents[link] {
        if above.contains(&index) {
            let joint = &urdf.joints[index];
            let message = format!("joint `{}` hangs on itself: links and joints must form a tree", joint.name);
            return Err(Fault::at(joint.line, message));
        }
        above.push(index);
        link = urdf.joints[index].parent;
    }
    let moving: Vec<usize> =
        above.into_iter().rev().filter(|&index| urdf.joints[index].kind != Ok(UrdfKind::Fixed)).collect();
    let [root, tip] = [&urdf.links[root].name, &urdf.links[tip].name];
    match moving.get(MOST_JOINTS) {
        Some(&first) => {
            let message = format!(
                "{} joints move between `{root}` and `{tip}`: at most {MOST_JOINTS} are allowed; fix some of them",
                moving.len()
            );
            Err(Fault::at(urdf.joints[first].line, message))
        }
        None if moving.is_empty() => Err(Fault::somewhere(format!(
            "no joint moves between `{root}` and `{tip}`: choose a tip behind the joints"
        ))),
        None => Ok(moving),
    }
}

/// A moving joint; frame and inertia are still to be found.
fn joint(urdf: &UrdfJoint, remarks: &mut Vec<Fault>) -> Result<Joint, Fault> {
    let fault = |message: String| Fault::at(urdf.line, format!("joint `{}`: {message}", urdf.name));
    let refused = |message: String| Err(fault(message));
    if urdf.is_mimic {
        return refused("it mimics another joint; an arm's joints must move on their own".to_owned());
    }
    let written = urdf.kind.clone()?;
    let kind = match written {
        UrdfKind::Revolute | UrdfKind::Continuous => JointKind::Revolute,
        UrdfKind::Prismatic => JointKind::Prismatic,
        other => return refused(format!("an arm cannot have a {} joint: use joints with one axis", other.name())),
    };
    let limits = urdf.limits.clone()?;
    let [lower, upper] = if written == UrdfKind::Continuous {
        [f64::NEG_INFINITY, f64::INFINITY]
    } else {
        match (limits.lower, limits.upper) {
            (Some(lower), Some(upper)) if lower < upper => [lower, upper],
            (Some(lower), Some(upper)) => {
                return refused(format!("`lower` = {lower} must be below `upper` = {upper}"));
            }
            _ => return refused(format!("a {} joint needs <limit lower=... upper=...>", written.name())),
        }
    };
    let mut largest = |name: &str, given: Option<f64>| match given {
        // The format demands a number: zero stands for an unknown one.
        Some(0.0) => {
            remarks.push(fault(format!("`{name}` = 0 is taken as unknown: nothing limits this joint's {name}")));
            Ok(f64::INFINITY)
        }
        Some(limit) if limit < 0.0 => Err(fault(format!("`{name}` = {limit} must not be negative"))),
        Some(limit) => Ok(limit),
        None => Ok(f64::INFINITY),
    };
    let (velocity, effort) = (largest("velocity", limits.velocity)?, largest("effort", limits.effort)?);
    Ok(Joint {
        name: urdf.name.clone(),
        kind,
        lower,
        upper,
        velocity,
        effort,
        before: IsometryMatrix3::identity(),
        axis: urdf.axis.clone()?,
        link_inertia: RigidInertia::zero(),
        rotor_inertia: 0.0,
    })
}

/// Frame of the link of a joint beside the chain: it stays at zero, or at the limit next to that. A joint of unknown
/// motion stays at zero.
fn held(joint: &UrdfJoint) -> IsometryMatrix3<f64> {
    let limits = joint.limits.clone().unwrap_or_default();
    let position = 0f64.max(limits.lower.unwrap_or(0.0)).min(limits.upper.unwrap_or(0.0));
    match (&joint.kind, &joint.axis) {
        (Ok(UrdfKind::Revolute), Ok(axis)) => JointKind::Revolute.motion(axis, position),
        (Ok(UrdfKind::Prismatic), Ok(axis)) => JointKind::Prismatic.motion(axis, position),
        _ => IsometryMatrix3::identity(),
    }
}

/// Part of the largest principal moment by which it may exceed the sum of the others: files have rounded numbers.
const ROUNDING: f64 = 1e-3;

/// A remark on a rotational inertia that no distribution of mass has: none of the principal moments exceeds the sum of the
/// other two.
fn impossible_shape(link: &UrdfLink, inertia: &RigidInertia) -> Option<Fault> {
    let mut moments: [f64; 3] = inertia.rotational().symmetric_eigenvalues().into();
    moments.sort_by(f64::total_cmp);
    let [small, middle, large] = moments;
    (large > (1.0 + ROUNDING) * (small + middle)).then(|| {
        Fault::at(
            link.line,
            format!(
                "link `{}`: no body has principal moments of {small:.3e}, {middle:.3e} and {large:.3e} kg m^2, the largest \
                 exceeds the sum of the others: check <inertia>",
                link.name
            ),
        )
    })
}
