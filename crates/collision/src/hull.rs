//! Facets from points and points from halfspaces, by enumeration of triples: parts have dozens of facets, not thousands.

use nalgebra::{Matrix3, Vector3};

/// Lengths below this fraction of a part's size count as rounding of its data.
const RELATIVE_TOLERANCE: f64 = 1e-7;

/// A halfspace `normal p <= offset` with a unit normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facet {
    pub normal: Vector3<f64>,
    pub offset: f64,
}

impl Facet {
    /// Signed distance of a point from the plane, positive outside.
    fn height(&self, point: &Vector3<f64>) -> f64 {
        self.normal.dot(point) - self.offset
    }
}

/// Length that counts as rounding for a set of points (m).
pub fn tolerance(points: &[Vector3<f64>]) -> f64 {
    let first = points.first().copied().unwrap_or_default();
    RELATIVE_TOLERANCE * points.iter().map(|point| (point - first).norm()).fold(0.0, f64::max)
}

/// Points that are not closer than the tolerance to an earlier one.
pub fn distinct(points: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let tolerance = tolerance(points);
    let mut kept: Vec<Vector3<f64>> = Vec::new();
    for point in points {
        if kept.iter().all(|other| (other - point).norm() > tolerance) {
            kept.push(*point);
        }
    }
    kept
}

/// Facets of the convex hull, coplanar ones merged; none when the points lie in a plane.
pub fn facets(points: &[Vector3<f64>]) -> Vec<Facet> {
    let tolerance = tolerance(points);
    let mut facets: Vec<(Facet, Vec<bool>)> = Vec::new();
    for (first, second, third) in triples(points.len()) {
        let known = |on: &[bool]| on[first] && on[second] && on[third];
        if facets.iter().any(|(_, on)| known(on)) {
            continue;
        }
        let Some(plane) = plane(&points[first], &points[second], &points[third], tolerance) else { continue };
        for facet in [plane, Facet { normal: -plane.normal, offset: -plane.offset }] {
            if points.iter().all(|point| facet.height(point) <= tolerance) {
                let on: Vec<bool> = points.iter().map(|point| facet.height(point) >= -tolerance).collect();
                if on.iter().all(|&on| on) {
                    return Vec::new();
                }
                facets.push((supporting(fitted(points, &on, &facet), points), on));
            }
        }
    }
    facets.into_iter().map(|(facet, _)| facet).collect()
}

/// Points in which at least three facets meet.
pub fn extreme_points(points: &[Vector3<f64>], facets: &[Facet]) -> Vec<Vector3<f64>> {
    let tolerance = tolerance(points);
    let is_extreme = |point: &&Vector3<f64>| {
        let touching: Vec<&Facet> = facets.iter().filter(|facet| facet.height(point) >= -2.0 * tolerance).collect();
        spans_space(touching.iter().map(|facet| facet.normal))
    };
    points.iter().filter(is_extreme).copied().collect()
}

/// A direction in which the intersection of halfspaces is infinite.
pub fn open_direction(halfspaces: &[Facet]) -> Option<Vector3<f64>> {
    const ANGLE: f64 = 1e-9;
    let is_open = |direction: &Vector3<f64>| halfspaces.iter().all(|facet| facet.normal.dot(direction) <= ANGLE);
    let count = halfspaces.len();
    let pairs = (0..count).flat_map(|first| (first + 1..count).map(move |second| (first, second)));
    let edges = pairs.map(|(first, second)| halfspaces[first].normal.cross(&halfspaces[second].normal));
    // Where all normals are parallel, any direction across them is open.
    let first = halfspaces.first().map_or(Vector3::x(), |facet| facet.normal);
    let across = first.cross(&Vector3::ith(first.iamin(), 1.0));
    let directions = edges.filter(|edge| edge.norm() > ANGLE).chain(std::iter::once(across));
    directions.map(|edge| edge.normalize()).flat_map(|edge| [edge, -edge]).find(is_open)
}

