//! Boxes along the axes of a frame, given by their lower and upper corners.

use nalgebra::Isometry3;

/// All corners of a box.
pub fn corners_of(&[low, high]: &[[f64; 3]; 2]) -> [[f64; 3]; 8] {
    std::array::from_fn(|corner| {
        std::array::from_fn(|axis| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] })
    })
}

/// The smallest box along the axes of a frame that holds a box of its parent.
pub fn in_frame(parent: &[[f64; 3]; 2], placement: &Isometry3<f64>) -> [[f64; 3]; 2] {
    let mut frame = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for corner in corners_of(parent) {
        let point = placement.inverse_transform_point(&corner.into());
        for axis in 0..3 {
            frame[0][axis] = frame[0][axis].min(point[axis]);
            frame[1][axis] = frame[1][axis].max(point[axis]);
        }
    }
    frame
}
