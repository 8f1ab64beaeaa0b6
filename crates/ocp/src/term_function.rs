//! Evaluation of a [`StepTerm`] at all of its points.

use autodiff::Batch;
use task::POSE;

use crate::distances::Distances;
use crate::function::{PointFunction, scatter};
use crate::layout::Layout;
use crate::pattern::{ABSENT, Patterns, add};
use crate::term::{Points, StepTerm};

/// The tape of a term at all of its points, with the rows and slots that its values and derivatives are added to.
pub struct TermFunction {
    function: PointFunction,
    /// Constraint row per (output, point).
    rows: Vec<u32>,
    /// Slot per (nonzero, point), [`ABSENT`] for derivatives by contact information.
    jacobian_slots: Vec<u32>,
    /// Slot per (nonzero, point), [`ABSENT`] for derivatives by contact information.
    hessian_slots: Vec<u32>,
    chain: ContactChain,
}

impl TermFunction {
    /// Records the tape and adds all entries to the patterns.
    ///
    /// # Panics
    /// When the term takes contact information at points other than [`Points::Pairs`].
    pub fn new(term: &dyn StepTerm, layout: &Layout, distances: &mut Distances, patterns: &mut Patterns) -> Self {
        let points = layout.points(term.points());
        let function = PointFunction::new(term.tape(), &points, |input, point| term.source(input, point, layout));
        let row = |output: usize| points.iter().map(move |point| term.row(output, point, layout) as u32);
        let rows: Vec<u32> = (0..function.outputs()).flat_map(row).collect();
        let jacobian_slots = function.jacobian_slots(&rows, &mut patterns.jacobian);
        let hessian_slots = function.hessian_slots(&mut patterns.hessian);
        let chain = if (0..function.inputs()).any(|input| function.contact(input).is_some()) {
            assert_eq!(term.points(), Points::Pairs, "contact information belongs to pairs");
            ContactChain::new(&function, &rows, distances, patterns)
        } else {
            ContactChain::default()
        };
        Self { function, rows, jacobian_slots, hessian_slots, chain }
    }

    /// Number of outputs at every point.
    pub fn outputs(&self) -> usize {
        self.function.outputs()
    }

    /// Takes the decision variables from `x`.
    pub fn set_point(&mut self, x: &[f64]) {
        self.function.set_point(x);
    }

    /// Adds the outputs to their rows. Requires evaluated distances.
    pub fn add_values(&mut self, distances: &Distances, constraints: &mut [f64]) {
        take_contact_information(&mut self.function, distances);
        let points = self.function.points();
        let outputs = self.function.outputs();
        let values = self.function.values();
        for output in 0..outputs {
            scatter(values.row(output), &self.rows[output * points..][..points], constraints);
        }
    }

    /// Adds the Jacobian, `d/dx + d/dW DW`, to its slots. Requires evaluated Jacobians of the distances.
    pub fn add_jacobian(&mut self, distances: &Distances, slots: &mut [f64]) {
        take_contact_information(&mut self.function, distances);
        let points = self.function.points();
        self.function.jacobian_values();
        let pattern = &self.function.jacobian;
        let values = self.function.evaluated_jacobian();
        for (entry, (&output, &input)) in pattern.rows.iter().zip(&pattern.columns).enumerate() {
            let values = values.row(entry);
            match self.function.contact(input) {
                None => scatter(values, &self.jacobian_slots[entry * points..][..points], slots),
                Some(component) => {
                    let targets = &self.chain.jacobian_slots[output * points..][..points];
                    scatter_gradients(values, distances, component, targets, slots);
                }
            }
        }
    }

    /// Takes the multipliers of the constraints and adds the adjoints of the contact information to the seeds of the
    /// distances, which must have been evaluated.
    pub fn take_multipliers(&mut self, multipliers: &[f64], distances: &mut Distances) {
        let points = self.function.points();
        for output in 0..self.function.outputs() {
            let rows = &self.rows[output * points..][..points];
            for (value, &row) in self.function.multiplier_mut(output).iter_mut().zip(rows) {
                *value = multipliers[row as usize];
            }
        }
        let Some(adjoint) = &mut self.chain.adjoint else { return };
        take_contact_information(&mut self.function, distances);
        self.function.adjoint(adjoint);
        for input in 0..self.function.inputs() {
            if let Some(component) = self.function.contact(input) {
                distances.add_seeds(component, adjoint.row(input));
            }
        }
    }

