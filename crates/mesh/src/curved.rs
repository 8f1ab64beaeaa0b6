//! Cylinders and cones of a mesh.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use crate::cone::Cone;
use crate::edges::{Edges, directed, undirected};
use crate::faces::{Faces, NONE};
use crate::geometry::{Vector, area_vector, mean};
use crate::strips::{LARGEST_ANGLE, Sides, Strip, rims};

/// A curved surface has at least this many facets in the mesh.
const LEAST_FACETS: usize = 4;
/// Angles (rad) closer than this are equal.
const SAME_ANGLE: f64 = 1e-4;
/// A plane that leaves a curved surface at a smaller angle (rad) is its tangent plane.
const TANGENT: f64 = 0.02;

/// A facet that is wider than the others by more than this is a flat: that of a D-shaft has its corners on the circle, too.
const WIDER: f64 = 2.5;
/// The strips of an arc are longer than wide by this.
const SLIM: f64 = 1.5;

/// A curved surface of a mesh with its faces.
#[derive(Debug, Clone)]
pub struct Curved {
    pub cone: Cone,
    pub is_convex: bool,
    /// Planar faces (indices) of the mesh.
    pub faces: Vec<usize>,
    /// Angle (rad) at which it begins, and its extent up to a full turn.
    pub start: f64,
    pub extent: f64,
    /// Whether planes go on tangentially where it begins and ends.
    pub is_tangent: [bool; 2],
    /// Heights along the axis between which it lies (m).
    pub heights: [f64; 2],
    /// Intervals of angle (rad) of the faces: start and extent.
    pub strips: Vec<(f64, f64)>,
    /// Largest distance of its vertices from the cone (m).
    pub deviation: f64,
}

impl Curved {
    pub fn is_full(&self) -> bool {
        self.extent >= TAU - SAME_ANGLE
    }

    /// Largest radius (m).
    pub fn radius(&self) -> f64 {
        self.heights.map(|height| self.cone.radius_at(height)).into_iter().fold(0.0, f64::max)
    }

    /// Whether both are convex or both concave around the same axis, within a tolerance (m).
    pub fn is_coaxial(&self, other: &Self, tolerance: f64) -> bool {
        let is_near = |height: &f64| {
            let point = other.cone.origin + other.cone.axis * *height;
            self.cone.coordinates(&point).2 <= tolerance
        };
        self.is_convex == other.is_convex && other.heights.iter().all(is_near)
    }

    /// Angle of the widest facet of the mesh (rad).
    pub fn widest(&self) -> f64 {
        self.strips.iter().map(|strip| strip.1).fold(0.0, f64::max)
    }
}

/// A mesh to look for curved surfaces in.
pub struct Mesh<'a> {
    pub vertices: &'a [Vector],
    pub triangles: &'a [[usize; 3]],
    pub edges: &'a Edges,
    pub faces: &'a Faces,
    /// Distance (m) within which vertices lie on their surface.
    pub tolerance: f64,
}

/// All cylinders and cones, full ones first.
pub fn recognise(mesh: &Mesh) -> Vec<Curved> {
    let sides = Sides::of(mesh.faces, mesh.triangles, mesh.edges);
    let mut chains = sides.chains(mesh.faces, LEAST_FACETS);
    chains.sort_by_key(|chain| (!chain.is_closed, std::cmp::Reverse(chain.strips.len())));
    let mut is_taken = vec![false; mesh.faces.faces.len()];
    let mut curved = Vec::new();
    for chain in chains {
        let free = chain.strips.split(|strip| is_taken[strip.face]).map(<[Strip]>::to_vec).collect::<Vec<_>>();
        let is_whole = chain.is_closed && free.len() == 1;
        for run in free {
            for strips in runs(&run, is_whole, mesh) {
                if strips.iter().any(|strip| is_taken[strip.face]) {
                    continue;
                }
                if let Some(surface) = surface_of_strips(&strips, &mut is_taken, mesh) {
                    curved.push(surface);
                }
            }
        }
    }
    for region in smooth_regions(&is_taken, mesh) {
        if let Some((cone, deviation)) = fit_region(&region, mesh) {
            curved.extend(surface(region, cone, deviation, &mut is_taken, mesh));
        }
    }
    curved.sort_by_key(|surface| !surface.is_full());
    curved
}

