//! Outer shells, voids and bodies in voids.

use crate::error::MeshError;
use crate::geometry::{Vector, area_vector, bounds, boxes_meet, mean};
use crate::surface::Surface;

/// Triangles of a shell that are asked whether they are inside of another.
const WITNESSES: usize = 16;
/// They are asked this many tolerances away from the surface.
const NEAR: f64 = 10.0;

/// Half the solid angle under which a triangle is seen from a point, positive from behind: its cosine and its sine, both
/// times the same positive number.
pub fn half_solid_angle(point: &Vector, triangle: &[Vector; 3]) -> (f64, f64) {
    let [a, b, c] = triangle.map(|corner| corner - point);
    let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
    (la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb, a.dot(&b.cross(&c)))
}

/// The solid angle (sr).
fn solid_angle(point: &Vector, triangle: &[Vector; 3]) -> f64 {
    let (cosine, sine) = half_solid_angle(point, triangle);
    2.0 * sine.atan2(cosine)
}

/// How often a closed surface runs around a point.
pub fn winding_number(point: &Vector, triangles: impl Iterator<Item = [Vector; 3]>) -> f64 {
    triangles.map(|triangle| solid_angle(point, &triangle)).sum::<f64>() / (4.0 * std::f64::consts::PI)
}

/// Numbers of shells that were changed.
pub struct Oriented {
    /// Turned inside out.
    pub turned: usize,
    /// Dropped, as they enclose nothing.
    pub flat: usize,
}

/// Turns shells whose outside is inside and drops those without volume.
///
/// # Errors
/// When nothing is enclosed, a shell is partly inside of another, or an inner shell is oriented like the one around it.
pub fn orient(surface: &mut Surface, scale: f64, tolerance: f64) -> Result<Oriented, MeshError> {
    let shells = surface.shells();
    let corners = |triangle: usize| surface.triangles[triangle].map(|corner| surface.vertices[corner]);
    let boxes: Vec<[Vector; 2]> = shells
        .iter()
        .map(|shell| bounds(&shell.iter().flat_map(|&triangle| corners(triangle)).collect::<Vec<_>>()))
        .collect();
    let mut depths = Vec::with_capacity(shells.len());
    for (index, shell) in shells.iter().enumerate() {
        // On both sides of a triangle: where shells touch, one of the two is inside and tells nothing.
        let sides = |&triangle: &usize| {
            let corners = corners(triangle);
            let step = area_vector(&corners).try_normalize(0.0).unwrap_or_default() * (NEAR * tolerance);
            [mean(&corners) - step, mean(&corners) + step]
        };
        let points: Vec<[Vector; 2]> = shell.iter().take(WITNESSES).map(sides).collect();
        let mut depth = 0;
        for other in (0..shells.len()).filter(|&other| other != index && boxes_meet(&boxes[index], &boxes[other], 0.0))
        {
            let is_around = |point: &Vector| {
                winding_number(point, shells[other].iter().map(|&triangle| corners(triangle))).abs() > 0.5
            };
            let both = points.iter().map(|sides| (sides, sides.each_ref().map(is_around)));
            let telling = || both.clone().filter(|(_, [behind, before])| behind == before);
            let inside = telling().find(|(_, [behind, _])| *behind);
            if let (Some((sides, _)), true) = (inside, telling().any(|(_, [behind, _])| !behind)) {
                return Err(MeshError::SelfIntersecting { place: (sides[0] / scale).into() });
            }
            depth += usize::from(inside.is_some());
        }
        depths.push(depth);
    }
    let volume = |shell: &Vec<usize>, bounds: &[Vector; 2]| {
        let center = 0.5 * (bounds[0] + bounds[1]);
        let tetrahedra = shell.iter().map(|&triangle| corners(triangle).map(|corner| corner - center));
        tetrahedra.map(|[a, b, c]| a.dot(&b.cross(&c)) / 6.0).sum::<f64>()
    };
    let volumes: Vec<f64> = shells.iter().zip(&boxes).map(|(shell, bounds)| volume(shell, bounds)).collect();
    let is_flat = |index: usize| {
        let size = (boxes[index][1] - boxes[index][0]).amax();
        volumes[index].abs() <= tolerance * size * size * 0.1
    };
    let solid: Vec<usize> = (0..shells.len()).filter(|&index| !is_flat(index)).collect();
    if solid.is_empty() {
        return Err(MeshError::Flat);
    }
    let is_outward = |index: usize| (volumes[index] > 0.0) == (depths[index] % 2 == 0);
    let outer: Vec<usize> = solid.iter().copied().filter(|&index| depths[index] == 0).collect();
    let is_inverted = !outer.is_empty() && outer.iter().all(|&index| !is_outward(index));
    let mut turned: Vec<usize> = Vec::new();
    for &index in &solid {
        if is_outward(index) {
            if is_inverted && depths[index] > 0 {
                return Err(MeshError::Nested { place: (corners(shells[index][0])[0] / scale).into() });
            }
        } else if depths[index] == 0 || is_inverted {
            turned.push(index);
        } else {
            return Err(MeshError::Nested { place: (corners(shells[index][0])[0] / scale).into() });
        }
    }
    for &index in &turned {
        shells[index].iter().for_each(|&triangle| surface.triangles[triangle].swap(1, 2));
    }
    // Shells without volume, such as gaps that were closed, are no part of the solid.
    let mut is_kept = vec![false; surface.triangles.len()];
    solid.iter().flat_map(|&index| &shells[index]).for_each(|&triangle| is_kept[triangle] = true);
    let mut kept = is_kept.iter();
    surface.triangles.retain(|_| kept.next() == Some(&true));
    Ok(Oriented { turned: turned.len(), flat: shells.len() - solid.len() })
}
