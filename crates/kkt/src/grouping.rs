//! Assigns every row to a front or leaf and every entry to the place where it is assembled.

use crate::error::StructureError;
use crate::label::{Class, Label, Owner};

/// Where a row is eliminated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// At a position of its stage's front.
    Front(usize),
    /// In a leaf, at a position of the leaf's list.
    Leaf(usize, usize),
}

impl Role {
    /// Position in the front or leaf.
    pub fn position(self) -> usize {
        match self {
            Self::Front(position) | Self::Leaf(_, position) => position,
        }
    }
}

/// An entry of the matrix: row, column, position among its values.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    pub row: usize,
    pub column: usize,
    pub source: usize,
}

/// Rows by stage and leaf; entries by the place where they are assembled.
#[derive(Debug, Default)]
pub struct Grouping {
    /// Stage of every row, from 0.
    pub stage: Vec<usize>,
    pub role: Vec<Role>,
    /// Rows of every stage's front: poses, their multipliers, the rest.
    pub fronts: Vec<Vec<usize>>,
    /// Rows of every stage's separator: those of the previous front that it is coupled with, in that front's order.
    pub separators: Vec<Vec<usize>>,
    /// Entries between rows of a front, or of a front and its separator.
    pub front_entries: Vec<Vec<Entry>>,
    /// All leaves; those of a stage are consecutive.
    pub leaves: Vec<Group>,
    /// Range of each stage in `leaves`.
    pub stage_leaves: Vec<std::ops::Range<usize>>,
}

/// A leaf: rows of one stage and owner that are eliminated before the front.
#[derive(Debug, Default)]
pub struct Group {
    pub rows: Vec<usize>,
    /// Rows of fronts that the leaf is coupled with.
    pub boundary: Vec<usize>,
    /// Entries whose row belongs to the leaf.
    pub entries: Vec<Entry>,
}

/// Sorts the rows of a matrix and checks its entries.
pub fn group(labels: &[Label], rows: &[usize], columns: &[usize]) -> Result<Grouping, StructureError> {
    let mut grouping = sort_rows(labels)?;
    for (source, (&row, &column)) in rows.iter().zip(columns).enumerate() {
        if let Err(reason) = grouping.add(Entry { row, column, source }) {
            let (first, second) = (labels[row], labels[column]);
            return Err(StructureError::Coupling { row, column, first, second, reason });
        }
    }
    grouping.collect_separators();
    Ok(grouping)
}

/// Distributes the rows over fronts and leaves.
fn sort_rows(labels: &[Label]) -> Result<Grouping, StructureError> {
    if let Some(row) = labels.iter().position(|label| label.stage == 0) {
        return Err(StructureError::Stage { row, label: labels[row] });
    }
    let stages = labels.iter().map(|label| label.stage).max().unwrap_or(0);
    let mut fronts = vec![Vec::new(); stages];
    let mut leaf_rows = vec![Vec::new(); stages];
    for (row, label) in labels.iter().enumerate() {
        let list = if label.class.is_leaf() { &mut leaf_rows } else { &mut fronts };
        list[label.stage - 1].push(row);
    }
    let mut grouping = Grouping {
        stage: labels.iter().map(|label| label.stage - 1).collect(),
        role: vec![Role::Front(0); labels.len()],
        separators: vec![Vec::new(); stages],
        front_entries: vec![Vec::new(); stages],
        ..Grouping::default()
    };
    for front in &mut fronts {
        front.sort_unstable_by_key(|&row| (front_rank(&labels[row]), labels[row].index, row));
        for (position, &row) in front.iter().enumerate() {
            grouping.role[row] = Role::Front(position);
        }
    }
    grouping.fronts = fronts;
    for mut rows in leaf_rows {
        let first = grouping.leaves.len();
        rows.sort_unstable_by_key(|&row| (labels[row].owner, labels[row].index, leaf_rank(labels[row].class), row));
        for leaf in rows.chunk_by(|&a, &b| labels[a].owner == labels[b].owner) {
            for (position, &row) in leaf.iter().enumerate() {
                grouping.role[row] = Role::Leaf(grouping.leaves.len(), position);
            }
            grouping.leaves.push(Group { rows: leaf.to_vec(), ..Group::default() });
        }
        grouping.stage_leaves.push(first..grouping.leaves.len());
    }
    Ok(grouping)
}

