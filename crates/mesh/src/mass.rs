//! Volume, centre and inertia of a closed surface.

use nalgebra::Matrix3;

use crate::bvh::BoxTree;
use crate::geometry::{Vector, bounds};

/// Lines along each axis with which a part is measured whose surface crosses itself.
const LINES: usize = 160;

/// Mass properties of a solid of density one, multiply by the density (kg/m^3) where marked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    /// Volume (m^3); times the density the mass (kg).
    pub volume: f64,
    /// Centre of mass (m).
    pub center: [f64; 3],
    /// Inertia about the centre (m^5), row by row; times the density in kg m^2.
    pub inertia: [[f64; 3]; 3],
}

impl MassProperties {
    /// Of the inside of closed outward triangles.
    pub fn of(triangles: &[[Vector; 3]]) -> Self {
        // About a point of the part, so that a part far from the origin loses no digits.
        let origin = triangles.first().map_or(Vector::zeros(), |triangle| triangle[0]);
        let mut volume = 0.0;
        let mut moment = Vector::zeros();
        let mut second = Matrix3::zeros();
        for triangle in triangles {
            let corners = triangle.map(|corner| corner - origin);
            let [a, b, c] = corners;
            let tetrahedron = a.dot(&b.cross(&c)) / 6.0;
            let sum = a + b + c;
            volume += tetrahedron;
            moment += tetrahedron / 4.0 * sum;
            let squares: Matrix3<f64> = corners.iter().map(|corner| corner * corner.transpose()).sum();
            second += tetrahedron / 20.0 * (squares + sum * sum.transpose());
        }
        let center = moment / volume;
        let second = second - volume * center * center.transpose();
        let inertia = Matrix3::identity() * second.trace() - second;
        Self { volume, center: (center + origin).into(), inertia: inertia.transpose().into() }
    }

    /// Of what triangles run around, however often, within some thousandths: along lines, so that what several bodies
    /// have in common counts once.
    pub fn along_lines(triangles: &[[Vector; 3]]) -> Self {
        let [low, high] = bounds(triangles.iter().flatten());
        let flat: Vec<[Vector; 2]> = triangles.iter().map(bounds).collect();
        let tree = BoxTree::new(&flat);
        let step = (high - low) / LINES as f64;
        let center = 0.5 * (low + high);
        let (mut volume, mut moment, mut second) = (0.0, Vector::zeros(), Matrix3::zeros());
        for line in 0..LINES * LINES {
            let x = low.x + step.x * ((line % LINES) as f64 + 0.5);
            let y = low.y + step.y * ((line / LINES) as f64 + 0.5);
            let mut crossings: Vec<(f64, i32)> = Vec::new();
            let is_here = |[low, high]: &[Vector; 2]| (low.x..=high.x).contains(&x) && (low.y..=high.y).contains(&y);
            tree.visit(is_here, |item| crossings.extend(crossing(&triangles[item], x, y)));
            crossings.sort_by(|one, other| one.0.total_cmp(&other.0));
            let mut depth = 0;
            for pair in crossings.windows(2) {
                depth += pair[0].1;
                if depth > 0 {
                    let length = pair[1].0 - pair[0].0;
                    let column = length * step.x * step.y;
                    let middle = Vector::new(x, y, 0.5 * (pair[0].0 + pair[1].0)) - center;
                    volume += column;
                    moment += column * middle;
                    let own = Vector::new(step.x * step.x, step.y * step.y, length * length) / 12.0;
                    second += column * (middle * middle.transpose() + Matrix3::from_diagonal(&own));
                }
            }
        }
        let mean = moment / volume;
        let second = second - volume * mean * mean.transpose();
        let inertia = Matrix3::identity() * second.trace() - second;
        Self { volume, center: (mean + center).into(), inertia: inertia.transpose().into() }
    }
}

/// Where a line along z crosses a triangle: upwards into the material counts +1, out of it -1.
fn crossing([a, b, c]: &[Vector; 3], x: f64, y: f64) -> Option<(f64, i32)> {
    let side = |from: &Vector, to: &Vector| (from.x - x) * (to.y - y) - (from.y - y) * (to.x - x);
    let (u, v, w) = (side(b, c), side(c, a), side(a, b));
    let is_hit = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
    is_hit.then(|| ((u * a.z + v * b.z + w * c.z) / (u + v + w), if u > 0.0 { -1 } else { 1 }))
}
