//! The stage-structured linear solver for a transcription: says what every row of its linear systems is.

use std::ops::Range;

use kkt::{Class, Label, Owner, StageSolver};
use nlp::{Factorisation, KktSolver};
use task::{Complementarity, LinearSolver, POSE, STATE, TWIST};

use crate::layout::Layout;

/// The linear solver of one solve.
pub struct TranscriptionSolver {
    labels: Vec<Label>,
    solver: Option<StageSolver>,
}

impl TranscriptionSolver {
    /// For a transcription with this layout.
    pub fn new(layout: Layout, complementarity: Complementarity) -> Self {
        Self { labels: labels(layout, complementarity), solver: None }
    }

    /// What the solver has done.
    pub fn report(&self) -> Option<&kkt::Report> {
        self.solver.as_ref().map(StageSolver::report)
    }
}

impl KktSolver for TranscriptionSolver {
    fn name(&self) -> &str {
        LinearSolver::Stage.name()
    }

    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), String> {
        if dimension != self.labels.len() {
            return Err(format!("Ipopt's linear systems have {dimension} rows, {} were expected", self.labels.len()));
        }
        let solver = StageSolver::new(&self.labels, rows, columns).map_err(|error| error.to_string())?;
        self.solver = Some(solver);
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

/// Labels in Ipopt's order of rows: variables, slacks of inequalities, multipliers of equalities, of inequalities.
fn labels(layout: Layout, complementarity: Complementarity) -> Vec<Label> {
    let mut labels = variables(layout);
    let constraints = constraints(layout, complementarity);
    let inequalities = constraints.iter().filter(|label| label.class == Class::InequalityMultiplier);
    labels.extend(inequalities.clone().map(|&label| Label { class: Class::InequalitySlack, ..label }));
    labels.extend(constraints.iter().filter(|label| label.class != Class::InequalityMultiplier));
    labels.extend(inequalities);
    labels
}

fn variables(layout: Layout) -> Vec<Label> {
    let blank = Label { stage: 0, owner: Owner::Reference, class: Class::Pose, index: 0 };
    let mut labels = vec![blank; layout.variable_count()];
    for stage in layout.stages() {
        label_state(&mut labels[layout.reference(stage)..], stage, Owner::Reference);
        for scenario in 0..layout.scenarios {
            let owner = Owner::Scenario(scenario);
            let start = layout.compliant(stage, scenario);
            label_state(&mut labels[start..], stage, owner);
            for index in 0..layout.pairs {
                labels[start + STATE + index] = Label { stage, owner, class: Class::ContactForce, index };
            }
        }
    }
    labels
}

fn label_state(labels: &mut [Label], stage: usize, owner: Owner) {
    for (index, label) in labels[..POSE].iter_mut().enumerate() {
        *label = Label { stage, owner, class: Class::Pose, index };
    }
    for (index, label) in labels[POSE..STATE].iter_mut().enumerate() {
        *label = Label { stage, owner, class: Class::Velocity, index };
    }
}

/// Multipliers of all constraints, in the order of the constraints.
fn constraints(layout: Layout, complementarity: Complementarity) -> Vec<Label> {
    let product = match complementarity {
        Complementarity::Relaxation => Class::InequalityMultiplier,
        Complementarity::Smoothing => Class::ComplementarityMultiplier,
    };
    let mut labels = Vec::with_capacity(layout.constraint_count());
    for stage in layout.stages() {
        let mut add = |owner: Owner, class: Class, indices: Range<usize>| {
            labels.extend(indices.map(|index| Label { stage, owner, class, index }));
        };
        add(Owner::Reference, Class::PoseMultiplier, 0..POSE);
        add(Owner::Reference, Class::InequalityMultiplier, 0..layout.accelerations);
        for scenario in 0..layout.scenarios {
            let owner = Owner::Scenario(scenario);
            add(owner, Class::PoseMultiplier, 0..POSE);
            add(owner, Class::VelocityMultiplier, 0..TWIST);
            add(owner, Class::InequalityMultiplier, 0..layout.pairs);
            add(owner, product, 0..layout.pairs);
            // Limits are numbered behind the pairs.
            let limits = layout.accelerations + layout.wrenches;
            add(owner, Class::InequalityMultiplier, layout.pairs..layout.pairs + limits);
        }
    }
    labels
}
