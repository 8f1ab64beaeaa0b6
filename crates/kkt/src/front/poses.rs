//! Elimination of the poses of a stage with the kinematics that define them, before its front is factorised.
//!
//! In the order (poses `q`, multipliers of their kinematics `y`, rest `r` of front and separator) a stage is
//!
//! ```text
//! [ H  J'  B' ]      H: poses of all trajectories        J: block diagonal, one small block per trajectory
//! [ J  0   C' ]      B: coupling with the rest           C: a few columns per trajectory
//! [ B  C   A  ]
//! ```
//!
//! With `T = C J^{-T}` the kinematics give `q = J^{-1} b_y - T' r`, and the Schur complement of the rest is
//! `A - T G' - G T'` with `G = B - T H / 2`. This needs no pivoting and causes no fill outside `A`. The
//! number of negative eigenvalues is the number of pose coordinates. The diagonal block of `y` must be zero: if it is
//! perturbed, as in the restoration phase, the front is factorised as one dense block.

use crate::front::assembly::{Place, Target};
use crate::front::general::GeneralLayout;
use crate::grouping::Entry;
use crate::kernel::padded;
use crate::label::{Class, Label};

/// Largest number of coordinates of a pose.
pub const LARGEST_POSE: usize = 8;

/// The pose of one trajectory.
#[derive(Debug)]
pub struct PoseBlock {
    /// Its first coordinate among all poses of the stage.
    pub first: usize,
    /// Number of coordinates.
    pub size: usize,
    /// Rows of the rest that its kinematics are coupled with.
    pub columns: Vec<usize>,
    /// Start of `J^{-1}`, column-major.
    pub inverse: usize,
    /// Start of `T`, a column for every coordinate.
    pub coupling: usize,
}

impl PoseBlock {
    /// Stride of `T`.
    pub fn height(&self) -> usize {
        padded(self.columns.len())
    }

    /// Its coordinates among all poses of the stage.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.size
    }
}

/// Layout of a stage's values on the fast path: the panel of the rest, then the values of the poses.
#[derive(Debug)]
pub struct PoseLayout {
    /// Number of pose coordinates.
    pub poses: usize,
    /// The rest: the front without poses and their multipliers, and the separator.
    pub rest: GeneralLayout,
    pub blocks: Vec<PoseBlock>,
    /// Start of `B`: a column of the rest's rows for every coordinate.
    pub coupling: usize,
    /// Start of `H`, with a padded stride.
    pub hessian: usize,
    /// Number of values.
    pub store: usize,
    /// Entries of `J` and `C`: target, position in the matrix.
    pub kinematics: Vec<(u32, u32)>,
    /// Diagonal entries of the multipliers: position in the matrix.
    pub diagonals: Vec<u32>,
}

impl PoseLayout {
    /// Plans the elimination of the poses of a front; `None` when it does not have the form above.
    pub fn new(front: &[Label], separator: usize, entries: &[(Place, Place, Entry)]) -> Option<Self> {
        let count = |class| front.iter().filter(|label| label.class == class).count();
        let poses = count(Class::Pose);
        let matched = front[..poses].iter().zip(&front[poses..]).all(|(pose, multiplier)| {
            multiplier.class == Class::PoseMultiplier
                && (multiplier.owner, multiplier.index) == (pose.owner, pose.index)
        });
        if poses == 0 || !matched || count(Class::PoseMultiplier) != poses {
            return None;
        }
        let rest = GeneralLayout { order: front.len() - 2 * poses, separator };
        let coupling = padded(rest.store());
        let hessian = coupling + rest.stride() * poses;
        let mut layout = Self {
            poses,
            rest,
            blocks: Vec::new(),
            coupling,
            hessian,
            store: hessian + padded(poses) * poses,
            kinematics: Vec::new(),
            diagonals: Vec::new(),
        };
        let mut first = 0;
        for labels in front[..poses].chunk_by(|a, b| a.owner == b.owner) {
            layout.add_block(first, labels.len(), entries)?;
            first += labels.len();
        }
        for &(row, column, entry) in entries {
            layout.add_kinematics(row, column, entry.source)?;
        }
        Some(layout)
    }

