//! Distances and normals of a small cube to a cuboid, in a plane, as CSV: the data of figures like the paper's
//! Figs. distancecomp and normalvis.
//!
//! `cargo run --release -p collision --example planar_distances > distances.csv`
//!
//! The paper draws a point and a rectangle in two dimensions. Here the product itself is asked, which knows polytopes in
//! space with an interior: a cube of edge `POINT` stands for the point and a cuboid as long as `LENGTH` for the rectangle.

use collision::{Pair, Polytope};

/// Edge lengths of the rectangle.
const RECTANGLE: [f64; 2] = [2.0, 1.0];
const LENGTH: f64 = 20.0;
const POINT: f64 = 1e-3;
const SMOOTHINGS: [f64; 4] = [0.1, 0.03, 0.01, 0.001];
/// The grid reaches so far from the centre, along both axes, in so many points.
const REACH: [f64; 2] = [2.5, 2.0];
const COUNT: [usize; 2] = [101, 81];

/// Point of a grid from `-reach` to `reach`.
fn coordinate(axis: usize, index: usize) -> f64 {
    REACH[axis] * (2.0 * index as f64 / (COUNT[axis] - 1) as f64 - 1.0)
}

fn main() {
    let [width, height] = RECTANGLE;
    let shape = |edges| Polytope::from_box(edges).expect("positive edge lengths");
    let pair = Pair::new(shape([POINT; 3]), shape([width, height, LENGTH]));
    println!("tau,x,y,exact_distance,smoothed_distance,normal_x,normal_y,gradient_x,gradient_y");
    for tau in SMOOTHINGS {
        for (row, column) in (0..COUNT[1]).flat_map(|row| (0..COUNT[0]).map(move |column| (row, column))) {
            let (x, y) = (coordinate(0, column), coordinate(1, row));
            let pose = [x, y, 0.0, 1.0, 0.0, 0.0, 0.0];
            let (mut values, mut jacobians) = ([[0.0; 7]], [[[0.0; 7]; 7]]);
            pair.contact_jacobians(&[pose], tau, &mut values, &mut jacobians).expect("the distance converges");
            let [[distance, normal_x, normal_y, ..]] = values;
            let [gradient_x, gradient_y, ..] = jacobians[0][0];
            let exact = pair.exact_distance(&pose);
            println!("{tau},{x},{y},{exact},{distance},{normal_x},{normal_y},{gradient_x},{gradient_y}");
        }
    }
}
