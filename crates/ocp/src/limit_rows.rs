//! The rows of limited accelerations and wrenches.

use crate::function::{ConstraintFunction, PointFunction, Source};
use crate::layout::{Layout, POSE, STATE, TWIST};
use crate::model;
use crate::pattern::PatternBuilder;
use crate::task::AssemblyTask;

/// The rows of limited accelerations and wrenches; nothing where nothing is limited.
pub fn limit_rows(
    task: &AssemblyTask,
    layout: Layout,
    jacobian: &mut PatternBuilder,
    hessian: &mut PatternBuilder,
) -> Vec<ConstraintFunction> {
    let axes = |limits: Vec<(usize, f64)>| -> Vec<usize> { limits.into_iter().map(|(axis, _)| axis).collect() };
    let (accelerations, wrenches) = (axes(task.limits.accelerations()), axes(task.limits.wrenches()));
    let mut rows = Vec::new();
    if !accelerations.is_empty() {
        let steps: Vec<(usize, usize)> = layout.stages_and_trajectories().collect();
        let row = |output: usize, point: usize| layout.acceleration(steps[point].0, steps[point].1) + output;
        rows.push(ConstraintFunction::new(acceleration(task, &accelerations, layout, &steps), row, jacobian, hessian));
    }
    if !wrenches.is_empty() {
        let steps: Vec<(usize, usize)> = layout.stages_and_scenarios().collect();
        let row = |output: usize, point: usize| layout.wrench(steps[point].0, steps[point].1) + output;
        rows.push(ConstraintFunction::new(wrench(task, &wrenches, layout, &steps), row, jacobian, hessian));
    }
    rows
}

/// Accelerations in steps, which are stages with their trajectories.
fn acceleration(task: &AssemblyTask, axes: &[usize], layout: Layout, steps: &[(usize, usize)]) -> PointFunction {
    let source = |input: usize, point: usize| {
        let (stage, trajectory) = steps[point];
        match input {
            // Everything starts at rest.
            0..TWIST if stage == 1 => Source::Constant(0.0),
            0..TWIST => Source::Variable(layout.state(stage - 1, trajectory) + POSE + input),
            _ => Source::Variable(layout.state(stage, trajectory) + POSE + input - TWIST),
        }
    };
    PointFunction::new(model::acceleration(task.horizon.time_step, axes), 2 * TWIST, steps.len(), source)
}

/// Wrenches in steps, which are stages with their scenarios.
fn wrench(task: &AssemblyTask, axes: &[usize], layout: Layout, steps: &[(usize, usize)]) -> PointFunction {
    let source = |input: usize, point: usize| {
        let (stage, scenario) = steps[point];
        match (input / STATE, input % STATE) {
            (0, component) => Source::Variable(layout.reference(stage) + component),
            (1, component) => Source::Variable(layout.compliant(stage, scenario) + component),
            (_, axis) => Source::Constant(task.offsets[scenario][axis]),
        }
    };
    PointFunction::new(model::wrench(&task.impedance, axes), 2 * STATE, steps.len(), source)
}
