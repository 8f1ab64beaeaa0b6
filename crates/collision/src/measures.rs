//! Volume and thickness of polytopes.

use nalgebra::Vector3;

use crate::polytope::Polytope;

/// A corner this near to a facet's plane, relative to the part's size, is one of the facet's.
const ON_FACET: f64 = 1e-6;

impl Polytope {
    /// Volume (m^3).
    pub fn volume(&self) -> f64 {
        let center = Vector3::from(self.center());
        let facets = self.normals().iter().zip(self.offsets());
        let pyramids = facets.map(|(normal, offset)| {
            let normal = Vector3::from(*normal);
            (offset - normal.dot(&center)) * self.facet_area(&normal, *offset) / 3.0
        });
        pyramids.sum()
    }

    /// Smallest distance between a facet and the corner farthest from it (m).
    pub fn thickness(&self) -> f64 {
        let widths = self.normals().iter().zip(self.offsets()).map(|(normal, offset)| {
            let normal = Vector3::from(*normal);
            let heights = self.vertices().iter().map(|vertex| offset - normal.dot(&Vector3::from(*vertex)));
            heights.fold(0.0, f64::max)
        });
        widths.fold(f64::INFINITY, f64::min)
    }

    fn facet_area(&self, normal: &Vector3<f64>, offset: f64) -> f64 {
        let tolerance = ON_FACET * self.size();
        let vertices = self.vertices().iter().map(|vertex| Vector3::from(*vertex));
        let corners: Vec<Vector3<f64>> =
            vertices.filter(|vertex| (normal.dot(vertex) - offset).abs() <= tolerance).collect();
        let middle = corners.iter().sum::<Vector3<f64>>() / corners.len().max(1) as f64;
        let right = normal.cross(&Vector3::ith(normal.iamin(), 1.0)).normalize();
        let up = normal.cross(&right);
        let mut angles: Vec<(f64, Vector3<f64>)> = corners
            .into_iter()
            .map(|corner| corner - middle)
            .map(|corner| (up.dot(&corner).atan2(right.dot(&corner)), corner))
            .collect();
        angles.sort_by(|one, other| one.0.total_cmp(&other.0));
        let next = angles.iter().cycle().skip(1);
        0.5 * angles.iter().zip(next).map(|((_, one), (_, other))| one.cross(other).dot(normal)).sum::<f64>().abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_box_and_of_a_wedge() {
        let block = Polytope::from_box([0.1, 0.02, 0.3]).unwrap().placed([1.0, 2.0, 3.0], [0.3, 0.5, -0.2, 0.8]);
        assert!((block.volume() / 6e-4 - 1.0).abs() < 1e-9 && (block.thickness() - 0.02).abs() < 1e-9);
        let corners =
            [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 10.0], [3.0, 0.0, 10.0], [0.0, 4.0, 10.0]];
        let wedge = Polytope::from_vertices(&corners).unwrap();
        assert!((wedge.volume() / 60.0 - 1.0).abs() < 1e-9 && (wedge.thickness() - 2.4).abs() < 1e-9);
    }
}
