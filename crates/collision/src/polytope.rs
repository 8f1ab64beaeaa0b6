//! Bounded convex polytopes in halfspace form (assumption_1) with their vertices.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::facet::Facet;
use crate::hull;
use crate::interior::analytic_center;

/// More distinct vertices are refused.
const MOST_VERTICES: usize = 10_000;
/// More halfspaces are refused.
const MOST_HALFSPACES: usize = 2_000;
/// Larger coordinates and offsets (m) are a mistake.
const LARGEST: f64 = 1e6;
/// The squares of the components of a shorter normal underflow.
const SHORTEST_NORMAL: f64 = 1e-150;

/// Why a description is not a convex polytope that can be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PolytopeError {
    /// A coordinate, normal or offset is infinite or not a number.
    #[error("entry {index} is not a finite number")]
    NotFinite {
        /// Index of the vertex or halfspace.
        index: usize,
    },
    /// A coordinate, normal or offset that no part in metres has.
    #[error("entry {index} is larger than {LARGEST:.0e}: lengths are in metres")]
    TooLarge {
        /// Index of the vertex or halfspace.
        index: usize,
    },
    /// More points than are handled in reasonable time.
    #[error("{count} distinct vertices are too many: at most {MOST_VERTICES} are allowed")]
    TooManyVertices {
        /// Number of distinct points.
        count: usize,
    },
    /// More halfspaces than are handled in reasonable time.
    #[error("{count} halfspaces are too many: at most {MOST_HALFSPACES} are allowed")]
    TooManyHalfspaces {
        /// Number of halfspaces.
        count: usize,
    },
    /// Fewer points than any solid has.
    #[error("{count} distinct vertices do not span a solid: at least 4 are needed")]
    TooFewVertices {
        /// Number of distinct points.
        count: usize,
    },
    /// All points in one plane, or no interior.
    #[error("the part is flat: its thickness is below {tolerance:.1e} m")]
    Flat {
        /// Thickness below which a part counts as flat (m).
        tolerance: f64,
    },
    /// An edge length that is not positive.
    #[error("edge lengths must be positive, got {edge_lengths:?}")]
    EdgeLength {
        /// The edge lengths (m).
        edge_lengths: [f64; 3],
    },
    /// Different numbers of normals and offsets.
    #[error("{normals} normals but {offsets} offsets")]
    Lengths {
        /// Number of normals.
        normals: usize,
        /// Number of offsets.
        offsets: usize,
    },
    /// A normal of length zero.
    #[error("normal {index} has length zero")]
    ZeroNormal {
        /// Index of the halfspace.
        index: usize,
    },
    /// The halfspaces leave a direction open.
    #[error("the halfspaces do not bound the part in direction ({:.3}, {:.3}, {:.3})", direction[0], direction[1], direction[2])]
    Unbounded {
        /// A direction in which the part is infinite.
        direction: [f64; 3],
    },
    /// The halfspaces contradict each other.
    #[error("the halfspaces have no common interior")]
    Empty,
}

/// A bounded convex polytope `{p | normals p <= offsets}` with unit rows, none redundant, and its vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Polytope {
    normals: Vec<[f64; 3]>,
    offsets: Vec<f64>,
    vertices: Vec<[f64; 3]>,
    center: [f64; 3],
    center_weights: Vec<f64>,
}

impl Polytope {
    /// Convex hull of points (m). Coplanar facets are merged, points inside are dropped. Lengths below 1e-7 of the size
    /// of the part count as rounding.
    ///
    /// # Errors
    /// When the points do not span a solid, are too many or too far away.
    pub fn from_vertices(vertices: &[[f64; 3]]) -> Result<Self, PolytopeError> {
        Self::from_vertices_within(vertices, 0.0)
    }

    /// Convex hull of points (m) whose coordinates are known to a tolerance (m), such as those of a file with few
    /// digits: points closer than that are one and facets whose points are closer than that to a plane are merged.
    /// A tolerance below that of [`Self::from_vertices`] has no effect.
    ///
    /// # Errors
    /// When the points do not span a solid, are too many or too far away.
    pub fn from_vertices_within(vertices: &[[f64; 3]], tolerance: f64) -> Result<Self, PolytopeError> {
        require_reasonable(vertices.iter().map(|vertex| vertex.as_slice()))?;
        let points: Vec<Vector3<f64>> = vertices.iter().map(|vertex| Vector3::from(*vertex)).collect();
        let points = hull::distinct(&points, tolerance.max(hull::tolerance(&points)));
        let count = points.len();
        if count < 4 {
            return Err(PolytopeError::TooFewVertices { count });
        }
        if count > MOST_VERTICES {
            return Err(PolytopeError::TooManyVertices { count });
        }
        let tolerance = tolerance.max(hull::tolerance(&points));
        let facets = hull::facets(&points, tolerance);
        let planes: Vec<Facet> = facets.iter().map(|facet| facet.plane).collect();
        if hull::open_direction(&planes).is_some() {
            return Err(PolytopeError::Flat { tolerance });
        }
        let extreme = hull::extreme_points(&points, &facets, tolerance);
        Self::new(planes, extreme).ok_or(PolytopeError::Flat { tolerance })
    }

    /// Box with edge lengths (m), centred at the origin.
    ///
    /// # Errors
    /// When an edge length is not positive and finite.
    pub fn from_box(edge_lengths: [f64; 3]) -> Result<Self, PolytopeError> {
        if edge_lengths.iter().any(|&length| !(length > 0.0 && length.is_finite())) {
            return Err(PolytopeError::EdgeLength { edge_lengths });
        }
        let normals: Vec<[f64; 3]> = (0..6)
            .map(|row| {
                std::array::from_fn(|axis| {
                    if axis != row % 3 {
                        0.0
                    } else if row < 3 {
                        1.0
                    } else {
                        -1.0
                    }
                })
            })
            .collect();
        let offsets: Vec<f64> = (0..6).map(|row| 0.5 * edge_lengths[row % 3]).collect();
        Self::from_halfspaces(&normals, &offsets)
    }

