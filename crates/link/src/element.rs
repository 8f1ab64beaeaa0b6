//! Values of XML elements with their places.

use std::ops::Range;

use nalgebra::{Isometry3, Quaternion, UnitQuaternion};
use roxmltree::Node;

use crate::error::ModelError;

/// Larger numbers are a mistake.
const LARGEST: f64 = 1e6;
/// A quaternion or axis that is shorter has no direction.
const SHORTEST: f64 = 1e-6;

/// The text of an attribute or element.
pub struct Value<'text> {
    /// Its name in messages.
    name: &'text str,
    pub text: &'text str,
    span: Range<usize>,
}

/// An attribute of an element, if it is given.
pub fn attribute<'text>(element: Node<'text, 'text>, name: &str) -> Option<Value<'text>> {
    let attribute = element.attribute_node(name)?;
    Some(Value { name: attribute.name(), text: attribute.value().trim(), span: attribute.range() })
}

/// An attribute of an element that must be given.
pub fn require_attribute<'text>(element: Node<'text, 'text>, name: &str) -> Result<Value<'text>, ModelError> {
    attribute(element, name).ok_or_else(|| refuse(element, format!("<{}> has no `{name}`", tag(element))))
}

/// The shape of a collision, which must have one: each of several needs a collision of its own.
///
/// # Errors
/// When it has none or several.
pub fn only_shape<'text>(collision: Node<'text, 'text>) -> Result<Node<'text, 'text>, ModelError> {
    let shapes = child(collision, "geometry")?.into_iter().flat_map(|geometry| geometry.children());
    let mut shapes = shapes.filter(Node::is_element);
    let Some(shape) = shapes.next() else { return Err(refuse(collision, "<collision> has no geometry")) };
    match shapes.next() {
        None => Ok(shape),
        Some(second) => Err(refuse(second, "a second shape in one <geometry>: give it a <collision> of its own")),
    }
}

/// The only child of a name, if there is one.
pub fn child<'text>(element: Node<'text, 'text>, name: &str) -> Result<Option<Node<'text, 'text>>, ModelError> {
    let mut found = children(element, name);
    let first = found.next();
    match found.next() {
        None => Ok(first),
        Some(second) => {
            Err(refuse(second, format!("a second <{name}> in one <{}>: only one can be meant", tag(element))))
        }
    }
}

/// All children of a name.
pub fn children<'text, 'name>(
    element: Node<'text, 'text>,
    name: &'name str,
) -> impl Iterator<Item = Node<'text, 'text>> + use<'text, 'name> {
    element.children().filter(move |child| child.has_tag_name(name))
}

/// The text of a child of a name that must be there.
pub fn require_content<'text>(element: Node<'text, 'text>, name: &str) -> Result<Value<'text>, ModelError> {
    let child = child(element, name)?;
    child.map(content).ok_or_else(|| refuse(element, format!("<{}> has no <{name}>", tag(element))))
}

/// The text of an element.
pub fn content<'text>(element: Node<'text, 'text>) -> Value<'text> {
    Value { name: tag(element), text: element.text().unwrap_or_default().trim(), span: element.range() }
}

/// Name of an element.
pub fn tag<'text>(element: Node<'text, 'text>) -> &'text str {
    element.tag_name().name()
}

/// An error about an element.
pub fn refuse(element: Node, message: impl Into<String>) -> ModelError {
    ModelError::new(element.range(), message)
}

/// An error about a shape or another element that is not read.
pub fn unsupported(element: Node, what: &str) -> ModelError {
    refuse(element, format!("{what} is not supported: use boxes, cylinders or STL or OBJ meshes in its place"))
}

impl<'text> Value<'text> {
    /// An error about the value.
    pub fn refuse(&self, message: &str) -> ModelError {
        ModelError::new(self.span.clone(), format!("{} \"{}\" {message}", self.name, shortened(self.text)))
    }

    /// All its numbers, which are separated by blanks.
    pub fn list(&self) -> Result<Vec<f64>, ModelError> {
        let number = |word: &str| {
            let number: f64 = word.parse().map_err(|_| self.refuse("must be numbers with blanks between them"))?;
            let is_reasonable = number.abs() <= LARGEST;
            is_reasonable.then_some(number).ok_or_else(|| self.refuse("must have finite numbers below 1e6"))
        };
        self.text.split_whitespace().map(number).collect()
    }

    /// A fixed number of numbers.
    pub fn numbers<const N: usize>(&self) -> Result<[f64; N], ModelError> {
        let wrong = |list: Vec<f64>| self.refuse(&format!("must have {N} numbers, not {}", list.len()));
        self.list()?.try_into().map_err(wrong)
    }

    /// The first of its numbers, all positive.
    pub fn first_lengths<const N: usize>(&self) -> Result<[f64; N], ModelError> {
        let list = self.list()?;
        let Some(lengths) = list.first_chunk::<N>() else {
            return Err(self.refuse(&format!("must have {N} numbers, not {}", list.len())));
        };
        if lengths.iter().all(|&length| length > 0.0) { Ok(*lengths) } else { Err(self.refuse("must be positive")) }
    }

    /// A fixed number of positive numbers.
    pub fn lengths<const N: usize>(&self) -> Result<[f64; N], ModelError> {
        self.numbers::<N>()?;
        self.first_lengths()
    }

    /// One positive number.
    pub fn length(&self) -> Result<f64, ModelError> {
        self.lengths().map(|[length]| length)
    }

    /// The factor of a scaling that is the same along all axes.
    pub fn uniform_scale(&self) -> Result<f64, ModelError> {
        let [x, y, z] = self.numbers()?;
        if x > 0.0 && x == y && x == z {
            return Ok(x);
        }
        Err(self.refuse("must be positive and the same along all axes: stretch or mirror the mesh in its file"))
    }

    /// `true`, `1` or something else.
    pub fn is_true(&self) -> bool {
        self.text == "true" || self.text == "1"
    }

    /// A direction of length one.
    pub fn direction(&self, vector: [f64; 3]) -> Result<nalgebra::Unit<nalgebra::Vector3<f64>>, ModelError> {
        let direction = nalgebra::Unit::try_new(vector.into(), SHORTEST);
        direction.ok_or_else(|| self.refuse("must be a direction, not zero"))
    }

    /// A rotation as a quaternion of any length but zero.
    pub fn rotation(&self, [w, x, y, z]: [f64; 4]) -> Result<UnitQuaternion<f64>, ModelError> {
        let rotation = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), SHORTEST);
        rotation.ok_or_else(|| self.refuse("must have a quaternion, not zero"))
    }
}

/// A pose of a position (m) and angles (rad) about the fixed axes x, y and z, in this order.
pub fn pose(position: [f64; 3], [roll, pitch, yaw]: [f64; 3]) -> Isometry3<f64> {
    let rotation = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
    Isometry3::from_parts(position.into(), rotation)
}

/// The name of a shape, or its element and number.
pub fn shape_name(element: Node, number: usize) -> String {
    match element.attribute("name").filter(|name| !name.trim().is_empty()) {
        Some(name) => name.to_owned(),
        None => format!("{} {number}", element.tag_name().name()),
    }
}

/// The beginning of a file's text, for messages.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 60;
    let shown: String = text.chars().take(LONGEST).map(|shown| if shown.is_control() { ' ' } else { shown }).collect();
    if text.chars().nth(LONGEST).is_some() { shown + "..." } else { shown }
}
