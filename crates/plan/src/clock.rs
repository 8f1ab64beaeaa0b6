//! The one clock of a run.

use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread::Builder;
use std::time::{Duration, Instant};

/// Between two looks at the time while a thread works.
pub const LOOK: Duration = Duration::from_millis(10);
/// Stack of such a thread, as much as main threads have.
pub const STACK: usize = 8 << 20;

/// The present time.
pub type Now<'run> = &'run (dyn Fn() -> Instant + Sync);

/// The elapsed time of a run, everything included, and its limit.
#[derive(Clone, Copy)]
pub struct RunClock<'run> {
    now: Now<'run>,
    begin: Instant,
    limit: Option<Duration>,
}

impl RunClock<'static> {
    /// A run that starts now, without a limit.
    pub fn start() -> Self {
        Self::with(&Instant::now)
    }
}

impl<'run> RunClock<'run> {
    /// [`RunClock::start`] with another source of time.
    pub fn with(now: Now<'run>) -> Self {
        Self { now, begin: now(), limit: None }
    }

    /// The run may take so long; any time for `None`.
    pub fn limited(self, limit: Option<Duration>) -> Self {
        Self { limit, ..self }
    }

    /// Time since the run began.
    pub fn elapsed(&self) -> Duration {
        (self.now)().saturating_duration_since(self.begin)
    }

    /// Time limit of the run, from its start to its end.
    pub fn limit(&self) -> Option<Duration> {
        self.limit
    }

    /// When the run has to end, if ever.
    pub fn deadline(&self) -> Option<Instant> {
        self.begin.checked_add(self.limit?)
    }

    /// The result of work in a thread of its own; `None` if the time limit of the run ends first, or no thread can be
    /// started.
    pub fn wait_for<T: Send + 'static>(&self, work: impl FnOnce() -> T + Send + 'static) -> Option<T> {
        let (sender, results) = sync_channel(1);
        let thread = Builder::new().stack_size(STACK).spawn(move || drop(sender.send(work()))).ok()?;
        loop {
            match results.recv_timeout(LOOK) {
                Ok(result) => return Some(result),
                Err(RecvTimeoutError::Timeout) if self.limit.is_some_and(|limit| self.elapsed() >= limit) => {
                    return None;
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => {
                    thread.join().unwrap_or_else(|panic| resume_unwind(panic));
                    return None;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::sync::mpsc::channel;

    use super::*;

    #[test]
    fn nobody_waits_for_work_when_the_time_is_over() {
        let (begin, looks) = (Instant::now(), AtomicU64::new(0));
        // Every look at the clock takes a second.
        let now = || begin + Duration::from_secs(looks.fetch_add(1, Ordering::Relaxed));
        let clock = RunClock::with(&now).limited(Some(Duration::from_secs(5)));
        let (release, released) = channel::<()>();
        assert_eq!(
            clock.wait_for(move || {
                let _ = released.recv();
            }),
            None
        );
        assert!(looks.load(Ordering::Relaxed) < 10);
        drop(release);
        assert_eq!(RunClock::start().wait_for(|| 7), Some(7), "without a limit all work ends");
    }
}
