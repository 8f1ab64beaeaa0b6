//! When a body has come to rest for good.

/// Speed (m/s) of any point of the body below which it rests.
const SPEED: f64 = 1e-6;
/// Time (s) after which a body that rests does not turn back, if its controller answers at once.
const TIME: f64 = 0.1;

/// How long a body has rested while its reference is held.
#[derive(Debug, Clone, Copy)]
pub struct Rest {
    /// In seconds.
    time: f64,
    /// After which it is final (s).
    wanted: f64,
}

impl Rest {
    /// Of a body whose controller answers after at most so long (s).
    pub fn new(latency: f64) -> Self {
        Self { time: 0.0, wanted: TIME + latency }
    }

    /// After a step of some duration (s), when no point of the body is faster than `speed` (m/s).
    pub fn add(&mut self, duration: f64, speed: f64) {
        self.time = if speed < SPEED { self.time + duration } else { 0.0 };
    }

    /// Whether friction holds the body: nothing changes any more.
    pub fn is_final(&self) -> bool {
        self.time >= self.wanted
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_that_turns_back_does_not_rest() {
        let mut rest = Rest::new(0.0);
        (0..99).for_each(|_| rest.add(1e-3, 0.0));
        assert!(!rest.is_final());
        rest.add(1e-3, 1e-5);
        (0..99).for_each(|_| rest.add(1e-3, 1e-7));
        assert!(!rest.is_final());
        rest.add(2e-3, 0.0);
        assert!(rest.is_final());
        rest.add(1e-3, f64::NAN);
        assert!(!rest.is_final());
        let mut late = Rest::new(0.5);
        late.add(0.55, 0.0);
        assert!(!late.is_final());
        late.add(0.1, 0.0);
        assert!(late.is_final());
    }
}
