//! A homotopy in a thread of its own: an iteration of the solver with a thousand pairs takes seconds, and the session
//! does not wait for it once its time is over.

use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::thread::{Builder, JoinHandle};

use nlp::{Control, Progress, SolveError, SolveStatus, Start};
use ocp::{Event, Homotopy, HomotopyStep, IterationEnd};
use task::Smoothing;

use crate::clock::{LOOK, STACK};
use crate::error::PlannerError;
use crate::iteration::PlanIteration;
use crate::session::Session;
use crate::variant::Variant;

/// The homotopy of a variant.
pub struct HomotopyRun<'run> {
    /// The variant to solve.
    pub variant: &'run Variant,
    /// Threads that evaluate.
    pub threads: usize,
    /// Homotopy steps that another run has finished.
    pub earlier: &'run [PlanIteration],
    /// Start of the next homotopy step, if not that of the variant.
    pub start: Option<Start>,
}

/// The result of a homotopy step.
pub struct Solved {
    /// Its number, from 1.
    pub number: usize,
    pub iteration: PlanIteration,
    /// Whether it was stopped before it had ended.
    pub is_cut: bool,
}

/// How a homotopy ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// After its last homotopy step, or by request.
    ByItself,
    /// In an iteration of the solver, by request.
    Cut,
    /// When the time of the session was over.
    OutOfTime,
}

/// Messages of the solver's thread, each with a reply.
enum Message {
    Iteration { number: usize, most: usize, smoothing: Smoothing, progress: Progress },
    Solved(Box<Solved>),
}

impl<'run> HomotopyRun<'run> {
    /// From the beginning, with one thread.
    pub fn new(variant: &'run Variant) -> Self {
        Self { variant, threads: 1, earlier: &[], start: None }
    }

    /// Runs until it ends, `observe` or `finished` stops it, or the time of the session is over: then at once, and the
    /// running homotopy step is lost.
    ///
    /// # Errors
    /// When an option or the linear solver is rejected, or no thread can be started.
    pub fn run(
        self,
        session: &Session,
        mut observe: impl FnMut(&Event) -> Control,
        mut finished: impl FnMut(Solved) -> Control,
    ) -> Result<Ended, PlannerError> {
        let mut ended = Ended::ByItself;
        let Solver { messages, replies, thread } = self.start()?;
        loop {
            let message = match messages.recv_timeout(LOOK) {
                Ok(message) => message,
                Err(RecvTimeoutError::Timeout) if session.is_over() => return Ok(Ended::OutOfTime),
                Err(RecvTimeoutError::Timeout) => continue,
                Err(RecvTimeoutError::Disconnected) => {
                    return Ok(thread.join().unwrap_or_else(|panic| resume_unwind(panic)).map(|()| ended)?);
                }
            };
            let reply = match message {
                Message::Iteration { number, most, smoothing, progress } => {
                    observe(&Event { number, most, smoothing, progress: &progress })
                }
                Message::Solved(solved) => {
                    ended = if solved.is_cut { Ended::Cut } else { Ended::ByItself };
                    finished(*solved)
                }
            };
            if session.is_over() {
                return Ok(Ended::OutOfTime);
            }
            // A thread that does not listen any more has ended.
            let _ = replies.send(reply);
        }
    }

    /// The homotopy steps that are finished when it ends, or when `is_over` or the session ends it.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn finished(self, session: &Session, is_over: impl Fn() -> bool) -> Result<Vec<PlanIteration>, PlannerError> {
        let mut iterations = Vec::new();
        let observe = |_: &Event| if is_over() { Control::Stop } else { Control::Continue };
        self.run(session, observe, |Solved { iteration, is_cut, .. }| {
            iterations.extend((!is_cut).then_some(iteration));
            Control::Continue
        })?;
        Ok(iterations)
    }

    fn start(self) -> Result<Solver, PlannerError> {
        let (variant, threads, earlier, start) =
            (self.variant.clone(), self.threads, self.earlier.to_vec(), self.start);
        let ((sender, messages), (replies, receiver)) = (sync_channel(0), sync_channel(1));
        let line = Line { sender, receiver };
        let solve = move || solve(&variant, threads, &earlier, start, &line);
        let thread = Builder::new().name("homotopy".to_owned()).stack_size(STACK).spawn(solve);
        let thread = thread.map_err(|_| PlannerError::Internal("no thread for the solver"))?;
        Ok(Solver { messages, replies, thread })
    }
}

/// The thread of the solver, as the session sees it.
struct Solver {
    messages: Receiver<Message>,
    replies: SyncSender<Control>,
    thread: JoinHandle<Result<(), SolveError>>,
}

/// The session, as the thread of the solver sees it.
struct Line {
    sender: SyncSender<Message>,
    receiver: Receiver<Control>,
}

impl Line {
    /// Sends a message and waits for the reply; without a listener, the solver stops.
    fn say(&self, message: Message) -> Control {
        match self.sender.send(message) {
            Ok(()) => self.receiver.recv().unwrap_or(Control::Stop),
            Err(_) => Control::Stop,
        }
    }
}

fn solve(
    variant: &Variant,
    threads: usize,
    earlier: &[PlanIteration],
    start: Option<Start>,
    line: &Line,
) -> Result<(), SolveError> {
    let homotopy = Homotopy::new(&variant.task, variant.settings.clone()).with_threads(threads);
    let formulation = homotopy.formulation(earlier.len() + 1);
    let start = start.unwrap_or_else(|| {
        Start::Cold(match &variant.near {
            None => formulation.initial_guess(),
            Some(motion) => formulation.point_at(motion),
        })
    });
    let ends: Vec<IterationEnd> = earlier.iter().map(PlanIteration::end).collect();
    let observe = |event: Event| {
        let Event { number, most, smoothing, progress } = event;
        line.say(Message::Iteration { number, most, smoothing, progress: *progress })
    };
    let finished = |number: usize, iteration: &HomotopyStep| {
        let is_cut = iteration.status == SolveStatus::Interrupted;
        line.say(Message::Solved(Box::new(Solved { number, iteration: PlanIteration::from(iteration), is_cut })))
    };
    homotopy.run_from(&ends, start, observe, finished).map(drop)
}
