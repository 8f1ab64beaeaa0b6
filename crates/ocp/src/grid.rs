//! Coarse and fine time grids: the first homotopy steps are solved with fewer time steps, and their primal-dual point
//! is transferred to all time steps.
//!
//! Poses and velocities are nodal values and the multipliers of their dynamics are costates; both are interpolated.
//! Contact forces and the multipliers of all other constraints and bounds belong to the time step that ends at a knot:
//! a force is held for the whole step, a multiplier is divided among the fine steps.

use kkt::{Class, Label, Owner};
use nlp::Iterate;
use task::{AssemblyTask, CostWeights, Horizon, STATE};

use crate::block::Owners;
use crate::formulation::Formulation;

/// Fewest steps of a coarse grid.
const FEWEST_STEPS: usize = 25;

/// The task on half of the steps (rounded up) of the same horizon, if these are enough. Running costs are sums over
/// steps, so that each of the fewer steps has a larger weight.
pub fn coarsened(task: &AssemblyTask) -> Option<AssemblyTask> {
    let Horizon { steps: fine, time_step } = task.horizon;
    let steps = fine.div_ceil(2);
    if steps < FEWEST_STEPS {
        return None;
    }
    let ratio = fine as f64 / steps as f64;
    let mut coarse = task.clone();
    coarse.horizon = Horizon { steps, time_step: time_step * ratio };
    coarse.cost.reference = heavier(&task.cost.reference, ratio);
    coarse.cost.compliant = heavier(&task.cost.compliant, ratio);
    Some(coarse)
}

fn heavier(weights: &CostWeights, ratio: f64) -> CostWeights {
    CostWeights {
        translational_velocity: weights.translational_velocity * ratio,
        rotational_velocity: weights.rotational_velocity * ratio,
        ..*weights
    }
}

/// Transfers a primal-dual point of one formulation to the grid of another one of the same task, both with all contacts.
pub fn transferred(point: &Iterate, from: &Formulation, to: &Formulation) -> Iterate {
    let (coarse, fine) = (from.layout(), to.layout());
    let share = coarse.steps as f64 / fine.steps as f64;
    let (variables, multipliers) = (fine.variable_labels(), fine.multiplier_labels());
    let on_fine = |values: &[f64], initial: &[f64], labels: &[Label], rule: &dyn Fn(Class) -> Rule| {
        let length = initial.len();
        let value = |(index, label): (usize, &Label)| {
            let member = index % length;
            // The end of the fine step lies in a coarse step, at this fraction of it.
            let passed = label.stage * coarse.steps;
            let stage = passed.div_ceil(fine.steps);
            let fraction = passed as f64 / fine.steps as f64 - (stage - 1) as f64;
            let after = values[(stage - 1) * length + member];
            match rule(label.class) {
                Rule::Interpolate if stage == 1 => initial[member] + fraction * (after - initial[member]),
                Rule::Interpolate => {
                    let before = values[(stage - 2) * length + member];
                    before + fraction * (after - before)
                }
                Rule::Hold => after,
                Rule::Share => share * after,
            }
        };
        labels.iter().enumerate().map(value).collect()
    };
    let stage = |values: &[f64]| values[..values.len() / coarse.steps].to_vec();
    let of_bounds = |values: &[f64]| on_fine(values, &stage(values), &variables, &|_| Rule::Share);
    Iterate {
        x: on_fine(&point.x, &initial_stage(from, stage(&point.x)), &variables, &of_variable),
        constraint_multipliers: on_fine(
            &point.constraint_multipliers,
            &stage(&point.constraint_multipliers),
            &multipliers,
            &of_multiplier,
        ),
        lower_multipliers: of_bounds(&point.lower_multipliers),
        upper_multipliers: of_bounds(&point.upper_multipliers),
    }
}

/// How a value is transferred.
enum Rule {
    /// Linearly between the ends of the coarse step.
    Interpolate,
    /// The same in all fine steps of the coarse step.
    Hold,
    /// Divided among the fine steps of the coarse step.
    Share,
}