/// Faces that no surface has, joined where they meet smoothly.
fn smooth_regions(is_taken: &[bool], mesh: &Mesh) -> Vec<Vec<usize>> {
    let mut is_known = is_taken.to_vec();
    let mut regions = Vec::new();
    for first in 0..is_known.len() {
        if std::mem::replace(&mut is_known[first], true) {
            continue;
        }
        let mut region = vec![first];
        let mut next = 0;
        while let Some(&face) = region.get(next) {
            next += 1;
            for other in neighbors(face, mesh) {
                let cosine = mesh.faces.faces[face].plane.normal.dot(&mesh.faces.faces[other].plane.normal);
                if cosine > LARGEST_ANGLE.cos() && !std::mem::replace(&mut is_known[other], true) {
                    region.push(other);
                }
            }
        }
        if region.len() >= LEAST_FACETS {
            regions.push(region);
        }
    }
    regions
}

fn fit_region(region: &[usize], mesh: &Mesh) -> Option<(Cone, f64)> {
    let triangles = region.iter().flat_map(|&face| &mesh.faces.faces[face].triangles);
    let corners = |triangle: usize| mesh.triangles[triangle].map(|corner| mesh.vertices[corner]);
    let area = |face: &usize| {
        let triangles = mesh.faces.faces[*face].triangles.iter();
        let area: f64 = triangles.map(|&triangle| area_vector(&corners(triangle)).norm()).sum();
        mesh.faces.faces[*face].plane.normal * area
    };
    let vertices: BTreeSet<usize> = triangles.flat_map(|&triangle| mesh.triangles[triangle]).collect();
    let points: Vec<Vector> = vertices.into_iter().map(|vertex| mesh.vertices[vertex]).collect();
    Cone::near(&points, &region.iter().map(area).collect::<Vec<_>>(), mesh.tolerance)
}

/// Faces across the edges of a face, some several times.
fn neighbors<'a>(face: usize, mesh: &'a Mesh) -> impl Iterator<Item = usize> + 'a {
    let triangles = mesh.faces.faces[face].triangles.iter();
    let edges = triangles.flat_map(|&triangle| directed(mesh.triangles[triangle]));
    let sides = edges.flat_map(|edge| mesh.edges.at(undirected(edge)));
    sides.map(|side| mesh.faces.of_triangle[side.triangle]).filter(move |&other| other != NONE && other != face)
}

fn fit(strips: &[Strip], mesh: &Mesh) -> Option<(Cone, f64)> {
    let [near, far] = rims(strips, mesh.vertices);
    let width = |rim: &[Vector]| rim.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect::<Vec<_>>();
    let mut widths: Vec<f64> = width(&near).iter().zip(width(&far)).map(|(one, other)| one.max(other)).collect();
    widths.sort_by(f64::total_cmp);
    if *widths.last()? > WIDER * widths[widths.len() / 2] {
        return None;
    }
    Cone::through(&[&near, &far], mesh.tolerance)
}

/// The longest parts of a chain that lie on a cone each.
fn runs(strips: &[Strip], is_closed: bool, mesh: &Mesh) -> Vec<Vec<Strip>> {
    if strips.len() >= LEAST_FACETS && fit(strips, mesh).is_some() {
        return vec![strips.to_vec()];
    }
    let mut strips = strips.to_vec();
    let fits = |strips: &[Strip], start: usize, end: usize| fit(&strips[start..end], mesh).is_some();
    if is_closed {
        // Begin where a surface begins.
        let doubled = [&strips[..], &strips[..LEAST_FACETS.min(strips.len())]].concat();
        let begins = |start: &usize| !fits(&doubled, *start - 1, *start - 1 + LEAST_FACETS);
        if let Some(start) = (1..strips.len().saturating_sub(1)).find(begins) {
            strips.rotate_left(start);
        }
    }
    let mut runs = Vec::new();
    let mut start = 0;
    while start + LEAST_FACETS <= strips.len() {
        let mut end = start + LEAST_FACETS;
        if !fits(&strips, start, end) {
            start += 1;
            continue;
        }
        while end < strips.len() && fits(&strips, start, end + 1) {
            end += 1;
        }
        runs.push(strips[start..end].to_vec());
        start = end;
    }
    runs
}

