//! Refinements that resume where another run has stopped.

use std::time::Duration;

use plan::records::GraspRecord;
use plan::{Event, IterationRecord, Plan, PlanIteration, PlannerError, Round, Unusable};
use simulation::{Reference, TestCase};
use task::GraspError;

use crate::candidate::Evaluated;
use crate::checkpoint::{BestRecord, HomotopyRecord, RefinementCheckpoint, TestCaseRecord};
use crate::origin::Solved;
use crate::schedule::Schedule;
use crate::search::Search;
use crate::setting::Setting;

/// The checkpoint of the refinement.
pub fn checkpoint(search: &Search, best: &Evaluated, rounds: Vec<Round>) -> RefinementCheckpoint {
    let Setting { problem, target, .. } = search.setting;
    let (success, variant) = (problem.success(), &best.solved.variant);
    RefinementCheckpoint {
        identity: problem.identity().to_owned(),
        frictions: target.frictions.clone(),
        turn_rad: target.rotation_error,
        inertia_error: target.inertia_error,
        stiffness_error: target.stiffness_error,
        delay_s: target.delay,
        bias: target.bias,
        edge_radius_m: problem.edge_radius(),
        parameters: target.parameters.clone(),
        tolerance: [success.position, success.orientation],
        elapsed_s: search.schedule.total().as_secs_f64(),
        evaluations: search.judge.evaluations,
        before: search.found.before.clone(),
        training: search.training.cases.iter().map(TestCaseRecord::from).collect(),
        tables: search.found.tables.clone(),
        best: BestRecord {
            origin: best.solved.origin,
            marks: best.solved.marks,
            scenarios: variant.task.grasps.iter().map(GraspRecord::from).collect(),
            planned_frictions: variant.task.frictions.clone(),
            steps: variant.task.horizon.steps,
            time_step_s: variant.task.horizon.time_step,
            reference_weights: variant.task.cost.reference.into(),
            compliant_weights: variant.task.cost.compliant.into(),
            homotopy: HomotopyRecord::from(&variant.settings),
            iterations: best.solved.iterations.iter().map(|iteration| iteration.record.clone()).collect(),
            reference: best.reference.states(),
            rates: best.rates.clone(),
            reached: best.reached,
            evaluation: best.evaluation,
            unplayed: best.unplayed,
            failing: best.failing.iter().map(TestCaseRecord::from).collect(),
            round: best.round,
            chosen_stage: best.solved.chosen,
            perturbations: best.perturbations,
        },
        rounds,
    }
}

/// The checkpoint of an earlier run, if it was refined for the same target.
pub fn earlier_work(search: &Search) -> Result<Option<RefinementCheckpoint>, PlannerError> {
    let Setting { problem, target, session, .. } = search.setting;
    let Some(folder) = session.folder else { return Ok(None) };
    let success = problem.success();
    let reason = match RefinementCheckpoint::load(folder, problem.identity()) {
        Ok(None) => return Ok(None),
        Ok(Some(checkpoint)) => {
            let same = checkpoint.frictions == target.frictions
                && checkpoint.turn_rad == target.rotation_error
                && checkpoint.inertia_error == target.inertia_error
                && checkpoint.stiffness_error == target.stiffness_error
                && checkpoint.delay_s == target.delay
                && checkpoint.bias == target.bias
                && checkpoint.edge_radius_m == problem.edge_radius()
                && checkpoint.parameters == target.parameters
                && checkpoint.tolerance == [success.position, success.orientation];
            if same {
                return Ok(Some(checkpoint));
            }
            Unusable::OtherTarget
        }
        Err(reason) => reason,
    };
    session.tell(Event::Discarded { reason });
    Ok(None)
}