fn of_variable(class: Class) -> Rule {
    match class {
        Class::Pose | Class::Velocity => Rule::Interpolate,
        _ => Rule::Hold,
    }
}

fn of_multiplier(class: Class) -> Rule {
    match class {
        Class::PoseMultiplier | Class::VelocityMultiplier => Rule::Interpolate,
        _ => Rule::Share,
    }
}

/// The variables of the first knot with the states before the first step.
fn initial_stage(formulation: &Formulation, mut variables: Vec<f64>) -> Vec<f64> {
    let layout = formulation.layout();
    for (stage, owner) in layout.stages_of(Owners::All).take_while(|&(stage, _)| stage == 1) {
        let state = match owner {
            Owner::Reference => formulation.task().start.at_rest(),
            Owner::Scenario(scenario) => formulation.initial_compliant()[scenario],
        };
        variables[layout.state(stage, owner)..][..STATE].copy_from_slice(&state[..]);
    }
    variables
}

#[cfg(test)]
mod tests {
    use task::Complementarity;

    use super::*;

    fn task(steps: usize) -> AssemblyTask {
        let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
        let mut task = scene::Scene::load(&file).unwrap().task(None, None).unwrap();
        task.horizon = Horizon { steps, time_step: 0.02 };
        task
    }

    #[test]
    fn a_coarse_grid_covers_the_same_time_with_half_of_the_steps() {
        let coarse = coarsened(&task(61)).unwrap();
        assert_eq!(coarse.horizon.steps, 31);
        assert!((coarse.horizon.time_step * 31.0 - 0.02 * 61.0).abs() < 1e-12);
        let ratio = coarse.cost.compliant.translational_velocity / task(61).cost.compliant.translational_velocity;
        assert!((ratio * 31.0 - 61.0).abs() < 1e-9, "running costs keep their sum");
        assert!(coarsened(&task(48)).is_none(), "too few steps");
    }

    #[test]
    fn motions_at_constant_velocity_and_constant_forces_are_carried_over_exactly() {
        let fine_task = task(61);
        let coarse_task = coarsened(&fine_task).unwrap();
        let formulate = |task| Formulation::new(task, Complementarity::Relaxation);
        let (from, to) = (formulate(&coarse_task), formulate(&fine_task));
        // Poses and velocities grow with time, everything else is one.
        let filled = |formulation: &Formulation| -> Vec<f64> {
            let (layout, start) = (formulation.layout(), initial_stage(formulation, formulation.initial_guess()));
            let labels = layout.variable_labels();
            let length = labels.len() / layout.steps;
            let value = |(index, label): (usize, &Label)| match label.class {
                Class::Pose | Class::Velocity => start[index % length] + label.stage as f64 / layout.steps as f64,
                _ => 1.0,
            };
            labels.iter().enumerate().map(value).collect()
        };
        let x = filled(&from);
        let constraint_multipliers = vec![61.0; from.layout().constraint_count()];
        let bounds = vec![61.0; x.len()];
        let point = Iterate { x, constraint_multipliers, lower_multipliers: bounds.clone(), upper_multipliers: bounds };
        let carried = transferred(&point, &from, &to);
        for (value, expected) in carried.x.iter().zip(filled(&to)) {
            assert!((value - expected).abs() < 1e-12, "{value} {expected}");
        }
        assert!(carried.lower_multipliers.iter().all(|multiplier| (multiplier - 31.0).abs() < 1e-9));
        for (label, multiplier) in to.layout().multiplier_labels().iter().zip(&carried.constraint_multipliers) {
            let is_costate = matches!(label.class, Class::PoseMultiplier | Class::VelocityMultiplier);
            let expected = if is_costate { 61.0 } else { 31.0 };
            assert!((multiplier - expected).abs() < 1e-9);
        }
    }
}
