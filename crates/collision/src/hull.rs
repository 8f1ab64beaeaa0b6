//! Facets from points and points from halfspaces, by trial of all triples that may span one.
//!
//! Whether a triple spans a facet, and which points belong to it, is decided by tolerances here. An exact triangulation
//! names the triples that are worth a trial: three points that span a supporting plane are all near one triangle of the
//! hull, and three halfspaces that meet in a vertex are all near one vertex.

use std::collections::{BTreeSet, HashMap};

use nalgebra::{Matrix3, Vector3};

use crate::facet::Facet;
use crate::interior;
use crate::triangulation::{Triangle, groups, triangulate, triples_within};

/// Lengths below this fraction of a part's size count as rounding of its data.
const RELATIVE_TOLERANCE: f64 = 1e-7;

/// All points are at most a tolerance above the plane of three points. The centre of the three is then at most a tolerance
/// below a triangle of the hull and each of them at most three; the rest is for rounding.
const NEAR: f64 = 4.0;

/// Above this number, not every triple is compared.
const MOST_COMPARED: usize = 128;

/// Length that counts as rounding for a set of points (m).
pub fn tolerance(points: &[Vector3<f64>]) -> f64 {
    let first = points.first().copied().unwrap_or_default();
    RELATIVE_TOLERANCE * points.iter().map(|point| (point - first).norm()).fold(0.0, f64::max)
}

/// Points that are not closer than the tolerance to an earlier one.
pub fn distinct(points: &[Vector3<f64>], tolerance: f64) -> Vec<Vector3<f64>> {
    /// Edge of a cell in tolerances: few points are near more than one cell.
    const CELL: f64 = 16.0;
    let first = points.first().copied().unwrap_or_default();
    let cell = |coordinate: f64| (coordinate / (CELL * tolerance)).floor() as i64;
    let mut kept: Vec<Vector3<f64>> = Vec::new();
    let mut near_cell: HashMap<[i64; 3], Vec<Vector3<f64>>> = HashMap::new();
    for point in points {
        let place = point - first;
        let others = near_cell.get(&[cell(place.x), cell(place.y), cell(place.z)]);
        if others.into_iter().flatten().all(|other| (other - point).norm() > tolerance) {
            kept.push(*point);
            let reach = 1.01 * tolerance;
            let [x, y, z] = [place.x, place.y, place.z].map(|along| cell(along - reach)..=cell(along + reach));
            for (x, y) in x.flat_map(|x| y.clone().map(move |y| (x, y))) {
                z.clone().for_each(|z| near_cell.entry([x, y, z]).or_default().push(*point));
            }
        }
    }
    kept
}

/// Facets of the convex hull, coplanar ones merged, each with the largest triangle of its points; none when the points
/// lie in a plane.
pub fn facets(points: &[Vector3<f64>], tolerance: f64) -> Vec<Triangle> {
    let is_near = |plane: &Facet, point: usize| plane.height(&points[point]) >= -NEAR * tolerance;
    let groups = groups(&triangulate(points), points.len(), is_near);
    // The plane of a small triangle that is known to a coarse tolerance misses points of its facet further away.
    let is_coarse = tolerance > self::tolerance(points);
    let wide = if is_coarse { widest_first(points, &groups) } else { Vec::new() };
    let mut facets: Vec<Triangle> = Vec::new();
    let mut touching: Vec<Vec<usize>> = vec![Vec::new(); points.len()];
    for [first, second, third] in wide.into_iter().chain(triples_within(&groups, points.len())) {
        let touches = |point: usize, facet: &usize| touching[point].binary_search(facet).is_ok();
        if touching[first].iter().any(|facet| touches(second, facet) && touches(third, facet)) {
            continue;
        }
        let Some(plane) = plane(&points[first], &points[second], &points[third], tolerance) else { continue };
        for facet in [plane, Facet { normal: -plane.normal, offset: -plane.offset }] {
            if points.iter().all(|point| facet.height(point) <= tolerance) {
                let on: Vec<usize> =
                    (0..points.len()).filter(|&point| facet.height(&points[point]) >= -tolerance).collect();
                if on.len() == points.len() {
                    return Vec::new();
                }
                on.iter().for_each(|&point| touching[point].push(facets.len()));
                facets.extend(fitted(points, &on, &facet, tolerance));
            }
        }
    }
    facets
}

/// The largest triangle of each group, in the order of their areas.
fn widest_first(points: &[Vector3<f64>], groups: &BTreeSet<Vec<usize>>) -> Vec<[usize; 3]> {
    let mut triangles: Vec<([usize; 3], f64)> =
        groups.iter().filter_map(|group| largest_triangle(points, group)).collect();
    triangles.sort_by(|one, other| other.1.total_cmp(&one.1));
    triangles.into_iter().map(|(triangle, _)| triangle).collect()
}

