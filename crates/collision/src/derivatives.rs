//! Exact first and second derivatives of the contact information (Eq. firstderw to secondderfF).
//!
//! The barrier value function `V(u) = min_z B(z, u)` has the contact normal as its gradient (Eq. contactvectordef and
//! the remark on Eq. barrierprob), so that `V'' = D n` and `V''' = D2 n`. Here `u = (translation, rotation vector)`
//! moves the body away from its pose. Body rows depend on `(z, u)` only through the point in the moved frame, `y' =
//! exp(-[theta]) (p - rho - translation)`, and linearly on that. Three quantities therefore suffice: derivatives of
//! `y'`, the sum `M = sum d a a'` per part, and the same sum with the weights of the third derivative. Only these sums
//! take an effort that grows with the number of rows.

use pulp::Simd;

use crate::interior_point::Row;
use crate::lane::{Lane, Vector, array, cross, dot};
use crate::newton::{Factors, Moments};

/// Number of directions `u`.
pub const DIRECTIONS: usize = 6;
/// Matrix whose rows and columns are directions.
pub type DirectionMatrix<S> = [[Lane<S>; DIRECTIONS]; DIRECTIONS];

/// Value and first derivatives along `u`, in the frame of the rows.
pub struct First<S: Simd> {
    /// `grad V`: contact normal as force and torque about the body's origin.
    pub normal: [Lane<S>; DIRECTIONS],
    /// `D Phi = c' z'`
    pub distance: [Lane<S>; DIRECTIONS],
    /// `V''`, symmetric.
    pub curvature: DirectionMatrix<S>,
    /// `z' = -M^-1 B_zu`: of the contact point and of the growth.
    pub solution: [[Lane<S>; DIRECTIONS]; 4],
    force: Vector<S>,
    lever: Vector<S>,
    /// `M^-1 c`
    cost_response: [Lane<S>; 4],
    /// Of `M`.
    factors: Factors<S>,
    body: Moments<S>,
}

/// Seed `s` of the contact information, in the frame of the rows.
pub struct Seed<S: Simd> {
    /// Of the distance `Phi`.
    pub distance: Lane<S>,
    /// Of the normal `V'`.
    pub normal: [Lane<S>; DIRECTIONS],
    /// Of the contact point, where it is part of the contact information.
    pub point: Option<Vector<S>>,
}

/// First derivatives at a solution. `lever` is the common point relative to the body's origin.
#[inline(always)]
pub fn first<S: Simd>(simd: S, body_rows: &[Row<S>], fixed_rows: &[Row<S>], lever: Vector<S>) -> First<S> {
    let zero = Lane::splat(simd, 0.0);
    let (mut body, mut fixed, mut force) = (Moments::zero(simd), Moments::zero(simd), [zero; 3]);
    for row in body_rows {
        body.add(row.curvature(), &row.normal);
        force = array!(|axis| row.dual.mul_add(row.normal[axis], force[axis]));
    }
    for row in fixed_rows {
        fixed.add(row.curvature(), &row.normal);
    }
    let factors = body.plus(&fixed).factorise();
    let torque = cross(&force, &lever);
    let mixed = mixed_derivatives(simd, &body, &force, &lever);
    let solution = implicit(simd, &factors, &mixed);
    let cost_response = factors.solve([zero, zero, zero, Lane::splat(simd, 2.0)]);
    let distance = array!(|column| solution[3][column] + solution[3][column]);
    let curvature = value_curvature(simd, &body, &force, &lever, &mixed, &solution);
    let normal = [-force[0], -force[1], -force[2], torque[0], torque[1], torque[2]];
    First { normal, distance, curvature, solution, force, lever, cost_response, factors, body }
}