/// Order of a front: poses and their multipliers first, as the fast path requires, then rows that the next stage is
/// coupled with, so that they are consecutive.
fn front_rank(label: &Label) -> (usize, Owner) {
    let rank = match (label.class, label.owner) {
        (Class::Pose, _) => 0,
        (Class::PoseMultiplier, _) => 1,
        (Class::Velocity, Owner::Scenario(_)) => 2,
        (Class::Velocity, Owner::Reference) => 3,
        (Class::VelocityMultiplier, _) => 4,
        _ => 5,
    };
    (rank, label.owner)
}

/// Order within a pair: rows that can be eliminated without fill come first.
fn leaf_rank(class: Class) -> usize {
    match class {
        Class::InequalitySlack => 0,
        Class::InequalityMultiplier => 1,
        Class::Gap => 2,
        Class::GapMultiplier => 3,
        Class::ContactForce => 4,
        _ => 5,
    }
}

impl Grouping {
    /// Number of stages.
    pub fn stages(&self) -> usize {
        self.fronts.len()
    }

    /// Assigns an entry to the place where it is assembled.
    fn add(&mut self, entry: Entry) -> Result<(), &'static str> {
        let Entry { row, column, source } = entry;
        match (self.role[row], self.role[column]) {
            (Role::Front(_), Role::Front(_)) => self.add_to_front(entry),
            (Role::Leaf(leaf, _), Role::Leaf(other, _)) => {
                if leaf != other {
                    return Err("contacts of different stages or scenarios must be independent");
                }
                self.leaves[leaf].entries.push(entry);
                Ok(())
            }
            (Role::Leaf(leaf, _), Role::Front(_)) => self.add_to_leaf(leaf, entry),
            (Role::Front(_), Role::Leaf(leaf, _)) => self.add_to_leaf(leaf, Entry { row: column, column: row, source }),
        }
    }

    fn add_to_front(&mut self, entry: Entry) -> Result<(), &'static str> {
        let (row, column) = (entry.row, entry.column);
        let (stage, other) = (self.stage[row], self.stage[column]);
        let later = stage.max(other);
        if stage.abs_diff(other) > 1 {
            return Err("only neighbouring stages may be coupled");
        }
        if stage != other {
            self.separators[later].push(if stage < other { row } else { column });
        }
        self.front_entries[later].push(entry);
        Ok(())
    }

    fn add_to_leaf(&mut self, leaf: usize, entry: Entry) -> Result<(), &'static str> {
        let (stage, other) = (self.stage[entry.row], self.stage[entry.column]);
        if other != stage && other + 1 != stage {
            return Err("a contact may only be coupled with the states of its own and the previous stage");
        }
        let leaf = &mut self.leaves[leaf];
        leaf.boundary.push(entry.column);
        leaf.entries.push(entry);
        Ok(())
    }

    /// Sorts each boundary: rows of the leaf's own front first, then those of the previous front, in the fronts' order.
    fn collect_separators(&mut self) {
        for stage in 0..self.stages() {
            for leaf in &mut self.leaves[self.stage_leaves[stage].clone()] {
                leaf.boundary.sort_unstable_by_key(|&row| (self.stage[row] != stage, self.role[row].position()));
                leaf.boundary.dedup();
                let earlier = leaf.boundary.iter().filter(|&&row| self.stage[row] != stage);
                self.separators[stage].extend(earlier);
            }
            let separator = &mut self.separators[stage];
            separator.sort_unstable_by_key(|&row| self.role[row].position());
            separator.dedup();
        }
    }
}
