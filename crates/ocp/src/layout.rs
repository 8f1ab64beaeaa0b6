//! Indices of variables and constraints of the transcription (Eq. discretizedOCP).
//!
//! Stages are numbered 1 to N; the initial states are data. The constraints of the step that leads to a stage belong to
//! that stage. The variables of a stage are those of the reference, followed by those of every scenario; the same holds
//! for rows. The [`Block`]s of a trajectory are in order of declaration within three groups: fronts (states and their
//! dynamics), contact pairs, all others.

use kkt::{Class, Label, Owner};
use nlp::Bounds;
use task::{AssemblyTask, TWIST};

use crate::block::{Block, Blocks, Owners, POSE_VARIABLES};
use crate::point::{Point, Points};

/// Number of components of the contact information `W = (Phi_tau, n~_tau)`.
pub const CONTACT: usize = 1 + TWIST;
/// Number of components of the contact information with the contact point, `W = (Phi_tau, n~_tau, p)`.
pub const CONTACT_AND_POINT: usize = CONTACT + 3;

/// Sizes of a transcription and the indices of its variables and constraints.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layout {
    /// Number of steps `N`.
    pub steps: usize,
    /// Number of scenarios `n_s`.
    pub scenarios: usize,
    /// Number of contact pairs `|Pi|`.
    pub pairs: usize,
    variables: StageOrder,
    rows: StageOrder,
}

/// Order of a stage's variables or rows.
#[derive(Debug, Clone, PartialEq, Eq)]
struct StageOrder {
    reference: TrajectoryOrder,
    /// The same for every scenario.
    scenario: TrajectoryOrder,
}

/// Order of the variables or rows that a stage has of one trajectory.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct TrajectoryOrder {
    /// The blocks, one after the other.
    blocks: Vec<PlacedBlock>,
    /// Class and index of the label at every position.
    labels: Vec<(Class, usize)>,
}

/// A block among the variables or rows of a trajectory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct PlacedBlock {
    name: &'static str,
    start: usize,
    count: usize,
    per_pair: bool,
}

/// The meaning of a variable or constraint row: one of the numbers of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Member {
    /// Name of the block.
    pub block: &'static str,
    /// Stage, 1 to `N`.
    pub stage: usize,
    /// Trajectory.
    pub owner: Owner,
    /// Contact pair, in a block whose members belong to pairs.
    pub pair: Option<usize>,
    /// Number in the block, or among those of the pair, from 0.
    pub component: usize,
}

impl Layout {
    /// Assigns indices to all blocks that the terms of a task declare.
    ///
    /// # Panics
    /// When a trajectory has two blocks of the same name.
    pub fn new(task: &AssemblyTask, blocks: &Blocks) -> Self {
        let pairs = task.pairs.len();
        Self {
            steps: task.horizon.steps,
            scenarios: task.grasps.len() * task.frictions.len(),
            pairs,
            variables: StageOrder::new(&blocks.variables, pairs),
            rows: StageOrder::new(&blocks.rows, pairs),
        }
    }

    /// Number of decision variables.
    pub fn variable_count(&self) -> usize {
        self.steps * self.variables.length(self.scenarios)
    }

    /// Number of constraints.
    pub fn constraint_count(&self) -> usize {
        self.steps * self.rows.length(self.scenarios)
    }

    /// Index of the first variable of a block.
    ///
    /// # Panics
    /// When no term declares the block for this trajectory.
    pub fn variable(&self, name: &str, stage: usize, owner: Owner) -> usize {
        self.variables.index(name, stage, owner, self.scenarios)
    }

    /// Index of the first row of a block.
    ///
    /// # Panics
    /// When no term declares the block for this trajectory.
    pub fn row(&self, name: &str, stage: usize, owner: Owner) -> usize {
        self.rows.index(name, stage, owner, self.scenarios)
    }

    /// Index of the first of 13 coordinates of a trajectory's state: pose (7), then twist (6).
    pub fn state(&self, stage: usize, owner: Owner) -> usize {
        self.variable(POSE_VARIABLES, stage, owner)
    }

    /// All stages of some trajectories: stage by stage, the reference first.
    pub fn stages_of(&self, owners: Owners) -> impl Iterator<Item = (usize, Owner)> + use<> {
        let all = std::iter::once(Owner::Reference).chain((0..self.scenarios).map(Owner::Scenario));
        let wanted: Vec<Owner> = all.filter(|&owner| owners.include(owner)).collect();
        (1..=self.steps).flat_map(move |stage| wanted.clone().into_iter().map(move |owner| (stage, owner)))
    }

    /// All points of a kind in the order of evaluation: pair by pair, stage by stage, the reference first.
    pub fn points(&self, points: Points) -> Vec<Point> {
        let (owners, pairs) = match points {
            Points::Stages(owners) => (owners, 1),
            Points::Pairs => (Owners::Scenarios, self.pairs),
        };
        let stages = |pair| self.stages_of(owners).map(move |(stage, owner)| Point { stage, owner, pair });
        (0..pairs).flat_map(stages).collect()
    }

