//! Where another part passes a solid, and by how much pieces may come closer to it there than the solid does.

use std::ops::Range;

use nalgebra::{Isometry3, Point3};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::body::Body;
use crate::bvh::divide;
use crate::geometry::{Vector, area_vector, bounds, mean};

/// Places where another part passes are no farther apart than this share of their distance from the solid.
const SPACING: f64 = 0.6;
/// Beyond reach, shapes are as close as this share of the distance.
const FAR_SHARE: f64 = 0.25;

/// Motions of another part past a solid.
#[derive(Debug, Clone, Copy)]
pub struct Passage<'a> {
    /// Triangles of the other part (m), in its own frame.
    pub triangles: &'a [[[f64; 3]; 3]],
    /// Its poses in the frame of the solid, without errors.
    pub poses: &'a [Isometry3<f64>],
}

/// How close pieces must be to a surface that is touched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Share of the local gap.
    pub share: f64,
    /// No more than this where the other part can touch the surface (m).
    pub most: f64,
    /// No less than this (m).
    pub least: f64,
    /// How far the other part may get away from its poses (m).
    pub reach: f64,
    /// Smallest distance between places (m).
    pub spacing: f64,
}

impl Budget {
    /// How much closer pieces may be to a place at a distance (m) from the solid.
    pub fn allowed(&self, distance: f64) -> f64 {
        let near = (self.share * distance).min(self.most);
        (near + FAR_SHARE * (distance - self.reach).max(0.0)).max(self.least)
    }
}

/// A place where a point of the other part passes.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    pub point: Vector,
    /// Its distance from the solid (m).
    pub distance: f64,
    /// Distance from pieces that is enough (m).
    pub enough: f64,
    /// The nearest triangle of the solid.
    pub nearest: usize,
}

impl Place {
    /// Distance from pieces that is enough when these may take a share of what is allowed (m).
    pub fn within(&self, share: f64) -> f64 {
        self.distance - share * (self.distance - self.enough)
    }
}

/// Balls around triangles of the other part, which are divided when somebody comes near them.
struct Balls {
    /// The first is around all.
    balls: Vec<Ball>,
    /// Smallest distance between points (m).
    spacing: f64,
    /// Cells of that size that have a point.
    taken: FxHashSet<[i32; 3]>,
}

struct Ball {
    center: Vector,
    /// Points have none (m).
    radius: f64,
    /// A point of the surface in the ball.
    point: Vector,
    content: Content,
}

enum Content {
    /// Triangles that were not divided yet.
    Triangles(Vec<[Vector; 3]>),
    /// Balls (indices) around what they were divided into.
    Balls(Range<usize>),
}

impl Balls {
    fn new(triangles: &[[[f64; 3]; 3]], spacing: f64) -> Self {
        let triangles: Vec<[Vector; 3]> = triangles.iter().map(|triangle| triangle.map(Vector::from)).collect();
        let balls = if triangles.is_empty() { Vec::new() } else { vec![Ball::around(triangles)] };
        Self { balls, spacing, taken: FxHashSet::default() }
    }

    /// The balls in a ball.
    fn within(&mut self, ball: usize) -> Range<usize> {
        let first = self.balls.len();
        match &mut self.balls[ball].content {
            Content::Balls(balls) => return balls.clone(),
            Content::Triangles(triangles) => {
                let mut triangles = std::mem::take(triangles);
                if let [triangle] = triangles[..] {
                    self.add_halves(&triangle);
                } else {
                    let half = divide(&mut triangles);
                    let other = triangles.split_off(half);
                    self.balls.extend([triangles, other].map(Ball::around));
                }
            }
        }
        let within = first..self.balls.len();
        self.balls[ball].content = Content::Balls(within.clone());
        within
    }

    /// Adds the corners of a triangle and its halves.
    fn add_halves(&mut self, triangle: &[Vector; 3]) {
        let halves = halves(triangle);
        triangle.iter().chain([&halves[0][1]]).for_each(|corner| self.add_point(corner));
        if area_vector(triangle).norm() > 0.0 {
            for half in halves {
                let ball = Ball::around(vec![half]);
                if ball.radius > self.spacing { self.balls.push(ball) } else { self.add_point(&ball.point) }
            }
        }
    }

    /// Adds a point unless there is one in its cell.
    fn add_point(&mut self, point: &Vector) {
        if self.taken.insert(cell(point, self.spacing)) {
            self.balls.push(Ball { center: *point, radius: 0.0, point: *point, content: Content::Balls(0..0) });
        }
    }
}

impl Ball {
    fn around(triangles: Vec<[Vector; 3]>) -> Self {
        let [low, high] = bounds(triangles.iter().flatten());
        let center = if let [triangle] = &triangles[..] { mean(triangle) } else { 0.5 * (low + high) };
        let radius = triangles.iter().flatten().map(|corner| (corner - center).norm()).fold(0.0, f64::max);
        Self { center, radius, point: mean(&triangles[0]), content: Content::Triangles(triangles) }
    }
}

