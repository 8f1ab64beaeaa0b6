//! Factorisation of the fronts, stage by stage, backward in time, and solves with their factors.

use pulp::Arch;

use crate::front::assembly::Place;
use crate::front::general::{FrontFactors, FrontNumbers, SolveGeneral};
use crate::front::pose_elimination::{EliminatePoses, SolvePoses, work_length as pose_work_length};
use crate::kernel::{Aligned, padded};
use crate::leaf::factors::LeafUpdate;
use crate::pivot::{Breakdown, Pivots};
use crate::symbolic::{Stage, Symbolic};

/// Factors of the fronts of all stages.
#[derive(Debug)]
pub struct Fronts {
    arch: Arch,
    /// Fronts whose poses were eliminated first.
    fast_store: Aligned,
    /// Fronts that were factorised as one dense block; allocated on first use.
    general_store: Aligned,
    diagonal: Vec<f64>,
    subdiagonal: Vec<f64>,
    order: Vec<u32>,
    /// Whether each stage's poses were eliminated first.
    fast: Vec<bool>,
    work: Work,
    /// Largest sum of the terms of a pivot.
    largest_scale: f64,
}

/// Scratch of one stage.
#[derive(Debug, Default)]
struct Work {
    /// Schur complement of the current stage.
    schur: Aligned,
    /// Schur complement of the next stage.
    later: Aligned,
    /// Sums of the absolute values of the terms of the front's diagonal, then of its separator.
    scale: Aligned,
    /// The same for the next stage's separator.
    later_scale: Vec<f64>,
    columns: Aligned,
    poses: Aligned,
    solve: Aligned,
}

impl Fronts {
    /// Allocates all factors.
    pub fn new(symbolic: &Symbolic, arch: Arch) -> Self {
        let pivots = symbolic.stages.iter().map(|stage| stage.front.len()).sum();
        let mut work = Work::default();
        for stage in &symbolic.stages {
            let layout = stage.general.layout;
            let schur = padded(layout.separator) * layout.separator;
            work.schur.reserve(schur);
            work.later.reserve(schur);
            work.scale.reserve(layout.stride());
            work.columns.reserve(crate::front::bunch_kaufman::work_length(layout.stride()));
            work.solve.reserve(layout.stride());
            if let Some(plan) = &stage.fast {
                work.poses.reserve(pose_work_length(&plan.layout));
                work.solve.reserve(plan.layout.rest.stride() + 2 * padded(plan.layout.poses));
            }
        }
        Self {
            arch,
            fast_store: Aligned::new(symbolic.fast_store),
            general_store: Aligned::default(),
            diagonal: vec![0.0; pivots],
            subdiagonal: vec![0.0; pivots],
            order: vec![0; pivots],
            fast: vec![false; symbolic.stages.len()],
            work,
            largest_scale: 0.0,
        }
    }

    /// Largest sum of the terms of a pivot of the last factorisation.
    pub fn largest_scale(&self) -> f64 {
        self.largest_scale
    }

    /// Forgets the last factorisation.
    pub fn begin(&mut self) {
        self.largest_scale = 0.0;
    }

    /// Whether the poses of a stage were eliminated first.
    pub fn is_fast(&self, stage: usize) -> bool {
        self.fast[stage]
    }

    /// Factorises the front of a stage, after that of the next one, from the values of the matrix and what the leaves
    /// of the stage add. Returns its number of negative pivots.
    pub fn factorise(
        &mut self,
        symbolic: &Symbolic,
        index: usize,
        values: &[f64],
        leaves: &[LeafUpdate],
    ) -> Result<usize, Breakdown> {
        let stage = &symbolic.stages[index];
        let fast = stage.fast.as_ref().filter(|plan| {
            let store = &mut self.fast_store[plan.offset..][..plan.layout.store];
            plan.layout.prepare(values, store)
        });
        self.fast[index] = fast.is_some();
        let (store, assembly) = match fast {
            Some(plan) => (&mut self.fast_store[plan.offset..][..plan.layout.blocks[0].inverse], &plan.assembly),
            None => {
                self.general_store.reserve(symbolic.general_store);
                let plan = &stage.general;
                (&mut self.general_store[plan.offset..][..plan.layout.store()], &plan.assembly)
            }
        };
        let work = &mut self.work;
        store.fill(0.0);
        work.schur[..padded(stage.separator.len()) * stage.separator.len()].fill(0.0);
        work.scale[..stage.general.layout.stride()].fill(0.0);
        assembly.scatter_entries(values, store, &mut work.schur);
        let place_of = |place: Place| stage.scale_row(fast.is_some(), place);
        for (number, leaf) in leaves.iter().enumerate() {
            assembly.scatter_block(number, &leaf.schur, store, &mut work.schur);
            for (&place, &scale) in stage.leaf_places[number].iter().zip(&*leaf.scale) {
                place_of(place).into_iter().for_each(|row| work.scale[row] += scale);
            }
        }
        assembly.scatter_block(stage.leaves.len(), &work.later, store, &mut work.schur);
        for (&place, &scale) in stage.later_places.iter().zip(&work.later_scale) {
            place_of(place).into_iter().for_each(|row| work.scale[row] += scale);
        }
        self.factorise_assembled(stage, fast.is_some())
    }

