//! Work in a thread of its own, of which the interpreter hears and which it can interrupt.

use std::ffi::CString;
use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use planner::{Event, Observer, PlannerError, Session};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::errors::{SceneWarning, exception};

/// Stack of the thread, as programs have it for their first one.
const STACK: usize = 8 << 20;
/// Between two looks at signals.
const TICK: Duration = Duration::from_millis(50);
/// How long interrupted work may continue before the interpreter stops waiting for it. Files are written whole or not
/// at all.
const PATIENCE: Duration = Duration::from_secs(1);

/// Messages of the thread to the interpreter.
enum Message {
    /// Name and fields, as JSON.
    Event(&'static str, String),
    Warning(String),
}

/// The thread's side: sends messages, and knows whether to stop.
pub struct Watch {
    messages: Sender<Message>,
    wants_events: bool,
    stopped: Arc<AtomicBool>,
}

impl Watch {
    /// Sends a warning for the user.
    pub fn warn(&self, warning: String) {
        self.tell(Message::Warning(warning));
    }

    /// The session of the work: it forwards events, stops at an interrupt, and has the requested threads.
    pub fn session(&self, jobs: Option<usize>) -> Session<'_> {
        let session = Session::new(self, &self.stopped);
        Session { threads: jobs.unwrap_or(session.threads), ..session }
    }

    fn tell(&self, message: Message) {
        // Without a listener, messages are dropped.
        let _ = self.messages.send(message);
    }
}

impl Observer for Watch {
    fn observe(&self, event: &Event) {
        if self.wants_events {
            let (name, fields) = event.record();
            self.tell(Message::Event(name, fields.to_string()));
        }
    }
}

/// Works in a thread, calls `progress` here with name and fields of every event, and warns here. A signal, or an exception
/// of `progress`, stops the work and is raised.
pub fn run<T, F>(py: Python, progress: Option<&Bound<PyAny>>, work: F) -> PyResult<T>
where
    T: Send + 'static,
    F: FnOnce(&Watch) -> Result<T, PlannerError> + Send + 'static,
{
    let (messages, heard) = channel();
    let stopped = Arc::new(AtomicBool::new(false));
    let watch = Watch { messages, wants_events: progress.is_some(), stopped: Arc::clone(&stopped) };
    // The thread owns the only sender: once it has ended, there are no more messages.
    let worker = Builder::new().stack_size(STACK).spawn(move || work(&watch));
    let worker = worker.map_err(|error| PyRuntimeError::new_err(format!("no thread can be started: {error}")))?;
    if let Err(raised) = listen(py, progress, heard) {
        stopped.store(true, Ordering::Relaxed);
        py.detach(|| wait(&worker));
        return Err(raised);
    }
    match py.detach(|| worker.join()) {
        Ok(result) => result.map_err(|error| exception(&error)),
        Err(panic) => resume_unwind(panic),
    }
}

/// Waits until interrupted work has ended, but not for ever.
fn wait<T>(worker: &JoinHandle<T>) {
    let since = Instant::now();
    while !worker.is_finished() && since.elapsed() < PATIENCE {
        std::thread::sleep(TICK);
    }
}

/// Hears until the thread has ended.
fn listen(py: Python, progress: Option<&Bound<PyAny>>, mut heard: Receiver<Message>) -> PyResult<()> {
    loop {
        let message;
        (message, heard) = py.detach(move || (heard.recv_timeout(TICK), heard));
        match (message, progress) {
            (Ok(Message::Event(name, fields)), Some(progress)) => _ = progress.call1((name, fields))?,
            (Ok(Message::Warning(warning)), _) => warn(py, warning)?,
            (Err(RecvTimeoutError::Disconnected), _) => return Ok(()),
            (Ok(Message::Event(..)) | Err(RecvTimeoutError::Timeout), _) => {}
        }
        py.check_signals()?;
    }
}

fn warn(py: Python, warning: String) -> PyResult<()> {
    // From the planner through the method of the package, and what reads its former names, to whom has called that.
    let caller = py.import("sys")?.call_method1("_getframe", (1,))?;
    let file: String = caller.getattr("f_code")?.getattr("co_filename")?.extract()?;
    let level = if file.ends_with("_renamed.py") { 3 } else { 2 };
    PyErr::warn(py, &py.get_type::<SceneWarning>(), &CString::new(warning)?, level)
}
