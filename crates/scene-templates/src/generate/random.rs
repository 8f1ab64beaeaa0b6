//! Random cross-sections like those of the paper's pegs.

use std::f64::consts::PI;

use fastrand::Rng;

use super::section::{Line, Point, Section, length, subtract};

/// Attempts to draw a section with the requested number of pieces and without sharp or narrow places.
const DRAWS: usize = 20_000;
/// Largest angle by which corners are rotated about the origin, as a fraction of their distance.
const JITTER: f64 = 0.3;
/// Shorter axis of the ellipse on which corners lie, as a fraction of the longer one, at least.
const FLATTEST: f64 = 0.6;
/// How far corners that make a section concave are pulled towards the origin, as factors of their distance.
const NOTCHES: std::ops::Range<f64> = 0.25..0.6;
/// Smallest angle between two edges of a piece, and between an outline's edges and a straight line.
const SHARPEST: f64 = PI / 6.0;
const STRAIGHTEST: f64 = PI / 18.0;
/// Shortest edge, as a fraction of the diameter.
const SHORTEST: f64 = 0.08;

/// A section of `prisms` convex pieces with `facets` edges, within a circle about the origin, whose edges can be moved
/// outwards by some distances (m); `None` if hardly any exists.
pub fn section(rng: &mut Rng, diameter: f64, prisms: usize, facets: usize, moves: &[f64]) -> Option<Section> {
    if facets < 2 * prisms {
        return None;
    }
    (0..DRAWS).find_map(|_| {
        let outline = outline(rng, 0.5 * diameter, prisms - 1, facets);
        let mut pieces = Vec::new();
        partition(&outline, (0..facets).collect(), &mut pieces)?;
        let section = Section { outline, pieces };
        let can_move = || moves.iter().all(|distance| section.offset(*distance).is_some());
        let is_right = section.pieces.len() == prisms && is_regular(&section, SHORTEST * diameter) && can_move();
        is_right.then_some(section)
    })
}

/// A star-shaped polygon: corners on an ellipse, some of them pulled inwards.
fn outline(rng: &mut Rng, radius: f64, notches: usize, facets: usize) -> Vec<Point> {
    let (phase, turn) = (2.0 * PI * rng.f64(), 2.0 * PI / facets as f64);
    let shorter = radius * between(rng, FLATTEST..1.0);
    let mut pulled = vec![false; facets];
    pulled[..notches].fill(true);
    rng.shuffle(&mut pulled);
    let corner = |(index, is_pulled): (usize, bool)| {
        let angle = (index as f64 + between(rng, -JITTER..JITTER)) * turn;
        let factor = if is_pulled { between(rng, NOTCHES) } else { 1.0 };
        let [x, y] = [factor * radius * angle.cos(), factor * shorter * angle.sin()];
        [x * phase.cos() - y * phase.sin(), x * phase.sin() + y * phase.cos()]
    };
    pulled.into_iter().enumerate().map(corner).collect()
}

fn between(rng: &mut Rng, range: std::ops::Range<f64>) -> f64 {
    range.start + (range.end - range.start) * rng.f64()
}

/// Cuts a part of an outline at its concave corners until all pieces are convex; none where a corner sees no other one
/// that would do.
fn partition(outline: &[Point], part: Vec<usize>, pieces: &mut Vec<Vec<usize>>) -> Option<()> {
    let count = part.len();
    let at = |place: usize| outline[part[place % count]];
    let Some(concave) = (0..count).find(|&place| turn(at(place + count - 1), at(place), at(place + 1)) < 0.0) else {
        pieces.push(part);
        return Some(());
    };
    let candidates = (concave + 2..concave + count - 1).filter(|&other| {
        let cures = turn(at(concave + count - 1), at(concave), at(other)) > 0.0
            && turn(at(other), at(concave), at(concave + 1)) > 0.0;
        cures && (0..count).all(|edge| !crosses([at(concave), at(other)], [at(edge), at(edge + 1)]))
    });
    let gap = |other: &usize| length(subtract(at(*other), at(concave)));
    let other = candidates.min_by(|one, other| gap(one).total_cmp(&gap(other)))?;
    let ring = |from: usize, to: usize| (from..=to).map(|place| part[place % count]).collect();
    partition(outline, ring(concave, other), pieces)?;
    partition(outline, ring(other, concave + count), pieces)
}

/// Angle by which a path turns left at its second point.
fn turn(from: Point, at: Point, to: Point) -> f64 {
    let ([x1, y1], [x2, y2]) = (subtract(at, from), subtract(to, at));
    (x1 * y2 - y1 * x2).atan2(x1 * x2 + y1 * y2)
}

/// Whether two segments have a point in common that is no end of theirs.
fn crosses(one: [Point; 2], other: [Point; 2]) -> bool {
    let separates = |line: [Point; 2], ends: [Point; 2]| {
        let line = Line::through(line[0], line[1]);
        line.distance(ends[0]) * line.distance(ends[1]) < 0.0
    };
    one.iter().all(|end| !other.contains(end)) && separates(one, other) && separates(other, one)
}

/// Whether a section has neither sharp nor nearly straight corners nor short edges.
fn is_regular(section: &Section, shortest: f64) -> bool {
    let turns = |corners: &[Point]| -> Vec<f64> {
        let count = corners.len();
        (0..count).map(|at| turn(corners[(at + count - 1) % count], corners[at], corners[(at + 1) % count])).collect()
    };
    let edges = |corners: &[Point]| -> f64 {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(from, to)| length(subtract(*to, *from))).fold(f64::INFINITY, f64::min)
    };
    let is_blunt = |piece: &Vec<usize>| turns(&section.piece(piece)).iter().all(|turn| *turn < PI - SHARPEST);
    edges(&section.outline) >= shortest
        && turns(&section.outline).iter().all(|turn| turn.abs() > STRAIGHTEST)
        && section.pieces.iter().all(is_blunt)
}

/// A unit quaternion (w x y z) of a random axis and an angle (rad) in a range.
pub fn orientation(rng: &mut Rng, angles: std::ops::Range<f64>) -> [f64; 4] {
    let (height, around) = (between(rng, -1.0..1.0), 2.0 * PI * rng.f64());
    let radius = (1.0 - height * height).sqrt();
    let (sine, cosine) = (0.5 * between(rng, angles)).sin_cos();
    [cosine, sine * radius * around.cos(), sine * radius * around.sin(), sine * height]
}
