//! Offsets to inject (m, body frame).
//!
//! Numbers of offsets are at most [`MAX_COUNT`]: callers refuse larger ones with [`validate_count`].

use fastrand::Rng;
use nalgebra::Vector3;
use task::GraspError;

use crate::settings_error::{SettingsError, check};

/// Largest number of offsets.
pub const MAX_COUNT: usize = 1_000_000;

/// Whether a number of offsets, such as a [`grid_size`], is at most [`MAX_COUNT`].
///
/// # Errors
/// When it is larger, with `field` as its name.
pub fn validate_count(field: &'static str, count: f64) -> Result<(), SettingsError> {
    check(field, count, &(0.0..=MAX_COUNT as f64), "")
}

/// All convex combinations of the planned offsets with weights that are multiples of `1 / divisions`, each offset once:
/// a grid in their hull with the planned offsets as its corners. There is at least one division; no planned offsets
/// have no grid. Go ahead only if [`grid_size`] is valid.
pub fn grid(planned: &[[f64; 3]], divisions: usize) -> Vec<[f64; 3]> {
    let divisions = divisions.max(1);
    let mut found = Vec::new();
    for_each_composition(planned.len(), divisions, |weights| {
        let terms = weights.iter().map(|&(index, weight)| Vector3::from(planned[index]) * weight as f64);
        found.push((terms.sum::<Vector3<f64>>() / divisions as f64).into());
    });
    distinct(&found)
}

/// Number of combinations that [`grid`] goes through, before those that coincide are left out.
pub fn grid_size(planned: usize, divisions: usize) -> f64 {
    let (fewer, more) = (planned.saturating_sub(1).min(divisions), planned.saturating_sub(1).max(divisions));
    // Every factor is at least 2: beyond 1024 of them the product is infinite.
    (1..=fewer.min(1024)).map(|index| (more as f64 + index as f64) / index as f64).product()
}

/// Calls `visit` with every way to distribute `total` over `count` entries, as the entries (index, share) that are not
/// zero: from all for the first entry to all for the last.
fn for_each_composition(count: usize, total: usize, mut visit: impl FnMut(&[(usize, usize)])) {
    let Some(last) = count.checked_sub(1) else { return };
    let mut shares = vec![(0, total)];
    loop {
        visit(&shares);
        // One unit moves on to the next entry, and all of the last entry with it.
        let rest = shares.pop_if(|(index, _)| *index == last).map_or(0, |(_, share)| share);
        let Some((index, share)) = shares.pop() else { return };
        if share > 1 {
            shares.push((index, share - 1));
        }
        shares.push((index + 1, rest + 1));
    }
}

/// Random convex combinations of the planned offsets, at least one (Dirichlet weights, all equally likely).
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
    GraspError::distinct(offsets.iter().copied().map(GraspError::from)).into_iter().map(|grasp| grasp.offset).collect()
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
    fn a_grid_may_be_fine_or_have_many_corners() {
        let many: Vec<[f64; 3]> = (0..200_000).map(|index| [1e-5 * index as f64, 0.0, 0.0]).collect();
        assert_eq!(grid(&many, 1), many);
        let fine = grid(&PLANNED[..2], 200_000);
        assert_eq!(fine.len(), 200_001);
        assert!(fine.into_iter().all(in_hull));
        assert_eq!(grid(&PLANNED, 0), PLANNED);
        assert!(grid(&[], 3).is_empty());
    }

    #[test]
    fn sizes_of_grids_are_binomial_coefficients_of_any_size() {
        for (planned, divisions, size) in
            [(0, 5, 1.0), (1, 5, 1.0), (2, 1_000_000, 1_000_001.0), (4, 10, 286.0), (20, 3, 1540.0)]
        {
            let actual = grid_size(planned, divisions);
            assert!((actual / size - 1.0).abs() < 1e-12, "{planned} offsets, {divisions} divisions: {actual}");
            assert_eq!(validate_count("grid", actual).is_ok(), size <= 1e6);
        }
        assert_eq!(grid_size(usize::MAX, usize::MAX), f64::INFINITY);
        assert_eq!(grid_size(usize::MAX, 0), 1.0);
        let error = validate_count("random", 2e6).unwrap_err().to_string();
        assert_eq!(error, "random = 2000000: must lie in [0, 1000000]");
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
