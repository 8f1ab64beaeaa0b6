//! From parts as the scene gives them to convex parts.

use collision::Polytope;
use mesh::CoverSettings;
use nalgebra::{Isometry3, Vector3};
use task::Pose;

use crate::error::SceneError;
use crate::facets::{ChosenFacets, Fit, LARGEST_SHARE, Placed, chosen_facets, tightest_fit};
use crate::mesh::{GivenMesh, MeshPart};
use crate::motion_region::{MotionRegion, Motions};
use crate::part::{GivenPart, Part, Shape};
use crate::touching::{Gap, SPACINGS, Sides};

/// Distance (m) that is no more than rounding.
const ROUNDING: f64 = 1e-9;

/// The convex parts of a scene, and what they were made from.
pub struct Shapes {
    pub body: Vec<Part>,
    pub environment: Vec<Part>,
    pub body_meshes: Vec<MeshPart>,
    pub environment_meshes: Vec<MeshPart>,
    pub fit: Option<Fit>,
    /// Region that the body can reach: only pieces of environment meshes with surface in it are parts. `None` without
    /// such meshes.
    pub region: Option<MotionRegion>,
    /// How both sides compare with the shapes as they are given, if there are meshes.
    pub gaps: Vec<Gap>,
}

/// With more pairs than this, meshes are covered accurately only where something can touch.
const FEW_PAIRS: usize = 300;
/// The same holds where the cells into which meshes divide make more pairs with the pieces of the body, or where the body
/// divides into more, unless there is a round fit or the scene states `facets` or `clearance`.
const FEW_CELLS: usize = 600;
const FEW_BODY_CELLS: usize = 100;

/// Share of the gap that exact pieces keep; where they keep less, pieces that are exact where something can touch are tried.
const LEAST_KEPT: f64 = 0.5;

/// Makes all parts convex.
pub fn shapes(
    body: &[GivenPart],
    environment: &[GivenPart],
    motions: &Motions,
    goal: &Pose,
) -> Result<Shapes, SceneError> {
    let given_meshes = || body.iter().chain(environment).filter_map(GivenPart::mesh);
    let fit = tightest_fit(&meshes(body, &goal.isometry()), &meshes(environment, &Isometry3::identity()));
    let chosen = chosen_facets(fit);
    let exact = |most_cells: MostCells| {
        require_fine(fit, chosen.facets, given_meshes())?;
        exact_shapes(body, environment, motions, (fit, chosen), most_cells)
    };
    let is_stated = |mesh: &GivenMesh| mesh.making.clearance > 0.0 || mesh.making.facets.is_some();
    let Some(mesh) = given_meshes().next().filter(|_| !given_meshes().any(is_stated)) else {
        return exact(|_| CoverSettings::default().most_cells);
    };
    let sides = Sides::new(body, environment, motions);
    let compared = |shapes: Shapes, chord_errors: f64| {
        let gaps = sides.gaps(&polytopes(&shapes.body), &polytopes(&shapes.environment));
        let worst = gaps
            .iter()
            .filter(|gap| !gap.agrees(chord_errors))
            .max_by(|one, other| one.error().total_cmp(&other.error()));
        worst.map(|gap| disagreement(gap, mesh)).map_or(Ok(Shapes { gaps, ..shapes }), Err)
    };
    // Exact shapes are round where the meshes approximate round surfaces by flat sides.
    let chord_errors = fit.map_or(0.0, |fit| fit.chord_errors);
    let compared_exact = |most_cells: MostCells| exact(most_cells).and_then(|shapes| compared(shapes, chord_errors));
    // Round fits are worth more time: only exact pieces know them.
    let exact = compared_exact(if fit.is_some() { |_| FEW_CELLS } else { few_cells });
    let keeps_gap = |exact: &Shapes| exact.gaps.iter().all(|gap| gap.kept() >= LEAST_KEPT);
    if exact.as_ref().is_ok_and(|exact| exact.pairs() <= FEW_PAIRS && keeps_gap(exact)) {
        return exact;
    }
    let touching_at = |spacing: f64| touching_shapes(body, environment, &sides, motions, spacing);
    let touching = || {
        // Only pieces that lose the gap between their places are worth more places.
        let [first, finer @ ..] = SPACINGS;
        let mut touching = compared(touching_at(first)?, 0.0);
        for spacing in finer {
            if touching.is_err() {
                touching = compared(touching_at(spacing)?, 0.0);
            }
        }
        touching
    };
    match (exact, touching()) {
        (Ok(exact), Ok(touching)) if touching.pairs() < exact.pairs() || !keeps_gap(&exact) => Ok(touching),
        (Ok(exact), _) => Ok(exact),
        (Err(_), Ok(touching)) => Ok(touching),
        (Err(_), Err(reason)) => compared_exact(|_| FEW_CELLS).or(Err(reason)),
    }
}

