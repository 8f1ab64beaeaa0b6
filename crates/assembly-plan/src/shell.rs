//! Paths in commands for a shell.

use std::path::Path;

/// A path as one word of a POSIX shell, in quotation marks where it needs them.
pub fn word(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = |letter: char| letter.is_alphanumeric() || "_./+=:@%,-".contains(letter);
    match text.chars().all(is_plain) && !text.is_empty() {
        true => text,
        false => format!("'{}'", text.replace('\'', r"'\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_one_word() {
        let word = |text: &str| word(Path::new(text));
        assert_eq!(word("out/peg1-1"), "out/peg1-1");
        assert_eq!(word("my parts/a.toml"), "'my parts/a.toml'");
        assert_eq!(word("it's"), r"'it'\''s'");
        assert_eq!(word("$HOME"), "'$HOME'");
    }
}
