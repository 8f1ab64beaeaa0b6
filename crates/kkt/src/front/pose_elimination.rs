//! Numerical part of the fast path: see [`crate::front::poses`].

use pulp::{Arch, Simd, WithSimd};

use crate::front::poses::{LARGEST_POSE, PoseBlock, PoseLayout};
use crate::kernel::{SubtractProduct, dot, padded, subtract_columns};

/// If a pivot of `J` is below this fraction of its largest entry, the front takes the general path.
const SMALLEST_PIVOT: f64 = 1e-6;

impl PoseLayout {
    /// Reads the kinematics, inverts `J` and computes `T`; false when the poses cannot be eliminated this way.
    pub fn prepare(&self, values: &[f64], store: &mut [f64]) -> bool {
        if self.diagonals.iter().any(|&source| values[source as usize] != 0.0) {
            return false;
        }
        let first = self.blocks[0].inverse;
        store[first..self.store].fill(0.0);
        for &(target, source) in &self.kinematics {
            store[target as usize] += values[source as usize];
        }
        self.blocks.iter().all(|block| block.solve_kinematics(store))
    }
}

impl PoseBlock {
    /// `J := J^{-1}` and `C := T`.
    fn solve_kinematics(&self, store: &mut [f64]) -> bool {
        let (size, height) = (self.size, self.height());
        let (jacobian, rest) = store[self.inverse..].split_at_mut(self.coupling - self.inverse);
        let jacobian = &mut jacobian[..size * size];
        if !invert(jacobian, size) {
            return false;
        }
        let couplings = &mut rest[..height * size];
        let mut row = [0.0; LARGEST_POSE];
        for column in 0..self.columns.len() {
            for d in 0..size {
                row[d] = (0..size).map(|e| jacobian[d + e * size] * couplings[column + e * height]).sum();
            }
            for d in 0..size {
                couplings[column + d * height] = row[d];
            }
        }
        true
    }
}

/// Inverts a small column-major matrix in place by Gauss-Jordan elimination with row exchanges; false when it is close
/// to singular.
fn invert(matrix: &mut [f64], size: usize) -> bool {
    let largest = matrix.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    let mut exchanged = [0; LARGEST_POSE];
    for pivot in 0..size {
        let mut best = pivot;
        for row in pivot + 1..size {
            if matrix[row + pivot * size].abs() > matrix[best + pivot * size].abs() {
                best = row;
            }
        }
        let value = matrix[best + pivot * size];
        // Written so that NaN fails too.
        if !(value.abs() > SMALLEST_PIVOT * largest && value.is_finite()) {
            return false;
        }
        exchanged[pivot] = best;
        for column in 0..size {
            matrix.swap(pivot + column * size, best + column * size);
        }
        matrix[pivot + pivot * size] = 1.0;
        for column in 0..size {
            matrix[pivot + column * size] /= value;
        }
        for row in (0..size).filter(|&row| row != pivot) {
            let factor = std::mem::take(&mut matrix[row + pivot * size]);
            for column in 0..size {
                matrix[row + column * size] -= factor * matrix[pivot + column * size];
            }
        }
    }
    for pivot in (0..size).rev() {
        for row in 0..size {
            matrix.swap(row + pivot * size, row + exchanged[pivot] * size);
        }
    }
    true
}

/// Eliminates the poses of an assembled and prepared stage from the rest.
pub struct EliminatePoses<'a> {
    pub arch: Arch,
    pub layout: &'a PoseLayout,
    pub store: &'a mut [f64],
    pub schur: &'a mut [f64],
    /// Sums of the absolute values of the terms of the rest's diagonal.
    pub scale: &'a mut [f64],
    pub work: &'a mut [f64],
}

/// Length of the scratch of an elimination.
pub fn work_length(layout: &PoseLayout) -> usize {
    let widest = layout.blocks.iter().map(|block| block.columns.len()).max().unwrap_or(0);
    layout.rest.stride() * (layout.poses + widest) + padded(widest) * layout.poses
}

