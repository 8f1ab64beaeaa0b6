//! Few large convex pieces instead of the cells of a partition.

use workers::Workers;

use crate::cell::{Bound, Cell};
use crate::geometry::{Vector, area_vector, boxes_meet};
use crate::partition::Partition;
use crate::set_cover::set_cover;

/// Corners may be this many tolerances in front of a plane that bounds the same piece.
const INSIDE: f64 = 2.0;

/// With more cells than this there is no time to try several ways.
const FEW: usize = 200;

/// Polygons of cells that are compared with bounds while these grow: more take too long. Fewer for the most cells that
/// there may be.
const MOST_WORK: usize = 100_000_000;
const WORK_PER_CELL: usize = 100_000;

/// A piece that falls into more parts counts as not covered.
const MOST_PARTS: usize = 300;

/// Enlarges cells with material into whatever has material and leaves out those that others cover. Pieces overlap. `None`
/// when that takes too long.
pub fn merge(partition: &Partition, root: &Cell, tolerance: f64, most_cells: usize) -> Option<Vec<Cell>> {
    let free: Vec<(&Cell, [Vector; 2])> = partition.free.iter().map(|cell| (cell, cell.bounding_box())).collect();
    let mut leaves: Vec<(&Cell, f64)> = partition.solid.iter().map(|cell| (cell, cell.volume())).collect();
    leaves.sort_by(|one, other| other.1.total_cmp(&one.1));
    let orders = if leaves.len() <= FEW { &Order::ALL[..] } else { &Order::ALL[1..2] };
    let workers = Workers::of_all_processors();
    let mut work = 0;
    let mut pieces: Vec<Cell> = Vec::new();
    let mut covers: Vec<Vec<usize>> = Vec::new();
    let mut known = vec![0; leaves.len()];
    for (index, (leaf, _)) in leaves.iter().enumerate() {
        // A leaf that several pieces cover needs no more of them.
        let grown = workers.map(orders.iter().skip(known[index]), |order| {
            let mut grower = Grower { free: &free, used: &partition.used, root, tolerance, work: 0 };
            (grower.grow(leaf, *order), grower.work)
        });
        work += grown.iter().map(|(_, work)| work).sum::<usize>();
        if work > MOST_WORK.min(WORK_PER_CELL * most_cells) {
            return None;
        }
        for (piece, _) in grown {
            let is_covered = |other: &usize| *other == index || contains(&piece, leaves[*other].0, INSIDE * tolerance);
            let covered: Vec<usize> = (0..leaves.len()).filter(is_covered).collect();
            covered.iter().for_each(|&leaf| known[leaf] += 1);
            pieces.push(piece);
            covers.push(covered);
        }
    }
    let volumes: Vec<f64> = leaves.iter().map(|(_, volume)| *volume).collect();
    let mut chosen = set_cover(&covers, &volumes);
    chosen.sort_unstable();
    let chosen = chosen.into_iter().map(|piece| pieces[piece].clone()).collect();
    Some(without_superfluous(chosen, &partition.solid, INSIDE * tolerance))
}

/// Without pieces for which the others together cover all cells: no single one may contain a cell.
fn without_superfluous(mut pieces: Vec<Cell>, leaves: &[Cell], tolerance: f64) -> Vec<Cell> {
    let mut order: Vec<(usize, f64)> = pieces.iter().map(Cell::volume).enumerate().collect();
    order.sort_by(|one, other| one.1.total_cmp(&other.1));
    let boxes: Vec<[Vector; 2]> = pieces.iter().map(Cell::bounding_box).collect();
    let leaves: Vec<(&Cell, [Vector; 2])> = leaves.iter().map(|leaf| (leaf, leaf.bounding_box())).collect();
    let mut is_kept = vec![true; pieces.len()];
    for (index, _) in order {
        let is_other = |other: &usize| *other != index && is_kept[*other];
        let others: Vec<usize> =
            (0..pieces.len()).filter(is_other).filter(|&other| boxes_meet(&boxes[index], &boxes[other], 0.0)).collect();
        let mut own = leaves.iter().filter(|(_, bounds)| boxes_meet(&boxes[index], bounds, 0.0));
        is_kept[index] = !own.all(|(leaf, bounds)| {
            let near = others.iter().filter(|&&other| boxes_meet(bounds, &boxes[other], 0.0));
            is_covered(leaf, near.map(|&other| &pieces[other]), tolerance)
        });
    }
    let mut kept = is_kept.iter();
    pieces.retain(|_| kept.next() == Some(&true));
    pieces
}

