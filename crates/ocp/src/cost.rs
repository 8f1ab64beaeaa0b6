//! The cost (Sec. ocp:cost): for every trajectory `sum_k beta_1 |nu_k|^2 + beta_2 |omega_k|^2`, and
//! `beta_3 |rho_N - rho_goal|^2 + beta_4 |R(xi_N / |xi_N|) - R(xi_goal)|_F^2`.

use autodiff::{Expression, Tape};
use kkt::Owner;
use task::algebra::{dot, rotation};
use task::{AssemblyTask, CostWeights, POSE, Pose, TWIST};

use crate::block::Owners;
use crate::function::PointFunction;
use crate::layout::Layout;
use crate::least_squares::LeastSquares;
use crate::pattern::PatternBuilder;
use crate::point::{Point, Points};
use crate::term::Source;

/// Cost of the velocities of all trajectories at all stages.
pub fn running_cost(task: &AssemblyTask, layout: &Layout, hessian: &mut PatternBuilder) -> LeastSquares {
    let source = |input: usize, point: &Point| {
        let weights = weights(task, point.owner);
        match input {
            0..TWIST => Source::Variable(layout.state(point.stage, point.owner) + POSE + input),
            TWIST => Source::Constant(weights.translational_velocity.sqrt()),
            _ => Source::Constant(weights.rotational_velocity.sqrt()),
        }
    };
    let points = layout.points(Points::Stages(Owners::All));
    LeastSquares::new(PointFunction::new(running_residuals(), &points, source), hessian)
}

/// Cost of the distance of all trajectories from the goal at the last stage.
pub fn terminal_cost(task: &AssemblyTask, layout: &Layout, hessian: &mut PatternBuilder) -> LeastSquares {
    let source = |input: usize, point: &Point| {
        let weights = weights(task, point.owner);
        match input {
            0..POSE => Source::Variable(layout.state(point.stage, point.owner) + input),
            POSE => Source::Constant(weights.terminal_position.sqrt()),
            _ => Source::Constant(weights.terminal_orientation.sqrt()),
        }
    };
    let mut points = layout.points(Points::Stages(Owners::All));
    points.retain(|point| point.stage == layout.steps);
    LeastSquares::new(PointFunction::new(terminal_residuals(&task.goal), &points, source), hessian)
}

fn weights(task: &AssemblyTask, owner: Owner) -> CostWeights {
    match owner {
        Owner::Reference => task.cost.reference,
        Owner::Scenario(_) => task.cost.compliant,
    }
}

/// Residuals of the running cost: inputs twist (6) and the square roots of two weights; 6 outputs.
fn running_residuals() -> Tape {
    Tape::record(TWIST + 2, |inputs| (0..TWIST).map(|axis| inputs[axis] * inputs[TWIST + axis / 3]).collect())
}

/// Residuals of the terminal cost: inputs pose (7) and the square roots of two weights; outputs the weighted position
/// error (3) and rotation matrix error (9).
fn terminal_residuals(goal: &Pose) -> Tape {
    Tape::record(POSE + 2, |inputs| {
        let (pose, roots) = inputs.split_at(POSE);
        let mut residuals: Vec<Expression> = (0..3).map(|axis| (pose[axis] - goal[axis]) * roots[0]).collect();
        let actual = rotation(&normalised(&pose[3..]));
        let target = goal.rotation_matrix();
        for (row, actual_row) in actual.iter().enumerate() {
            for (column, &entry) in actual_row.iter().enumerate() {
                residuals.push((entry - target[(row, column)]) * roots[1]);
            }
        }
        residuals
    })
}

fn normalised<'tape>(quaternion: &[Expression<'tape>]) -> [Expression<'tape>; 4] {
    let norm = dot(quaternion, quaternion).sqrt();
    std::array::from_fn(|component| quaternion[component] / norm)
}
