//! Surface that hangs loose: sheets across holes, and rims that were moved away from each other.

use crate::edges::{Side, components, edges};
use crate::geometry::{Vector, bounds, mean};
use crate::repair::holes;
use crate::surface::{Repair, Surface};

/// Rims are joined that are apart by no more than this share of the part's size and of their shortest edge.
const APART: f64 = 2e-3;
const OF_EDGE: f64 = 0.25;

/// Drops sheets: surface that ends all around at edges of one other surface, which is closed without it.
pub fn drop_sheets(surface: &mut Surface, scale: f64) {
    let edges = edges(&surface.triangles);
    let smooth = edges.with_two_sides();
    if smooth.len() == edges.len() {
        return;
    }
    let patches = components(surface.triangles.len(), &smooth);
    let mut patch_of = vec![0; surface.triangles.len()];
    for (patch, triangles) in patches.iter().enumerate() {
        triangles.iter().for_each(|&triangle| patch_of[triangle] = patch);
    }
    let mut is_sheet = vec![false; patches.len()];
    for (patch, is_sheet) in is_sheet.iter_mut().enumerate() {
        let ends = edges
            .iter()
            .map(|(_, sides)| sides)
            .filter(|sides| sides.len() != 2 && sides.iter().any(|side| patch_of[side.triangle] == patch));
        let is_end = |sides: &[Side]| {
            let others: Vec<_> = sides.iter().filter(|side| patch_of[side.triangle] != patch).collect();
            matches!(others[..], [one, other] if sides.len() == 3
                && patch_of[one.triangle] == patch_of[other.triangle])
        };
        let mut ends = ends.peekable();
        *is_sheet = ends.peek().is_some() && ends.all(is_end);
    }
    for (triangles, _) in patches.iter().zip(&is_sheet).filter(|(_, is_sheet)| **is_sheet) {
        let corners = triangles.iter().flat_map(|&triangle| surface.triangles[triangle]);
        let place = mean(corners.map(|corner| &surface.vertices[corner])) / scale;
        surface.repairs.push(Repair::Sheet { place: place.into(), triangles: triangles.len() });
    }
    let mut patch_of = patch_of.into_iter();
    surface.triangles.retain(|_| patch_of.next().is_some_and(|patch| !is_sheet[patch]));
}

/// Joins rims of the same number of edges that lie side by side, such as those of a hole and of its wall.
pub fn join_rims(surface: &mut Surface, scale: f64) {
    let edges = edges(&surface.triangles);
    let rims = holes(&edges);
    if rims.len() < 2 {
        return;
    }
    let [low, high] = bounds(&surface.vertices);
    let most = APART * (high - low).amax();
    let mut is_joined = vec![false; rims.len()];
    for one in 0..rims.len() {
        for other in one + 1..rims.len() {
            if is_joined[one] || is_joined[other] {
                continue;
            }
            let Some((partners, moved)) = partners(&rims[one], &rims[other], &surface.vertices, most) else { continue };
            (is_joined[one], is_joined[other]) = (true, true);
            let place = mean(rims[one].iter().map(|&corner| &surface.vertices[corner])) / scale;
            surface.repairs.push(Repair::Joined { place: place.into(), edges: rims[one].len(), moved });
            for (&corner, partner) in rims[other].iter().zip(partners) {
                surface.vertices[corner] = surface.vertices[partner];
                let own = surface.triangles.iter_mut().flatten().filter(|own| **own == corner);
                own.for_each(|own| *own = partner);
            }
        }
    }
}

/// For each corner of a rim the one of another rim beside it, and how far they are apart at most (m).
fn partners(one: &[usize], other: &[usize], vertices: &[Vector], most: f64) -> Option<(Vec<usize>, f64)> {
    let shortest = |rim: &[usize]| {
        let edges = (0..rim.len()).map(|at| (vertices[rim[at]] - vertices[rim[(at + 1) % rim.len()]]).norm());
        edges.fold(f64::INFINITY, f64::min)
    };
    if one.len() != other.len() || one.iter().any(|corner| other.contains(corner)) {
        return None;
    }
    let most = most.min(OF_EDGE * shortest(one).min(shortest(other)));
    let mut moved = 0.0_f64;
    let mut partners = Vec::with_capacity(other.len());
    for &corner in other {
        let apart = |partner: &usize| (vertices[*partner] - vertices[corner]).norm();
        let partner = one.iter().copied().min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        if !(apart(&partner) <= most) || partners.contains(&partner) {
            return None;
        }
        moved = moved.max(apart(&partner));
        partners.push(partner);
    }
    Some((partners, moved))
}
