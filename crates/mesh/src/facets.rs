//! Facets for curved surfaces, on the side away from the material.

use std::f64::consts::{PI, TAU};

use crate::curved::{Curved, turn};
use crate::curved_surface::CurvedSurface;
use crate::geometry::{Plane, Vector, clip};
use crate::settings::CoverSettings;

/// Angles (rad) closer than this are equal.
const SAME_ANGLE: f64 = 1e-4;
/// Facets per full turn of small surfaces: at least these, and multiples of the step.
const FEWEST: usize = 8;
const STEP: usize = 4;

/// Facets per full turn of each curved surface: as many as the settings say, or the fewest with which it keeps their error,
/// if these are no more than half as many. So only small surfaces have fewer: a peg and its hole, of nearly one radius,
/// stay face to face. Surfaces around one axis have equally many for the same reason.
pub fn facet_counts(curved: &[Curved], settings: &CoverSettings, tolerance: f64) -> Vec<usize> {
    let needed = |curved: &Curved| {
        let surface = CurvedSurface::of(curved);
        let mut fewer = (FEWEST..=settings.facets / 2).step_by(STEP);
        fewer.find(|&count| surface.error(count) <= settings.error).unwrap_or(settings.facets)
    };
    let needed: Vec<usize> = curved.iter().map(needed).collect();
    let most_around = |one: &Curved| {
        let around = curved.iter().zip(&needed).filter(|(other, _)| other.is_coaxial(one, tolerance));
        around.map(|(_, &count)| count).fold(0, usize::max)
    };
    curved.iter().map(most_around).collect()
}

/// The part of a curved surface for which one facet stands.
#[derive(Debug, Clone, Copy)]
pub struct Sector {
    /// Angle of the facet's normal (rad).
    middle: f64,
    /// Angles between which it lies (rad).
    ends: [f64; 2],
}

/// Sectors of a curved surface with `count` of them per full turn.
///
/// Those of full turns have their middles at multiples of the angle from +x across the axis. So have those of arcs that
/// meet other surfaces at an angle; arcs that planes continue are divided evenly, and the planes serve as facets.
pub fn sectors(curved: &Curved, count: usize) -> Vec<Sector> {
    let step = TAU / count as f64;
    if curved.is_tangent.contains(&true) && !curved.is_full() {
        return divided(curved, step);
    }
    let all = (0..count).map(|index| step * index as f64);
    all.filter(|middle| overlaps(curved, *middle, 0.5 * step))
        .map(|middle| Sector { middle, ends: [middle - 0.5 * step, middle + 0.5 * step] })
        .collect()
}

fn overlaps(curved: &Curved, middle: f64, half: f64) -> bool {
    curved.is_full() || {
        let center = curved.start + 0.5 * curved.extent;
        turn(middle - center).abs() < half + 0.5 * curved.extent - SAME_ANGLE
    }
}

/// Equal sectors of an arc. Planes tangent to its ends are facets already, of half a sector.
fn divided(curved: &Curved, step: f64) -> Vec<Sector> {
    let is_shared = curved.is_tangent.map(|is_tangent| is_tangent && curved.is_convex);
    let halves = is_shared.iter().filter(|is_shared| **is_shared).count() as f64 / 2.0;
    let least = if halves < 1.0 { 1.0 } else { 0.0 };
    let own = (curved.extent / step - halves - SAME_ANGLE).ceil().max(least);
    let width = curved.extent / (own + halves);
    let end = curved.start + curved.extent;
    let from = curved.start + if is_shared[0] { 0.5 * width } else { 0.0 };
    let own = (0..own as usize).map(|index| {
        let start = from + width * index as f64;
        Sector { middle: start + 0.5 * width, ends: [start, start + width] }
    });
    let first =
        is_shared[0].then_some(Sector { middle: curved.start, ends: [curved.start, curved.start + 0.5 * width] });
    let last = is_shared[1].then_some(Sector { middle: end, ends: [end - 0.5 * width, end] });
    first.into_iter().chain(own).chain(last).collect()
}

impl Sector {
    /// The part of a polygon on the curved surface that belongs to this sector.
    pub fn share(&self, curved: &Curved, polygon: &[Vector], tolerance: f64) -> Vec<Vector> {
        let cone = &curved.cone;
        // Sectors are narrower than half a turn: two sides and the half of the space around the middle bound them.
        let across = |angle: f64| Plane::through(&cone.origin, cone.outward(angle));
        let part = clip(polygon, &across(self.ends[1] + 0.5 * PI), tolerance);
        let part = clip(&part, &across(self.ends[0] - 0.5 * PI), tolerance);
        clip(&part, &across(self.middle).flipped(), tolerance)
    }

    fn half_cosine(&self) -> f64 {
        (self.ends[1] - self.middle).max(self.middle - self.ends[0]).cos()
    }

    /// Where facets of a concave surface have their corners, as a part of the radius, so that points of the surface in
    /// the sector are behind the facet: one when the mesh has vertices at the corners, else those are on its facets.
    pub fn corner_factor<'a>(&self, curved: &Curved, points: impl Iterator<Item = &'a Vector>) -> f64 {
        let cone = &curved.cone;
        let outward = cone.outward(self.middle);
        let least = 1e-3 * curved.radius();
        let factor = |point: &Vector| {
            let from = point - cone.origin;
            let radius = cone.radius_at(cone.axis.dot(&from));
            if radius < least { 1.0 } else { outward.dot(&from) / (radius * self.half_cosine()) }
        };
        points.map(factor).fold(1.0, f64::min)
    }

    /// The plane of the facet, normal out of the material: tangent to a convex surface, through corners at the factor
    /// times the radius of a concave one.
    pub fn plane(&self, curved: &Curved, factor: f64) -> Plane {
        let cone = &curved.cone;
        let scale = if curved.is_convex { 1.0 } else { factor * self.half_cosine() };
        let outward = cone.outward(self.middle);
        let normal = (outward - cone.axis * (cone.slope * scale)).normalize();
        let plane = Plane::through(&(cone.origin + outward * (cone.radius * scale)), normal);
        if curved.is_convex { plane } else { plane.flipped() }
    }
}
