//! Offsets to inject (m, body frame).
//!
//! At most [`MAX_COUNT`] offsets are allowed: callers refuse larger numbers with [`validate_count`].

use collision::Polytope;
use fastrand::Rng;
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use task::{Coverage, GraspError};

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
/// a grid in their hull with the planned offsets as its corners. At least one division is used; without planned offsets
/// the grid is empty. Check [`grid_size`] first.
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

/// Calls `visit` with every distribution of `total` over `count` entries, as the entries (index, share) that are not
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

/// Random covered offsets of up to a magnitude (m): for a hull, convex combinations of the planned ones, as [`hull`]
/// returns them. For a disc or a ball, the first [`rim_count`] have the full magnitude, in directions that are all
/// equally likely, because long ones fail first; the others are uniform inside.
pub fn covered(coverage: &Coverage, planned: &[[f64; 3]], magnitude: f64, count: usize, seed: u64) -> Vec<[f64; 3]> {
    if *coverage == Coverage::Hull {
        return hull(planned, count, seed);
    }
    let (span, mut random) = (coverage.span(), Rng::with_seed(seed));
    let mut offset = |index: usize| {
        let point = round_point(&span, &mut random);
        let is_on_rim = index < rim_count(count);
        plain(if is_on_rim { point.normalize() } else { point } * magnitude)
    };
    (0..count).map(&mut offset).collect()
}

/// How many of some random offsets of a disc or a ball have the full magnitude: half of them, rounded up.
pub fn rim_count(count: usize) -> usize {
    count.div_ceil(2)
}

/// Random offsets, uniform in a ball of a radius (m).
pub fn ball(radius: f64, count: usize, seed: u64) -> Vec<[f64; 3]> {
    let (span, mut random) = (Coverage::Ball.span(), Rng::with_seed(seed));
    (0..count).map(|_| plain(round_point(&span, &mut random) * radius)).collect()
}

/// Random rotation errors (rotation vectors, rad) for the random offsets of the same seed, uniform in a ball.
pub fn rotations(largest: f64, count: usize, seed: u64) -> Vec<[f64; 3]> {
    /// Distance between the seeds of rotations and of offsets, which must be independent.
    const ROTATION_SEED: u64 = 50;
    ball(largest, count, seed.wrapping_add(ROTATION_SEED))
}

/// A point uniform in the unit disc or ball that orthonormal vectors span, but for its centre, which has no direction.
fn round_point(span: &[Vector3<f64>], random: &mut Rng) -> Vector3<f64> {
    loop {
        let point: Vector3<f64> = span.iter().map(|axis| axis * (2.0 * random.f64() - 1.0)).sum();
        let square = point.norm_squared();
        if square > f64::MIN_POSITIVE && square <= 1.0 {
            return point;
        }
    }
}

/// Without negative zeros.
fn plain(offset: Vector3<f64>) -> [f64; 3] {
    offset.map(|component| component + 0.0).into()
}

/// Length (m) up to which offsets in every direction that the planned ones span lie in their hull; zero where no offset
/// lies inside it.
pub fn worst_direction(planned: &[[f64; 3]]) -> f64 {
    let planned: Vec<Vector3<f64>> = planned.iter().copied().map(Vector3::from).collect();
    let longest = planned.iter().map(Vector3::norm).fold(0.0, f64::max);
    if longest == 0.0 || !planned.iter().all(|offset| offset.norm().is_finite()) {
        return 0.0;
    }
    let unit: Vec<Vector3<f64>> = planned.iter().map(|offset| offset / longest).collect();
    // Where the planned offsets span no direction, the hull is made longer than anywhere else.
    let widened = directions_across(&unit).iter().fold(unit, |points, direction| {
        points.iter().flat_map(|point| [point + 2.0 * direction, point - 2.0 * direction]).collect()
    });
    let vertices: Vec<[f64; 3]> = widened.into_iter().map(Into::into).collect();
    let Ok(hull) = Polytope::from_vertices(&vertices) else { return 0.0 };
    longest * hull.offsets().iter().copied().fold(f64::INFINITY, f64::min).max(0.0)
}

