//! The nearest point of a polyhedron in velocity space. A contact problem without restitution is such a problem.

use nalgebra::SVector;

/// Velocities in coordinates in which the kinetic energy is half the squared norm.
pub type Vector6 = SVector<f64, DIMENSIONS>;

/// Dimensions of velocity space.
const DIMENSIONS: usize = 6;

/// The halfspace `normal u >= bound`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Halfspace {
    pub normal: Vector6,
    pub bound: f64,
}

/// Solver for the point `u` of an intersection of halfspaces that is nearest to `target`:
/// `u = target + sum multiplier normal`, over the active halfspaces.
#[derive(Debug, Clone, Default)]
pub struct LeastDistance {
    /// Index and multiplier (not negative) of every active halfspace.
    pub active: Vec<(usize, f64)>,
    /// An orthonormal basis of the active normals, and their coefficients in it: an upper triangular matrix.
    basis: [Vector6; DIMENSIONS],
    triangle: [Vector6; DIMENSIONS],
    excluded: Vec<bool>,
}

/// Smaller violations are rounding errors (m/s times the square root of kg).
const TOLERANCE: f64 = 1e-12;
/// A normal counts as linearly dependent on the active ones if its distance from their span is a smaller fraction of
/// its length.
const DEPENDENT: f64 = 1e-7;

impl LeastDistance {
    /// The nearest point, by the dual active-set method (Goldfarb and Idnani, 1983): starts at the target and adds the
    /// most violated halfspace until none is violated. At most six are active at once, however many points touch. A
    /// halfspace that contradicts the active ones is ignored.
    pub fn solve(&mut self, target: &Vector6, halfspaces: &[Halfspace]) -> Vector6 {
        self.active.clear();
        self.excluded.clear();
        self.excluded.resize(halfspaces.len(), false);
        let mut point = *target;
        // Every addition increases the distance from the target, so that no active set recurs. The limit is for
        // rounding.
        for _ in 0..10 * (halfspaces.len() + DIMENSIONS) {
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

    /// Moves the point into the entering halfspace, and drops active ones whose multiplier would become negative.
    fn enter(&mut self, entering: usize, point: &mut Vector6, halfspaces: &[Halfspace]) {
        let Halfspace { normal, bound } = halfspaces[entering];
        let mut multiplier = 0.0;
        loop {
            let (column, rest) = orthogonalise(&normal, &self.basis[..self.active.len()]);
            let coefficients = self.coefficients(column);
            let independent = self.active.len() < DIMENSIONS && rest.norm() > DEPENDENT * normal.norm();
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
                Some((position, dual)) if dual < full => self.leave(position, halfspaces),
                _ => {
                    self.extend_basis(self.active.len(), column, &rest);
                    self.active.push((entering, multiplier));
                    return;
                }
            }
        }
    }

    /// Position of the active halfspace whose multiplier reaches zero first as the entering one's grows, and the step
    /// at which it does.
    fn blocking(&self, coefficients: &Vector6) -> Option<(usize, f64)> {
        let falling = self.active.iter().enumerate().filter(|(position, _)| coefficients[*position] > 0.0);
        let steps = falling.map(|(position, (_, multiplier))| (position, multiplier / coefficients[position]));
        steps.min_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// Coefficients of a vector in the active normals, from those in their basis.
    fn coefficients(&self, mut coefficients: Vector6) -> Vector6 {
        let count = self.active.len();
        for row in (0..count).rev() {
            let known: f64 = (row + 1..count).map(|column| self.triangle[column][row] * coefficients[column]).sum();
            coefficients[row] = (coefficients[row] - known) / self.triangle[row][row];
        }
        coefficients
    }

    /// Extends the first `count` vectors of the basis by a normal, given by its coefficients in them and the rest.
    fn extend_basis(&mut self, count: usize, mut column: Vector6, rest: &Vector6) {
        let length = rest.norm();
        column[count] = length;
        (self.triangle[count], self.basis[count]) = (column, rest / length);
    }

    /// Drops an active halfspace.
    fn leave(&mut self, position: usize, halfspaces: &[Halfspace]) {
        self.active.remove(position);
        for count in position..self.active.len() {
            let normal = &halfspaces[self.active[count].0].normal;
            let (column, rest) = orthogonalise(normal, &self.basis[..count]);
            self.extend_basis(count, column, &rest);
        }
    }
}

/// Coefficients of a vector in an orthonormal basis, and the rest orthogonal to it. Gram-Schmidt twice: once is not
/// accurate for vectors that nearly depend on each other.
fn orthogonalise(vector: &Vector6, basis: &[Vector6]) -> (Vector6, Vector6) {
    let (mut coefficients, mut rest) = (Vector6::zeros(), *vector);
    for _ in 0..2 {
        for (index, direction) in basis.iter().enumerate() {
            let coefficient = direction.dot(&rest);
            coefficients[index] += coefficient;
            rest -= direction * coefficient;
        }
    }
    (coefficients, rest)
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
        /// Only the nearest point fulfils the Karush-Kuhn-Tucker conditions.
        #[test]
        fn the_nearest_point_is_optimal(target in proptest::array::uniform6(-3.0..3.0_f64), mut set in halfspaces()) {
            // Equal and dependent normals, as the contact points of one facet have them.
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
    fn a_contradiction_is_ignored() {
        let normal = Vector6::from([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let set = [Halfspace { normal, bound: 1.0 }, Halfspace { normal: -normal, bound: 0.0 }];
        let point = LeastDistance::default().solve(&Vector6::zeros(), &set);
        assert!((point - normal).norm() < 1e-12);
    }
}
