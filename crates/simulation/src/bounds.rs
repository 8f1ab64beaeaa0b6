//! Bounds on the motion of a reference.

use nalgebra::UnitQuaternion;
use task::Limits;

use crate::reference::Reference;

/// Fraction of a limit by which a motion may exceed it.
pub const LIMIT_SLACK: f64 = 1e-3;

/// Rounding of a scalar product of unit quaternions.
const ROUNDING: f64 = 1e-12;

/// Limits of velocity and acceleration that a reference keeps, and motions that it stays near. Without the latter,
/// refinement could succeed by throwing the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    limits: Limits,
    near: Option<Near>,
}

/// A box of positions, orientations, and velocities.
#[derive(Debug, Clone, PartialEq)]
struct Near {
    /// Smallest and largest coordinates (m, world frame).
    lowest: [f64; 3],
    highest: [f64; 3],
    /// Orientations, and the largest angle to the nearest of them (rad).
    orientations: Vec<UnitQuaternion<f64>>,
    rotation: f64,
    /// Largest component (m/s, and rad/s).
    velocity: f64,
    angular_velocity: f64,
}

impl Bounds {
    /// The limits alone.
    pub fn new(limits: Limits) -> Self {
        Self { limits, near: None }
    }

    /// Also near some references: at most `margin` (m) outside the box of their positions, and at most `haste` times as
    /// fast as the fastest of them. For a body that reaches `radius` (m) from its origin, rotations away from all of
    /// their orientations may shift the farthest corner by at most the margin, and move it at most as fast.
    pub fn near(self, references: &[&Reference], margin: f64, haste: f64, radius: f64) -> Self {
        let all = references.iter().map(|reference| Near::of(reference)).reduce(|one, other| one.with(&other));
        Self { near: all.map(|near| near.widened(margin, haste, radius)), ..self }
    }

    /// With room for another reference as it is: the one that refinement starts from must be allowed.
    pub fn including(&self, reference: &Reference) -> Self {
        Self { near: self.near.as_ref().map(|near| near.with(&Near::of(reference))), ..*self }
    }

    /// Whether a reference keeps the limits, within a solver's tolerance, and stays near.
    pub fn allow(&self, reference: &Reference) -> bool {
        let kept = reference.limits_kept();
        self.limits.allow(&kept, LIMIT_SLACK)
            && self.near.as_ref().is_none_or(|near| near.contains(&Near::of(reference)))
    }
}

impl Near {
    fn of(reference: &Reference) -> Self {
        let Limits { translational_velocity, rotational_velocity, .. } = reference.limits_kept();
        let axis = |axis: usize| reference.positions().map(move |position| position[axis]);
        Self {
            lowest: [0, 1, 2].map(|of| axis(of).fold(f64::INFINITY, f64::min)),
            highest: [0, 1, 2].map(|of| axis(of).fold(f64::NEG_INFINITY, f64::max)),
            orientations: reference.orientations().collect(),
            rotation: 0.0,
            velocity: translational_velocity,
            angular_velocity: rotational_velocity,
        }
    }

    fn with(&self, other: &Self) -> Self {
        Self {
            lowest: std::array::from_fn(|axis| self.lowest[axis].min(other.lowest[axis])),
            highest: std::array::from_fn(|axis| self.highest[axis].max(other.highest[axis])),
            orientations: [&self.orientations[..], &other.orientations[..]].concat(),
            rotation: self.rotation.max(other.rotation),
            velocity: self.velocity.max(other.velocity),
            angular_velocity: self.angular_velocity.max(other.angular_velocity),
        }
    }

    fn widened(&self, margin: f64, haste: f64, radius: f64) -> Self {
        let velocity = haste * self.velocity;
        Self {
            lowest: self.lowest.map(|least| least - margin),
            highest: self.highest.map(|most| most + margin),
            orientations: self.orientations.clone(),
            rotation: margin / radius,
            velocity,
            angular_velocity: (haste * self.angular_velocity).max(velocity / radius),
        }
    }

    fn contains(&self, other: &Self) -> bool {
        let is_inside =
            |axis: usize| self.lowest[axis] <= other.lowest[axis] && other.highest[axis] <= self.highest[axis];
        (0..3).all(is_inside)
            && other.orientations.iter().all(|orientation| self.is_near(orientation))
            && other.velocity <= self.velocity
            && other.angular_velocity <= self.angular_velocity
    }

    fn is_near(&self, orientation: &UnitQuaternion<f64>) -> bool {
        // The cosine of half of the angle between two orientations is the size of their scalar product.
        let least = (0.5 * self.rotation.min(std::f64::consts::PI)).cos() - ROUNDING;
        self.orientations.iter().any(|known| known.coords.dot(&orientation.coords).abs() >= least)
    }
}

#[cfg(test)]
mod tests {
    use task::Pose;

    use super::*;

    /// Through positions along x (m), a second apart.
    fn along(positions: &[f64]) -> Reference {
        let mut before = positions[0];
        let mut knot = |&x: &f64| {
            let mut state = Pose([x, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).at_rest();
            state.0[7] = x - std::mem::replace(&mut before, x);
            state
        };
        Reference::new(1.0, &positions.iter().map(&mut knot).collect::<Vec<_>>())
    }

    #[test]
    fn references_stay_near_where_limits_say_nothing() {
        let wide = along(&[0.0, 0.1, 0.5]);
        assert!(Bounds::new(Limits::NONE).allow(&wide));
        let bounds = Bounds::new(Limits::NONE).near(&[&along(&[0.0, 0.1, 0.2])], 0.05, 2.0, 0.5);
        assert!(bounds.allow(&along(&[0.0, 0.2, 0.25])), "twice as fast, and 0.05 m further");
        assert!(!bounds.allow(&along(&[0.0, 0.21, 0.2])), "too fast");
        assert!(!bounds.allow(&along(&[0.0, 0.1, 0.26])), "too far");
        assert!(!bounds.allow(&wide));
        let mut turning = along(&[0.0, 0.1, 0.2]).states();
        turning[1].0[12] = 0.39;
        assert!(bounds.allow(&Reference::new(1.0, &turning)), "corners 0.5 m away are as fast as the body may be");
        turning[1].0[12] = 0.41;
        assert!(!bounds.allow(&Reference::new(1.0, &turning)), "rotates too fast");
        let mut rotated = along(&[0.0, 0.1, 0.2]).states();
        // The farthest corner may be shifted by 0.05 m as well.
        for (angle, allowed) in [(0.099_f64, true), (0.101, false)] {
            rotated[1].0[3..7].copy_from_slice(&[(0.5 * angle).cos(), 0.0, (0.5 * angle).sin(), 0.0]);
            assert_eq!(bounds.allow(&Reference::new(1.0, &rotated)), allowed, "rotated by {angle} rad");
        }
        assert!(bounds.including(&Reference::new(1.0, &rotated)).allow(&Reference::new(1.0, &rotated)));
        assert!(bounds.including(&wide).allow(&wide));
        let limited = Limits { translational_velocity: 0.15, ..Limits::NONE };
        assert!(
            !Bounds::new(limited).near(&[&wide], 0.0, 2.0, 0.5).including(&wide).allow(&wide),
            "limits always hold"
        );
    }
}
