//! Motions of the planner's model of contact for a reference that is given.

use kkt::Owner;
use nlp::{Bounds, Control, EvaluationError, LinearSystemSolver, Options, Pattern, Problem, Start};
use ocp::Transcription;
use task::{AssemblyTask, Complementarity, HessianKind, POSE, State, TWIST, Twist};

/// Homotopy steps.
pub const ITERATIONS: usize = 5;

/// A transcription whose reference has given velocities: what is left to find is the motion of the body.
struct Played {
    inner: Transcription,
    velocities: Vec<Twist>,
}

impl Problem for Played {
    fn variable_bounds(&self) -> Bounds {
        let mut bounds = self.inner.variable_bounds();
        for (index, twist) in self.velocities.iter().enumerate() {
            let first = self.inner.layout().state(index + 1, Owner::Reference) + POSE;
            bounds.lower[first..][..TWIST].copy_from_slice(&twist[..]);
            bounds.upper[first..][..TWIST].copy_from_slice(&twist[..]);
        }
        bounds
    }

    fn constraint_bounds(&self) -> Bounds {
        self.inner.constraint_bounds()
    }

    fn jacobian_pattern(&self) -> Pattern {
        self.inner.jacobian_pattern()
    }

    fn hessian_pattern(&self) -> Pattern {
        self.inner.hessian_pattern()
    }

    fn set_point(&mut self, x: &[f64]) -> Result<(), EvaluationError> {
        self.inner.set_point(x)
    }

    fn objective(&mut self) -> Result<f64, EvaluationError> {
        self.inner.objective()
    }

    fn gradient(&mut self, gradient: &mut [f64]) -> Result<(), EvaluationError> {
        self.inner.gradient(gradient)
    }

    fn constraints(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        self.inner.constraints(values)
    }

    fn jacobian(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        self.inner.jacobian(values)
    }

    fn hessian(&mut self, factor: f64, multipliers: &[f64], values: &mut [f64]) -> Result<(), EvaluationError> {
        self.inner.hessian(factor, multipliers, values)
    }
}

/// States of the body at the end of every step when the reference has given velocities, with less and less smoothing: one
/// motion per smoothing.
pub fn motions(task: &AssemblyTask, velocities: Vec<Twist>) -> Vec<Vec<State>> {
    let inner = Transcription::new(task, Complementarity::Relaxation, HessianKind::Exact);
    let mut problem = Played { velocities, inner };
    let mut start = Start::Cold(problem.inner.formulation().initial_guess());
    let settings = scene::default_homotopy();
    let mut motions = Vec::new();
    for smoothing in settings.schedule().take(ITERATIONS) {
        problem.inner.set_smoothing(smoothing.tau, smoothing.sigma);
        let mut options = Options::default();
        options.set("mu_init", smoothing.mu_init);
        options.set("max_iter", 300);
        for push in ["bound_push", "bound_frac", "slack_bound_push", "slack_bound_frac", "mult_bound_push"] {
            options.set(&format!("warm_start_{push}"), 1e-9);
        }
        let solver = LinearSystemSolver::Named("mumps");
        let solution = nlp::solve(&mut problem, &start, &options, solver, &mut |_| Control::Continue).unwrap();
        assert!(solution.status.is_success(), "{smoothing:?}: {:?}", solution.status);
        motions.push(
            problem.inner.formulation().motion(&solution.iterate.x, smoothing.tau).scenarios.remove(0).states[1..]
                .to_vec(),
        );
        start = Start::Warm(solution.iterate);
    }
    motions
}
