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
    around(&corners_of(parent).map(|corner| placement.inverse_transform_point(&corner.into()).into()))
}

/// The smallest box around some points.
pub fn around(points: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let mut frame = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for point in points {
        for axis in 0..3 {
            frame[0][axis] = frame[0][axis].min(point[axis]);
            frame[1][axis] = frame[1][axis].max(point[axis]);
        }
    }
    frame
}

/// Whether two boxes have a point in common.
pub fn boxes_meet([low, high]: &[[f64; 3]; 2], [other_low, other_high]: &[[f64; 3]; 2]) -> bool {
    (0..3).all(|axis| low[axis] <= other_high[axis] && other_low[axis] <= high[axis])
}
