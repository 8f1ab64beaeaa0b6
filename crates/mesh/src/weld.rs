//! Vertices of a file that are the same point.

use rustc_hash::FxHashMap;

use crate::geometry::Vector;

/// The distinct points, and for each point the index of the one it is the same as within a distance (m).
pub fn weld(points: &[Vector], distance: f64) -> (Vec<Vector>, Vec<usize>) {
    let mut distinct: Vec<Vector> = Vec::new();
    let mut cells: FxHashMap<[i64; 3], Vec<usize>> = FxHashMap::default();
    let cell =
        |point: &Vector| -> [i64; 3] { std::array::from_fn(|axis| (point[axis] / (2.0 * distance)).floor() as i64) };
    let index = points.iter().map(|point| {
        let here = cell(point);
        let low = cell(&point.add_scalar(-distance));
        let high = cell(&point.add_scalar(distance));
        // All cells within the distance. These two may be those on both sides of the point's own, by rounding.
        let xy = (low[0]..=high[0]).flat_map(|x| (low[1]..=high[1]).map(move |y| [x, y]));
        let around = xy.flat_map(|[x, y]| (low[2]..=high[2]).map(move |z| [x, y, z]));
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

#[cfg(test)]
mod tests {
    use super::weld;
    use crate::geometry::Vector;

    #[test]
    fn equal_points_are_one_wherever_they_lie_in_their_cells() {
        let distance = 1e-6;
        // Beginnings, middles and ends of cells, and what rounding makes of them.
        let coordinates = (0..20_000).map(|index| 0.25 * distance * f64::from(index) + 0.004_85);
        let points: Vec<Vector> = coordinates.map(|at| Vector::new(at, -at, 2.0 * at)).collect();
        for point in points {
            let (distinct, index) = weld(&[point, Vector::zeros(), point], distance);
            assert_eq!((distinct.len(), index), (2, vec![0, 1, 0]), "{point}");
        }
    }
}
