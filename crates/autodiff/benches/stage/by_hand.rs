//! Derivatives of the step as one would write them by hand, nonzeros only, by rows and then columns.

use super::step::{DAMPING, INPUTS, OFFSET, OUTPUTS, ROTATIONAL_DAMPING, ROTATIONAL_STIFFNESS, STIFFNESS, TIME_STEP};

pub const JACOBIAN_NONZEROS: usize = 101;
pub const HESSIAN_NONZEROS: usize = 48;

/// Fills an array from front to back.
struct Writer<'array> {
    values: &'array mut [f64],
    next: usize,
}

impl Writer<'_> {
    #[inline(always)]
    fn extend<const N: usize>(&mut self, values: [f64; N]) {
        self.values[self.next..self.next + N].copy_from_slice(&values);
        self.next += N;
    }
}

pub fn jacobian(x: &[f64; INPUTS + OUTPUTS], values: &mut [f64; JACOBIAN_NONZEROS]) {
    let mut entries = Writer { values, next: 0 };
    for _ in 0..3 {
        entries.extend([-1.0, 1.0, -TIME_STEP]);
    }
    let half = 0.5 * TIME_STEP;
    let [w, i, j, k] = [16, 17, 18, 19].map(|input| x[input] * half);
    let [p, q, r] = [23, 24, 25].map(|input| x[input] * half);
    entries.extend([-1.0, 1.0, p, q, r, i, j, k]);
    entries.extend([-1.0, -p, 1.0, -r, q, -w, k, -j]);
    entries.extend([-1.0, -q, r, 1.0, -p, -k, -w, i]);
    entries.extend([-1.0, -r, -q, p, 1.0, j, -i, -w]);
    force_rows(x, &mut entries);
    torque_rows(x, &mut entries);
}

fn force_rows(x: &[f64; INPUTS + OUTPUTS], entries: &mut Writer) {
    let [w, i, j, k] = [16, 17, 18, 19].map(|input| x[input]);
    let (stiffness, damping) = (TIME_STEP * STIFFNESS, TIME_STEP * DAMPING);
    let [o, m, n] = OFFSET.map(|offset| 2.0 * stiffness * offset);
    let along = i * o + j * m + k * n;
    let [first, second, third] = [w * o - k * m + j * n, w * m + k * o - i * n, w * n - j * o + i * m];
    let rows = [[first, along, third, -second], [second, -third, along, first], [third, second, -first, along]];
    for [by_w, by_i, by_j, by_k] in rows {
        entries.extend([-1.0, stiffness, by_w, by_i, by_j, by_k, 1.0 + damping, -stiffness, -damping]);
    }
}

fn torque_rows(x: &[f64; INPUTS + OUTPUTS], entries: &mut Writer) {
    let [w, i, j, k] = [16, 17, 18, 19].map(|input| x[input]);
    let [a, b, c, d] = [29, 30, 31, 32].map(|input| x[input]);
    let stiffness = -TIME_STEP * ROTATIONAL_STIFFNESS;
    let damping = TIME_STEP * ROTATIONAL_DAMPING;
    let scalar = stiffness * (w * a + i * b + j * c + k * d);
    let rows = [([b, -a, -d, c], [-i, w, k, -j]), ([c, d, -a, -b], [-j, -k, w, i]), ([d, -c, b, -a], [-k, j, -i, w])];
    for (by_pose, by_reference) in rows {
        let vector = stiffness * (w * by_pose[0] + i * by_pose[1] + j * by_pose[2] + k * by_pose[3]);
        let [one, two, three, four] = by_pose;
        entries.extend([-1.0, a * vector + scalar * one, b * vector + scalar * two]);
        entries.extend([c * vector + scalar * three, d * vector + scalar * four, 1.0 + damping]);
        let [one, two, three, four] = by_reference;
        entries.extend([w * vector + scalar * one, i * vector + scalar * two]);
        entries.extend([j * vector + scalar * three, k * vector + scalar * four, -damping]);
    }
}

pub fn hessian(x: &[f64; INPUTS + OUTPUTS], values: &mut [f64; HESSIAN_NONZEROS]) {
    let mut entries = Writer { values, next: 0 };
    let multipliers = &x[INPUTS..];
    let pose = [16, 17, 18, 19].map(|input| x[input]);
    let reference = [29, 30, 31, 32].map(|input| x[input]);
    let [l, m, n] = [10, 11, 12].map(|row| -TIME_STEP * ROTATIONAL_STIFFNESS * multipliers[row]);
    // Second derivatives of the weighted vector part by reference and pose.
    let mixed = [[0.0, -l, -m, -n], [l, 0.0, n, -m], [m, -n, 0.0, l], [n, m, -l, 0.0]];
    let (mut by_pose, mut by_reference) = ([0.0; 4], [0.0; 4]);
    for row in 0..4 {
        for column in 0..4 {
            by_pose[column] += mixed[row][column] * reference[row];
            by_reference[row] += mixed[row][column] * pose[column];
        }
    }
    let (mut scalar, mut vector) = (0.0, 0.0);
    for index in 0..4 {
        scalar += pose[index] * reference[index];
        vector += by_pose[index] * pose[index];
    }
    let arm = weighted_arm(multipliers);
    for row in 0..4 {
        for column in 0..=row {
            let torque = reference[row] * by_pose[column] + by_pose[row] * reference[column];
            entries.extend([torque + arm[row * (row + 1) / 2 + column]]);
        }
    }
    let [e, f, g, h] = [3, 4, 5, 6].map(|row| -0.5 * TIME_STEP * multipliers[row]);
    entries.extend([f, -e, -h, g, g, h, -e, -f, h, -g, f, -e]);
    for row in 0..4 {
        for column in 0..4 {
            let diagonal = if row == column { vector } else { 0.0 };
            let product = pose[row] * by_pose[column] + by_reference[row] * reference[column];
            entries.extend([product + diagonal + scalar * mixed[row][column]]);
        }
        for column in 0..=row {
            entries.extend([pose[row] * by_reference[column] + by_reference[row] * pose[column]]);
        }
    }
}

/// Second derivatives of the weighted arm by the quaternion, lower triangle.
fn weighted_arm(multipliers: &[f64]) -> [f64; 10] {
    let [e, f, g] = [7, 8, 9].map(|row| 2.0 * TIME_STEP * STIFFNESS * multipliers[row]);
    let [o, m, n] = OFFSET;
    [
        e * o + f * m + g * n,
        g * m - f * n,
        e * o - f * m - g * n,
        e * n - g * o,
        e * m + f * o,
        f * m - e * o - g * n,
        f * o - e * m,
        e * n + g * o,
        f * n + g * m,
        g * n - e * o - f * m,
    ]
}