/// Orthonormal vectors across all offsets, of which the longest has unit length.
fn directions_across(offsets: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    /// Length that may be rounding.
    const FLAT: f64 = 1e-6;
    let moments: Matrix3<f64> = offsets.iter().map(|offset| offset * offset.transpose()).sum();
    let SymmetricEigen { eigenvalues, eigenvectors } = moments.symmetric_eigen();
    let is_flat = |axis: &usize| eigenvalues[*axis].max(0.0).sqrt() <= FLAT;
    (0..3).filter(is_flat).map(|axis| eigenvectors.column(axis).into_owned()).collect()
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
    fn a_disc_is_drawn_uniformly_and_half_on_its_rim() {
        let axis = [0.48, 0.6, 0.64];
        let draw = |coverage: &Coverage, seed: u64| covered(coverage, &PLANNED, 0.01, 4001, seed);
        for (coverage, dimension) in [(Coverage::Disc { axis }, 2), (Coverage::Ball, 3)] {
            let offsets = draw(&coverage, 7);
            assert_eq!(offsets, draw(&coverage, 7));
            assert_ne!(offsets, draw(&coverage, 8));
            let points: Vec<Vector3<f64>> = offsets.into_iter().map(Vector3::from).collect();
            let (rim, inside) = points.split_at(2001);
            assert!(rim.iter().all(|point| (point.norm() - 0.01).abs() < 1e-15));
            assert!(inside.iter().all(|point| point.norm() < 0.01));
            let along = points.iter().map(|point| point.dot(&Vector3::from(axis)).abs()).fold(0.0, f64::max);
            assert!(if dimension == 2 { along < 1e-15 } else { along > 0.009 }, "{along}");
            // Half of what is uniform lies within this length, half of everything on either side of a plane.
            let half = 0.01 * 0.5_f64.powf(1.0 / f64::from(dimension));
            let near = inside.iter().filter(|point| point.norm() < half).count();
            assert!((900..1100).contains(&near), "{near}");
            for points in [rim, inside] {
                for direction in coverage.span() {
                    let count = points.iter().filter(|point| point.dot(&direction) > 0.0).count();
                    assert!((900..1100).contains(&count), "{count}");
                }
            }
        }
    }

    #[test]
    fn one_random_offset_of_a_disc_is_on_its_rim_and_those_of_a_hull_are_in_it() {
        let axis = [0.0, 0.0, 1.0];
        let [offset] = covered(&Coverage::Disc { axis }, &[], 0.01, 1, 3)[..] else { panic!() };
        assert!((Vector3::from(offset).norm() - 0.01).abs() < 1e-15);
        assert_eq!(covered(&Coverage::Hull, &PLANNED, 0.01, 5, 3), hull(&PLANNED, 5, 3));
        assert!(covered(&Coverage::Ball, &[], 0.01, 0, 3).is_empty());
        assert_eq!(covered(&Coverage::Ball, &[], 0.0, 2, 3), [[0.0; 3]; 2]);
    }

    /// Rotations as the points of a ball, which do not follow the offsets of the same seed.
    #[test]
    fn turns_and_offsets_of_one_seed_are_independent() {
        let (offsets, rotated) = (ball(1.0, 2000, 7), rotations(1.0, 2000, 7));
        let products = offsets
            .iter()
            .zip(&rotated)
            .map(|(offset, rotation)| Vector3::from(*offset).dot(&Vector3::from(*rotation)));
        let mean = products.sum::<f64>() / 2000.0;
        assert!(mean.abs() < 0.05, "{mean}");
        assert_eq!(rotations(0.0, 3, u64::MAX), [[0.0; 3]; 3]);
    }

    #[test]
    fn the_worst_direction_of_a_hull_is_that_of_its_nearest_side() {
        let regular = |count: usize| -> Vec<[f64; 3]> {
            let angles = (0..count).map(|index| std::f64::consts::TAU * index as f64 / count as f64);
            // In a plane that lies askew.
            angles.map(|angle| [0.6 * angle.cos(), angle.sin(), 0.8 * angle.cos()].map(|c| 8e-4 * c)).collect()
        };
        let octahedron: Vec<[f64; 3]> =
            Coverage::Ball.span().iter().flat_map(|axis| [*axis, -axis].map(Into::into)).collect();
        let with_none = [regular(3), vec![[0.0; 3]]].concat();
        for (planned, expected) in [
            (regular(3), 4e-4),
            (with_none, 4e-4),
            (regular(4), 8e-4 * 0.5_f64.sqrt()),
            (regular(6), 8e-4 * 0.75_f64.sqrt()),
            (octahedron, 3_f64.sqrt().recip()),
            (vec![[0.0, 0.003, 0.004], [0.0, -0.006, -0.008]], 0.005),
            (vec![[0.01, 0.0, 0.0], [0.0, 0.01, 0.0]], 0.0),
            (PLANNED.to_vec(), 0.0),
            (vec![[0.0, 0.0, 0.01]], 0.0),
            (vec![[0.0; 3]], 0.0),
            (vec![], 0.0),
            (vec![[f64::NAN; 3], [0.01, 0.0, 0.0]], 0.0),
        ] {
            let actual = worst_direction(&planned);
            assert!((actual - expected).abs() < 1e-6 * expected + 1e-12, "{planned:?}: {actual}, not {expected}");
        }
    }

    #[test]
    fn repetitions_are_left_out() {
        assert_eq!(distinct(&[[0.0; 3], [0.1, 0.0, 0.0], [0.0, 1e-12, 0.0]]), [[0.0; 3], [0.1, 0.0, 0.0]]);
    }
}
