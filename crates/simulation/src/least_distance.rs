//! The nearest point of a polyhedron in velocity space. A contact problem without restitution is such a problem.

use nalgebra::SVector;

/// Velocities in coordinates in which the kinetic energy is half the squared norm.
pub type Vector6 = SVector<f64, DIMENSIONS>;

/// Dimensions of velocity space.
const DIMENSIONS: usize = 6;

/// The intersection of halfspaces `(normal + cosine first + sine second) u >= bound`, at equal angles: the velocities
/// that a contact with friction allows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    pub normal: Vector6,
    /// The first and the second tangent; without them the cone is the halfspace `normal u >= bound`.
    pub tangents: Option<[Vector6; 2]>,
    pub bound: f64,
}

/// Cosine and sine of the angles of a cone's facets. Their number is even: the direction of sliding and its opposite are
/// among them.
const FACETS: [[f64; 2]; 8] = {
    const C: f64 = std::f64::consts::FRAC_1_SQRT_2;
    [[1.0, 0.0], [C, C], [0.0, 1.0], [-C, C], [-1.0, 0.0], [-C, -C], [0.0, -1.0], [C, -C]]
};

impl Cone {
    /// Normal of a facet.
    fn facet(&self, index: usize) -> Vector6 {
        let [cosine, sine] = FACETS[index];
        self.tangents.map_or(self.normal, |[first, second]| self.normal + first * cosine + second * sine)
    }

    /// What friction of an active facet adds to the point: its multiple of the normal without that of the cone.
    pub fn friction(&self, active: &Active) -> Vector6 {
        (self.facet(active.facet) - self.normal) * active.multiplier
    }

    /// The facet that a point violates most of those that are `allowed`, if by more than `least`, and by how much.
    fn most_violated(&self, point: &Vector6, least: f64, allowed: impl Fn(usize) -> bool) -> Option<(usize, f64)> {
        let violation = self.bound - self.normal.dot(point);
        let Some(tangents) = &self.tangents else {
            return (violation > least && allowed(0)).then_some((0, violation));
        };
        let [first, second] = tangents.map(|tangent| tangent.dot(point));
        if violation + first.abs() + second.abs() <= least {
            return None;
        }
        let mut worst = (None, least);
        for (index, [cosine, sine]) in FACETS.iter().enumerate() {
            let violation = violation - (first * cosine + second * sine);
            if violation > worst.1 && allowed(index) {
                worst = (Some(index), violation);
            }
        }
        worst.0.map(|index| (index, worst.1))
    }
}

/// An active facet of a cone.
#[derive(Debug, Clone, Copy)]
pub struct Active {
    /// Index of the cone.
    pub cone: usize,
    facet: usize,
    /// Not negative.
    pub multiplier: f64,
}

/// Solver for the point `u` of an intersection of cones that is nearest to `target`:
/// `u = target + sum multiplier normal`, over the active facets.
#[derive(Debug, Clone, Default)]
pub struct LeastDistance {
    pub active: Vec<Active>,
    /// An orthonormal basis of the active normals, and their coefficients in it: an upper triangular matrix.
    basis: [Vector6; DIMENSIONS],
    triangle: [Vector6; DIMENSIONS],
    /// Cone and index of facets that contradict the active ones.
    excluded: Vec<(usize, usize)>,
}

/// Smaller violations are rounding errors (m/s times the square root of kg).
const TOLERANCE: f64 = 1e-12;
/// A normal counts as linearly dependent on the active ones if its distance from their span is a smaller fraction of
/// its length.
const DEPENDENT: f64 = 1e-7;

impl LeastDistance {
    /// The nearest point, by the dual active-set method (Goldfarb and Idnani, 1983), from the target. At most six facets are
    /// active at once, however many points touch. A facet that contradicts the active ones is ignored.
    pub fn solve(&mut self, target: &Vector6, cones: &[Cone]) -> Vector6 {
        self.active.clear();
        self.excluded.clear();
        self.descend(*target, cones)
    }