/// `dy'/du = (-I, [y])`, column by column.
#[inline(always)]
fn moved_point<S: Simd>(simd: S, lever: &Vector<S>, column: usize) -> Vector<S> {
    let mut unit = [Lane::splat(simd, 0.0); 3];
    unit[column % 3] = Lane::splat(simd, 1.0);
    if column < 3 { array!(|axis| -unit[axis]) } else { cross(lever, &unit) }
}

/// `B_zu = M_body (dy'/du) + (0, -[f])`
#[inline(always)]
fn mixed_derivatives<S: Simd>(
    simd: S,
    body: &Moments<S>,
    force: &Vector<S>,
    lever: &Vector<S>,
) -> [[Lane<S>; DIRECTIONS]; 4] {
    let mut mixed = [[Lane::splat(simd, 0.0); DIRECTIONS]; 4];
    for column in 0..DIRECTIONS {
        let response = body.times_point(&moved_point(simd, lever, column));
        for row in 0..4 {
            mixed[row][column] = response[row];
        }
    }
    let twist = skew(simd, force);
    for row in 0..3 {
        for column in 0..3 {
            mixed[row][3 + column] -= twist[row][column];
        }
    }
    mixed
}

/// `z' = -M^-1 B_zu` (Eq. firstderF)
#[inline(always)]
fn implicit<S: Simd>(simd: S, factors: &Factors<S>, mixed: &[[Lane<S>; DIRECTIONS]; 4]) -> [[Lane<S>; DIRECTIONS]; 4] {
    let mut solution = [[Lane::splat(simd, 0.0); DIRECTIONS]; 4];
    for column in 0..DIRECTIONS {
        let change = factors.solve(array!(|row| -mixed[row][column]));
        for row in 0..4 {
            solution[row][column] = change[row];
        }
    }
    solution
}

/// `V'' = B_uu + B_uz z'`
#[inline(always)]
fn value_curvature<S: Simd>(
    simd: S,
    body: &Moments<S>,
    force: &Vector<S>,
    lever: &Vector<S>,
    mixed: &[[Lane<S>; DIRECTIONS]; 4],
    solution: &[[Lane<S>; DIRECTIONS]; 4],
) -> DirectionMatrix<S> {
    let mut curvature = [[Lane::splat(simd, 0.0); DIRECTIONS]; DIRECTIONS];
    let rotational = symmetric_part(force, lever);
    let twist = skew(simd, force);
    for column in 0..DIRECTIONS {
        let response = body.times_point(&moved_point(simd, lever, column));
        let response = [response[0], response[1], response[2]];
        for row in column..DIRECTIONS {
            let mut entry = dot(&moved_point(simd, lever, row), &response);
            if column >= 3 {
                entry += rotational[row - 3][column - 3];
            } else if row >= 3 {
                // Rows of rotation, columns of translation: transpose of [f].
                entry += twist[column][row - 3];
            }
            for component in 0..4 {
                entry = mixed[component][row].mul_add(solution[component][column], entry);
            }
            curvature[row][column] = entry;
            curvature[column][row] = entry;
        }
    }
    curvature
}

