//! The distance problem, solved to a fixed barrier parameter (Eq. KKTsystem) by Mehrotra's predictor-corrector method.
//! It aims at the point `tau` of the central path and always begins at the same cold start. Every lane solves one pose.

use pulp::Simd;

use crate::lane::{Lane, Mask, Vector, dot};
use crate::newton::Moments;

/// Relative error of `dual slack / tau` at which a problem counts as solved.
pub const TOLERANCE: f64 = 1e-9;
/// Largest number of iterations, far more than any problem has needed.
const ITERATIONS: usize = 60;
/// The second-order correction clamps relative changes of slack and dual to this. Otherwise a product `dual slack`
/// collapses in about one problem of a thousand, and the method jams.
const CORRECTION_LIMIT: f64 = 2.0;
/// Smallest slack of the cold start, up to a term with `tau`, as a fraction of the mean excess over the smallest slack.
const START_MARGIN: f64 = 0.2;
/// Smallest and largest fraction of the distance to the boundary of the feasible set that a step may take.
const BOUNDARY_FRACTIONS: [f64; 2] = [0.9, 0.995];
/// That fraction is 1 minus this multiple of `tau` over the mean product `dual slack`: the closer the iterate is to its
/// target, the further its steps stay away from the boundary.
const BOUNDARY_SLOPE: f64 = 0.3;
/// Ratios are at least this where they divide the boundary fraction. A step with a smaller ratio is a full one anyway.
const SMALLEST_RATIO: f64 = 1e-3;

/// One halfspace `normal p - alpha <= offset`, with its iterates.
#[derive(Clone, Copy)]
pub struct Row<S: Simd> {
    /// Unit normal in the frame of the problem.
    pub normal: Vector<S>,
    /// Offset (m).
    pub offset: Lane<S>,
    /// Dual variable.
    pub dual: Lane<S>,
    /// Slack (m).
    pub slack: Lane<S>,
    /// Reciprocal slack.
    pub inverse_slack: Lane<S>,
    reciprocal_product: Lane<S>,
    correction: Lane<S>,
    dual_step: Lane<S>,
    slack_slope: Lane<S>,
}

impl<S: Simd> Row<S> {
    /// A row before the first iteration. The duals of all rows are a dual feasible start.
    #[inline(always)]
    pub fn new(normal: Vector<S>, offset: Lane<S>, dual: Lane<S>) -> Self {
        let zero = offset.constant(0.0);
        Self {
            normal,
            offset,
            dual,
            slack: zero,
            inverse_slack: zero,
            reciprocal_product: zero,
            correction: zero,
            dual_step: zero,
            slack_slope: zero,
        }
    }

    /// Curvature `d = dual / slack` of the row.
    #[inline(always)]
    pub fn curvature(&self) -> Lane<S> {
        self.dual * self.inverse_slack
    }
}

/// Primal solution `z = (p, alpha)`, its error and the number of iterations.
pub struct Solution<S: Simd> {
    /// Common point (m).
    pub point: Vector<S>,
    /// Growth `alpha` (m).
    pub growth: Lane<S>,
    /// Largest relative error of `dual slack / tau` of all rows.
    pub residual: Lane<S>,
    /// Iterations of the slowest lane.
    pub iterations: usize,
}

/// The Newton system at an iterate.
struct Assembly<S: Simd> {
    matrix: Moments<S>,
    /// `sum a / slack`
    barrier: [Lane<S>; 4],
    /// Largest relative error of `dual slack / tau` of all rows.
    residual: Lane<S>,
    /// `sum dual slack`
    complementarity: Lane<S>,
}

