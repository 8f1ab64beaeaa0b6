//! Sums of squared residuals with exact or Gauss-Newton second derivatives.

use crate::function::{PointFunction, scatter};
use crate::pattern::{PatternBuilder, add};

/// `sum |r|^2` over all points of a residual function.
pub struct LeastSquares {
    function: PointFunction,
    /// Pairs of Jacobian nonzeros in one row, each pair once, as in the lower triangle of `J'J`.
    products: Vec<Product>,
    curvature_slots: Vec<u32>,
}

struct Product {
    left: usize,
    right: usize,
    slots: Vec<u32>,
}

impl LeastSquares {
    /// Adds the Hessian's entries to `hessian`.
    pub fn new(function: PointFunction, hessian: &mut PatternBuilder) -> Self {
        let pattern = &function.jacobian;
        let mut products = Vec::new();
        for left in 0..pattern.rows.len() {
            for right in 0..=left {
                if pattern.rows[left] != pattern.rows[right] {
                    continue;
                }
                let slot = |point| {
                    let one = function.variable(pattern.columns[left], point);
                    let other = function.variable(pattern.columns[right], point);
                    hessian.symmetric_slot(one, other)
                };
                products.push(Product { left, right, slots: (0..function.points()).map(slot).collect() });
            }
        }
        let curvature_slots = function.hessian_slots(hessian);
        Self { function, products, curvature_slots }
    }

    /// Takes the decision variables from `x`.
    pub fn set_point(&mut self, x: &[f64]) {
        self.function.set_point(x);
    }

    /// The cost.
    pub fn value(&mut self) -> f64 {
        let outputs = self.function.outputs();
        let values = self.function.values();
        (0..outputs).flat_map(|output| values.row(output)).map(|residual| residual * residual).sum()
    }

    /// Adds the gradient `2 J' r`.
    pub fn add_gradient(&mut self, gradient: &mut [f64]) {
        let residuals = self.function.values().clone();
        let derivatives = self.function.jacobian_values().clone();
        let pattern = &self.function.jacobian;
        for (entry, (&row, &column)) in pattern.rows.iter().zip(&pattern.columns).enumerate() {
            for (point, (residual, derivative)) in residuals.row(row).iter().zip(derivatives.row(entry)).enumerate() {
                add(gradient, self.function.variable(column, point), 2.0 * residual * derivative);
            }
        }
    }

    /// Adds `factor (2 J' J + 2 sum r D2r)`, the second term only when `exact`.
    pub fn add_hessian(&mut self, factor: f64, exact: bool, slots: &mut [f64]) {
        let derivatives = self.function.jacobian_values();
        for product in &self.products {
            let (left, right) = (derivatives.row(product.left), derivatives.row(product.right));
            for ((one, other), &slot) in left.iter().zip(right).zip(&product.slots) {
                add(slots, slot, 2.0 * factor * one * other);
            }
        }
        if exact && !self.curvature_slots.is_empty() {
            self.add_curvature(factor, slots);
        }
    }

    fn add_curvature(&mut self, factor: f64, slots: &mut [f64]) {
        let points = self.function.points();
        let residuals = self.function.values().clone();
        for output in 0..self.function.outputs() {
            for (multiplier, residual) in self.function.multiplier_mut(output).iter_mut().zip(residuals.row(output)) {
                *multiplier = 2.0 * factor * residual;
            }
        }
        let values = self.function.hessian_values();
        for (entry, targets) in self.curvature_slots.chunks_exact(points).enumerate() {
            scatter(values.row(entry), targets, slots);
        }
    }
}
