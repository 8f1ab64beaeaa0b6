//! Remarks on what looks like a mistake.

use mesh::Repair;
use task::Pose;
use task::algebra::norm;

use crate::error::SceneError;
use crate::mesh::MeshPart;
use crate::part::{Extent, Part};
use crate::robot;
use crate::scene::Scene;
use crate::table::Table;

/// Sizes of parts that need no remark (m).
pub const USUAL_SIZES: std::ops::Range<f64> = 1e-4..10.0;
/// Distances that need a remark: in metres, and in sizes of the scene.
const FAR: f64 = 10.0;
const FAR_IN_SIZES: f64 = 10.0;

/// All remarks, each with file, line and column.
pub fn warnings(table: &Table, scene: &Scene) -> Result<Vec<String>, SceneError> {
    let mut warnings = former_names(table)?;
    for (name, parts) in [("body", &scene.body), ("environment", &scene.environment)] {
        sizes(&table.require_table(name)?, parts, &mut warnings)?;
    }
    warnings.extend(scene.body_meshes.iter().chain(&scene.environment_meshes).flat_map(caps));
    let (body, environment) = (Extent::of(&scene.body), Extent::of(&scene.environment));
    let far = FAR.min(FAR_IN_SIZES * body.size().max(environment.size()));
    if body.distance(&[0.0; 3]) > far {
        let distance = body.distance(&[0.0; 3]);
        let message =
            format!("the body is {distance:.3} m away from its origin, the centre of mass: are its parts in metres?");
        warnings.push(table.require("body")?.refuse(message).headline());
    }
    let radius = scene.body.iter().flat_map(|part| part.shape.vertices()).map(|v| norm(v)).fold(0.0, f64::max);
    let mut check = |table: &Table, name: &str, pose: &Pose| {
        let distance = environment.distance(&pose[..3]) - radius;
        if distance > far {
            let message = format!("{name} is {distance:.3} m away from the environment: are these metres?");
            warnings.push(table.require("position")?.refuse(message).headline());
        }
        Ok(())
    };
    for (table, start) in table.tables("start", "start")?.iter().zip(&scene.starts) {
        check(table, &format!("start `{}`", start.name), &start.pose)?;
    }
    check(&table.require_table("goal")?, "the goal", &scene.goal)?;
    if scene.offset_magnitude > body.size() {
        let has_unit =
            table.require_table("body")?.tables("part", "part")?.iter().any(|part| part.find("unit").is_some());
        let message = format!(
            "an offset of {} m is larger than the body, {:.3} m: is it in metres{}?",
            scene.offset_magnitude,
            body.size(),
            if has_unit { ", and is the `unit` of the body's mesh right" } else { "" }
        );
        let entry = table.require_table("robustness")?.require("offset_magnitude")?;
        warnings.push(entry.refuse(message).headline());
    }
    warnings.extend(
        scene.carried.unread.iter().map(|unread| format!("{unread}; whether it meets the environment is not checked")),
    );
    warnings.extend(robot::warnings(table, scene.robot.as_ref(), &scene.impedance)?);
    Ok(warnings)
}

/// Remarks on keys under their former names.
fn former_names(table: &Table) -> Result<Vec<String>, SceneError> {
    let mut warnings = Vec::new();
    for renamed in input::KEYS {
        if let Some((parent, old)) = renamed.old.split_once('.') {
            let written = table.table(parent)?.written(old);
            warnings.extend(written.map(|entry| entry.refuse_name(renamed.warning()).headline()));
        }
    }
    Ok(warnings)
}

/// Remarks on holes of a mesh that were closed: they may be mouths of pockets.
fn caps(mesh: &MeshPart) -> impl Iterator<Item = String> {
    let caps = mesh.solid.repairs().iter().filter(|repair| matches!(repair, Repair::Capped { .. }));
    caps.map(|cap| {
        format!(
            "part `{}`, {}: {cap}; if a pocket begins there, the file lacks its faces: export the part again",
            mesh.name,
            mesh.file.display()
        )
    })
}

/// Remarks on parts that are very large or very small.
fn sizes(parent: &Table, parts: &[Part], warnings: &mut Vec<String>) -> Result<(), SceneError> {
    for table in parent.tables("part", "part")? {
        let name = table.require("name")?.name()?;
        // A mesh has several.
        let is_of =
            |part: &&Part| part.name == name || part.name.strip_prefix(&name).is_some_and(|rest| rest.starts_with('.'));
        let own: Vec<Part> = parts.iter().filter(is_of).cloned().collect();
        let size = Extent::of(&own).size();
        if !USUAL_SIZES.contains(&size) {
            let question = if table.find("unit").is_some() { "is its `unit` right?" } else { "are these metres?" };
            let message = format!("part `{name}` is {} m long: {question}", (1e9 * size).round() / 1e9);
            warnings.push(table.require("name")?.refuse(message).headline());
        }
    }
    Ok(())
}
