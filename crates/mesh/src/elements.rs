//! The surface of a part as convex polygons, each with the plane that stands for it.

use crate::cell::{Bound, Cell, is_wide};
use crate::curved::Curved;
use crate::error::MeshError;
use crate::facets::{Sector, facet_counts, sectors};
use crate::geometry::{Plane, Vector, bounds, clip};
use crate::planes::Planes;
use crate::settings::CoverSettings;
use crate::solid::Solid;

/// A convex polygon of the surface.
#[derive(Debug, Clone)]
pub struct Element {
    pub polygon: Vec<Vector>,
    /// The plane that stands for it, the normal out of the material. The polygon is behind it or on it ...
    pub bound: Bound,
    /// ... and no farther from it than this (m).
    pub slack: f64,
}

/// The surface within a box.
pub struct Elements {
    pub elements: Vec<Element>,
    pub planes: Planes,
    /// The box as a cell.
    pub root: Cell,
    /// Whether the bounds of the box cut through the part.
    pub is_cropped: [bool; 6],
    /// Distance (m) below which a point is on a plane.
    pub tolerance: f64,
}

/// A curved surface cut into sectors.
struct Faceted<'a> {
    curved: &'a Curved,
    sectors: Vec<(Sector, Vec<Vec<Vector>>)>,
    /// See [`Sector::corner_factor`].
    factor: f64,
}

/// With more planes the part has too many pieces, and it takes long to find that.
const MOST_PLANES: usize = 20_000;
/// Roundings of vertices, fits of faces and of planes add up.
const ON_PLANE: f64 = 2.0;

/// How much larger than the part the box is (m), so that it cuts neither corners of facets around convex surfaces nor
/// what pieces grow.
fn margin(solid: &Solid, settings: &CoverSettings) -> f64 {
    const GENEROUS: f64 = 4.0;
    let convex = solid.curved_surfaces().into_iter().filter(|surface| surface.is_convex);
    let error = convex.map(|surface| surface.error(settings.facets)).fold(settings.error, f64::max);
    GENEROUS * (error + settings.tolerance)
}

impl Elements {
    /// The surface of a solid within the crop box.
    ///
    /// # Errors
    /// When nothing is there, or it has more planes than can be compared.
    pub fn of(solid: &Solid, settings: &CoverSettings) -> Result<Self, MeshError> {
        let tolerance = ON_PLANE * solid.tolerance;
        let whole = solid.bounds();
        let crop = settings.crop.map(|corners| corners.map(Vector::from)).unwrap_or(whole);
        let is_cropped = [0, 1, 2, 3, 4, 5].map(|face| match (face / 3, face % 3) {
            (0, axis) => crop[0][axis] > whole[0][axis] + tolerance,
            (_, axis) => crop[1][axis] < whole[1][axis] - tolerance,
        });
        let margin = margin(solid, settings);
        let box_: [Vector; 2] = std::array::from_fn(|side| {
            let outer = whole[side].add_scalar(if side == 0 { -margin } else { margin });
            Vector::from_fn(|axis, _| if is_cropped[3 * side + axis] { crop[side][axis] } else { outer[axis] })
        });
        if (box_[1] - box_[0]).min() <= 2.0 * tolerance {
            return Err(MeshError::NothingLeft);
        }
        let mut planes = Planes::default();
        let sides = std::array::from_fn(|face| {
            let (axis, side) = (face % 3, face / 3);
            let normal = Vector::ith(axis, if side == 0 { -1.0 } else { 1.0 });
            planes.bound(&Plane::through(&box_[side], normal), &box_, 0.0)
        });
        let root = Cell::of_box(&box_, sides);
        let mut elements = Self { elements: Vec::new(), planes, root, is_cropped, tolerance };
        elements.add_planar(solid, &box_)?;
        let counts = facet_counts(&solid.curved, settings, solid.tolerance);
        let faceted = solid.curved.iter().zip(counts);
        let faceted: Vec<Faceted> =
            faceted.map(|(curved, count)| elements.faceted(solid, curved, count, &box_)).collect();
        // Surfaces around the same axis meet in the corners of their facets when they have one factor.
        let factor = |one: &Faceted| {
            let alike = faceted.iter().filter(|other| other.curved.is_coaxial(one.curved, tolerance));
            alike.map(|other| other.factor).fold(one.factor, f64::min)
        };
        let factors: Vec<f64> = faceted.iter().map(factor).collect();
        for (faceted, factor) in faceted.into_iter().zip(factors) {
            elements.add_curved(faceted, factor);
        }
        Ok(elements)
    }

