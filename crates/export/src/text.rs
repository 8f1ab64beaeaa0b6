//! Text of files in text for people and robots: it stays text.

/// A name or title without characters that could end its line, change its direction or close its quotes.
pub fn plain(text: &str) -> String {
    text.chars()
        .filter(|letter| !input::is_control(*letter))
        .map(|letter| if letter == '`' { '\'' } else { letter })
        .collect()
}

/// A template whose `{{name}}` are replaced by their values, all in one pass: what stands in a value stays as it is.
pub fn filled(template: &str, values: &[(&str, String)]) -> String {
    let mut text = String::with_capacity(template.len());
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        text += before;
        let value = after.split_once("}}").and_then(|(name, behind)| {
            values.iter().find(|(known, _)| *known == name).map(|(_, value)| (value, behind))
        });
        rest = match value {
            Some((value, behind)) => {
                text += value;
                behind
            }
            None => {
                text += "{{";
                after
            }
        };
    }
    text + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_not_a_template() {
        let values = [("scene", "{{knots}}".to_owned()), ("knots", "1".to_owned())];
        assert_eq!(filled("# {{scene}} {{knots}} {{other}} {{", &values), "# {{knots}} 1 {{other}} {{");
    }

    #[test]
    fn a_title_is_one_line_from_left_to_right() {
        assert_eq!(plain("a\n  movej(1)\u{1b}[2J\u{202e}b`c`\u{2028}\u{7f}é"), "a  movej(1)[2Jb'c'é");
    }
}