fn is_covered<'a>(piece: &Cell, others: impl Iterator<Item = &'a Cell>, tolerance: f64) -> bool {
    let mut open = vec![piece.clone()];
    for other in others {
        open = open.iter().flat_map(|part| outside(part, other, tolerance)).collect();
        if open.is_empty() {
            return true;
        }
        if open.len() > MOST_PARTS {
            return false;
        }
    }
    false
}

/// The parts of a cell that are not in another one.
fn outside(cell: &Cell, other: &Cell, tolerance: f64) -> Vec<Cell> {
    let mut parts = Vec::new();
    let mut inside = cell.clone();
    for bound in &other.bounds {
        parts.extend(inside.cut(&bound.flipped(), tolerance));
        match inside.cut(bound, tolerance) {
            Some(left) => inside = left,
            None => return vec![cell.clone()],
        }
    }
    parts
}

fn contains(piece: &Cell, leaf: &Cell, tolerance: f64) -> bool {
    piece.bounds.iter().all(|bound| leaf.is_behind(&bound.plane, tolerance))
}

/// Which of the planes around a piece is dropped first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Order {
    /// The one with the largest polygon.
    LargestFirst,
    /// The one with the smallest polygon.
    SmallestFirst,
    /// The one behind which most volume is gained.
    MostGained,
}

impl Order {
    const ALL: [Self; 3] = [Self::MostGained, Self::LargestFirst, Self::SmallestFirst];
}

struct Grower<'a> {
    free: &'a [(&'a Cell, [Vector; 2])],
    used: &'a [Bound],
    root: &'a Cell,
    tolerance: f64,
    /// Polygons that were compared with bounds.
    work: usize,
}

impl Grower<'_> {
    /// A largest convex cell around a leaf that meets no free cell.
    fn grow(&mut self, leaf: &Cell, order: Order) -> Cell {
        let is_around = |bound: &Bound| leaf.is_behind(&bound.plane, self.tolerance);
        let both = self.used.iter().flat_map(|bound| [*bound, bound.flipped()]);
        let mut around: Vec<Bound> = both.filter(is_around).collect();
        let mut cell = leaf.clone();
        // What is in the way stays in the way as the cell grows.
        let mut fixed: Vec<Bound> = self.root.bounds.clone();
        loop {
            let loose =
                cell.bounds.iter().zip(&cell.polygons).filter(|(bound, _)| !fixed.iter().any(|other| other.is(bound)));
            let mut rating = |bound: &Bound, polygon: &Vec<Vector>| match order {
                Order::LargestFirst => area_vector(polygon).norm(),
                Order::SmallestFirst => -area_vector(polygon).norm(),
                Order::MostGained => self.beyond(&cell, bound, &around).map_or(0.0, |gain| gain.volume()),
            };
            let mut loose: Vec<(Bound, f64)> = loose.map(|(bound, polygon)| (*bound, rating(bound, polygon))).collect();
            loose.sort_by(|one, other| other.1.total_cmp(&one.1));
            let mut is_grown = false;
            for (bound, _) in loose {
                let gain = self.beyond(&cell, &bound, &around);
                if gain.as_ref().is_some_and(|gain| self.meets_free(gain)) {
                    fixed.push(bound);
                    continue;
                }
                around.retain(|other| !other.is(&bound));
                // The planes of both parts first: few others cut what these leave.
                let near = cell.bounds.iter().chain(gain.iter().flat_map(|gain| &gain.bounds));
                let near = near.filter(|other| other.id != bound.id);
                let planes = near.chain(&around);
                let grown = self.root.cut_by_at_cost(planes, self.tolerance, &mut self.work);
                let Some(grown) = grown else { return cell };
                cell = grown;
                is_grown = true;
                break;
            }
            if !is_grown {
                return cell;
            }
        }
    }

    /// What is gained when a bound is dropped.
    fn beyond(&mut self, cell: &Cell, bound: &Bound, around: &[Bound]) -> Option<Cell> {
        let others = cell.bounds.iter().chain(around).filter(|other| !other.is(bound));
        self.root.cut(&bound.flipped(), self.tolerance)?.cut_by_at_cost(others, self.tolerance, &mut self.work)
    }

    fn meets_free(&self, gain: &Cell) -> bool {
        let bounds = gain.bounding_box();
        let depth = INSIDE * self.tolerance;
        self.free.iter().filter(|(_, other)| boxes_meet(&bounds, other, -depth)).any(|(free, _)| {
            let is_apart = |one: &Cell, other: &Cell| {
                one.bounds.iter().any(|bound| other.corners().all(|corner| bound.plane.height(corner) >= -depth))
            };
            !is_apart(gain, free) && !is_apart(free, gain) && {
                let shrunk: Vec<Bound> = gain.bounds.iter().map(|bound| bound.moved(-depth)).collect();
                free.cut_by(&shrunk, self.tolerance).is_some()
            }
        })
    }
}
