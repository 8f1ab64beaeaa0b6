//! Whether what was chosen beside the scene is as large as it should be.

use plan::Problem;

/// Share of the body's size that an offset should not exceed: contact hardly leads a body farther.
const OFFSET: f64 = 0.5;

/// An offset or a position tolerance that is large beside the body.
pub fn warnings(problem: &Problem) -> Vec<String> {
    let (size, offset_magnitude, tolerance) =
        (problem.scene().body_size(), problem.offset_magnitude(), problem.success().position);
    // The scene itself remarks on an offset of its own that is larger than the body.
    let is_remarked = offset_magnitude == problem.scene().offset_magnitude && offset_magnitude > size;
    let offset = if offset_magnitude > size && !is_remarked {
        Some(format!("an offset of {offset_magnitude} m is larger than the body, {size:.3} m: is it in metres?"))
    } else if offset_magnitude > OFFSET * size && !is_remarked {
        let [offset, size] = [offset_magnitude, size].map(|length| 1e3 * length);
        Some(format!(
            "an offset of {offset:.2} mm is more than half of the body's size, {size:.2} mm: contact hardly leads a body that \
             far; is robustness.offset_magnitude (--delta) right?"
        ))
    } else {
        None
    };
    let tolerance = (tolerance > size).then(|| {
        format!("a position tolerance of {tolerance} m is larger than the body, {size:.3} m: is it in metres?")
    });
    offset.into_iter().chain(tolerance).collect()
}
