//! Reactions to Ctrl-C, requests to terminate and the end of a parent process.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

use crate::console::remove_bar;
use crate::exit::{CommandError, Exit};

/// Set by the first interrupt, once a command has requested it.
static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// Ctrl-C, a request to terminate and a lost terminal end the program at once with its own exit code, until a command asks for
/// [`stop_flag`].
///
/// # Errors
/// When the system does not let a program handle them.
pub fn begin() -> Result<(), CommandError> {
    outlive_large_files();
    name_aborts();
    let handler = || match STOP.get() {
        Some(flag) => flag.store(true, Ordering::Relaxed),
        None => {
            remove_bar();
            std::process::exit(Exit::Interrupted as i32)
        }
    };
    ctrlc::set_handler(handler).map_err(|error| CommandError::System(format!("interrupts cannot be handled: {error}")))
}

/// A flag that an interrupt sets from now on instead of ending the program: the solve then ends with its last iterate.
pub fn stop_flag() -> Arc<AtomicBool> {
    Arc::clone(STOP.get_or_init(Arc::default))
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

/// Files that outgrow the limit of the system (`ulimit -f`) are then errors like those of a full disk, where the signal would
/// have ended the program without a word.
fn outlive_large_files() {
    #[cfg(unix)]
    // A command that does not watch the flag is ended by the signal, as any other program.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

/// Exhausted memory or stack ends the program with the exit code of a system failure, after a message.
fn name_aborts() {
    #[cfg(unix)]
    // Without it, the program ends by the signal.
    let _ = signal_hook::flag::register_conditional_shutdown(
        signal_hook::consts::SIGABRT,
        Exit::Failed as i32,
        Arc::new(AtomicBool::new(true)),
    );
}