/// Restores the work of an earlier run, unless its tables are damaged; `plan` is that of the scene itself.
pub fn restore(search: &mut Search, checkpoint: RefinementCheckpoint, plan: &Plan) -> Option<Evaluated> {
    let RefinementCheckpoint { elapsed_s, evaluations, before, training, rounds, tables, best, .. } = checkpoint;
    let Setting { target, session, .. } = search.setting;
    let mut variant = plan.variant.clone();
    variant.task.grasps = best.scenarios.iter().map(GraspError::from).collect();
    variant.task.frictions = best.planned_frictions;
    variant.task.horizon.steps = best.steps;
    variant.task.horizon.time_step = best.time_step_s;
    variant.task.cost.reference = best.reference_weights.into();
    variant.task.cost.compliant = best.compliant_weights.into();
    variant.settings = best.homotopy.applied_to(variant.settings);
    let iterations = match (best.origin.has_homotopy_of_scene(), session.folder) {
        (false, Some(folder)) => {
            let read = |(number, record): (usize, IterationRecord)| {
                let task = record.task(&variant.task);
                let trajectory = folder.refined(best.round, number, &task)?;
                Ok(PlanIteration { record, trajectory, point: None })
            };
            let iterations: Result<_, PlannerError> = (1..).zip(best.iterations).map(read).collect();
            if iterations.is_err() {
                session.tell(Event::Discarded { reason: Unusable::DamagedRefinementTables });
            }
            iterations.ok()?
        }
        _ => plan.iterations.clone(),
    };
    let earlier = Duration::try_from_secs_f64(elapsed_s).unwrap_or_default();
    search.schedule = Schedule::new(session, target.time_limit, target.parameters.time).after(earlier);
    search.judge.evaluations = evaluations;
    search.found.before = before;
    search.training.cases = training.iter().map(TestCase::from).collect();
    search.found.rounds = rounds;
    search.found.tables = tables;
    Some(Evaluated {
        reference: Reference::new(best.time_step_s, &best.reference),
        solved: Solved { origin: best.origin, marks: best.marks, variant, iterations, chosen: best.chosen_stage },
        rates: best.rates,
        reached: best.reached,
        evaluation: best.evaluation,
        unplayed: best.unplayed,
        failing: best.failing.iter().map(TestCase::from).collect(),
        round: best.round,
        perturbations: best.perturbations,
    })
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use fastrand::Rng;
    use plan::{Variant, solve};

    use super::*;
    use crate::draft::Draft;
    use crate::evaluation::{ErrorRange, Evaluation, Wanted};
    use crate::origin::Origin;
    use crate::tests::in_corner;

    #[test]
    fn a_resumed_draft_has_the_weights_and_the_smoothing_that_made_it() {
        in_corner(Duration::from_secs(1000), |search| {
            let Setting { problem, target, session, .. } = search.setting;
            let plan = solve(problem, session).unwrap();
            let parameters = &target.parameters.drafts;
            let draft = Draft::random(&mut Rng::with_seed(1), 0.3, parameters);
            let mut variant = draft.variant(&Variant::of_scene(problem), parameters);
            (variant.settings.tau, variant.settings.sigma) = (0.5 * variant.settings.tau, 0.5 * variant.settings.sigma);
            let solved = Solved::new(Origin::Draft(draft), variant.clone(), plan.iterations.clone());
            let evaluation =
                Evaluation::new(problem.task(), &ErrorRange::new(problem, target), &target.frictions, 1, 1);
            let unplayed = evaluation.judgement(&[], Wanted::target(target));
            let best = Evaluated::new(solved, plan.reference(), &unplayed, 1, 0);
            let restored = restore(search, checkpoint(search, &best, Vec::new()), &plan).unwrap().solved.variant;
            assert_ne!(variant.task.cost, plan.variant.task.cost);
            assert_eq!(restored.task.cost, variant.task.cost);
            assert_eq!(restored.settings, variant.settings);
            assert_eq!((restored.task.grasps, restored.task.horizon), (variant.task.grasps, variant.task.horizon));
        });
    }
}
