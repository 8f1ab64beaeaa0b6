//! Convex pieces that cover a part.

use crate::body::Body;
use crate::cell::{Bound, Cell};
use crate::coarsen::coarsen;
use crate::curved_surface::CurvedSurface;
use crate::elements::Elements;
use crate::error::MeshError;
use crate::facets::facet_counts;
use crate::facing::{Place, Places, surface_on};
use crate::geometry::{Plane, Vector};
use crate::merge::merge;
use crate::partition::partition;
use crate::passing::{self, Budget, Passage};
use crate::settings::CoverSettings;
use crate::solid::Solid;
use crate::touch::Touched;

/// Covers with more pieces are refused.
pub const MOST_PIECES: usize = 1000;

/// Convex parts with more planar facets are refused.
const MOST_HALFSPACES: usize = 5000;

/// A convex piece `{p | normals p <= offsets}`, rows of unit length, none redundant.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Unit outward normals.
    pub normals: Vec<[f64; 3]>,
    /// Offsets (m).
    pub offsets: Vec<f64>,
    /// Corners (m).
    pub vertices: Vec<[f64; 3]>,
    /// For each halfspace whether part of the surface lies on its facet; others are cuts.
    pub is_surface: Vec<bool>,
}

impl Piece {
    /// Of a cell, whose corners are different points where they are farther apart than the tolerance (m).
    fn new(cell: &Cell, is_surface: Vec<bool>, tolerance: f64) -> Self {
        let mut vertices: Vec<Vector> = Vec::new();
        for corner in cell.corners() {
            if vertices.iter().all(|other| (other - corner).norm() > tolerance) {
                vertices.push(*corner);
            }
        }
        Self {
            normals: cell.bounds.iter().map(|bound| bound.plane.normal.into()).collect(),
            offsets: cell.bounds.iter().map(|bound| bound.plane.offset).collect(),
            vertices: vertices.into_iter().map(Into::into).collect(),
            is_surface,
        }
    }
}

/// Convex pieces that overlap and together contain a part.
#[derive(Debug, Clone)]
pub struct Cover {
    pieces: Vec<Piece>,
    surfaces: Vec<(CurvedSurface, usize)>,
    growth: f64,
    vanished: usize,
    pub(crate) cells: Vec<Cell>,
    /// Where it covers the solid, and which cells of the partition have surface there: none where it is everywhere.
    pub(crate) places: Places,
    pub(crate) leaves: Vec<Cell>,
    pub(crate) crop_planes: Vec<Bound>,
    pub(crate) box_: [Vector; 2],
    pub(crate) tolerance: f64,
}

impl Cover {
    /// Covers a solid.
    ///
    /// # Errors
    /// When a setting is out of range, the part needs too many pieces or nothing is left of it.
    pub fn of(solid: &Solid, settings: &CoverSettings) -> Result<Self, MeshError> {
        Self::facing(solid, settings, &[])
    }

    /// Covers what of a solid has surface in convex places; what stays in these can touch nothing else. No places mean
    /// everywhere.
    ///
    /// # Errors
    /// As [`Cover::of`].
    pub fn facing(solid: &Solid, settings: &CoverSettings, places: &[Place]) -> Result<Self, MeshError> {
        settings.check()?;
        if let Some(reason) = &solid.undecided {
            return Err(reason.clone());
        }
        let whole_solid = Elements::of(solid, &CoverSettings { crop: None, ..*settings })?;
        let is_convex = whole_solid.is_convex();
        // A convex part is one piece: cut at a box it would have more halfspaces.
        let elements = if is_convex { whole_solid } else { Elements::of(solid, settings)? };
        let places = Places::new(places, elements.tolerance);
        let (leaves, merged) = if is_convex {
            (Vec::new(), whole(&elements)?.into_iter().collect())
        } else {
            let mut partition = partition(&elements, solid, settings.tolerance, settings.most_cells)?;
            partition.solid.retain(|cell| places.face(cell, &elements));
            let merged = merge(&partition, &elements.root, elements.tolerance, settings.most_cells);
            let merged = merged.ok_or_else(|| MeshError::too_many_pieces(solid))?;
            (partition.solid, merged)
        };
        if merged.len() > MOST_PIECES {
            return Err(MeshError::too_many_pieces(solid));
        }
        let counts = facet_counts(&solid.curved, settings, solid.tolerance);
        let mut cover = Self {
            pieces: Vec::new(),
            surfaces: solid.curved_surfaces().into_iter().zip(counts).collect(),
            growth: 0.0,
            vanished: 0,
            cells: Vec::new(),
            leaves: if places.are_everywhere() { Vec::new() } else { leaves },
            places,
            crop_planes: crop_planes(&elements),
            box_: elements.root.bounding_box(),
            tolerance: elements.tolerance,
        };
        for cell in merged {
            cover.add(&cell, &elements, settings);
        }
        if cover.pieces.is_empty() { Err(MeshError::NothingLeft) } else { Ok(cover) }
    }

