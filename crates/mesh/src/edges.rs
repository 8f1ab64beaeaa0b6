//! The edges of a triangle mesh.

use std::collections::BTreeMap;

/// A triangle at an edge, and whether it runs through the edge from the smaller to the larger index.
#[derive(Debug, Clone, Copy)]
pub struct Side {
    pub triangle: usize,
    pub is_forward: bool,
}

/// Edges (smaller index first) with their triangles.
pub type Edges = BTreeMap<(usize, usize), Vec<Side>>;

/// The directed edges of a triangle.
pub fn directed([a, b, c]: [usize; 3]) -> [(usize, usize); 3] {
    [(a, b), (b, c), (c, a)]
}

/// The name of an edge.
pub fn undirected((from, to): (usize, usize)) -> (usize, usize) {
    (from.min(to), from.max(to))
}

/// All edges of triangles.
pub fn edges(triangles: &[[usize; 3]]) -> Edges {
    let mut edges = Edges::new();
    for (triangle, corners) in triangles.iter().enumerate() {
        for (from, to) in directed(*corners) {
            edges.entry(undirected((from, to))).or_default().push(Side { triangle, is_forward: from < to });
        }
    }
    edges
}

/// Triangles (indices) that hang together by edges, in lists.
pub fn components(count: usize, edges: &Edges) -> Vec<Vec<usize>> {
    let mut neighbors: Vec<Vec<usize>> = vec![Vec::new(); count];
    for sides in edges.values() {
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