/// The surface of a run of strips.
fn surface_of_strips(strips: &[Strip], is_taken: &mut [bool], mesh: &Mesh) -> Option<Curved> {
    let (cone, deviation) = fit(strips, mesh)?;
    let faces: Vec<usize> = strips.iter().map(|strip| strip.face).collect();
    let extents: Vec<(f64, f64)> = faces.iter().map(|&face| extent(face, &cone, mesh)).collect();
    // The small facets of a sphere lie on cones too, but these are no strips.
    let [near, far] = rims(strips, mesh.vertices);
    let width = |rim: &[Vector]| rim.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(0.0, f64::max);
    let length = near.iter().zip(&far).map(|(from, to)| (to - from).norm()).fold(f64::INFINITY, f64::min);
    if union(&extents).1 < TAU - SAME_ANGLE && length < SLIM * width(&near).max(width(&far)) {
        return None;
    }
    surface(faces, cone, deviation, is_taken, mesh)
}

/// The surface of faces that lie on a cone, with the smooth neighbours that do.
fn surface(mut faces: Vec<usize>, cone: Cone, deviation: f64, is_taken: &mut [bool], mesh: &Mesh) -> Option<Curved> {
    let outward = |&face: &usize| {
        mesh.faces.faces[face].plane.normal.dot(&cone.normal(cone.coordinates(&face_middle(face, mesh)).0))
    };
    let is_convex = faces.first().map(outward)? > 0.0;
    let sign = if is_convex { 1.0 } else { -1.0 };
    if faces.iter().any(|face| sign * outward(face) < LARGEST_ANGLE.cos()) {
        return None;
    }
    // The facets of a prism or a pyramid.
    if faces.iter().any(|&face| extent(face, &cone, mesh).1 > LARGEST_ANGLE) {
        return None;
    }
    faces.iter().for_each(|&face| is_taken[face] = true);
    adopt(&mut faces, is_taken, &cone, is_convex, deviation, mesh);
    let strips: Vec<(f64, f64)> = faces.iter().map(|&face| extent(face, &cone, mesh)).collect();
    let (start, extent) = union(&strips);
    let heights = face_points(&faces, mesh)
        .map(|point| cone.coordinates(&point).1)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| [low.min(height), high.max(height)]);
    let mut curved =
        Curved { cone, is_convex, faces, start, extent, is_tangent: [false; 2], heights, strips, deviation };
    curved.is_tangent = tangents(&curved, mesh);
    Some(curved)
}

fn face_points<'a>(faces: &'a [usize], mesh: &'a Mesh) -> impl Iterator<Item = Vector> + 'a {
    let triangles = faces.iter().flat_map(|&face| &mesh.faces.faces[face].triangles);
    triangles.flat_map(|&triangle| mesh.triangles[triangle].map(|corner| mesh.vertices[corner]))
}

fn face_middle(face: usize, mesh: &Mesh) -> Vector {
    let points: Vec<Vector> = face_points(&[face], mesh).collect();
    mean(&points)
}

