//! Convex cells between planes, with the polygons that bound them.

use crate::geometry::{Plane, Vector, area_vector, bounds, clip, mean};

/// A halfspace that bounds a cell: one side of a numbered plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Number of the plane.
    pub id: usize,
    /// Whether the cell is in front of the numbered plane.
    pub is_flipped: bool,
    /// The plane with its normal out of the cell.
    pub plane: Plane,
}

impl Bound {
    pub fn flipped(&self) -> Self {
        Self { is_flipped: !self.is_flipped, plane: self.plane.flipped(), ..*self }
    }

    pub fn moved(&self, distance: f64) -> Self {
        Self { plane: self.plane.moved(distance), ..*self }
    }

    /// Whether it is the same side of the same plane.
    pub fn is(&self, other: &Self) -> bool {
        self.id == other.id && self.is_flipped == other.is_flipped
    }
}

/// A bounded convex cell.
#[derive(Debug, Clone)]
pub struct Cell {
    pub bounds: Vec<Bound>,
    /// One polygon per bound, corners in the plane of the bound.
    pub polygons: Vec<Vec<Vector>>,
}

impl Cell {
    /// A box with these six bounds, in the order of lower and upper ones.
    pub fn of_box([low, high]: &[Vector; 2], bounds: [Bound; 6]) -> Self {
        let polygons = (0..6).map(|face| {
            let axis = face % 3;
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let corner = |at_u: bool, at_v: bool| {
                let mut corner = if face < 3 { *low } else { *high };
                corner[u] = if at_u { high[u] } else { low[u] };
                corner[v] = if at_v { high[v] } else { low[v] };
                corner
            };
            let mut polygon = vec![corner(false, false), corner(true, false), corner(true, true), corner(false, true)];
            if face < 3 {
                polygon.reverse();
            }
            polygon
        });
        Self { bounds: bounds.into(), polygons: polygons.collect() }
    }

    /// Corners, each several times.
    pub fn corners(&self) -> impl Iterator<Item = &Vector> {
        self.polygons.iter().flatten()
    }

    pub fn center(&self) -> Vector {
        mean(self.corners())
    }

    pub fn bounding_box(&self) -> [Vector; 2] {
        bounds(self.corners())
    }

    pub fn volume(&self) -> f64 {
        let center = self.center();
        let pyramid =
            |(polygon, bound): (&Vec<Vector>, &Bound)| -area_vector(polygon).norm() * bound.plane.height(&center);
        self.polygons.iter().zip(&self.bounds).map(pyramid).sum::<f64>() / 3.0
    }

    /// Smallest extent across a bound (m).
    pub fn thickness(&self) -> f64 {
        let extents = self.bounds.iter().map(|bound| -bound.plane.heights(self.corners()).0);
        extents.fold(f64::INFINITY, f64::min)
    }

    /// Whether all corners are behind a plane by no less than the tolerance (m) in front of it.
    pub fn is_behind(&self, plane: &Plane, tolerance: f64) -> bool {
        self.corners().all(|corner| plane.height(corner) <= tolerance)
    }

    /// The part behind a bound, `None` when it is thinner than the tolerance (m). Corners within the tolerance of the
    /// plane count as on it.
    pub fn cut(&self, bound: &Bound, tolerance: f64) -> Option<Self> {
        let (low, high) = bound.plane.heights(self.corners());
        if high <= tolerance {
            return Some(self.clone());
        }
        if low >= -tolerance {
            return None;
        }
        let mut cut = Self { bounds: Vec::new(), polygons: Vec::new() };
        let mut rim: Vec<Vector> = Vec::new();
        for (own, polygon) in self.bounds.iter().zip(&self.polygons) {
            let behind = clip(polygon, &bound.plane, tolerance);
            rim.extend(behind.iter().filter(|corner| bound.plane.height(corner) >= -tolerance));
            if is_wide(&behind, tolerance) {
                cut.bounds.push(*own);
                cut.polygons.push(behind);
            }
        }
        let cap = around(rim, &bound.plane, tolerance);
        if is_wide(&cap, tolerance) {
            cut.bounds.push(*bound);
            cut.polygons.push(cap);
        }
        (cut.bounds.len() >= 4).then_some(cut)
    }

    /// The part behind all of the bounds.
    pub fn cut_by<'a>(&self, bounds: impl IntoIterator<Item = &'a Bound>, tolerance: f64) -> Option<Self> {
        self.cut_by_at_cost(bounds, tolerance, &mut 0)
    }

    /// The part behind all of the bounds. Adds the number of polygons that are compared with a bound to the cost.
    pub fn cut_by_at_cost<'a>(
        &self,
        bounds: impl IntoIterator<Item = &'a Bound>,
        tolerance: f64,
        cost: &mut usize,
    ) -> Option<Self> {
        let mut cell = std::borrow::Cow::Borrowed(self);
        let mut ball = cell.ball();
        for bound in bounds {
            // Most bounds are far away: no need to look at all corners, or to copy the cell, for them.
            let is_far = bound.plane.height(&ball.0) + ball.1 <= tolerance;
            *cost += if is_far { 1 } else { cell.bounds.len() };
            if !is_far && !cell.is_behind(&bound.plane, tolerance) {
                cell = std::borrow::Cow::Owned(cell.cut(bound, tolerance)?);
                ball = cell.ball();
            }
        }
        Some(cell.into_owned())
    }

    /// Centre and radius (m) of a ball around the cell.
    fn ball(&self) -> (Vector, f64) {
        let center = self.center();
        let radius = self.corners().map(|corner| (corner - center).norm()).fold(0.0, f64::max);
        (center, radius)
    }
}

/// Whether a polygon is more than a line within the tolerance (m).
pub fn is_wide(polygon: &[Vector], tolerance: f64) -> bool {
    if polygon.len() < 3 {
        return false;
    }
    let longest = polygon.iter().map(|corner| (corner - polygon[0]).norm()).fold(0.0, f64::max);
    area_vector(polygon).norm() > tolerance * longest
}

/// The convex polygon with these corners, anticlockwise around the normal.
fn around(corners: Vec<Vector>, plane: &Plane, tolerance: f64) -> Vec<Vector> {
    let mut distinct: Vec<Vector> = Vec::new();
    for corner in corners {
        if distinct.iter().all(|other| (other - corner).norm() > 0.1 * tolerance) {
            distinct.push(corner);
        }
    }
    let center = mean(&distinct);
    let u = plane.normal.cross(&Vector::ith(plane.normal.iamin(), 1.0)).normalize();
    let v = plane.normal.cross(&u);
    let angle = |corner: &Vector| v.dot(&(corner - center)).atan2(u.dot(&(corner - center)));
    distinct.sort_by(|one, other| angle(one).total_cmp(&angle(other)));
    distinct
}
