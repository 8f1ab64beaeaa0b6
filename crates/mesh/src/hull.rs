//! Convex hulls of points, in exact arithmetic.
//!
//! Points are rounded to a grid that is finer than the precision of any file, on which every sign is exact: points in a
//! plane, on a line or on each other are no special cases.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::geometry::{Plane, Vector, bounds};
use crate::nearest::nearest;

/// Coordinates on the grid lie within `2^GRID_BITS`: the sums of products of three differences stay below `2^126`.
const GRID_BITS: i32 = 36;
/// Heights in floating point below this share of the size may have the wrong sign.
const UNCERTAIN: f64 = 1e-9;

type GridPoint = [i64; 3];

/// The convex hull of some points as triangles.
#[derive(Debug, Clone)]
pub struct Hull {
    /// Its corners (m).
    pub points: Vec<Vector>,
    /// Corners of each triangle, anticlockwise seen from outside.
    pub triangles: Vec<[usize; 3]>,
    /// The planes of the triangles, normals outward.
    pub planes: Vec<Plane>,
    /// The box around it.
    pub bounds: [Vector; 2],
}

struct Face {
    corners: [usize; 3],
    plane: Plane,
    /// Points in front of it.
    ahead: Vec<usize>,
}

struct Points {
    exact: Vec<GridPoint>,
    points: Vec<Vector>,
    uncertain: f64,
    /// Points are left out that are no farther from the hull (m).
    tolerance: f64,
}

impl Points {
    /// Distinct points on a grid that is much finer than the tolerance (m), if there is one.
    fn new(points: &[Vector], tolerance: f64) -> Self {
        let [low, high] = bounds(points);
        let size = (high - low).amax();
        let step = (0.1 * tolerance).max(size * 2f64.powi(-GRID_BITS));
        let mut known: FxHashSet<GridPoint> = FxHashSet::default();
        let mut own = Self { exact: Vec::new(), points: Vec::new(), uncertain: UNCERTAIN * size, tolerance };
        for point in points {
            let exact: GridPoint = std::array::from_fn(|axis| ((point - low)[axis] / step).round() as i64);
            if known.insert(exact) {
                own.exact.push(exact);
                own.points.push(low + Vector::from(exact.map(|coordinate| coordinate as f64)) * step);
            }
        }
        own
    }

    /// Six times the volume of the tetrahedron between three points and one in front of them.
    fn volume(&self, [a, b, c]: [usize; 3], d: usize) -> i128 {
        let to = |point: usize| -> [i128; 3] {
            std::array::from_fn(|axis| i128::from(self.exact[point][axis] - self.exact[a][axis]))
        };
        let (u, v, w) = (to(b), to(c), to(d));
        w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) + w[2] * (u[0] * v[1] - u[1] * v[0])
    }

    fn face(&self, corners: [usize; 3]) -> Face {
        let [a, b, c] = corners.map(|corner| self.points[corner]);
        let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_default();
        Face { corners, plane: Plane::through(&a, normal), ahead: Vec::new() }
    }

    fn sees(&self, face: &Face, point: usize) -> bool {
        let height = face.plane.height(&self.points[point]);
        if height.abs() > self.uncertain { height > 0.0 } else { self.volume(face.corners, point) > 0 }
    }

    /// Four points that are not in a plane, those of the first three far apart.
    fn simplex(&self) -> Option<[usize; 4]> {
        let all = 0..self.points.len();
        let by = |value: &dyn Fn(usize) -> f64| all.clone().max_by(|&i, &j| value(i).total_cmp(&value(j)));
        let a = by(&|point| -self.points[point].x)?;
        let b = by(&|point| (self.points[point] - self.points[a]).norm())?;
        let along = self.points[b] - self.points[a];
        let c = by(&|point| along.cross(&(self.points[point] - self.points[a])).norm())?;
        let d = all.clone().max_by_key(|&point| self.volume([a, b, c], point).abs())?;
        (self.volume([a, b, c], d) != 0).then_some([a, b, c, d])
    }
}

