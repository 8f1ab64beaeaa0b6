//! Names in XML.

/// Text for an attribute or an element: no character of it is markup.
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe += "&amp;",
            '<' => safe += "&lt;",
            '>' => safe += "&gt;",
            '"' => safe += "&quot;",
            '\'' => safe += "&apos;",
            other => safe.push(other),
        }
    }
    safe
}

/// Text for a comment, which must not contain two hyphens.
pub fn comment(text: &str) -> String {
    // Of three in a row, the first replacement leaves two.
    format!("<!-- {} -->", text.replace("--", "- -").replace("--", "- -"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_no_markup() {
        assert_eq!(escaped(r#"a<b>&"c'"#), "a&lt;b&gt;&amp;&quot;c&apos;");
        assert_eq!(comment("a --> b-"), "<!-- a - -> b- -->");
        assert_eq!(comment("a---"), "<!-- a- - - -->");
    }
}
