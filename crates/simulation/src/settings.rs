//! How a rollout is computed.

/// Time steps and friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Largest time step (s), above zero; the interval between two knots is divided into equal steps that are not longer.
    pub time_step: f64,
    /// Coulomb's coefficient; 0 is the frictionless contact of the paper. Friction is Anitescu's convex approximation
    /// (Optimization-based simulation of nonsmooth rigid multibody dynamics, 2006): sticking and the force of sliding
    /// are Coulomb's, but a body that slides at a speed `v` hovers `friction v time_step` above the surface.
    pub friction: f64,
    /// How long the last reference pose is held (s), rounded up to whole intervals between knots.
    pub settling_time: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { time_step: 1e-3, friction: 0.0, settling_time: 1.0 }
    }
}

/// A quotient this little above a whole number is one: 0.033 / 0.001 is 33.
const ROUNDING: f64 = 1e-9;

impl Settings {
    /// Step (s) and number of steps in an interval between two knots (s).
    pub fn divide(&self, interval: f64) -> (f64, usize) {
        let count = (interval / self.time_step - ROUNDING).ceil().max(1.0);
        (interval / count, count as usize)
    }

    /// Number of intervals between knots for which the last pose is held.
    pub fn settling_intervals(&self, interval: f64) -> usize {
        (self.settling_time / interval - ROUNDING).ceil().max(0.0) as usize
    }
}
