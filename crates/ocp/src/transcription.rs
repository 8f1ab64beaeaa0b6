//! The multi-scenario optimal control problem (Eq. discretizedOCP) as a sparse nonlinear program.

use nlp::{Bounds, EvaluationError, Pattern, Problem};
use task::pose::without_offset;
use task::{AssemblyTask, Complementarity, CostWeights, HessianKind, POSE, STATE, TWIST, at_rest, pose_of};

use crate::contacts::Contacts;
use crate::cost::LeastSquares;
use crate::function::{ConstraintFunction, PointFunction, Source};
use crate::layout::Layout;
use crate::limit_rows::{bound_rows, bound_variables, limit_rows};
use crate::model::{self, COMPLIANT_VARIABLES};
use crate::pattern::PatternBuilder;

/// Contact forces of the initial guess (N).
pub const INITIAL_CONTACT_FORCE: f64 = 1e-3;

/// Layout, tapes and patterns of a task, built once; smoothing is set before each homotopy iteration.
pub struct Transcription {
    layout: Layout,
    task: AssemblyTask,
    complementarity: Complementarity,
    hessian_kind: HessianKind,
    sigma: f64,
    /// Kinematics, dynamics without contact, and limits.
    free_motion: Vec<ConstraintFunction>,
    contacts: Contacts,
    running_cost: LeastSquares,
    terminal_cost: LeastSquares,
    jacobian: Pattern,
    hessian: Pattern,
    initial_compliant: Vec<[f64; STATE]>,
}

impl Transcription {
    /// Records all tapes and patterns.
    pub fn new(task: &AssemblyTask, complementarity: Complementarity, hessian_kind: HessianKind) -> Self {
        let layout = Layout {
            steps: task.horizon.steps,
            scenarios: task.offsets.len(),
            pairs: task.pairs.len(),
            accelerations: task.limits.accelerations().len(),
            wrenches: task.limits.wrenches().len(),
        };
        let initial_compliant: Vec<[f64; STATE]> =
            task.offsets.iter().map(|offset| at_rest(&without_offset(&task.start, offset))).collect();
        let initial_poses: Vec<[f64; POSE]> = initial_compliant.iter().map(pose_of).collect();
        let (mut jacobian, mut hessian) = (PatternBuilder::default(), PatternBuilder::default());
        let mut free_motion = vec![
            reference_rows(task, layout, &mut jacobian, &mut hessian),
            compliant_rows(task, layout, &initial_compliant, &mut jacobian, &mut hessian),
        ];
        free_motion.extend(limit_rows(task, layout, &mut jacobian, &mut hessian));
        let contacts = Contacts::new(task, layout, &initial_poses, &mut jacobian, &mut hessian);
        let running_cost = running_cost(task, layout, &mut hessian);
        let terminal_cost = terminal_cost(task, layout, &mut hessian);
        Self {
            layout,
            task: task.clone(),
            complementarity,
            hessian_kind,
            sigma: f64::NAN,
            free_motion,
            contacts,
            running_cost,
            terminal_cost,
            jacobian: jacobian.finish(),
            hessian: hessian.finish(),
            initial_compliant,
        }
    }

    /// Smoothing of the distances `tau` and of the complementarity conditions `sigma` (Sec. ocp:homotopy).
    pub fn set_smoothing(&mut self, tau: f64, sigma: f64) {
        self.contacts.set_tau(tau);
        self.sigma = sigma;
    }

    /// Indices of variables and constraints.
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// Relaxation or smoothing of the complementarity conditions.
    pub fn complementarity(&self) -> Complementarity {
        self.complementarity
    }

    /// The task that was transcribed.
    pub fn task(&self) -> &AssemblyTask {
        &self.task
    }

    /// Compliant states at the start, one per scenario.
    pub fn initial_compliant(&self) -> &[[f64; STATE]] {
        &self.initial_compliant
    }

    /// The contact terms, whose distances the trajectory reports.
    pub fn contacts(&mut self) -> &mut Contacts {
        &mut self.contacts
    }

    /// The trivial guess: everything rests at the start pose, with small positive contact forces.
    pub fn initial_guess(&self) -> Vec<f64> {
        let mut x = vec![INITIAL_CONTACT_FORCE; self.layout.variable_count()];
        for stage in self.layout.stages() {
            x[self.layout.reference(stage)..][..STATE].copy_from_slice(&at_rest(&self.task.start));
            for (scenario, state) in self.initial_compliant.iter().enumerate() {
                x[self.layout.compliant(stage, scenario)..][..STATE].copy_from_slice(state);
            }
        }
        x
    }
}

impl Problem for Transcription {
    fn variable_bounds(&self) -> Bounds {
        let count = self.layout.variable_count();
        let mut lower = vec![f64::NEG_INFINITY; count];
        for (stage, scenario) in self.layout.stages_and_scenarios() {
            lower[self.layout.contact_force(stage, scenario, 0)..][..self.layout.pairs].fill(0.0);
        }
        let mut bounds = Bounds { lower, upper: vec![f64::INFINITY; count] };
        bound_variables(&self.task.limits, self.layout, &mut bounds);
        bounds
    }

    fn constraint_bounds(&self) -> Bounds {
        let count = self.layout.constraint_count();
        let (mut lower, mut upper) = (vec![0.0; count], vec![0.0; count]);
        let least_product = match self.complementarity {
            Complementarity::Relaxation => f64::NEG_INFINITY,
            Complementarity::Smoothing => self.sigma,
        };
        let pairs = self.layout.pairs;
        for (stage, scenario) in self.layout.stages_and_scenarios() {
            upper[self.layout.gap(stage, scenario, 0)..][..pairs].fill(f64::INFINITY);
            let products = self.layout.complementarity(stage, scenario, 0);
            lower[products..][..pairs].fill(least_product);
            upper[products..][..pairs].fill(self.sigma);
        }
        let mut bounds = Bounds { lower, upper };
        bound_rows(&self.task.limits, self.layout, &mut bounds);
        bounds
    }

