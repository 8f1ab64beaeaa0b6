//! MJCF.

mod compiler;
mod defaults;
mod orientation;

use std::path::Path;

use nalgebra::{Isometry3, Translation3, Vector3};
use roxmltree::Node;

use crate::element::{Value, attribute, children, refuse, shape_name, tag, unsupported};
use crate::error::ModelError;
use crate::shape::{Geometry, LinkShape};
use compiler::Compiler;
use defaults::Levels;
use orientation::{from_z, orientation};

/// Elements of a body that make geoms which do not stand in the file.
const MAKERS: [&str; 4] = ["attach", "composite", "flexcomp", "replicate"];

/// The bodies with geoms that collide; the world is one. One without a name has its number in MuJoCo as name, such as
/// `#2`.
pub fn bodies<'text>(root: Node<'text, 'text>) -> Result<Vec<(String, Node<'text, 'text>)>, ModelError> {
    let mut bodies = Vec::new();
    for (number, element) in root.descendants().filter(|node| is_body(*node)).enumerate() {
        let geoms = own(element).filter(|node| node.has_tag_name("geom"));
        let collides = geoms.map(collides).collect::<Result<Vec<bool>, _>>()?.contains(&true);
        if collides || own(element).any(|node| MAKERS.contains(&tag(node))) {
            let name = if element.has_tag_name("worldbody") { Some("world") } else { element.attribute("name") };
            bodies.push((name.map_or_else(|| format!("#{number}"), str::to_owned), element));
        }
    }
    Ok(bodies)
}

/// The geoms of a body that collide.
pub fn shapes<'text>(body: Node<'text, 'text>, file: &Path) -> Result<Vec<LinkShape>, ModelError> {
    let compiler = Compiler::of(body)?;
    if let Some(maker) = own(body).find(|node| MAKERS.contains(&tag(*node))) {
        return Err(unsupported(maker, tag(maker)));
    }
    let mut shapes = Vec::new();
    for (number, geom) in (1..).zip(own(body).filter(|node| node.has_tag_name("geom"))) {
        if collides(geom)? {
            let (place, geometry) = place_and_geometry(geom, &compiler, file)?;
            let mut frames = geom.ancestors().skip(1).take_while(|around| *around != body);
            let pose = frames.try_fold(place, |inner, frame| Ok(pose(&Levels::alone(frame), &compiler)? * inner))?;
            shapes.push(LinkShape { name: shape_name(geom, number), pose, geometry, span: geom.range() });
        }
    }
    Ok(shapes)
}

fn is_body(node: Node) -> bool {
    node.has_tag_name("body") || node.has_tag_name("worldbody")
}

/// The elements of a body, also those in frames, in the order of the file.
fn own<'text>(body: Node<'text, 'text>) -> impl Iterator<Item = Node<'text, 'text>> {
    let inside = |node: Node<'text, 'text>| node.children().rev().filter(Node::is_element);
    let mut rest: Vec<Node> = inside(body).collect();
    std::iter::from_fn(move || {
        let next = rest.pop()?;
        if next.has_tag_name("frame") {
            rest.extend(inside(next));
        }
        Some(next)
    })
}

/// Whether a geom takes part in collisions; those that do not are only seen.
fn collides<'text>(geom: Node<'text, 'text>) -> Result<bool, ModelError> {
    let levels = Levels::of(geom)?;
    let is_zero = |name| levels.attribute(name).map_or(Ok(false), |mask| Ok(mask.numbers::<1>()? == [0.0]));
    Ok(!(is_zero("contype")? && is_zero("conaffinity")?))
}

/// The pose that position and orientation of an element state.
fn pose(levels: &Levels, compiler: &Compiler) -> Result<Isometry3<f64>, ModelError> {
    let position: [f64; 3] = levels.attribute("pos").map_or(Ok([0.0; 3]), |position| position.numbers())?;
    Ok(Isometry3::from_parts(position.into(), orientation(levels, compiler)?))
}

