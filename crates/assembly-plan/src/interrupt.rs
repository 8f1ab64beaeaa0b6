//! What Ctrl-C, requests to terminate and the end of a parent process do.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::console::remove_bar;
use crate::exit::{CommandError, Exit};

/// A flag that Ctrl-C and a request to terminate set: the solve then ends with its last iterate.
pub fn stop_flag() -> Result<Arc<AtomicBool>, CommandError> {
    let stopped = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&stopped);
    handle(move || flag.store(true, Ordering::Relaxed))?;
    Ok(stopped)
}

/// Sets the flag when standard input ends: a batch holds the other end of it, so its cells stop when it wants them to
/// and also when it is killed itself.
pub fn stop_with_parent(stopped: Arc<AtomicBool>) {
    std::thread::spawn(move || {
        // An input that cannot be read has ended too.
        let _ = std::io::copy(&mut std::io::stdin(), &mut std::io::sink());
        stopped.store(true, Ordering::Relaxed);
    });
}

/// Ends the program at once, for what writes nothing before all is done.
pub fn exit_at_once() -> Result<(), CommandError> {
    handle(|| {
        remove_bar();
        std::process::exit(Exit::Interrupted as i32)
    })
}

/// Files that outgrow the limit of the system (`ulimit -f`) are then errors like those of a full disk, where the signal would
/// have ended the program without a word.
pub fn outlive_large_files() {
    #[cfg(unix)]
    // Who cannot be told of the signal is ended by it, as every other program.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

fn handle(handler: impl FnMut() + Send + 'static) -> Result<(), CommandError> {
    ctrlc::set_handler(handler).map_err(|error| CommandError::System(format!("interrupts cannot be handled: {error}")))
}
