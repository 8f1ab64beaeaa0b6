//! The pictures of a motion: convex polygons in the order of painting, lines upon them, and a bar of time.
//!
//! One scenario is solid; the others and the reference are outlines, which hide nothing.

use nalgebra::{Isometry3, Vector3};
use task::Pose;

use super::camera::{Camera, WIDTH, plane};
use super::order::{Pairs, Seen, painted, pairs};
use super::outline::{Point, hull, outline};
use super::solid::{Facet, Piece};
use crate::figures::{COLOURS, Colour};
use crate::model::{MotionData, PlanData};

/// Most pictures of a film, and the shortest time between two of them (s).
const MOST: f64 = 60.0;
const SHORTEST: f64 = 0.05;
/// How long the end is shown (s) before the motion begins again.
pub const REST: f64 = 1.0;
/// Steps between the darkest and the brightest tone: fewer tones compress better.
const TONES: f64 = 20.0;
/// Brightness of facets that get no light.
const SHADE: f64 = 0.6;
/// Colours of the environment, of the faces that the cut has made of it, and of the reference.
const ENVIRONMENT: Colour = [0xcb, 0xd1, 0xda];
const CUT: Colour = [0x98, 0xa1, 0xaf];
const REFERENCE: Colour = [0x10, 0x16, 0x1f];
/// Brightness of the faces that the cut has made of the body.
const CUT_TONE: f64 = 0.84;

/// A convex polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Its corners in pixels.
    pub corners: Vec<Point>,
    /// Its colour.
    pub colour: Colour,
}

/// What is painted at once.
#[derive(Debug)]
pub enum Item {
    /// A piece that does not move, by its index.
    Fixed(usize),
    /// A piece that does.
    Moving(Vec<Shape>),
}

/// Lines around something.
#[derive(Debug)]
pub struct Outline {
    /// Corners of each line, in pixels.
    pub lines: Vec<Vec<Point>>,
    /// Their colour.
    pub colour: Colour,
    /// Whether they are dashed.
    pub dashed: bool,
}

/// A picture.
#[derive(Debug)]
pub struct Picture {
    /// From behind to the front.
    pub items: Vec<Item>,
    /// Upon them.
    pub outlines: Vec<Outline>,
    /// Share of the motion that is done.
    pub share: f64,
}

/// A motion in pictures.
#[derive(Debug)]
pub struct Film {
    /// Width and height in pixels.
    pub size: [f64; 2],
    /// Shapes of the pieces that do not move.
    pub fixed: Vec<Vec<Shape>>,
    /// The pictures.
    pub pictures: Vec<Picture>,
    /// Time (s) from one to the next; the last one rests.
    pub interval: f64,
}

/// What moves: poses at the knots.
struct Motion<'a> {
    poses: &'a [f64],
    time_step: f64,
}

impl Motion<'_> {
    /// Where it is at a time (s), between knots as the robot interpolates.
    fn at(&self, time: f64) -> Isometry3<f64> {
        let (knots, _) = self.poses.as_chunks();
        let last = knots.len() - 1;
        let place = (time / self.time_step).clamp(0.0, last as f64);
        let index = (place as usize).min(last.saturating_sub(1));
        let [from, to] = [index, (index + 1).min(last)].map(|knot| Pose(knots[knot]).isometry());
        from.try_lerp_slerp(&to, place - index as f64, 1e-9).unwrap_or(from)
    }
}

/// Films a motion with one of its scenarios, or all.
pub fn film(plan: &PlanData, motion: &MotionData, scenario: Option<usize>) -> Film {
    let moving = |poses| Motion { poses, time_step: motion.time_step };
    let reference = moving(&motion.reference);
    let all = scenario.map_or(0..motion.scenarios.len(), |only| only..only + 1);
    let shown: Vec<(usize, Motion)> = all.map(|index| (index, moving(&motion.scenarios[index].poses))).collect();
    let end = motion.time_step * (motion.reference.len() / 7 - 1) as f64;
    // Hundredths of a second are the unit of GIF files.
    let interval = (100.0 * (end / MOST).max(SHORTEST) - 1e-6).ceil() / 100.0;
    let count = (end / interval - 1e-6).ceil() as usize;
    let times: Vec<f64> = (0..=count).map(|index| (index as f64 * interval).min(end)).collect();

    let goal = plan.goal.isometry();
    let travel = goal.translation.vector - reference.at(0.0).translation.vector;
    let cut = plane(travel, pushed(motion), middle(plan, &goal));
    let environment: Vec<Piece> =
        plan.environment.iter().filter_map(|part| Piece::cut(part, &Isometry3::identity(), cut)).collect();
    // The body is cut where it ends, and moves like that.
    let body: Vec<Piece> = plan.body.iter().filter_map(|part| Piece::cut(part, &goal, cut)).collect();
    let body: Vec<Piece> = body.iter().map(|piece| piece.moved(&goal.inverse())).collect();
    let motions = || shown.iter().map(|(_, motion)| motion).chain([&reference]);
    let poses: Vec<Isometry3<f64>> =
        times.iter().flat_map(|&time| motions().map(move |motion| motion.at(time))).collect();
    let camera = Camera::new(cut, &environment, &body, &poses);

    let stage = Stage::new(environment, body, camera);
    let picture = |&time: &f64| {
        let scenarios: Vec<_> =
            shown.iter().map(|(index, motion)| (COLOURS[index % COLOURS.len()], motion.at(time))).collect();
        stage.picture(&scenarios, &reference.at(time), if end > 0.0 { time / end } else { 1.0 })
    };
    Film {
        size: [WIDTH, stage.camera.height],
        pictures: times.iter().map(picture).collect(),
        fixed: stage.fixed.iter().map(|seen| stage.shapes(&seen.piece, ENVIRONMENT, CUT)).collect(),
        interval,
    }
}

