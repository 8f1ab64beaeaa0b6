//! The program as a user runs it: one binary, so that all tests share [`support`].

mod batch;
mod calibrate;
mod carried;
mod command_line;
mod documentation;
mod end_to_end;
mod executed;
mod explained;
mod export;
mod failures;
mod hostile;
mod limits;
mod mujoco;
mod mutations;
mod outputs;
mod progress;
mod report;
mod resume;
mod robust;
mod simulate;
mod starting;
mod support;
mod tolerance;
mod turned;
mod verdicts;
mod wrong_inputs;
