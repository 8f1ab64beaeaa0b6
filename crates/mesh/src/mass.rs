//! Volume, centre and inertia of a closed surface.

use nalgebra::Matrix3;

use crate::geometry::Vector;

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
}
