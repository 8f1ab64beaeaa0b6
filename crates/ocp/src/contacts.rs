//! Contact in the transcription (Eq. ts, Eq. ts3): a tape per pair that takes the contact information as an input, and
//! the chain rule through the distances that were evaluated outside it.

use autodiff::Batch;
use nlp::EvaluationError;
use task::{AssemblyTask, POSE, TWIST};

use crate::distances::Distances;
use crate::function::{PointFunction, Source, scatter};
use crate::layout::{CONTACT, Layout};
use crate::model::{self, CONTACT_VARIABLES};
use crate::pattern::{ABSENT, PatternBuilder, add};

/// All pairs in all steps of all scenarios. Point `pair * poses + pose` of the tape belongs to pose
/// `(stage - 1) n_s + scenario` of [`Distances`].
pub struct Contacts {
    layout: Layout,
    distances: Distances,
    function: PointFunction,
    rows: Vec<u32>,
    /// Tape nonzeros by variables, per (nonzero, point); nonzeros by contact information are absent.
    jacobian_slots: Vec<u32>,
    /// Entries (output, previous pose coordinate) per point.
    chained_jacobian_slots: Vec<[[u32; POSE]; OUTPUTS]>,
    hessian_slots: Vec<u32>,
    chained_hessian_slots: Vec<ChainedSlots>,
    adjoint: Batch,
    seeds: Vec<Vec<[f64; CONTACT]>>,
}

/// Outputs of the contact tape: velocity defect (6), gap, product.
const OUTPUTS: usize = TWIST + 2;

/// Hessian entries that a point's distance derivatives fill.
struct ChainedSlots {
    /// Previous pose with previous pose.
    pose: [[u32; POSE]; POSE],
    /// Variables of the tape (twist, contact force) with previous pose.
    mixed: [[u32; POSE]; CONTACT_VARIABLES],
}

impl Contacts {
    /// Records the tape and adds all entries to the two patterns.
    pub fn new(
        task: &AssemblyTask,
        layout: Layout,
        initial_poses: &[[f64; POSE]],
        jacobian: &mut PatternBuilder,
        hessian: &mut PatternBuilder,
    ) -> Self {
        let place = Placement { layout };
        let points = layout.pairs * place.poses();
        let tape = model::contact(task);
        let function = PointFunction::new(tape, CONTACT_VARIABLES + CONTACT, points, |input, point| {
            place.variable(input, point).map_or(Source::Constant(0.0), Source::Variable)
        });
        let mut rows = Vec::with_capacity(OUTPUTS * points);
        for output in 0..OUTPUTS {
            rows.extend((0..points).map(|point| place.row(output, point) as u32));
        }
        let pattern = &function.jacobian;
        let mut jacobian_slots = Vec::with_capacity(pattern.rows.len() * points);
        for (&output, &input) in pattern.rows.iter().zip(&pattern.columns) {
            for point in 0..points {
                jacobian_slots.push(jacobian.slot(rows[output * points + point], function.variable(input, point)));
            }
        }
        let chained_jacobian_slots = (0..points)
            .map(|point| {
                let pose = place.previous_pose(point);
                std::array::from_fn(|output| pose.map(|column| jacobian.slot(rows[output * points + point], column)))
            })
            .collect();
        let hessian_slots = crate::function::hessian_slots(&function, hessian);
        let chained_hessian_slots = (0..points).map(|point| ChainedSlots::new(&place, point, hessian)).collect();
        Self {
            layout,
            distances: Distances::new(&task.pairs, layout, initial_poses),
            rows,
            jacobian_slots,
            chained_jacobian_slots,
            hessian_slots,
            chained_hessian_slots,
            adjoint: Batch::new(CONTACT_VARIABLES + CONTACT, points),
            seeds: vec![vec![[0.0; CONTACT]; place.poses()]; layout.pairs],
            function,
        }
    }

    /// Smoothing parameter of the distances.
    pub fn set_tau(&mut self, tau: f64) {
        self.distances.set_tau(tau);
    }

    /// Takes the decision variables from `x`.
    pub fn set_point(&mut self, x: &[f64]) {
        self.function.set_point(x);
        self.distances.set_point(x);
    }

    /// The distances at the current point.
    pub fn distances(&mut self) -> &mut Distances {
        &mut self.distances
    }

    /// Adds the contact terms to the constraints.
    pub fn add_values(&mut self, constraints: &mut [f64]) -> Result<(), EvaluationError> {
        self.distances.values()?;
        self.take_contact_information()?;
        let points = self.function.points();
        let values = self.function.values();
        for output in 0..OUTPUTS {
            scatter(values.row(output), &self.rows[output * points..(output + 1) * points], constraints);
        }
        Ok(())
    }

    /// Adds the contact terms to the Jacobian's slots: `d/dx + d/dW DW`.
    pub fn add_jacobian(&mut self, slots: &mut [f64]) -> Result<(), EvaluationError> {
        self.distances.jacobians()?;
        self.take_contact_information()?;
        let points = self.function.points();
        self.function.jacobian_values();
        let pattern = &self.function.jacobian;
        let values = self.function.evaluated_jacobian();
        let derivatives = self.distances.last_jacobians();
        for (entry, (&output, &input)) in pattern.rows.iter().zip(&pattern.columns).enumerate() {
            let row = values.row(entry);
            if input < CONTACT_VARIABLES {
                scatter(row, &self.jacobian_slots[entry * points..(entry + 1) * points], slots);
                continue;
            }
            let gradients = derivatives.iter().flatten().map(|derivative| &derivative[input - CONTACT_VARIABLES]);
            for ((&value, gradient), targets) in row.iter().zip(gradients).zip(&self.chained_jacobian_slots) {
                for (&slope, &target) in gradient.iter().zip(&targets[output]) {
                    add(slots, target, value * slope);
                }
            }
        }
        Ok(())
    }