impl Hull {
    /// The hull of points, which may be outside of it by a tolerance (m); none when they lie in a plane.
    pub fn of(points: &[Vector], tolerance: f64) -> Option<Self> {
        let all = Points::new(points, tolerance);
        let [a, b, c, d] = all.simplex()?;
        let (a, b) = if all.volume([a, b, c], d) > 0 { (b, a) } else { (a, b) };
        let mut faces: Vec<Option<Face>> =
            [[a, b, c], [a, d, b], [b, d, c], [c, d, a]].map(|corners| Some(all.face(corners))).into();
        let mut across: FxHashMap<(usize, usize), usize> = FxHashMap::default();
        for (index, face) in faces.iter().flatten().enumerate() {
            sides(face.corners).for_each(|side| _ = across.insert(side, index));
        }
        let mut waiting: Vec<usize> = (0..4).collect();
        (0..all.points.len()).for_each(|point| assign(&all, &mut faces, &[0, 1, 2, 3], point));
        while let Some(index) = waiting.pop() {
            let Some(face) = &faces[index] else { continue };
            let height = |point: &usize| face.plane.height(&all.points[*point]);
            let Some(&apex) = face.ahead.iter().max_by(|one, other| height(one).total_cmp(&height(other))) else {
                continue;
            };
            // All faces that the point sees are connected.
            let (mut seen, mut horizon, mut next) = (vec![index], Vec::new(), 0);
            while let Some(&at) = seen.get(next) {
                next += 1;
                let corners = faces[at].as_ref().map(|face| face.corners)?;
                for (from, to) in sides(corners) {
                    let other = *across.get(&(to, from))?;
                    if seen.contains(&other) {
                        continue;
                    }
                    if faces[other].as_ref().is_some_and(|other| all.sees(other, apex)) {
                        seen.push(other);
                    } else {
                        horizon.push((from, to));
                    }
                }
            }
            let mut loose: Vec<usize> = Vec::new();
            for at in seen {
                loose.extend(faces[at].take().into_iter().flat_map(|face| face.ahead));
            }
            loose.retain(|&point| point != apex);
            let new: Vec<usize> = (faces.len()..faces.len() + horizon.len()).collect();
            for (from, to) in horizon {
                let corners = [from, to, apex];
                sides(corners).for_each(|side| _ = across.insert(side, faces.len()));
                faces.push(Some(all.face(corners)));
            }
            loose.into_iter().for_each(|point| assign(&all, &mut faces, &new, point));
            waiting.extend(new);
        }
        // Large triangles first: they separate most.
        let mut faces: Vec<Face> = faces.into_iter().flatten().collect();
        let area = |face: &Face| {
            let [a, b, c] = face.corners.map(|corner| all.points[corner]);
            (b - a).cross(&(c - a)).norm_squared()
        };
        faces.sort_by(|one, other| area(other).total_cmp(&area(one)));
        Some(Self::compact(&all.points, &faces))
    }

    fn compact(points: &[Vector], faces: &[Face]) -> Self {
        let mut index: FxHashMap<usize, usize> = FxHashMap::default();
        let mut corners = Vec::new();
        let triangles = faces.iter().map(|face| {
            face.corners.map(|corner| {
                *index.entry(corner).or_insert_with(|| {
                    corners.push(points[corner]);
                    corners.len() - 1
                })
            })
        });
        let triangles = triangles.collect();
        let bounds = bounds(&corners);
        Self { points: corners, triangles, planes: faces.iter().map(|face| face.plane).collect(), bounds }
    }

    /// Volume (m^3).
    pub fn volume(&self) -> f64 {
        let [low, high] = self.bounds;
        let center = 0.5 * (low + high);
        let corners = self.triangles.iter().map(|triangle| triangle.map(|corner| self.points[corner] - center));
        corners.map(|[a, b, c]| a.dot(&b.cross(&c)) / 6.0).sum()
    }

