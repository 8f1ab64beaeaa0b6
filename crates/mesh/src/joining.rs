//! Hulls that are joined as long as the hulls of both keep their distance.

use std::collections::VecDeque;

use rustc_hash::FxHashSet;

use crate::geometry::{Vector, boxes_meet};
use crate::hull::Hull;
use crate::touch::Touched;

/// Places in the way of hulls that are remembered.
const RECENT: usize = 64;

/// Hulls that are joined.
pub struct Joining<'a> {
    touched: &'a Touched<'a>,
    hulls: Vec<Option<Hull>>,
    /// Those that can be joined, with the share of the volume of both that is in neither.
    pairs: Vec<(f64, usize, usize)>,
    /// Those that cannot, with whatever else they are joined.
    apart: FxHashSet<(usize, usize)>,
    /// Places that were in the way are often in the way again.
    recent: VecDeque<usize>,
}

impl<'a> Joining<'a> {
    /// Of hulls that keep their distance from the places of a part.
    pub fn of(touched: &'a Touched<'a>, hulls: Vec<Hull>) -> Self {
        let mut joining = Self {
            touched,
            hulls: hulls.into_iter().map(Some).collect(),
            pairs: Vec::new(),
            apart: FxHashSet::default(),
            recent: VecDeque::new(),
        };
        (0..joining.hulls.len()).for_each(|new| joining.add(new));
        joining
    }

    /// Finds the hulls with which one can be joined, of those before it.
    fn add(&mut self, new: usize) {
        let Some(own) = &self.hulls[new] else { return };
        let near = self.hulls[..new].iter().enumerate().filter_map(|(index, hull)| Some((index, hull.as_ref()?)));
        let near = near.filter(|(index, hull)| {
            !self.apart.contains(&(*index, new)) && boxes_meet(&hull.bounds, &own.bounds, 4.0 * self.touched.tolerance)
        });
        let filled = self.touched.workers.map(near, |(index, hull)| {
            let volumes = hull.volume() + own.volume();
            let joined = self.touched.joined(hull, own, &self.recent).map(|joined| joined.volume());
            (index, joined.map(|volume| (volume - volumes) / volume))
        });
        for (index, filled) in filled {
            match filled {
                Ok(filled) => self.pairs.push((filled, index, new)),
                Err(in_the_way) => {
                    self.apart.insert((index, new));
                    self.recent.extend(in_the_way);
                }
            }
        }
        self.recent.drain(..self.recent.len().saturating_sub(RECENT));
    }

    /// Joins pairs, those first that fill least.
    pub fn join_all(mut self) -> Vec<Hull> {
        loop {
            self.pairs.sort_by(|one, other| other.0.total_cmp(&one.0).then(other.1.cmp(&one.1)));
            let Some((_, one, other)) = self.pairs.pop() else { break };
            let (Some(a), Some(b)) = (&self.hulls[one], &self.hulls[other]) else { continue };
            let points: Vec<Vector> = a.points.iter().chain(&b.points).copied().collect();
            let Some(joined) = Hull::of(&points, self.touched.tolerance) else { continue };
            let new = self.hulls.len();
            (self.hulls[one], self.hulls[other]) = (None, None);
            self.pairs.retain(|pair| ![pair.1, pair.2].iter().any(|at| *at == one || *at == other));
            // What one of both cannot be joined with, neither can both together.
            let is_apart = |from: usize, to: usize| self.apart.contains(&(from.min(to), from.max(to)));
            let apart: Vec<usize> = (0..new).filter(|&from| is_apart(from, one) || is_apart(from, other)).collect();
            self.apart.extend(apart.into_iter().map(|from| (from, new)));
            self.hulls.push(Some(joined));
            self.add(new);
        }
        self.hulls.into_iter().flatten().collect()
    }
}
