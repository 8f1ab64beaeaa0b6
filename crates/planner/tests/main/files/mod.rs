//! Every file is read back as it was written, and nothing is replaced that no earlier run has written.

mod folder;
mod round_trips;
mod support;
