//! External input: files of any kind and size, text with terminal controls, and names that have changed.

mod file;
mod renamed;
mod text;

pub use file::{append, read, require_regular};
pub use renamed::{FLAGS, KEYS, Renamed};
pub use text::{is_control, shown};