/// Takes the neighbours that lie on the cone.
fn adopt(faces: &mut Vec<usize>, is_taken: &mut [bool], cone: &Cone, is_convex: bool, deviation: f64, mesh: &Mesh) {
    let allowed = deviation + mesh.tolerance;
    let sign = if is_convex { 1.0 } else { -1.0 };
    let widest = faces.iter().map(|&face| extent(face, cone, mesh).1).fold(0.0, f64::max);
    let widest = (WIDER * widest).min(LARGEST_ANGLE);
    let belongs = |face: usize| {
        let normal = sign * mesh.faces.faces[face].plane.normal;
        let angle = cone.coordinates(&face_middle(face, mesh)).0;
        normal.dot(&cone.normal(angle)) > LARGEST_ANGLE.cos()
            && extent(face, cone, mesh).1 <= widest
            && face_points(&[face], mesh).all(|point| cone.deviation(&point) <= allowed)
    };
    let mut next = 0;
    while let Some(&face) = faces.get(next) {
        next += 1;
        for other in neighbors(face, mesh) {
            if !is_taken[other] && belongs(other) {
                is_taken[other] = true;
                faces.push(other);
            }
        }
    }
}

/// The angles over which a face extends (rad): start and extent. Vertices on the axis have none.
fn extent(face: usize, cone: &Cone, mesh: &Mesh) -> (f64, f64) {
    let middle = cone.coordinates(&face_middle(face, mesh)).0;
    let points: Vec<Vector> = face_points(&[face], mesh).collect();
    let radius = |point: &Vector| cone.coordinates(point).2;
    let largest = points.iter().map(radius).fold(0.0, f64::max);
    let points = points.iter().filter(|point| radius(point) > 1e-3 * largest);
    let turns = points.map(|point| turn(cone.coordinates(point).0 - middle));
    let (low, high) = turns.fold((0.0_f64, 0.0_f64), |(low, high), angle| (low.min(angle), high.max(angle)));
    (middle + low, high - low)
}

/// An angle between minus and plus half a turn.
pub fn turn(angle: f64) -> f64 {
    angle - TAU * ((angle + PI) / TAU).floor()
}

/// Start and extent of a union of intervals of angles: the complement of the largest gap.
fn union(intervals: &[(f64, f64)]) -> (f64, f64) {
    let Some(&(origin, _)) = intervals.first() else { return (0.0, 0.0) };
    let mut sorted: Vec<(f64, f64)> =
        intervals.iter().map(|(start, extent)| ((start - origin).rem_euclid(TAU), *extent)).collect();
    sorted.sort_by(|one, other| one.0.total_cmp(&other.0));
    // Rounding may turn the first start into almost a full turn, which changes nothing around the circle.
    let mut reached = sorted.iter().map(|(start, extent)| start + extent - TAU).fold(f64::NEG_INFINITY, f64::max);
    let mut widest = (0.0, 0.0);
    for (start, extent) in sorted {
        if start - reached > widest.1 {
            widest = (start, start - reached);
        }
        reached = reached.max(start + extent);
    }
    if widest.1 <= SAME_ANGLE { (origin, TAU) } else { (turn(origin + widest.0), TAU - widest.1) }
}

/// Whether planes go on tangentially at the two ends of an arc.
fn tangents(curved: &Curved, mesh: &Mesh) -> [bool; 2] {
    let ends = [curved.start, curved.start + curved.extent];
    let sign = if curved.is_convex { 1.0 } else { -1.0 };
    let mut is_tangent = [false; 2];
    let own: BTreeSet<usize> = curved.faces.iter().copied().collect();
    for &triangle in curved.faces.iter().flat_map(|&face| &mesh.faces.faces[face].triangles) {
        for edge in directed(mesh.triangles[triangle]) {
            let points = [edge.0, edge.1].map(|vertex| mesh.vertices[vertex]);
            for other in mesh.edges.at(undirected(edge)).iter().map(|side| mesh.faces.of_triangle[side.triangle]) {
                if other == NONE || own.contains(&other) {
                    continue;
                }
                let normal = sign * mesh.faces.faces[other].plane.normal;
                for (end, angle) in ends.iter().enumerate() {
                    let is_here = |point: &Vector| turn(curved.cone.coordinates(point).0 - angle).abs() < SAME_ANGLE;
                    is_tangent[end] |=
                        points.iter().all(is_here) && normal.dot(&curved.cone.normal(*angle)) > TANGENT.cos();
                }
            }
        }
    }
    is_tangent
}
