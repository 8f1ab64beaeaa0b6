//! Threads that share the pieces of work of one computation. They stay between calls, because a solve calls thousands
//! of times for work of a fraction of a millisecond.
//!
//! Results arrive in the order of the pieces, in the calling thread. Which thread computes a piece, and when, is not
//! determined; the boundaries of pieces must not depend on the number of threads.

use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Polls of a piece that another thread computes before the waiting thread offers its processor to others.
const POLLS: usize = 1000;

/// The calling thread and those that help it.
#[derive(Debug, Clone, Default)]
pub struct Workers {
    /// The helpers; none with one thread.
    helpers: Option<Arc<ThreadPool>>,
}

impl Workers {
    /// A number of threads, including the calling one; fewer where the system does not provide them.
    pub fn new(threads: usize) -> Self {
        let helpers = threads.saturating_sub(1);
        let build = || ThreadPoolBuilder::new().num_threads(helpers).thread_name(|_| "worker".to_owned()).build();
        Self { helpers: if helpers == 0 { None } else { build().ok().map(Arc::new) } }
    }

    /// As many threads as there are processors.
    pub fn of_all_processors() -> Self {
        Self::new(std::thread::available_parallelism().map_or(1, Into::into))
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        1 + self.helpers.as_ref().map_or(0, |helpers| helpers.current_num_threads())
    }

    /// Does all pieces of work.
    pub fn each<T: Send>(&self, pieces: impl Iterator<Item = T>, work: impl Fn(T) + Sync) {
        self.in_order(pieces, work, |()| ControlFlow::Continue(()));
    }

    /// Results of all pieces of work, in the order of the pieces.
    ///
    /// # Panics
    /// When `work` panics.
    pub fn map<T: Send, R: Send>(&self, pieces: impl Iterator<Item = T>, work: impl Fn(T) -> R + Sync) -> Vec<R> {
        let mut results = Vec::with_capacity(pieces.size_hint().0);
        self.in_order(pieces, work, |result| {
            results.push(result);
            ControlFlow::Continue(())
        });
        results
    }

    /// Does all pieces of work and passes their results to `take` in the calling thread, in the order of the pieces.
    /// Results are taken as soon as possible, and the calling thread helps with the work while the next result is
    /// missing. When `take` breaks, pieces that no thread has started are dropped.
    ///
    /// # Panics
    /// When `work` or `take` panics.
    pub fn in_order<T: Send, R: Send>(
        &self,
        pieces: impl Iterator<Item = T>,
        work: impl Fn(T) -> R + Sync,
        mut take: impl FnMut(R) -> ControlFlow<()>,
    ) {
        let Some(helpers) = &self.helpers else {
            let _all_or_broken = pieces.map(work).try_for_each(take);
            return;
        };
        let desk = Desk::new(pieces.collect(), work);
        helpers.in_place_scope(|scope| {
            for _ in 1..self.threads().min(desk.results.len()) {
                scope.spawn(|_| {
                    let _report = ReportPanic(&desk.panicked);
                    while desk.do_next() {}
                });
            }
            for index in 0..desk.results.len() {
                let Some(result) = desk.result(index) else { break };
                if take(result).is_break() {
                    desk.close();
                    break;
                }
            }
        });
    }
}

/// Results of two pieces of work that are done at the same time.
///
/// # Panics
/// When one of both does.
pub fn both<A, B: Send>(one: impl FnOnce() -> A, other: impl FnOnce() -> B + Send) -> (A, B) {
    std::thread::scope(|scope| {
        let other = scope.spawn(other);
        (one(), other.join().unwrap_or_else(|panic| resume_unwind(panic)))
    })
}

/// Pieces of work that wait and their results.
struct Desk<T, R, W> {
    pieces: Mutex<std::iter::Enumerate<std::vec::IntoIter<T>>>,
    results: Vec<Mutex<Option<R>>>,
    work: W,
    /// Whether a helper has panicked, whose result will never come.
    panicked: AtomicBool,
}

impl<T, R, W: Fn(T) -> R> Desk<T, R, W> {
    fn new(pieces: Vec<T>, work: W) -> Self {
        let results = pieces.iter().map(|_| Mutex::new(None)).collect();
        Self { pieces: Mutex::new(pieces.into_iter().enumerate()), results, work, panicked: AtomicBool::new(false) }
    }

    /// Does the next piece; false when there is none.
    fn do_next(&self) -> bool {
        let next = lock(&self.pieces).next();
        let Some((index, piece)) = next else { return false };
        let result = (self.work)(piece);
        *lock(&self.results[index]) = Some(result);
        true
    }

    /// Waits for a result and works meanwhile; `None` after a panic.
    fn result(&self, index: usize) -> Option<R> {
        let mut polls = 0;
        loop {
            if let Some(result) = lock(&self.results[index]).take() {
                return Some(result);
            }
            if self.panicked.load(Ordering::Acquire) {
                return None;
            }
            if !self.do_next() {
                polls += 1;
                if polls < POLLS { std::hint::spin_loop() } else { std::thread::yield_now() }
            }
        }
    }

    /// Drops the pieces that no thread has started.
    fn close(&self) {
        lock(&self.pieces).by_ref().for_each(drop);
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Tells the calling thread of a panic.
struct ReportPanic<'flag>(&'flag AtomicBool);

impl Drop for ReportPanic<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.store(true, Ordering::Release);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::panic::{AssertUnwindSafe, catch_unwind};

    use super::*;

    #[test]
    fn results_come_in_order_with_any_number_of_threads() {
        for threads in [0, 1, 2, 3, 7] {
            let workers = Workers::new(threads);
            assert_eq!(workers.threads(), threads.max(1));
            for count in [0, 1, 2, 1000] {
                let results = workers.map(0..count, |index| 2 * index);
                assert!(results.into_iter().eq((0..count).map(|index| 2 * index)), "{threads} threads, {count} pieces");
            }
        }
    }

    #[test]
    fn nothing_is_taken_after_a_break() {
        for threads in [1, 3] {
            let mut taken = Vec::new();
            Workers::new(threads).in_order(
                0..1000,
                |index| index,
                |result| {
                    taken.push(result);
                    if result == 4 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
                },
            );
            assert_eq!(taken, [0, 1, 2, 3, 4]);
        }
    }

    #[test]
    fn pieces_may_be_mutable_slices() {
        let mut numbers = vec![1; 1000];
        Workers::new(2).each(numbers.chunks_mut(7), |chunk| chunk.iter_mut().for_each(|number| *number += 1));
        assert!(numbers.iter().all(|&number| number == 2));
    }

    #[test]
    fn both_are_done_and_a_panic_of_either_ends_the_call() {
        assert_eq!(both(|| 1, || "two"), (1, "two"));
        assert!(catch_unwind(|| both(|| 1, || -> i32 { panic!("of the other") })).is_err());
        assert!(catch_unwind(|| both(|| -> i32 { panic!("of the one") }, || 2)).is_err());
    }

    #[test]
    fn a_panic_of_a_piece_ends_the_call() {
        let workers = Workers::new(3);
        for bad in [0, 500, 999] {
            let call = || workers.each(0..1000, |index| assert_ne!(index, bad));
            assert!(catch_unwind(AssertUnwindSafe(call)).is_err());
        }
        workers.each(0..10, drop);
    }
}
