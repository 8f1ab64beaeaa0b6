//! Inside and outside of surfaces that cross themselves or do not quite close.

use workers::Workers;

use crate::body::Body;
use crate::edges::{components, edges};
use crate::error::MeshError;
use crate::geometry::{Vector, area_vector, bounds, mean};
use crate::read::TriangleMesh;
use crate::repair::{SAME, wind};
use crate::superfluous::without_copies;
use crate::surface::{Repair, Surface};
use crate::weld::weld;
use crate::winding::Winding;

/// Both sides of triangles are asked this many tolerances away.
const NEAR: f64 = 10.0;
/// Cracks must be narrower than this share of the part's size.
const CRACK: f64 = 2e-4;
/// A winding number that is farther than this from a whole number says nothing.
const UNDECIDED: f64 = 0.25;
/// Triangles are asked in the middle, and this far towards their corners.
const NEARLY: f64 = 0.98;
/// Triangles that one thread asks together.
const CHUNK: usize = 200;
/// Share of the surface that may be folded over.
const REVERSED: f64 = 1e-2;
/// Surfaces with more shells of negative volume are refused.
const MOST_NEGATIVE: usize = 64;
/// Triangles of such a shell at which its location is tested.
const WITNESSES: usize = 32;
/// Surfaces with more open edges are refused.
const MOST_OPEN: usize = 20_000;

/// The surface between inside and outside: winding numbers say which is which.
///
/// # Errors
/// With `reason`, why the surface cannot be taken as it is, when it leaves a place undecided.
pub fn decide(mesh: &TriangleMesh, reason: MeshError) -> Result<Surface, MeshError> {
    let tolerance = SAME * mesh.rounding;
    let (vertices, index) = weld(&mesh.vertices, tolerance);
    let welded = mesh.triangles.iter().map(|corners| corners.map(|corner| index[corner]));
    let whole: Vec<[usize; 3]> = welded.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    let mut surface = Surface { vertices, triangles: without_copies(whole), repairs: Vec::new() };
    // One side only: then as the file has it.
    let _ = wind(&mut surface, mesh.scale);
    let Surface { vertices, mut triangles, .. } = surface;
    let corners = |triangle: &[usize; 3]| triangle.map(|corner| vertices[corner]);
    let Some(turned) = outward(&mut triangles, &vertices) else { return Err(reason) };
    let body = Body::new(triangles.iter().map(corners).collect());
    let [low, high] = bounds(&vertices);
    let crack = CRACK * (high - low).amax() + NEAR * tolerance;
    let open = open_edges(&triangles);
    if open.len() > MOST_OPEN || open.iter().any(|edge| is_undecided(edge, &triangles, &vertices, &body, crack)) {
        return Err(reason);
    }
    let decided = |triangle: &[usize; 3]| Decision::of(&corners(triangle), &body, NEAR * tolerance);
    let chunks =
        Workers::of_all_processors().map(triangles.chunks(CHUNK), |own| own.iter().map(decided).collect::<Vec<_>>());
    let (mut reversed, mut sound) = (0.0, 0.0);
    let (mut hidden, mut kept) = (0, Vec::with_capacity(triangles.len()));
    for (triangle, decision) in triangles.into_iter().zip(chunks.concat()) {
        match decision {
            Decision::Outward => sound += area_vector(&corners(&triangle)).norm(),
            Decision::Inward => reversed += area_vector(&corners(&triangle)).norm(),
            Decision::Crossing => {}
            Decision::Hidden => {
                hidden += 1;
                continue;
            }
            Decision::Flat => continue,
        }
        kept.push(triangle);
    }
    if kept.is_empty() || reversed > REVERSED * sound {
        return Err(reason);
    }
    let mut repairs = Vec::new();
    if turned > 0 {
        repairs.push(Repair::Inverted { shells: turned });
    }
    repairs.push(Repair::Decided {
        reason: Box::new(reason),
        open: open.len(),
        crack: if open.is_empty() { 0.0 } else { crack },
        hidden,
    });
    Ok(Surface { vertices, triangles: kept, repairs })
}

