//! Shapes of parts.

use collision::{Polytope, PolytopeError};
use toml::Spanned;

use crate::entry::Entry;
use crate::error::SceneError;
use crate::keys::UNITS;
use crate::pose::{norm, orientation};
use crate::table::Table;

/// A named convex part, placed in its parent's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Name, unique among the parts of its parent.
    pub name: String,
    /// Shape in the frame of the body, or of the world for the environment.
    pub shape: Polytope,
}

/// The units of mesh files (m), in the order of their names.
pub const SCALES: [f64; 4] = [1.0, 0.01, 0.001, 0.0254];
const _: () = assert!(SCALES.len() == UNITS.len());

/// Smallest length of a part, and largest coordinate of one that is placed (m).
const SMALLEST: f64 = 1e-5;
const FARTHEST: f64 = 1e4;
/// A box with a shorter edge than this fraction of its longest one cannot be told from a plane.
const FLATTEST: f64 = 1e-6;
/// Shortest normal of a halfspace.
const SHORTEST_NORMAL: f64 = 1e-6;

/// Keys that give a part its shape.
pub const SHAPES: [&str; 4] = ["vertices", "box", "normals", "mesh"];
/// Keys that need each other.
pub const COMPANIONS: [(&str, &str); 2] = [("normals", "offsets"), ("mesh", "unit")];

/// Builds the parts of a body or environment.
pub fn parts(parent: &Table) -> Result<Vec<Part>, SceneError> {
    let mut parts: Vec<Part> = Vec::new();
    for table in parent.tables("part", "part")? {
        let part = part(&table)?;
        if parts.iter().any(|other| other.name == part.name) {
            let message = format!("part name `{}` is used twice", part.name);
            return Err(table.require("name")?.refuse(message));
        }
        parts.push(part);
    }
    Ok(parts)
}

fn part(table: &Table) -> Result<Part, SceneError> {
    let name = table.require("name")?.name()?;
    let (place, shape) = shape(table, &name)?;
    let refuse = |message: String| place.refuse(format!("part `{name}`: {message}"));
    let shape = shape.map_err(|error| refuse(error.to_string()))?;
    if shape.size() < SMALLEST {
        return Err(refuse(format!("it is {:.1e} m long; parts must be longer than {SMALLEST:.0e} m", shape.size())));
    }
    let position = table.find("position").map_or(Ok([0.0; 3]), |entry| entry.vector())?;
    let orientation = table.find("orientation").map_or(Ok([1.0, 0.0, 0.0, 0.0]), |entry| orientation(&entry))?;
    let shape = shape.placed(position, orientation);
    if !shape.vertices().iter().flatten().all(|coordinate| (-FARTHEST..=FARTHEST).contains(coordinate)) {
        return Err(refuse(format!("a corner is more than {FARTHEST} m from the origin along an axis")));
    }
    Ok(Part { shape, name })
}

/// The one shape that a part gives, with its place in the file.
fn shape<'text>(
    table: &Table<'text>,
    name: &str,
) -> Result<(Entry<'text>, Result<Polytope, PolytopeError>), SceneError> {
    if let (Some(offsets), None) = (table.find("offsets"), table.find("normals")) {
        return Err(offsets.refuse(format!("part `{name}` needs both `normals` and `offsets`")));
    }
    if let (Some(unit), None) = (table.find("unit"), table.find("mesh")) {
        return Err(unit.refuse("`unit` belongs to `mesh`; everything else is in metres"));
    }
    let mut given = SHAPES.into_iter().filter_map(|key| Some((key, table.find(key)?)));
    let (Some((key, entry)), None) = (given.next(), given.next()) else {
        let choices = "exactly one of `vertices`, `box`, `normals` with `offsets`, `mesh`";
        return Err(table.refuse(format!("part `{name}` needs {choices}")));
    };
    let shape = match key {
        "vertices" => Polytope::from_vertices(&values(entry.vectors()?)),
        "box" => Polytope::from_box(edge_lengths(&entry)?),
        "mesh" => Ok(mesh(table, &entry)?),
        _ => {
            let Some(offsets) = table.find("offsets") else {
                return Err(entry.refuse(format!("part `{name}` needs both `normals` and `offsets`")));
            };
            Polytope::from_halfspaces(&normals(&entry)?, &offsets.numbers()?)
        }
    };
    Ok((entry, shape))
}

fn edge_lengths(entry: &Entry) -> Result<[f64; 3], SceneError> {
    let edges: [f64; 3] = entry.vector()?;
    let (shortest, longest) = edges.iter().fold((f64::INFINITY, 0.0f64), |(low, high), &e| (low.min(e), high.max(e)));
    if shortest < FLATTEST * longest {
        return Err(entry.refuse(format!("{}: the longest edge is more than 1e6 times the shortest", entry.path())));
    }
    Ok(edges)
}

fn normals(entry: &Entry) -> Result<Vec<[f64; 3]>, SceneError> {
    let normals = entry.vectors()?;
    match normals.iter().find(|normal| norm(normal.get_ref()) < SHORTEST_NORMAL) {
        None => Ok(values(normals)),
        Some(normal) => {
            let message = format!("{}: the normal is shorter than {SHORTEST_NORMAL:.0e}", entry.path());
            Err(entry.source().error(normal.span(), message))
        }
    }
}

/// Shape of a mesh (m).
fn mesh(table: &Table, entry: &Entry) -> Result<Polytope, SceneError> {
    let file = Spanned::new(entry.span(), entry.text()?.to_owned());
    if file.get_ref().is_empty() {
        return Err(entry.refuse(format!("{} is empty", entry.path())));
    }
    let Some(unit) = table.find("unit") else {
        return Err(entry.refuse(format!("a mesh needs its `unit`: one of \"{}\"", UNITS.join("\", \""))));
    };
    crate::mesh::shape(entry.source(), &file, SCALES[unit.choice()?])
}

fn values<T>(entries: Vec<Spanned<T>>) -> Vec<T> {
    entries.into_iter().map(Spanned::into_inner).collect()
}

/// Smallest box along the axes that holds some parts (m).
#[derive(Debug, Clone, Copy)]
pub struct Extent {
    axes: [(f64, f64); 3],
}

impl Extent {
    /// Of one or more parts.
    pub fn of(parts: &[Part]) -> Self {
        let mut axes = [(f64::INFINITY, f64::NEG_INFINITY); 3];
        for vertex in parts.iter().flat_map(|part| part.shape.vertices()) {
            for (axis, coordinate) in axes.iter_mut().zip(vertex) {
                *axis = (axis.0.min(*coordinate), axis.1.max(*coordinate));
            }
        }
        Self { axes }
    }

    /// Longest edge.
    pub fn size(&self) -> f64 {
        self.axes.iter().map(|(low, high)| high - low).fold(0.0, f64::max)
    }

    /// Distance of a point from the box, zero inside.
    pub fn distance(&self, point: &[f64]) -> f64 {
        let gaps = self.axes.iter().zip(point).map(|((low, high), &x)| (low - x).max(x - high).max(0.0));
        norm(&gaps.collect::<Vec<_>>())
    }
}
