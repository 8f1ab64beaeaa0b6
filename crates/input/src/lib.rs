//! What comes from outside: files of any kind and size, text that a terminal might obey, and names that have changed.

mod file;
mod renamed;
mod text;

pub use file::{append, read, require_regular};
pub use renamed::{FLAGS, KEYS, Renamed};
pub use text::{is_control, shown};