    /// Intersection of halfspaces `normals[k] p <= offsets[k]` (m for unit normals; others are normalised). Redundant
    /// and repeated rows are removed: they would shift the smoothed distance.
    ///
    /// # Errors
    /// When the intersection is unbounded or has no interior, or the halfspaces are too many or too far away.
    pub fn from_halfspaces(normals: &[[f64; 3]], offsets: &[f64]) -> Result<Self, PolytopeError> {
        if normals.len() != offsets.len() {
            return Err(PolytopeError::Lengths { normals: normals.len(), offsets: offsets.len() });
        }
        if normals.len() > MOST_HALFSPACES {
            return Err(PolytopeError::TooManyHalfspaces { count: normals.len() });
        }
        require_reasonable(normals.iter().map(|normal| normal.as_slice()))?;
        require_reasonable(offsets.iter().map(std::slice::from_ref))?;
        let mut halfspaces = Vec::with_capacity(normals.len());
        for (index, (normal, offset)) in normals.iter().zip(offsets).enumerate() {
            let normal = Vector3::from(*normal);
            let length = normal.norm();
            if length < SHORTEST_NORMAL {
                return Err(PolytopeError::ZeroNormal { index });
            }
            halfspaces.push(Facet { normal: normal / length, offset: offset / length });
        }
        require_reasonable(halfspaces.iter().map(|facet| std::slice::from_ref(&facet.offset)))?;
        if let Some(direction) = hull::open_direction(&halfspaces) {
            return Err(PolytopeError::Unbounded { direction: direction.into() });
        }
        let vertices = hull::vertices(&halfspaces);
        if vertices.len() < 4 || hull::facets(&vertices, hull::tolerance(&vertices)).len() < 4 {
            return Err(PolytopeError::Empty);
        }
        let facets = hull::irredundant(&halfspaces, &vertices);
        if hull::open_direction(&facets).is_some() {
            return Err(PolytopeError::Empty);
        }
        Self::new(facets, vertices).ok_or(PolytopeError::Empty)
    }

    /// `None` when rounding leaves no point strictly inside.
    fn new(facets: Vec<Facet>, vertices: Vec<Vector3<f64>>) -> Option<Self> {
        let centroid = vertices.iter().sum::<Vector3<f64>>() / vertices.len() as f64;
        let center = analytic_center(&facets, centroid);
        // The gradient of the barrier is zero in its minimiser: the reciprocal slacks are weights of the normals.
        let weights: Vec<f64> = facets.iter().map(|facet| 1.0 / (facet.offset - facet.normal.dot(&center))).collect();
        let total: f64 = weights.iter().sum();
        let is_inside = weights.iter().all(|weight| weight.is_finite() && *weight > 0.0);
        is_inside.then(|| Self {
            normals: facets.iter().map(|facet| facet.normal.into()).collect(),
            offsets: facets.iter().map(|facet| facet.offset).collect(),
            vertices: vertices.into_iter().map(Into::into).collect(),
            center: center.into(),
            center_weights: weights.into_iter().map(|weight| weight / total).collect(),
        })
    }

    /// Unit outward normals.
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }

    /// Offsets (m).
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }

    /// Extreme points (m).
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// Analytic centre (m), strictly inside.
    pub fn center(&self) -> [f64; 3] {
        self.center
    }

    /// Positive weights of sum 1 for which the weighted normals cancel: dual feasible in every orientation.
    pub(crate) fn center_weights(&self) -> &[f64] {
        &self.center_weights
    }

    /// Largest extent along the axes of its frame (m).
    pub fn size(&self) -> f64 {
        let extent = |axis: usize| {
            let coordinates = self.vertices.iter().map(|vertex| vertex[axis]);
            let (low, high) = coordinates
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
            high - low
        };
        (0..3).map(extent).fold(0.0, f64::max)
    }

    /// The polytope rotated by a quaternion (w x y z, of any norm) and then moved by `position` (m).
    pub fn placed(&self, position: [f64; 3], [w, x, y, z]: [f64; 4]) -> Self {
        let rotation = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
        let shift = Vector3::from(position);
        let turned = |vector: &[f64; 3]| rotation * Vector3::from(*vector);
        let moved = |point: &[f64; 3]| -> [f64; 3] { (turned(point) + shift).into() };
        let normals: Vec<Vector3<f64>> = self.normals.iter().map(turned).collect();
        Self {
            offsets: normals.iter().zip(&self.offsets).map(|(normal, offset)| offset + normal.dot(&shift)).collect(),
            normals: normals.into_iter().map(Into::into).collect(),
            vertices: self.vertices.iter().map(moved).collect(),
            center: moved(&self.center),
            center_weights: self.center_weights.clone(),
        }
    }
}

/// Refuses numbers that are infinite, not a number or absurdly large.
fn require_reasonable<'numbers>(entries: impl Iterator<Item = &'numbers [f64]>) -> Result<(), PolytopeError> {
    for (index, entry) in entries.enumerate() {
        if entry.iter().any(|number| !number.is_finite()) {
            return Err(PolytopeError::NotFinite { index });
        }
        if entry.iter().any(|number| number.abs() > LARGEST) {
            return Err(PolytopeError::TooLarge { index });
        }
    }
    Ok(())
}
