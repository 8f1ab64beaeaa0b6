//! The rows of limited accelerations and wrenches.

use nlp::Bounds;
use task::{AssemblyTask, Limits, POSE, STATE, TWIST};

use crate::function::{ConstraintFunction, PointFunction, Source};
use crate::layout::Layout;
use crate::model;
use crate::pattern::PatternBuilder;

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

/// Sets the bounds of velocities and contact forces.
pub fn bound_variables(limits: &Limits, layout: Layout, bounds: &mut Bounds) {
    for (stage, trajectory) in layout.stages_and_trajectories() {
        for (axis, limit) in limits.velocities() {
            bound(bounds, layout.state(stage, trajectory) + POSE + axis, limit);
        }
    }
    for (stage, scenario) in layout.stages_and_scenarios() {
        bounds.upper[layout.contact_force(stage, scenario, 0)..][..layout.pairs].fill(limits.contact_force);
    }
}

/// Sets the bounds of the rows of accelerations and wrenches.
pub fn bound_rows(limits: &Limits, layout: Layout, bounds: &mut Bounds) {
    for (stage, trajectory) in layout.stages_and_trajectories() {
        for (row, (_, limit)) in limits.accelerations().into_iter().enumerate() {
            bound(bounds, layout.acceleration(stage, trajectory) + row, limit);
        }
    }
    for (stage, scenario) in layout.stages_and_scenarios() {
        for (row, (_, limit)) in limits.wrenches().into_iter().enumerate() {
            bound(bounds, layout.wrench(stage, scenario) + row, limit);
        }
    }
}

fn bound(bounds: &mut Bounds, index: usize, limit: f64) {
    (bounds.lower[index], bounds.upper[index]) = (-limit, limit);
}
