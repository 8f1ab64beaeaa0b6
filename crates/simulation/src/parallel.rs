//! Independent pieces of work on several threads.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::Builder;

/// More threads than this are not started.
const MAX_THREADS: usize = 1024;

/// Results of `count` pieces of work in their order, on `jobs` threads. The calling thread is one of them; when no more
/// can be started, those that run do all the work.
///
/// # Panics
/// When a piece of work does.
pub fn in_parallel<T: Send>(count: usize, jobs: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return done;
            }
            done.push((index, work(index)));
        }
    };
    let mut results: Vec<(usize, T)> = std::thread::scope(|scope| {
        let more = 1..jobs.min(count).min(MAX_THREADS);
        let threads: Vec<_> = more.map_while(|_| Builder::new().spawn_scoped(scope, worker).ok()).collect();
        let mut results = worker();
        for thread in threads {
            results.extend(thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        results
    });
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_number_of_jobs_gives_all_results_in_order() {
        for jobs in [0, 1, 3, usize::MAX] {
            assert!(in_parallel(5000, jobs, |index| 2 * index).into_iter().eq((0..5000).map(|index| 2 * index)));
        }
        assert!(in_parallel(0, 4, |index| index).is_empty());
    }
}
