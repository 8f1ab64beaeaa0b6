//! Indices of variables and constraints of the transcription (Eq. discretizedOCP).
//!
//! Stages are numbered 1 to N; the initial states are data. The constraints of the step that leads to a stage belong to
//! that stage. The variables of a stage are those of the reference, followed by those of every scenario; the same holds
//! for rows. The [`Block`]s of a trajectory are in order of declaration within three groups: fronts (states and their
//! dynamics), contact pairs, all others.

use kkt::{Class, Label, Owner};
use nlp::Bounds;
use task::{AssemblyTask, TWIST};

use crate::active_contacts::ActiveContacts;
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
    contacts: ActiveContacts,
    variables: StageOrder,
    rows: StageOrder,
}

/// The pair of another layout from which a pair takes its values, if any: of a stage (from 1), a scenario and the pair.
pub type PairSource<'a> = dyn Fn(usize, usize, usize) -> Option<usize> + 'a;

/// Where both layouts have the same pairs.
pub fn same_pair(_stage: usize, _scenario: usize, pair: usize) -> Option<usize> {
    Some(pair)
}

/// Order of the variables or rows, stage by stage.
#[derive(Debug, Clone, PartialEq, Eq)]
struct StageOrder {
    reference: TrajectoryOrder,
    /// The same for every scenario, but for the number of contacts.
    scenario: TrajectoryOrder,
    /// Index of the first one of every trajectory of every stage, the reference first; their number at the end.
    starts: Vec<usize>,
}

/// Order of the variables or rows that a stage has of one trajectory.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct TrajectoryOrder {
    /// The blocks, one after the other.
    blocks: Vec<PlacedBlock>,
}

/// A block among the variables or rows of a trajectory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct PlacedBlock {
    name: &'static str,
    class: Class,
    /// Number of its members, or of those of a pair.
    size: usize,
    per_pair: bool,
    /// Index of the label of the first member, in a leaf without pairs.
    first_label: usize,
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
    /// Assigns indices to all blocks that the terms of a task declare, with all contacts.
    ///
    /// # Panics
    /// When a trajectory has two blocks of the same name.
    pub fn new(task: &AssemblyTask, blocks: &Blocks) -> Self {
        let pairs = task.pairs.len();
        let layout = Self {
            steps: task.horizon.steps,
            scenarios: task.grasps.len() * task.frictions.len(),
            pairs,
            contacts: ActiveContacts::all(task),
            variables: StageOrder::new(&blocks.variables, pairs),
            rows: StageOrder::new(&blocks.rows, pairs),
        };
        layout.with_contacts(layout.contacts.clone())
    }

    /// The same with these contacts.
    pub fn with_contacts(&self, contacts: ActiveContacts) -> Self {
        let started = |order: &StageOrder| {
            let lengths = self.stages_of(Owners::All).map(|(stage, owner)| {
                order.of(owner).blocks.iter().map(|block| block.count(pairs_of(&contacts, stage, owner))).sum()
            });
            let mut starts = vec![0];
            lengths.for_each(|length: usize| starts.push(starts[starts.len() - 1] + length));
            StageOrder { starts, ..order.clone() }
        };
        let (variables, rows) = (started(&self.variables), started(&self.rows));
        Self { contacts, variables, rows, ..*self }
    }

    /// The contacts that it has.
    pub fn contacts(&self) -> &ActiveContacts {
        &self.contacts
    }

    /// Number of decision variables.
    pub fn variable_count(&self) -> usize {
        self.variables.count()
    }

    /// Number of constraints.
    pub fn constraint_count(&self) -> usize {
        self.rows.count()
    }

    /// Index of the first variable of a block. Those of pairs follow in the order of the contacts: [`Point::slot`].
    ///
    /// # Panics
    /// When no term declares the block for this trajectory.
    pub fn variable(&self, name: &str, stage: usize, owner: Owner) -> usize {
        self.index(&self.variables, name, stage, owner)
    }

    /// Index of the first row of a block. Those of pairs follow in the order of the contacts: [`Point::slot`].
    ///
    /// # Panics
    /// When no term declares the block for this trajectory.
    pub fn row(&self, name: &str, stage: usize, owner: Owner) -> usize {
        self.index(&self.rows, name, stage, owner)
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
        match points {
            Points::Stages(owners) => {
                self.stages_of(owners).map(|(stage, owner)| Point { stage, owner, pair: 0, slot: 0 }).collect()
            }
            Points::Pairs => (0..self.pairs).flat_map(|pair| self.contacts_of(pair)).collect(),
        }
    }

    /// The contacts of a pair, stage by stage.
    fn contacts_of(&self, pair: usize) -> impl Iterator<Item = Point> {
        let scenarios = move |stage| (0..self.scenarios).map(move |scenario| (stage, scenario));
        (1..=self.steps).flat_map(scenarios).filter_map(move |(stage, scenario)| {
            let slot = self.contacts.slot(stage, scenario, pair)?;
            Some(Point { stage, owner: Owner::Scenario(scenario), pair, slot })
        })
    }

    /// Values of the variables from those of a layout with other contacts; zero for contacts that are not there.
    pub fn variables_from(&self, other: &Self, values: &[f64], source: &PairSource) -> Vec<f64> {
        self.values_from(&self.variables, (other, &other.variables), values, source)
    }

    /// Values of the rows from those of a layout with other contacts; zero for contacts that are not there.
    pub fn rows_from(&self, other: &Self, values: &[f64], source: &PairSource) -> Vec<f64> {
        self.values_from(&self.rows, (other, &other.rows), values, source)
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
        let mut bounds = Bounds { lower: vec![f64::NAN; order.count()], upper: vec![f64::NAN; order.count()] };
        for Block { name, owners, bounds: declared, per_pair, .. } in blocks {
            for (stage, owner) in self.stages_of(*owners) {
                let repeated = if *per_pair { pairs_of(&self.contacts, stage, owner).len() } else { 1 };
                let start = self.index(order, name, stage, owner);
                let size = declared.lower.len();
                for part in 0..repeated {
                    bounds.lower[start + part * size..][..size].copy_from_slice(&declared.lower);
                    bounds.upper[start + part * size..][..size].copy_from_slice(&declared.upper);
                }
            }
        }
        bounds
    }

    fn labels(&self, order: &StageOrder) -> Vec<Label> {
        let label = |(stage, owner)| {
            let active = pairs_of(&self.contacts, stage, owner);
            let blocks = order.of(owner).blocks.iter();
            blocks.flat_map(move |block| {
                let labels = (0..block.count(active)).map(|number| block.label(number, active));
                labels.map(move |index| Label { stage, owner, class: block.class, index })
            })
        };
        self.stages_of(Owners::All).flat_map(label).collect()
    }

    fn members(&self, order: &StageOrder) -> Vec<Member> {
        let members = |(stage, owner)| {
            let active = pairs_of(&self.contacts, stage, owner);
            let blocks = order.of(owner).blocks.iter();
            blocks.flat_map(move |block| {
                (0..block.count(active)).map(move |number| block.member(number, stage, owner, active))
            })
        };
        self.stages_of(Owners::All).flat_map(members).collect()
    }

    fn values_from(
        &self,
        order: &StageOrder,
        (other, theirs): (&Self, &StageOrder),
        values: &[f64],
        source: &PairSource,
    ) -> Vec<f64> {
        let mut result = Vec::with_capacity(order.count());
        for (stage, owner) in self.stages_of(Owners::All) {
            for PlacedBlock { name, size, per_pair, .. } in &order.of(owner).blocks {
                let from = &values[other.index(theirs, name, stage, owner)..];
                if !per_pair {
                    result.extend_from_slice(&from[..*size]);
                    continue;
                }
                let Owner::Scenario(scenario) = owner else { continue };
                for &pair in pairs_of(&self.contacts, stage, owner) {
                    let pair = source(stage, scenario, pair);
                    match pair.and_then(|pair| other.contacts.slot(stage, scenario, pair)) {
                        Some(slot) => result.extend_from_slice(&from[slot * size..][..*size]),
                        None => result.extend(std::iter::repeat_n(0.0, *size)),
                    }
                }
            }
        }
        result
    }

    fn index(&self, order: &StageOrder, name: &str, stage: usize, owner: Owner) -> usize {
        let trajectory = match owner {
            Owner::Reference => 0,
            Owner::Scenario(number) => 1 + number,
        };
        let active = pairs_of(&self.contacts, stage, owner);
        order.starts[(stage - 1) * (1 + self.scenarios) + trajectory] + order.of(owner).start(name, active)
    }
}

