//! Which parts may touch.

use collision::Polytope;

use crate::error::SceneError;
use crate::keys::key;
use crate::mesh::MeshPart;
use crate::motion_region::{MotionRegion, meet};
use crate::part::Part;
use crate::table::Table;
use crate::words::{clipped, suggest};

/// The parts of the body or of the environment.
#[derive(Clone, Copy)]
pub struct Side<'scene> {
    /// `body` or `environment`.
    pub parent: &'static str,
    pub parts: &'scene [Part],
    pub meshes: &'scene [MeshPart],
}

/// Pairs as indices of a body and an environment part.
pub type Pairs = Vec<(usize, usize)>;

/// The pairs that are listed; else every body part with every environment part, without pieces of meshes that its motions
/// do not come near to. Second, the pairs that are left out.
pub fn pairs(
    scene: &Table,
    body: Side,
    environment: Side,
    region: Option<&MotionRegion>,
) -> Result<(Pairs, Pairs), SceneError> {
    let Some(entry) = scene.table("contact")?.find("pairs") else {
        let (mut near, mut far) = (Pairs::new(), Pairs::new());
        let is_piece = |other: usize| environment.meshes.iter().any(|mesh| mesh.parts.contains(&other));
        let is_far = |part: usize, other: usize| {
            let meets = |place: &Polytope| meet(place, &environment.parts[other].shape);
            is_piece(other) && region.is_some_and(|region| !region.places[part].iter().any(meets))
        };
        for pair in (0..body.parts.len()).flat_map(|part| (0..environment.parts.len()).map(move |other| (part, other)))
        {
            if is_far(pair.0, pair.1) { far.push(pair) } else { near.push(pair) }
        }
        if near.is_empty() {
            std::mem::swap(&mut near, &mut far);
        }
        let most = *key("contact", "pairs").count().map_or(&usize::MAX, |count| count.end());
        if near.len() > most {
            return Err(scene.require("environment")?.refuse(format!(
                "{} body parts and {} environment parts make more than {most} pairs: list those that may touch as \
                 pairs in [contact]",
                body.parts.len(),
                environment.parts.len()
            )));
        }
        return Ok((near, far));
    };
    let mut pairs = Vec::new();
    for pair in entry.pairs()? {
        let refuse = |message: String| entry.source().error(pair.span(), message);
        let [first, second] = *pair.get_ref();
        let (firsts, seconds) = (body.named(first, refuse)?, environment.named(second, refuse)?);
        for indices in firsts.iter().flat_map(|&part| seconds.iter().map(move |&other| (part, other))) {
            if pairs.contains(&indices) {
                return Err(refuse(format!("the pair `{first}`, `{second}` is listed twice")));
            }
            pairs.push(indices);
        }
    }
    Ok((pairs, Vec::new()))
}

impl Side<'_> {
    /// Indices of the part of a name, or of all parts of a mesh or link of that name.
    fn named(&self, name: &str, refuse: impl Fn(String) -> SceneError) -> Result<Vec<usize>, SceneError> {
        let of_meshes: Vec<usize> =
            self.meshes.iter().filter(|mesh| mesh.name == name).flat_map(|mesh| mesh.parts.clone()).collect();
        if !of_meshes.is_empty() {
            return Ok(of_meshes);
        }
        let index = self.parts.iter().position(|part| part.name == name);
        index.map(|index| vec![index]).ok_or_else(|| {
            let names: Vec<&str> = self.parts.iter().map(|part| part.name.as_str()).collect();
            let name = clipped(name);
            refuse(format!("[{}] has no part `{name}`{}", self.parent, suggest(&name, &names)))
        })
    }
}
