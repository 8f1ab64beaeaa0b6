//! The elimination plan, made once for all matrices of a pattern.

use crate::error::StructureError;
use crate::front::assembly::{Assembly, Place, Target};
use crate::front::general::GeneralLayout;
use crate::front::poses::PoseLayout;
use crate::grouping::{Entry, Grouping, group};
use crate::kernel::padded;
use crate::label::Label;
use crate::leaf::Leaf;

/// One way to factorise a front.
#[derive(Debug)]
pub struct Plan<Layout> {
    pub layout: Layout,
    pub assembly: Assembly,
    /// Start of its values in the store of all stages.
    pub offset: usize,
}

/// A stage's front.
#[derive(Debug)]
pub struct Stage {
    /// Rows of the front.
    pub front: Vec<usize>,
    /// Rows of the separator, which belong to the previous stage.
    pub separator: Vec<usize>,
    /// Leaves that are eliminated before it.
    pub leaves: std::ops::Range<usize>,
    /// Place of every row of each leaf's boundary.
    pub leaf_places: Vec<Vec<Place>>,
    /// Place of every row of the next stage's separator.
    pub later_places: Vec<Place>,
    pub general: Plan<GeneralLayout>,
    /// The fast path, if the poses can be eliminated first.
    pub fast: Option<Plan<PoseLayout>>,
    /// Start of its pivots in the list of all stages.
    pub pivots: usize,
    /// Number of multipliers, including those of the leaves.
    pub multipliers: usize,
}

/// The pattern of a KKT matrix, stage by stage.
#[derive(Debug)]
pub struct Symbolic {
    pub stages: Vec<Stage>,
    pub leaves: Vec<Leaf>,
    /// Number of stored values of all fronts on the general path.
    pub general_store: usize,
    /// Number of stored values of all fronts on the fast path.
    pub fast_store: usize,
    /// Whether a surplus of negative pivots in the last stages proves the inertia wrong: every multiplier is coupled
    /// with variables of its own and earlier stages only.
    pub causal: bool,
}

impl Symbolic {
    /// Plans the elimination of a matrix with the given entries of its lower triangle.
    pub fn new(labels: &[Label], rows: &[usize], columns: &[usize]) -> Result<Self, StructureError> {
        let grouping = group(labels, rows, columns)?;
        let mut local = vec![0; labels.len()];
        let mut leaves = Vec::with_capacity(grouping.leaves.len());
        for group in &grouping.leaves {
            leaves.push(Leaf::new(group, &grouping, labels, &mut local));
        }
        let causal = is_causal(labels, rows, columns);
        let mut symbolic = Self { stages: Vec::new(), leaves, general_store: 0, fast_store: 0, causal };
        let mut pivots = 0;
        for index in 0..grouping.stages() {
            let stage = symbolic.plan_stage(&grouping, labels, index, pivots);
            pivots += stage.front.len();
            symbolic.general_store += padded(stage.general.layout.store());
            symbolic.fast_store += stage.fast.as_ref().map_or(0, |plan| padded(plan.layout.store));
            symbolic.stages.push(stage);
        }
        Ok(symbolic)
    }

    /// Leaves of a stage.
    pub fn leaves_of(&self, stage: usize) -> &[Leaf] {
        &self.leaves[self.stages[stage].leaves.clone()]
    }

