//! Pieces of messages: what a user wrote, and names that would be valid.

/// The first line of a user's text, short enough for a message.
pub fn clipped(written: &str) -> String {
    clipped_to(written.lines().next().unwrap_or_default(), 60)
}

/// The first characters of a text, without control characters.
pub fn clipped_to(text: &str, length: usize) -> String {
    let shown: String =
        text.chars().take(length).map(|shown| if input::is_control(shown) { ' ' } else { shown }).collect();
    if text.chars().nth(length).is_some() { shown + "..." } else { shown }
}

/// The nearest valid name, or all of them when none is near.
pub fn suggest(unknown: &str, valid: &[&str]) -> String {
    match nearest(unknown, valid) {
        Some(nearest) => format!(", did you mean `{nearest}`?"),
        None => format!("; valid are: {}", listed(valid)),
    }
}

/// The names, or the first ones of many.
pub fn listed(names: &[&str]) -> String {
    const SHOWN: usize = 20;
    let shown = names[..names.len().min(SHOWN)].join(", ");
    if names.len() > SHOWN { format!("{shown} and {} more", names.len() - SHOWN) } else { shown }
}

/// The nearest valid name, if one is near: the only one that ends with the unknown name as a word, else the most similar one.
pub fn nearest<'name>(unknown: &str, valid: &[&'name str]) -> Option<&'name str> {
    const NEAR: f64 = 0.6;
    let word = format!("_{unknown}");
    let mut longer = valid.iter().filter(|name| name.ends_with(&word));
    if let (Some(only), None) = (longer.next(), longer.next()) {
        return Some(only);
    }
    let similarities = valid.iter().map(|name| (strsim::jaro_winkler(unknown, name), *name));
    let (similarity, name) = similarities.max_by(|(one, _), (other, _)| one.total_cmp(other))?;
    (similarity >= NEAR).then_some(name)
}
