//! URDF.

use std::path::Path;

use nalgebra::Isometry3;
use roxmltree::Node;

use crate::element::{attribute, child, children, only_shape, pose, require_attribute, shape_name, tag, unsupported};
use crate::error::ModelError;
use crate::mesh_file::mesh_file;
use crate::shape::{Geometry, LinkShape};

/// The links with collision shapes.
pub fn links<'text>(root: Node<'text, 'text>) -> Vec<(String, Node<'text, 'text>)> {
    let links = children(root, "link").filter(|link| children(*link, "collision").next().is_some());
    links.map(|link| (link.attribute("name").unwrap_or_default().to_owned(), link)).collect()
}

/// The collision shapes of a link.
pub fn shapes<'text>(link: Node<'text, 'text>, file: &Path) -> Result<Vec<LinkShape>, ModelError> {
    let shape = |(number, collision): (usize, Node<'text, 'text>)| {
        Ok(LinkShape {
            name: shape_name(collision, number),
            pose: child(collision, "origin")?.map_or(Ok(Isometry3::identity()), origin)?,
            geometry: geometry(collision, file)?,
            span: collision.range(),
        })
    };
    (1..).zip(children(link, "collision")).map(shape).collect()
}

fn origin<'text>(origin: Node<'text, 'text>) -> Result<Isometry3<f64>, ModelError> {
    let numbers = |name| attribute(origin, name).map_or(Ok([0.0; 3]), |value| value.numbers());
    Ok(pose(numbers("xyz")?, numbers("rpy")?))
}

fn geometry<'text>(collision: Node<'text, 'text>, file: &Path) -> Result<Geometry, ModelError> {
    let shape = only_shape(collision)?;
    match tag(shape) {
        "box" => Ok(Geometry::Box { edges: require_attribute(shape, "size")?.lengths()? }),
        "cylinder" => Ok(Geometry::Cylinder {
            radius: require_attribute(shape, "radius")?.length()?,
            length: require_attribute(shape, "length")?.length()?,
        }),
        "mesh" => Ok(Geometry::Mesh {
            file: mesh_file(&require_attribute(shape, "filename")?, file)?,
            scale: attribute(shape, "scale").map_or(Ok(1.0), |scale| scale.uniform_scale())?,
        }),
        other => Err(unsupported(shape, other)),
    }
}