impl EliminatePoses<'_> {
    /// `A := A - T G' - G T'`
    pub fn run(mut self) {
        self.mirror_hessian();
        let layout = self.layout;
        let (stride, poses) = (layout.rest.stride(), layout.poses);
        let work = std::mem::take(&mut self.work);
        let (mixed, scratch) = work.split_at_mut(stride * poses);
        mixed.copy_from_slice(&self.store[layout.coupling..][..stride * poses]);
        for block in &layout.blocks {
            self.subtract_half_hessian(block, mixed, scratch);
        }
        for block in &layout.blocks {
            let product = &mut scratch[..stride * block.columns.len()];
            product.fill(0.0);
            SubtractProduct {
                target: product,
                target_stride: stride,
                left: &mixed[block.first * stride..],
                left_stride: stride,
                right: &self.store[block.coupling..],
                right_stride: block.height(),
                rows: stride,
                depth: block.size,
                columns: 0..block.columns.len(),
                lower: false,
            }
            .run(self.arch);
            for (&column, product) in block.columns.iter().zip(product.chunks_exact(stride)) {
                self.add_symmetrically(column, product);
            }
        }
    }

    /// Copies the lower triangle of `H` to the upper.
    fn mirror_hessian(&mut self) {
        let (poses, stride) = (self.layout.poses, padded(self.layout.poses));
        let hessian = &mut self.store[self.layout.hessian..][..stride * poses];
        for column in 0..poses {
            for row in column + 1..poses {
                hessian[column + row * stride] = hessian[row + column * stride];
            }
        }
    }

    /// `G -= T H / 2` for a block's rows of `T`.
    fn subtract_half_hessian(&mut self, block: &PoseBlock, mixed: &mut [f64], scratch: &mut [f64]) {
        let layout = self.layout;
        let (stride, poses, height) = (layout.rest.stride(), layout.poses, block.height());
        let product = &mut scratch[..height * poses];
        product.fill(0.0);
        SubtractProduct {
            target: product,
            target_stride: height,
            left: &self.store[block.coupling..],
            left_stride: height,
            right: &self.store[layout.hessian + block.first * padded(poses)..],
            right_stride: padded(poses),
            rows: height,
            depth: block.size,
            columns: 0..poses,
            lower: false,
        }
        .run(self.arch);
        for (pose, product) in product.chunks_exact(height).enumerate() {
            for (&column, product) in block.columns.iter().zip(product) {
                mixed[column + pose * stride] += 0.5 * product;
            }
        }
        for pose in block.range() {
            let coefficients = &self.store[block.coupling + (pose - block.first) * height..][..height];
            let coupling = &self.store[layout.coupling + pose * stride..][..stride];
            let product = &product[pose * height..][..height];
            for ((&column, coefficient), product) in block.columns.iter().zip(coefficients).zip(product) {
                self.scale[column] += 2.0 * coefficient.abs() * (coupling[column].abs() + product.abs());
            }
        }
    }

    /// Adds a column and its mirrored row to the lower triangle of the rest.
    fn add_symmetrically(&mut self, column: usize, product: &[f64]) {
        let rest = self.layout.rest;
        let (stride, separator, width) = (rest.stride(), padded(rest.order), padded(rest.separator));
        if column < rest.order {
            for (row, value) in product[..column].iter().enumerate() {
                self.store[column + row * stride] += value;
            }
            let target = &mut self.store[column * stride..(column + 1) * stride];
            target[column] += product[column];
            for (target, value) in target[column..].iter_mut().zip(&product[column..]) {
                *target += value;
            }
            return;
        }
        for (row, value) in product[..rest.order].iter().enumerate() {
            self.store[column + row * stride] += value;
        }
        let (place, product) = (column - separator, &product[separator..]);
        for (row, value) in product[..place].iter().enumerate() {
            self.schur[place + row * width] += value;
        }
        let target = &mut self.schur[place * width..(place + 1) * width];
        target[place] += product[place];
        for (target, value) in target[place..].iter_mut().zip(&product[place..]) {
            *target += value;
        }
    }
}

/// One sweep of a solve through the poses of a stage: before the rest's forward sweep or after its backward sweep.
pub struct SolvePoses<'a> {
    pub layout: &'a PoseLayout,
    pub store: &'a [f64],
    /// Rows of the front.
    pub front: &'a [usize],
    /// Rows of the separator.
    pub separator: &'a [usize],
    /// Right-hand side or solution, by row of the matrix. Between the two sweeps the rows of the multipliers hold
    /// `J^{-1} b_y`.
    pub values: &'a mut [f64],
    /// Scratch: rows of the rest's panel and three times the number of pose coordinates.
    pub work: &'a mut [f64],
    pub backward: bool,
}

