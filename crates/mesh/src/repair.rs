//! Meshes made closed and consistent where it is certain how.

use std::collections::BTreeMap;

use crate::crossing::refuse_crossings;
use crate::edges::{Edges, edges, undirected};
use crate::error::MeshError;
use crate::geometry::{Plane, Vector, area_vector, mean};
use crate::loose::{drop_sheets, join_rims};
use crate::read::TriangleMesh;
use crate::shells::{Oriented, orient};
use crate::superfluous::{without_copies, without_slivers};
use crate::surface::{Repair, Surface};
use crate::triangulate::triangulate;
use crate::weld::weld;

/// Points of a file are the same, and in a plane, within this many roundings: each of two coordinates, in space.
pub const SAME: f64 = 4.0;
/// A hole that takes this share of the surface is not small: more than a triangle is missing there.
const SMALL_HOLE: f64 = 0.02;
/// A hole with more edges is not capped.
const MOST_EDGES: usize = 2000;

/// Repairs a mesh.
///
/// # Errors
/// When it is open, not orientable or does not enclose a volume.
pub fn repair(mesh: &TriangleMesh) -> Result<Surface, MeshError> {
    let tolerance = SAME * mesh.rounding;
    let (vertices, index) = weld(&mesh.vertices, tolerance);
    let welded: Vec<[usize; 3]> = mesh.triangles.iter().map(|corners| corners.map(|corner| index[corner])).collect();
    let whole: Vec<[usize; 3]> = welded.iter().copied().filter(|[a, b, c]| a != b && b != c && c != a).collect();
    let single = without_copies(whole.clone());
    let mut repairs = Vec::new();
    note(&mut repairs, whole.len() - single.len(), |triangles| Repair::Duplicates { triangles });
    let mut surface = Surface { vertices, triangles: single, repairs };
    drop_sheets(&mut surface, mesh.scale);
    let with_slivers = surface.triangles.len();
    surface.triangles = without_slivers(surface.triangles, &surface.vertices, tolerance);
    let collapsed = welded.len() - whole.len() + with_slivers - surface.triangles.len();
    note(&mut surface.repairs, collapsed, |triangles| Repair::Collapsed { triangles });
    join_rims(&mut surface, mesh.scale);
    let rewound = wind(&mut surface, mesh.scale)?;
    note(&mut surface.repairs, rewound, |triangles| Repair::Rewound { triangles });
    close(&mut surface, mesh.scale, tolerance)?;
    refuse_flat(&surface, tolerance)?;
    refuse_crossings(&surface, mesh.scale, tolerance)?;
    let Oriented { turned, flat } = orient(&mut surface, mesh.scale, tolerance)?;
    note(&mut surface.repairs, turned, |shells| Repair::Inverted { shells });
    note(&mut surface.repairs, flat, |shells| Repair::Flat { shells });
    Ok(surface)
}

fn refuse_flat(surface: &Surface, tolerance: f64) -> Result<(), MeshError> {
    let corners = surface.triangles.iter().map(|triangle| triangle.map(|corner| surface.vertices[corner]));
    let areas = corners.clone().map(|corners| (area_vector(&corners), corners[0]));
    let largest = areas.max_by(|one, other| one.0.norm().total_cmp(&other.0.norm()));
    let (area, point) = largest.ok_or(MeshError::Flat)?;
    let plane = Plane::through(&point, area.try_normalize(0.0).ok_or(MeshError::Flat)?);
    let (low, high) = plane.heights(corners.collect::<Vec<_>>().as_flattened());
    if high - low <= 2.0 * tolerance { Err(MeshError::Flat) } else { Ok(()) }
}

fn note(repairs: &mut Vec<Repair>, count: usize, repair: impl Fn(usize) -> Repair) {
    if count > 0 {
        repairs.push(repair(count));
    }
}

/// A triangle across an edge, and whether it is wound alike.
#[derive(Debug, Clone, Copy)]
struct Neighbor {
    triangle: usize,
    is_same: bool,
    edge: (usize, usize),
}

/// Winds triangles like their neighbours, each component as most of it was. Returns the number of those turned around.
pub fn wind(surface: &mut Surface, scale: f64) -> Result<usize, MeshError> {
    let edges = edges(&surface.triangles);
    let place = |edge: (usize, usize)| (0.5 * (surface.vertices[edge.0] + surface.vertices[edge.1]) / scale).into();
    let mut neighbors: Vec<Vec<Neighbor>> = vec![Vec::new(); surface.triangles.len()];
    for (edge, sides) in edges.iter() {
        if let [one, other] = sides[..] {
            let is_same = one.is_forward != other.is_forward;
            neighbors[one.triangle].push(Neighbor { triangle: other.triangle, is_same, edge });
            neighbors[other.triangle].push(Neighbor { triangle: one.triangle, is_same, edge });
        }
    }
    let mut is_turned: Vec<Option<bool>> = vec![None; surface.triangles.len()];
    for first in 0..surface.triangles.len() {
        if is_turned[first].is_some() {
            continue;
        }
        is_turned[first] = Some(false);
        let mut component = vec![first];
        let mut next = 0;
        while let Some(&triangle) = component.get(next) {
            next += 1;
            for &Neighbor { triangle: neighbor, is_same, edge } in &neighbors[triangle] {
                let wanted = is_turned[triangle] == Some(is_same);
                // Wound alike, a neighbour is turned when this one is; otherwise when this one is not.
                match is_turned[neighbor] {
                    None => {
                        is_turned[neighbor] = Some(wanted);
                        component.push(neighbor);
                    }
                    Some(turned) if turned != wanted => return Err(MeshError::OneSided { place: place(edge) }),
                    Some(_) => {}
                }
            }
        }
        let turned = component.iter().filter(|&&triangle| is_turned[triangle] == Some(true)).count();
        if 2 * turned > component.len() {
            component.iter().for_each(|&triangle| is_turned[triangle] = is_turned[triangle].map(|turned| !turned));
        }
    }
    let turned = surface.triangles.iter_mut().zip(&is_turned).filter(|(_, turned)| **turned == Some(true));
    Ok(turned.map(|(corners, _)| corners.swap(1, 2)).count())
}