/// Solves to `tau`, starting at the point midway between the parts' centres. Rows hold the duals of the start before,
/// and the slacks and duals of the solution afterwards.
#[inline(always)]
pub fn solve<S: Simd>(simd: S, rows: &mut [Row<S>], midpoint: Vector<S>, tau: f64, tolerance: f64) -> Solution<S> {
    let count = rows.len() as f64;
    let splat = |value: f64| Lane::splat(simd, value);
    let (zero, one, target) = (splat(0.0), splat(1.0), splat(tau));
    let mut point = midpoint;
    let mut growth = start(simd, rows, &point, tau);
    let (mut primal_step, mut dual_step) = (zero, zero);
    for iterations in 0.. {
        let assembly = advance(simd, rows, primal_step, dual_step, tau);
        let done = assembly.residual.less_than(splat(tolerance));
        if zero.all(done) || iterations == ITERATIONS {
            return Solution { point, growth, residual: assembly.residual, iterations };
        }
        let factors = assembly.matrix.factorise();
        let barrier = &assembly.barrier;
        let step = factors.solve([
            -(target * barrier[0]),
            -(target * barrier[1]),
            -(target * barrier[2]),
            -target.mul_add(barrier[3], splat(2.0)),
        ]);
        let prediction = predict(simd, rows, &step, target);
        let mean = assembly.complementarity * splat(1.0 / count);
        let centring = prediction.target(assembly.complementarity, mean, target, count);
        let correction = &prediction.correction;
        let step = factors.solve([
            -centring.mul_add(barrier[0], correction[0]),
            -centring.mul_add(barrier[1], correction[1]),
            -centring.mul_add(barrier[2], correction[2]),
            -centring.mul_add(barrier[3], correction[3] + splat(2.0)),
        ]);
        let (primal_ratio, dual_ratio) = correct(simd, rows, &step, centring);
        let [least, most] = BOUNDARY_FRACTIONS.map(splat);
        let boundary = (one - splat(BOUNDARY_SLOPE) * target * mean.recip()).min(most).max(least);
        primal_step = step_length(primal_ratio, boundary, done);
        dual_step = step_length(dual_ratio, boundary, done);
        for axis in 0..3 {
            point[axis] = primal_step.mul_add(step[axis], point[axis]);
        }
        growth = primal_step.mul_add(step[3], growth);
    }
    unreachable!("the loop ends at its last iteration")
}

/// Growth of a strictly feasible start. The term with `tau` keeps the products `dual slack` from vanishing when the
/// parts coincide.
#[inline(always)]
fn start<S: Simd>(simd: S, rows: &mut [Row<S>], point: &Vector<S>, tau: f64) -> Lane<S> {
    let count = rows.len() as f64;
    let (mut least, mut sum) = (Lane::splat(simd, f64::MAX), Lane::splat(simd, 0.0));
    for row in rows.iter_mut() {
        row.slack = row.offset - dot(&row.normal, point);
        least = least.min(row.slack);
        sum += row.slack;
    }
    let spread = sum * Lane::splat(simd, 1.0 / count) - least;
    let growth = Lane::splat(simd, START_MARGIN).mul_add(spread, Lane::splat(simd, 0.5 * count * tau) - least);
    for row in rows.iter_mut() {
        row.slack += growth;
    }
    growth
}

/// Takes the previous step and assembles the Newton system. Slacks are updated, not recomputed: recomputation would add
/// rounding errors of the order of `eps / tau`.
#[inline(always)]
fn advance<S: Simd>(simd: S, rows: &mut [Row<S>], primal_step: Lane<S>, dual_step: Lane<S>, tau: f64) -> Assembly<S> {
    let zero = Lane::splat(simd, 0.0);
    let (one, inverse_tau) = (Lane::splat(simd, 1.0), Lane::splat(simd, 1.0 / tau));
    let mut matrix = Moments::zero(simd);
    let (mut barrier, mut residual, mut complementarity) = ([zero; 4], zero, zero);
    for row in rows {
        row.slack = primal_step.mul_sub_from(row.slack_slope, row.slack);
        row.dual = dual_step.mul_add(row.dual_step, row.dual);
        let product = row.dual * row.slack;
        complementarity += product;
        residual = residual.max((product.mul_add(inverse_tau, -one)).abs());
        // One division per row yields all reciprocals.
        row.reciprocal_product = product.recip();
        row.inverse_slack = row.dual * row.reciprocal_product;
        matrix.add(row.curvature(), &row.normal);
        for axis in 0..3 {
            barrier[axis] = row.inverse_slack.mul_add(row.normal[axis], barrier[axis]);
        }
        barrier[3] -= row.inverse_slack;
    }
    Assembly { matrix, barrier, residual, complementarity }
}

/// Effect of the predictor step.
struct Prediction<S: Simd> {
    /// Largest relative decrease of a slack, at least 1.
    primal_ratio: Lane<S>,
    /// Largest relative decrease of a dual, at least 1.
    dual_ratio: Lane<S>,
    /// Changes of `sum dual slack` by the primal step, the dual step and both.
    changes: [Lane<S>; 3],
    /// `sum a q` of the second-order correction.
    correction: [Lane<S>; 4],
}

