//! How constraints are named in messages.

use kkt::Owner;
use ocp::{
    ACCELERATION, CONTACT_FORCE, GAP, Member, POSE_DYNAMICS, PRODUCT, REFERENCE_KINEMATICS, TWIST_VARIABLES,
    VELOCITY_DYNAMICS, WRENCH,
};
use plan::directions::AXES;
use task::AssemblyTask;

/// A constraint in words of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstraintName {
    /// Kind of the constraint; limits have the name of their key.
    pub kind: &'static str,
    /// Unit of its value.
    pub unit: &'static str,
    /// `x`, `y` or `z`, or a component of the quaternion; `None` for contacts.
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
