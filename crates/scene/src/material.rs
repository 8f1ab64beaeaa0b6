//! Mass, centre of mass and inertia of parts with known density.

use nalgebra::{Matrix3, Vector3};
use task::algebra::norm;
use task::{Inertia, Pose};

use crate::error::SceneError;
use crate::part::GivenPart;

/// Distance of the centre of mass from the origin, in sizes of the body, that counts as rounding.
const CENTERED: f64 = 1e-6;

/// Parts of known density.
pub struct Material {
    pub mass: f64,
    pub center: Vector3<f64>,
    /// About the origin.
    pub rotational: Matrix3<f64>,
}

impl Material {
    /// From a body whose parts are meshes with a density, if any of them has one.
    pub fn of(parts: &[GivenPart]) -> Result<Option<Self>, SceneError> {
        let Some(first) = parts.iter().find_map(|part| part.mesh().filter(|mesh| mesh.making.density.is_some())) else {
            return Ok(None);
        };
        let (mut mass, mut moment, mut rotational) = (0.0, Vector3::zeros(), Matrix3::zeros());
        for part in parts {
            let Some((mesh, density)) = part.mesh().and_then(|mesh| Some((mesh, mesh.making.density?))) else {
                return Err(first.refuse(format!("`density` is given here but not for part `{}`", part.name)));
            };
            let (properties, placement) = (mesh.solid.mass_properties(), part.placement());
            let own = density * properties.volume;
            let center = placement.transform_point(&properties.center.into()).coords;
            let rotation = placement.rotation.to_rotation_matrix();
            let rows = Matrix3::from_fn(|row, column| properties.inertia[row][column]);
            mass += own;
            moment += own * center;
            rotational += density * (rotation * rows * rotation.inverse())
                + own * (Matrix3::identity() * center.norm_squared() - center * center.transpose());
        }
        Ok(Some(Self { mass, center: moment / mass, rotational }))
    }

    /// About the origin of the body's frame. Beside its centre of mass `c`, the momentum `m (nu + R (omega x c))` depends
    /// on the angular velocity and, as the apparent inertia is constant, on the orientation `R` at the goal.
    pub fn inertia(&self, parts: &[GivenPart], goal: &Pose) -> Inertia {
        let mut matrix = *Inertia::of_body(self.mass, self.rotational).matrix();
        let size = parts.iter().flat_map(GivenPart::points).map(|point| norm(&point)).fold(0.0, f64::max);
        if self.center.norm() > CENTERED * size {
            let rotation = goal.isometry().rotation.to_rotation_matrix();
            let coupling = rotation.matrix() * self.center.cross_matrix() * -self.mass;
            matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&coupling);
            matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&coupling.transpose());
        }
        Inertia::from_matrix(matrix)
    }
}
