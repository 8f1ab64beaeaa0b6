//! A tree of boxes for finding triangles near a point, a line or each other.

use crate::geometry::{Vector, bounds};

/// Boxes per leaf.
const LEAF: usize = 4;
/// Levels of a tree of any number of boxes: each halves them.
const DEEPEST: usize = 64;

struct Node {
    bounds: [Vector; 2],
    /// The boxes below, as places in the order of the tree.
    items: std::ops::Range<usize>,
    /// Second child; the first one follows its parent. Leaves have none.
    second: Option<usize>,
}

/// Boxes in a binary tree.
pub struct BoxTree {
    nodes: Vec<Node>,
    order: Vec<usize>,
}

impl BoxTree {
    pub fn new(boxes: &[[Vector; 2]]) -> Self {
        let mut tree = Self { nodes: Vec::new(), order: (0..boxes.len()).collect() };
        if !boxes.is_empty() {
            tree.build(boxes, 0..boxes.len());
        }
        tree
    }

    fn build(&mut self, boxes: &[[Vector; 2]], items: std::ops::Range<usize>) {
        let bounds = self.order[items.clone()]
            .iter()
            .map(|&item| boxes[item])
            .reduce(|[low, high], [next_low, next_high]| [low.inf(&next_low), high.sup(&next_high)])
            .unwrap_or_default();
        let node = self.nodes.len();
        self.nodes.push(Node { bounds, items: items.clone(), second: None });
        if items.len() <= LEAF {
            return;
        }
        let axis = (bounds[1] - bounds[0]).imax();
        let middle = items.start + items.len() / 2;
        let center = |item: &usize| boxes[*item][0][axis] + boxes[*item][1][axis];
        self.order[items.clone()]
            .select_nth_unstable_by(items.len() / 2, |one, other| center(one).total_cmp(&center(other)));
        self.build(boxes, items.start..middle);
        self.nodes[node].second = Some(self.nodes.len());
        self.build(boxes, middle..items.end);
    }

    /// Calls `found` for the boxes in all leaves whose bounds `enters` accepts.
    pub fn visit(&self, enters: impl FnMut(&[Vector; 2]) -> bool, mut found: impl FnMut(usize)) {
        self.find_map(enters, |item| {
            found(item);
            None::<()>
        });
    }

    /// The first that `find` returns of the boxes in leaves whose bounds `enters` accepts.
    pub fn find_map<T>(
        &self,
        mut enters: impl FnMut(&[Vector; 2]) -> bool,
        mut find: impl FnMut(usize) -> Option<T>,
    ) -> Option<T> {
        let mut waiting: Vec<usize> = (!self.nodes.is_empty()).then_some(0).into_iter().collect();
        while let Some(index) = waiting.pop() {
            let node = &self.nodes[index];
            if !enters(&node.bounds) {
                continue;
            }
            let found = match node.second {
                Some(second) => {
                    waiting.extend([second, index + 1]);
                    None
                }
                None => self.order[node.items.clone()].iter().find_map(|&item| find(item)),
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }

    /// The least that `distance` returns of pairs of an item of this tree and one of another (m), which is not asked for pairs
    /// in boxes farther apart than the least so far, its third argument.
    pub fn least_between(&self, other: &Self, mut distance: impl FnMut(usize, usize, f64) -> f64) -> f64 {
        let mut least = f64::INFINITY;
        if self.nodes.is_empty() || other.nodes.is_empty() {
            return least;
        }
        let apart = |one: usize, two: usize| squared_gap(&self.nodes[one].bounds, &other.nodes[two].bounds);
        let extent = |[low, high]: &[Vector; 2]| (high - low).norm_squared();
        let mut waiting = vec![(0, 0, apart(0, 0))];
        while let Some((one, two, between)) = waiting.pop() {
            if between >= least * least {
                continue;
            }
            let (node, against) = (&self.nodes[one], &other.nodes[two]);
            let halves = match (node.second, against.second) {
                (None, None) => {
                    for &item in &self.order[node.items.clone()] {
                        for &against in &other.order[against.items.clone()] {
                            least = least.min(distance(item, against, least));
                        }
                    }
                    continue;
                }
                (Some(second), None) => [(one + 1, two), (second, two)],
                (None, Some(second)) => [(one, two + 1), (one, second)],
                (Some(second), Some(_)) if extent(&node.bounds) > extent(&against.bounds) => {
                    [(one + 1, two), (second, two)]
                }
                (Some(_), Some(second)) => [(one, two + 1), (one, second)],
            };
            let mut halves = halves.map(|(one, two)| (one, two, apart(one, two)));
            halves.sort_by(|one, two| two.2.total_cmp(&one.2));
            waiting.extend(halves);
        }
        least
    }

    /// The item with the smallest squared distance from a point, which is no more than a distance (m), and that. Asked for an
    /// item, `squared_distance` may return anything larger than the most that it is told where the item is farther away.
    pub fn nearest(&self, point: &Vector, most: f64, squared_distance: impl Fn(usize, f64) -> f64) -> (usize, f64) {
        let mut nearest = (0, most * most);
        let to_box = |node: &Node| (point - point.sup(&node.bounds[0]).inf(&node.bounds[1])).norm_squared();
        let mut waiting = [(0, 0.0); DEEPEST];
        let mut count = 0;
        if let Some(root) = self.nodes.first() {
            waiting[0] = (0, to_box(root));
            count = 1;
        }
        while count > 0 {
            count -= 1;
            let (index, distance) = waiting[count];
            if distance >= nearest.1 {
                continue;
            }
            let node = &self.nodes[index];
            let Some(second) = node.second else {
                for &item in &self.order[node.items.clone()] {
                    let distance = squared_distance(item, nearest.1);
                    if distance < nearest.1 {
                        nearest = (item, distance);
                    }
                }
                continue;
            };
            let [one, other] = [index + 1, second].map(|child| (child, to_box(&self.nodes[child])));
            let (near, far) = if one.1 < other.1 { (one, other) } else { (other, one) };
            for child in [far, near] {
                if child.1 < nearest.1 {
                    waiting[count] = child;
                    count += 1;
                }
            }
        }
        nearest
    }
}

/// Squared distance of two boxes (m^2).
pub fn squared_gap([low, high]: &[Vector; 2], [other_low, other_high]: &[Vector; 2]) -> f64 {
    (0..3).map(|axis| (low[axis] - other_high[axis]).max(other_low[axis] - high[axis]).max(0.0).powi(2)).sum()
}

/// Sorts triangles so that those before the returned number lie below the others along the longest edge of their box.
pub fn divide(triangles: &mut [[Vector; 3]]) -> usize {
    let [low, high] = bounds(triangles.iter().flatten());
    let axis = (high - low).imax();
    let half = triangles.len() / 2;
    let along = |triangle: &[Vector; 3]| triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
    triangles.select_nth_unstable_by(half, |one, other| along(one).total_cmp(&along(other)));
    half
}
