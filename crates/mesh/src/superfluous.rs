//! Triangles that a surface is closed without.

use std::collections::BTreeMap;

use crate::cell::is_wide;
use crate::edges::{directed, undirected};
use crate::geometry::Vector;

/// Triangles at an edge.
type Counts = BTreeMap<(usize, usize), usize>;

fn sides(triangle: [usize; 3]) -> impl Iterator<Item = (usize, usize)> {
    directed(triangle).into_iter().map(undirected)
}

fn counts(triangles: impl Iterator<Item = [usize; 3]>) -> Counts {
    let mut counts = Counts::new();
    triangles.for_each(|triangle| add(&mut counts, triangle));
    counts
}

fn add(counts: &mut Counts, triangle: [usize; 3]) {
    sides(triangle).for_each(|edge| *counts.entry(edge).or_default() += 1);
}

/// Of triangles with the same corners one is left: the others were exported twice, or are the other side of the same
/// surface. Where they have both windings none is left if the surface is closed without them: a wall between two bodies.
///
/// Such pairs that hang together are one patch, of which all are left or none. Its rim decides. Where that tells nothing,
/// it is a surface of its own and is left, so that nothing is lost.
pub fn without_copies(triangles: Vec<[usize; 3]>) -> Vec<[usize; 3]> {
    let mut copies: BTreeMap<[usize; 3], Vec<usize>> = BTreeMap::new();
    for (triangle, corners) in triangles.iter().enumerate() {
        let mut key = *corners;
        key.sort_unstable();
        copies.entry(key).or_default().push(triangle);
    }
    let is_pair = |same: &Vec<usize>| same.iter().any(|&other| !is_alike(triangles[same[0]], triangles[other]));
    let (pairs, mut kept): (Vec<Vec<usize>>, Vec<Vec<usize>>) = copies.into_values().partition(is_pair);
    let mut known = Known::new(&triangles, &pairs, &kept);
    let mut open = patches(&triangles, pairs, &known.singles);
    // A patch that is decided tells more about those beside it.
    while !open.is_empty() {
        let (decided, unknown): (Vec<_>, Vec<_>) =
            open.into_iter().map(|patch| (known.decide(&patch), patch)).partition(|(is_kept, _)| is_kept.is_some());
        let is_last = decided.is_empty();
        kept.extend(
            decided.into_iter().filter(|(is_kept, _)| *is_kept == Some(true)).flat_map(|(_, patch)| patch.sets),
        );
        open = unknown.into_iter().map(|(_, patch)| patch).collect();
        if is_last {
            kept.extend(open.drain(..).flat_map(|patch| patch.sets));
        }
    }
    let mut first: Vec<usize> = kept.iter().map(|same| same[0]).collect();
    first.sort_unstable();
    first.into_iter().map(|triangle| triangles[triangle]).collect()
}

/// Whether two triangles with the same corners have the same side.
fn is_alike(one: [usize; 3], [a, b, c]: [usize; 3]) -> bool {
    [[a, b, c], [b, c, a], [c, a, b]].contains(&one)
}

/// Sets of copies that hang together, and how many are at each edge.
struct Patch {
    sets: Vec<Vec<usize>>,
    counts: Counts,
}

/// Patches of pairs that meet at edges with nothing else than an even number of other triangles, those with the fewest
/// copies first: where bodies that are there twice touch, their wall is there more often.
fn patches(triangles: &[[usize; 3]], pairs: Vec<Vec<usize>>, singles: &Counts) -> Vec<Patch> {
    let mut at_edge: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for (set, same) in pairs.iter().enumerate() {
        sides(triangles[same[0]]).for_each(|edge| at_edge.entry(edge).or_default().push(set));
    }
    let is_even = |edge: &(usize, usize)| singles.get(edge).is_none_or(|singles| singles % 2 == 0);
    let mut is_taken = vec![false; pairs.len()];
    let mut patches = Vec::new();
    for first in 0..pairs.len() {
        if std::mem::replace(&mut is_taken[first], true) {
            continue;
        }
        let mut patch = vec![first];
        let mut next = 0;
        while let Some(&set) = patch.get(next) {
            next += 1;
            for edge in sides(triangles[pairs[set][0]]).filter(is_even) {
                let [one, other] = at_edge[&edge][..] else { continue };
                for set in [one, other] {
                    if !std::mem::replace(&mut is_taken[set], true) {
                        patch.push(set);
                    }
                }
            }
        }
        let sets: Vec<Vec<usize>> = patch.into_iter().map(|set| pairs[set].clone()).collect();
        let counts = counts(sets.iter().map(|same| triangles[same[0]]));
        patches.push(Patch { sets, counts });
    }
    patches.sort_by_key(|patch| patch.sets.iter().map(Vec::len).min());
    patches
}

/// What is known at the edges while patches are decided.
struct Known {
    /// Different triangles, one of each set.
    sets: Counts,
    /// Those that are no pairs.
    singles: Counts,
    /// Those of patches that are left, and of walls that are dropped.
    kept: Counts,
    walls: Counts,
}

impl Known {
    fn new(triangles: &[[usize; 3]], pairs: &[Vec<usize>], singles: &[Vec<usize>]) -> Self {
        let first = |same: &Vec<usize>| triangles[same[0]];
        Self {
            sets: counts(pairs.iter().chain(singles).map(first)),
            singles: counts(singles.iter().map(first)),
            kept: Counts::new(),
            walls: Counts::new(),
        }
    }

    /// Whether a patch is left, `None` where its rim does not tell. It is where the rim somewhere ends in nothing, or mostly
    /// where an odd number of other triangles meet, and it is not where that number is even, or other walls meet.
    fn decide(&mut self, patch: &Patch) -> Option<bool> {
        let at = |counts: &Counts, edge| counts.get(edge).copied().unwrap_or(0);
        let rim = || patch.counts.iter().filter(|(_, count)| **count % 2 == 1);
        let is_free = rim().any(|(edge, count)| self.sets[edge] == *count);
        let votes = rim().filter_map(|(edge, _)| match at(&self.singles, edge) {
            0 => (at(&self.walls, edge) > 0).then_some(true),
            singles => Some((singles + at(&self.kept, edge)) % 2 == 0),
        });
        let (mut closed, mut open) = (0, usize::from(is_free));
        votes.for_each(|is_closed| if is_closed { closed += 1 } else { open += 1 });
        if closed + open == 0 {
            return None;
        }
        let is_kept = is_free || open >= closed;
        let decided = if is_kept { &mut self.kept } else { &mut self.walls };
        patch.counts.iter().for_each(|(edge, count)| *decided.entry(*edge).or_default() += count);
        Some(is_kept)
    }
}

/// Drops triangles thinner than two tolerances (m) without which at least two of their edges are closed: they fill no gap.
pub fn without_slivers(mut triangles: Vec<[usize; 3]>, vertices: &[Vector], tolerance: f64) -> Vec<[usize; 3]> {
    let mut counts = counts(triangles.iter().copied());
    loop {
        let count = triangles.len();
        triangles.retain(|triangle| {
            let is_needed = sides(*triangle).filter(|edge| counts[edge] % 2 == 0).count() >= 2;
            let is_kept = is_needed || is_wide(&triangle.map(|corner| vertices[corner]), tolerance);
            if !is_kept {
                sides(*triangle).for_each(|edge| *counts.entry(edge).or_default() -= 1);
            }
            is_kept
        });
        if triangles.len() == count {
            return triangles;
        }
    }
}
