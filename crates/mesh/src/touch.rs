//! Convex pieces that are exact where something passes, and large elsewhere.
//!
//! The part is cut only where the hull of what is in a cell comes too close to a place where the other part passes. What
//! the other part cannot enter is filled.

mod trim;

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use rustc_hash::FxHashSet;
use workers::Workers;

use crate::body::Body;
use crate::bvh::BoxTree;
use crate::cell::{Bound, Cell};
use crate::edges::edges;
use crate::faces::NONE;
use crate::geometry::{Plane, Vector, area_vector, boxes_meet, clip, mean};
use crate::hull::Hull;
use crate::joining::Joining;
use crate::nearest::squared_distance;
use crate::passing::Place;
use crate::solid::Solid;
use crate::strips::LARGEST_ANGLE;

/// More cells take too long.
const MOST_CELLS: usize = 6000;
/// Places by which planes are chosen, and planes that are compared.
const SAMPLE: usize = 200;
const CANDIDATES: usize = 12;
/// Share of what is allowed that is spent on cells, and on cells that are joined; the rest is for fewer halfspaces.
const CUTTING: f64 = 0.5;
const JOINING: f64 = 0.75;
/// Share of it by which planes of curved surfaces are moved into the open.
const MOVED: f64 = 0.4;
/// Share of it by which faces may be away from the plane of a larger one that stands for them, and the least cosine between
/// their normals.
const BAND: f64 = 0.1;
const ALIKE: f64 = 0.98;

/// Places that one thread looks at together.
const CHUNK: usize = 1000;
/// Corners of each of two hulls between which points are looked at before both are joined.
const BETWEEN: usize = 3;

/// The surface of a part as the cutting sees it.
pub struct Touched<'a> {
    body: &'a Body,
    places: &'a [Place],
    /// The boxes that joined hulls keep out of, each around a place.
    around_places: BoxTree,
    planes: Vec<Facing>,
    /// The plane of each triangle, if it has one.
    plane_of: Vec<Option<usize>>,
    /// Triangles that have a corner with each triangle in common.
    neighbors: Vec<Vec<usize>>,
    pub workers: Workers,
    /// Distance below which points are the same (m).
    pub tolerance: f64,
}

/// A plane of the surface, with all faces that lie in it within a share of what is allowed there.
struct Facing {
    plane: Plane,
    /// How far its faces are in front of it at most (m).
    ahead: f64,
    /// Whether some of them is part of a curved surface.
    is_curved: bool,
}

struct Node {
    cell: Cell,
    fragments: Vec<(usize, Vec<Vector>)>,
    /// Places that the hull may come close to.
    places: Vec<usize>,
}

impl<'a> Touched<'a> {
    pub fn new(solid: &Solid, body: &'a Body, places: &'a [Place]) -> Self {
        let around = |place: &Place| {
            let within = place.within(JOINING).max(0.0);
            [-1.0, 1.0].map(|side| place.point.add_scalar(side * within))
        };
        let around_places = BoxTree::new(&places.iter().map(around).collect::<Vec<_>>());
        let (planes, plane_of_face) = facing(solid, places);
        let plane_of = solid.faces.of_triangle.iter().map(|&face| plane_of_face.get(face).copied()).collect();
        let mut at_corner: Vec<Vec<usize>> = vec![Vec::new(); solid.vertices.len()];
        for (triangle, corners) in solid.triangles.iter().enumerate() {
            corners.iter().for_each(|&corner| at_corner[corner].push(triangle));
        }
        let around = |corners: &[usize; 3]| corners.iter().flat_map(|&corner| &at_corner[corner]).copied().collect();
        let neighbors = solid.triangles.iter().map(around).collect();
        let (workers, tolerance) = (Workers::of_all_processors(), solid.tolerance);
        Self { body, places, around_places, planes, plane_of, neighbors, workers, tolerance }
    }

