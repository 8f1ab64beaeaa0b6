//! The contact frame, with axes along the rows that determine the solution. In exact face-to-face contact the entries
//! of the Newton matrix differ by many orders of magnitude. In this frame they do not mix, and derivatives stay
//! accurate.

use pulp::Simd;

use crate::interior_point::Row;
use crate::lane::{Lane, Vector, array, cross, dot, rotate};

/// Rotates all normals into the contact frame and returns its axes. The z axis is the normal of the row with the
/// largest curvature; the x axis points along the tangential component of the row with the largest tangential
/// curvature.
#[inline(always)]
pub fn enter<S: Simd>(simd: S, rows: &mut [Row<S>]) -> [Vector<S>; 3] {
    let zero = Lane::splat(simd, 0.0);
    let mut z = [zero, zero, Lane::splat(simd, 1.0)];
    let mut largest = zero;
    for row in rows.iter() {
        let curvature = row.curvature();
        let larger = largest.less_than(curvature);
        largest = curvature.select(larger, largest);
        z = array!(|axis| row.normal[axis].select(larger, z[axis]));
    }
    let mut x = z;
    let mut largest = Lane::splat(simd, -1.0);
    for row in rows.iter() {
        let along = dot(&z, &row.normal);
        let tangential: Vector<S> = array!(|axis| along.mul_sub_from(z[axis], row.normal[axis]));
        let curvature = row.curvature() * dot(&tangential, &tangential);
        let larger = largest.less_than(curvature);
        largest = curvature.select(larger, largest);
        x = array!(|axis| tangential[axis].select(larger, x[axis]));
    }
    let z = unit(&z);
    let along = dot(&z, &x);
    let x = unit(&array!(|axis| along.mul_sub_from(z[axis], x[axis])));
    let frame = [x, cross(&z, &x), z];
    for row in rows {
        row.normal = rotate(&frame, &row.normal);
    }
    frame
}

#[inline(always)]
fn unit<S: Simd>(vector: &Vector<S>) -> Vector<S> {
    let scale = dot(vector, vector).sqrt().recip();
    array!(|axis| vector[axis] * scale)
}