    fn add_block(&mut self, first: usize, size: usize, entries: &[(Place, Place, Entry)]) -> Option<()> {
        if size > LARGEST_POSE {
            return None;
        }
        let range = first..first + size;
        let mut columns = Vec::new();
        for &(row, column, _) in entries {
            let (row, column) = (self.part(row), self.part(column));
            for (multiplier, other) in [(row, column), (column, row)] {
                match (multiplier, other) {
                    (Part::Multiplier(y), Part::Rest(other)) if range.contains(&y) => columns.push(other),
                    _ => {}
                }
            }
        }
        columns.sort_unstable();
        columns.dedup();
        let inverse = self.store;
        let coupling = inverse + padded(size * size);
        let block = PoseBlock { first, size, columns, inverse, coupling };
        self.store = coupling + block.height() * size;
        self.blocks.push(block);
        Some(())
    }

    /// Assigns an entry of the kinematics to its place; `None` when the form above has none.
    fn add_kinematics(&mut self, row: Place, column: Place, source: usize) -> Option<()> {
        let (row, column) = (self.part(row), self.part(column));
        let (multiplier, other) = match (row, column) {
            (Part::Multiplier(a), Part::Multiplier(b)) => {
                self.diagonals.push(source as u32);
                return (a == b).then_some(());
            }
            (Part::Multiplier(multiplier), other) | (other, Part::Multiplier(multiplier)) => (multiplier, other),
            _ => return Some(()),
        };
        let block = self.blocks.iter().find(|block| block.range().contains(&multiplier))?;
        let row = multiplier - block.first;
        let target = match other {
            Part::Pose(pose) if block.range().contains(&pose) => {
                block.inverse + row + (pose - block.first) * block.size
            }
            Part::Rest(other) => block.coupling + block.columns.binary_search(&other).ok()? + row * block.height(),
            _ => return None,
        };
        self.kinematics.push((target as u32, source as u32));
        Some(())
    }

    /// Whether an entry belongs to the kinematics, which are not assembled with the rest.
    pub fn is_kinematic(&self, row: Place, column: Place) -> bool {
        [row, column].iter().any(|&place| matches!(self.part(place), Part::Multiplier(_)))
    }

    /// Place where a coupling is assembled; `None` when the form above has none.
    pub fn target(&self, row: Place, column: Place) -> Option<Target> {
        let stride = self.rest.stride();
        match (self.part(row), self.part(column)) {
            (Part::Pose(a), Part::Pose(b)) => {
                Some(Target::store(self.hessian + a.max(b) + a.min(b) * padded(self.poses)))
            }
            (Part::Pose(pose), Part::Rest(other)) | (Part::Rest(other), Part::Pose(pose)) => {
                Some(Target::store(self.coupling + other + pose * stride))
            }
            (Part::Rest(_), Part::Rest(_)) => Some(self.rest.target(self.shifted(row), self.shifted(column))),
            _ => None,
        }
    }

    /// Row of the rest's panel for a place, `None` for poses and their multipliers.
    pub fn rest_row(&self, place: Place) -> Option<usize> {
        match self.part(place) {
            Part::Rest(row) => Some(row),
            _ => None,
        }
    }

    fn shifted(&self, place: Place) -> Place {
        match place {
            Place::Front(position) => Place::Front(position - 2 * self.poses),
            Place::Separator(_) => place,
        }
    }

    fn part(&self, place: Place) -> Part {
        match place {
            Place::Front(position) if position < self.poses => Part::Pose(position),
            Place::Front(position) if position < 2 * self.poses => Part::Multiplier(position - self.poses),
            Place::Front(position) => Part::Rest(position - 2 * self.poses),
            Place::Separator(position) => Part::Rest(padded(self.rest.order) + position),
        }
    }
}

/// Role of a place on the fast path.
#[derive(Clone, Copy)]
enum Part {
    Pose(usize),
    Multiplier(usize),
    /// Row of the rest's panel.
    Rest(usize),
}