    fn plan_stage(&self, grouping: &Grouping, labels: &[Label], index: usize, pivots: usize) -> Stage {
        let places = Places::new(grouping, index);
        let front = grouping.fronts[index].clone();
        let separator = grouping.separators[index].clone();
        let leaves = grouping.stage_leaves[index].clone();
        let blocks = Blocks {
            leaves: self.leaves[leaves.clone()].iter().map(|leaf| (places.of(&leaf.boundary), leaf.width)).collect(),
            later: grouping.separators.get(index + 1).map(|rows| places.of(rows)).unwrap_or_default(),
        };
        let multipliers = front.iter().filter(|&&row| labels[row].class.is_multiplier()).count();
        let of_leaves: usize = self.leaves[leaves.clone()].iter().map(|leaf| leaf.multipliers).sum();
        let entries: Vec<(Place, Place, Entry)> = grouping.front_entries[index]
            .iter()
            .map(|&entry| (places.one(entry.row), places.one(entry.column), entry))
            .collect();
        let layout = GeneralLayout { order: front.len(), separator: separator.len() };
        let assembly = assemble(&entries, &blocks, |row, column| Some(layout.target(row, column)));
        let front_labels: Vec<Label> = front.iter().map(|&row| labels[row]).collect();
        Stage {
            leaves,
            general: Plan { layout, assembly: assembly.unwrap_or_default(), offset: self.general_store },
            fast: self.plan_fast_path(&front_labels, separator.len(), entries, &blocks),
            leaf_places: blocks.leaves.into_iter().map(|(places, _)| places).collect(),
            later_places: blocks.later,
            front,
            separator,
            pivots,
            multipliers: multipliers + of_leaves,
        }
    }

    fn plan_fast_path(
        &self,
        front: &[Label],
        separator: usize,
        mut entries: Vec<(Place, Place, Entry)>,
        blocks: &Blocks,
    ) -> Option<Plan<PoseLayout>> {
        let layout = PoseLayout::new(front, separator, &entries)?;
        entries.retain(|&(row, column, _)| !layout.is_kinematic(row, column));
        let assembly = assemble(&entries, blocks, |row, column| layout.target(row, column))?;
        Some(Plan { layout, assembly, offset: self.fast_store })
    }
}

/// The symmetric blocks that are added to a front, by the places of their rows.
struct Blocks {
    /// Places of every block's rows, with the block's stride.
    leaves: Vec<(Vec<Place>, usize)>,
    later: Vec<Place>,
}

/// Places of rows of the matrix in a stage.
struct Places<'a> {
    grouping: &'a Grouping,
    stage: usize,
}

impl<'a> Places<'a> {
    fn new(grouping: &'a Grouping, stage: usize) -> Self {
        Self { grouping, stage }
    }

    fn one(&self, row: usize) -> Place {
        let position = self.grouping.role[row].position();
        if self.grouping.stage[row] == self.stage {
            return Place::Front(position);
        }
        let separator = &self.grouping.separators[self.stage];
        // A separator keeps the order of the previous front and has a few dozen rows.
        Place::Separator(separator.partition_point(|&other| self.grouping.role[other].position() < position))
    }

    fn of(&self, rows: &[usize]) -> Vec<Place> {
        rows.iter().map(|&row| self.one(row)).collect()
    }
}

/// Plans the assembly of a front in a layout; `None` when the layout has no place for a coupling.
fn assemble(
    entries: &[(Place, Place, Entry)],
    blocks: &Blocks,
    target: impl Fn(Place, Place) -> Option<Target>,
) -> Option<Assembly> {
    let mut assembly = Assembly::default();
    for &(row, column, entry) in entries {
        assembly.add_entry(target(row, column)?, entry.source);
    }
    for (boundary, stride) in &blocks.leaves {
        assembly.add_block(boundary, *stride, &target)?;
    }
    assembly.add_block(&blocks.later, padded(blocks.later.len()), &target)?;
    Some(assembly)
}

/// Whether every multiplier is coupled with variables of its own and earlier stages only.
fn is_causal(labels: &[Label], rows: &[usize], columns: &[usize]) -> bool {
    rows.iter().zip(columns).all(|(&row, &column)| {
        let (first, second) = (&labels[row], &labels[column]);
        match (first.class.is_multiplier(), second.class.is_multiplier()) {
            (true, true) => row == column,
            (true, false) => second.stage <= first.stage,
            (false, true) => first.stage <= second.stage,
            (false, false) => true,
        }
    })
}