impl<S: Simd> Prediction<S> {
    /// Mehrotra's barrier parameter for the corrector, between the target `tau` and the current mean.
    #[inline(always)]
    fn target(&self, complementarity: Lane<S>, mean: Lane<S>, tau: Lane<S>, count: f64) -> Lane<S> {
        let (zero, one) = (tau.constant(0.0), tau.constant(1.0));
        let (primal, dual) = (self.primal_ratio.recip(), self.dual_ratio.recip());
        let [by_primal, by_dual, by_both] = self.changes;
        let predicted = complementarity + primal * by_primal + dual * by_dual + primal * dual * by_both;
        let excess = (predicted * tau.constant(1.0 / count) - tau).max(zero);
        let ratio = (excess * (mean - tau).abs().max(tau.constant(f64::MIN_POSITIVE)).recip()).min(one);
        (ratio * ratio * ratio).mul_add((mean - tau).max(zero), tau)
    }
}

/// Evaluates the predictor step, which aims directly at `tau`, and the second-order correction.
#[inline(always)]
fn predict<S: Simd>(simd: S, rows: &mut [Row<S>], step: &[Lane<S>; 4], tau: Lane<S>) -> Prediction<S> {
    let (zero, one) = (Lane::splat(simd, 0.0), Lane::splat(simd, 1.0));
    let limit = Lane::splat(simd, CORRECTION_LIMIT);
    let mut prediction = Prediction { primal_ratio: one, dual_ratio: one, changes: [zero; 3], correction: [zero; 4] };
    for row in rows {
        let slope = slope(&row.normal, step);
        let slack_change = row.inverse_slack * slope;
        let dual_change = tau.mul_add(row.reciprocal_product, slack_change) - one;
        prediction.primal_ratio = prediction.primal_ratio.max(slack_change);
        prediction.dual_ratio = prediction.dual_ratio.max(-dual_change);
        let dual_step = row.dual * dual_change;
        let [by_primal, by_dual, by_both] = prediction.changes;
        prediction.changes = [
            (row.dual * row.slack).mul_sub_from(slack_change, by_primal),
            row.slack.mul_add(dual_step, by_dual),
            (row.slack * slack_change).mul_sub_from(dual_step, by_both),
        ];
        let clamp = |value: Lane<S>| value.max(-limit).min(limit);
        row.correction = clamp(slack_change) * (row.dual * clamp(dual_change));
        let correction = &mut prediction.correction;
        for axis in 0..3 {
            correction[axis] = row.correction.mul_add(row.normal[axis], correction[axis]);
        }
        correction[3] -= row.correction;
    }
    prediction
}

/// Steps of slacks and duals for the corrected step, and the largest relative decreases of both.
#[inline(always)]
fn correct<S: Simd>(simd: S, rows: &mut [Row<S>], step: &[Lane<S>; 4], centring: Lane<S>) -> (Lane<S>, Lane<S>) {
    let (mut primal_ratio, mut dual_ratio) = (Lane::splat(simd, 0.0), Lane::splat(simd, 0.0));
    let one = Lane::splat(simd, 1.0);
    for row in rows {
        row.slack_slope = slope(&row.normal, step);
        let slack_change = row.inverse_slack * row.slack_slope;
        row.dual_step = centring.mul_add(row.inverse_slack, row.correction) + row.dual * (slack_change - one);
        primal_ratio = primal_ratio.max(slack_change);
        dual_ratio = dual_ratio.max(-(row.dual_step * (row.slack * row.reciprocal_product)));
    }
    (primal_ratio, dual_ratio)
}

/// `a dz`, the decrease of the slack.
#[inline(always)]
fn slope<S: Simd>(normal: &Vector<S>, step: &[Lane<S>; 4]) -> Lane<S> {
    normal[0].mul_add(step[0], normal[1].mul_add(step[1], normal[2].mul_add(step[2], -step[3])))
}

/// Length of a step: 1 unless that comes too close to the boundary, and 0 in lanes that are done.
#[inline(always)]
fn step_length<S: Simd>(ratio: Lane<S>, boundary: Lane<S>, done: Mask<S>) -> Lane<S> {
    let (zero, one) = (ratio.constant(0.0), ratio.constant(1.0));
    let limited = boundary * ratio.max(ratio.constant(SMALLEST_RATIO)).recip();
    zero.select(done, one.select(ratio.less_than(boundary), limited))
}
