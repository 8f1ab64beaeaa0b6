//! Default number of facets for curved surfaces.

use std::f64::consts::TAU;

use mesh::{CurvedSurface, Solid};
use nalgebra::{Isometry3, Point3, Vector3};

/// Candidates for facets per full turn; the smallest that is fine enough is chosen.
const CHOICES: [usize; 8] = [8, 12, 16, 24, 32, 40, 48, 64];
/// Facets where no round part enters a round hole.
const DEFAULT: usize = 24;
/// Share of the gap between a round part and its hole that facets may take.
pub const SHARE: f64 = 0.05;
/// Share of the gap beyond which a plan for the facets is not valid for the part.
pub const LARGEST_SHARE: f64 = 0.25;
/// Largest interference and largest gap of a fit, in radii of the hole: cylinders with more interference belong to
/// other features, those with more room guide nothing.
const LARGEST_INTERFERENCE: f64 = 0.02;
const LARGEST_GAP: f64 = 0.5;
/// Cylinders that overlap by less along their axis (m) only touch end to end.
const TOUCHING: f64 = 1e-6;
/// Cosine of the angle between axes that are parallel.
const PARALLEL: f64 = 0.9999;

/// A round part in a round hole.
#[derive(Debug, Clone, Copy)]
pub struct Fit {
    /// Radius (m) of the hole.
    pub hole: f64,
    /// Difference of the radii (m); negative where the part is larger.
    pub gap: f64,
    /// Largest distance (m) between flat sides of the hole's mesh and the hole.
    pub mesh_error: f64,
    /// The same of hole and part together (m): as much as meshes say of the gap.
    pub chord_errors: f64,
}

impl Fit {
    /// Loss of gap by facets (m): flat sides of the hole against flat sides of the part, or corners against corners,
    /// whichever is more.
    pub fn lost(&self, facets: usize) -> f64 {
        let cosine = (0.5 * TAU / facets as f64).cos();
        (self.hole * (1.0 - cosine)).max((self.hole - self.gap) * (1.0 / cosine - 1.0))
    }
}

/// A mesh with its place in the world.
#[derive(Clone, Copy)]
pub struct Placed<'mesh> {
    pub solid: &'mesh Solid,
    pub placement: Isometry3<f64>,
    /// Distance (m) that its surface is moved inwards.
    pub clearance: f64,
}

/// The tightest fit of a cylinder of the body in one of the environment, or around one, when the body is at its goal.
pub fn tightest_fit(body: &[Placed], environment: &[Placed]) -> Option<Fit> {
    let fits = |inner: &[Placed], outer: &[Placed]| {
        let pegs: Vec<Cylinder> = inner.iter().flat_map(|part| cylinders(part, true)).collect();
        let holes: Vec<Cylinder> = outer.iter().flat_map(|part| cylinders(part, false)).collect();
        pegs.iter().flat_map(|peg| holes.iter().filter_map(|hole| peg.fit(hole))).collect::<Vec<Fit>>()
    };
    let all = fits(body, environment).into_iter().chain(fits(environment, body));
    all.min_by(|one, other| one.gap.total_cmp(&other.gap))
}

/// How fine curved surfaces are.
#[derive(Debug, Clone, Copy)]
pub struct ChosenFacets {
    /// Facets per full turn.
    pub facets: usize,
    /// Distance (m) from the surface that is fine enough: small surfaces keep it with fewer facets.
    pub error: f64,
}

/// Facets for a fit.
pub fn chosen_facets(fit: Option<Fit>) -> ChosenFacets {
    let Some(fit) = fit.filter(|fit| fit.gap > 0.0) else { return ChosenFacets { facets: DEFAULT, error: 0.0 } };
    let is_fine = |&facets: &usize| fit.lost(facets) <= SHARE * fit.gap;
    let facets = CHOICES.into_iter().find(is_fine).unwrap_or(CHOICES[CHOICES.len() - 1]);
    ChosenFacets { facets, error: fit.lost(facets) }
}

struct Cylinder {
    middle: Point3<f64>,
    axis: Vector3<f64>,
    length: f64,
    radius: f64,
    mesh_error: f64,
}

fn cylinders(part: &Placed, convex: bool) -> Vec<Cylinder> {
    let sign = if convex { -1.0 } else { 1.0 };
    let of = |surface: CurvedSurface| {
        let [begin, end] = surface.axis.map(|point| part.placement.transform_point(&point.into()));
        let axis = end - begin;
        let radius = 0.5 * (surface.radii[0] + surface.radii[1]) + sign * part.clearance;
        let (middle, mesh_error) = (nalgebra::center(&begin, &end), surface.mesh_error);
        Cylinder { middle, axis: axis.normalize(), length: axis.norm(), radius, mesh_error }
    };
    let surfaces = part.solid.curved_surfaces().into_iter();
    surfaces.filter(|surface| surface.is_convex == convex && surface.radii[0] == surface.radii[1]).map(of).collect()
}

impl Cylinder {
    /// This cylinder in a hole, if that is around it.
    fn fit(&self, hole: &Self) -> Option<Fit> {
        let between = hole.middle - self.middle;
        let along = between.dot(&hole.axis);
        let aside = (between - along * hole.axis).norm();
        let gap = hole.radius - self.radius;
        let is_around = self.axis.dot(&hole.axis).abs() > PARALLEL
            && along.abs() < 0.5 * (self.length + hole.length) - TOUCHING
            && aside < 0.1 * hole.radius
            && (-LARGEST_INTERFERENCE * hole.radius..LARGEST_GAP * hole.radius).contains(&gap);
        let chord_errors = self.mesh_error + hole.mesh_error;
        is_around.then_some(Fit { hole: hole.radius, gap: gap - aside, mesh_error: hole.mesh_error, chord_errors })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cylinder(radius: f64) -> Cylinder {
        Cylinder { middle: Point3::origin(), axis: Vector3::z(), length: 0.01, radius, mesh_error: 0.0 }
    }

    #[test]
    fn walls_of_other_features_are_no_fit() {
        let gap = |part: f64, hole: f64| cylinder(part).fit(&cylinder(hole)).map(|fit| fit.gap);
        // The rim of a lid in its pot, and a boss that is nominally as large as its hole.
        assert!((gap(0.0367, 0.037).unwrap() - 3e-4).abs() < 1e-12);
        assert!((gap(0.01813, 0.018).unwrap() + 1.3e-4).abs() < 1e-12);
        // The inside of the rim around the outside of the pot, and a pin in a wide pot.
        assert_eq!((gap(0.04, 0.033), gap(0.01, 0.037)), (None, None));
    }
}
