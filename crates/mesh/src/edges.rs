//! The edges of a triangle mesh.

use std::ops::Range;

/// Two vertices, smaller index first.
pub type Edge = (usize, usize);

/// A triangle at an edge, and whether it runs through the edge from the smaller to the larger index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Side {
    pub triangle: usize,
    pub is_forward: bool,
}

/// Edges in rising order, with their triangles.
#[derive(Debug, Clone)]
pub struct Edges {
    /// Each edge with the range of its sides.
    edges: Vec<(Edge, Range<usize>)>,
    sides: Vec<Side>,
}

/// The directed edges of a triangle.
pub fn directed([a, b, c]: [usize; 3]) -> [(usize, usize); 3] {
    [(a, b), (b, c), (c, a)]
}

/// The name of an edge.
pub fn undirected((from, to): (usize, usize)) -> Edge {
    (from.min(to), from.max(to))
}

/// All edges of triangles.
pub fn edges(triangles: &[[usize; 3]]) -> Edges {
    let mut all: Vec<(Edge, Side)> = Vec::with_capacity(3 * triangles.len());
    for (triangle, corners) in triangles.iter().enumerate() {
        let sides = directed(*corners);
        all.extend(sides.map(|(from, to)| (undirected((from, to)), Side { triangle, is_forward: from < to })));
    }
    all.sort_unstable();
    let mut first = 0;
    let edges = all.chunk_by(|one, other| one.0 == other.0).map(|same| {
        let range = first..first + same.len();
        first = range.end;
        (same[0].0, range)
    });
    Edges { edges: edges.collect(), sides: all.iter().map(|(_, side)| *side).collect() }
}

impl Edges {
    /// All edges with their sides.
    pub fn iter(&self) -> impl Iterator<Item = (Edge, &[Side])> {
        self.edges.iter().map(|(edge, range)| (*edge, &self.sides[range.clone()]))
    }

    /// The sides at an edge, none where there is no such edge.
    pub fn at(&self, edge: Edge) -> &[Side] {
        let found = self.edges.binary_search_by(|(other, _)| other.cmp(&edge));
        found.map_or(&[], |found| &self.sides[self.edges[found].1.clone()])
    }

    /// Those at which two triangles meet.
    pub fn with_two_sides(&self) -> Self {
        let two = self.edges.iter().filter(|(_, range)| range.len() == 2);
        Self { edges: two.cloned().collect(), sides: self.sides.clone() }
    }

    /// Number of edges.
    pub fn len(&self) -> usize {
        self.edges.len()
    }
}

/// Triangles (indices) that hang together by edges, in lists.
pub fn components(count: usize, edges: &Edges) -> Vec<Vec<usize>> {
    let mut neighbors: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (_, sides) in edges.iter() {
        for pair in sides.windows(2) {
            neighbors[pair[0].triangle].push(pair[1].triangle);
            neighbors[pair[1].triangle].push(pair[0].triangle);
        }
    }
    let mut is_taken = vec![false; count];
    let mut components = Vec::new();
    for first in 0..count {
        if std::mem::replace(&mut is_taken[first], true) {
            continue;
        }
        let mut component = vec![first];
        let mut next = 0;
        while let Some(&triangle) = component.get(next) {
            next += 1;
            for &neighbor in &neighbors[triangle] {
                if !std::mem::replace(&mut is_taken[neighbor], true) {
                    component.push(neighbor);
                }
            }
        }
        components.push(component);
    }
    components
}
