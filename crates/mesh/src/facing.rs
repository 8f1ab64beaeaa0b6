//! The cells with surface that can be touched.

use crate::cell::{Bound, Cell, is_wide};
use crate::elements::{Element, Elements};
use crate::geometry::{Plane, Vector, bounds, boxes_meet, clip};

/// A convex place as halfspaces: unit outward normals and offsets (m).
pub type Place = Vec<([f64; 3], f64)>;

/// Convex places, or everywhere.
#[derive(Debug, Clone)]
pub struct Places {
    places: Vec<Vec<Plane>>,
    tolerance: f64,
}

impl Places {
    /// No places mean everywhere.
    pub fn new(places: &[Place], tolerance: f64) -> Self {
        let plane = |&(normal, offset): &([f64; 3], f64)| Plane { normal: Vector::from(normal), offset };
        Self { places: places.iter().map(|place| place.iter().map(plane).collect()).collect(), tolerance }
    }

    /// Whether they are everywhere.
    pub fn are_everywhere(&self) -> bool {
        self.places.is_empty()
    }

    /// Whether a point is in one of them.
    pub fn contain(&self, point: &Vector) -> bool {
        let is_in = |place: &Vec<Plane>| place.iter().all(|side| side.height(point) <= 0.0);
        self.are_everywhere() || self.places.iter().any(is_in)
    }

    /// Whether some of a convex polygon is in one of them.
    fn meet(&self, polygon: &[Vector]) -> bool {
        let meets = |place: &Vec<Plane>| {
            if place.iter().any(|side| side.heights(polygon).0 > self.tolerance) {
                return false;
            }
            let clipped = place.iter().fold(polygon.to_vec(), |polygon, side| clip(&polygon, side, self.tolerance));
            !clipped.is_empty()
        };
        self.are_everywhere() || self.places.iter().any(meets)
    }

    /// Whether a cell has surface in one of them.
    pub fn face(&self, cell: &Cell, elements: &Elements) -> bool {
        let has_surface = |bound: &Bound| surface_on(cell, bound, elements).any(|polygon| self.meet(&polygon));
        self.are_everywhere() || cell.bounds.iter().any(has_surface)
    }
}

/// Polygons of the surface on a facet of a cell.
pub fn surface_on<'a>(
    cell: &'a Cell,
    bound: &'a Bound,
    elements: &'a Elements,
) -> impl Iterator<Item = Vec<Vector>> + 'a {
    let box_ = cell.bounding_box();
    let is_near = move |element: &&Element| boxes_meet(&bounds(&element.polygon), &box_, elements.tolerance);
    let clipped = |polygon: &Vec<Vector>| {
        let others = cell.bounds.iter().filter(|other| !other.is(bound));
        others.fold(polygon.clone(), |polygon, other| clip(&polygon, &other.plane, elements.tolerance))
    };
    let own = elements.elements.iter().filter(|element| element.bound.is(bound)).filter(is_near);
    own.map(move |element| clipped(&element.polygon)).filter(|polygon| is_wide(polygon, elements.tolerance))
}