impl WithSimd for SolvePoses<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        if self.backward { self.backward(simd) } else { self.forward(simd) }
    }
}

impl SolvePoses<'_> {
    #[inline(always)]
    fn forward<S: Simd>(&mut self, simd: S) {
        let layout = self.layout;
        let (poses, stride) = (layout.poses, layout.rest.stride());
        let (rest, work) = self.work.split_at_mut(stride);
        let (resolved, remaining) = work.split_at_mut(padded(poses));
        let (pose_rows, front) = self.front.split_at(poses);
        let (multiplier_rows, rest_rows) = front.split_at(poses);
        for block in &layout.blocks {
            let inverse = &self.store[block.inverse..];
            for row in 0..block.size {
                resolved[block.first + row] = (0..block.size)
                    .map(|e| inverse[row + e * block.size] * self.values[multiplier_rows[block.first + e]])
                    .sum();
            }
        }
        let remaining = &mut remaining[..padded(poses)];
        remaining.fill(0.0);
        for ((remaining, resolved), (&pose, &multiplier)) in
            remaining.iter_mut().zip(&*resolved).zip(pose_rows.iter().zip(multiplier_rows))
        {
            *remaining = self.values[pose];
            self.values[multiplier] = *resolved;
        }
        subtract_columns(simd, remaining, &self.store[layout.hessian..], padded(poses), &resolved[..poses]);
        rest.fill(0.0);
        subtract_columns(simd, rest, &self.store[layout.coupling..], stride, &resolved[..poses]);
        for block in &layout.blocks {
            for (index, &column) in block.columns.iter().enumerate() {
                let coefficients = self.store[block.coupling + index..].iter().step_by(block.height());
                rest[column] -= coefficients.zip(&remaining[block.range()]).map(|(a, b)| a * b).sum::<f64>();
            }
        }
        let (front, separator) = rest.split_at(padded(layout.rest.order));
        for (value, &row) in front.iter().zip(rest_rows).chain(separator.iter().zip(self.separator)) {
            self.values[row] += value;
        }
    }

    #[inline(always)]
    fn backward<S: Simd>(&mut self, simd: S) {
        let layout = self.layout;
        let (poses, stride) = (layout.poses, layout.rest.stride());
        let (rest, work) = self.work.split_at_mut(stride);
        let (solution, remaining) = work.split_at_mut(padded(poses));
        let (pose_rows, front) = self.front.split_at(poses);
        let (multiplier_rows, rest_rows) = front.split_at(poses);
        rest.fill(0.0);
        let (inner, separator) = rest.split_at_mut(padded(layout.rest.order));
        for (value, &row) in inner.iter_mut().zip(rest_rows).chain(separator.iter_mut().zip(self.separator)) {
            *value = self.values[row];
        }
        for block in &layout.blocks {
            let couplings = self.store[block.coupling..].chunks_exact(block.height().max(1));
            for (pose, coefficients) in block.range().zip(couplings) {
                let coupled = block.columns.iter().zip(coefficients).map(|(&column, a)| a * rest[column]);
                solution[pose] = self.values[multiplier_rows[pose]] - coupled.sum::<f64>();
            }
        }
        let remaining = &mut remaining[..padded(poses)];
        remaining.fill(0.0);
        for (pose, (remaining, &row)) in remaining.iter_mut().zip(pose_rows).enumerate() {
            let coupling = &self.store[layout.coupling + pose * stride..][..stride];
            *remaining = self.values[row] - dot(simd, coupling, rest);
        }
        subtract_columns(simd, remaining, &self.store[layout.hessian..], padded(poses), &solution[..poses]);
        for block in &layout.blocks {
            let inverse = self.store[block.inverse..].chunks_exact(block.size);
            for (multiplier, column) in block.range().zip(inverse) {
                let terms = column.iter().zip(&remaining[block.range()]).map(|(a, b)| a * b);
                self.values[multiplier_rows[multiplier]] = terms.sum();
            }
        }
        for (&row, value) in pose_rows.iter().zip(&*solution) {
            self.values[row] = *value;
        }
    }
}
