//! How the time of a refinement is shared out.

use std::time::{Duration, Instant};

use crate::session::Session;

/// Fraction of the time that is left for the comparison at the end.
const COMPARISON: f64 = 0.04;

/// Time that has passed and time that is left.
pub struct Clock<'run> {
    session: &'run Session<'run>,
    begin: Instant,
    /// Time that was spent before.
    spent: Duration,
    limit: Duration,
}

/// When a part of the work has to end, as the time that has then passed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Deadline(Duration);

impl<'run> Clock<'run> {
    /// Starts now.
    pub fn new(session: &'run Session<'run>, spent: Duration, limit: Duration) -> Self {
        Self { session, begin: Instant::now(), spent, limit }
    }

    /// Time that has passed, that of earlier work included.
    pub fn elapsed(&self) -> Duration {
        self.spent + self.begin.elapsed()
    }

    /// The end of all work but the comparison of what it has found.
    pub fn end(&self) -> Deadline {
        Deadline(self.limit.mul_f64(1.0 - COMPARISON))
    }

    /// The end of all work.
    pub fn limit(&self) -> Deadline {
        Deadline(self.limit)
    }

    /// When as much time again has passed, or the end of all work but the comparison.
    pub fn as_much_again(&self) -> Deadline {
        Deadline(2 * self.elapsed()).min(self.end())
    }

    /// The same clock, but with an earlier end of all work, for another session.
    pub fn until<'other>(&self, limit: Deadline, session: &'other Session<'other>) -> Clock<'other> {
        Clock::new(session, self.elapsed(), limit.0)
    }

    /// Time until the comparison.
    pub fn left(&self) -> Duration {
        self.end().0.saturating_sub(self.elapsed())
    }

    /// The end of a fraction of the time that is left until a deadline.
    pub fn share(&self, until: Deadline, fraction: f64) -> Deadline {
        let elapsed = self.elapsed();
        Deadline(elapsed + until.0.saturating_sub(elapsed).mul_f64(fraction))
    }

    /// Whether a deadline has passed, or the user has interrupted.
    pub fn is_over(&self, until: Deadline) -> bool {
        self.session.is_interrupted() || self.elapsed() > until.0
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::*;
    use crate::session::Event;

    #[test]
    fn shares_are_of_the_time_that_is_left() {
        let stopped = AtomicBool::new(false);
        let session = Session::new(&|_: &Event| {}, &stopped);
        let seconds = Duration::from_secs;
        let clock = Clock::new(&session, seconds(40), seconds(100));
        let half = clock.share(clock.limit(), 0.5);
        assert!(half >= Deadline(seconds(70)) && half < Deadline(seconds(71)));
        assert!(!clock.is_over(half) && clock.is_over(Deadline(seconds(40))));
        assert!(clock.end() > half && clock.end() < clock.limit());
        let again = clock.as_much_again();
        assert!(again >= Deadline(seconds(80)) && again < Deadline(seconds(81)));
        assert_eq!(Clock::new(&session, seconds(60), seconds(100)).as_much_again(), clock.end());
        let sooner = clock.until(again, &session);
        assert!(sooner.limit() == again && sooner.elapsed() >= seconds(40));
        let late = Clock::new(&session, seconds(200), seconds(100));
        assert!(late.is_over(late.share(late.end(), 0.5)));
        stopped.store(true, std::sync::atomic::Ordering::Relaxed);
        assert!(clock.is_over(half), "the user has interrupted");
    }
}
