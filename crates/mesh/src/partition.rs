//! Binary space partition of a box by the planes of the surface in it.

use std::collections::{BTreeMap, BTreeSet};

use crate::cell::{Bound, Cell, is_wide};
use crate::elements::{Element, Elements};
use crate::error::MeshError;
use crate::geometry::{Vector, area_vector, clip};
use crate::solid::Solid;
use crate::winding::Winding;

/// Planes that are compared, and elements by which they are, at each split.
const CANDIDATES: usize = 32;
const SAMPLE: usize = 400;
/// Elements that turn from the plane by more than this cosine are no rough spots of it.
const ALIKE: f64 = 0.5;

/// Cells with and without material.
pub struct Partition {
    pub solid: Vec<Cell>,
    pub free: Vec<Cell>,
    /// Planes (their bounds) that split cells.
    pub used: Vec<Bound>,
}

/// A piece of an element in a cell.
#[derive(Clone)]
struct Fragment<'a> {
    element: &'a Element,
    polygon: Vec<Vector>,
    is_resolved: bool,
}

struct Node<'a> {
    cell: Cell,
    fragments: Vec<Fragment<'a>>,
}

/// Splits until no cell has surface in it other than within its slack, or `rough` (m), behind a plane that splits.
///
/// # Errors
/// When there are more cells than the most.
pub fn partition(elements: &Elements, solid: &Solid, rough: f64, most_cells: usize) -> Result<Partition, MeshError> {
    let mut partition = Partition { solid: Vec::new(), free: Vec::new(), used: Vec::new() };
    let fragments = elements.elements.iter();
    let fragments = fragments
        .map(|element| Fragment { element, polygon: element.polygon.clone(), is_resolved: false })
        .filter(|fragment| elements.root.bounds.iter().all(|side| !is_on(&fragment.polygon, side, elements.tolerance)))
        .collect();
    let mut waiting = vec![Node { cell: elements.root.clone(), fragments }];
    let mut used = BTreeSet::new();
    let winding = Winding::new((0..solid.triangles.len()).map(|triangle| solid.corners(triangle)).collect());
    while let Some(node) = waiting.pop() {
        if waiting.len() + partition.solid.len() + partition.free.len() > most_cells {
            return Err(MeshError::too_many_pieces(solid));
        }
        match choose(&node.fragments, elements) {
            Some(id) => {
                used.insert(id);
                let bound = elements.planes.get(id);
                waiting.extend([bound, bound.flipped()].iter().filter_map(|side| part(&node, side, elements, rough)));
            }
            None if !node.fragments.is_empty() || winding.number(&node.cell.center()) > 0.5 => {
                partition.solid.push(node.cell)
            }
            None => partition.free.push(node.cell),
        }
    }
    partition.used = used.into_iter().map(|id| elements.planes.get(id)).collect();
    Ok(partition)
}

fn is_on(polygon: &[Vector], bound: &Bound, tolerance: f64) -> bool {
    polygon.iter().all(|corner| bound.plane.height(corner).abs() <= tolerance)
}

/// The part of a node behind a side of a plane.
fn part<'a>(node: &Node<'a>, side: &Bound, elements: &Elements, rough: f64) -> Option<Node<'a>> {
    let tolerance = elements.tolerance;
    let cell = node.cell.cut(side, tolerance)?;
    let fragments = node.fragments.iter().filter_map(|fragment| {
        if is_on(&fragment.polygon, side, tolerance) {
            return None;
        }
        let element = fragment.element;
        let polygon = clip(&fragment.polygon, &side.plane, tolerance);
        if !is_wide(&polygon, tolerance) || is_on(&polygon, side, tolerance) {
            return None;
        }
        let slack = element.slack.max(rough) + tolerance;
        let is_near = || polygon.iter().all(|corner| side.plane.height(corner) >= -slack);
        let is_alike = element.bound.is(side) || element.bound.plane.normal.dot(&side.plane.normal) > ALIKE;
        let is_resolved = fragment.is_resolved || (is_alike && is_near());
        Some(Fragment { element, polygon, is_resolved })
    });
    Some(Node { fragments: fragments.collect(), cell })
}

/// The plane that splits little and resolves much, `None` when nothing is left to resolve.
fn choose(fragments: &[Fragment], elements: &Elements) -> Option<usize> {
    let mut areas: BTreeMap<usize, f64> = BTreeMap::new();
    let open: Vec<(&Fragment, f64)> = fragments
        .iter()
        .filter(|fragment| !fragment.is_resolved)
        .map(|fragment| (fragment, area_vector(&fragment.polygon).norm()))
        .collect();
    open.iter().for_each(|(fragment, area)| *areas.entry(fragment.element.bound.id).or_default() += area);
    let mut candidates: Vec<(usize, f64)> = areas.into_iter().collect();
    candidates.sort_by(|one, other| other.1.total_cmp(&one.1).then(one.0.cmp(&other.0)));
    candidates.truncate(CANDIDATES);
    let stride = open.len().div_ceil(SAMPLE).max(1);
    let sample: Vec<&(&Fragment, f64)> = open.iter().step_by(stride).collect();
    let total: f64 = sample.iter().map(|(_, area)| area).sum();
    let cost = |id: usize, own: f64| {
        let plane = elements.planes.get(id).plane;
        let (mut split, mut balance) = (0.0, 0.0_f64);
        for (fragment, area) in &sample {
            let (low, high) = plane.heights(&fragment.polygon);
            if low < -elements.tolerance && high > elements.tolerance {
                split += area;
            } else if fragment.element.bound.id != id {
                balance += if high > -low { *area } else { -area };
            }
        }
        3.0 * split / total - own / total / stride as f64 + 0.2 * balance.abs() / total
    };
    let costs = candidates.into_iter().map(|(id, own)| (id, cost(id, own)));
    costs.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(id, _)| id)
}