/// How much the contact forces of a motion push along each axis (N, summed over steps).
fn pushed(motion: &MotionData) -> Vector3<f64> {
    let steps = motion.scenarios.iter().flat_map(|scenario| &scenario.contacts);
    let contacts = steps.flat_map(|step| step.as_chunks().0);
    contacts.map(|&[_, force, _, _, _, x, y, z]| force * Vector3::new(x, y, z).abs()).sum()
}

/// Middle of the box around the body at a pose (m).
fn middle(plan: &PlanData, pose: &Isometry3<f64>) -> Vector3<f64> {
    let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    for corner in plan.body.iter().flat_map(|part| part.vertices.chunks_exact(3)) {
        let corner = (pose * nalgebra::Point3::from_slice(corner)).coords;
        (low, high) = (low.inf(&corner), high.sup(&corner));
    }
    0.5 * (low + high)
}

/// Parts and camera.
struct Stage {
    fixed: Vec<Seen>,
    /// Which of the fixed pieces hide which.
    order: Pairs,
    /// Pieces of the body, in its frame.
    body: Vec<Piece>,
    camera: Camera,
}

impl Stage {
    fn new(environment: Vec<Piece>, body: Vec<Piece>, camera: Camera) -> Self {
        let fixed: Vec<Seen> = environment.into_iter().map(|piece| Seen::new(piece, &camera)).collect();
        let all: Vec<&Seen> = fixed.iter().collect();
        let among = (0..fixed.len()).flat_map(|one| (0..one).map(move |other| [one, other]));
        let order = pairs(&all, among, &camera);
        Self { fixed, order, body, camera }
    }

    /// Scenarios by their colours and poses, the first one solid.
    fn picture(&self, scenarios: &[(Colour, Isometry3<f64>)], reference: &Isometry3<f64>, share: f64) -> Picture {
        let mut items = Vec::new();
        if let Some((colour, pose)) = scenarios.first() {
            let moving: Vec<Seen> = self.body.iter().map(|piece| Seen::new(piece.moved(pose), &self.camera)).collect();
            let all: Vec<&Seen> = self.fixed.iter().chain(&moving).collect();
            let among = (self.fixed.len()..all.len()).flat_map(|one| (0..one).map(move |other| [one, other]));
            let order = painted(&all, &[&self.order, &pairs(&all, among, &self.camera)]);
            let faces = toned(*colour, CUT_TONE);
            items.extend(order.into_iter().map(|index| match index.checked_sub(self.fixed.len()) {
                None => Item::Fixed(index),
                Some(own) => Item::Moving(self.shapes(&moving[own].piece, *colour, faces)),
            }));
        }
        let around = |pose: &Isometry3<f64>, colour: Colour, dashed: bool| {
            let pixels = |piece: &Piece| piece.moved(pose).corners().map(|corner| self.camera.pixel(corner)).collect();
            let hulls: Vec<Vec<Point>> = self.body.iter().map(|piece| hull(pixels(piece))).collect();
            Outline { lines: outline(&hulls), colour, dashed }
        };
        let mut outlines: Vec<Outline> =
            scenarios.iter().skip(1).map(|(colour, pose)| around(pose, *colour, false)).collect();
        outlines.push(around(reference, REFERENCE, true));
        Picture { items, outlines, share }
    }

    /// The facets of a piece that face the viewer.
    fn shapes(&self, piece: &Piece, colour: Colour, cut: Colour) -> Vec<Shape> {
        let shape = |facet: &Facet| Shape {
            corners: facet.corners.iter().map(|corner| self.camera.pixel(corner)).collect(),
            colour: if facet.is_cut { cut } else { toned(colour, self.tone(facet)) },
        };
        piece.facets.iter().filter(|facet| facet.normal.dot(&self.camera.back) > 1e-6).map(shape).collect()
    }

    fn tone(&self, facet: &Facet) -> f64 {
        SHADE + (1.0 - SHADE) * (TONES * self.camera.light(&facet.normal)).round() / TONES
    }
}

/// A colour of a brightness.
fn toned(colour: Colour, brightness: f64) -> Colour {
    colour.map(|part| (f64::from(part) * brightness).round() as u8)
}
