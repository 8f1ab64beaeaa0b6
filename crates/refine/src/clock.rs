//! How the time of a refinement is shared out.

use std::time::Duration;

use plan::Session;

/// Fraction of the time that is left for the comparison at the end.
const COMPARISON: f64 = 0.04;

/// Time that has passed since the run began, by the clock of its session, and time that is left.
pub struct Clock<'run> {
    session: &'run Session<'run>,
    /// Time that earlier runs have taken.
    earlier: Duration,
    limit: Duration,
}

/// When a part of the work has to end, as the time that the run has then taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Deadline(Duration);

impl<'run> Clock<'run> {
    /// All work ends when the run has taken `limit`, or earlier where the session's time for work does.
    pub fn new(session: &'run Session<'run>, limit: Duration) -> Self {
        let limit = session.end_of_work().map_or(limit, |end| end.min(limit));
        Self { session, earlier: Duration::ZERO, limit }
    }

    /// After runs that have taken some time, which is counted in the [total](Self::total) only.
    pub fn after(self, earlier: Duration) -> Self {
        Self { earlier, ..self }
    }

    /// Time that the run has taken.
    pub fn elapsed(&self) -> Duration {
        self.session.clock.elapsed()
    }

    /// Time that this and earlier runs have taken.
    pub fn total(&self) -> Duration {
        self.earlier + self.elapsed()
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
        Clock { session, earlier: self.earlier, limit: limit.0 }
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
        self.session.is_interrupted() || self.elapsed() >= until.0
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
    use std::time::Instant;

    use plan::{Event, RunClock};

    use super::*;

    #[test]
    fn shares_are_of_the_time_that_is_left() {
        let (stopped, passed, begin) = (AtomicBool::new(false), AtomicU64::new(0), Instant::now());
        let seconds = Duration::from_secs;
        let now = || begin + seconds(passed.load(Ordering::Relaxed));
        let session = Session { clock: RunClock::with(&now), ..Session::new(&|_: &Event| {}, &stopped) };
        passed.store(40, Ordering::Relaxed);
        let clock = Clock::new(&session, seconds(100)).after(seconds(7));
        assert_eq!((clock.elapsed(), clock.total()), (seconds(40), seconds(47)));
        let half = clock.share(clock.limit(), 0.5);
        assert_eq!(half, Deadline(seconds(70)));
        assert!(!clock.is_over(half) && clock.is_over(Deadline(seconds(40))));
        assert!(clock.end() > half && clock.end() < clock.limit());
        assert_eq!(clock.as_much_again(), Deadline(seconds(80)));
        assert_eq!(clock.until(half, &session).limit(), half);
        passed.store(60, Ordering::Relaxed);
        assert_eq!(clock.as_much_again(), clock.end());
        passed.store(200, Ordering::Relaxed);
        assert!(clock.is_over(clock.share(clock.end(), 0.5)));
        passed.store(40, Ordering::Relaxed);
        stopped.store(true, Ordering::Relaxed);
        assert!(clock.is_over(half), "the user has interrupted");
    }

    #[test]
    fn a_session_with_less_time_ends_the_work_earlier_and_leaves_some_for_writing() {
        let stopped = AtomicBool::new(false);
        let seconds = Duration::from_secs;
        let clock = RunClock::start().limited(Some(seconds(50)));
        let session = Session { clock, ..Session::new(&|_: &Event| {}, &stopped) };
        let limit = Clock::new(&session, seconds(100)).limit();
        assert!(Deadline(seconds(48)) < limit && limit < Deadline(seconds(50)), "{limit:?}");
        assert_eq!(Clock::new(&session, seconds(10)).limit(), Deadline(seconds(10)));
    }
}
