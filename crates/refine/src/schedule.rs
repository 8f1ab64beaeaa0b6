//! Distribution of the time of a refinement.

use std::time::Duration;

use plan::Session;
use plan::parameters::TimeShares;

/// Elapsed time of a run by the clock of its session, and the shares of the rest.
pub struct Schedule<'run> {
    session: &'run Session<'run>,
    shares: TimeShares,
    /// Time of earlier runs.
    earlier: Duration,
    limit: Duration,
}

/// Deadline of a part of the work, as elapsed time of the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Deadline(Duration);

impl<'run> Schedule<'run> {
    /// All work ends when the run has taken `limit`, or earlier if the session's time for work ends earlier.
    pub fn new(session: &'run Session<'run>, limit: Duration, shares: TimeShares) -> Self {
        let limit = session.end_of_work().map_or(limit, |end| end.min(limit));
        Self { session, shares, earlier: Duration::ZERO, limit }
    }

    /// After runs that have taken some time, which counts in the [total](Self::total) only.
    pub fn after(self, earlier: Duration) -> Self {
        Self { earlier, ..self }
    }

    /// The same, but with an earlier end of all work, for another session.
    pub fn until<'other>(&self, limit: Deadline, session: &'other Session<'other>) -> Schedule<'other> {
        Schedule { session, shares: self.shares, earlier: self.earlier, limit: limit.0 }
    }

    /// Elapsed time of the run.
    pub fn elapsed(&self) -> Duration {
        self.session.clock.elapsed()
    }

    /// Elapsed time of this and earlier runs.
    pub fn total(&self) -> Duration {
        self.earlier + self.elapsed()
    }

    /// Whether a deadline has passed, or the user has interrupted.
    pub fn is_over(&self, until: Deadline) -> bool {
        self.session.is_interrupted() || self.elapsed() >= until.0
    }

    /// The end of all work.
    pub fn limit(&self) -> Deadline {
        Deadline(self.limit)
    }

    /// The end of all work but the final comparison.
    pub fn end(&self) -> Deadline {
        Deadline(self.limit.mul_f64(1.0 - self.shares.comparison))
    }

    /// The end of the homotopy of the scene itself.
    pub fn homotopy(&self) -> Duration {
        self.share(self.end(), self.shares.homotopy).0
    }

    /// The end of the refinement of the plan of the scene itself, or of its replacement.
    pub fn own(&self) -> Deadline {
        self.share(self.end(), self.shares.own)
    }

    /// The end of the refinement of a straight push.
    pub fn push(&self) -> Deadline {
        self.share(self.end(), self.shares.push)
    }

    /// The end of the solves of drafts, if a solve as long as the scene's own fits in before.
    pub fn drafts(&self, solving: Duration) -> Option<Deadline> {
        (solving < self.left().mul_f64(self.shares.drafts)).then(|| self.share(self.end(), self.shares.drafts))
    }

    /// The end of the time in which other drafts may replace one that gets stuck.
    pub fn other_drafts(&self) -> Deadline {
        self.share(self.end(), self.shares.other_drafts)
    }

    /// Number of variants that can be solved, each in as much time as the scene's own problem.
    pub fn affordable_variants(&self, solving: Duration) -> usize {
        (self.shares.solving * self.left().as_secs_f64() / solving.as_secs_f64()) as usize
    }

    /// The end of the next of `count` variants, which share the time.
    pub fn one_of(&self, count: usize) -> Deadline {
        self.share(self.end(), 1.0 / count as f64)
    }

    /// The end of the solve of a variant that has time until then.
    pub fn solving(&self, until: Deadline) -> Deadline {
        self.share(until, self.shares.solving)
    }

    /// The end of the perturbations of a refinement that has time until then.
    pub fn training(&self, until: Deadline) -> Deadline {
        self.share(until, self.shares.training)
    }

    /// The end of the refinement in the hardened environment, which may take as much time as the run so far.
    pub fn margins(&self) -> Deadline {
        let as_much_again = Deadline(2 * self.elapsed()).min(self.end());
        self.share(as_much_again, self.shares.margins)
    }

    /// The end of the simplification of a robust plan.
    pub fn simplification(&self) -> Deadline {
        self.share(self.end(), self.shares.simplification)
    }

    /// Time until the comparison.
    fn left(&self) -> Duration {
        self.end().0.saturating_sub(self.elapsed())
    }

    /// The end of a fraction of the time that is left until a deadline.
    fn share(&self, until: Deadline, fraction: f64) -> Deadline {
        let elapsed = self.elapsed();
        Deadline(elapsed + until.0.saturating_sub(elapsed).mul_f64(fraction))
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
        let shares = TimeShares { margins: 1.0, comparison: 0.25, ..TimeShares::default() };
        let schedule = Schedule::new(&session, seconds(120), shares).after(seconds(7));
        assert_eq!((schedule.elapsed(), schedule.total()), (seconds(40), seconds(47)));
        assert_eq!((schedule.limit(), schedule.end()), (Deadline(seconds(120)), Deadline(seconds(90))));
        let half = schedule.own();
        assert_eq!(half, Deadline(seconds(65)));
        assert!(!schedule.is_over(half) && schedule.is_over(Deadline(seconds(40))));
        assert_eq!(schedule.margins(), Deadline(seconds(80)), "as much time again");
        assert_eq!(schedule.until(half, &session).limit(), half);
        assert_eq!((schedule.drafts(seconds(15)), schedule.drafts(seconds(14))), (None, Some(Deadline(seconds(55)))));
        assert_eq!(schedule.affordable_variants(seconds(10)), 3, "in three fifths of the time");
        passed.store(60, Ordering::Relaxed);
        assert_eq!(schedule.margins(), schedule.end());
        passed.store(200, Ordering::Relaxed);
        assert!(schedule.is_over(schedule.own()));
        passed.store(40, Ordering::Relaxed);
        stopped.store(true, Ordering::Relaxed);
        assert!(schedule.is_over(half), "the user has interrupted");
    }

    #[test]
    fn a_session_with_less_time_ends_the_work_earlier_and_leaves_some_for_writing() {
        let stopped = AtomicBool::new(false);
        let seconds = Duration::from_secs;
        let clock = RunClock::start().limited(Some(seconds(50)));
        let session = Session { clock, ..Session::new(&|_: &Event| {}, &stopped) };
        let schedule = |limit: u64| Schedule::new(&session, seconds(limit), TimeShares::default());
        let limit = schedule(100).limit();
        assert!(Deadline(seconds(48)) < limit && limit < Deadline(seconds(50)), "{limit:?}");
        assert_eq!(schedule(10).limit(), Deadline(seconds(10)));
    }
}
