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
        rows.push(acceleration_rows(task, &accelerations, layout, jacobian, hessian));
    }
    if !wrenches.is_empty() {
        rows.push(wrench_rows(task, &wrenches, layout, jacobian, hessian));
    }
    rows
}

fn acceleration_rows(
    task: &AssemblyTask,
    axes: &[usize],
    layout: Layout,
    jacobian: &mut PatternBuilder,
    hessian: &mut PatternBuilder,
) -> ConstraintFunction {
    let steps: Vec<(usize, usize)> = layout.stages_and_trajectories().collect();
    let source = |input: usize, point: usize| {
        let (stage, trajectory) = steps[point];
        match input {
            // Everything starts at rest.
            0..TWIST if stage == 1 => Source::Constant(0.0),
            0..TWIST => Source::Variable(layout.state(stage - 1, trajectory) + POSE + input),
            _ => Source::Variable(layout.state(stage, trajectory) + POSE + input - TWIST),
        }
    };
    let tape = model::acceleration(task.horizon.time_step, axes);
    let function = PointFunction::new(tape, 2 * TWIST, steps.len(), source);
    let row = |output: usize, point: usize| layout.acceleration(steps[point].0, steps[point].1) + output;
    ConstraintFunction::new(function, row, jacobian, hessian)
}

fn wrench_rows(
    task: &AssemblyTask,
    axes: &[usize],
    layout: Layout,
    jacobian: &mut PatternBuilder,
    hessian: &mut PatternBuilder,
) -> ConstraintFunction {
    let steps: Vec<(usize, usize)> = layout.stages_and_scenarios().collect();
    let source = |input: usize, point: usize| {
        let (stage, scenario) = steps[point];
        match (input / STATE, input % STATE) {
            (0, component) => Source::Variable(layout.reference(stage) + component),
            (1, component) => Source::Variable(layout.compliant(stage, scenario) + component),
            (_, axis) => Source::Constant(task.offsets[scenario][axis]),
        }
    };
    let function = PointFunction::new(model::wrench(&task.impedance, axes), 2 * STATE, steps.len(), source);
    let row = |output: usize, point: usize| layout.wrench(steps[point].0, steps[point].1) + output;
    ConstraintFunction::new(function, row, jacobian, hessian)
}
