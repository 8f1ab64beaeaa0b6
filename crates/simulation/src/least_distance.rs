//! The nearest point of a polyhedron in velocity space: what a contact problem without restitution comes down to.

use nalgebra::{SMatrix, SVector};

/// Velocities in coordinates in which the kinetic energy is half the squared norm.
pub type Vector6 = SVector<f64, 6>;

/// The halfspace `normal u >= bound`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Halfspace {
    pub normal: Vector6,
    pub bound: f64,
}

/// The point of the halfspaces' intersection that is nearest to `target`, with the multipliers of those that hold it:
/// `u = target + sum multiplier normal`.
#[derive(Debug, Clone, Default)]
pub struct LeastDistance {
    /// Index of a halfspace and its positive multiplier.
    pub active: Vec<(usize, f64)>,
    excluded: Vec<bool>,
}

/// Violations below this are rounding (m/s times the square root of mass).
const TOLERANCE: f64 = 1e-12;
/// A normal closer than this to the span of the active ones, relative to its length, depends on them.
const DEPENDENT: f64 = 1e-7;

impl LeastDistance {
    /// Solves by the dual active-set method (Goldfarb and Idnani): starts outside, at the target, and takes in the
    /// halfspace that is violated most until none is. At most six hold at once, however many points touch. A halfspace
    /// that contradicts those already active is left out.
    pub fn solve(&mut self, target: &Vector6, halfspaces: &[Halfspace]) -> Vector6 {
        self.active.clear();
        self.excluded.clear();
        self.excluded.resize(halfspaces.len(), false);
        let mut point = *target;
        // Each addition increases the distance from the target, so that no active set comes twice; rounding may differ.
        for _ in 0..10 * (halfspaces.len() + 6) {
            let Some(entering) = self.most_violated(&point, halfspaces) else { break };
            self.enter(entering, &mut point, halfspaces);
        }
        point
    }

    fn most_violated(&self, point: &Vector6, halfspaces: &[Halfspace]) -> Option<usize> {
        let mut worst = (None, TOLERANCE);
        for (index, halfspace) in halfspaces.iter().enumerate() {
            let violation = halfspace.bound - halfspace.normal.dot(point);
            if violation > worst.1 && !self.excluded[index] {
                worst = (Some(index), violation);
            }
        }
        worst.0
    }

    /// Moves the point until the entering halfspace holds, dropping those whose multiplier would turn negative.
    fn enter(&mut self, entering: usize, point: &mut Vector6, halfspaces: &[Halfspace]) {
        let Halfspace { normal, bound } = halfspaces[entering];
        let mut multiplier = 0.0;
        loop {
            let (coefficients, rest) = self.decompose(&normal, halfspaces);
            let independent = rest.norm() > DEPENDENT * normal.norm();
            let full = if independent { (bound - normal.dot(point)) / rest.norm_squared() } else { f64::INFINITY };
            let blocking = self.blocking(&coefficients);
            let step = blocking.map_or(full, |(_, step)| step.min(full));
            if step == f64::INFINITY {
                self.excluded[entering] = true;
                return;
            }
            if independent {
                *point += rest * step;
            }
            multiplier += step;
            for (position, (_, multiplier)) in self.active.iter_mut().enumerate() {
                *multiplier -= step * coefficients[position];
            }
            match blocking {
                Some((position, dual)) if dual < full => drop(self.active.remove(position)),
                _ => {
                    self.active.push((entering, multiplier));
                    return;
                }
            }
        }
    }

    /// The active halfspace whose multiplier reaches zero first as the entering one's grows, and where.
    fn blocking(&self, coefficients: &Vector6) -> Option<(usize, f64)> {
        let falling = self.active.iter().enumerate().filter(|(position, _)| coefficients[*position] > 0.0);
        let steps = falling.map(|(position, (_, multiplier))| (position, multiplier / coefficients[position]));
        steps.min_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// `normal = sum coefficient active + rest` with the rest orthogonal to the active normals.
    fn decompose(&self, normal: &Vector6, halfspaces: &[Halfspace]) -> (Vector6, Vector6) {
        let count = self.active.len();
        let mut basis = [Vector6::zeros(); 6];
        let mut triangle = SMatrix::<f64, 6, 6>::zeros();
        for (column, (index, _)) in self.active.iter().enumerate() {
            let (shares, rest) = orthogonalise(&halfspaces[*index].normal, &basis[..column]);
            triangle.set_column(column, &shares);
            triangle[(column, column)] = rest.norm();
            basis[column] = rest / rest.norm();
        }
        let (mut coefficients, rest) = orthogonalise(normal, &basis[..count]);
        for row in (0..count).rev() {
            let known: f64 = (row + 1..count).map(|column| triangle[(row, column)] * coefficients[column]).sum();
            coefficients[row] = (coefficients[row] - known) / triangle[(row, row)];
        }
        (coefficients, rest)
    }
}

/// Gram and Schmidt, twice: once is not enough for normals that nearly depend on each other.
fn orthogonalise(vector: &Vector6, basis: &[Vector6]) -> (Vector6, Vector6) {
    let (mut shares, mut rest) = (Vector6::zeros(), *vector);
    for _ in 0..2 {
        for (index, direction) in basis.iter().enumerate() {
            let share = direction.dot(&rest);
            shares[index] += share;
            rest -= direction * share;
        }
    }
    (shares, rest)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn halfspaces() -> impl Strategy<Value = Vec<Halfspace>> {
        let halfspace = (proptest::array::uniform6(-1.0..1.0_f64), -1.0..0.0_f64);
        proptest::collection::vec(
            halfspace.prop_map(|(normal, bound)| Halfspace { normal: normal.into(), bound }),
            1..40,
        )
    }

    proptest! {
        /// The conditions of Karush, Kuhn and Tucker, which only the nearest point fulfils.
        #[test]
        fn the_nearest_point_is_optimal(target in proptest::array::uniform6(-3.0..3.0_f64), mut set in halfspaces()) {
            // Many points of one facet: equal and dependent normals.
            set.extend(set.clone());
            let mut solver = LeastDistance::default();
            let target = Vector6::from(target);
            let point = solver.solve(&target, &set);
            let mut sum = target;
            for &(index, multiplier) in &solver.active {
                prop_assert!(multiplier >= -1e-9);
                prop_assert!((set[index].normal.dot(&point) - set[index].bound).abs() < 1e-9);
                sum += set[index].normal * multiplier;
            }
            prop_assert!((sum - point).norm() < 1e-9);
            prop_assert!(set.iter().all(|halfspace| halfspace.normal.dot(&point) >= halfspace.bound - 1e-9));
        }
    }

    #[test]
    fn a_contradiction_is_left_out() {
        let normal = Vector6::from([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let set = [Halfspace { normal, bound: 1.0 }, Halfspace { normal: -normal, bound: 0.0 }];
        let point = LeastDistance::default().solve(&Vector6::zeros(), &set);
        assert!((point - normal).norm() < 1e-12);
    }
}
