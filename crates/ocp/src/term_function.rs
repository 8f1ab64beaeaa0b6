//! Evaluation of a [`StepTerm`] at all of its points.

use autodiff::Batch;
use task::POSE;

use crate::distances::Distances;
use crate::function::{PointFunction, scatter};
use crate::layout::Layout;
use crate::pattern::{ABSENT, Patterns, add};
use crate::point::Points;
use crate::term::StepTerm;

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
        let components = (0..function.inputs()).filter_map(|input| function.contact(input));
        let chain = if let Some(last) = components.max() {
            distances.require(last);
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

    /// Takes the smoothing parameter of the distances.
    pub fn set_tau(&mut self, tau: f64) {
        self.function.set_tau(tau);
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
        for (entry, &input) in pattern.columns.iter().enumerate() {
            if self.function.contact(input).is_none() {
                scatter(values.row(entry), &self.jacobian_slots[entry * points..][..points], slots);
            }
        }
        add_links(&self.chain.jacobian, values, distances, slots);
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
                (Some(one), Some(other)) => distances.add_products(values, one, other, slots),
                _ => {}
            }
        }
        add_links(&self.chain.mixed, values, distances, slots);
    }
}

fn take_contact_information(function: &mut PointFunction, distances: &Distances) {
    for input in 0..function.inputs() {
        if let Some(component) = function.contact(input) {
            for (input, value) in function.input_mut(input).iter_mut().zip(distances.last_values(component)) {
                *input = value;
            }
        }
    }
}

/// A term's derivatives by contact information, which is a function of the pose before the step.
#[derive(Default)]
struct ContactChain {
    /// Of every output that depends on contact information.
    jacobian: Vec<Link>,
    /// Of every input that has second derivatives together with contact information.
    mixed: Vec<Link>,
    /// Gradient of the weighted outputs; `None` when no input is contact information.
    adjoint: Option<Batch>,
}

impl ContactChain {
    fn new(function: &PointFunction, rows: &[u32], distances: &mut Distances, patterns: &mut Patterns) -> Self {
        let points = function.points();
        let poses: Vec<[u32; POSE]> = (0..points).map(|point| distances.pose_variables(point)).collect();
        let jacobian_entries = || function.jacobian.rows.iter().zip(&function.jacobian.columns).enumerate();
        let of_output = |output: usize| {
            let own = jacobian_entries().filter(move |(_, (row, _))| **row == output);
            own.filter_map(|(entry, (_, &input))| Some((entry, function.contact(input)?))).collect()
        };
        let hessian_entries = || function.hessian.rows.iter().zip(&function.hessian.columns).enumerate();
        let with_input = |input: usize| {
            let partner = move |(entry, (&row, &column)): (usize, (&usize, &usize))| match (row, column) {
                _ if row == input => Some((entry, function.contact(column)?)),
                _ if column == input => Some((entry, function.contact(row)?)),
                _ => None,
            };
            hessian_entries().filter_map(partner).collect()
        };
        let jacobian = (0..function.outputs()).filter_map(|output| {
            let row = |point: usize| rows[output * points + point];
            let slots = |(point, pose): (usize, &[u32; POSE])| pose.map(|c| patterns.jacobian.slot(row(point), c));
            Link::new(of_output(output), || poses.iter().enumerate().map(slots).collect(), None)
        });
        let jacobian = jacobian.collect();
        (0..points).for_each(|point| distances.reserve_curvature(point, &mut patterns.hessian));
        let mixed = (0..function.inputs()).filter(|&input| function.contact(input).is_none()).filter_map(|input| {
            let variable = |point: usize| function.variable(input, point);
            let is_own = |point: usize| poses[point].iter().position(|&c| c == variable(point) && c != ABSENT);
            let slots = |(point, pose): (usize, &[u32; POSE])| {
                pose.map(|c| patterns.hessian.symmetric_slot(variable(point), c))
            };
            let doubled = (0..points).find_map(is_own);
            Link::new(with_input(input), || poses.iter().enumerate().map(slots).collect(), doubled)
        });
        let mixed = mixed.collect();
        Self { jacobian, mixed, adjoint: Some(Batch::new(function.inputs(), points)) }
    }
}

/// Derivatives by components of the contact information, and where their products with its gradients belong.
struct Link {
    /// Nonzeros of the tape with the component that each is a derivative by.
    entries: Vec<(usize, usize)>,
    /// Slots (coordinate of the pose) per point.
    slots: Vec<[u32; POSE]>,
    /// A coordinate whose entry is on the diagonal: a second derivative by one and the same variable occurs twice.
    doubled: Option<usize>,
}

impl Link {
    /// `None` without entries.
    fn new(
        entries: Vec<(usize, usize)>,
        slots: impl FnOnce() -> Vec<[u32; POSE]>,
        doubled: Option<usize>,
    ) -> Option<Self> {
        if entries.is_empty() { None } else { Some(Self { entries, slots: slots(), doubled }) }
    }
}

/// Adds the products of the tape's derivatives with the gradients of the contact information. The gradients of all
/// points are larger than the caches, so that all links take those of a few points.
fn add_links(links: &[Link], values: &Batch, distances: &Distances, slots: &mut [f64]) {
    const FEW: usize = 32;
    let count = distances.last_jacobians().len();
    for start in (0..count).step_by(FEW) {
        let points = start..count.min(start + FEW);
        for link in links {
            let mut sums = [[0.0; POSE]; FEW];
            for &(entry, component) in &link.entries {
                let values = &values.row(entry)[points.clone()];
                let gradients = distances.last_jacobians().skip(start);
                for ((sum, gradients), value) in sums.iter_mut().zip(gradients).zip(values) {
                    for (sum, slope) in sum.iter_mut().zip(&gradients[component]) {
                        *sum += value * slope;
                    }
                }
            }
            for (sum, targets) in sums.iter_mut().zip(&link.slots[points.clone()]) {
                if let Some(coordinate) = link.doubled {
                    sum[coordinate] *= 2.0;
                }
                for (&target, &sum) in targets.iter().zip(&*sum) {
                    add(slots, target, sum);
                }
            }
        }
    }
}
