//! Plans of problems that nothing has to be solved for.

use simulation::Reference;

use crate::error::PlannerError;
use crate::iteration::{IterationRecord, PlanIteration, Split};
use crate::plan::{Plan, Stop};
use crate::problem::Problem;
use crate::variant::Variant;

/// A reference as the plan of a problem, with the motion that it leads to in each scenario. Its homotopy is a single step
/// without iterations.
///
/// # Errors
/// When an arm does not reach the start.
pub fn unsolved(problem: &Problem, reference: &Reference, threads: usize) -> Result<Plan, PlannerError> {
    let mut variant = Variant::of_scene(problem);
    variant.task.horizon = reference.horizon();
    let settings = &variant.settings;
    let smoothing = settings.schedule().next().ok_or(PlannerError::Internal("a homotopy without steps"))?;
    let trajectory = problem.motions(&variant.task, reference, smoothing.tau)?;
    let record = IterationRecord {
        steps: variant.task.horizon.steps,
        time_step_s: variant.task.horizon.time_step,
        tau: smoothing.tau,
        sigma: smoothing.sigma,
        mu_init: smoothing.mu_init,
        status: "not solved".to_owned(),
        converged: false,
        message: None,
        iterations: 0,
        objective: f64::NAN,
        constraint_violation: f64::NAN,
        max_penetration_m: trajectory.max_penetration(),
        wall_s: 0.0,
        wall_split_s: Split { distances: 0.0, model: 0.0, linear_solver: 0.0, rest: 0.0 },
        linear_solver: settings.linear_solver.name().to_owned(),
        stage_solver: None,
    };
    let iteration = PlanIteration { record, trajectory, point: None };
    Ok(Plan::new(problem, variant, vec![iteration], threads, Some(Stop::Unsolved)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::PlanStatus;
    use crate::problem::Choices;
    use crate::testing::corner;

    #[test]
    fn a_reference_is_a_plan_with_the_motions_of_its_rollouts() {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let task = problem.task();
        let push = Reference::straight(&task.start, &task.goal, task.horizon);
        let plan = unsolved(&problem, &push, 1).unwrap();
        let place = |reference: &Reference, knot: usize| reference.at(knot, 0.0).pose.translation.vector;
        assert!((0..=push.intervals()).all(|knot| place(&plan.reference(), knot) == place(&push, knot)));
        assert_eq!((plan.stopped, plan.iterations[0].record.iterations), (Some(Stop::Unsolved), 0));
        assert!(matches!(plan.status(), PlanStatus::NotConverged { .. }), "solving nothing is no plan of the solver");
        assert_eq!(plan.trajectory.scenarios.len(), task.scenarios().len());
    }
}