/// `<s, D2 (Phi, V', p)>` along `u` for the seed `s`, symmetric (Eq. secondderw).
#[inline(always)]
pub fn second<S: Simd>(
    simd: S,
    body_rows: &[Row<S>],
    fixed_rows: &[Row<S>],
    first: &First<S>,
    seed: &Seed<S>,
) -> DirectionMatrix<S> {
    let First { force, lever, solution, body, .. } = first;
    let [shift, spin]: [Vector<S>; 2] = array!(|part| array!(|axis| seed.normal[3 * part + axis]));
    let adjoint = adjoint(simd, first, seed);
    let along: Vector<S> = array!(|axis| adjoint[axis] - shift[axis]);
    let spun = cross(&spin, lever);
    let body_direction = [along[0] - spun[0], along[1] - spun[1], along[2] - spun[2], adjoint[3]];
    let body_third = third_moments(simd, body_rows, &body_direction);
    let fixed_third = third_moments(simd, fixed_rows, &adjoint);
    let reaction = body.times(&body_direction);
    let reaction = [reaction[0], reaction[1], reaction[2]];

    // Change w of the point p relative to the translation, along every direction.
    let moves: [Vector<S>; DIRECTIONS] = array!(|column| {
        let mut point = [solution[0][column], solution[1][column], solution[2][column]];
        if column < 3 {
            point[column] -= Lane::splat(simd, 1.0);
        }
        point
    });
    let rotating = rotating_terms(simd, force, &spin, &reaction);
    let rotational = rotational_terms(force, lever, &spin, &along, &reaction);
    let mut hessian = [[Lane::splat(simd, 0.0); DIRECTIONS]; DIRECTIONS];
    let half = Lane::splat(simd, 0.5);
    let columns: [Column<S>; DIRECTIONS] = array!(|column| {
        let point = relative_point(simd, lever, &moves[column], column);
        let hat = [point[0], point[1], point[2], solution[3][column]];
        let bend = bending(simd, lever, &spin, &along, &moves[column], column);
        let third = body_third.times(&hat);
        let bent = body.times_point(&bend);
        let fixed = fixed_third.times(&array!(|row| solution[row][column]));
        Column { hat, half_response: array!(|row| half.mul_add(third[row], bent[row])), fixed }
    });
    for row in 0..DIRECTIONS {
        for column in 0..=row {
            let (a, b) = (&columns[row], &columns[column]);
            let mut entry = Lane::splat(simd, 0.0);
            for component in 0..4 {
                entry = a.hat[component].mul_add(b.half_response[component], entry);
                entry = a.half_response[component].mul_add(b.hat[component], entry);
                entry = solution[component][row].mul_add(b.fixed[component], entry);
            }
            if row >= 3 {
                entry += dot(&rotating[row - 3], &moves[column]);
            }
            if column >= 3 {
                entry += dot(&rotating[column - 3], &moves[row]);
                entry += rotational[row - 3][column - 3];
            }
            hessian[row][column] = entry;
            hessian[column][row] = entry;
        }
    }
    hessian
}

/// Direction in `z` of the third derivative, `z' s_n - M^-1 s_z` (Eq. secondderadjeq), where `s_z` is the seed of `p` and
/// the seed of `Phi` times `c`.
#[inline(always)]
fn adjoint<S: Simd>(simd: S, first: &First<S>, seed: &Seed<S>) -> [Lane<S>; 4] {
    let mut adjoint: [Lane<S>; 4] = array!(|row| {
        let mut sum = -(seed.distance * first.cost_response[row]);
        for column in 0..DIRECTIONS {
            sum = first.solution[row][column].mul_add(seed.normal[column], sum);
        }
        sum
    });
    if let Some([x, y, z]) = seed.point {
        let response = first.factors.solve([x, y, z, Lane::splat(simd, 0.0)]);
        for row in 0..4 {
            adjoint[row] -= response[row];
        }
    }
    adjoint
}

/// Contribution of one direction to the products with all others.
#[derive(Clone, Copy)]
struct Column<S: Simd> {
    /// Change of `(y', alpha)`.
    hat: [Lane<S>; 4],
    /// Half of the third moments' response, plus the second moments' response to the second derivative of `y'`.
    half_response: [Lane<S>; 4],
    /// Response of the environment's third moments.
    fixed: [Lane<S>; 4],
}

/// `sum 2 (d / slack) (a t) a a'`
#[inline(always)]
fn third_moments<S: Simd>(simd: S, rows: &[Row<S>], direction: &[Lane<S>; 4]) -> Moments<S> {
    let mut moments = Moments::zero(simd);
    let [x, y, z, growth] = *direction;
    for row in rows {
        let along = dot(&row.normal, &[x, y, z]) - growth;
        let weight = row.curvature() * row.inverse_slack;
        moments.add((weight + weight) * along, &row.normal);
    }
    moments
}

