//! Shapes of parts.

use std::ops::Range;
use std::path::Path;

use collision::{Polytope, PolytopeError};
use toml::Spanned;

use crate::document::PartDocument;
use crate::error::{SceneError, Source, suggest};
use crate::pose;

/// A named convex part, placed in its parent's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Name, unique among the parts of its parent.
    pub name: String,
    /// Shape in the frame of the body, or of the world for the environment.
    pub shape: Polytope,
}

/// Lengths that a mesh file may be in (m).
const UNITS: [(&str, f64); 4] = [("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("inch", 0.0254)];

/// Builds the parts of one parent.
pub fn parts(source: Source, documents: &[Spanned<PartDocument>]) -> Result<Vec<Part>, SceneError> {
    let mut parts: Vec<Part> = Vec::new();
    for document in documents {
        let part = part(source, document.span(), document.get_ref())?;
        if parts.iter().any(|other| other.name == part.name) {
            let span = document.get_ref().name.span();
            return Err(source.error(span, format!("part name `{}` is used twice", part.name)));
        }
        parts.push(part);
    }
    Ok(parts)
}

fn part(source: Source, span: Range<usize>, document: &PartDocument) -> Result<Part, SceneError> {
    let name = document.name.get_ref().clone();
    if name.is_empty() {
        return Err(source.error(document.name.span(), "a part needs a name"));
    }
    let (place, shape) = shape(source, span, document)?;
    let refuse = |error: PolytopeError| source.error(place.clone(), format!("part `{name}`: {error}"));
    let shape = shape.map_err(refuse)?;
    let position = match &document.position {
        Some(position) => pose::position(source, position)?,
        None => [0.0; 3],
    };
    let orientation = match &document.orientation {
        Some(orientation) => pose::orientation(source, orientation)?,
        None => [1.0, 0.0, 0.0, 0.0],
    };
    Ok(Part { shape: shape.placed(position, orientation), name })
}

/// The one shape that a part gives, with its place in the file.
fn shape(
    source: Source,
    span: Range<usize>,
    document: &PartDocument,
) -> Result<(Range<usize>, Result<Polytope, PolytopeError>), SceneError> {
    let PartDocument { name, vertices, edge_lengths, normals, offsets, mesh, unit, .. } = document;
    let given = [vertices.is_some(), edge_lengths.is_some(), normals.is_some() || offsets.is_some(), mesh.is_some()];
    if given.iter().filter(|given| **given).count() != 1 {
        let name = name.get_ref();
        return Err(source.error(
            span,
            format!("part `{name}` needs exactly one of `vertices`, `box`, `normals` with `offsets`, `mesh`"),
        ));
    }
    if let (Some(unit), None) = (unit, mesh) {
        return Err(source.error(unit.span(), "`unit` belongs to `mesh`; everything else is in metres"));
    }
    if let Some(vertices) = vertices {
        return Ok((vertices.span(), Polytope::from_vertices(vertices.get_ref())));
    }
    if let Some(edge_lengths) = edge_lengths {
        return Ok((edge_lengths.span(), Polytope::from_box(*edge_lengths.get_ref())));
    }
    if let Some(mesh) = mesh {
        let shape = crate::mesh::shape(source, mesh, scale(source, mesh, unit.as_ref())?)?;
        return Ok((mesh.span(), Ok(shape)));
    }
    match (normals, offsets) {
        (Some(normals), Some(offsets)) => {
            Ok((normals.span(), Polytope::from_halfspaces(normals.get_ref(), offsets.get_ref())))
        }
        _ => Err(source.error(span, format!("part `{}` needs both `normals` and `offsets`", name.get_ref()))),
    }
}

fn scale(source: Source, mesh: &Spanned<String>, unit: Option<&Spanned<String>>) -> Result<f64, SceneError> {
    let names: Vec<&str> = UNITS.iter().map(|(name, _)| *name).collect();
    let Some(unit) = unit else {
        let choices = names.join("\", \"");
        return Err(source.error(mesh.span(), format!("a mesh needs its `unit`: one of \"{choices}\"")));
    };
    match UNITS.iter().find(|(name, _)| name == unit.get_ref()) {
        Some((_, scale)) => Ok(*scale),
        None => {
            let hint = suggest(unit.get_ref(), &names);
            Err(source.error(unit.span(), format!("unknown unit `{}`{hint}", unit.get_ref())))
        }
    }
}

/// Remarks on sizes that look like a mistaken unit.
pub fn size_warnings(file: &Path, parts: &[Part]) -> Vec<String> {
    const RANGE: std::ops::Range<f64> = 1e-4..10.0;
    let odd = parts.iter().filter(|part| !RANGE.contains(&part.shape.size()));
    odd.map(|part| {
        format!("{}: part `{}` is {} m long; lengths are in metres", file.display(), part.name, part.shape.size())
    })
    .collect()
}
