//! SDF.

use std::path::Path;

use nalgebra::Isometry3;
use roxmltree::Node;

use crate::element::{
    attribute, child, children, content, only_shape, pose, require_content, shape_name, tag, unsupported,
};
use crate::error::ModelError;
use crate::mesh_file::mesh_file;
use crate::shape::{Geometry, LinkShape};

/// The links with collision shapes.
pub fn links<'text>(root: Node<'text, 'text>) -> Vec<(String, Node<'text, 'text>)> {
    let links =
        root.descendants().filter(|node| node.has_tag_name("link") && children(*node, "collision").next().is_some());
    links.map(|link| (scoped_name(link), link)).collect()
}

/// The name of a link after those of the models that it is nested in. The one model of a file needs none.
fn scoped_name(link: Node) -> String {
    let is_nested = |node: &Node| {
        let is_in_world = || node.parent().is_some_and(|parent| !parent.has_tag_name("sdf"));
        node.has_tag_name("link") || node.has_tag_name("model") && is_in_world()
    };
    let mut names: Vec<&str> =
        link.ancestors().filter(is_nested).map(|node| node.attribute("name").unwrap_or_default()).collect();
    names.reverse();
    names.join("::")
}

/// The collision shapes of a link.
pub fn shapes<'text>(link: Node<'text, 'text>, file: &Path) -> Result<Vec<LinkShape>, ModelError> {
    let mut shapes = Vec::new();
    for (number, collision) in (1..).zip(children(link, "collision")) {
        let Some(geometry) = geometry(collision, file)? else { continue };
        let name = shape_name(collision, number);
        let pose = child(collision, "pose")?.map_or(Ok(Isometry3::identity()), |pose| pose_in(pose, link))?;
        shapes.push(LinkShape { name, pose, geometry, span: collision.range() });
    }
    Ok(shapes)
}

/// A pose in the frame of a link.
fn pose_in<'text>(element: Node<'text, 'text>, link: Node) -> Result<Isometry3<f64>, ModelError> {
    // SDF up to 1.6 says `frame`.
    let frame = attribute(element, "relative_to").or_else(|| attribute(element, "frame"));
    if let Some(frame) = frame.filter(|frame| !frame.text.is_empty() && Some(frame.text) != link.attribute("name")) {
        return Err(frame.refuse("is not followed: state the pose in the frame of the link"));
    }
    let value = content(element);
    if value.text.is_empty() {
        return Ok(Isometry3::identity());
    }
    match attribute(element, "rotation_format").map(|format| (format.text, format)) {
        None | Some(("euler_rpy", _)) => {
            let [x, y, z, angles @ ..] = value.numbers::<6>()?;
            let is_in_degrees = attribute(element, "degrees").is_some_and(|degrees| degrees.is_true());
            let angles = if is_in_degrees { angles.map(f64::to_radians) } else { angles };
            Ok(pose([x, y, z], angles))
        }
        Some(("quat_xyzw", _)) => {
            let [x, y, z, i, j, k, w] = value.numbers()?;
            Ok(Isometry3::from_parts([x, y, z].into(), value.rotation([w, i, j, k])?))
        }
        Some((_, format)) => Err(format.refuse("must be euler_rpy or quat_xyzw")),
    }
}

/// The geometry of a collision; an empty one does not count.
fn geometry<'text>(collision: Node<'text, 'text>, file: &Path) -> Result<Option<Geometry>, ModelError> {
    let shape = only_shape(collision)?;
    Ok(Some(match tag(shape) {
        "empty" => return Ok(None),
        "box" => Geometry::Box { edges: require_content(shape, "size")?.lengths()? },
        "cylinder" => Geometry::Cylinder {
            radius: require_content(shape, "radius")?.length()?,
            length: require_content(shape, "length")?.length()?,
        },
        "mesh" => {
            if let Some(submesh) = child(shape, "submesh")? {
                return Err(unsupported(submesh, "a submesh"));
            }
            let scale = child(shape, "scale")?.map(content);
            Geometry::Mesh {
                file: mesh_file(&require_content(shape, "uri")?, file)?,
                scale: scale.map_or(Ok(1.0), |scale| scale.uniform_scale())?,
            }
        }
        other => return Err(unsupported(shape, other)),
    }))
}