/// Vertices of a bounded intersection of halfspaces.
pub fn vertices(halfspaces: &[Facet]) -> Vec<Vector3<f64>> {
    const SMALLEST_DETERMINANT: f64 = 1e-12;
    let scale = halfspaces.iter().map(|facet| facet.offset.abs()).fold(0.0, f64::max);
    let mut points = Vec::new();
    for (first, second, third) in triples(halfspaces.len()) {
        let corner = [halfspaces[first], halfspaces[second], halfspaces[third]];
        let normals = Matrix3::from_rows(&corner.map(|facet| facet.normal.transpose()));
        if normals.determinant().abs() < SMALLEST_DETERMINANT {
            continue;
        }
        let offsets = Vector3::from(corner.map(|facet| facet.offset));
        let Some(point) = normals.lu().solve(&offsets) else { continue };
        if halfspaces.iter().all(|facet| facet.height(&point) <= RELATIVE_TOLERANCE * scale) {
            points.push(point);
        }
    }
    distinct(&points)
}

/// Halfspaces that carry a facet, each once.
pub fn irredundant(halfspaces: &[Facet], vertices: &[Vector3<f64>]) -> Vec<Facet> {
    let tolerance = 2.0 * tolerance(vertices);
    let mut kept: Vec<(Facet, Vec<usize>)> = Vec::new();
    for facet in halfspaces {
        let on: Vec<usize> = (0..vertices.len()).filter(|&v| facet.height(&vertices[v]) >= -tolerance).collect();
        let mut corners = triples(on.len());
        let is_face =
            corners.any(|(a, b, c)| plane(&vertices[on[a]], &vertices[on[b]], &vertices[on[c]], tolerance).is_some());
        if is_face && kept.iter().all(|(_, other)| *other != on) {
            kept.push((*facet, on));
        }
    }
    kept.into_iter().map(|(facet, _)| facet).collect()
}

/// The plane through three points, `None` when they are almost in a line.
fn plane(a: &Vector3<f64>, b: &Vector3<f64>, c: &Vector3<f64>, tolerance: f64) -> Option<Facet> {
    let edges = [b - a, c - a, c - b];
    let normal = edges[0].cross(&edges[1]);
    let longest = edges.iter().map(Vector3::norm).fold(0.0, f64::max);
    if normal.norm() <= 2.0 * tolerance * longest {
        return None;
    }
    let normal = normal.normalize();
    Some(Facet { normal, offset: normal.dot(a) })
}

/// The plane through the largest triangle of a facet's points, oriented as the facet.
fn fitted(points: &[Vector3<f64>], on: &[bool], facet: &Facet) -> Facet {
    let corners: Vec<Vector3<f64>> = points.iter().zip(on).filter(|(_, on)| **on).map(|(point, _)| *point).collect();
    let area = |&(a, b, c): &(usize, usize, usize)| (corners[b] - corners[a]).cross(&(corners[c] - corners[a])).norm();
    let Some((a, b, c)) = triples(corners.len()).max_by(|one, other| area(one).total_cmp(&area(other))) else {
        return *facet;
    };
    let normal = (corners[b] - corners[a]).cross(&(corners[c] - corners[a])).normalize();
    let normal = if normal.dot(&facet.normal) < 0.0 { -normal } else { normal };
    Facet { normal, offset: normal.dot(&corners[a]) }
}

/// The facet moved outward until no point is outside.
fn supporting(facet: Facet, points: &[Vector3<f64>]) -> Facet {
    let offset = points.iter().map(|point| facet.normal.dot(point)).fold(f64::NEG_INFINITY, f64::max);
    Facet { offset, ..facet }
}

fn spans_space(normals: impl Iterator<Item = Vector3<f64>>) -> bool {
    const SMALLEST_VOLUME: f64 = 1e-6;
    let normals: Vec<Vector3<f64>> = normals.collect();
    let mut corners = triples(normals.len());
    corners.any(|(a, b, c)| normals[a].cross(&normals[b]).dot(&normals[c]).abs() > SMALLEST_VOLUME)
}

fn triples(count: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..count).flat_map(move |a| (a + 1..count).flat_map(move |b| (b + 1..count).map(move |c| (a, b, c))))
}