    /// Factorises an assembled front and passes its Schur complement to the previous stage.
    fn factorise_assembled(&mut self, stage: &Stage, fast: bool) -> Result<usize, Breakdown> {
        let (arch, work) = (self.arch, &mut self.work);
        let (layout, store, eliminated) = match &stage.fast {
            Some(plan) if fast => {
                let store = &mut self.fast_store[plan.offset..][..plan.layout.store];
                let (schur, scale, poses) = (&mut *work.schur, &mut *work.scale, &mut *work.poses);
                let poses = &mut poses[..pose_work_length(&plan.layout)];
                EliminatePoses { arch, layout: &plan.layout, store, schur, scale, work: poses }.run();
                (plan.layout.rest, &mut self.fast_store[plan.offset..], plan.layout.poses)
            }
            _ => (stage.general.layout, &mut self.general_store[stage.general.offset..], 0),
        };
        let pivots = stage.pivots..stage.pivots + layout.order;
        let numbers = FrontNumbers {
            store,
            schur: &mut work.schur,
            scale: &mut work.scale,
            work: &mut work.columns,
            pivots: Pivots {
                diagonal: &mut self.diagonal[pivots.clone()],
                subdiagonal: &mut self.subdiagonal[pivots.clone()],
                order: &mut self.order[pivots],
            },
        };
        let negative = layout.factorise(arch, numbers)?;
        let separator = padded(layout.order);
        let largest = work.scale[..layout.stride()].iter().fold(0.0, |largest: f64, &scale| largest.max(scale));
        self.largest_scale = self.largest_scale.max(largest);
        work.later_scale.clear();
        work.later_scale.extend_from_slice(&work.scale[separator..separator + layout.separator]);
        std::mem::swap(&mut work.schur, &mut work.later);
        Ok(negative + eliminated)
    }

    /// The forward sweep of a solve through a stage, in place.
    pub fn solve_forward(&mut self, symbolic: &Symbolic, index: usize, values: &mut [f64]) {
        self.sweep_poses(&symbolic.stages[index], index, values, false);
        self.sweep_front(&symbolic.stages[index], index, values, false);
    }

    /// The backward sweep of a solve through a stage, in place.
    pub fn solve_backward(&mut self, symbolic: &Symbolic, index: usize, values: &mut [f64]) {
        self.sweep_front(&symbolic.stages[index], index, values, true);
        self.sweep_poses(&symbolic.stages[index], index, values, true);
    }

    fn sweep_poses(&mut self, stage: &Stage, index: usize, values: &mut [f64], backward: bool) {
        let Some(plan) = stage.fast.as_ref().filter(|_| self.fast[index]) else { return };
        self.arch.dispatch(SolvePoses {
            layout: &plan.layout,
            store: &self.fast_store[plan.offset..][..plan.layout.store],
            front: &stage.front,
            separator: &stage.separator,
            values,
            work: &mut self.work.solve,
            backward,
        });
    }

    fn sweep_front(&mut self, stage: &Stage, index: usize, values: &mut [f64], backward: bool) {
        let (layout, store, first) = match &stage.fast {
            Some(plan) if self.fast[index] => {
                (plan.layout.rest, &self.fast_store[plan.offset..], 2 * plan.layout.poses)
            }
            _ => (stage.general.layout, &self.general_store[stage.general.offset..], 0),
        };
        let pivots = stage.pivots..stage.pivots + layout.order;
        let factors = FrontFactors {
            store,
            diagonal: &self.diagonal[pivots.clone()],
            subdiagonal: &self.subdiagonal[pivots.clone()],
            order: &self.order[pivots],
            front: &stage.front[first..],
            separator: &stage.separator,
        };
        self.arch.dispatch(SolveGeneral { layout, factors, values, work: &mut self.work.solve, backward });
    }
}

impl Stage {
    /// Place of the scale of a row of the stage; `None` for poses, which are eliminated without pivots.
    fn scale_row(&self, fast: bool, place: Place) -> Option<usize> {
        match (&self.fast, place) {
            (Some(plan), _) if fast => plan.layout.rest_row(place),
            (_, Place::Front(position)) => Some(position),
            (_, Place::Separator(position)) => Some(padded(self.front.len()) + position),
        }
    }
}
