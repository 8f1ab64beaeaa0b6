//! Text of files in what people read: it stays text.

/// Whether a character could end a line, change the direction of text, or be obeyed by a terminal.
pub fn is_control(character: char) -> bool {
    character.is_control()
        || matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Lines as they may be shown in a terminal: what it might obey, but for the ends of lines and tabulators, is written
/// as its number, such as `\u{1b}`.
pub fn shown(lines: &str) -> String {
    let mut shown = String::with_capacity(lines.len());
    for character in lines.chars() {
        match is_control(character) && !matches!(character, '\n' | '\t') {
            true => shown.extend(character.escape_unicode()),
            false => shown.push(character),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_might_obey_is_shown_by_its_number() {
        assert_eq!(shown("a\u{1b}[2J\tb\nc\u{202e}d\u{7f}é"), "a\\u{1b}[2J\tb\nc\\u{202e}d\\u{7f}é");
    }
}
