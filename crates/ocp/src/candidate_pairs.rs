//! Broad phase: pairs that may touch.
//!
//! Most pairs of parts with many pieces never touch, but each has variables and constraints at every step. A homotopy
//! step with a warm start culls the pairs that stay far apart there. If a culled pair penetrates in the solution, it is
//! added and the solve continues.

use nlp::Iterate;
use task::{AssemblyTask, ContactPair, Trajectory};

use crate::layout::Member;
use crate::transcription::Transcription;

/// Candidate pairs come closer than this fraction of the size of the largest part of the body.
const NEAR: f64 = 0.0125;

/// The candidate pairs of a task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CandidatePairs {
    /// One per pair.
    is_candidate: Vec<bool>,
}

impl CandidatePairs {
    /// The pairs whose exact shapes come near at a point `x`. Smoothed distances are longer: with much smoothing, even
    /// between parts that penetrate.
    pub fn at(x: &[f64], transcription: &Transcription) -> Self {
        let pairs = &transcription.task().pairs;
        let largest = pairs.iter().map(|pair| pair.shapes.body().size()).fold(0.0, f64::max);
        let poses: Vec<_> = transcription.compliant_states(x).iter().flatten().map(|state| state.pose().0).collect();
        let is_candidate = |pair: &ContactPair| {
            let is_far = |distance: &f64| *distance >= NEAR * largest;
            !pair.shapes.exact_distances(&poses).iter().all(is_far)
        };
        Self { is_candidate: pairs.iter().map(is_candidate).collect() }
    }

    /// Whether no pair is left out.
    pub fn are_all(&self) -> bool {
        self.is_candidate.iter().all(|&is_candidate| is_candidate)
    }

    /// These and the culled pairs that penetrate in a motion. `None` when there are none.
    pub fn with_missing(&self, motion: &Trajectory) -> Option<Self> {
        let contacts = motion.scenarios.iter().flat_map(|scenario| &scenario.contacts);
        let penetrates = |pair: usize| !contacts.clone().all(|contacts| contacts[pair].distance >= 0.0);
        let is_candidate =
            (0..).zip(&self.is_candidate).map(|(pair, &is_candidate)| is_candidate || penetrates(pair)).collect();
        let more = Self { is_candidate };
        (more != *self).then_some(more)
    }

    /// The task without the culled pairs.
    pub fn of_task(&self, task: &AssemblyTask) -> AssemblyTask {
        let pairs = task.pairs.iter().zip(&self.is_candidate).filter(|&(_, &is_candidate)| is_candidate);
        AssemblyTask { pairs: pairs.map(|(pair, _)| pair.clone()).collect(), ..task.clone() }
    }

    /// A point of the transcription of all pairs, restricted to the candidates.
    pub fn restrict(&self, point: &Iterate, all: &Transcription) -> Iterate {
        let (variables, rows) = self.indices(all);
        let chosen = |values: &[f64], indices: &[usize]| indices.iter().map(|&index| values[index]).collect();
        Iterate {
            x: chosen(&point.x, &variables),
            constraint_multipliers: chosen(&point.constraint_multipliers, &rows),
            lower_multipliers: chosen(&point.lower_multipliers, &variables),
            upper_multipliers: chosen(&point.upper_multipliers, &variables),
        }
    }

    /// A point of the candidates, extended to all pairs: the others exert no force.
    pub fn extend(&self, point: &Iterate, all: &Transcription) -> Iterate {
        let (variables, rows) = self.indices(all);
        let placed = |values: &[f64], indices: &[usize], count: usize| {
            let mut of_all = vec![0.0; count];
            indices.iter().zip(values).for_each(|(&index, &value)| of_all[index] = value);
            of_all
        };
        let count = all.layout().variable_count();
        Iterate {
            x: placed(&point.x, &variables, count),
            constraint_multipliers: placed(&point.constraint_multipliers, &rows, all.layout().constraint_count()),
            lower_multipliers: placed(&point.lower_multipliers, &variables, count),
            upper_multipliers: placed(&point.upper_multipliers, &variables, count),
        }
    }

    /// Indices of the variables and rows that the transcription of the candidates has, in the same order.
    fn indices(&self, all: &Transcription) -> (Vec<usize>, Vec<usize>) {
        let there = |members: Vec<Member>| -> Vec<usize> {
            let is_there = |member: &Member| member.pair.is_none_or(|pair| self.is_candidate[pair]);
            (0..).zip(&members).filter(|(_, member)| is_there(member)).map(|(index, _)| index).collect()
        };
        (there(all.layout().variable_members()), there(all.layout().row_members()))
    }
}
