//! Points of triangles nearest to other points.

use crate::geometry::Vector;

/// The squared distance (m^2) of a point from a triangle; infinite where the plane of that is no nearer than the most.
pub fn squared_distance(point: &Vector, triangle: &[Vector; 3], most: f64) -> f64 {
    let [a, b, c] = triangle;
    let normal = (b - a).cross(&(c - a));
    if normal.dot(&(point - a)).powi(2) > most * normal.norm_squared() {
        return f64::INFINITY;
    }
    (nearest(point, triangle) - point).norm_squared()
}

/// The point of a triangle nearest to a point: inside of it, or on the nearest of its sides.
pub fn nearest(point: &Vector, [a, b, c]: &[Vector; 3]) -> Vector {
    let normal = (b - a).cross(&(c - a));
    let is_inside = |from: &Vector, to: &Vector| normal.cross(&(to - from)).dot(&(point - from)) >= 0.0;
    if normal.norm_squared() > 0.0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a) {
        return point - normal * (normal.dot(&(point - a)) / normal.norm_squared());
    }
    let on_side = |from: &Vector, to: &Vector| {
        let along = to - from;
        let share = (along.dot(&(point - from)) / along.norm_squared()).clamp(0.0, 1.0);
        from + along * if share.is_finite() { share } else { 0.0 }
    };
    let sides = [on_side(a, b), on_side(b, c), on_side(c, a)];
    let distance = |side: &Vector| (side - point).norm_squared();
    sides.into_iter().min_by(|one, other| distance(one).total_cmp(&distance(other))).unwrap_or(*a)
}