    /// Convex hulls that contain the part and keep their distance from all places; `None` when that takes too long.
    pub fn pieces(&self, root: Cell) -> Option<Vec<Hull>> {
        let fragments: Vec<(usize, Vec<Vector>)> =
            self.body.triangles().iter().map(|triangle| triangle.to_vec()).enumerate().collect();
        let mut waiting = vec![Node { cell: root, fragments, places: (0..self.places.len()).collect() }];
        let mut hulls = Vec::new();
        let mut count = 0;
        let mut next_id = 6;
        while let Some(node) = waiting.pop() {
            count += 1;
            if count > MOST_CELLS {
                return None;
            }
            let Some(hull) = self.hull(&node) else { continue };
            let close = self.close(&hull, &node.places);
            if close.is_empty() {
                hulls.push(hull);
                continue;
            }
            let bound = self.choose(&node, &hull, &close, next_id);
            next_id += 1;
            let Some(bound) = bound else {
                hulls.push(hull);
                continue;
            };
            for side in [bound, bound.flipped()] {
                let Some(cell) = node.cell.cut(&side, self.tolerance) else { continue };
                let cut = |(triangle, polygon): &(usize, Vec<Vector>)| {
                    // Surface in the plane belongs to the side with its material.
                    let is_on = polygon.iter().all(|corner| side.plane.height(corner).abs() <= self.tolerance);
                    if is_on && area_vector(&self.body.triangles()[*triangle]).dot(&side.plane.normal) < 0.0 {
                        return None;
                    }
                    let polygon = clip(polygon, &side.plane, 0.1 * self.tolerance);
                    (polygon.len() >= 3).then_some((*triangle, polygon))
                };
                let fragments = node.fragments.iter().filter_map(cut).collect();
                waiting.push(Node { cell, fragments, places: close.clone() });
            }
        }
        Some(hulls)
    }

    /// The hull of what is in a cell.
    fn hull(&self, node: &Node) -> Option<Hull> {
        let mut points: Vec<Vector> = node.fragments.iter().flat_map(|(_, polygon)| polygon).copied().collect();
        if points.is_empty() {
            if !self.body.contains(&node.cell.center()) {
                return None;
            }
            points.extend(node.cell.corners());
        } else {
            let mut known: Vec<Vector> = Vec::new();
            for corner in node.cell.corners() {
                if known.iter().all(|other| (other - corner).norm() > self.tolerance) {
                    known.push(*corner);
                    if self.body.contains(corner) {
                        points.push(*corner);
                    }
                }
            }
        }
        let hull = Hull::of(&points, self.tolerance)?;
        let thickness = |plane: &Plane| -plane.heights(&hull.points).0;
        let is_thick = hull.planes.iter().all(|plane| thickness(plane) > 2.0 * self.tolerance);
        is_thick.then_some(hull)
    }

    /// Places that the hull of a cell comes too close to.
    fn close(&self, hull: &Hull, among: &[usize]) -> Vec<usize> {
        let is_close = |place: &Place| !hull.is_beyond(&place.point, place.within(CUTTING));
        let close =
            |among: &[usize]| among.iter().copied().filter(|&place| is_close(&self.places[place])).collect::<Vec<_>>();
        self.workers.map(among.chunks(CHUNK), close).concat()
    }