    /// Bounds of all variables, from the blocks of the layout.
    pub fn variable_bounds(&self, blocks: &Blocks) -> Bounds {
        self.bounds(&self.variables, &blocks.variables)
    }

    /// Bounds of all constraints, from the blocks of the layout.
    pub fn constraint_bounds(&self, blocks: &Blocks) -> Bounds {
        self.bounds(&self.rows, &blocks.rows)
    }

    /// Labels of all variables.
    pub fn variable_labels(&self) -> Vec<Label> {
        self.labels(&self.variables)
    }

    /// Labels of the multipliers of all constraints.
    pub fn multiplier_labels(&self) -> Vec<Label> {
        self.labels(&self.rows)
    }

    /// The meaning of all variables.
    pub fn variable_members(&self) -> Vec<Member> {
        self.members(&self.variables)
    }

    /// The meaning of all constraint rows.
    pub fn row_members(&self) -> Vec<Member> {
        self.members(&self.rows)
    }

    fn bounds(&self, order: &StageOrder, blocks: &[Block]) -> Bounds {
        let count = self.steps * order.length(self.scenarios);
        let mut bounds = Bounds { lower: vec![f64::NAN; count], upper: vec![f64::NAN; count] };
        for Block { name, owners, bounds: declared, .. } in blocks {
            for (stage, owner) in self.stages_of(*owners) {
                let start = order.index(name, stage, owner, self.scenarios);
                bounds.lower[start..][..declared.lower.len()].copy_from_slice(&declared.lower);
                bounds.upper[start..][..declared.upper.len()].copy_from_slice(&declared.upper);
            }
        }
        bounds
    }

    fn labels(&self, order: &StageOrder) -> Vec<Label> {
        let trajectories = self.stages_of(Owners::All);
        let label = |(stage, owner)| {
            let labels = order.of(owner).labels.iter();
            labels.map(move |&(class, index)| Label { stage, owner, class, index })
        };
        trajectories.flat_map(label).collect()
    }

    fn members(&self, order: &StageOrder) -> Vec<Member> {
        let members = |(stage, owner)| {
            let blocks = order.of(owner).blocks.iter();
            blocks.flat_map(move |block| {
                (0..block.count).map(move |number| block.member(number, stage, owner, self.pairs))
            })
        };
        self.stages_of(Owners::All).flat_map(members).collect()
    }
}

impl PlacedBlock {
    fn member(&self, number: usize, stage: usize, owner: Owner, pairs: usize) -> Member {
        let (pair, component) = match self.per_pair {
            true => (Some(number * pairs / self.count), number % (self.count / pairs)),
            false => (None, number),
        };
        Member { block: self.name, stage, owner, pair, component }
    }
}

impl StageOrder {
    fn new(blocks: &[Block], pairs: usize) -> Self {
        Self {
            reference: TrajectoryOrder::new(blocks, Owner::Reference, pairs),
            scenario: TrajectoryOrder::new(blocks, Owner::Scenario(0), pairs),
        }
    }

    fn of(&self, owner: Owner) -> &TrajectoryOrder {
        match owner {
            Owner::Reference => &self.reference,
            Owner::Scenario(_) => &self.scenario,
        }
    }

    /// Number of variables or rows of a stage.
    fn length(&self, scenarios: usize) -> usize {
        self.reference.labels.len() + scenarios * self.scenario.labels.len()
    }

    fn index(&self, name: &str, stage: usize, owner: Owner, scenarios: usize) -> usize {
        let trajectory = match owner {
            Owner::Reference => 0,
            Owner::Scenario(number) => self.reference.labels.len() + number * self.scenario.labels.len(),
        };
        (stage - 1) * self.length(scenarios) + trajectory + self.of(owner).start(name)
    }
}

impl TrajectoryOrder {
    fn new(blocks: &[Block], owner: Owner, pairs: usize) -> Self {
        let mut blocks: Vec<&Block> = blocks.iter().filter(|block| block.owners.include(owner)).collect();
        blocks.sort_by_key(|block| (block.class.is_leaf(), !block.per_pair));
        let mut order = Self::default();
        // Rows of a leaf are eliminated in the order of their indices, those of pairs first.
        let mut next = pairs;
        for block in blocks {
            let known = order.blocks.iter().any(|known| known.name == block.name);
            assert!(!known, "two terms declare the block \"{}\"", block.name);
            let count = block.bounds.lower.len();
            let start = order.labels.len();
            order.blocks.push(PlacedBlock { name: block.name, start, count, per_pair: block.per_pair });
            let index = |member: usize| match (block.class.is_leaf(), block.per_pair) {
                (true, true) => member * pairs / count,
                (true, false) => next + member,
                (false, _) => member,
            };
            order.labels.extend((0..count).map(|member| (block.class, index(member))));
            if block.class.is_leaf() && !block.per_pair {
                next += count;
            }
        }
        order
    }

    fn start(&self, name: &str) -> usize {
        let found = self.blocks.iter().find(|block| block.name == name);
        found.unwrap_or_else(|| panic!("no term declares the block \"{name}\"")).start
    }
}