/// Points in which at least three facets meet.
pub fn extreme_points(points: &[Vector3<f64>], facets: &[Triangle], tolerance: f64) -> Vec<Vector3<f64>> {
    let touches = |facet: &Triangle, point: &Vector3<f64>| facet.plane.height(point) >= -2.0 * tolerance;
    let is_extreme = |point: &Vector3<f64>| {
        let touching = facets.iter().filter(|facet| touches(facet, point));
        spans_space(&touching.map(|facet| facet.plane.normal).collect::<Vec<_>>())
    };
    let mut extreme: Vec<bool> = points.iter().map(is_extreme).collect();
    // Where facets are almost parallel, as those of a flat cone, their normals do not show which points are corners.
    for facet in facets {
        let vertices = points.iter().zip(&extreme).filter(|(point, extreme)| **extreme && touches(facet, point));
        if vertices.count() < 3 {
            facet.corners.iter().for_each(|&corner| extreme[corner] = true);
        }
    }
    points.iter().zip(extreme).filter(|(_, extreme)| *extreme).map(|(point, _)| *point).collect()
}

/// A direction in which the intersection of halfspaces is infinite.
pub fn open_direction(halfspaces: &[Facet]) -> Option<Vector3<f64>> {
    const ANGLE: f64 = 1e-9;
    // Bounded are the halfspaces whose normals have the origin inside their hull.
    let normals: Vec<Vector3<f64>> = halfspaces.iter().map(|facet| facet.normal).collect();
    let triangles = triangulate(&[&normals[..], &[Vector3::zeros()]].concat());
    if triangles.is_empty() {
        return Some(across(&normals, ANGLE));
    }
    let open = triangles.iter().map(|triangle| triangle.plane).filter(|plane| plane.offset <= ANGLE);
    open.map(|plane| plane.normal).reduce(|sum, normal| sum + normal).map(|sum| sum.normalize())
}

/// A direction across normals that lie in a plane through the origin.
fn across(normals: &[Vector3<f64>], angle: f64) -> Vector3<f64> {
    let first = normals.first().copied().unwrap_or(Vector3::x());
    let directions = normals.iter().map(|normal| first.cross(normal));
    let widest = directions.max_by(|one, other| one.norm().total_cmp(&other.norm()));
    widest
        .filter(|direction| direction.norm() > angle)
        .unwrap_or(first.cross(&Vector3::ith(first.iamin(), 1.0)))
        .normalize()
}

/// Vertices of a bounded intersection of halfspaces.
pub fn vertices(halfspaces: &[Facet]) -> Vec<Vector3<f64>> {
    const SMALLEST_DETERMINANT: f64 = 1e-12;
    let scale = halfspaces.iter().map(|facet| facet.offset.abs()).fold(0.0, f64::max);
    let slack = RELATIVE_TOLERANCE * scale;
    let mut points = Vec::new();
    for triple in meeting(halfspaces, slack) {
        let corner = triple.map(|index| halfspaces[index]);
        let normals = Matrix3::from_rows(&corner.map(|facet| facet.normal.transpose()));
        if normals.determinant().abs() < SMALLEST_DETERMINANT {
            continue;
        }
        let offsets = Vector3::from(corner.map(|facet| facet.offset));
        let Some(point) = normals.lu().solve(&offsets) else { continue };
        if halfspaces.iter().all(|facet| facet.height(&point) <= slack) {
            points.push(point);
        }
    }
    distinct(&points, tolerance(&points))
}

/// Triples of halfspaces that may meet in a point that is at most `slack` outside of the others.
///
/// Such a point is inside the halfspaces moved outward by the slack. Where the sum of the three normals reaches furthest
/// in there, a vertex is at most three slacks below each of the three.
fn meeting(halfspaces: &[Facet], slack: f64) -> Vec<[usize; 3]> {
    let moved: Vec<Facet> = halfspaces.iter().map(|facet| Facet { offset: facet.offset + slack, ..*facet }).collect();
    let Some(inside) = interior::point_inside(&moved, 0.1 * slack) else { return Vec::new() };
    let center = interior::analytic_center(&moved, inside);
    let Some(round) = interior::barrier(&moved, &center).1.cholesky() else { return Vec::new() };
    // In coordinates in which the intersection is round, vertices are the facets of the hull of the polar points.
    let depths: Vec<f64> = moved.iter().map(|facet| -facet.height(&center)).collect();
    let polar = |(facet, depth): (&Facet, &f64)| round.l_dirty().solve_lower_triangular(&(facet.normal / *depth));
    let polars: Option<Vec<Vector3<f64>>> = moved.iter().zip(&depths).map(polar).collect();
    let Some(polars) = polars else { return Vec::new() };
    let is_near =
        |vertex: &Facet, index: usize| -vertex.height(&polars[index]) * depths[index] <= NEAR * slack * vertex.offset;
    triples_within(&groups(&triangulate(&polars), polars.len(), is_near), polars.len()).collect()
}

