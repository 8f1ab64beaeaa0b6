//! Plain parts of any size, as two programs each write them in each format, are closed and have their volumes.

use std::f64::consts::TAU;

use crate::reading::random::Random;
use crate::reading::volume;
use crate::reading::writers::{WRITERS, Writer};
use crate::shapes::{Point, Shape, circle, stack};

fn assert_read<'a>(shape: &Shape, writers: impl IntoIterator<Item = &'a Writer>, expected: f64, what: &str) {
    for Writer { name, format, write } in writers {
        match volume(&write(shape), *format) {
            Ok(volume) => {
                assert!((volume - expected).abs() < 1e-4 * expected, "{what}, {name}: {volume}, not {expected}")
            }
            Err(error) => panic!("{what}, {name}: {error}"),
        }
    }
}

fn rounded(points: Vec<Point>, decimals: i32) -> Vec<Point> {
    let scale = 10f64.powi(decimals);
    points.into_iter().map(|point| point.map(|coordinate| (coordinate * scale).round() / scale)).collect()
}

fn area(outline: &[Point]) -> f64 {
    let pairs = (0..outline.len()).map(|at| (outline[at], outline[(at + 1) % outline.len()]));
    0.5 * pairs.map(|([x, y, _], [u, v, _])| x * v - y * u).sum::<f64>()
}

/// A box around the origin, or with a corner there.
fn cuboid([x, y, z]: [f64; 3], is_centred: bool) -> Shape {
    let low = if is_centred { [-0.5 * x, -0.5 * y, -0.5 * z] } else { [0.0; 3] };
    let square = |height: f64| {
        [[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]].map(|[u, v]| [low[0] + u, low[1] + v, low[2] + height]).to_vec()
    };
    stack(&[square(0.0), square(z)], false)
}

#[test]
fn boxes_of_every_round_size() {
    for hundredths in 1..=2000 {
        let size = f64::from(hundredths) / 100.0;
        for is_centred in [true, false] {
            let writers = &WRITERS[..if hundredths % 10 == 0 { 6 } else { 2 }];
            assert_read(
                &cuboid([size, 10.0, 12.0], is_centred),
                writers,
                size * 120.0,
                &format!("{size} {is_centred}"),
            );
        }
    }
}

/// A cylinder, a ring or a star-shaped prism with a phase, at a place, with coordinates of a number of decimals.
fn random_part(random: &mut Random, decimals: i32) -> (Shape, f64, String) {
    let sides = 3 + random.below(58);
    let radius = random.between(15.0, 60.0);
    let low = random.between(-40.0, 40.0);
    let high = low + random.between(1.0, 80.0);
    let phase = random.between(0.0, TAU);
    let loop_at = |radius: f64, z: f64| rounded(circle(radius, z, sides, phase), decimals);
    match random.below(3) {
        0 => {
            let loops = [loop_at(radius, low), loop_at(radius, high)];
            let volume = area(&loops[0]) * (loops[1][0][2] - loops[0][0][2]);
            (star_prism(&loops[0], &loops[1]), volume, format!("cylinder of {sides} sides, {decimals} decimals"))
        }
        1 => {
            let inner = radius * random.between(0.3, 0.8);
            let loops = [loop_at(radius, low), loop_at(radius, high), loop_at(inner, high), loop_at(inner, low)];
            let volume = (area(&loops[0]) - area(&loops[2])) * (loops[1][0][2] - loops[0][0][2]);
            (stack(&loops, true), volume, format!("ring of {sides} sides, {decimals} decimals"))
        }
        _ => {
            let radii: Vec<f64> = (0..sides).map(|_| radius * random.between(0.6, 1.0)).collect();
            let corner = |z: f64, (index, radius): (usize, &f64)| {
                let angle = phase + TAU * index as f64 / sides as f64;
                [radius * angle.cos(), radius * angle.sin(), z]
            };
            let outline = |z: f64| rounded(radii.iter().enumerate().map(|side| corner(z, side)).collect(), decimals);
            let (below, above) = (outline(low), outline(high));
            let volume = area(&below) * (above[0][2] - below[0][2]);
            (star_prism(&below, &above), volume, format!("prism of {sides} sides, {decimals} decimals"))
        }
    }
}

/// A prism over an outline that the origin sees, its ends triangles from their middles.
fn star_prism(below: &[Point], above: &[Point]) -> Shape {
    let mut shape = Shape::default();
    let (low, high) = (shape.add(below), shape.add(above));
    let middles = shape.add(&[[0.0, 0.0, below[0][2]], [0.0, 0.0, above[0][2]]]);
    for at in 0..low.len() {
        let next = (at + 1) % low.len();
        shape.polygons.push(vec![low[at], low[next], high[next], high[at]]);
        shape.polygons.push(vec![middles[0], low[next], low[at]]);
        shape.polygons.push(vec![middles[1], high[at], high[next]]);
    }
    shape
}

#[test]
fn random_cylinders_rings_and_prisms() {
    let mut random = Random(51);
    for number in 0..500 {
        let (shape, volume, what) = random_part(&mut random, 1 + number % 6);
        // One program or the other, in all formats.
        let writers = WRITERS.iter().skip(number as usize / 6 % 2).step_by(2);
        assert_read(&shape, writers, volume, &format!("number {number}, {what}"));
    }
}