    fn jacobian_pattern(&self) -> Pattern {
        self.jacobian.clone()
    }

    fn hessian_pattern(&self) -> Pattern {
        self.hessian.clone()
    }

    fn set_point(&mut self, x: &[f64]) -> Result<(), EvaluationError> {
        self.free_motion.iter_mut().for_each(|rows| rows.set_point(x));
        self.contacts.set_point(x);
        self.running_cost.set_point(x);
        self.terminal_cost.set_point(x);
        Ok(())
    }

    fn objective(&mut self) -> Result<f64, EvaluationError> {
        Ok(self.running_cost.value() + self.terminal_cost.value())
    }

    fn gradient(&mut self, gradient: &mut [f64]) -> Result<(), EvaluationError> {
        gradient.fill(0.0);
        self.running_cost.add_gradient(gradient);
        self.terminal_cost.add_gradient(gradient);
        Ok(())
    }

    fn constraints(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        values.fill(0.0);
        self.free_motion.iter_mut().for_each(|rows| rows.add_values(values));
        self.contacts.add_values(values)
    }

    fn jacobian(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        values.fill(0.0);
        self.free_motion.iter_mut().for_each(|rows| rows.add_jacobian(values));
        self.contacts.add_jacobian(values)
    }

    fn hessian(
        &mut self,
        objective_factor: f64,
        multipliers: &[f64],
        values: &mut [f64],
    ) -> Result<(), EvaluationError> {
        values.fill(0.0);
        let exact = self.hessian_kind == HessianKind::Exact;
        self.running_cost.add_hessian(objective_factor, exact, values);
        self.terminal_cost.add_hessian(objective_factor, exact, values);
        if !exact {
            return Ok(());
        }
        self.free_motion.iter_mut().for_each(|rows| rows.add_hessian(multipliers, values));
        self.contacts.add_hessian(multipliers, values)
    }
}

fn reference_rows(
    task: &AssemblyTask,
    layout: Layout,
    jacobian: &mut PatternBuilder,
    hessian: &mut PatternBuilder,
) -> ConstraintFunction {
    let tape = model::reference_kinematics(task.horizon.time_step);
    let start = at_rest(&task.start);
    let function = PointFunction::new(tape, POSE + STATE, layout.steps, |input, point| match input {
        0..POSE if point == 0 => Source::Constant(start[input]),
        0..POSE => Source::Variable(layout.reference(point) + input),
        _ => Source::Variable(layout.reference(point + 1) + input - POSE),
    });
    ConstraintFunction::new(function, |row, point| layout.reference_kinematics(point + 1) + row, jacobian, hessian)
}

fn compliant_rows(
    task: &AssemblyTask,
    layout: Layout,
    initial: &[[f64; STATE]],
    jacobian: &mut PatternBuilder,
    hessian: &mut PatternBuilder,
) -> ConstraintFunction {
    let locate = |point: usize| (point / layout.scenarios + 1, point % layout.scenarios);
    let source = |input: usize, point: usize| {
        let (stage, scenario) = locate(point);
        match (input / STATE, input % STATE) {
            (0, component) if stage == 1 => Source::Constant(initial[scenario][component]),
            (0, component) => Source::Variable(layout.compliant(stage - 1, scenario) + component),
            (1, component) => Source::Variable(layout.compliant(stage, scenario) + component),
            (2, component) => Source::Variable(layout.reference(stage) + component),
            (_, axis) => Source::Constant(task.offsets[scenario][axis]),
        }
    };
    let points = layout.steps * layout.scenarios;
    let function = PointFunction::new(model::compliant_dynamics(task), COMPLIANT_VARIABLES, points, source);
    let row = |output: usize, point: usize| {
        let (stage, scenario) = locate(point);
        layout.pose_dynamics(stage, scenario) + output
    };
    ConstraintFunction::new(function, row, jacobian, hessian)
}

/// Weights of trajectory 0 (the reference) or `1 + scenario`.
fn weights(task: &AssemblyTask, trajectory: usize) -> CostWeights {
    if trajectory == 0 { task.cost.reference } else { task.cost.compliant }
}

fn running_cost(task: &AssemblyTask, layout: Layout, hessian: &mut PatternBuilder) -> LeastSquares {
    let steps: Vec<(usize, usize)> = layout.stages_and_trajectories().collect();
    let source = |input: usize, point: usize| {
        let (stage, trajectory) = steps[point];
        let weights = weights(task, trajectory);
        match input {
            0..TWIST => Source::Variable(layout.state(stage, trajectory) + POSE + input),
            TWIST => Source::Constant(weights.translational_velocity.sqrt()),
            _ => Source::Constant(weights.rotational_velocity.sqrt()),
        }
    };
    LeastSquares::new(PointFunction::new(model::running_residuals(), TWIST, steps.len(), source), hessian)
}

fn terminal_cost(task: &AssemblyTask, layout: Layout, hessian: &mut PatternBuilder) -> LeastSquares {
    let source = |input: usize, trajectory: usize| {
        let weights = weights(task, trajectory);
        match input {
            0..POSE => Source::Variable(layout.state(layout.steps, trajectory) + input),
            POSE => Source::Constant(weights.terminal_position.sqrt()),
            _ => Source::Constant(weights.terminal_orientation.sqrt()),
        }
    };
    let tape = model::terminal_residuals(&task.goal);
    LeastSquares::new(PointFunction::new(tape, POSE, layout.scenarios + 1, source), hessian)
}