    /// The plane that separates most places from the part and cuts little of it.
    fn choose(&self, node: &Node, hull: &Hull, close: &[usize], id: usize) -> Option<Bound> {
        let here: FxHashSet<usize> = node.fragments.iter().map(|(triangle, _)| *triangle).collect();
        let stride = close.len().div_ceil(SAMPLE).max(1);
        let mut votes: BTreeMap<usize, (f64, f64)> = BTreeMap::new();
        let mut total_votes = 0.0;
        for &place in close.iter().step_by(stride) {
            let place = &self.places[place];
            let separating = self.separating(place, node, &here);
            if separating.is_empty() {
                continue;
            }
            // Close places matter most.
            let weight = 1.0 / (place.distance + 10.0 * self.tolerance);
            total_votes += weight;
            let allowed = place.distance - place.enough;
            for plane in separating {
                let vote = votes.entry(plane).or_insert((0.0, f64::INFINITY));
                *vote = (vote.0 + weight, vote.1.min(allowed));
            }
        }
        let mut votes: Vec<(usize, (f64, f64))> = votes.into_iter().collect();
        votes.sort_by(|one, other| other.1.0.total_cmp(&one.1.0).then(one.0.cmp(&other.0)));
        votes.truncate(CANDIDATES);
        let stride = node.fragments.len().div_ceil(400).max(1);
        let sample: Vec<(&Vec<Vector>, f64)> =
            node.fragments.iter().step_by(stride).map(|(_, polygon)| (polygon, area_vector(polygon).norm())).collect();
        let total: f64 = sample.iter().map(|(_, area)| area).sum();
        let cost = |plane: &Plane, own: f64| {
            let (mut split, mut balance) = (0.0, 0.0_f64);
            for (polygon, area) in &sample {
                let (low, high) = plane.heights(*polygon);
                if low < -self.tolerance && high > self.tolerance {
                    split += area;
                } else if high > self.tolerance || low < -self.tolerance {
                    balance += if high > -low { *area } else { -area };
                }
            }
            3.0 * split / total - own / total_votes + 0.2 * balance.abs() / total
        };
        let separates = |plane: &Plane| {
            let (low, high) = plane.heights(node.cell.corners());
            low < -2.0 * self.tolerance && high > 2.0 * self.tolerance
        };
        let best = votes
            .iter()
            .map(|(index, (weight, allowed))| {
                let Facing { plane, ahead, is_curved } = &self.planes[*index];
                (plane.moved(ahead + if *is_curved { MOVED * allowed } else { 0.0 }), *weight)
            })
            .filter(|(plane, _)| separates(plane))
            .map(|(plane, weight)| (plane, cost(&plane, weight)))
            .min_by(|one, other| one.1.total_cmp(&other.1));
        let plane = best.map(|(plane, _)| plane).or_else(|| {
            // Nothing of the surface separates: the cell is halved.
            let [low, high] = hull.bounds;
            let axis = (high - low).imax();
            let plane = Plane::through(&(0.5 * (low + high)), Vector::ith(axis, 1.0));
            ((high - low)[axis] > 20.0 * self.tolerance).then_some(plane)
        });
        plane.map(|plane| Bound { id, is_flipped: false, plane })
    }

    /// Planes of what of the surface is nearest to a place, in front of which that is.
    fn separating(&self, place: &Place, node: &Node, here: &FxHashSet<usize>) -> BTreeSet<usize> {
        let corners = |triangle: usize| &self.body.triangles()[triangle];
        let most = (place.distance + self.tolerance).powi(2);
        // At an edge or a corner, several triangles are nearest.
        let nearest = self.neighbors[place.nearest].iter().copied();
        let mut nearest: Vec<usize> =
            nearest.filter(|&other| squared_distance(&place.point, corners(other), most) <= most).collect();
        nearest.retain(|triangle| here.contains(triangle));
        if nearest.is_empty() {
            let apart = |(_, polygon): &&(usize, Vec<Vector>)| {
                let apart = polygon.iter().map(|corner| (corner - place.point).norm_squared());
                apart.fold(f64::INFINITY, f64::min)
            };
            let fragment = node.fragments.iter().min_by(|one, other| apart(one).total_cmp(&apart(other)));
            nearest.extend(fragment.map(|(triangle, _)| *triangle));
        }
        let planes = nearest.into_iter().filter_map(|triangle| self.plane_of[triangle]);
        planes.filter(|&plane| self.planes[plane].plane.height(&place.point) > 0.0).collect()
    }

    /// Joins hulls as long as the hulls of both keep their distance.
    pub fn join(&self, hulls: Vec<Hull>) -> Vec<Hull> {
        Joining::of(self, hulls).join_all()
    }

