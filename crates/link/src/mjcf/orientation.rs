//! The five ways to state an orientation.

use nalgebra::{Matrix3, Rotation3, Unit, UnitQuaternion, Vector3};

use crate::element::Value;
use crate::error::ModelError;
use crate::mjcf::compiler::Compiler;
use crate::mjcf::defaults::Levels;

/// The orientation of an element, none where it states none.
pub fn orientation(levels: &Levels, compiler: &Compiler) -> Result<UnitQuaternion<f64>, ModelError> {
    let angle = |angle: f64| if compiler.is_in_degrees { angle.to_radians() } else { angle };
    match levels.one_of(&["quat", "axisangle", "euler", "xyaxes", "zaxis"])? {
        None => Ok(UnitQuaternion::identity()),
        Some((0, value)) => value.rotation(value.numbers()?),
        Some((1, value)) => {
            let [x, y, z, turn] = value.numbers()?;
            Ok(UnitQuaternion::from_axis_angle(&value.direction([x, y, z])?, angle(turn)))
        }
        Some((2, value)) => Ok(euler(compiler.euler_axes, value.numbers::<3>()?.map(angle))),
        Some((3, value)) => from_axes(&value),
        Some((_, value)) => Ok(from_z(&value.direction(value.numbers()?)?)),
    }
}

/// Turns about axes of the body (small letters) or of its parent (capitals), one after the other.
fn euler(axes: &str, angles: [f64; 3]) -> UnitQuaternion<f64> {
    axes.chars().zip(angles).fold(UnitQuaternion::identity(), |before, (axis, angle)| {
        let direction = match axis.to_ascii_lowercase() {
            'x' => Vector3::x_axis(),
            'y' => Vector3::y_axis(),
            _ => Vector3::z_axis(),
        };
        let turn = UnitQuaternion::from_axis_angle(&direction, angle);
        if axis.is_ascii_lowercase() { before * turn } else { turn * before }
    })
}

/// The x axis as given, and the y axis as near to the given one as it can be.
fn from_axes(axes: &Value) -> Result<UnitQuaternion<f64>, ModelError> {
    let [a, b, c, d, e, f] = axes.numbers()?;
    let x = axes.direction([a, b, c])?;
    let y = Vector3::new(d, e, f);
    let y = axes.direction((y - x.dot(&y) * x.into_inner()).into())?;
    let columns = [x.into_inner(), y.into_inner(), x.cross(&y)];
    Ok(UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(Matrix3::from_columns(&columns))))
}

/// The shortest rotation of the z axis to a direction; a half turn is about x.
pub fn from_z(direction: &Unit<Vector3<f64>>) -> UnitQuaternion<f64> {
    let half_turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI);
    UnitQuaternion::rotation_between(&Vector3::z(), direction).unwrap_or(half_turn)
}
