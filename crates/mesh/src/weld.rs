//! Vertices of a file that are the same point.

use std::collections::HashMap;

use crate::geometry::Vector;

/// The distinct points, and for each point the index of the one it is the same as within a distance (m).
pub fn weld(points: &[Vector], distance: f64) -> (Vec<Vector>, Vec<usize>) {
    let mut distinct: Vec<Vector> = Vec::new();
    let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    let cell =
        |point: &Vector| -> [i64; 3] { std::array::from_fn(|axis| (point[axis] / (2.0 * distance)).floor() as i64) };
    let index = points.iter().map(|point| {
        let here = cell(point);
        // A point nearer than a quarter of a cell is in one of the cells towards which this one lies.
        let low = cell(&point.add_scalar(-distance));
        let high = cell(&point.add_scalar(distance));
        let around = (0..8).map(|corner: usize| -> [i64; 3] {
            std::array::from_fn(|axis| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] })
        });
        let same = around
            .filter_map(|cell| cells.get(&cell))
            .flatten()
            .copied()
            .filter(|&other| (distinct[other] - point).norm() <= distance)
            .min();
        same.unwrap_or_else(|| {
            distinct.push(*point);
            cells.entry(here).or_default().push(distinct.len() - 1);
            distinct.len() - 1
        })
    });
    let index = index.collect();
    (distinct, index)
}