    /// Adds the contact terms to the Hessian's slots. With `s_W` the adjoint of the contact information, the distances
    /// add `<s_W, D2W>` (Eq. secondderw) and `DW'` times the mixed derivatives of the tape.
    pub fn add_hessian(&mut self, multipliers: &[f64], slots: &mut [f64]) -> Result<(), EvaluationError> {
        self.distances.values()?;
        self.take_contact_information()?;
        let points = self.function.points();
        for output in 0..OUTPUTS {
            let rows = &self.rows[output * points..(output + 1) * points];
            for (value, &row) in self.function.multiplier_mut(output).iter_mut().zip(rows) {
                *value = multipliers[row as usize];
            }
        }
        self.function.adjoint(&mut self.adjoint);
        for (component, seeds) in (CONTACT_VARIABLES..).zip(0..CONTACT) {
            let row = self.adjoint.row(component);
            for (seed, &value) in self.seeds.iter_mut().flatten().zip(row) {
                seed[seeds] = value;
            }
        }
        self.add_distance_curvature(slots)?;
        self.add_tape_curvature(slots);
        Ok(())
    }

    fn add_distance_curvature(&mut self, slots: &mut [f64]) -> Result<(), EvaluationError> {
        let hessians = self.distances.hessians(&self.seeds)?;
        for (hessian, targets) in hessians.iter().flatten().zip(&self.chained_hessian_slots) {
            if targets.pose[0][0] == ABSENT {
                continue;
            }
            for row in 0..POSE {
                for column in 0..=row {
                    add(slots, targets.pose[row][column], hessian[row][column]);
                }
            }
        }
        Ok(())
    }

    fn add_tape_curvature(&mut self, slots: &mut [f64]) {
        let points = self.function.points();
        self.function.hessian_values();
        let values = self.function.evaluated_hessian();
        let pattern = &self.function.hessian;
        let derivatives = self.distances.last_jacobians();
        for (entry, (&row, &column)) in pattern.rows.iter().zip(&pattern.columns).enumerate() {
            let values = values.row(entry);
            if row < CONTACT_VARIABLES {
                scatter(values, &self.hessian_slots[entry * points..(entry + 1) * points], slots);
                continue;
            }
            // The tape is linear in W, so that W meets only variables here.
            let gradients = derivatives.iter().flatten().map(|derivative| &derivative[row - CONTACT_VARIABLES]);
            for ((&value, gradient), targets) in values.iter().zip(gradients).zip(&self.chained_hessian_slots) {
                for (&slope, &target) in gradient.iter().zip(&targets.mixed[column]) {
                    add(slots, target, value * slope);
                }
            }
        }
    }

    fn take_contact_information(&mut self) -> Result<(), EvaluationError> {
        let values = self.distances.values()?;
        for component in 0..CONTACT {
            let inputs = self.function.input_mut(CONTACT_VARIABLES + component);
            for (input, contact) in inputs.iter_mut().zip(values.iter().flatten()) {
                *input = contact[component];
            }
        }
        debug_assert_eq!(values.len(), self.layout.pairs);
        Ok(())
    }
}

impl ChainedSlots {
    fn new(place: &Placement, point: usize, hessian: &mut PatternBuilder) -> Self {
        let pose = place.previous_pose(point);
        Self {
            pose: pose.map(|row| pose.map(|column| hessian.symmetric_slot(row, column))),
            mixed: std::array::from_fn(|input| {
                let variable = place.variable(input, point).map_or(ABSENT, |index| index as u32);
                pose.map(|column| hessian.symmetric_slot(variable, column))
            }),
        }
    }
}

/// Where the inputs and outputs of a point of the contact tape stand.
struct Placement {
    layout: Layout,
}

impl Placement {
    fn poses(&self) -> usize {
        self.layout.steps * self.layout.scenarios
    }

    /// (stage, scenario, pair) of a point.
    fn locate(&self, point: usize) -> (usize, usize, usize) {
        let (pair, pose) = (point / self.poses(), point % self.poses());
        (pose / self.layout.scenarios + 1, pose % self.layout.scenarios, pair)
    }

    /// Decision variable behind an input; contact information has none.
    fn variable(&self, input: usize, point: usize) -> Option<usize> {
        let (stage, scenario, pair) = self.locate(point);
        match input {
            0..TWIST => Some(self.layout.compliant(stage, scenario) + POSE + input),
            TWIST => Some(self.layout.contact_force(stage, scenario, pair)),
            _ => None,
        }
    }

    fn row(&self, output: usize, point: usize) -> usize {
        let (stage, scenario, pair) = self.locate(point);
        match output {
            0..TWIST => self.layout.velocity_dynamics(stage, scenario) + output,
            TWIST => self.layout.gap(stage, scenario, pair),
            _ => self.layout.complementarity(stage, scenario, pair),
        }
    }

    /// Variables of the pose before the step, absent when it is the initial pose.
    fn previous_pose(&self, point: usize) -> [u32; POSE] {
        let (stage, scenario, _) = self.locate(point);
        if stage == 1 {
            return [ABSENT; POSE];
        }
        let start = self.layout.compliant(stage - 1, scenario);
        std::array::from_fn(|coordinate| (start + coordinate) as u32)
    }
}
