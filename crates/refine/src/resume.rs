//! Refinements that go on where another run has stopped.

use std::time::Duration;

use plan::records::GraspRecord;
use plan::{Event, IterationRecord, Plan, PlanIteration, PlannerError, Round, Unusable};
use simulation::{Reference, TestCase};
use task::GraspError;

use crate::Refiner;
use crate::candidate::Kept;
use crate::checkpoint::{BestRecord, RefinementCheckpoint, TestCaseRecord};
use crate::origin::Solved;
use crate::schedule::Schedule;

impl Refiner<'_> {
    /// What is to be kept of the refinement.
    pub(super) fn checkpoint(&self, kept: &Kept, rounds: Vec<Round>) -> RefinementCheckpoint {
        let success = self.problem.success();
        RefinementCheckpoint {
            identity: self.problem.identity().to_owned(),
            frictions: self.target.frictions.clone(),
            turn_rad: self.target.rotation_error,
            inertia_error: self.target.inertia_error,
            stiffness_error: self.target.stiffness_error,
            delay_s: self.target.delay,
            edge_radius_m: self.problem.edge_radius(),
            parameters: self.target.parameters.clone(),
            tolerance: [success.position, success.orientation],
            elapsed_s: self.schedule.total().as_secs_f64(),
            evaluations: self.evaluations,
            before: self.before.clone(),
            training: self.training.iter().map(TestCaseRecord::from).collect(),
            best: BestRecord {
                origin: kept.solved.origin,
                marks: kept.solved.marks,
                scenarios: kept.solved.variant.task.grasps.iter().map(GraspRecord::from).collect(),
                planned_frictions: kept.solved.variant.task.frictions.clone(),
                steps: kept.solved.variant.task.horizon.steps,
                time_step_s: kept.solved.variant.task.horizon.time_step,
                homotopy_iterations: kept.solved.variant.settings.iterations,
                iterations: kept.solved.iterations.iter().map(|iteration| iteration.record.clone()).collect(),
                reference: kept.reference.states(),
                rates: kept.rates.clone(),
                reached: kept.reached,
                evaluation: kept.evaluation,
                unplayed: kept.unplayed,
                failing: kept.failing.iter().map(TestCaseRecord::from).collect(),
                round: kept.round,
                chosen_stage: kept.solved.chosen,
                changes: kept.changes,
            },
            rounds,
        }
    }

    /// What another run has left, if it was refined for the same target.
    pub(super) fn earlier_work(&self) -> Result<Option<RefinementCheckpoint>, PlannerError> {
        let Some(folder) = self.session.folder else { return Ok(None) };
        let success = self.problem.success();
        let reason = match RefinementCheckpoint::load(folder, self.problem.identity()) {
            Ok(None) => return Ok(None),
            Ok(Some(checkpoint)) => {
                let same = checkpoint.frictions == self.target.frictions
                    && checkpoint.turn_rad == self.target.rotation_error
                    && checkpoint.inertia_error == self.target.inertia_error
                    && checkpoint.stiffness_error == self.target.stiffness_error
                    && checkpoint.delay_s == self.target.delay
                    && checkpoint.edge_radius_m == self.problem.edge_radius()
                    && checkpoint.parameters == self.target.parameters
                    && checkpoint.tolerance == [success.position, success.orientation];
                if same {
                    return Ok(Some(checkpoint));
                }
                Unusable::OtherTarget
            }
            Err(reason) => reason,
        };
        self.session.tell(Event::Discarded { reason });
        Ok(None)
    }

    /// Takes over what another run has left, unless its tables are damaged; `plan` is that of the scene itself.
    pub(super) fn restore(&mut self, checkpoint: RefinementCheckpoint, plan: &Plan) -> Option<Kept> {
        let RefinementCheckpoint { elapsed_s, evaluations, before, training, rounds, best, .. } = checkpoint;
        let mut variant = plan.variant.clone();
        variant.task.grasps = best.scenarios.iter().map(GraspError::from).collect();
        variant.task.frictions = best.planned_frictions;
        variant.task.horizon.steps = best.steps;
        variant.task.horizon.time_step = best.time_step_s;
        variant.settings.iterations = best.homotopy_iterations;
        let iterations = match (best.origin.has_homotopy_of_scene(), self.session.folder) {
            (false, Some(folder)) => {
                let read = |(number, record): (usize, IterationRecord)| {
                    let task = record.task(&variant.task);
                    let trajectory = folder.refined(best.round, number, &task)?;
                    Ok(PlanIteration { record, trajectory, point: None })
                };
                let iterations: Result<_, PlannerError> = (1..).zip(best.iterations).map(read).collect();
                if iterations.is_err() {
                    self.session.tell(Event::Discarded { reason: Unusable::DamagedRefinementTables });
                }
                iterations.ok()?
            }
            _ => plan.iterations.clone(),
        };
        let earlier = Duration::try_from_secs_f64(elapsed_s).unwrap_or_default();
        self.schedule = Schedule::new(self.session, self.target.time_limit, self.target.parameters.time).after(earlier);
        self.evaluations = evaluations;
        self.before = before;
        self.training = training.iter().map(TestCase::from).collect();
        self.rounds = rounds;
        Some(Kept {
            reference: Reference::new(best.time_step_s, &best.reference),
            solved: Solved { origin: best.origin, marks: best.marks, variant, iterations, chosen: best.chosen_stage },
            rates: best.rates,
            reached: best.reached,
            evaluation: best.evaluation,
            unplayed: best.unplayed,
            failing: best.failing.iter().map(TestCase::from).collect(),
            round: best.round,
            changes: best.changes,
        })
    }
}
