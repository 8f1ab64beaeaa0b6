//! How often a surface runs around points, fast: of triangles far away only their sum counts.

use crate::bvh::divide;
use crate::geometry::{Vector, area_vector, mean};
use crate::shells::half_solid_angle;

/// Triangles per leaf.
const LEAF: usize = 8;
/// A group counts as far away from this many of its radii on.
const FAR: f64 = 2.3;

struct Node {
    center: Vector,
    radius: f64,
    /// Sum of the area vectors (m^2).
    area: Vector,
    items: std::ops::Range<usize>,
    second: Option<usize>,
}

/// Triangles whose winding numbers are asked for.
pub struct Winding {
    triangles: Vec<[Vector; 3]>,
    nodes: Vec<Node>,
}

impl Winding {
    pub fn new(triangles: Vec<[Vector; 3]>) -> Self {
        let mut winding = Self { triangles, nodes: Vec::new() };
        if !winding.triangles.is_empty() {
            winding.build(0..winding.triangles.len());
        }
        winding
    }

    fn build(&mut self, items: std::ops::Range<usize>) {
        let own = &self.triangles[items.clone()];
        let weights: Vec<f64> = own.iter().map(|triangle| area_vector(triangle).norm()).collect();
        let total: f64 = weights.iter().sum();
        let middle = |(triangle, weight): (&[Vector; 3], &f64)| mean(triangle) * *weight;
        let center = own.iter().zip(&weights).map(middle).sum::<Vector>() / total.max(f64::MIN_POSITIVE);
        let radius = own.iter().flatten().map(|corner| (corner - center).norm()).fold(0.0, f64::max);
        let area = own.iter().map(|triangle| area_vector(triangle)).sum();
        let node = self.nodes.len();
        self.nodes.push(Node { center, radius, area, items: items.clone(), second: None });
        if items.len() <= LEAF {
            return;
        }
        let half = divide(&mut self.triangles[items.clone()]);
        self.build(items.start..items.start + half);
        self.nodes[node].second = Some(self.nodes.len());
        self.build(items.start + half..items.end);
    }

    /// The winding number of the surface around a point, within some hundredths.
    pub fn number(&self, point: &Vector) -> f64 {
        let mut sum = 0.0;
        let mut waiting: Vec<usize> = (!self.nodes.is_empty()).then_some(0).into_iter().collect();
        while let Some(index) = waiting.pop() {
            let node = &self.nodes[index];
            let to = node.center - point;
            let distance = to.norm();
            if distance > FAR * node.radius {
                sum += node.area.dot(&to) / distance.powi(3);
                continue;
            }
            match node.second {
                Some(second) => waiting.extend([second, index + 1]),
                None => sum += solid_angle_of_all(point, &self.triangles[node.items.clone()]),
            }
        }
        sum / (4.0 * std::f64::consts::PI)
    }
}

/// The solid angle under which some triangles are seen from a point, positive from behind (sr). Their angles are added by
/// multiplying complex numbers, of which one arc tangent is enough.
fn solid_angle_of_all(point: &Vector, triangles: &[[Vector; 3]]) -> f64 {
    let (mut real, mut imaginary, mut turns) = (1.0, 0.0, 0.0);
    for triangle in triangles {
        let (cosine, sine) = half_solid_angle(point, triangle);
        if (cosine, sine) == (0.0, 0.0) {
            // From its corner a triangle is seen under no certain angle.
            continue;
        }
        let before = imaginary;
        (real, imaginary) = (real * cosine - imaginary * sine, real * sine + imaginary * cosine);
        // Half an angle is less than half a turn.
        if sine > 0.0 && before >= 0.0 && imaginary < 0.0 {
            turns += 1.0;
        } else if sine < 0.0 && before < 0.0 && imaginary >= 0.0 {
            turns -= 1.0;
        }
    }
    2.0 * (imaginary.atan2(real) + std::f64::consts::TAU * turns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shells::winding_number;

    #[test]
    fn winding_numbers_are_those_of_all_triangles() {
        // A cube twice around itself, of 24 triangles.
        let corner = |index: usize| [0, 1, 2].map(|axis| if index >> axis & 1 == 0 { 0.0 } else { 1.0 });
        let cube = crate::hull::hull_triangles(&(0..8).map(corner).collect::<Vec<_>>());
        let both: Vec<[Vector; 3]> = [cube.clone(), cube].concat().iter().map(|own| own.map(Vector::from)).collect();
        let winding = Winding::new(both.clone());
        for index in 0..1000 {
            let share = |step: f64| (step * (f64::from(index) + 0.5)).fract() * 3.0 - 1.0;
            let point = Vector::new(share(0.819), share(0.671), share(0.549));
            let exact = winding_number(&point, both.iter().copied());
            assert!((winding.number(&point) - exact).abs() < 0.05, "{point}: {exact}");
            assert!((solid_angle_of_all(&point, &both) / (4.0 * std::f64::consts::PI) - exact).abs() < 1e-9);
        }
    }
}
