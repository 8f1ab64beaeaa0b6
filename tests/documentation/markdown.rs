//! What the tests need of Markdown: pages, fenced blocks, tables, code spans, links, headings.

use std::fs;
use std::path::{Path, PathBuf};

/// A page of the documentation.
pub struct Page {
    pub file: PathBuf,
    pub text: String,
}

/// A fenced block and the language after its opening fence.
pub struct Block<'page> {
    pub language: &'page str,
    pub text: String,
}

impl Page {
    pub fn read(file: PathBuf) -> Self {
        let text = fs::read_to_string(&file).unwrap();
        Self { file, text }
    }

    /// The name for messages.
    pub fn name(&self) -> String {
        self.file.file_name().unwrap().to_string_lossy().into_owned()
    }

    pub fn folder(&self) -> &Path {
        self.file.parent().unwrap()
    }

    pub fn blocks(&self) -> Vec<Block<'_>> {
        let mut blocks: Vec<Block> = Vec::new();
        let mut is_inside = false;
        for line in self.text.lines() {
            match line.strip_prefix("```") {
                Some(language) if !is_inside => {
                    blocks.push(Block { language, text: String::new() });
                    is_inside = true;
                }
                Some(_) => is_inside = false,
                None if is_inside => {
                    let block = blocks.last_mut().unwrap();
                    block.text += line;
                    block.text.push('\n');
                }
                None => {}
            }
        }
        blocks
    }

    pub fn blocks_of(&self, language: &str) -> Vec<String> {
        self.blocks().into_iter().filter(|block| block.language == language).map(|block| block.text).collect()
    }

    /// The text without fenced blocks.
    pub fn prose(&self) -> String {
        self.text.split("```").step_by(2).collect()
    }

    /// What stands between backticks, outside of fenced blocks.
    pub fn code_spans(&self) -> Vec<String> {
        self.prose().split('`').skip(1).step_by(2).map(str::to_owned).collect()
    }

    /// Targets of links and images, outside of fenced blocks.
    pub fn links(&self) -> Vec<String> {
        let prose = self.prose();
        prose.split("](").skip(1).map(|rest| rest.split(')').next().unwrap().to_owned()).collect()
    }

    /// Names under which links reach the headings.
    pub fn anchors(&self) -> Vec<String> {
        let headings = self.text.lines().filter(|line| line.starts_with('#'));
        headings.map(|heading| anchor(heading.trim_start_matches('#').trim())).collect()
    }

    /// Rows of all tables between the comment `<!-- BEGIN... -->` and the next `<!-- end of ... -->`, with what stands in
    /// the comment after BEGIN.
    pub fn marked_tables(&self, begin: &str) -> Vec<(String, Vec<Vec<String>>)> {
        let begin = format!("<!-- {begin}");
        let marked = self.text.split(&begin).skip(1);
        marked
            .map(|rest| {
                let (mark, rest) = rest.split_once(" -->").unwrap();
                (mark.trim().to_owned(), rows(rest.split("<!-- end of ").next().unwrap()))
            })
            .collect()
    }
}

/// Rows of a table without its two header lines.
fn rows(text: &str) -> Vec<Vec<String>> {
    let lines = text.lines().filter(|line| line.starts_with('|')).skip(2);
    let cells = |line: &str| {
        line.trim().trim_start_matches('|').trim_end_matches('|').split('|').map(|c| c.trim().to_owned()).collect()
    };
    lines.map(cells).collect()
}

/// What stands between backticks in a text.
pub fn spans(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
    kept.map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}
