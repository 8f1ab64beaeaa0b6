//! Shapes of parts.

use collision::Polytope;
use nalgebra::Isometry3;
use task::Pose;
use task::algebra::norm;
use toml::Spanned;

use crate::entry::Entry;
use crate::error::SceneError;
use crate::known_meshes::KnownMeshes;
use crate::mesh::GivenMesh;
use crate::model::link_shapes;
use crate::pose::orientation;
use crate::table::Table;

/// A named convex part, placed in its parent's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Name, unique among the parts of its parent.
    pub name: String,
    /// Shape in the frame of the body, or of the world for the environment.
    pub shape: Polytope,
}

/// Smallest length of a part, and largest coordinate of one that is placed (m).
const SMALLEST: f64 = 1e-5;
const FARTHEST: f64 = 1e4;
/// A box whose shortest edge is a smaller fraction of its longest one counts as flat.
const FLATTEST: f64 = 1e-6;
/// Shortest normal of a halfspace.
const SHORTEST_NORMAL: f64 = 1e-6;

/// Keys that give a part its shape.
pub const SHAPES: [&str; 5] = ["vertices", "box", "normals", "mesh", "model"];
/// Keys that only some shapes have.
const OWNERS: [(&str, &[&str]); 5] = [
    ("unit", &["mesh"]),
    ("link", &["model"]),
    ("facets", &["mesh", "model"]),
    ("clearance", &["mesh", "model"]),
    ("density", &["mesh", "model"]),
];
/// Keys that need each other.
pub const COMPANIONS: [(&str, &str); 2] = [("normals", "offsets"), ("mesh", "unit")];

/// A part as the scene gives it: a mesh is covered by convex parts only when the region of motion is known. The shapes
/// of a link are separate parts with the same name.
pub struct GivenPart<'text> {
    pub name: String,
    pub shape: Shape<'text>,
    pub position: [f64; 3],
    pub orientation: [f64; 4],
}

/// Shape of a part in its own frame.
pub enum Shape<'text> {
    Convex(Polytope),
    Mesh(GivenMesh<'text>),
}

/// Reads the parts of a body or environment, and the files of their meshes that are not known.
pub fn given_parts<'text>(parent: &Table<'text>, known: &KnownMeshes) -> Result<Vec<GivenPart<'text>>, SceneError> {
    let mut given_parts: Vec<GivenPart> = Vec::new();
    for table in parent.tables("part", "part")? {
        let name = table.require("name")?.name()?;
        if given_parts.iter().any(|other| other.name == name) {
            return Err(table.require("name")?.refuse(format!("part name `{name}` is used twice")));
        }
        let entry = shape_entry(&table, &name)?;
        let position = table.find("position").map_or(Ok([0.0; 3]), |entry| entry.vector())?;
        let orientation = table.find("orientation").map_or(Ok([1.0, 0.0, 0.0, 0.0]), |entry| orientation(&entry))?;
        let own = match entry.key().name {
            "model" => of_link(&table, &name, &Pose::new(position, orientation).isometry())?,
            _ => vec![GivenPart { shape: shape(&entry, &table, &name, known)?, name, position, orientation }],
        };
        own.iter().try_for_each(|given| check(given, &entry))?;
        given_parts.extend(own);
    }
    Ok(given_parts)
}

/// The shapes of a link whose frame has a pose in the parent's.
fn of_link<'text>(
    table: &Table<'text>,
    name: &str,
    frame: &Isometry3<f64>,
) -> Result<Vec<GivenPart<'text>>, SceneError> {
    let given = |(mesh, pose): (GivenMesh<'text>, Isometry3<f64>)| {
        let placement = frame * pose;
        let rotation = placement.rotation.quaternion();
        GivenPart {
            name: name.to_owned(),
            shape: Shape::Mesh(mesh),
            position: placement.translation.vector.into(),
            orientation: [rotation.w, rotation.i, rotation.j, rotation.k],
        }
    };
    Ok(link_shapes(table, name)?.into_iter().map(given).collect())
}

/// Refuses a part that is too small or too far away.
fn check(given: &GivenPart, place: &Entry) -> Result<(), SceneError> {
    let refuse = |message: String| Err(place.refuse(format!("part `{}`: {message}", given.name)));
    let size = given.size();
    if size < SMALLEST {
        return refuse(format!("it is {size:.1e} m long; parts must be longer than {SMALLEST:.0e} m"));
    }
    if !given.points().iter().flatten().all(|coordinate| (-FARTHEST..=FARTHEST).contains(coordinate)) {
        return refuse(format!("a corner is more than {FARTHEST} m from the origin along an axis"));
    }
    Ok(())
}

impl GivenPart<'_> {
    /// Points (m) of the parent's frame in whose convex hull the part lies.
    pub fn points(&self) -> Vec<[f64; 3]> {
        let points = match &self.shape {
            Shape::Convex(shape) => shape.vertices().to_vec(),
            Shape::Mesh(mesh) => mesh.corners().to_vec(),
        };
        let placed = self.placement();
        points.into_iter().map(|point| placed.transform_point(&point.into()).coords.into()).collect()
    }

    /// From the part's frame to its parent's.
    pub fn placement(&self) -> Isometry3<f64> {
        Pose::new(self.position, self.orientation).isometry()
    }

    /// Its mesh, if it has one.
    pub fn mesh(&self) -> Option<&GivenMesh<'_>> {
        match &self.shape {
            Shape::Convex(_) => None,
            Shape::Mesh(mesh) => Some(mesh),
        }
    }

    fn size(&self) -> f64 {
        match &self.shape {
            Shape::Convex(shape) => shape.size(),
            Shape::Mesh(mesh) => mesh.size(),
        }
    }
}

/// The one key that gives a part its shape.
fn shape_entry<'text>(table: &Table<'text>, name: &str) -> Result<Entry<'text>, SceneError> {
    if let (Some(offsets), None) = (table.find("offsets"), table.find("normals")) {
        return Err(offsets.refuse(format!("part `{name}` needs both `normals` and `offsets`")));
    }
    for (key, owners) in OWNERS {
        if let (Some(entry), false) = (table.find(key), owners.iter().any(|owner| table.find(owner).is_some())) {
            let hint = if key == "unit" { "; everything else is in metres" } else { "" };
            return Err(entry.refuse(format!("`{key}` belongs to `{}`{hint}", owners.join("` or `"))));
        }
    }
    let mut chosen = SHAPES.into_iter().filter_map(|key| table.find(key));
    let (Some(entry), None) = (chosen.next(), chosen.next()) else {
        let choices = "exactly one of `vertices`, `box`, `normals` with `offsets`, `mesh`, `model`";
        return Err(table.refuse(format!("part `{name}` needs {choices}")));
    };
    Ok(entry)
}

/// The shape that a key gives to a part.
fn shape<'text>(
    entry: &Entry<'text>,
    table: &Table<'text>,
    name: &str,
    known: &KnownMeshes,
) -> Result<Shape<'text>, SceneError> {
    let shape = match entry.key().name {
        "vertices" => Polytope::from_vertices(&values(entry.vectors()?)),
        "box" => Polytope::from_box(edge_lengths(entry)?),
        "mesh" => return Ok(Shape::Mesh(GivenMesh::read(table, known)?)),
        _ => {
            let Some(offsets) = table.find("offsets") else {
                return Err(entry.refuse(format!("part `{name}` needs both `normals` and `offsets`")));
            };
            Polytope::from_halfspaces(&normals(entry)?, &offsets.numbers()?)
        }
    };
    shape.map(Shape::Convex).map_err(|error| entry.refuse(format!("part `{name}`: {error}")))
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
