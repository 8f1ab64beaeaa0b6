//! Cells with few halfspaces around hulls.

use rustc_hash::FxHashSet;

use super::Touched;
use crate::cell::{Bound, Cell};
use crate::geometry::{Plane, Vector};
use crate::hull::Hull;
use crate::nearest::nearest;

/// Halfspaces of a piece, at most: a piece with more would make every distance slow.
const MOST_CUTS: usize = 500;

impl Touched<'_> {
    /// The cells around hulls.
    pub fn trim_all(&self, hulls: &[Hull], root: &Cell) -> Vec<Cell> {
        self.workers.map(hulls.iter(), |hull| self.trim(hull, root))
    }

    /// A cell around a hull with few halfspaces that keeps its distance from all places, or from most of them where that takes
    /// too many; the comparison of gaps with the meshes shows what that costs.
    fn trim(&self, hull: &Hull, root: &Cell) -> Cell {
        let facets = hull.facets(2.0 * self.tolerance);
        let mut cell = root.clone();
        let mut id = 1000;
        let tolerance = 0.1 * self.tolerance;
        let cut = |cell: &Cell, plane: Plane, id: usize| {
            let bound = Bound { id, is_flipped: false, plane };
            cell.cut(&bound, tolerance).unwrap_or_else(|| cell.clone())
        };
        // The box around the hull first.
        for axis in 0..3 {
            for side in 0..2 {
                let normal = Vector::ith(axis, if side == 0 { -1.0 } else { 1.0 });
                cell = cut(&cell, Plane::through(&hull.bounds[side], normal), id);
                id += 1;
            }
        }
        let mut waiting: Vec<usize> = (0..self.places.len()).collect();
        let mut used: FxHashSet<usize> = FxHashSet::default();
        for _ in 0..MOST_CUTS {
            let outer = OuterCell::new(&cell);
            waiting.retain(|&place| !outer.is_beyond(&self.places[place].point, self.places[place].enough));
            let depth = |place: &usize| self.places[*place].enough - outer.height(&self.places[*place].point);
            let Some(worst) = waiting.iter().copied().max_by(|one, other| depth(one).total_cmp(&depth(other))) else {
                break;
            };
            let place = &self.places[worst];
            let separating = facets
                .iter()
                .enumerate()
                .filter(|(index, (plane, _))| !used.contains(index) && plane.height(&place.point) >= place.enough)
                .max_by(|one, other| one.1.1.total_cmp(&other.1.1));
            let plane = match separating {
                Some((index, (plane, _))) => {
                    used.insert(index);
                    Some(*plane)
                }
                None => hull.nearest(&place.point).and_then(|nearest| {
                    let normal = (place.point - nearest).try_normalize(1e-3 * self.tolerance)?;
                    let plane = Plane::through(&nearest, normal);
                    Some(plane.moved(plane.heights(&hull.points).1.max(0.0)))
                }),
            };
            match plane {
                Some(plane) => cell = cut(&cell, plane, id),
                None => waiting.retain(|&other| other != worst),
            }
            id += 1;
        }
        cell
    }
}

/// Triangles of a convex polygon.
fn fan(polygon: &[Vector]) -> impl Iterator<Item = [Vector; 3]> {
    (2..polygon.len()).map(|at| [polygon[0], polygon[at - 1], polygon[at]])
}

/// A cell that is asked for distances.
struct OuterCell<'a> {
    cell: &'a Cell,
    bounds: [Vector; 2],
}

impl<'a> OuterCell<'a> {
    fn new(cell: &'a Cell) -> Self {
        Self { cell, bounds: cell.bounding_box() }
    }

    fn height(&self, point: &Vector) -> f64 {
        self.cell.bounds.iter().map(|bound| bound.plane.height(point)).fold(f64::NEG_INFINITY, f64::max)
    }

    fn is_beyond(&self, point: &Vector, distance: f64) -> bool {
        let [low, high] = &self.bounds;
        let to_box = (point - point.sup(low).inf(high)).norm_squared();
        if distance > 0.0 && to_box >= distance * distance {
            return true;
        }
        let height = self.height(point);
        height >= distance || (height > 0.0 && self.distance(point) >= distance)
    }

    fn distance(&self, point: &Vector) -> f64 {
        let ahead =
            self.cell.bounds.iter().zip(&self.cell.polygons).filter(|(bound, _)| bound.plane.height(point) > 0.0);
        let to = |polygon: &Vec<Vector>| {
            fan(polygon).map(|triangle| (nearest(point, &triangle) - point).norm()).fold(f64::INFINITY, f64::min)
        };
        ahead.map(|(_, polygon)| to(polygon)).fold(f64::INFINITY, f64::min)
    }
}
