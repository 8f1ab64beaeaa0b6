//! The program: how it is begun, stopped and what it says.

use std::ffi::OsStr;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::sync::mpsc;
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// A run that is to be made.
pub struct TestCommand {
    command: Command,
    line: String,
}

/// A run under way.
pub struct Running {
    child: Child,
    line: String,
    /// Standard error once [`Running::read_until`] has taken it over: it is read to its end.
    stderr: Option<JoinHandle<Vec<u8>>>,
}

/// Longest wait for something that comes within seconds on an idle machine: it ends tests that would hang.
pub const WATCHDOG: Duration = Duration::from_secs(600);

/// A run that has ended.
#[derive(Debug)]
pub struct Run {
    /// Exit code; none if a signal ended it.
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
    line: String,
}

impl TestCommand {
    pub fn new(folder: &Path, line: &str) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_assembly-plan"));
        command.current_dir(folder).args(words(line)).stdin(Stdio::null());
        command.env_remove("SLURM_ARRAY_TASK_ID").env_remove("HQ_TASK_ID");
        Self { command, line: line.to_owned() }
    }

    /// Runs the program from a shell that sets something up, such as `ulimit -f 1`.
    pub fn in_shell(folder: &Path, setup: &str, line: &str) -> Self {
        let mut command = Command::new("sh");
        command.current_dir(folder).args(["-c", &format!("{setup}; exec \"$@\""), "sh"]);
        command.arg(env!("CARGO_BIN_EXE_assembly-plan")).args(words(line)).stdin(Stdio::null());
        Self { command, line: line.to_owned() }
    }

    pub fn arg(mut self, argument: impl AsRef<OsStr>) -> Self {
        self.command.arg(argument);
        self
    }

    /// Adds the words of a line.
    pub fn args(mut self, line: &str) -> Self {
        self.command.args(words(line));
        self
    }

    pub fn env(mut self, name: &str, value: &str) -> Self {
        self.command.env(name, value);
        self
    }

    pub fn run(self) -> Run {
        self.spawn().finish()
    }

    pub fn spawn(mut self) -> Running {
        let child = self.command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        Running { child, line: self.line, stderr: None }
    }
}

impl Running {
    /// Sends a signal, such as `INT`.
    #[track_caller]
    pub fn signal(&self, signal: &str) {
        let arguments = ["-s", signal, &self.child.id().to_string()];
        assert!(Command::new("kill").args(arguments).status().unwrap().success());
    }

    /// Whether a signal, such as `TERM`, reaches a handler of its own.
    #[cfg(target_os = "linux")]
    pub fn handles(&self, signal: &str) -> bool {
        let number = match signal {
            "ABRT" => 6,
            "TERM" => 15,
            other => panic!("{other}: add its number"),
        };
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).unwrap_or_default();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap_or_default();
        u64::from_str_radix(caught.trim(), 16).is_ok_and(|caught| caught >> (number - 1) & 1 == 1)
    }

    pub fn has_ended(&mut self) -> bool {
        self.child.try_wait().unwrap().is_some()
    }

    /// Waits for something that the running program does; it must not end before.
    #[track_caller]
    pub fn wait_until(&mut self, what: &str, is_so: impl Fn() -> bool) {
        let begun = Instant::now();
        while !is_so() {
            assert!(!self.has_ended(), "{}: ended before {what}", self.line);
            assert!(begun.elapsed() < WATCHDOG, "{}: timed out waiting for {what}", self.line);
            thread::sleep(Duration::from_millis(2));
        }
    }

    /// Reads standard error up to a line with some words; the rest is read as it comes, so that the program can go on.
    #[track_caller]
    pub fn read_until(&mut self, words: &str) {
        let mut reader = BufReader::new(self.child.stderr.take().unwrap());
        let mut heard = String::new();
        while !heard.lines().next_back().is_some_and(|line| line.contains(words)) {
            assert!(reader.read_line(&mut heard).unwrap() > 0, "{}: never said {words}\n{heard}", self.line);
        }
        self.stderr = Some(thread::spawn(move || {
            let mut all = heard.into_bytes();
            reader.read_to_end(&mut all).unwrap();
            all
        }));
    }

    /// Stops listening to both streams.
    pub fn close_streams(&mut self) {
        drop((self.child.stdout.take(), self.child.stderr.take()));
    }

    /// Waits for the end.
    pub fn finish(self) -> Run {
        let mut output = self.child.wait_with_output().unwrap();
        if let Some(stderr) = self.stderr {
            output.stderr = stderr.join().unwrap();
        }
        Run::new(output, self.line)
    }

    /// Waits for the end, which must come within [`WATCHDOG`]; the program is killed otherwise.
    #[track_caller]
    pub fn finish_in_time(self) -> Run {
        let (id, line) = (self.child.id(), self.line.clone());
        let (sender, receiver) = mpsc::channel();
        thread::spawn(move || sender.send(self.finish()));
        receiver.recv_timeout(WATCHDOG).unwrap_or_else(|_| {
            Command::new("kill").args(["-KILL", &id.to_string()]).status().unwrap();
            panic!("{line}: has not ended after {WATCHDOG:?}");
        })
    }
}

impl Run {
    fn new(output: Output, line: String) -> Self {
        let Output { status, stdout, stderr } = output;
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        Self { code: status.code(), stdout: text(stdout), stderr: text(stderr), line }
    }

    /// Expects an exit code.
    #[track_caller]
    pub fn code(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{}\n{}{}", self.line, self.stdout, self.stderr);
        self
    }

    /// Expects some words on one of the streams.
    #[track_caller]
    pub fn says(self, words: &str) -> Self {
        assert!(self.has(words), "{}: `{words}` is missing in\n{}{}", self.line, self.stdout, self.stderr);
        self
    }

    /// Expects some words on none of the streams.
    #[track_caller]
    pub fn keeps_silent_about(self, words: &str) -> Self {
        assert!(!self.has(words), "{}: `{words}` is in\n{}{}", self.line, self.stdout, self.stderr);
        self
    }

    pub fn has(&self, words: &str) -> bool {
        self.stdout.contains(words) || self.stderr.contains(words)
    }
}

/// The words of a line; single quotes hold a word together, which may be empty.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut is_quoted) = (Vec::new(), None::<String>, false);
    for letter in line.chars() {
        match letter {
            '\'' => {
                is_quoted = !is_quoted;
                word.get_or_insert_default();
            }
            ' ' if !is_quoted => words.extend(word.take()),
            _ => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    words
}
