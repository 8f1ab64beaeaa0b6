//! Round parts as OBJ files in millimetres.

use std::f64::consts::TAU;
use std::fmt::Write;

/// Sides of a full turn; each turns by less than 25 degrees, so that they are recognised as round.
const SIDES: usize = 24;

/// Upright cylinders of a radius and a height, with their lower middle at these places in the xy plane.
pub fn cylinders(radius: f64, height: f64, middles: &[[f64; 2]]) -> String {
    let mut file = String::new();
    for (index, middle) in middles.iter().enumerate() {
        circle(&mut file, radius, 0.0, *middle);
        circle(&mut file, radius, height, *middle);
        let below = |side: usize| 2 * SIDES * index + side % SIDES + 1;
        let above = |side: usize| below(side) + SIDES;
        sides(&mut file, |side| [below(side), below(side + 1), above(side + 1), above(side)]);
        face(&mut file, (0..SIDES).rev().map(below));
        face(&mut file, (0..SIDES).map(above));
    }
    file
}

/// A tube around the z axis with this inner and outer radius, from the xy plane upwards.
pub fn tube(inner: f64, outer: f64, height: f64) -> String {
    let mut file = String::new();
    for (radius, z) in [(inner, 0.0), (inner, height), (outer, 0.0), (outer, height)] {
        circle(&mut file, radius, z, [0.0, 0.0]);
    }
    let corner = |ring: usize, side: usize| ring * SIDES + side % SIDES + 1;
    for [one, other] in [[1, 0], [2, 3], [0, 2], [3, 1]] {
        sides(&mut file, |side| {
            [corner(one, side), corner(one, side + 1), corner(other, side + 1), corner(other, side)]
        });
    }
    file
}

fn circle(file: &mut String, radius: f64, z: f64, [x, y]: [f64; 2]) {
    for side in 0..SIDES {
        let (sine, cosine) = (TAU * side as f64 / SIDES as f64).sin_cos();
        writeln!(file, "v {:.9} {:.9} {z}", x + radius * cosine, y + radius * sine).unwrap();
    }
}

fn sides(file: &mut String, corners: impl Fn(usize) -> [usize; 4]) {
    (0..SIDES).for_each(|side| face(file, corners(side).into_iter()));
}

fn face(file: &mut String, corners: impl Iterator<Item = usize>) {
    let corners: Vec<String> = corners.map(|corner| corner.to_string()).collect();
    writeln!(file, "f {}", corners.join(" ")).unwrap();
}
