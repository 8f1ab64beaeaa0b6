//! Parts that are links of SDF, URDF and MJCF files.

use std::path::Path;
use std::sync::Arc;

use collision::{Pair, Polytope};
use link::{Geometry, Link, LinkShape, Model, ModelError};
use mesh::{MeshError, Solid, TriangleMesh};
use nalgebra::{Isometry3, Point3};

use crate::boxes::corners_of;
use crate::error::{SceneError, Source};
use crate::file::read_text;
use crate::mesh::{GivenMesh, Making};
use crate::table::Table;
use crate::words::{clipped, listed, suggest};

/// Depth (m) to which shapes may overlap by rounding.
const ROUNDING: f64 = 1e-7;

/// The collision shapes of the link that a part names, with their poses in its frame.
///
/// What is wrong in the model is shown there, that it cannot be read in the scene.
pub fn link_shapes<'text>(
    table: &Table<'text>,
    part: &str,
) -> Result<Vec<(GivenMesh<'text>, Isometry3<f64>)>, SceneError> {
    let entry = table.require("model")?;
    let (file, making) = (entry.file()?, Making::read(table)?);
    let text = read_text(&file, "model").map_err(|error| match error.line() {
        Some(_) => error,
        None => entry.refuse(error.headline()),
    })?;
    let source = Source { file: &file, text: &text };
    let in_model = |error: ModelError| source.error(error.span(), format!("part `{part}`: {error}"));
    let model = Model::parse(&file, &text).map_err(in_model)?;
    let links = model.links().map_err(in_model)?;
    let mut shapes = Vec::new();
    for shape in chosen(&links, table, &file)?.shapes().map_err(in_model)? {
        let problem =
            |error| source.error(shape.span.clone(), format!("part `{part}`: shape `{}`: {error}", shape.name));
        let solid = Arc::new(solid(&shape).map_err(problem)?);
        let given =
            GivenMesh { entry: table.require("model")?, file: file.clone(), shape: Some(shape.name), solid, making };
        shapes.push((given, shape.pose));
    }
    if shapes.is_empty() {
        return Err(entry.refuse(format!("model {}: all collision shapes of the link are empty", file.display())));
    }
    if making.density.is_some() {
        refuse_overlaps(&shapes)?;
    }
    Ok(shapes)
}

/// Triangles (m) of the collision shapes of a link of a model, in its frame: the one of a name, or the only one that has
/// collision shapes.
///
/// # Errors
/// When the model cannot be read, has no such link, has several and none is named, or a shape is not supported.
pub fn triangles_of_link(file: &Path, name: Option<&str>) -> Result<Vec<[[f64; 3]; 3]>, SceneError> {
    let text = read_text(file, "model")?;
    let source = Source { file, text: &text };
    let in_model = |error: ModelError| source.error(error.span(), error.to_string());
    let model = Model::parse(file, &text).map_err(in_model)?;
    let links = model.links().map_err(in_model)?;
    let link = match name {
        Some(name) => named(&links, name, file),
        None => only(&links, file, "--link"),
    };
    let link = link.map_err(|message| SceneError::about(file, message))?;
    let mut triangles = Vec::new();
    for shape in link.shapes().map_err(in_model)? {
        let solid = solid(&shape).map_err(|error| source.error(shape.span.clone(), error))?;
        let placed = |corner: [f64; 3]| <[f64; 3]>::from((shape.pose * Point3::from(corner)).coords);
        triangles.extend(solid.corner_triangles().map(|triangle| triangle.map(placed)));
    }
    Ok(triangles)
}

/// The only link; where there are several, one has to be chosen by a key or flag.
fn only<'links, 'model>(
    links: &'links [Link<'model>],
    file: &Path,
    choice: &str,
) -> Result<&'links Link<'model>, String> {
    let file = file.display();
    match links {
        [only] => Ok(only),
        [] => Err(format!("model {file} has no link with collision shapes")),
        _ => {
            let names: Vec<&str> = links.iter().map(|link| link.name.as_str()).collect();
            Err(format!("model {file} has several links; choose one with {choice}: {}", listed(&names)))
        }
    }
}

/// The link of a name.
fn named<'links, 'model>(
    links: &'links [Link<'model>],
    name: &str,
    file: &Path,
) -> Result<&'links Link<'model>, String> {
    let names: Vec<&str> = links.iter().map(|link| link.name.as_str()).collect();
    let named: Vec<&Link> = links.iter().filter(|link| link.name == name).collect();
    let file = file.display();
    match named[..] {
        [link] => Ok(link),
        [] => {
            let hint = if names.is_empty() { String::new() } else { suggest(name, &names) };
            Err(format!("model {file} has no link `{}` with collision shapes{hint}", clipped(name)))
        }
        _ => Err(format!("model {file} has {} links `{name}`: rename all but one", named.len())),
    }
}

/// The link that a part names, or the only one.
fn chosen<'links, 'model>(
    links: &'links [Link<'model>],
    table: &Table,
    file: &Path,
) -> Result<&'links Link<'model>, SceneError> {
    match table.find("link") {
        Some(entry) => named(links, &entry.name()?, file).map_err(|message| entry.refuse(message)),
        None => {
            let place = table.require("model")?;
            only(links, file, "`link`").map_err(|message| place.refuse(message))
        }
    }
}

/// The surface of a shape in its own frame.
fn solid(shape: &LinkShape) -> Result<Solid, String> {
    Solid::of(&triangles(shape)?).map_err(|error| explained(shape, &error))
}

/// The triangles of a shape in its own frame, closed or not.
pub fn triangles(shape: &LinkShape) -> Result<TriangleMesh, String> {
    let mesh = match &shape.geometry {
        Geometry::Box { edges } => TriangleMesh::cuboid(*edges),
        Geometry::Cylinder { radius, length } => TriangleMesh::cylinder(*radius, *length),
        Geometry::Mesh { file, scale } => TriangleMesh::read(file, *scale),
    };
    mesh.map_err(|error| explained(shape, &error))
}

/// An error with the file of the shape, if it has one.
fn explained(shape: &LinkShape, error: &MeshError) -> String {
    match &shape.geometry {
        Geometry::Mesh { file, .. } => format!("mesh {}: {error}", file.display()),
        _ => error.to_string(),
    }
}

/// Refuses shapes whose boxes overlap: their material would be counted twice.
fn refuse_overlaps(shapes: &[(GivenMesh, Isometry3<f64>)]) -> Result<(), SceneError> {
    let bounds = |(given, pose): &(GivenMesh, Isometry3<f64>)| {
        let corners = corners_of(&given.solid.bounding_box()).map(|corner| (pose * Point3::from(corner)).into());
        Polytope::from_vertices(&corners).map_err(|error| given.refuse(error))
    };
    let bounds: Vec<Polytope> = shapes.iter().map(bounds).collect::<Result<_, _>>()?;
    for (index, one) in bounds.iter().enumerate() {
        let overlaps = |other: &&Polytope| {
            let pair = Pair::new(one.clone(), (*other).clone());
            pair.exact_distance(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]) < -ROUNDING
        };
        if let Some(other) = bounds[..index].iter().position(|other| overlaps(&other)) {
            let other = shapes[other].0.shape.as_deref().unwrap_or_default();
            return Err(shapes[index].0.refuse(format!(
                "it may overlap with shape `{other}`, so that `density` would count material twice: leave it out and give \
                 body.mass and body.inertia"
            )));
        }
    }
    Ok(())
}
