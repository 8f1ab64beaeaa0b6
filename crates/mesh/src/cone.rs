//! Cylinders and cones through the rims of chains of strips.

use nalgebra::{Matrix3, Matrix4, Matrix6, Vector4, Vector6};

use crate::geometry::{Vector, mean};

/// Vertices of a curved surface lie on it within this part of the sagitta of its strips, besides the rounding.
const SAGITTA: f64 = 0.05;
/// ... and within this part of its radius.
const RADIUS: f64 = 1e-3;
/// A cone this steep is a plane (ratio of radius to height), and one this slim a cylinder.
const STEEPEST: f64 = 1e4;

/// A cylinder or cone: the points at a radius that is linear in the height along an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Point of the axis from which heights are measured.
    pub origin: Vector,
    /// Unit direction of the axis.
    pub axis: Vector,
    /// Unit directions across the axis: the first is +x (or +y for an axis along x) as far as it is across.
    pub across: [Vector; 2],
    /// Radius at the height of the origin (m).
    pub radius: f64,
    /// Change of the radius with height.
    pub slope: f64,
}

impl Cone {
    /// Angle around the axis (rad), height (m) and distance from the axis (m).
    pub fn coordinates(&self, point: &Vector) -> (f64, f64, f64) {
        let from = point - self.origin;
        let (x, y) = (self.across[0].dot(&from), self.across[1].dot(&from));
        (y.atan2(x), self.axis.dot(&from), x.hypot(y))
    }

    /// Radius at a height (m).
    pub fn radius_at(&self, height: f64) -> f64 {
        self.radius + self.slope * height
    }

    /// Unit direction away from the axis.
    pub fn outward(&self, angle: f64) -> Vector {
        self.across[0] * angle.cos() + self.across[1] * angle.sin()
    }

    /// Unit normal away from the axis.
    pub fn normal(&self, angle: f64) -> Vector {
        (self.outward(angle) - self.axis * self.slope).normalize()
    }

    /// Distance from the surface (m).
    pub fn deviation(&self, point: &Vector) -> f64 {
        let (_, height, distance) = self.coordinates(point);
        (distance - self.radius_at(height)).abs() / self.slope.hypot(1.0)
    }

    /// The cone through the points of two rims, opposite ones with the same index, and the largest distance from it (m).
    /// `None` when they do not lie on one within the rounding (m) and the tolerances of this file.
    pub fn through(rims: &[&[Vector]; 2], rounding: f64) -> Option<(Self, f64)> {
        let axis = direction(rims, rounding)?;
        let across = across(&axis);
        let middle = mean(rims[0].iter().chain(rims[1]));
        let (center, heights, radii) = circles(rims, &middle, &axis, &across)?;
        let rise = heights[1] - heights[0];
        let slope = if rise.abs() * STEEPEST > (radii[1] - radii[0]).abs() {
            (radii[1] - radii[0]) / rise
        } else {
            return None;
        };
        let slope = if slope.abs() * rise.abs() <= rounding { 0.0 } else { slope };
        let radius = if slope == 0.0 { 0.5 * (radii[0] + radii[1]) } else { radii[0] - slope * heights[0] };
        let cone = Self { origin: center, axis, across, radius, slope };
        let largest = radii[0].max(radii[1]);
        let widest = rims.iter().flat_map(|rim| rim.windows(2)).map(|pair| (pair[1] - pair[0]).norm());
        let sagitta = widest.fold(0.0, f64::max).powi(2) / (8.0 * largest);
        let deviation = rims.iter().copied().flatten().map(|point| cone.deviation(point)).fold(0.0, f64::max);
        let allowed = rounding + (SAGITTA * sagitta).min(RADIUS * largest);
        (deviation <= allowed && largest.is_finite()).then_some((cone, deviation))
    }
}

/// Steps of the fit to points without order.
const STEPS: usize = 12;

impl Cone {
    /// The cone nearest to points of a smooth region with these face normals (times areas), and the largest distance of
    /// a point from it (m). `None` when that is more than the rounding (m).
    pub fn near(points: &[Vector], normals: &[Vector], rounding: f64) -> Option<(Self, f64)> {
        let area: f64 = normals.iter().map(Vector::norm).sum();
        let middle = normals.iter().sum::<Vector>() / area;
        // The normals of a cone keep their angle with its axis.
        let spread: Matrix3<f64> = normals
            .iter()
            .map(|normal| {
                let from = normal.normalize() - middle;
                from * from.transpose() * normal.norm()
            })
            .sum();
        let eigen = spread.symmetric_eigen();
        let axis = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned().try_normalize(0.0)?;
        let center = mean(points);
        let (center, _, radii) = circles(&[points, points], &center, &axis, &across(&axis))?;
        let mut cone = Self { origin: center, axis, across: across(&axis), radius: radii[0], slope: 0.0 };
        for _ in 0..STEPS {
            cone = cone.improved(points)?;
        }
        let size = points.iter().map(|point| (point - cone.origin).norm()).fold(0.0, f64::max);
        let axis = snapped(&cone.axis, size, rounding);
        // A radius that differs by rounding only is the same.
        let slope = if cone.slope.abs() * size <= rounding { 0.0 } else { cone.slope };
        let cone = Self { axis, across: across(&axis), slope, ..cone };
        let deviation = points.iter().map(|point| cone.deviation(point)).fold(0.0, f64::max);
        (deviation <= rounding).then_some((cone, deviation))
    }

