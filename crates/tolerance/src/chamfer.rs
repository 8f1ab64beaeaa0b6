//! Scenes with a chamfer at the mouth of the hole.

use collision::{Polytope, PolytopeError};
use nalgebra::Vector3;
use scene::{Part, Scene};

use crate::mouth::{Halfspace, Mouth, Side, within};

/// Distance (m) that is rounding.
const ROUNDING: f64 = 1e-7;

/// A scene whose hole has a chamfer of 45 degrees, of some width (m) across the insertion and the same depth along it. What is
/// cut off is the frustum between the rim and the sides: at each depth, the section of the hole moved outwards with its corners.
/// A part that a single halfspace of a side would cut too much of, as at a corner, is split in two.
///
/// # Errors
/// With the name of the part that a cut leaves nothing of.
pub fn chamfered(scene: &Scene, mouth: &Mouth, width: f64) -> Result<Scene, (String, PolytopeError)> {
    if width == 0.0 {
        return Ok(scene.clone());
    }
    let cut = Cut::new(mouth, width);
    let (mut environment, mut corners) = (Vec::with_capacity(scene.environment.len()), Vec::new());
    for part in &scene.environment {
        let named = |error| (part.name.clone(), error);
        match cut.side_of(&part.shape) {
            None => environment.push(part.clone()),
            Some(own) => {
                let shape = within(&part.shape, &[cut.kept[own]]).map_err(named)?;
                environment.push(Part { name: part.name.clone(), shape });
                corners.extend((0..cut.kept.len()).filter(|&other| other != own).map(|other| (part, own, other)));
            }
        }
    }
    let mut split = Vec::new();
    for (part, own, other) in corners {
        let (normal, offset) = cut.kept[own];
        // What the cut of its own side takes away, and the frustum does not.
        let Ok(lost) = within(&part.shape, &[(-normal, -offset), cut.kept[other]]) else { continue };
        if !environment.iter().any(|covering| contains(&covering.shape, &lost)) {
            let name = format!("{}-{}", part.name, other + 1);
            let shape = within(&part.shape, &[cut.kept[other]]).map_err(|error| (part.name.clone(), error))?;
            split.push(Part { name, shape });
        }
    }
    environment.append(&mut split);
    Ok(Scene { environment, ..scene.clone() })
}

/// The frustum that is cut off.
struct Cut {
    /// What each side keeps, and at the end, what is above the rim: a point is cut off that none of them contains.
    kept: Vec<Halfspace>,
}

impl Cut {
    fn new(mouth: &Mouth, width: f64) -> Self {
        let slope = |side: &Side| {
            let length = 2.0_f64.sqrt();
            ((side.normal + mouth.out) / length, (side.offset + mouth.rim - width) / length)
        };
        let above = (-mouth.out, -mouth.rim);
        Self { kept: mouth.sides.iter().map(slope).chain([above]).collect() }
    }

    /// The side that keeps most of a shape; `None` where the frustum does not reach the shape.
    fn side_of(&self, shape: &Polytope) -> Option<usize> {
        let removed: Vec<Halfspace> = self.kept.iter().map(|(normal, offset)| (-normal, -offset)).collect();
        within(shape, &removed).ok()?;
        let volume = |&kept: &Halfspace| within(shape, &[kept]).map_or(0.0, |left| left.volume());
        let volumes: Vec<f64> = self.kept.iter().map(volume).collect();
        (0..volumes.len()).max_by(|&one, &other| volumes[one].total_cmp(&volumes[other]))
    }
}

/// Whether a shape contains all of another one.
fn contains(shape: &Polytope, other: &Polytope) -> bool {
    let is_inside = |vertex: &[f64; 3]| {
        let vertex = Vector3::from(*vertex);
        let mut faces = shape.normals().iter().zip(shape.offsets());
        faces.all(|(normal, offset)| Vector3::from(*normal).dot(&vertex) <= offset + ROUNDING)
    };
    other.vertices().iter().all(is_inside)
}
