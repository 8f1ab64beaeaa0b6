//! The multi-scenario optimal control problem (Eq. discretizedOCP) as a sparse nonlinear program.

use nlp::{Bounds, EvaluationError, Pattern, Problem};
use task::{AssemblyTask, Complementarity, HessianKind};
use workers::Workers;

use crate::cost::{running_cost, terminal_cost};
use crate::distances::Distances;
use crate::formulation::Formulation;
use crate::layout::Layout;
use crate::least_squares::LeastSquares;
use crate::pattern::Patterns;
use crate::term::{StepTerm, blocks};
use crate::term_function::TermFunction;
use crate::terms::standard_terms;

/// Layout, tapes and patterns of a task, built once. The smoothing is set before each homotopy step.
pub struct Transcription {
    formulation: Formulation,
    hessian_kind: HessianKind,
    terms: Vec<Box<dyn StepTerm>>,
    distances: Distances,
    functions: Vec<TermFunction>,
    costs: [LeastSquares; 2],
    jacobian: Pattern,
    hessian: Pattern,
    workers: Workers,
}

impl Transcription {
    /// Records all tapes and patterns of a task, with all contacts.
    pub fn new(task: &AssemblyTask, complementarity: Complementarity, hessian_kind: HessianKind) -> Self {
        Self::with_terms(task, standard_terms(task, complementarity), hessian_kind)
    }

    /// [`Transcription::new`] with other terms than [`standard_terms`].
    pub fn with_terms(task: &AssemblyTask, terms: Vec<Box<dyn StepTerm>>, hessian_kind: HessianKind) -> Self {
        Self::record(Formulation::with_blocks(task, &blocks(&terms)), terms, hessian_kind)
    }

    /// With the contacts of a formulation, which has been made with the same `complementarity`.
    pub fn of(formulation: Formulation, complementarity: Complementarity, hessian_kind: HessianKind) -> Self {
        let terms = standard_terms(formulation.task(), complementarity);
        Self::record(formulation, terms, hessian_kind)
    }

    fn record(formulation: Formulation, terms: Vec<Box<dyn StepTerm>>, hessian_kind: HessianKind) -> Self {
        let (task, layout) = (formulation.task(), formulation.layout());
        let initial_poses: Vec<_> = formulation.initial_compliant().iter().map(|state| state.pose().0).collect();
        let mut distances = Distances::new(task, layout, &initial_poses);
        let mut patterns = Patterns::default();
        let functions = terms.iter().map(|term| TermFunction::new(&**term, layout, &mut distances, &mut patterns));
        // Limits have no outputs where nothing is limited.
        let functions = functions.filter(|function| function.outputs() > 0).collect();
        let costs =
            [running_cost(task, layout, &mut patterns.hessian), terminal_cost(task, layout, &mut patterns.hessian)];
        Self {
            hessian_kind,
            terms,
            distances,
            functions,
            costs,
            jacobian: patterns.jacobian.finish(),
            hessian: patterns.hessian.finish(),
            workers: Workers::default(),
            formulation,
        }
    }

    /// Evaluates with some threads; they do not affect results. The default is one.
    pub fn with_workers(mut self, workers: Workers) -> Self {
        self.distances.set_workers(workers.clone());
        self.workers = workers;
        self
    }

    /// The threads that evaluate.
    pub fn workers(&self) -> &Workers {
        &self.workers
    }

    /// Sets the smoothing of the distances, `tau`, and of the complementarity conditions, `sigma` (Sec. ocp:homotopy).
    pub fn set_smoothing(&mut self, tau: f64, sigma: f64) {
        self.distances.set_tau(tau);
        self.functions.iter_mut().for_each(|function| function.set_tau(tau));
        self.terms.iter_mut().for_each(|term| term.set_sigma(sigma));
    }

    /// What is transcribed.
    pub fn formulation(&self) -> &Formulation {
        &self.formulation
    }

    /// Indices of variables and constraints.
    pub fn layout(&self) -> &Layout {
        self.formulation.layout()
    }

    /// The task that was transcribed.
    pub fn task(&self) -> &AssemblyTask {
        self.formulation.task()
    }

    /// The distances of all pairs.
    pub(crate) fn distances(&mut self) -> &mut Distances {
        &mut self.distances
    }
}

impl Problem for Transcription {
    fn variable_bounds(&self) -> Bounds {
        self.layout().variable_bounds(&blocks(&self.terms))
    }

    fn constraint_bounds(&self) -> Bounds {
        self.layout().constraint_bounds(&blocks(&self.terms))
    }

    fn jacobian_pattern(&self) -> Pattern {
        self.jacobian.clone()
    }

    fn hessian_pattern(&self) -> Pattern {
        self.hessian.clone()
    }

    fn set_point(&mut self, x: &[f64]) -> Result<(), EvaluationError> {
        self.functions.iter_mut().for_each(|function| function.set_point(x));
        self.distances.set_point(x);
        self.costs.iter_mut().for_each(|cost| cost.set_point(x));
        Ok(())
    }

    fn objective(&mut self) -> Result<f64, EvaluationError> {
        Ok(self.costs.iter_mut().map(LeastSquares::value).sum())
    }

    fn gradient(&mut self, gradient: &mut [f64]) -> Result<(), EvaluationError> {
        gradient.fill(0.0);
        self.costs.iter_mut().for_each(|cost| cost.add_gradient(gradient));
        Ok(())
    }

    fn constraints(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        values.fill(0.0);
        self.distances.evaluate()?;
        self.functions.iter_mut().for_each(|function| function.add_values(&self.distances, values));
        Ok(())
    }

    fn jacobian(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        values.fill(0.0);
        self.distances.evaluate_jacobians()?;
        self.functions.iter_mut().for_each(|function| function.add_jacobian(&self.distances, values));
        Ok(())
    }

    fn hessian(
        &mut self,
        objective_factor: f64,
        multipliers: &[f64],
        values: &mut [f64],
    ) -> Result<(), EvaluationError> {
        values.fill(0.0);
        let exact = self.hessian_kind == HessianKind::Exact;
        self.costs.iter_mut().for_each(|cost| cost.add_hessian(objective_factor, exact, values));
        if !exact {
            return Ok(());
        }
        self.distances.evaluate_jacobians()?;
        self.distances.clear_seeds();
        for function in &mut self.functions {
            function.take_multipliers(multipliers, &mut self.distances);
        }
        self.distances.evaluate_hessians()?;
        self.functions.iter_mut().for_each(|function| function.add_hessian(&self.distances, values));
        self.distances.add_curvature(values);
        Ok(())
    }
}
