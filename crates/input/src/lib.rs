//! What comes from outside: files of any kind and size, and text that a terminal might obey.

mod file;
mod text;

pub use file::{append, read, require_regular};
pub use text::{is_control, shown};
