//! The equations of the method, recorded as tapes: dynamics, impedance law, contact and cost.

use autodiff::{Expression, Tape};
use task::algebra::{apply, dot, rotation};
use task::{AssemblyTask, Impedance, Inertia, POSE, STATE, TWIST};

use crate::layout::CONTACT;

/// `q_r - q_r_prev - dt Q(q_r_prev) v_r` (Eq. discretizedOCP): inputs previous pose, pose, twist; 7 outputs.
pub fn reference_kinematics(time_step: f64) -> Tape {
    Tape::record(POSE + STATE, |inputs| {
        let (previous, rest) = inputs.split_at(POSE);
        let (pose, twist) = rest.split_at(POSE);
        kinematic_defect(previous, pose, previous, twist, time_step)
    })
}

/// Inputs of [`compliant_dynamics`] that are decision variables: previous state, state, reference state.
pub const COMPLIANT_VARIABLES: usize = 3 * STATE;

/// One step of a compliant body without contact (Eq. ts, Eq. impedancewrench): inputs previous state, state,
/// reference state and the offset (3, a parameter); outputs pose defect (7) and velocity defect (6).
pub fn compliant_dynamics(task: &AssemblyTask) -> Tape {
    let time_step = task.horizon.time_step;
    Tape::record(COMPLIANT_VARIABLES + 3, |inputs| {
        let (previous, rest) = inputs.split_at(STATE);
        let (state, rest) = rest.split_at(STATE);
        let (reference, offset) = rest.split_at(STATE);
        let (pose, twist) = state.split_at(POSE);
        let mut defects = kinematic_defect(&previous[..POSE], pose, pose, twist, time_step);
        let wrench = task.impedance.wrench(reference, state, offset);
        let acceleration = accelerate(&task.inertia, &wrench);
        for axis in 0..TWIST {
            defects.push(twist[axis] - previous[POSE + axis] - acceleration[axis] * time_step);
        }
        defects
    })
}

/// Some axes of the impedance wrench (Eq. impedancewrench): inputs reference state, compliant state, offset (3);
/// outputs of force (axes 0 to 2, world frame, N) and torque (3 to 5, body frame, Nm).
pub fn wrench(impedance: &Impedance, axes: &[usize]) -> Tape {
    Tape::record(2 * STATE + 3, |inputs| {
        let (reference, rest) = inputs.split_at(STATE);
        let (state, offset) = rest.split_at(STATE);
        let wrench = impedance.wrench(reference, state, offset);
        axes.iter().map(|&axis| wrench[axis]).collect()
    })
}

/// Some axes of the acceleration of a step: inputs previous twist and twist.
pub fn acceleration(time_step: f64, axes: &[usize]) -> Tape {
    Tape::record(2 * TWIST, |inputs| {
        let (previous, twist) = inputs.split_at(TWIST);
        axes.iter().map(|&axis| (twist[axis] - previous[axis]) * (1.0 / time_step)).collect()
    })
}

/// Inputs of [`contact`] that are decision variables: twist and contact force.
pub const CONTACT_VARIABLES: usize = TWIST + 1;

/// What one pair adds to a step (Eq. ts): inputs twist, contact force and contact information `(Phi, n~)` at the
/// previous pose; outputs its share of the velocity defect (6), the gap `a` and the product `a lambda_n` (Eq. ts3).
pub fn contact(task: &AssemblyTask) -> Tape {
    let time_step = task.horizon.time_step;
    Tape::record(CONTACT_VARIABLES + CONTACT, |inputs| {
        let (twist, rest) = inputs.split_at(TWIST);
        let (force, distance, normal) = (rest[0], rest[1], &rest[2..]);
        let wrench: [Expression; TWIST] = std::array::from_fn(|axis| normal[axis] * force);
        let acceleration = accelerate(&task.inertia, &wrench);
        let mut outputs: Vec<Expression> = acceleration.iter().map(|&value| value * -time_step).collect();
        let gap = distance + dot(normal, twist) * time_step;
        outputs.push(gap);
        outputs.push(gap * force);
        outputs
    })
}

/// Residuals of the running cost: inputs twist and the square roots of two weights; 6 outputs.
pub fn running_residuals() -> Tape {
    Tape::record(TWIST + 2, |inputs| (0..TWIST).map(|axis| inputs[axis] * inputs[TWIST + axis / 3]).collect())
}

/// Residuals of the terminal cost (Sec. ocp:cost): inputs pose and the square roots of two weights; outputs the
/// weighted position error (3) and rotation matrix error (9).
pub fn terminal_residuals(goal: &[f64; POSE]) -> Tape {
    Tape::record(POSE + 2, |inputs| {
        let (pose, roots) = inputs.split_at(POSE);
        let mut residuals: Vec<Expression> = (0..3).map(|axis| (pose[axis] - goal[axis]) * roots[0]).collect();
        let actual = rotation(&normalised(&pose[3..]));
        let target = task::pose::rotation_matrix(&[goal[3], goal[4], goal[5], goal[6]]);
        for (row, actual_row) in actual.iter().enumerate() {
            for (column, &entry) in actual_row.iter().enumerate() {
                residuals.push((entry - target[(row, column)]) * roots[1]);
            }
        }
        residuals
    })
}

/// `q - q_prev - dt Q(q_at) v` with `Q = blkdiag(I, E(xi) / 2)`: 7 expressions.
fn kinematic_defect<'tape>(
    previous: &[Expression<'tape>],
    pose: &[Expression<'tape>],
    kinematics_at: &[Expression<'tape>],
    twist: &[Expression<'tape>],
    time_step: f64,
) -> Vec<Expression<'tape>> {
    let mut defects: Vec<_> = (0..3).map(|axis| pose[axis] - previous[axis] - twist[axis] * time_step).collect();
    let [w, x, y, z] = [kinematics_at[3], kinematics_at[4], kinematics_at[5], kinematics_at[6]];
    let [p, q, r] = [twist[3], twist[4], twist[5]];
    let rates = [-(x * p) - y * q - z * r, w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p];
    for (component, rate) in rates.into_iter().enumerate() {
        defects.push(pose[3 + component] - previous[3 + component] - rate * (0.5 * time_step));
    }
    defects
}

/// `M^-1` times a wrench.
fn accelerate<'tape>(inertia: &Inertia, wrench: &[Expression<'tape>; TWIST]) -> [Expression<'tape>; TWIST] {
    let inverse = inertia.rotational.try_inverse().expect("a validated rotational inertia is positive definite");
    let rotational = apply(&inverse, &wrench[3..]);
    std::array::from_fn(|axis| if axis < 3 { wrench[axis] * (1.0 / inertia.mass) } else { rotational[axis - 3] })
}

fn normalised<'tape>(quaternion: &[Expression<'tape>]) -> [Expression<'tape>; 4] {
    let norm = dot(quaternion, quaternion).sqrt();
    std::array::from_fn(|component| quaternion[component] / norm)
}
