//! Facets for curved surfaces, on the side away from the material.

use std::f64::consts::{PI, TAU};

use crate::curved::{Curved, turn};
use crate::geometry::{Plane, Vector, clip};

/// Angles (rad) closer than this are equal.
const SAME_ANGLE: f64 = 1e-4;

/// A plane that stands for a curved surface between two angles.
#[derive(Debug, Clone, Copy)]
pub struct Facet {
    /// Outward of the material.
    pub plane: Plane,
    middle: f64,
    sector: [f64; 2],
}

/// Facets of a curved surface with `count` of them per full turn.
///
/// Those of full turns have normals at multiples of the angle from +x across the axis. So have those of arcs that meet
/// other surfaces at an angle; those of arcs that planes continue divide the arc, and the planes serve as facets.
pub fn facets(curved: &Curved, count: usize) -> Vec<Facet> {
    let step = TAU / count as f64;
    let is_tangent = curved.is_tangent.contains(&true) && !curved.is_full();
    let sectors: Vec<(f64, [f64; 2])> = if !is_tangent {
        let all = (0..count)
            .map(|index| step * index as f64)
            .map(|middle| (middle, [middle - 0.5 * step, middle + 0.5 * step]));
        all.filter(|(middle, _)| overlaps(curved, *middle, 0.5 * step)).collect()
    } else {
        divided(curved, step)
    };
    let factor = corner_factor(curved, &sectors);
    sectors.into_iter().map(|(middle, sector)| facet(curved, middle, sector, factor)).collect()
}

fn overlaps(curved: &Curved, middle: f64, half: f64) -> bool {
    curved.is_full() || {
        let center = curved.start + 0.5 * curved.extent;
        turn(middle - center).abs() < half + 0.5 * curved.extent - SAME_ANGLE
    }
}

/// Equal sectors of an arc. Planes tangent to its ends are facets already, of half a sector.
fn divided(curved: &Curved, step: f64) -> Vec<(f64, [f64; 2])> {
    let ends = if curved.is_convex {
        curved.is_tangent.map(|is_tangent| if is_tangent { 0.5 } else { 0.0 })
    } else {
        [0.0; 2]
    };
    let halves = ends[0] + ends[1];
    let least = if halves < 1.0 { 1.0 } else { 0.0 };
    let own = (curved.extent / step - halves - SAME_ANGLE).ceil().max(least);
    let width = curved.extent / (own + halves);
    let mut sectors = Vec::new();
    let mut from = curved.start;
    if ends[0] > 0.0 {
        sectors.push((from, [from, from + 0.5 * width]));
        from += 0.5 * width;
    }
    for _ in 0..own as usize {
        sectors.push((from + 0.5 * width, [from, from + width]));
        from += width;
    }
    if ends[1] > 0.0 {
        sectors.push((from + 0.5 * width, [from, from + 0.5 * width]));
    }
    sectors
}

/// Concave facets have their corners on the facets of the mesh: the smallest distance of these from the axis there,
/// relative to the radius.
fn corner_factor(curved: &Curved, sectors: &[(f64, [f64; 2])]) -> f64 {
    let at = |angle: f64| {
        let strips = curved.strips.iter().map(|(start, extent)| (turn(angle - start - 0.5 * extent), 0.5 * extent));
        strips
            .filter(|(from_middle, half)| from_middle.abs() <= half + SAME_ANGLE)
            .map(|(from_middle, half)| half.cos() / from_middle.abs().min(half).cos())
            .fold(1.0, f64::min)
    };
    sectors.iter().flat_map(|(_, sector)| *sector).map(at).fold(1.0, f64::min)
}

fn facet(curved: &Curved, middle: f64, sector: [f64; 2], factor: f64) -> Facet {
    let cone = &curved.cone;
    let half = (sector[1] - middle).max(middle - sector[0]);
    let scale = if curved.is_convex { 1.0 } else { factor * half.cos() };
    let outward = cone.outward(middle);
    let normal = (outward - cone.axis * (cone.slope * scale)).normalize();
    let plane = Plane::through(&(cone.origin + outward * (cone.radius * scale)), normal);
    Facet { plane: if curved.is_convex { plane } else { plane.flipped() }, middle, sector }
}

impl Facet {
    /// The part of a polygon on the curved surface that belongs to this facet.
    pub fn share(&self, curved: &Curved, polygon: &[Vector], tolerance: f64) -> Vec<Vector> {
        let cone = &curved.cone;
        // Sectors are narrower than half a turn, so that their two sides and the half around their middle bound them.
        let across = |angle: f64| Plane::through(&cone.origin, cone.outward(angle));
        let part = clip(polygon, &across(self.sector[1] + 0.5 * PI), tolerance);
        let part = clip(&part, &across(self.sector[0] - 0.5 * PI), tolerance);
        clip(&part, &across(self.middle).flipped(), tolerance)
    }
}