/// The pairs with contacts of a trajectory; none of the reference.
fn pairs_of(contacts: &ActiveContacts, stage: usize, owner: Owner) -> &[usize] {
    match owner {
        Owner::Reference => &[],
        Owner::Scenario(scenario) => contacts.of(stage, scenario),
    }
}

impl PlacedBlock {
    /// Number of members, with the pairs that have contacts.
    fn count(&self, active: &[usize]) -> usize {
        if self.per_pair { self.size * active.len() } else { self.size }
    }

    fn member(&self, number: usize, stage: usize, owner: Owner, active: &[usize]) -> Member {
        let (pair, component) = match self.per_pair {
            true => (Some(active[number / self.size]), number % self.size),
            false => (None, number),
        };
        Member { block: self.name, stage, owner, pair, component }
    }

    /// Index of the label of a member.
    fn label(&self, number: usize, active: &[usize]) -> usize {
        match (self.class.is_leaf(), self.per_pair) {
            (true, true) => active[number / self.size],
            (true, false) => self.first_label + number,
            (false, _) => number,
        }
    }
}

impl StageOrder {
    fn new(blocks: &[Block], pairs: usize) -> Self {
        Self {
            reference: TrajectoryOrder::new(blocks, Owner::Reference, pairs),
            scenario: TrajectoryOrder::new(blocks, Owner::Scenario(0), pairs),
            starts: Vec::new(),
        }
    }

    fn of(&self, owner: Owner) -> &TrajectoryOrder {
        match owner {
            Owner::Reference => &self.reference,
            Owner::Scenario(_) => &self.scenario,
        }
    }

    /// Number of variables or rows.
    fn count(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }
}

impl TrajectoryOrder {
    fn new(blocks: &[Block], owner: Owner, pairs: usize) -> Self {
        let mut blocks: Vec<&Block> = blocks.iter().filter(|block| block.owners.include(owner)).collect();
        blocks.sort_by_key(|block| (block.class.is_leaf(), !block.per_pair));
        let mut order = Self::default();
        // Rows of a leaf are eliminated in the order of their indices, those of pairs first.
        let mut first_label = pairs;
        for &Block { name, class, per_pair, ref bounds, .. } in blocks {
            let known = order.blocks.iter().any(|known| known.name == name);
            assert!(!known, "two terms declare the block \"{name}\"");
            let size = bounds.lower.len();
            order.blocks.push(PlacedBlock { name, class, size, per_pair, first_label });
            if class.is_leaf() && !per_pair {
                first_label += size;
            }
        }
        order
    }

    fn start(&self, name: &str, active: &[usize]) -> usize {
        let place = self.blocks.iter().position(|block| block.name == name);
        let place = place.unwrap_or_else(|| panic!("no term declares the block \"{name}\""));
        self.blocks[..place].iter().map(|block| block.count(active)).sum()
    }
}
