//! Sections through convex parts.

use nalgebra::{Isometry3, Vector3};

use crate::model::PartData;

/// Corners of the section through a part where the plane `p[axis] = at` cuts it, in the two other axes; none where it
/// does not.
pub fn section(part: &PartData, pose: &Isometry3<f64>, axis: usize, at: f64) -> Vec<[f64; 2]> {
    let corners: Vec<Vector3<f64>> =
        part.vertices.chunks_exact(3).map(|corner| (pose * nalgebra::Point3::from_slice(corner)).coords).collect();
    let mut cut: Vec<[f64; 2]> = Vec::new();
    for facet in &part.facets {
        for (&from, &to) in facet.iter().zip(facet.iter().cycle().skip(1)) {
            let (before, after) = (corners[from][axis] - at, corners[to][axis] - at);
            // Every edge is met twice, once in each direction.
            if from < to && (before < 0.0) != (after < 0.0) {
                let point = corners[from].lerp(&corners[to], before / (before - after));
                let [first, second] = others(axis);
                cut.push([point[first], point[second]]);
            }
        }
    }
    around_their_centre(cut)
}

/// The two axes that are not the given one.
pub fn others(axis: usize) -> [usize; 2] {
    [[1, 2], [0, 2], [0, 1]][axis]
}

fn around_their_centre(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / points.len() as f64;
    let centre = [mean(0), mean(1)];
    let angle = |point: &[f64; 2]| (point[1] - centre[1]).atan2(point[0] - centre[0]);
    points.sort_by(|one, other| angle(one).total_cmp(&angle(other)));
    points
}

#[cfg(test)]
mod tests {
    use simulation::Solid;

    use super::*;

    #[test]
    fn a_turned_cube_is_cut_in_a_rectangle() {
        let solid = Solid::new(&collision::Polytope::from_box([0.2; 3]).unwrap());
        let part = PartData {
            name: "cube".to_owned(),
            vertices: solid.vertices.iter().flatten().copied().collect(),
            facets: solid.facets.iter().map(|facet| facet.corners.clone()).collect(),
        };
        let turned = task::Pose([1.0, 0.0, 0.0, 0.5_f64.sqrt(), 0.0, 0.0, 0.5_f64.sqrt()]).isometry();
        let polygon = section(&part, &turned, 2, 0.05);
        assert_eq!(polygon.len(), 4);
        for [x, y] in &polygon {
            assert!(((x - 1.0).abs() - 0.1).abs() < 1e-12 && (y.abs() - 0.1).abs() < 1e-12, "{polygon:?}");
        }
        let area: f64 = (0..4)
            .map(|index| [polygon[index], polygon[(index + 1) % 4]])
            .map(|[a, b]| a[0] * b[1] - b[0] * a[1])
            .sum();
        assert!((0.5 * area - 0.04).abs() < 1e-12, "corners go round: {area}");
        assert!(section(&part, &turned, 2, 0.11).is_empty());
    }
}