    fn add_planar(&mut self, solid: &Solid, box_: &[Vector; 2]) -> Result<(), MeshError> {
        let mut is_curved = vec![false; solid.faces.faces.len()];
        solid.curved.iter().flat_map(|curved| &curved.faces).for_each(|&face| is_curved[face] = true);
        for (face, _) in solid.faces.faces.iter().zip(is_curved).filter(|(_, is_curved)| !is_curved) {
            let polygons = self.inside(face.triangles.iter().map(|&triangle| solid.corners(triangle)), box_);
            if polygons.is_empty() {
                continue;
            }
            let points: Vec<Vector> = face.triangles.iter().flat_map(|&triangle| solid.corners(triangle)).collect();
            let bound = self.planes.bound(&face.plane, &points, self.tolerance);
            self.elements.extend(polygons.into_iter().map(|polygon| Element { polygon, bound, slack: 0.0 }));
            if self.planes.len() > MOST_PLANES {
                return Err(MeshError::too_many_pieces(solid));
            }
        }
        Ok(())
    }

    fn faceted<'a>(&self, solid: &Solid, curved: &'a Curved, count: usize, box_: &[Vector; 2]) -> Faceted<'a> {
        let triangles = curved.faces.iter().flat_map(|&face| &solid.faces.faces[face].triangles);
        let polygons = self.inside(triangles.map(|&triangle| solid.corners(triangle)), box_);
        let shares = |sector: &Sector| -> Vec<Vec<Vector>> {
            let shares = polygons.iter().map(|polygon| sector.share(curved, polygon, self.tolerance));
            shares.filter(|share| is_wide(share, self.tolerance)).collect()
        };
        let sectors: Vec<(Sector, Vec<Vec<Vector>>)> =
            sectors(curved, count).into_iter().map(|sector| (sector, shares(&sector))).collect();
        let factors = sectors.iter().map(|(sector, shares)| sector.corner_factor(curved, shares.iter().flatten()));
        Faceted { factor: factors.fold(1.0, f64::min), curved, sectors }
    }

    fn add_curved(&mut self, faceted: Faceted, factor: f64) {
        for (sector, shares) in faceted.sectors.into_iter().filter(|(_, shares)| !shares.is_empty()) {
            let plane = sector.plane(faceted.curved, factor);
            // Vertices that are not exactly on the surface must not be in front of the facet either.
            let (_, high) = plane.heights(shares.iter().flatten());
            let plane = if high > self.tolerance { plane.moved(high) } else { plane };
            let shadow: Vec<Vector> =
                shares.iter().flatten().map(|point| point - plane.normal * plane.height(point)).collect();
            let bound = self.planes.bound(&plane, &shadow, self.tolerance);
            let slack = |polygon: &[Vector]| (-bound.plane.heights(polygon).0).max(0.0);
            self.elements.extend(shares.into_iter().map(|polygon| Element { slack: slack(&polygon), polygon, bound }));
        }
    }

    /// Triangles clipped to the box.
    fn inside(&self, triangles: impl Iterator<Item = [Vector; 3]>, box_: &[Vector; 2]) -> Vec<Vec<Vector>> {
        let is_near = |triangle: &[Vector; 3]| crate::geometry::boxes_meet(&bounds(triangle), box_, self.tolerance);
        let sides = &self.root.bounds;
        let clipped = triangles.filter(is_near).map(|triangle| {
            sides.iter().fold(triangle.to_vec(), |polygon, side| clip(&polygon, &side.plane, self.tolerance))
        });
        clipped.filter(|polygon| is_wide(polygon, self.tolerance)).collect()
    }

    /// Whether the part is the intersection of the halfspaces of its elements.
    pub fn is_convex(&self) -> bool {
        let mut checked = vec![[false; 2]; self.planes.len()];
        self.elements.iter().all(|element| {
            let side = &mut checked[element.bound.id][usize::from(element.bound.is_flipped)];
            std::mem::replace(side, true)
                || self.elements.iter().all(|other| element.bound.plane.heights(&other.polygon).1 <= self.tolerance)
        })
    }
}
