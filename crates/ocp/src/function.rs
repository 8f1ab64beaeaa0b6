//! One tape at many points: every input is a decision variable, a constant, the smoothing of the distances or contact
//! information.

use autodiff::{Batch, Jacobian, LagrangianHessian, Tape, Workspace};

use crate::pattern::{ABSENT, PatternBuilder, add};
use crate::point::Point;
use crate::term::Source;

/// A tape with derivatives at many points, and the decision variable behind every input of every point.
pub struct PointFunction {
    tape: Tape,
    /// Derivatives by the tape's first inputs, up to the last that is not a constant everywhere.
    pub jacobian: Jacobian,
    /// Second derivatives by the same inputs; the multipliers of the outputs are its last inputs.
    pub hessian: LagrangianHessian,
    points: usize,
    /// Decision variable per (input, point), [`ABSENT`] where the input is anything else.
    variables: Vec<u32>,
    /// Component of the contact information per input, if the input is one.
    contact: Vec<Option<usize>>,
    /// Inputs that are the smoothing of the distances.
    smoothing: Vec<usize>,
    inputs: Batch,
    values: Batch,
    jacobian_values: Batch,
    hessian_values: Batch,
    workspace: Workspace,
}

impl PointFunction {
    /// `source` gives the source of an input at a point.
    pub fn new(tape: Tape, points: &[Point], source: impl Fn(usize, &Point) -> Source) -> Self {
        let (input_count, output_count) = (tape.input_count(), tape.output_count());
        let mut inputs = Batch::new(input_count + output_count, points.len());
        let mut variables = vec![ABSENT; input_count * points.len()];
        let mut contact = vec![None; input_count];
        let mut smoothing = Vec::new();
        let mut differentiated = 0;
        for input in 0..input_count {
            for (index, point) in points.iter().enumerate() {
                match source(input, point) {
                    Source::Constant(value) => {
                        inputs.row_mut(input)[index] = value;
                        continue;
                    }
                    Source::Smoothing => {
                        smoothing.push(input);
                        break;
                    }
                    Source::Variable(variable) => variables[input * points.len() + index] = variable as u32,
                    Source::Contact(component) => contact[input] = Some(component),
                }
                differentiated = input + 1;
            }
        }
        let jacobian = tape.jacobian(differentiated);
        let hessian = tape.lagrangian_hessian(differentiated);
        Self {
            values: Batch::new(output_count, points.len()),
            jacobian_values: Batch::new(jacobian.rows.len(), points.len()),
            hessian_values: Batch::new(hessian.rows.len(), points.len()),
            workspace: Workspace::default(),
            tape,
            jacobian,
            hessian,
            points: points.len(),
            variables,
            contact,
            smoothing,
            inputs,
        }
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Number of inputs at every point.
    pub fn inputs(&self) -> usize {
        self.tape.input_count()
    }

    /// Number of outputs at every point.
    pub fn outputs(&self) -> usize {
        self.tape.output_count()
    }

    /// Decision variable behind an input; [`ABSENT`] if there is none.
    pub fn variable(&self, input: usize, point: usize) -> u32 {
        self.variables[input * self.points + point]
    }

    /// Component of the contact information that an input is, if any.
    pub fn contact(&self, input: usize) -> Option<usize> {
        self.contact[input]
    }

    /// Takes the smoothing of the distances.
    pub fn set_tau(&mut self, tau: f64) {
        for &input in &self.smoothing {
            self.inputs.row_mut(input).fill(tau);
        }
    }

    /// Takes the decision variables from `x`.
    pub fn set_point(&mut self, x: &[f64]) {
        for input in 0..self.tape.input_count() {
            let sources = &self.variables[input * self.points..(input + 1) * self.points];
            for (value, &source) in self.inputs.row_mut(input).iter_mut().zip(sources) {
                if source != ABSENT {
                    *value = x[source as usize];
                }
            }
        }
    }

    /// An input that is filled from outside, one value per point.
    pub fn input_mut(&mut self, input: usize) -> &mut [f64] {
        self.inputs.row_mut(input)
    }

    /// The multiplier of an output, one value per point.
    pub fn multiplier_mut(&mut self, output: usize) -> &mut [f64] {
        self.inputs.row_mut(self.tape.input_count() + output)
    }

    /// Outputs, a row per output.
    pub fn values(&mut self) -> &Batch {
        self.tape.evaluate(&self.inputs, &mut self.values, &mut self.workspace);
        &self.values
    }

    /// Nonzeros of the Jacobian, a row per nonzero.
    pub fn jacobian_values(&mut self) -> &Batch {
        self.jacobian.tape().evaluate(&self.inputs, &mut self.jacobian_values, &mut self.workspace);
        &self.jacobian_values
    }

    /// Nonzeros of the Hessian of the outputs weighted by the multipliers, a row per nonzero.
    pub fn hessian_values(&mut self) -> &Batch {
        self.hessian.tape().evaluate(&self.inputs, &mut self.hessian_values, &mut self.workspace);
        &self.hessian_values
    }

    /// The last result of [`PointFunction::jacobian_values`].
    pub fn evaluated_jacobian(&self) -> &Batch {
        &self.jacobian_values
    }

    /// The last result of [`PointFunction::hessian_values`].
    pub fn evaluated_hessian(&self) -> &Batch {
        &self.hessian_values
    }

    /// Gradient of the weighted outputs, a row per differentiated input.
    pub fn adjoint(&mut self, gradient: &mut Batch) {
        self.hessian.adjoint().evaluate(&self.inputs, gradient, &mut self.workspace);
    }

    /// Slots of the Jacobian's nonzeros, per (nonzero, point), for a constraint row per (output, point).
    pub fn jacobian_slots(&self, rows: &[u32], jacobian: &mut PatternBuilder) -> Vec<u32> {
        let pattern = &self.jacobian;
        let mut slots = Vec::with_capacity(pattern.rows.len() * self.points);
        for (&output, &input) in pattern.rows.iter().zip(&pattern.columns) {
            for point in 0..self.points {
                slots.push(jacobian.slot(rows[output * self.points + point], self.variable(input, point)));
            }
        }
        slots
    }

    /// Slots of the Hessian's nonzeros, per (nonzero, point).
    pub fn hessian_slots(&self, hessian: &mut PatternBuilder) -> Vec<u32> {
        let pattern = &self.hessian;
        let mut slots = Vec::with_capacity(pattern.rows.len() * self.points);
        for (&row, &column) in pattern.rows.iter().zip(&pattern.columns) {
            for point in 0..self.points {
                slots.push(hessian.symmetric_slot(self.variable(row, point), self.variable(column, point)));
            }
        }
        slots
    }
}

/// Adds one value per point to its slot.
pub fn scatter(values: &[f64], targets: &[u32], slots: &mut [f64]) {
    for (&value, &target) in values.iter().zip(targets) {
        add(slots, target, value);
    }
}