/// What is on both sides of a triangle: the inside, the outside, or the same.
#[derive(Debug, Clone, Copy)]
enum Decision {
    /// The inside behind it, the outside in front of it.
    Outward,
    /// The other way around.
    Inward,
    /// The same in its middle, but not everywhere: part of it may be outside.
    Crossing,
    /// The same.
    Hidden,
    /// It has no area.
    Flat,
}

impl Decision {
    /// Of a triangle, asked at a distance (m) from it.
    fn of(corners: &[Vector; 3], body: &Body, near: f64) -> Self {
        let Some(normal) = area_vector(corners).try_normalize(0.0) else { return Self::Flat };
        let middle = mean(corners);
        let sides = |point: &Vector| [-1.0, 1.0].map(|side| body.contains(&(point + normal * (side * near))));
        match sides(&middle) {
            [true, false] => Self::Outward,
            [false, true] => Self::Inward,
            _ => {
                let mut nearly = corners.iter().map(|corner| sides(&(middle + NEARLY * (corner - middle))));
                if nearly.any(|[behind, before]| behind != before) { Self::Crossing } else { Self::Hidden }
            }
        }
    }
}

/// Edges that do not have as many triangles on the one side as on the other, each with one of its triangles.
fn open_edges(triangles: &[[usize; 3]]) -> Vec<((usize, usize), usize)> {
    let mut open = Vec::new();
    for (edge, sides) in edges(triangles).iter() {
        if 2 * sides.iter().filter(|side| side.is_forward).count() != sides.len() {
            open.push((edge, sides[0].triangle));
        }
    }
    open
}

/// Whether the winding number is no whole number at a distance (m) from an open edge: in the four directions between its
/// triangle and the normal of that, where points are on no surface that ends there.
fn is_undecided(
    ((from, to), triangle): &((usize, usize), usize),
    triangles: &[[usize; 3]],
    vertices: &[Vector],
    body: &Body,
    distance: f64,
) -> bool {
    let [from, to] = [vertices[*from], vertices[*to]];
    let normal = area_vector(&triangles[*triangle].map(|corner| vertices[corner])).try_normalize(0.0);
    let (Some(normal), Some(along)) = (normal, (to - from).try_normalize(0.0)) else { return false };
    let across = normal.cross(&along);
    let steps = [normal + across, normal - across, across - normal, -normal - across];
    steps.iter().any(|step| {
        let number = body.winding_number(&(0.5 * (from + to) + step * distance));
        (number - number.round()).abs() > UNDECIDED
    })
}

/// Turns shells inside out that enclose a negative volume and lie in no other; those inside of others are voids. `None`
/// where such a shell crosses others: nobody knows which of both it is.
fn outward(triangles: &mut [[usize; 3]], vertices: &[Vector]) -> Option<usize> {
    let shells = components(triangles.len(), &edges(triangles));
    let corners = |triangles: &[[usize; 3]], triangle: usize| triangles[triangle].map(|corner| vertices[corner]);
    let mut negative = Vec::new();
    for shell in &shells {
        let own = shell.iter().map(|&triangle| corners(triangles, triangle).map(|corner| corner - vertices[0]));
        if own.map(|[a, b, c]| a.dot(&b.cross(&c))).sum::<f64>() < 0.0 {
            negative.push(shell);
        }
    }
    if negative.len() > MOST_NEGATIVE {
        return None;
    }
    let mut turned = 0;
    for shell in negative {
        let mut is_own = vec![false; triangles.len()];
        shell.iter().for_each(|&triangle| is_own[triangle] = true);
        let others = (0..triangles.len()).filter(|&triangle| !is_own[triangle]);
        let others = Winding::new(others.map(|triangle| corners(triangles, triangle)).collect());
        let stride = shell.len().div_ceil(WITNESSES);
        let witnesses: Vec<&usize> = shell.iter().step_by(stride).collect();
        let is_inside = |triangle: &&&usize| others.number(&mean(&corners(triangles, ***triangle))) > 0.5;
        match witnesses.iter().filter(is_inside).count() {
            0 => {
                shell.iter().for_each(|&triangle| triangles[triangle].swap(1, 2));
                turned += 1;
            }
            inside if inside == witnesses.len() => {}
            _ => return None,
        }
    }
    Some(turned)
}
