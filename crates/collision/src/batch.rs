//! One pair at many poses. Every lane holds a pose; the instruction set is chosen at run time.

use pulp::{Simd, WithSimd};

use crate::derivatives;
use crate::error::DistanceError;
use crate::frame;
use crate::interior_point::{self, Row, Solution};
use crate::lane::{Lane, Vector, array, column, cross, dot, gather, rotate, scatter};
use crate::polytope::Polytope;
use crate::pose_chart::{CONTACT, Map, POSE, Placement, contact_information};
use crate::rows;
use crate::solutions::Solutions;

/// The vector instructions to use. Every choice gives the same bits.
#[derive(Clone, Copy)]
pub struct Instructions(pub(crate) pulp::Arch);

impl std::fmt::Debug for Instructions {
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        formatter.write_str(match self.0 {
            pulp::Arch::Scalar => "scalar",
            #[cfg(target_arch = "x86_64")]
            pulp::Arch::V3(_) => "AVX2",
            #[cfg(target_arch = "x86_64")]
            pulp::Arch::V4(_) => "AVX-512",
            #[cfg(target_arch = "aarch64")]
            pulp::Arch::Neon(_) => "NEON",
            _ => "vector",
        })
    }
}

impl Instructions {
    /// The widest vector instructions of this processor.
    pub fn best() -> Self {
        Self(pulp::Arch::new())
    }

    /// All that this processor has, from none to the widest.
    pub fn available() -> Vec<Self> {
        let mut all = vec![pulp::Arch::Scalar];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(pulp::x86::V3::try_new().map(pulp::Arch::V3));
            all.extend(pulp::x86::V4::try_new().map(pulp::Arch::V4));
        }
        #[cfg(target_arch = "aarch64")]
        all.extend(pulp::aarch64::Neon::try_new().map(pulp::Arch::Neon));
        all.into_iter().map(Self).collect()
    }
}

/// What to compute at every pose, and where to store it. The contact information `W` has 7 components `(Phi, Q' n)`, or
/// 10, of which the last are the contact point `p` (m, world frame).
pub enum Request<'output, const COMPONENTS: usize = CONTACT> {
    /// `Phi` and the contact normal `n` in R^7.
    Normals(&'output mut [[f64; 1 + POSE]]),
    /// Upper bounds on the exact distance, tight up to the order of the barrier parameter.
    Bounds(&'output mut [f64]),
    /// `W`
    Values(&'output mut [[f64; COMPONENTS]]),
    /// `W` and `DW`
    Jacobians(&'output mut [[f64; COMPONENTS]], &'output mut [[[f64; POSE]; COMPONENTS]]),
    /// `<s, D2W>` for seeds `s`, one per pose.
    Hessians(&'output [[f64; COMPONENTS]], &'output mut [[[f64; POSE]; POSE]]),
}

/// A request for a pair at many poses.
pub struct Evaluation<'evaluation, const COMPONENTS: usize> {
    pub body: &'evaluation Polytope,
    pub environment: &'evaluation Polytope,
    pub poses: &'evaluation [[f64; POSE]],
    pub tau: f64,
    /// Relative error at which a distance counts as solved.
    pub tolerance: f64,
    /// Solutions of the pair's last request.
    pub solutions: &'evaluation mut Solutions,
    pub request: Request<'evaluation, COMPONENTS>,
}

impl<const COMPONENTS: usize> WithSimd for Evaluation<'_, COMPONENTS> {
    type Output = Result<usize, DistanceError>;

    /// Evaluates all poses and returns the largest number of iterations.
    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> Self::Output {
        let row_count = self.body.normals().len() + self.environment.normals().len();
        self.solutions.prepare(self.poses, self.tau, S::F64_LANES, row_count);
        let mut rows: Vec<Row<S>> = Vec::with_capacity(row_count);
        let mut iterations = 0;
        for start in (0..self.poses.len()).step_by(S::F64_LANES) {
            let count = S::F64_LANES.min(self.poses.len() - start);
            let place = Placement::new(simd, &gather(simd, &self.poses[start..start + count]));
            let solved = self.solve(simd, &mut rows, &place, start, count)?;
            iterations = iterations.max(solved.iterations);
            self.store(simd, &mut rows, &place, &solved, start, count);
        }
        Ok(iterations)
    }
}