/// Both halves of a triangle, divided across its longest side; the second corner of the first is the middle of that.
fn halves(&[a, b, c]: &[Vector; 3]) -> [[Vector; 3]; 2] {
    let [a, b, c] = match [(b - a).norm(), (c - b).norm(), (a - c).norm()] {
        [one, two, three] if one >= two && one >= three => [a, b, c],
        [_, two, three] if two >= three => [b, c, a],
        _ => [c, a, b],
    };
    let middle = 0.5 * (a + b);
    [[a, middle, c], [middle, b, c]]
}

/// A point whose distance from the solid is known.
struct Asked {
    point: Vector,
    /// m
    distance: f64,
    /// The nearest triangle.
    nearest: usize,
    /// Whether it is outside, if somebody wanted to know.
    is_outside: Option<bool>,
    /// Whether there is a place in its cell.
    is_taken: bool,
}

/// Finds places that represent all of some passages.
struct Finder<'a> {
    body: &'a Body,
    budget: Budget,
    /// Larger cells with a place: their edges in powers of two of the smallest spacing, and where they are.
    known: FxHashSet<(i32, [i32; 3])>,
    /// The first points that were asked for in cells as large as the smallest spacing.
    asked: FxHashMap<[i32; 3], Asked>,
    places: Vec<Place>,
}

/// The places where other parts pass a body: close together where they pass closely.
pub fn places(body: &Body, passages: &[Passage], budget: Budget) -> Vec<Place> {
    let (known, asked) = (FxHashSet::default(), FxHashMap::default());
    let mut finder = Finder { body, budget, known, asked, places: Vec::new() };
    for passage in passages {
        let mut balls = Balls::new(passage.triangles, budget.spacing);
        for pose in passage.poses {
            finder.pass(&mut balls, pose);
        }
    }
    finder.places
}

impl Finder<'_> {
    fn pass(&mut self, balls: &mut Balls, pose: &Isometry3<f64>) {
        let placed = |point: &Vector| pose.transform_point(&Point3::from(*point)).coords;
        // Each with a point nearby and the most that this may be away from the solid (m).
        let mut waiting: Vec<(usize, Vector, f64)> = Vec::new();
        waiting.extend((!balls.balls.is_empty()).then_some((0, Vector::zeros(), f64::INFINITY)));
        while let Some((index, known, most)) = waiting.pop() {
            let ball = &balls.balls[index];
            let center = placed(&ball.center);
            let most = most + (center - known).norm();
            if ball.radius == 0.0 {
                self.add(&center, most);
                continue;
            }
            let near = self.near(&center, most);
            let most = near.distance + (center - near.point).norm();
            if ball.radius <= SPACING * (near.distance - ball.radius) {
                let point = placed(&ball.point);
                self.add(&point, most + (point - center).norm());
            } else {
                waiting.extend(balls.within(index).map(|index| (index, center, most)));
            }
        }
    }

    /// What is known of a point in the same cell as this one, which is no farther from the solid than the most (m): its
    /// distance is that of this point within two spacings.
    fn near(&mut self, point: &Vector, most: f64) -> &mut Asked {
        let body = self.body;
        self.asked.entry(cell(point, self.budget.spacing)).or_insert_with(|| {
            let (nearest, distance) = body.distance_within(point, most);
            Asked { point: *point, distance, nearest, is_outside: None, is_taken: false }
        })
    }

    /// Adds a place, which is no farther from the solid than the most (m), unless there is one nearby.
    fn add(&mut self, point: &Vector, most: f64) {
        let (body, spacing) = (self.body, self.budget.spacing);
        let near = self.near(point, most);
        let level = (0.5 * SPACING * near.distance / spacing).max(1.0).log2().round() as i32;
        let is_taken = if level == 0 {
            std::mem::replace(&mut near.is_taken, true)
        } else {
            !self.known.insert((level, cell(point, spacing * 2f64.powi(level))))
        };
        if is_taken {
            return;
        }
        let near = self.near(point, most);
        let apart = (point - near.point).norm();
        let (nearest, distance) = if apart == 0.0 {
            (near.nearest, near.distance)
        } else {
            body.distance_within(point, near.distance + apart)
        };
        let is_outside = if apart < near.distance {
            // No surface is between both points.
            *near.is_outside.get_or_insert_with(|| body.is_beyond(point, nearest))
        } else {
            body.is_beyond(point, nearest)
        };
        if is_outside {
            let enough = distance - self.budget.allowed(distance);
            self.places.push(Place { point: *point, distance, enough, nearest });
        }
    }
}

/// The cube of an edge (m) in which a point lies.
fn cell(point: &Vector, edge: f64) -> [i32; 3] {
    std::array::from_fn(|axis| (point[axis] / edge).floor() as i32)
}
