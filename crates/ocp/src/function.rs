//! One tape at many points: every input is a decision variable or a constant, every output a constraint row or a
//! residual.

use autodiff::{Batch, Jacobian, LagrangianHessian, Tape, Workspace};

use crate::pattern::{ABSENT, PatternBuilder, add};

/// A tape with derivatives at `points` points, with the decision variable behind every input of every point.
pub struct PointFunction {
    tape: Tape,
    /// Derivatives by the tape's first inputs.
    pub jacobian: Jacobian,
    /// Second derivatives, its multipliers being the last inputs.
    pub hessian: LagrangianHessian,
    points: usize,
    /// Decision variable per (input, point), [`ABSENT`] where the input is a constant or filled from outside.
    variables: Vec<u32>,
    inputs: Batch,
    values: Batch,
    jacobian_values: Batch,
    hessian_values: Batch,
    workspace: Workspace,
}

impl PointFunction {
    /// Differentiates `tape` by its first `differentiated` inputs. `source` names what stands behind input `i` of
    /// point `p`.
    pub fn new(tape: Tape, differentiated: usize, points: usize, source: impl Fn(usize, usize) -> Source) -> Self {
        let jacobian = tape.jacobian(differentiated);
        let hessian = tape.lagrangian_hessian(differentiated);
        let (input_count, output_count) = (tape.input_count(), tape.output_count());
        let mut inputs = Batch::new(input_count + output_count, points);
        let mut variables = vec![ABSENT; input_count * points];
        for input in 0..input_count {
            for point in 0..points {
                match source(input, point) {
                    Source::Variable(index) => variables[input * points + point] = index as u32,
                    Source::Constant(value) => inputs.row_mut(input)[point] = value,
                }
            }
        }
        Self {
            values: Batch::new(output_count, points),
            jacobian_values: Batch::new(jacobian.rows.len(), points),
            hessian_values: Batch::new(hessian.rows.len(), points),
            workspace: Workspace::default(),
            tape,
            jacobian,
            hessian,
            points,
            variables,
            inputs,
        }
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Number of outputs at every point.
    pub fn outputs(&self) -> usize {
        self.tape.output_count()
    }

    /// Decision variable behind an input, [`ABSENT`] when there is none.
    pub fn variable(&self, input: usize, point: usize) -> u32 {
        self.variables[input * self.points + point]
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

    /// What [`PointFunction::jacobian_values`] gave last.
    pub fn evaluated_jacobian(&self) -> &Batch {
        &self.jacobian_values
    }

    /// What [`PointFunction::hessian_values`] gave last.
    pub fn evaluated_hessian(&self) -> &Batch {
        &self.hessian_values
    }

    /// Gradient of the weighted outputs, a row per differentiated input.
    pub fn adjoint(&mut self, gradient: &mut Batch) {
        self.hessian.adjoint().evaluate(&self.inputs, gradient, &mut self.workspace);
    }
}

/// What stands behind an input of a tape.
pub enum Source {
    /// A decision variable.
    Variable(usize),
    /// A number that does not change, or that [`PointFunction::input_mut`] fills.
    Constant(f64),
}

/// A [`PointFunction`] whose outputs are added to constraint rows.
pub struct ConstraintFunction {
    function: PointFunction,
    /// Constraint row per (output, point).
    rows: Vec<u32>,
    jacobian_slots: Vec<u32>,
    hessian_slots: Vec<u32>,
}

impl ConstraintFunction {
    /// `row` names the constraint that output `i` of point `p` adds to.
    pub fn new(
        function: PointFunction,
        row: impl Fn(usize, usize) -> usize,
        jacobian: &mut PatternBuilder,
        hessian: &mut PatternBuilder,
    ) -> Self {
        let points = function.points;
        let each = |count: usize| (0..count).flat_map(move |entry| (0..points).map(move |point| (entry, point)));
        let rows: Vec<u32> = each(function.outputs()).map(|(output, point)| row(output, point) as u32).collect();
        let pattern = &function.jacobian;
        let jacobian_slots = each(pattern.rows.len())
            .map(|(entry, point)| {
                let row = rows[pattern.rows[entry] * points + point];
                jacobian.slot(row, function.variable(pattern.columns[entry], point))
            })
            .collect();
        let hessian_slots = hessian_slots(&function, hessian);
        Self { function, rows, jacobian_slots, hessian_slots }
    }

    /// Takes the decision variables from `x`.
    pub fn set_point(&mut self, x: &[f64]) {
        self.function.set_point(x);
    }

    /// Adds the outputs to their rows.
    pub fn add_values(&mut self, constraints: &mut [f64]) {
        let points = self.function.points;
        let values = self.function.values();
        for (output, rows) in self.rows.chunks_exact(points.max(1)).enumerate() {
            scatter(values.row(output), rows, constraints);
        }
    }

    /// Adds the Jacobian's nonzeros to their slots.
    pub fn add_jacobian(&mut self, slots: &mut [f64]) {
        let points = self.function.points;
        let values = self.function.jacobian_values();
        for (entry, targets) in self.jacobian_slots.chunks_exact(points.max(1)).enumerate() {
            scatter(values.row(entry), targets, slots);
        }
    }

    /// Adds the Hessian weighted by the constraints' multipliers to its slots.
    pub fn add_hessian(&mut self, multipliers: &[f64], slots: &mut [f64]) {
        let points = self.function.points;
        for (output, rows) in self.rows.chunks_exact(points.max(1)).enumerate() {
            for (value, &row) in self.function.multiplier_mut(output).iter_mut().zip(rows) {
                *value = multipliers[row as usize];
            }
        }
        let values = self.function.hessian_values();
        for (entry, targets) in self.hessian_slots.chunks_exact(points.max(1)).enumerate() {
            scatter(values.row(entry), targets, slots);
        }
    }
}

/// Slots of a function's Hessian nonzeros, per (nonzero, point).
pub fn hessian_slots(function: &PointFunction, hessian: &mut PatternBuilder) -> Vec<u32> {
    let pattern = &function.hessian;
    let mut slots = Vec::with_capacity(pattern.rows.len() * function.points);
    for (&row, &column) in pattern.rows.iter().zip(&pattern.columns) {
        for point in 0..function.points {
            slots.push(hessian.symmetric_slot(function.variable(row, point), function.variable(column, point)));
        }
    }
    slots
}

/// Adds one value per point to its slot.
pub fn scatter(values: &[f64], targets: &[u32], slots: &mut [f64]) {
    for (&value, &target) in values.iter().zip(targets) {
        add(slots, target, value);
    }
}
