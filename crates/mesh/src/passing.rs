//! Where another part passes a solid, and by how much pieces may come closer to it there than the solid does.

use std::collections::{HashMap, HashSet};

use nalgebra::{Isometry3, Point3};

use crate::body::Body;
use crate::bvh::divide;
use crate::geometry::{Vector, area_vector, mean};

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

/// A tree of the triangles of the other part.
struct Balls {
    triangles: Vec<[Vector; 3]>,
    nodes: Vec<Ball>,
}

struct Ball {
    center: Vector,
    radius: f64,
    items: std::ops::Range<usize>,
    second: Option<usize>,
}

impl Balls {
    fn new(triangles: &[[[f64; 3]; 3]]) -> Self {
        let triangles: Vec<[Vector; 3]> = triangles.iter().map(|triangle| triangle.map(Vector::from)).collect();
        let mut balls = Self { triangles, nodes: Vec::new() };
        if !balls.triangles.is_empty() {
            balls.build(0..balls.triangles.len());
        }
        balls
    }

    fn build(&mut self, items: std::ops::Range<usize>) {
        let [low, high] = crate::geometry::bounds(self.triangles[items.clone()].iter().flatten());
        let center = 0.5 * (low + high);
        let corners = self.triangles[items.clone()].iter().flatten();
        let radius = corners.map(|corner| (corner - center).norm()).fold(0.0, f64::max);
        let node = self.nodes.len();
        self.nodes.push(Ball { center, radius, items: items.clone(), second: None });
        if items.len() == 1 {
            return;
        }
        let half = divide(&mut self.triangles[items.clone()]);
        self.build(items.start..items.start + half);
        self.nodes[node].second = Some(self.nodes.len());
        self.build(items.start + half..items.end);
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
    /// Whether it is outside, if somebody wanted to know.
    is_outside: Option<bool>,
}

/// Finds places that represent all of some passages.
struct Finder<'a> {
    body: &'a Body,
    budget: Budget,
    known: HashSet<(i32, [i64; 3])>,
    /// The first points that were asked for in cells as large as the smallest spacing.
    asked: HashMap<[i64; 3], Asked>,
    places: Vec<Place>,
}

/// The places where other parts pass a body: close together where they pass closely.
pub fn places(body: &Body, passages: &[Passage], budget: Budget) -> Vec<Place> {
    let mut finder = Finder { body, budget, known: HashSet::new(), asked: HashMap::new(), places: Vec::new() };
    for passage in passages {
        let balls = Balls::new(passage.triangles);
        for pose in passage.poses {
            finder.pass(&balls, pose);
        }
    }
    finder.places
}

impl Finder<'_> {
    fn pass(&mut self, balls: &Balls, pose: &Isometry3<f64>) {
        let placed = |point: &Vector| pose.transform_point(&Point3::from(*point)).coords;
        let mut waiting: Vec<usize> = (!balls.nodes.is_empty()).then_some(0).into_iter().collect();
        while let Some(index) = waiting.pop() {
            let ball = &balls.nodes[index];
            let distance = self.distance(&placed(&ball.center));
            let is_small = ball.radius <= SPACING * (distance - ball.radius);
            match ball.second {
                Some(second) if !is_small => waiting.extend([second, index + 1]),
                _ if is_small => self.add(&placed(&balls.triangles[ball.items.start][0])),
                _ => self.triangle(balls.triangles[ball.items.start].map(|corner| placed(&corner))),
            }
        }
    }

    fn triangle(&mut self, triangle: [Vector; 3]) {
        triangle.iter().for_each(|corner| self.add(corner));
        let mut waiting = vec![triangle];
        while let Some([a, b, c]) = waiting.pop() {
            let center = mean(&[a, b, c]);
            let radius = [a, b, c].iter().map(|corner| (corner - center).norm()).fold(0.0, f64::max);
            let distance = self.distance(&center);
            if radius <= (SPACING * distance).max(self.budget.spacing) || area_vector(&[a, b, c]).norm() == 0.0 {
                self.add(&center);
                continue;
            }
            let [one, other] = halves(&[a, b, c]);
            self.add(&one[1]);
            waiting.extend([one, other]);
        }
    }

    /// What is known of a point in the same cell as this one: its distance is that of this point within two spacings.
    fn near(&mut self, point: &Vector) -> &mut Asked {
        let body = self.body;
        let asked = || Asked { point: *point, distance: body.distance(point).1, is_outside: None };
        self.asked.entry(cell(point, self.budget.spacing)).or_insert_with(asked)
    }

    fn distance(&mut self, point: &Vector) -> f64 {
        self.near(point).distance
    }

    fn add(&mut self, point: &Vector) {
        let size = (0.5 * SPACING * self.distance(point)).max(self.budget.spacing);
        let level = size.log2().round() as i32;
        if !self.known.insert((level, cell(point, 2f64.powi(level)))) {
            return;
        }
        let body = self.body;
        let near = self.near(point);
        let apart = (point - near.point).norm();
        let (nearest, distance) = body.distance_within(point, near.distance + apart);
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
fn cell(point: &Vector, edge: f64) -> [i64; 3] {
    std::array::from_fn(|axis| (point[axis] / edge).floor() as i64)
}