impl<const COMPONENTS: usize> Evaluation<'_, COMPONENTS> {
    /// Solves one group of poses unless its solution is kept. When a lane does not converge, the group is solved again
    /// in its contact frames.
    #[inline(always)]
    fn solve<S: Simd>(
        &mut self,
        simd: S,
        rows: &mut Vec<Row<S>>,
        place: &Placement<S>,
        start: usize,
        count: usize,
    ) -> Result<Solution<S>, DistanceError> {
        let mut midpoint = rows::fill(simd, rows, self.body, self.environment, place);
        let group = start / S::F64_LANES;
        if let Some(solution) = self.solutions.restore(simd, group, rows) {
            return Ok(solution);
        }
        let mut solution = interior_point::solve(simd, rows, midpoint, self.tau, self.tolerance);
        let failed = |solution: &Solution<S>| {
            let (residuals, growths) = (solution.residual.to_array(), solution.growth.to_array());
            (0..count).find_map(|lane| {
                // The maximum over rows ignores NaN; the growth does not.
                let residual = if growths[lane].is_finite() { residuals[lane] } else { f64::NAN };
                let solved = residual <= self.tolerance;
                (!solved).then_some((lane, residual))
            })
        };
        if failed(&solution).is_none() {
            self.solutions.keep(group, rows, &solution);
        } else {
            let axes = frame::enter(simd, rows);
            rows::fill(simd, rows, self.body, self.environment, place);
            for row in rows.iter_mut() {
                row.normal = rotate(&axes, &row.normal);
            }
            midpoint = rotate(&axes, &midpoint);
            solution = interior_point::solve(simd, rows, midpoint, self.tau, self.tolerance);
            // Back to world axes: the inverse of a rotation is its transpose.
            let inverse: [Vector<S>; 3] = array!(|axis| column(&axes, axis));
            solution.point = rotate(&inverse, &solution.point);
            for row in rows.iter_mut() {
                row.normal = rotate(&inverse, &row.normal);
            }
        }
        match failed(&solution) {
            None => Ok(solution),
            Some((lane, residual)) => {
                let index = start + lane;
                Err(DistanceError { index, pose: self.poses[index], tau: self.tau, residual })
            }
        }
    }

    #[inline(always)]
    fn store<S: Simd>(
        &mut self,
        simd: S,
        rows: &mut [Row<S>],
        place: &Placement<S>,
        solved: &Solution<S>,
        start: usize,
        count: usize,
    ) {
        let body = self.body.normals().len();
        let lever: Vector<S> = array!(|axis| solved.point[axis] - place.position[axis]);
        let distance = solved.growth + solved.growth;
        let group = start..start + count;
        match &mut self.request {
            Request::Bounds(bounds) => {
                let bound = tightest(rows, &solved.point).to_array();
                bounds[group].copy_from_slice(&bound[..count]);
            }
            Request::Normals(normals) => {
                let [a, b, c, d, e, f, g] = place.pose_normal(&force(simd, &rows[..body]), &lever);
                scatter(&[distance, a, b, c, d, e, f, g], normals[group].iter_mut());
            }
            Request::Values(values) => {
                let force = force(simd, &rows[..body]);
                let torque = cross(&force, &lever);
                let [x, y, z] = force;
                let [a, b, c]: Vector<S> = array!(|axis| dot(&column(&place.rotation, axis), &torque));
                let information = contact_information(distance, &[-x, -y, -z, a, b, c], &solved.point);
                scatter::<_, COMPONENTS>(&information, values[group].iter_mut());
            }
            Request::Jacobians(values, jacobians) => {
                let contact = ContactGroup::new(simd, rows, place, lever, body);
                let information = contact.information(distance, &solved.point);
                scatter(&information, values[group.clone()].iter_mut());
                contact.store_first(simd, &mut jacobians[group]);
            }
            Request::Hessians(seeds, hessians) => {
                let contact = ContactGroup::new(simd, rows, place, lever, body);
                let seed = gather(simd, &seeds[group.clone()]);
                contact.store_second(simd, rows.split_at(body), &seed, &mut hessians[group]);
            }
        }
    }
}

/// First derivatives of one group of poses in its contact frame.
struct ContactGroup<S: Simd> {
    map: Map<S>,
    first: derivatives::First<S>,
}

impl<S: Simd> ContactGroup<S> {
    #[inline(always)]
    fn new(simd: S, rows: &mut [Row<S>], place: &Placement<S>, lever: Vector<S>, body: usize) -> Self {
        let axes = frame::enter(simd, rows);
        let first = derivatives::first(simd, &rows[..body], &rows[body..], rotate(&axes, &lever));
        Self { map: Map::new(axes, place), first }
    }

    #[inline(always)]
    fn information<const COMPONENTS: usize>(&self, distance: Lane<S>, point: &Vector<S>) -> [Lane<S>; COMPONENTS] {
        contact_information(distance, &self.map.normal(&self.first.normal), point)
    }

    #[inline(always)]
    fn store_first<const COMPONENTS: usize>(&self, simd: S, jacobians: &mut [[[f64; POSE]; COMPONENTS]]) {
        let rows: [_; COMPONENTS] = self.map.jacobian(simd, &self.first);
        for (component, row) in rows.iter().enumerate() {
            scatter(row, jacobians.iter_mut().map(|jacobian| &mut jacobian[component]));
        }
    }

    #[inline(always)]
    fn store_second<const COMPONENTS: usize>(
        &self,
        simd: S,
        (body_rows, fixed_rows): (&[Row<S>], &[Row<S>]),
        seed: &[Lane<S>; COMPONENTS],
        hessians: &mut [[[f64; POSE]; POSE]],
    ) {
        let seed = self.map.seed(seed);
        let along = derivatives::second(simd, body_rows, fixed_rows, &self.first, &seed);
        let hessian = self.map.hessian(simd, &self.first, along, &seed);
        for (index, row) in hessian.iter().enumerate() {
            scatter(row, hessians.iter_mut().map(|hessian| &mut hessian[index]));
        }
    }
}

/// Contact force at the common point: `sum dual normal` over the body's rows.
#[inline(always)]
fn force<S: Simd>(simd: S, body_rows: &[Row<S>]) -> Vector<S> {
    let mut force = [Lane::splat(simd, 0.0); 3];
    for row in body_rows {
        force = array!(|axis| row.dual.mul_add(row.normal[axis], force[axis]));
    }
    force
}

/// Twice the smallest growth with which both parts contain the point.
#[inline(always)]
fn tightest<S: Simd>(rows: &[Row<S>], point: &Vector<S>) -> Lane<S> {
    let growth = rows.iter().map(|row| dot(&row.normal, point) - row.offset);
    let growth = growth.reduce(|largest, next| largest.max(next)).expect("a pair has rows");
    growth + growth
}