    /// The same, warm-started with the facets that were active last, of cones in the same order: faster where cones and
    /// target differ little from the last ones.
    pub fn solve_next(&mut self, target: &Vector6, cones: &[Cone]) -> Vector6 {
        self.excluded.clear();
        let start = self.nearest_of_active(target, cones);
        let point = self.descend(start, cones);
        // Which of contradicting facets are ignored depends on the start.
        if self.excluded.is_empty() { point } else { self.solve(target, cones) }
    }

    /// The point of the active facets that is nearest to `target`, without those whose multiplier would be negative.
    fn nearest_of_active(&mut self, target: &Vector6, cones: &[Cone]) -> Vector6 {
        self.renew_basis(cones);
        loop {
            let mut shift = Vector6::zeros();
            for (row, &Active { cone, facet, .. }) in self.active.iter().enumerate() {
                let missing = cones[cone].bound - cones[cone].facet(facet).dot(target);
                shift[row] = (missing - self.triangle[row].dot(&shift)) / self.triangle[row][row];
            }
            let directions = self.active_basis().iter().zip(shift.iter());
            let point = directions.fold(*target, |point, (direction, length)| point + direction * *length);
            let multipliers = self.coefficients(shift);
            for (active, multiplier) in self.active.iter_mut().zip(multipliers.iter()) {
                active.multiplier = *multiplier;
            }
            let lowest = (0..self.active.len()).min_by(|&one, &other| multipliers[one].total_cmp(&multipliers[other]));
            match lowest {
                Some(position) if multipliers[position] < 0.0 => self.leave(position, cones),
                _ => return point,
            }
        }
    }

    /// Finds the basis of the active facets, without those that depend on others and those of missing cones.
    fn renew_basis(&mut self, cones: &[Cone]) {
        let mut kept = 0;
        for index in 0..self.active.len() {
            let active = self.active[index];
            let Some(cone) = cones.get(active.cone) else { continue };
            let normal = cone.facet(active.facet);
            let (column, rest) = orthogonalise(&normal, &self.basis[..kept]);
            if rest.norm() > DEPENDENT * normal.norm() {
                self.extend_basis(kept, column, &rest);
                self.active[kept] = active;
                kept += 1;
            }
        }
        self.active.truncate(kept);
    }

    /// Adds the most violated facet until none is violated, from the point of the active facets that is nearest to the target.
    fn descend(&mut self, mut point: Vector6, cones: &[Cone]) -> Vector6 {
        // Every addition increases the distance from the target, so that no active set recurs. The limit is for
        // rounding.
        for _ in 0..10 * (cones.len() + DIMENSIONS) {
            let Some((cone, facet)) = self.most_violated(&point, cones) else { break };
            self.enter(cone, facet, &mut point, cones);
        }
        point
    }

    /// An orthonormal basis of the active normals.
    pub fn active_basis(&self) -> &[Vector6] {
        &self.basis[..self.active.len()]
    }

    fn most_violated(&self, point: &Vector6, cones: &[Cone]) -> Option<(usize, usize)> {
        let mut worst = (None, TOLERANCE);
        for (index, cone) in cones.iter().enumerate() {
            let allowed = |facet: usize| !self.excluded.contains(&(index, facet));
            if let Some((facet, violation)) = cone.most_violated(point, worst.1, allowed) {
                worst = (Some((index, facet)), violation);
            }
        }
        worst.0
    }