/// Closes holes.
fn close(surface: &mut Surface, scale: f64, tolerance: f64) -> Result<(), MeshError> {
    let edges = edges(&surface.triangles);
    for (edge, sides) in edges.iter() {
        let forward = sides.iter().filter(|side| side.is_forward).count();
        if sides.len() > 1 && 2 * forward != sides.len() {
            let place = 0.5 * (surface.vertices[edge.0] + surface.vertices[edge.1]) / scale;
            return Err(MeshError::NonManifold { place: place.into(), count: sides.len() });
        }
    }
    let corners = |triangle: &[usize; 3]| triangle.map(|corner| surface.vertices[corner]);
    let total: f64 = surface.triangles.iter().map(|triangle| area_vector(&corners(triangle)).norm()).sum();
    let mut caps = Vec::new();
    for hole in holes(&edges) {
        let points: Vec<Vector> = hole.iter().map(|&corner| surface.vertices[corner]).collect();
        let length: f64 = (0..points.len()).map(|at| (points[at] - points[(at + 1) % points.len()]).norm()).sum();
        let area = area_vector(&points).norm();
        let is_gap = is_gap(&points, area, tolerance);
        let is_small = || {
            area <= SMALL_HOLE * total
                || (points.len() == 3 && continues(surface, &edges, &hole, &points, 1.0, tolerance))
        };
        // On an open sheet, a cap would lie on the sheet.
        let is_hole = || {
            is_planar(&points, tolerance) && is_small() && !continues(surface, &edges, &hole, &points, -1.0, tolerance)
        };
        if !(is_gap || is_hole()) || hole.len() > MOST_EDGES {
            return Err(MeshError::Open {
                place: (points[0] / scale).into(),
                length: length / scale,
                edges: hole.len(),
            });
        }
        caps.extend(triangulate(&points).into_iter().map(|triangle| triangle.map(|place| hole[place])));
        let place = (mean(&points) / scale).into();
        let edges = hole.len();
        surface.repairs.push(if is_gap {
            Repair::Sewn { place, edges }
        } else {
            Repair::Capped { place, edges, area }
        });
    }
    surface.triangles.extend(caps);
    Ok(())
}

/// Loops of vertices that close the surface, in the direction of the missing triangles.
pub fn holes(edges: &Edges) -> Vec<Vec<usize>> {
    let mut next: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for ((low, high), sides) in edges.iter() {
        if let [side] = sides[..] {
            let (from, to) = if side.is_forward { (high, low) } else { (low, high) };
            next.entry(from).or_default().push(to);
        }
    }
    let mut holes = Vec::new();
    for first in next.keys().copied().collect::<Vec<usize>>() {
        while next.get(&first).is_some_and(|ends| !ends.is_empty()) {
            let mut path = vec![first];
            while let Some(end) = path.last().and_then(|last| next.get_mut(last)).and_then(Vec::pop) {
                // A path that touches itself is several holes.
                match path.iter().position(|&vertex| vertex == end) {
                    Some(start) => {
                        holes.push(path.split_off(start));
                        path.push(end);
                    }
                    None => path.push(end),
                }
            }
        }
    }
    holes
}

/// Whether a loop runs to and fro along a line.
fn is_gap(points: &[Vector], area: f64, tolerance: f64) -> bool {
    let farthest = points.iter().map(|point| (point - points[0]).norm()).fold(0.0, f64::max);
    let end = points.iter().find(|point| (*point - points[0]).norm() == farthest).unwrap_or(&points[0]);
    let direction = (end - points[0]) / farthest;
    let is_on_line = |point: &Vector| (point - points[0]).cross(&direction).norm() <= 2.0 * tolerance;
    area <= 2.0 * tolerance * farthest && points.iter().all(is_on_line)
}

fn is_planar(points: &[Vector], tolerance: f64) -> bool {
    let normal = area_vector(points).normalize();
    let (low, high) = Plane::through(&points[0], normal).heights(points);
    high - low <= 2.0 * tolerance
}

/// Whether a hole lies in the plane of a triangle at its rim that has the same side, or for a sign of minus one the other.
fn continues(surface: &Surface, edges: &Edges, hole: &[usize], points: &[Vector], sign: f64, tolerance: f64) -> bool {
    let normal = area_vector(points).normalize();
    let plane = Plane::through(&points[0], normal);
    (0..hole.len()).any(|at| {
        let edge = undirected((hole[at], hole[(at + 1) % hole.len()]));
        edges.at(edge).iter().any(|side| {
            let corners = surface.triangles[side.triangle].map(|corner| surface.vertices[corner]);
            let area = area_vector(&corners);
            let (low, high) = plane.heights(&corners);
            low.abs().max(high.abs()) <= 2.0 * tolerance && sign * area.dot(&normal) > 0.99 * area.norm()
        })
    })
}