/// `y'` along a direction: `w - theta x y`.
#[inline(always)]
fn relative_point<S: Simd>(simd: S, lever: &Vector<S>, moved: &Vector<S>, column: usize) -> Vector<S> {
    if column < 3 {
        return *moved;
    }
    let turned = moved_point(simd, lever, column);
    array!(|axis| moved[axis] + turned[axis])
}

/// Second derivative of `y'` along the seed's direction and another one:
/// `-spin x w - theta x along + (spin x (theta x y) + theta x (spin x y)) / 2`.
#[inline(always)]
fn bending<S: Simd>(
    simd: S,
    lever: &Vector<S>,
    spin: &Vector<S>,
    along: &Vector<S>,
    moved: &Vector<S>,
    column: usize,
) -> Vector<S> {
    let turned = cross(spin, moved);
    if column < 3 {
        return array!(|axis| -turned[axis]);
    }
    let mut unit = [Lane::splat(simd, 0.0); 3];
    unit[column - 3] = Lane::splat(simd, 1.0);
    let half = Lane::splat(simd, 0.5);
    let swept = cross(&unit, along);
    let outer = cross(spin, &cross(&unit, lever));
    let inner = cross(&unit, &cross(spin, lever));
    array!(|axis| half.mul_add(outer[axis] + inner[axis], -(turned[axis] + swept[axis])))
}

/// Terms linear in a rotation and in the `w` of another direction:
/// `[reaction] + (f spin' - 2 spin f' + (f spin) I) / 2`.
#[inline(always)]
fn rotating_terms<S: Simd>(simd: S, force: &Vector<S>, spin: &Vector<S>, reaction: &Vector<S>) -> [Vector<S>; 3] {
    let half = Lane::splat(simd, 0.5);
    let aligned = half * dot(force, spin);
    let mut terms = skew(simd, reaction);
    for row in 0..3 {
        for column in 0..3 {
            terms[row][column] += (half * force[row]).mul_add(spin[column], -(spin[row] * force[column]));
        }
        terms[row][row] += aligned;
    }
    terms
}

/// Terms of two rotations.
#[inline(always)]
fn rotational_terms<S: Simd>(
    force: &Vector<S>,
    lever: &Vector<S>,
    spin: &Vector<S>,
    along: &Vector<S>,
    reaction: &Vector<S>,
) -> [Vector<S>; 3] {
    let third = force[0].constant(1.0 / 3.0);
    let torque = cross(lever, force);
    let mut terms = symmetric_part(reaction, lever);
    let swept = symmetric_part(force, along);
    let aligned = third * dot(spin, &torque);
    for row in 0..3 {
        for column in 0..3 {
            let cubic = spin[row].mul_add(torque[column], torque[row] * spin[column]);
            terms[row][column] += third.mul_add(cubic, swept[row][column]);
        }
        terms[row][row] += aligned;
    }
    terms
}

/// `(a b' + b a') / 2 - (a b) I`: second derivative of `a exp(-[theta]) b`.
#[inline(always)]
fn symmetric_part<S: Simd>(a: &Vector<S>, b: &Vector<S>) -> [Vector<S>; 3] {
    let half = a[0].constant(0.5);
    let along = dot(a, b);
    let mut matrix: [Vector<S>; 3] =
        array!(|row| { array!(|column| half * a[row].mul_add(b[column], b[row] * a[column])) });
    for (axis, row) in matrix.iter_mut().enumerate() {
        row[axis] -= along;
    }
    matrix
}

/// `[v]`, the matrix of the cross product.
#[inline(always)]
pub fn skew<S: Simd>(simd: S, [x, y, z]: &Vector<S>) -> [Vector<S>; 3] {
    let zero = Lane::splat(simd, 0.0);
    [[zero, -*z, *y], [*z, zero, -*x], [-*y, *x, zero]]
}
