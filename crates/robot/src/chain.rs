//! The joints between the root of a URDF and its tip, with everything else as part of the links that carry it.

use nalgebra::IsometryMatrix3;

use crate::error::{Fault, suggest};
use crate::inertia::RigidInertia;
use crate::joint::{Joint, JointKind, MOST_JOINTS};
use crate::urdf::{Urdf, UrdfJoint, UrdfKind, UrdfLink};

/// Moving joints from the root to the tip, and the tip in the frame of the last one's link.
#[derive(Debug)]
pub struct Chain {
    pub joints: Vec<Joint>,
    pub tip: IsometryMatrix3<f64>,
}

impl Chain {
    /// Of the link of a name.
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
        let joints = moving.iter().map(|&index| joint(&urdf.joints[index])).collect::<Result<Vec<_>, _>>()?;
        let mut chain = Self { joints, tip: IsometryMatrix3::identity() };
        chain.place_links(urdf, root, tip, &moving);
        match chain.joints.iter().position(|joint| joint.link_inertia.mass() == 0.0) {
            Some(massless) => Err(without_mass(&urdf.links[urdf.joints[moving[massless]].child])),
            None => Ok(chain),
        }
    }

    /// Adds the inertia of each link to the moving link that carries it, and finds the frames between moving links.
    fn place_links(&mut self, urdf: &Urdf, root: usize, tip: usize, moving: &[usize]) {
        // Links to visit: index, its moving link (none for the base), its frame in that link's.
        let mut links: Vec<(usize, Option<usize>, IsometryMatrix3<f64>)> =
            vec![(root, None, IsometryMatrix3::identity())];
        while let Some((link, carrier, frame)) = links.pop() {
            if let Some(carrier) = carrier {
                let joint = &mut self.joints[carrier];
                joint.link_inertia = joint.link_inertia.joined(&urdf.links[link].inertia.seen_from(&frame));
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
        above.into_iter().rev().filter(|&index| urdf.joints[index].kind != UrdfKind::Fixed).collect();
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
fn joint(urdf: &UrdfJoint) -> Result<Joint, Fault> {
    let refused = |message: String| Err(Fault::at(urdf.line, format!("joint `{}`: {message}", urdf.name)));
    if urdf.is_mimic {
        return refused("it mimics another joint; an arm's joints must move on their own".to_owned());
    }
    let kind = match urdf.kind {
        UrdfKind::Revolute | UrdfKind::Continuous => JointKind::Revolute,
        UrdfKind::Prismatic => JointKind::Prismatic,
        other => return refused(format!("an arm cannot have a {} joint: use joints with one axis", other.name())),
    };
    let [lower, upper] = if urdf.kind == UrdfKind::Continuous {
        [f64::NEG_INFINITY, f64::INFINITY]
    } else {
        match (urdf.limits.lower, urdf.limits.upper) {
            (Some(lower), Some(upper)) if lower < upper => [lower, upper],
            (Some(lower), Some(upper)) => {
                return refused(format!("`lower` = {lower} must be below `upper` = {upper}"));
            }
            _ => return refused(format!("a {} joint needs <limit lower=... upper=...>", urdf.kind.name())),
        }
    };
    for (name, limit) in [("velocity", urdf.limits.velocity), ("effort", urdf.limits.effort)] {
        if let Some(limit) = limit.filter(|limit| *limit <= 0.0) {
            return refused(format!("`{name}` = {limit} must be positive; leave it out if there is no limit"));
        }
    }
    Ok(Joint {
        name: urdf.name.clone(),
        kind,
        lower,
        upper,
        velocity: urdf.limits.velocity.unwrap_or(f64::INFINITY),
        effort: urdf.limits.effort.unwrap_or(f64::INFINITY),
        before: IsometryMatrix3::identity(),
        axis: urdf.axis,
        link_inertia: RigidInertia::zero(),
        rotor_inertia: 0.0,
    })
}

/// Frame of the link of a joint beside the chain: it stays where it is zero, or at the limit next to that.
fn held(joint: &UrdfJoint) -> IsometryMatrix3<f64> {
    let lower = joint.limits.lower.unwrap_or(0.0);
    let upper = joint.limits.upper.unwrap_or(0.0);
    let position = 0f64.max(lower).min(upper);
    match joint.kind {
        UrdfKind::Revolute => JointKind::Revolute.motion(&joint.axis, position),
        UrdfKind::Prismatic => JointKind::Prismatic.motion(&joint.axis, position),
        UrdfKind::Continuous | UrdfKind::Fixed | UrdfKind::Floating | UrdfKind::Planar => IsometryMatrix3::identity(),
    }
}

fn without_mass(link: &UrdfLink) -> Fault {
    let name = &link.name;
    Fault::at(
        link.line,
        format!("link `{name}` moves and has no mass, nor has what is fixed to it: give it <inertial>"),
    )
}