/// Halfspaces that carry a facet, each once.
pub fn irredundant(halfspaces: &[Facet], vertices: &[Vector3<f64>]) -> Vec<Facet> {
    let tolerance = 2.0 * tolerance(vertices);
    let mut kept: Vec<(Facet, Vec<usize>)> = Vec::new();
    for facet in halfspaces {
        let on: Vec<usize> = (0..vertices.len()).filter(|&v| facet.height(&vertices[v]) >= -tolerance).collect();
        let corners = |triple: [usize; 3]| triple.map(|corner| &vertices[on[corner]]);
        let widest = largest(on.len(), |triple| altitude(corners(triple)));
        let is_face = widest.is_some_and(|(_, altitude)| altitude > 2.0 * tolerance);
        if is_face && kept.iter().all(|(_, other)| *other != on) {
            kept.push((*facet, on));
        }
    }
    kept.into_iter().map(|(facet, _)| facet).collect()
}

/// The plane through three points, `None` when they are almost in a line.
fn plane(a: &Vector3<f64>, b: &Vector3<f64>, c: &Vector3<f64>, tolerance: f64) -> Option<Facet> {
    if altitude([a, b, c]) <= 2.0 * tolerance {
        return None;
    }
    let normal = (b - a).cross(&(c - a)).normalize();
    Some(Facet { normal, offset: normal.dot(a) })
}

/// Smallest altitude of a triangle.
fn altitude([a, b, c]: [&Vector3<f64>; 3]) -> f64 {
    let edges = [b - a, c - a, c - b];
    edges[0].cross(&edges[1]).norm() / edges.iter().map(Vector3::norm).fold(0.0, f64::max)
}

/// The largest triangle of a facet's points with its plane, oriented as the facet and moved outward until no point is
/// outside.
fn fitted(points: &[Vector3<f64>], on: &[usize], facet: &Facet, tolerance: f64) -> Option<Triangle> {
    let (corners, _) = largest_triangle(points, on)?;
    let [a, b, c] = corners.map(|corner| points[corner]);
    let normal = (b - a).cross(&(c - a)).normalize();
    let supporting = |normal: Vector3<f64>| {
        let offset = points.iter().map(|point| normal.dot(point)).fold(f64::NEG_INFINITY, f64::max);
        Facet { normal, offset }
    };
    let plane = supporting(if normal.dot(&facet.normal) < 0.0 { -normal } else { normal });
    // The triangle of points that are almost in a line may be tilted.
    let plane = if plane.height(&a) < -NEAR * tolerance { supporting(facet.normal) } else { plane };
    Some(Triangle { corners, plane })
}

/// The largest triangle of some of the points, with twice its area.
fn largest_triangle(points: &[Vector3<f64>], some: &[usize]) -> Option<([usize; 3], f64)> {
    let corners = |triple: [usize; 3]| triple.map(|corner| points[some[corner]]);
    let area = |[a, b, c]: [Vector3<f64>; 3]| (b - a).cross(&(c - a)).norm();
    let (triple, area) = largest(some.len(), |triple| area(corners(triple)))?;
    Some((triple.map(|corner| some[corner]), area))
}

fn spans_space(normals: &[Vector3<f64>]) -> bool {
    const SMALLEST_VOLUME: f64 = 1e-10;
    let volume = |[a, b, c]: [usize; 3]| normals[a].cross(&normals[b]).dot(&normals[c]).abs();
    largest(normals.len(), volume).is_some_and(|(_, volume)| volume > SMALLEST_VOLUME)
}

/// The triple with the largest measure and that measure, the last of equal ones. Of very many, a triple that is the best
/// for each two of its members.
fn largest(count: usize, measure: impl Fn([usize; 3]) -> f64) -> Option<([usize; 3], f64)> {
    let rated = |triple: [usize; 3]| (triple, measure(triple));
    let best = |triples: &mut dyn Iterator<Item = [usize; 3]>| {
        triples.map(rated).max_by(|one, other| one.1.total_cmp(&other.1))
    };
    if count <= MOST_COMPARED {
        return best(&mut triples(count));
    }
    let mut largest = rated([0, count / 3, 2 * count / 3]);
    loop {
        let exchanged = |member: usize| {
            let others = largest.0;
            (0..count)
                .map(move |other| std::array::from_fn(|place| if place == member { other } else { others[place] }))
        };
        match best(&mut (0..3).flat_map(exchanged)) {
            Some(better) if better.1 > largest.1 => largest = better,
            _ => return Some(largest),
        }
    }
}

fn triples(count: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..count).flat_map(move |a| (a + 1..count).flat_map(move |b| (b + 1..count).map(move |c| [a, b, c])))
}