    /// Whether a point is at least so far (m) from the hull.
    pub fn is_beyond(&self, point: &Vector, distance: f64) -> bool {
        let [low, high] = &self.bounds;
        let to_box = (point - point.sup(low).inf(high)).norm_squared();
        if distance > 0.0 && to_box >= distance * distance {
            return true;
        }
        let mut height = f64::NEG_INFINITY;
        for plane in &self.planes {
            height = plane.height(point).max(height);
            if height >= distance {
                return true;
            }
        }
        let is_far = |(triangle, plane): (&[usize; 3], &Plane)| {
            let to = || (nearest(point, &triangle.map(|corner| self.points[corner])) - point).norm_squared();
            plane.height(point) <= 0.0 || to() >= distance * distance
        };
        height > 0.0 && self.triangles.iter().zip(&self.planes).all(is_far)
    }

    /// The point of the hull nearest to one outside.
    pub fn nearest(&self, point: &Vector) -> Option<Vector> {
        let ahead = self.triangles.iter().zip(&self.planes).filter(|(_, plane)| plane.height(point) > 0.0);
        ahead
            .map(|(triangle, _)| nearest(point, &triangle.map(|corner| self.points[corner])))
            .min_by(|one, other| (one - point).norm().total_cmp(&(other - point).norm()))
    }

    /// Planes around the hull with the area of the triangles (m^2) that lie in each within the tolerance (m), largest
    /// first.
    pub fn facets(&self, tolerance: f64) -> Vec<(Plane, f64)> {
        let area = |triangle: &[usize; 3]| {
            let [a, b, c] = triangle.map(|corner| self.points[corner]);
            0.5 * (b - a).cross(&(c - a)).norm()
        };
        let mut order: Vec<(usize, f64)> = self.triangles.iter().map(area).enumerate().collect();
        order.sort_by(|one, other| other.1.total_cmp(&one.1));
        let mut facets: Vec<(Plane, f64)> = Vec::new();
        for (index, area) in order {
            let corners = self.triangles[index].map(|corner| self.points[corner]);
            let is_in = |plane: &Plane| corners.iter().all(|corner| plane.height(corner) >= -tolerance);
            match facets.iter_mut().find(|(plane, _)| is_in(plane)) {
                Some((_, total)) => *total += area,
                None => {
                    // Planes of small triangles are inexact: none may cut the hull.
                    let plane = self.planes[index];
                    facets.push((plane.moved(plane.heights(&self.points).1.max(0.0)), area));
                }
            }
        }
        facets
    }
}

fn sides([a, b, c]: [usize; 3]) -> impl Iterator<Item = (usize, usize)> {
    [(a, b), (b, c), (c, a)].into_iter()
}

/// Puts a point before the first of some faces that it sees; those that see none are inside.
fn assign(all: &Points, faces: &mut [Option<Face>], among: &[usize], point: usize) {
    // Points that are hardly outside, such as those all over a planar face, would only make slivers.
    let sees = |index: &&usize| {
        faces[**index].as_ref().is_some_and(|face| {
            !face.corners.contains(&point)
                && (face.plane.height(&all.points[point]) > all.tolerance || face.plane.normal == Vector::zeros())
                && all.sees(face, point)
        })
    };
    if let Some(&index) = among.iter().find(sees)
        && let Some(face) = &mut faces[index]
    {
        face.ahead.push(point);
    }
}

/// Triangles of the convex hull of points (m), anticlockwise seen from outside; none when they lie in a plane.
pub fn hull_triangles(points: &[[f64; 3]]) -> Vec<[[f64; 3]; 3]> {
    let points: Vec<Vector> = points.iter().copied().map(Vector::from).collect();
    let hull = Hull::of(&points, 0.0);
    let corners = |hull: Hull| {
        let corner = |corner: usize| <[f64; 3]>::from(hull.points[corner]);
        hull.triangles.iter().map(|triangle| triangle.map(corner)).collect()
    };
    hull.map(corners).unwrap_or_default()
}