    /// Moves the point into the halfspace of the entering facet, and drops active ones whose multiplier would become
    /// negative.
    fn enter(&mut self, cone: usize, facet: usize, point: &mut Vector6, cones: &[Cone]) {
        let (normal, bound) = (cones[cone].facet(facet), cones[cone].bound);
        let mut multiplier = 0.0;
        loop {
            let (column, rest) = orthogonalise(&normal, &self.basis[..self.active.len()]);
            let coefficients = self.coefficients(column);
            let independent = self.active.len() < DIMENSIONS && rest.norm() > DEPENDENT * normal.norm();
            let full = if independent { (bound - normal.dot(point)) / rest.norm_squared() } else { f64::INFINITY };
            let blocking = self.blocking(&coefficients);
            let step = blocking.map_or(full, |(_, step)| step.min(full));
            if step == f64::INFINITY {
                self.excluded.push((cone, facet));
                return;
            }
            if independent {
                *point += rest * step;
            }
            multiplier += step;
            for (position, active) in self.active.iter_mut().enumerate() {
                active.multiplier -= step * coefficients[position];
            }
            match blocking {
                Some((position, dual)) if dual < full => self.leave(position, cones),
                _ => {
                    self.extend_basis(self.active.len(), column, &rest);
                    self.active.push(Active { cone, facet, multiplier });
                    return;
                }
            }
        }
    }

    /// Position of the active facet whose multiplier reaches zero first as the entering one's grows, and the step
    /// at which it does.
    fn blocking(&self, coefficients: &Vector6) -> Option<(usize, f64)> {
        let falling = self.active.iter().enumerate().filter(|(position, _)| coefficients[*position] > 0.0);
        let steps = falling.map(|(position, active)| (position, active.multiplier / coefficients[position]));
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

    /// Drops an active facet.
    fn leave(&mut self, position: usize, cones: &[Cone]) {
        self.active.remove(position);
        for count in position..self.active.len() {
            let Active { cone, facet, .. } = self.active[count];
            let (column, rest) = orthogonalise(&cones[cone].facet(facet), &self.basis[..count]);
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

    fn cones() -> impl Strategy<Value = Vec<Cone>> {
        let vector = || proptest::array::uniform6(-1.0..1.0_f64).prop_map(Vector6::from);
        let tangents = proptest::option::of([vector(), vector()]);
        let cone = (vector(), tangents, -1.0..0.0_f64);
        proptest::collection::vec(cone.prop_map(|(normal, tangents, bound)| Cone { normal, tangents, bound }), 1..40)
    }

    proptest! {
        /// Only the nearest point fulfils the Karush-Kuhn-Tucker conditions.
        #[test]
        fn the_nearest_point_is_optimal(
            target in proptest::array::uniform6(-3.0..3.0_f64),
            before in proptest::array::uniform6(-3.0..3.0_f64),
            mut set in cones(),
        ) {
            // Equal and dependent normals, as the contact points of one facet have them.
            set.extend(set.clone());
            let (target, before) = (Vector6::from(target), Vector6::from(before));
            let mut solver = LeastDistance::default();
            let point = solver.solve(&target, &set);
            // From what was active elsewhere, with some more cones.
            let mut other = LeastDistance::default();
            other.solve(&before, &set[..set.len() / 2]);
            prop_assert!((other.solve_next(&target, &set) - point).norm() < 1e-9);
            prop_assert!((solver.solve_next(&target, &set) - point).norm() < 1e-9, "from the solution");
            let mut sum = target;
            for &Active { cone, facet, multiplier } in &solver.active {
                let normal = set[cone].facet(facet);
                prop_assert!(multiplier >= -1e-9);
                prop_assert!((normal.dot(&point) - set[cone].bound).abs() < 1e-9);
                sum += normal * multiplier;
            }
            prop_assert!((sum - point).norm() < 1e-9);
            for cone in &set {
                prop_assert!((0..FACETS.len()).all(|facet| cone.facet(facet).dot(&point) >= cone.bound - 1e-9));
            }
        }
    }

    #[test]
    fn a_contradiction_is_ignored() {
        let normal = Vector6::from([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let halfspace = |normal: Vector6, bound: f64| Cone { normal, tangents: None, bound };
        let set = [halfspace(normal, 1.0), halfspace(-normal, 0.0)];
        let point = LeastDistance::default().solve(&Vector6::zeros(), &set);
        assert!((point - normal).norm() < 1e-12);
    }
}