    /// The hull of two hulls, if it keeps its distance from the places that are known; else a place that is in the way and not
    /// recent, if one was looked for. Recent places are asked first.
    pub fn joined(&self, one: &Hull, other: &Hull, recent: &VecDeque<usize>) -> Result<Hull, Option<usize>> {
        if self.is_close_between(one, other) {
            return Err(None);
        }
        let points: Vec<Vector> = one.points.iter().chain(&other.points).copied().collect();
        let Some(joined) = Hull::of(&points, self.tolerance) else { return Err(None) };
        let is_close = |place: &usize| {
            let place = &self.places[*place];
            !joined.is_beyond(&place.point, place.within(JOINING))
        };
        if recent.iter().any(is_close) {
            return Err(None);
        }
        let is_near = |box_: &[Vector; 2]| boxes_meet(box_, &joined.bounds, 0.0);
        let close = self.around_places.find_map(is_near, |place| is_close(&place).then_some(place));
        close.map_or(Ok(joined), |place| Err(Some(place)))
    }

    /// Whether some points between corners of two hulls, which the hull of both contains, are too close to a place.
    fn is_close_between(&self, one: &Hull, other: &Hull) -> bool {
        let some = |hull: &Hull| -> Vec<Vector> {
            let corners = hull.points.iter().step_by(hull.points.len().div_ceil(BETWEEN)).copied();
            corners.chain([mean(&hull.points)]).collect()
        };
        let others = some(other);
        some(one).iter().flat_map(|own| others.iter().map(move |other| 0.5 * (own + other))).any(|point| {
            let is_near =
                |[low, high]: &[Vector; 2]| (0..3).all(|axis| (low[axis]..=high[axis]).contains(&point[axis]));
            let is_close = |place: usize| {
                let place = &self.places[place];
                (place.point - point).norm() < place.within(JOINING)
            };
            self.around_places.find_map(is_near, |place| is_close(place).then_some(())).is_some()
        })
    }
}

/// The planes of the faces of a solid, and the plane of each face. A face lies in the plane of a larger one when it is no
/// farther from it than a share of what is allowed at all places to which it is nearest.
fn facing(solid: &Solid, places: &[Place]) -> (Vec<Facing>, Vec<usize>) {
    let faces = &solid.faces.faces;
    let mut bands = vec![f64::INFINITY; faces.len()];
    for place in places {
        if let Some(band) = bands.get_mut(solid.faces.of_triangle[place.nearest]) {
            *band = band.min(BAND * (place.distance - place.enough));
        }
    }
    let is_curved = curved_faces(solid);
    let mut planes: Vec<Facing> = Vec::new();
    let mut plane_of_face = Vec::with_capacity(faces.len());
    for (face, (band, is_curved)) in faces.iter().zip(bands.into_iter().zip(is_curved)) {
        let corners = face.triangles.iter().flat_map(|&triangle| solid.corners(triangle)).collect::<Vec<_>>();
        let known = |known: &Facing| {
            known.plane.normal.dot(&face.plane.normal) > ALIKE
                && known.plane.height(&corners[0]).abs() <= band
                && corners.iter().all(|corner| known.plane.height(corner).abs() <= band)
        };
        let known = if band.is_finite() { planes.iter().position(known) } else { None };
        let index = known.unwrap_or(planes.len());
        match known {
            Some(known) => {
                let known = &mut planes[known];
                known.ahead = known.ahead.max(known.plane.heights(&corners).1);
                known.is_curved |= is_curved;
            }
            None => planes.push(Facing { plane: face.plane, ahead: 0.0, is_curved }),
        }
        plane_of_face.push(index);
    }
    (planes, plane_of_face)
}

/// Whether faces go on smoothly in others.
fn curved_faces(solid: &Solid) -> Vec<bool> {
    let faces = &solid.faces.faces;
    let mut is_curved = vec![false; faces.len()];
    for (_, sides) in edges(&solid.triangles).iter() {
        for pair in sides.windows(2) {
            let [one, other] = [pair[0], pair[1]].map(|side| solid.faces.of_triangle[side.triangle]);
            if one == NONE || other == NONE || one == other {
                continue;
            }
            if faces[one].plane.normal.dot(&faces[other].plane.normal) > LARGEST_ANGLE.cos() {
                (is_curved[one], is_curved[other]) = (true, true);
            }
        }
    }
    is_curved
}