/// How many cells a mesh may divide into. Its argument is the number of pieces on the other side, none before the body is
/// divided.
type MostCells = fn(usize) -> usize;

fn few_cells(others: usize) -> usize {
    FEW_CELLS.checked_div(others).unwrap_or(FEW_BODY_CELLS)
}

impl Shapes {
    fn pairs(&self) -> usize {
        self.body.len() * self.environment.len()
    }
}

fn polytopes(parts: &[Part]) -> Vec<Polytope> {
    parts.iter().map(|part| part.shape.clone()).collect()
}

/// That convex parts do not stand for the meshes.
fn disagreement(gap: &Gap, mesh: &GivenMesh) -> SceneError {
    mesh.refuse(format!(
        "{:.3} mm from the goal its convex parts are {:.4} mm from the other side, and the shapes as given {:.4} mm: they do \
         not stand for it; export a plainer part",
        1e3 * gap.from_goal,
        1e3 * gap.parts,
        1e3 * gap.given
    ))
}

/// Exact shapes, but for facets of round surfaces.
fn exact_shapes(
    body: &[GivenPart],
    environment: &[GivenPart],
    motions: &Motions,
    (fit, chosen): (Option<Fit>, ChosenFacets),
    most_cells: MostCells,
) -> Result<Shapes, SceneError> {
    let cover = |region: Option<&MotionRegion>, others: usize, mesh: &GivenMesh, given: &GivenPart| {
        mesh.cover(&given.name, &given.placement(), chosen, region, most_cells(others))
    };
    let (body, body_meshes) = convex(body, |mesh, given| cover(None, 0, mesh, given))?;
    let has_meshes = environment.iter().any(|given| given.mesh().is_some());
    let points = || body.iter().map(|part| part.shape.vertices().to_vec()).collect::<Vec<_>>();
    let region = has_meshes.then(|| motions.region(&points()));
    let (environment, environment_meshes) =
        convex(environment, |mesh, given| cover(region.as_ref(), body.len(), mesh, given))?;
    Ok(Shapes { body, environment, body_meshes, environment_meshes, fit, region, gaps: Vec::new() })
}

/// Shapes that are exact where both sides pass each other.
fn touching_shapes(
    body: &[GivenPart],
    environment: &[GivenPart],
    sides: &Sides,
    motions: &Motions,
    spacing: f64,
) -> Result<Shapes, SceneError> {
    let cover = |is_body: bool| {
        move |mesh: &GivenMesh, given: &GivenPart| {
            let placement = given.placement();
            sides.passing(is_body, &placement, spacing, |passages, budget| {
                mesh.touching_cover(&given.name, &placement, passages, budget)
            })
        }
    };
    let (body, environment) = workers::both(|| convex(body, cover(true)), || convex(environment, cover(false)));
    let ((body, body_meshes), (environment, environment_meshes)) = (body?, environment?);
    let points: Vec<Vec<[f64; 3]>> = body.iter().map(|part| part.shape.vertices().to_vec()).collect();
    let region = (!environment_meshes.is_empty()).then(|| motions.region(&points));
    Ok(Shapes { body, environment, body_meshes, environment_meshes, fit: None, region, gaps: Vec::new() })
}

