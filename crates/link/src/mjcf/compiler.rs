//! Settings of a whole MJCF file.

use roxmltree::Node;

use crate::element::{Value, attribute, children};
use crate::error::ModelError;

/// How a file is read.
pub struct Compiler<'text> {
    /// Whether angles are in degrees.
    pub is_in_degrees: bool,
    /// Axes of Euler angles: `xyz` rotate with the body, `XYZ` do not.
    pub euler_axes: &'text str,
    /// Folder of mesh files, relative to the model.
    pub mesh_folder: &'text str,
    /// Whether only the last part of the names of mesh files counts.
    pub is_path_stripped: bool,
}

impl<'text> Compiler<'text> {
    /// Of the file of an element. Of several values the last one holds.
    pub fn of(element: Node<'text, 'text>) -> Result<Self, ModelError> {
        let elements: Vec<Node> = children(element.document().root_element(), "compiler").collect();
        let last = |name| elements.iter().rev().find_map(|compiler| attribute(*compiler, name));
        if let Some(global) = last("coordinate").filter(|coordinate| coordinate.text != "local") {
            return Err(global.refuse("is not supported: convert the file with MuJoCo 2.3.3 or older"));
        }
        let is_in_degrees = match last("angle") {
            None => true,
            Some(unit) if unit.text == "degree" => true,
            Some(unit) if unit.text == "radian" => false,
            Some(unit) => return Err(unit.refuse("must be degree or radian")),
        };
        let euler_axes = last("eulerseq").map_or(Ok("xyz"), |axes| euler_axes(&axes))?;
        let mesh_folder = last("meshdir").or_else(|| last("assetdir")).map_or("", |folder| folder.text);
        let is_path_stripped = match last("strippath") {
            None => false,
            Some(strip) if strip.text == "false" => false,
            Some(strip) if strip.text == "true" => true,
            Some(strip) => return Err(strip.refuse("must be true or false")),
        };
        Ok(Self { is_in_degrees, euler_axes, mesh_folder, is_path_stripped })
    }
}

fn euler_axes<'text>(axes: &Value<'text>) -> Result<&'text str, ModelError> {
    let is_axis = |axis: char| "xyzXYZ".contains(axis);
    let is_known = axes.text.chars().count() == 3 && axes.text.chars().all(is_axis);
    is_known.then_some(axes.text).ok_or_else(|| axes.refuse("must be three of x, y, z, X, Y, Z"))
}