fn place_and_geometry<'text>(
    geom: Node<'text, 'text>,
    compiler: &Compiler,
    file: &Path,
) -> Result<(Isometry3<f64>, Geometry), ModelError> {
    let levels = Levels::of(geom)?;
    let kind = levels.attribute("type").map_or("sphere", |kind| kind.text);
    let mesh = levels.attribute("mesh");
    let size = || levels.attribute("size").ok_or_else(|| refuse(geom, format!("a {kind} must have its `size`")));
    match (kind, mesh, levels.attribute("fromto")) {
        ("mesh", Some(mesh), _) => Ok((pose(&levels, compiler)?, mesh_asset(&mesh, geom, compiler, file)?)),
        ("mesh", None, _) => Err(refuse(geom, "a geom of type mesh must name its `mesh`")),
        (_, Some(_), _) => Err(unsupported(geom, &format!("a {kind} fitted to a mesh"))),
        ("box", None, None) => {
            let edges = size()?.first_lengths::<3>()?.map(|half| 2.0 * half);
            Ok((pose(&levels, compiler)?, Geometry::Box { edges }))
        }
        ("cylinder", None, None) => {
            let [radius, half] = size()?.first_lengths()?;
            Ok((pose(&levels, compiler)?, Geometry::Cylinder { radius, length: 2.0 * half }))
        }
        ("box", None, Some(ends)) => {
            let [half] = size()?.first_lengths()?;
            let (place, length) = between(&ends)?;
            Ok((place, Geometry::Box { edges: [2.0 * half, 2.0 * half, length] }))
        }
        ("cylinder", None, Some(ends)) => {
            let [radius] = size()?.first_lengths()?;
            let (place, length) = between(&ends)?;
            Ok((place, Geometry::Cylinder { radius, length }))
        }
        _ => Err(unsupported(geom, kind)),
    }
}

/// Pose and length (m) of a shape along z whose ends are given. Its z axis points to the first of them.
fn between(ends: &Value) -> Result<(Isometry3<f64>, f64), ModelError> {
    let [x0, y0, z0, x1, y1, z1] = ends.numbers()?;
    let (from, to) = (Vector3::new(x0, y0, z0), Vector3::new(x1, y1, z1));
    let axis = ends.direction((from - to).into())?;
    Ok((Isometry3::from_parts(Translation3::from(0.5 * (from + to)), from_z(&axis)), (from - to).norm()))
}

/// The mesh of a name among the assets.
fn mesh_asset<'text>(
    name: &Value,
    geom: Node<'text, 'text>,
    compiler: &Compiler,
    file: &Path,
) -> Result<Geometry, ModelError> {
    let stem = |mesh: Node| mesh.attribute("file").map(|file| Path::new(file).with_extension("").into_os_string());
    let is_named = |mesh: &Node| match mesh.attribute("name") {
        Some(own) => own == name.text,
        None => stem(*mesh).is_some_and(|stem| Path::new(&stem).file_name() == Some(name.text.as_ref())),
    };
    let assets = children(geom.document().root_element(), "asset");
    let Some(asset) = assets.flat_map(|assets| children(assets, "mesh")).find(is_named) else {
        return Err(name.refuse("is not a mesh of <asset>"));
    };
    if let Some(moved) = ["refpos", "refquat"].into_iter().find_map(|name| attribute(asset, name)) {
        return Err(moved.refuse("is not supported: move the mesh by `pos` and `quat` of its geom"));
    }
    let levels = Levels::of(asset)?;
    let Some(mesh) = attribute(asset, "file") else { return Err(unsupported(asset, "a mesh without a file")) };
    let folder = file.parent().unwrap_or(file).join(compiler.mesh_folder);
    let path = Path::new(mesh.text);
    let path = if compiler.is_path_stripped { path.file_name().map_or(path, Path::new) } else { path };
    let scale = levels.attribute("scale").map_or(Ok(1.0), |scale| scale.uniform_scale())?;
    Ok(Geometry::Mesh { file: folder.join(path), scale })
}
