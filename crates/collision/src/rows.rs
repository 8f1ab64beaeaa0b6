//! The rows of the distance problem at a pose (Eq. sdfopt).

use pulp::Simd;

use crate::interior_point::Row;
use crate::lane::{Lane, Vector, array, dot, rotate};
use crate::polytope::Polytope;
use crate::pose_chart::Placement;

/// Fills `rows` with the halfspaces of both parts in world axes, the body's first, and the duals of the cold start.
/// Returns the point midway between the parts' centres.
#[inline(always)]
pub fn fill<S: Simd>(
    simd: S,
    rows: &mut Vec<Row<S>>,
    body: &Polytope,
    environment: &Polytope,
    place: &Placement<S>,
) -> Vector<S> {
    let splat = |vector: &[f64; 3]| -> Vector<S> { array!(|axis| Lane::splat(simd, vector[axis])) };
    rows.clear();
    for ((normal, &offset), &weight) in halfspaces(body) {
        let normal = rotate(&place.rotation, &splat(normal));
        let offset = dot(&normal, &place.position) + Lane::splat(simd, offset);
        rows.push(Row::new(normal, offset, Lane::splat(simd, weight)));
    }
    for ((normal, &offset), &weight) in halfspaces(environment) {
        rows.push(Row::new(splat(normal), Lane::splat(simd, offset), Lane::splat(simd, weight)));
    }
    let turned = rotate(&place.rotation, &splat(&body.center()));
    let fixed = splat(&environment.center());
    let half = Lane::splat(simd, 0.5);
    array!(|axis| half * (turned[axis] + place.position[axis] + fixed[axis]))
}

fn halfspaces(part: &Polytope) -> impl Iterator<Item = ((&[f64; 3], &f64), &f64)> {
    part.normals().iter().zip(part.offsets()).zip(part.center_weights())
}
