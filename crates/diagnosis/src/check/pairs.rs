//! Which parts make many pairs.

use std::collections::BTreeMap;

use scene::{MeshPart, Part, Scene};

/// Pairs from which on a scene takes long, and parts are named.
const MANY: usize = 150;
/// Pairs of parts that are named.
const NAMED: usize = 3;

/// The cause of many pairs, and how to reduce them.
pub fn warning(scene: &Scene) -> Option<String> {
    let count = scene.pairs.len();
    if count < MANY {
        return None;
    }
    let mut groups: BTreeMap<[(String, usize); 2], usize> = BTreeMap::new();
    for &(part, other) in &scene.pairs {
        let body = group(part, &scene.body, &scene.body_meshes);
        let environment = group(other, &scene.environment, &scene.environment_meshes);
        *groups.entry([body, environment]).or_default() += 1;
    }
    let mut groups: Vec<_> = groups.into_iter().collect();
    groups.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let name = |(name, pieces): &(String, usize)| match pieces {
        1 => format!("`{name}`"),
        _ => format!("`{name}` ({pieces} pieces)"),
    };
    let named = groups
        .iter()
        .take(NAMED)
        .map(|([body, environment], count)| format!("{count} of {} and {}", name(body), name(environment)));
    let named: Vec<String> = named.collect();
    Some(format!(
        "{count} pairs make planning slow, most of them {}: list those that may touch as contact.pairs, lower `facets` of round \
         parts, or give surfaces that touch nothing as boxes",
        named.join(", ")
    ))
}

/// The mesh or link that a part is a piece of, with the number of its pieces; else the part itself.
fn group(index: usize, parts: &[Part], meshes: &[MeshPart]) -> (String, usize) {
    let of_name = |name: &str| meshes.iter().filter(|mesh| mesh.name == name).map(|mesh| mesh.parts.len()).sum();
    match meshes.iter().find(|mesh| mesh.parts.contains(&index)) {
        Some(mesh) => (mesh.name.clone(), of_name(&mesh.name)),
        None => (parts[index].name.clone(), 1),
    }
}