/// The meshes among some parts, whose parent has a place in the world.
fn meshes<'given>(given_parts: &'given [GivenPart], parent: &Isometry3<f64>) -> Vec<Placed<'given>> {
    let placed = |given: &'given GivenPart| {
        let mesh = given.mesh()?;
        Some(Placed { solid: &mesh.solid, placement: parent * given.placement(), clearance: mesh.making.clearance })
    };
    given_parts.iter().filter_map(placed).collect()
}

/// Refuses facets that take too much of the gap of a round fit.
fn require_fine<'given>(
    fit: Option<Fit>,
    chosen: usize,
    meshes: impl Iterator<Item = &'given GivenMesh<'given>>,
) -> Result<(), SceneError> {
    let coarsest = meshes.map(|mesh| (mesh.making.facets.unwrap_or(chosen), mesh)).min_by_key(|(facets, _)| *facets);
    let (Some(fit), Some((facets, mesh))) = (fit.filter(|fit| fit.gap > 0.0), coarsest) else { return Ok(()) };
    if fit.lost(facets) <= LARGEST_SHARE * fit.gap {
        return Ok(());
    }
    Err(mesh.refuse(format!(
        "{facets} facets of a full turn take {:.4} mm of the gap of {:.4} mm between a round part and its hole, more than \
         {:.0} %: raise `facets` of the meshes, or state a larger `clearance`",
        1e3 * fit.lost(facets),
        1e3 * fit.gap,
        1e2 * LARGEST_SHARE
    )))
}

fn convex(
    given_parts: &[GivenPart],
    cover: impl Fn(&GivenMesh, &GivenPart) -> Result<(MeshPart, Vec<Polytope>), SceneError>,
) -> Result<(Vec<Part>, Vec<MeshPart>), SceneError> {
    let (mut parts, mut meshes) = (Vec::new(), Vec::new());
    for group in given_parts.chunk_by(|one, other| one.name == other.name) {
        let (mut shapes, mut own_meshes) = (Vec::new(), Vec::new());
        for given in group {
            shapes.push(match &given.shape {
                Shape::Convex(shape) => vec![shape.placed(given.position, given.orientation)],
                Shape::Mesh(mesh) => {
                    let (mesh, pieces) = cover(mesh, given)?;
                    own_meshes.push(mesh);
                    pieces
                }
            });
        }
        let shapes = without_contained(&shapes);
        let mut begin = parts.len();
        for (mesh, pieces) in own_meshes.into_iter().zip(&shapes) {
            meshes.push(MeshPart { parts: begin..begin + pieces.len(), ..mesh });
            begin += pieces.len();
        }
        parts.extend(named(&group[0].name, shapes.concat()));
    }
    Ok((parts, meshes))
}

/// Parts of a name and a number, or of the name alone where there is only one.
fn named(name: &str, shapes: Vec<Polytope>) -> impl Iterator<Item = Part> {
    let is_alone = shapes.len() == 1;
    (1..).zip(shapes).map(move |(number, shape)| {
        let name = if is_alone { name.to_owned() } else { format!("{name}.{number}") };
        Part { name, shape }
    })
}

/// The pieces of some shapes without those that lie inside a piece of another shape, which nothing can touch.
fn without_contained(shapes: &[Vec<Polytope>]) -> Vec<Vec<Polytope>> {
    let is_contained = |index: usize, piece: &Polytope| {
        let others = shapes.iter().enumerate().filter(|(other, _)| *other != index);
        others.flat_map(|(other, pieces)| pieces.iter().map(move |around| (other, around))).any(|(other, around)| {
            // Of two that are equal the first stays.
            contains(around, piece) && (other < index || !contains(piece, around))
        })
    };
    let kept = shapes
        .iter()
        .enumerate()
        .map(|(index, pieces)| pieces.iter().filter(|piece| !is_contained(index, piece)).cloned().collect());
    kept.collect()
}

/// Whether a polytope lies in another one, but for rounding.
fn contains(around: &Polytope, piece: &Polytope) -> bool {
    piece.vertices().iter().all(|vertex| {
        let mut sides = around.normals().iter().zip(around.offsets());
        sides.all(|(normal, offset)| Vector3::from(*normal).dot(&Vector3::from(*vertex)) <= offset + ROUNDING)
    })
}
