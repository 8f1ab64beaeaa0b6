//! Gains of the admittance law.

use nalgebra::Matrix3;
use task::{Impedance, Inertia};

/// Virtual mass, damping and stiffness: of translations (kg, Ns/m, N/m) and rotations (kg m^2, Nms/rad, Nm/rad), the same along
/// every axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    /// `M`.
    pub mass: [f64; 2],
    /// `D`.
    pub damping: [f64; 2],
    /// `K`.
    pub stiffness: [f64; 2],
}

impl Gains {
    /// Stiffness and damping.
    pub fn impedance(&self) -> Impedance {
        impedance(self.stiffness, self.damping)
    }

    /// Inertia and impedance that move as the law does behind a lag (s), to the second order in the lag. The part is where the
    /// law was a lag `T` ago, so `M a(t + T) + D v(t + T) + K x(t + T)` answers the wrench: a mass `M + D T + K T^2 / 2` with the
    /// damping `D + K T`. Damping acts on velocities relative to the reference.
    pub fn planned(&self, lag: f64) -> (Inertia, Impedance) {
        let of = |part: usize| {
            let (mass, damping, stiffness) = (self.mass[part], self.damping[part], self.stiffness[part]);
            (mass + damping * lag + 0.5 * stiffness * lag * lag, damping + stiffness * lag)
        };
        let ((mass, damping), (rotational, rotational_damping)) = (of(0), of(1));
        let inertia = Inertia::of_body(mass, Matrix3::from_diagonal_element(rotational));
        (inertia, impedance(self.stiffness, [damping, rotational_damping]))
    }
}

fn impedance(stiffness: [f64; 2], damping: [f64; 2]) -> Impedance {
    Impedance {
        translational_stiffness: stiffness[0],
        rotational_stiffness: stiffness[1],
        translational_damping: Matrix3::from_diagonal_element(damping[0]),
        rotational_damping: Matrix3::from_diagonal_element(damping[1]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lag_makes_the_planned_body_heavier() {
        let gains = Gains { mass: [10.0, 0.1], damping: [2000.0, 8.0], stiffness: [1000.0, 4.0] };
        let (inertia, impedance) = gains.planned(0.02);
        assert!((inertia.mean_mass() - (10.0 + 40.0 + 0.2)).abs() < 1e-12);
        assert!((inertia.rotational()[(1, 1)] - (0.1 + 0.16 + 0.0008)).abs() < 1e-12);
        assert!((impedance.translational_damping[(2, 2)] - 2020.0).abs() < 1e-9);
        assert_eq!((impedance.translational_stiffness, impedance.rotational_stiffness), (1000.0, 4.0));
        assert_eq!(gains.planned(0.0).1, gains.impedance());
    }
}