    /// Covers a solid exactly where others pass it, within a budget, and with few pieces elsewhere: what nothing enters is
    /// filled.
    ///
    /// # Errors
    /// When it needs too many pieces.
    pub fn touching(solid: &Solid, passages: &[Passage], budget: Budget) -> Result<Self, MeshError> {
        let body = Body::of(solid);
        let places = passing::places(&body, passages, budget);
        let touched = Touched::new(solid, &body, &places);
        let [low, high] = solid.bounds();
        let margin = 0.01 * (high - low).amax() + 100.0 * solid.tolerance;
        let box_ = [low.add_scalar(-margin), high.add_scalar(margin)];
        let sides = std::array::from_fn(|face| {
            let (axis, side) = (face % 3, face / 3);
            let normal = Vector::ith(axis, if side == 0 { -1.0 } else { 1.0 });
            Bound { id: face, is_flipped: false, plane: Plane::through(&box_[side], normal) }
        });
        let root = Cell::of_box(&box_, sides);
        let hulls = touched.pieces(root.clone()).ok_or_else(|| MeshError::too_many_pieces(solid))?;
        if hulls.len() > MOST_PIECES {
            return Err(MeshError::too_many_pieces(solid));
        }
        let hulls = touched.join(hulls);
        let cells = touched.trim_all(&hulls, &root);
        let mut cover = Self {
            pieces: Vec::new(),
            surfaces: Vec::new(),
            growth: 0.0,
            vanished: 0,
            cells: Vec::new(),
            leaves: Vec::new(),
            places: Places::new(&[], solid.tolerance),
            crop_planes: Vec::new(),
            box_,
            tolerance: solid.tolerance,
        };
        for cell in cells {
            let is_surface = vec![true; cell.bounds.len()];
            cover.pieces.push(Piece::new(&cell, is_surface, 1e-9 * margin));
            cover.cells.push(cell);
        }
        // What is filled, too.
        let middles = cover.cells.iter().flat_map(|cell| &cell.polygons).map(crate::geometry::mean);
        let corners = cover.cells.iter().flat_map(Cell::corners).copied();
        let reached = middles.chain(corners).filter(|point| !body.contains(point));
        cover.growth = reached.map(|point| body.distance(&point).1).fold(0.0, f64::max);
        if cover.pieces.is_empty() { Err(MeshError::NothingLeft) } else { Ok(cover) }
    }

    fn add(&mut self, cell: &Cell, elements: &Elements, settings: &CoverSettings) {
        let (cell, growth) = if settings.tolerance > 0.0 {
            coarsen(cell, &elements.root, settings.tolerance, self.tolerance)
        } else {
            (cell.clone(), 0.0)
        };
        self.growth = self.growth.max(growth);
        let is_surface: Vec<bool> =
            cell.bounds.iter().map(|bound| surface_on(&cell, bound, elements).next().is_some()).collect();
        let inward =
            |(bound, is_surface): (&Bound, &bool)| bound.moved(if *is_surface { -settings.clearance } else { 0.0 });
        let bounds: Vec<Bound> = cell.bounds.iter().zip(&is_surface).map(inward).collect();
        let is_same = settings.clearance == 0.0;
        let shrunk = if is_same { Some(cell.clone()) } else { elements.root.cut_by(&bounds, self.tolerance) };
        let Some(shrunk) = shrunk.filter(|shrunk| shrunk.thickness() > self.tolerance) else {
            self.vanished += 1;
            return;
        };
        let flags = shrunk
            .bounds
            .iter()
            .map(|bound| cell.bounds.iter().zip(&is_surface).any(|(other, is_surface)| other.is(bound) && *is_surface));
        self.pieces.push(Piece::new(&shrunk, flags.collect(), self.tolerance));
        self.cells.push(shrunk);
    }

    /// The pieces.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The curved surfaces of the part, also those outside of the crop box, with the facets of a full turn that stand for
    /// them.
    pub fn curved_surfaces(&self) -> &[(CurvedSurface, usize)] {
        &self.surfaces
    }

    /// How far pieces reach beyond halfspaces that were dropped for having fewer (m).
    pub fn growth(&self) -> f64 {
        self.growth
    }

    /// Number of pieces that were thinner than the tolerance or vanished with the clearance.
    pub fn vanished(&self) -> usize {
        self.vanished
    }

    /// Distance (m) below which points of the file count as on a plane; thinner pieces are dropped.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }
}

/// A convex part is one cell.
fn whole(elements: &Elements) -> Result<Option<Cell>, MeshError> {
    let mut bounds: Vec<Bound> = Vec::new();
    for element in &elements.elements {
        if !bounds.iter().any(|bound| bound.is(&element.bound)) {
            bounds.push(element.bound);
        }
    }
    if bounds.len() > MOST_HALFSPACES {
        return Err(MeshError::TooManyHalfspaces { count: bounds.len(), most: MOST_HALFSPACES });
    }
    Ok(elements.root.cut_by(&bounds, elements.tolerance))
}

fn crop_planes(elements: &Elements) -> Vec<Bound> {
    let sides = elements.root.bounds.iter().zip(elements.is_cropped);
    sides.filter(|(_, is_cropped)| *is_cropped).map(|(bound, _)| *bound).collect()
}