    /// Adds the Hessian weighted by the multipliers last taken, without the curvature of the distances
    /// ([`Distances::add_curvature`]). Requires evaluated Jacobians of the distances.
    pub fn add_hessian(&mut self, distances: &Distances, slots: &mut [f64]) {
        let points = self.function.points();
        self.function.hessian_values();
        let pattern = &self.function.hessian;
        let values = self.function.evaluated_hessian();
        for (entry, (&row, &column)) in pattern.rows.iter().zip(&pattern.columns).enumerate() {
            let values = values.row(entry);
            match (self.function.contact(row), self.function.contact(column)) {
                (None, None) => scatter(values, &self.hessian_slots[entry * points..][..points], slots),
                (Some(component), None) => self.chain.add_mixed(values, distances, component, column, slots),
                (None, Some(component)) => self.chain.add_mixed(values, distances, component, row, slots),
                (Some(one), Some(other)) => distances.add_products(values, one, other, slots),
            }
        }
    }
}

fn take_contact_information(function: &mut PointFunction, distances: &Distances) {
    for input in 0..function.inputs() {
        if let Some(component) = function.contact(input) {
            let values = distances.last_values().iter().flatten();
            for (input, contact) in function.input_mut(input).iter_mut().zip(values) {
                *input = contact[component];
            }
        }
    }
}

/// Entries of a term's derivatives by contact information, which is a function of the pose before the step.
#[derive(Default)]
struct ContactChain {
    /// Entries (constraint row, coordinates of the pose) per (output, point).
    jacobian_slots: Vec<[u32; POSE]>,
    /// Entries (variable, coordinates of the pose) per (input, point).
    mixed_slots: Vec<[u32; POSE]>,
    /// Coordinate of that pose per input, if the input is one.
    own_coordinate: Vec<Option<usize>>,
    /// Gradient of the weighted outputs; `None` when no input is contact information.
    adjoint: Option<Batch>,
}

impl ContactChain {
    fn new(function: &PointFunction, rows: &[u32], distances: &mut Distances, patterns: &mut Patterns) -> Self {
        let (points, inputs, outputs) = (function.points(), function.inputs(), function.outputs());
        let pairs_of_inputs = || function.hessian.rows.iter().zip(&function.hessian.columns);
        let meets_contact = |input: usize| {
            pairs_of_inputs().any(|(&row, &column)| {
                (row == input && function.contact(column).is_some())
                    || (column == input && function.contact(row).is_some())
            })
        };
        let mixed_inputs: Vec<usize> = (0..inputs).filter(|&input| meets_contact(input)).collect();
        let feels_contact = |output: usize| {
            let nonzeros = function.jacobian.rows.iter().zip(&function.jacobian.columns);
            nonzeros.into_iter().any(|(&row, &column)| row == output && function.contact(column).is_some())
        };
        let chained_outputs: Vec<usize> = (0..outputs).filter(|&output| feels_contact(output)).collect();
        let mut jacobian_slots = vec![[ABSENT; POSE]; outputs * points];
        let mut mixed_slots = vec![[ABSENT; POSE]; inputs * points];
        let mut own_coordinate = vec![None; inputs];
        for point in 0..points {
            let pose = distances.pose_variables(point);
            for &output in &chained_outputs {
                let entry = output * points + point;
                jacobian_slots[entry] = pose.map(|column| patterns.jacobian.slot(rows[entry], column));
            }
            distances.reserve_curvature(point, &mut patterns.hessian);
            for &input in &mixed_inputs {
                let variable = function.variable(input, point);
                mixed_slots[input * points + point] =
                    pose.map(|column| patterns.hessian.symmetric_slot(variable, column));
                if variable != ABSENT {
                    own_coordinate[input] = pose.iter().position(|&coordinate| coordinate == variable);
                }
            }
        }
        Self { jacobian_slots, mixed_slots, own_coordinate, adjoint: Some(Batch::new(inputs, points)) }
    }

    /// Adds second derivatives by a variable and a component of the contact information.
    fn add_mixed(&self, values: &[f64], distances: &Distances, component: usize, input: usize, slots: &mut [f64]) {
        let targets = &self.mixed_slots[input * values.len()..][..values.len()];
        scatter_gradients(values, distances, component, targets, slots);
        // The second derivative by one and the same coordinate has this term twice.
        if let Some(coordinate) = self.own_coordinate[input] {
            let derivatives = distances.last_jacobians().iter().flatten();
            for ((&value, derivative), target) in values.iter().zip(derivatives).zip(targets) {
                add(slots, target[coordinate], value * derivative[component][coordinate]);
            }
        }
    }
}

/// Adds one value per point, times the gradient of a component of the point's contact information.
fn scatter_gradients(
    values: &[f64],
    distances: &Distances,
    component: usize,
    targets: &[[u32; POSE]],
    slots: &mut [f64],
) {
    let gradients = distances.last_jacobians().iter().flatten().map(|derivative| &derivative[component]);
    for ((&value, gradient), targets) in values.iter().zip(gradients).zip(targets) {
        for (&slope, &target) in gradient.iter().zip(targets) {
            add(slots, target, value * slope);
        }
    }
}
