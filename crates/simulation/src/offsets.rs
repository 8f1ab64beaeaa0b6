//! Offsets to inject (m, body frame).

use fastrand::Rng;
use nalgebra::Vector3;

use crate::grasp::Grasp;

/// All convex combinations of the planned offsets with weights that are multiples of `1 / divisions`, each offset once:
/// a grid in their hull with the planned offsets as its corners.
pub fn grid(planned: &[[f64; 3]], divisions: usize) -> Vec<[f64; 3]> {
    let mut found = Vec::new();
    let mut weights = vec![0; planned.len()];
    for_each_composition(&mut weights, 0, divisions, &mut |weights| {
        let terms = planned.iter().zip(weights);
        let sum: Vector3<f64> = terms.map(|(offset, &weight)| Vector3::from(*offset) * weight as f64).sum();
        found.push((sum / divisions as f64).into());
    });
    distinct(&found)
}

/// Number of combinations that [`grid`] goes through, before those that coincide are left out.
pub fn grid_size(planned: usize, divisions: usize) -> f64 {
    (1..planned).map(|index| (divisions + index) as f64 / index as f64).product()
}

/// Calls `visit` with every way to distribute `rest` over the entries from `position` on.
fn for_each_composition(weights: &mut Vec<usize>, position: usize, rest: usize, visit: &mut impl FnMut(&[usize])) {
    if position + 1 >= weights.len() {
        weights.iter_mut().skip(position).for_each(|last| *last = rest);
        visit(weights);
        return;
    }
    for weight in (0..=rest).rev() {
        weights[position] = weight;
        for_each_composition(weights, position + 1, rest - weight, visit);
    }
}

/// Random convex combinations of the planned offsets (Dirichlet weights, all equally likely).
pub fn hull(planned: &[[f64; 3]], count: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut random = Rng::with_seed(seed);
    let mut combination = || {
        let weights: Vec<f64> = planned.iter().map(|_| -(1.0 - random.f64()).ln()).collect();
        let total: f64 = weights.iter().sum();
        let terms = planned.iter().zip(&weights);
        terms.map(|(offset, weight)| Vector3::from(*offset) * (weight / total)).sum::<Vector3<f64>>().into()
    };
    (0..count).map(|_| combination()).collect()
}

/// Random offsets, uniform in a ball of a radius (m).
pub fn ball(radius: f64, count: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut random = Rng::with_seed(seed);
    let mut point = || loop {
        let point = Vector3::from_fn(|_, _| 2.0 * random.f64() - 1.0);
        if point.norm_squared() <= 1.0 {
            // Without negative zeros.
            return (point * radius).map(|component| component + 0.0).into();
        }
    };
    (0..count).map(|_| point()).collect()
}

/// The offsets without repetitions, in their order.
pub fn distinct(offsets: &[[f64; 3]]) -> Vec<[f64; 3]> {
    Grasp::distinct(offsets.iter().copied().map(Grasp::from)).into_iter().map(|grasp| grasp.offset).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLANNED: [[f64; 3]; 3] = [[0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [-0.02, 0.0, 0.0]];

    fn in_hull([x, y, z]: [f64; 3]) -> bool {
        z == 0.0 && y >= -1e-15 && x.abs() + y <= 0.02 + 1e-15
    }

    #[test]
    fn a_grid_has_the_planned_offsets_as_corners() {
        let offsets = grid(&PLANNED, 4);
        assert_eq!(offsets.len(), 15);
        assert!((grid_size(PLANNED.len(), 4) - 15.0).abs() < 1e-9);
        assert!(PLANNED.iter().all(|corner| offsets.contains(corner)));
        assert!(offsets.into_iter().all(in_hull));
        assert_eq!(grid(&PLANNED, 1).len(), 3);
        assert_eq!(grid(&PLANNED[..1], 3), PLANNED[..1]);
    }

    #[test]
    fn random_offsets_stay_inside_and_repeat_with_their_seed() {
        let offsets = hull(&PLANNED, 1000, 7);
        assert_eq!(offsets, hull(&PLANNED, 1000, 7));
        assert_ne!(offsets, hull(&PLANNED, 1000, 8));
        assert!(offsets.into_iter().all(in_hull));
        let offsets = ball(0.01, 1000, 7);
        assert_eq!(offsets, ball(0.01, 1000, 7));
        let lengths: Vec<f64> = offsets.iter().map(|offset| Vector3::from(*offset).norm()).collect();
        assert!(lengths.iter().all(|&length| length <= 0.01));
        // In a uniform ball half of the points lie beyond the cube root of 1/2 of the radius.
        let beyond = lengths.iter().filter(|&&length| length > 0.01 * 0.5_f64.cbrt()).count();
        assert!((400..600).contains(&beyond));
    }

    #[test]
    fn repetitions_are_left_out() {
        assert_eq!(distinct(&[[0.0; 3], [0.1, 0.0, 0.0], [0.0, 1e-12, 0.0]]), [[0.0; 3], [0.1, 0.0, 0.0]]);
    }
}