    /// One Gauss-Newton step for the distances of points: shift and tilt of the axis, radius and slope.
    fn improved(&self, points: &[Vector]) -> Option<Self> {
        let mut left = Matrix6::zeros();
        let mut right = Vector6::zeros();
        let size = points.iter().map(|point| (point - self.origin).norm()).fold(0.0, f64::max);
        for point in points {
            let (angle, height, distance) = self.coordinates(point);
            let (cosine, sine) = (angle.cos(), angle.sin());
            let height = height / size;
            // Tilting the axis moves it at this height and changes the height of points away from it.
            let row = Vector6::new(
                -cosine,
                -sine,
                -(height + self.slope * distance / size) * cosine,
                -(height + self.slope * distance / size) * sine,
                -1.0,
                -height,
            );
            left += row * row.transpose();
            right -= row * ((distance - self.radius_at(height * size)) / size);
        }
        let step = left.lu().solve(&right)?;
        let axis = (self.axis + self.across[0] * step[2] + self.across[1] * step[3]).try_normalize(0.0)?;
        Some(Self {
            origin: self.origin + (self.across[0] * step[0] + self.across[1] * step[1]) * size,
            axis,
            across: across(&axis),
            radius: self.radius + step[4] * size,
            slope: self.slope + step[5],
        })
    }
}

/// Unit directions across an axis, the first as near as possible to +x, or +y for an axis along x.
pub fn across(axis: &Vector) -> [Vector; 2] {
    const ALONG: f64 = 0.9;
    let wanted = if axis.x.abs() < ALONG { Vector::x() } else { Vector::y() };
    let first = (wanted - axis * axis.dot(&wanted)).normalize();
    [first, axis.cross(&first)]
}

/// The axis: along parallel lines across the strips, else across the rims.
fn direction(rims: &[&[Vector]; 2], rounding: f64) -> Option<Vector> {
    let lines: Vec<Vector> = rims[0].iter().zip(rims[1]).map(|(from, to)| to - from).collect();
    let axis = lines.iter().sum::<Vector>().try_normalize(0.0)?;
    let is_parallel = lines.iter().all(|line| line.cross(&axis).norm() <= rounding);
    let axis = if is_parallel {
        axis
    } else {
        let mut spread = Matrix3::zeros();
        for rim in rims {
            let middle = mean(*rim);
            spread += rim.iter().map(|point| (point - middle) * (point - middle).transpose()).sum::<Matrix3<f64>>();
        }
        let eigen = spread.symmetric_eigen();
        eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned().try_normalize(0.0)?
    };
    let length = lines.iter().map(Vector::norm).fold(0.0, f64::max).max(spread_of(rims));
    Some(snapped(&axis, length, rounding))
}

/// An axis that is along a coordinate axis within the rounding (m) over a length (m) made so, seen along the largest
/// component, so that parallel axes are equal.
fn snapped(axis: &Vector, length: f64, rounding: f64) -> Vector {
    let snapped = axis.map(|component| if component.abs() * length <= rounding { 0.0 } else { component }).normalize();
    if snapped[snapped.iamax()] < 0.0 { -snapped } else { snapped }
}

fn spread_of(rims: &[&[Vector]; 2]) -> f64 {
    rims.iter().map(|rim| (rim[rim.len() - 1] - rim[0]).norm()).fold(0.0, f64::max)
}

/// Least-squares circles about a common centre: a point of the axis, and heights from it and radii of the rims.
fn circles(
    rims: &[&[Vector]; 2],
    middle: &Vector,
    axis: &Vector,
    across: &[Vector; 2],
) -> Option<(Vector, [f64; 2], [f64; 2])> {
    let flat = |point: &Vector| {
        let from = point - middle;
        (across[0].dot(&from), across[1].dot(&from))
    };
    let size = rims.iter().copied().flatten().map(|point| (point - middle).norm()).fold(0.0, f64::max);
    // x^2 + y^2 = 2 c_x x + 2 c_y y + k with one k per rim, in units of the size.
    let mut left = Matrix4::zeros();
    let mut right = Vector4::zeros();
    for (rim, points) in rims.iter().enumerate() {
        for point in points.iter() {
            let (x, y) = flat(point);
            let (x, y) = (x / size, y / size);
            let row = Vector4::new(2.0 * x, 2.0 * y, f64::from(rim == 0), f64::from(rim == 1));
            left += row * row.transpose();
            right += row * (x * x + y * y);
        }
    }
    let solution = left.lu().solve(&right)?;
    let center = middle + size * (across[0] * solution[0] + across[1] * solution[1]);
    let radius = |points: &[Vector]| {
        let distances = points.iter().map(|point| (point - center).cross(axis).norm());
        distances.sum::<f64>() / points.len() as f64
    };
    let height = |points: &[Vector]| axis.dot(&(mean(points) - center));
    let radii = rims.map(radius);
    radii.iter().all(|radius| radius.is_finite()).then_some((center, rims.map(height), radii))
}
