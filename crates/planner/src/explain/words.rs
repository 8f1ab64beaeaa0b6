//! How directions, scenarios and constraints are named in messages.

use kkt::Owner;
use ocp::{
    ACCELERATION, CONTACT_FORCE, GAP, Member, POSE_DYNAMICS, PRODUCT, REFERENCE_KINEMATICS, TWIST_VARIABLES,
    VELOCITY_DYNAMICS, WRENCH,
};
use task::AssemblyTask;

const AXES: [&str; 3] = ["x", "y", "z"];
/// Components of a direction that are smaller than this share of the largest are not named.
const MINOR: f64 = 0.5;

/// What a constraint is, in words of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstraintName {
    /// What kind of constraint; limits have the name of their key.
    pub kind: &'static str,
    /// Unit of its value.
    pub unit: &'static str,
    /// `x`, `y` or `z`, or a component of the quaternion; nothing for contacts.
    pub axis: Option<&'static str>,
}

/// The name of a constraint of a task.
pub fn constraint(member: &Member, task: &AssemblyTask) -> ConstraintName {
    let Member { block, component, .. } = *member;
    let pose = |kind| match component {
        0..3 => ConstraintName { kind, unit: "m", axis: Some(AXES[component]) },
        _ => ConstraintName { kind, unit: "", axis: ["w", "x", "y", "z"].get(component - 3).copied() },
    };
    let twist = |axis: usize, [translation, rotation]: [(&'static str, &'static str); 2]| {
        let (kind, unit) = if axis < 3 { translation } else { rotation };
        ConstraintName { kind, unit, axis: Some(AXES[axis % 3]) }
    };
    let limited = |axes: Vec<(usize, f64)>| axes.get(component).map_or(component, |&(axis, _)| axis);
    match block {
        REFERENCE_KINEMATICS => pose("motion of the reference"),
        POSE_DYNAMICS => pose("motion of the body"),
        VELOCITY_DYNAMICS => twist(component, [("balance of forces", "m/s"), ("balance of torques", "rad/s")]),
        TWIST_VARIABLES => {
            twist(component, [("limits.translational_velocity", "m/s"), ("limits.rotational_velocity", "rad/s")])
        }
        ACCELERATION => twist(
            limited(task.limits.accelerations()),
            [("limits.translational_acceleration", "m/s^2"), ("limits.rotational_acceleration", "rad/s^2")],
        ),
        WRENCH => twist(limited(task.limits.wrenches()), [("limits.force", "N"), ("limits.torque", "Nm")]),
        GAP => ConstraintName { kind: "gap", unit: "m", axis: None },
        PRODUCT => ConstraintName { kind: "force x gap", unit: "N m", axis: None },
        CONTACT_FORCE => ConstraintName { kind: "contact force", unit: "N", axis: None },
        other => ConstraintName { kind: other, unit: "", axis: None },
    }
}

/// A constraint of a task with its place, such as `gap of box/wall in scenario 1 at 0.08 s`.
pub fn constraint_at(member: &Member, task: &AssemblyTask) -> String {
    let ConstraintName { kind, axis, .. } = constraint(member, task);
    let axis = axis.map_or_else(String::new, |axis| format!(" ({axis})"));
    let pair = member.pair.map_or_else(String::new, |pair| format!(" of {}", task.pairs[pair]));
    let owner = match member.owner {
        Owner::Reference => String::new(),
        Owner::Scenario(index) => format!(" in scenario {}", index + 1),
    };
    format!("{kind}{axis}{pair}{owner} at {:.2} s", member.stage as f64 * task.horizon.time_step)
}

/// A direction in words, such as `-z` or `+x and -z`; nothing for a vector without length.
pub fn direction(vector: &[f64; 3]) -> Option<String> {
    let largest = vector.iter().fold(0.0, |largest: f64, component| largest.max(component.abs()));
    let is_named = |component: f64| component.abs() > MINOR * largest;
    let named = (0..3).filter(|&axis| is_named(vector[axis]));
    let names = named.map(|axis| format!("{}{}", if vector[axis] < 0.0 { "-" } else { "+" }, AXES[axis]));
    let names: Vec<String> = names.collect();
    (largest > 0.0 && largest.is_finite()).then(|| names.join(" and "))
}

/// An axis in words: that of the world along which a unit vector lies, else the vector.
pub fn axis_name(direction: &[f64; 3]) -> String {
    /// Cosine of the angle to an axis of the world within which a direction has its name.
    const ALONG: f64 = 0.9999;
    match (0..3).find(|&axis| direction[axis].abs() > ALONG) {
        Some(axis) => AXES[axis].to_owned(),
        None => format!("({})", direction.map(|component| format!("{component:.2}")).join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_name_the_axes_that_matter() {
        assert_eq!(direction(&[0.0, 0.1, -1.0]).unwrap(), "-z");
        assert_eq!(direction(&[0.7, 0.0, -0.7]).unwrap(), "+x and -z");
        assert_eq!(direction(&[0.0; 3]), None);
        assert_eq!(direction(&[f64::NAN; 3]), None);
        assert_eq!(axis_name(&[0.0, -1.0, 0.001]), "y");
        assert_eq!(axis_name(&[0.6, -0.8, 0.0]), "(0.60, -0.80, 0.00)");
    }
}
