//! The stage-structured linear solver for a transcription, with the labels of its linear systems.

use kkt::{Class, Label, StageSolver, StructureError};
use nlp::{AnalysisError, Factorisation, KktSolver};
use task::LinearSolver;
use workers::Workers;

use crate::layout::Layout;

/// The linear solver of one solve: [`kkt::StageSolver`] as Ipopt calls it.
pub struct TranscriptionSolver {
    labels: Vec<Label>,
    workers: Workers,
    solver: Option<StageSolver>,
}

impl TranscriptionSolver {
    /// A solver for transcriptions of a layout, with some threads.
    pub fn new(layout: &Layout, workers: Workers) -> Self {
        Self { labels: labels(layout), workers, solver: None }
    }

    /// Statistics, once the solver has a pattern.
    pub fn report(&self) -> Option<&kkt::Report> {
        self.solver.as_ref().map(StageSolver::report)
    }
}

impl KktSolver for TranscriptionSolver {
    fn name(&self) -> &str {
        LinearSolver::Stage.name()
    }

    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError> {
        if dimension != self.labels.len() {
            return Err(StructureError::Dimension { labels: self.labels.len(), dimension }.into());
        }
        self.solver = Some(StageSolver::with_workers(&self.labels, rows, columns, self.workers.clone())?);
        Ok(())
    }

    fn factorise(&mut self, values: &[f64]) -> Factorisation {
        match self.solver.as_mut().map(|solver| solver.factorise(values)) {
            Some(kkt::Factorisation::Inertia { negative }) => Factorisation::Inertia { negative },
            Some(kkt::Factorisation::Singular) => Factorisation::Singular,
            Some(kkt::Factorisation::Failed) | None => Factorisation::Failed,
        }
    }

    fn solve(&mut self, values: &mut [f64]) -> bool {
        self.solver.as_mut().is_some_and(|solver| solver.solve(values))
    }

    fn increase_quality(&mut self) {
        if let Some(solver) = &mut self.solver {
            solver.increase_quality();
        }
    }
}

/// Labels in Ipopt's order of rows: variables, slacks of inequalities, multipliers of equalities, multipliers of
/// inequalities.
fn labels(layout: &Layout) -> Vec<Label> {
    let mut labels = layout.variable_labels();
    let multipliers = layout.multiplier_labels();
    let inequalities = multipliers.iter().filter(|label| label.class == Class::InequalityMultiplier);
    labels.extend(inequalities.clone().map(|&label| Label { class: Class::InequalitySlack, ..label }));
    labels.extend(multipliers.iter().filter(|label| label.class != Class::InequalityMultiplier));
    labels.extend(inequalities);
    labels
}
