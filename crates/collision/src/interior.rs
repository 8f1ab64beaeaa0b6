//! Points inside intersections of halfspaces, by the logarithmic barrier.

use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};

use crate::facet::Facet;

/// Newton steps that no reasonable part needs.
const MOST_STEPS: usize = 100;

/// Minimises `-sum log(offset - normal x)` by damped Newton steps from a point inside.
pub fn analytic_center(facets: &[Facet], inside: Vector3<f64>) -> Vector3<f64> {
    let mut center = inside;
    for _ in 0..MOST_STEPS {
        let (gradient, hessian) = barrier(facets, &center);
        let Some(step) = hessian.cholesky().map(|factor| factor.solve(&-gradient)) else { break };
        let decrement = (-step.dot(&gradient)).max(0.0).sqrt();
        center += step * if decrement > 0.25 { 1.0 / (1.0 + decrement) } else { 1.0 };
        if decrement < 1e-14 {
            break;
        }
    }
    center
}

/// Gradient and Hessian of the barrier at a point inside.
pub fn barrier(facets: &[Facet], point: &Vector3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let (mut gradient, mut hessian) = (Vector3::zeros(), Matrix3::zeros());
    for facet in facets {
        let weight = 1.0 / (facet.offset - facet.normal.dot(point));
        gradient += facet.normal * weight;
        hessian += facet.normal * facet.normal.transpose() * (weight * weight);
    }
    (gradient, hessian)
}

/// A point strictly inside all halfspaces, `None` when the least depth that any point can have is not above `accuracy` (m).
///
/// All halfspaces are moved outward until the origin is inside, and the move is then undone along the central path of
/// the linear program whose variables are the point and the move.
pub fn point_inside(halfspaces: &[Facet], accuracy: f64) -> Option<Vector3<f64>> {
    const GROWTH: f64 = 8.0;
    let farthest = halfspaces.iter().map(|facet| facet.offset.abs()).fold(accuracy, f64::max);
    let mut point = Vector4::new(0.0, 0.0, 0.0, 2.0 * farthest);
    let count = halfspaces.len() as f64;
    let mut gap = count * farthest;
    // A minimiser of the barrier with the gap `g` is at most `g` above the optimum.
    while gap > accuracy {
        for _ in 0..MOST_STEPS {
            let (mut gradient, mut hessian) = (Vector4::new(0.0, 0.0, 0.0, count / gap), Matrix4::zeros());
            for facet in halfspaces {
                let row = facet.normal.push(-1.0);
                let weight = 1.0 / (facet.offset - row.dot(&point));
                gradient += row * weight;
                hessian += row * row.transpose() * (weight * weight);
            }
            let step = hessian.cholesky()?.solve(&-gradient);
            let decrement = (-step.dot(&gradient)).max(0.0).sqrt();
            point += step / (1.0 + decrement);
            if decrement < 0.25 {
                break;
            }
        }
        if point[3] < 0.0 {
            return Some(point.xyz());
        }
        gap /= GROWTH;
    }
    None
}
