//! Lines, words and numbers of text files, whatever their encoding and line ends: only ASCII matters in them.

use crate::error::MeshError;

/// A message shows this much of a word (bytes).
const SHOWN: usize = 24;

/// The bytes without the mark that some programs put before UTF-8.
pub fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// The lines, counted from one, that end with LF, CR LF or CR.
pub fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    let mut rest = Some(without_mark(bytes));
    let lines = std::iter::from_fn(move || {
        let bytes = rest?;
        let Some(end) = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')) else {
            return rest.take();
        };
        let length = if bytes[end..].starts_with(b"\r\n") { 2 } else { 1 };
        rest = Some(&bytes[end + length..]);
        Some(&bytes[..end])
    });
    (1..).zip(lines)
}

/// The words of a line. Padding and the end mark of old systems separate words as blanks do.
pub fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|byte| is_blank(*byte)).filter(|word| !word.is_empty())
}

/// Whether a byte only separates words or fills a file up.
pub fn is_blank(byte: u8) -> bool {
    byte.is_ascii_whitespace() || matches!(byte, 0x00 | 0x0b | 0x1a)
}

/// A finite number.
///
/// # Errors
/// When the word is something else.
pub fn number(word: &[u8], line: usize) -> Result<f64, MeshError> {
    let parsed = str::from_utf8(word).ok().and_then(|word| word.parse::<f64>().ok());
    match parsed {
        Some(number) if number.is_finite() => Ok(number),
        _ if word.contains(&b',') => {
            Err(at(line, format!("{} has a comma: numbers need decimal points, and blanks between them", shown(word))))
        }
        _ => Err(at(line, format!("{} is not a finite number", shown(word)))),
    }
}

/// An error in a line.
pub fn at(line: usize, problem: impl Into<String>) -> MeshError {
    MeshError::Line { line, problem: problem.into() }
}

/// A word as messages show it.
pub fn shown(word: &[u8]) -> String {
    let (clipped, rest) = word.split_at(word.len().min(SHOWN));
    format!("`{}{}`", clipped.escape_ascii(), if rest.is_empty() { "" } else { "..." })
}
