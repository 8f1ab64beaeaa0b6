//! Coarse and fine pieces: where smoothing rounds shapes off anyway, pieces of both sides are merged into fewer ones, and
//! the primal-dual point is transferred to all of them.
//!
//! A pair of merged pieces stands for the pairs of their members. Its force belongs to the nearest of these, the others
//! exert none; back, it is that of the member with the largest force.

use std::collections::{BTreeMap, BTreeSet};

use collision::{Pair, Polytope};
use kkt::Owner;
use nlp::{Iterate, Start};
use task::{AssemblyTask, Complementarity, ContactPair, pose};

use crate::formulation::Formulation;
use crate::layout::Layout;
use crate::merging::merged;
use crate::terms::CONTACT_FORCE;

/// The problem of a task with merged pieces.
pub struct CoarsePieces {
    formulation: Formulation,
    /// The pairs of the task that each pair stands for.
    members: Vec<Vec<usize>>,
}

/// The pieces of one side.
struct Side<'task> {
    names: Vec<&'task str>,
    shapes: Vec<&'task Polytope>,
    /// The number of the piece of each pair.
    of_pairs: Vec<usize>,
}

impl CoarsePieces {
    /// Of a problem, with hulls that are no more than an error (m) outside the pieces they stand for. `None` where no pieces
    /// can be merged.
    pub fn within(error: f64, fine: &Formulation, complementarity: Complementarity) -> Option<Self> {
        let pairs = &fine.task().pairs;
        let body = Side::new(pairs.iter().map(|pair| (&pair.body, pair.shapes.body())));
        let environment = Side::new(pairs.iter().map(|pair| (&pair.environment, pair.shapes.environment())));
        let of_body = body.merged(&environment, error);
        let of_environment = environment.merged(&body, error);
        let mut coarse: Vec<ContactPair> = Vec::new();
        let mut members: Vec<Vec<usize>> = Vec::new();
        let mut known = BTreeMap::new();
        for (index, pair) in pairs.iter().enumerate() {
            let (one, body) = &of_body[body.of_pairs[index]];
            let (other, environment) = &of_environment[environment.of_pairs[index]];
            let number = *known.entry([one, other]).or_insert(coarse.len());
            if number == coarse.len() {
                coarse.push(ContactPair { shapes: Pair::new(body.clone(), environment.clone()), ..pair.clone() });
                members.push(Vec::new());
            }
            members[number].push(index);
        }
        (coarse.len() < pairs.len()).then(|| {
            let task = AssemblyTask { pairs: coarse, ..fine.task().clone() };
            Self { formulation: Formulation::new(&task, complementarity), members }
        })
    }

    /// The problem with merged pieces.
    pub fn formulation(&self) -> &Formulation {
        &self.formulation
    }

    /// A start of the problem with all pieces, for merged ones.
    pub fn start_of(&self, fine: &Formulation, start: &Start) -> Start {
        let x = match start {
            Start::Cold(x) => x,
            Start::Warm(point) => &point.x,
        };
        let layout = fine.layout();
        let strongest = self.best_members(|stage, scenario, member| {
            let slot = layout.contacts().slot(stage, scenario, member);
            let force = |slot| x[layout.variable(CONTACT_FORCE, stage, Owner::Scenario(scenario)) + slot];
            slot.map_or(f64::NEG_INFINITY, force)
        });
        let source = |stage: usize, scenario: usize, pair: usize| Some(strongest[pair][self.place(stage, scenario)]);
        match start {
            Start::Cold(x) => Start::Cold(self.formulation.variables_from(fine, x, &source)),
            Start::Warm(point) => Start::Warm(self.formulation.point_from(fine, point, &source)),
        }
    }

    /// A point of the problem with merged pieces, for all of them.
    pub fn fine_point(&self, fine: &Formulation, point: &Iterate) -> Iterate {
        let motions = self.formulation.compliant_poses(&point.x);
        let poses = pose::arrays(&motions.concat());
        let pairs = &fine.task().pairs;
        let distances: Vec<Vec<f64>> = pairs.iter().map(|pair| pair.shapes.exact_distances(&poses)).collect();
        let nearest = self.best_members(|stage, scenario, member| {
            // The contact of a stage is at the pose before its step.
            -distances[member][scenario * motions[scenario].len() + stage - 1]
        });
        let mut coarse_of = vec![0; pairs.len()];
        for (coarse, members) in self.members.iter().enumerate() {
            members.iter().for_each(|&member| coarse_of[member] = coarse);
        }
        let source = |stage: usize, scenario: usize, pair: usize| {
            let coarse = coarse_of[pair];
            (nearest[coarse][self.place(stage, scenario)] == pair).then_some(coarse)
        };
        fine.point_from(&self.formulation, point, &source)
    }

    /// The member of each pair with the largest value of a stage (from 1), a scenario and a member, the first of equal ones; at
    /// the place of stage and scenario.
    fn best_members(&self, value: impl Fn(usize, usize, usize) -> f64) -> Vec<Vec<usize>> {
        let Layout { steps, scenarios, .. } = *self.formulation.layout();
        let best = |members: &Vec<usize>| {
            let places = (1..=steps).flat_map(|stage| (0..scenarios).map(move |scenario| (stage, scenario)));
            let best = |(stage, scenario)| {
                let best = members.iter().map(|&member| (value(stage, scenario, member), member));
                best.reduce(|best, next| if next.0 > best.0 { next } else { best }).map_or(0, |(_, member)| member)
            };
            places.map(best).collect()
        };
        self.members.iter().map(best).collect()
    }

    /// The place of a stage (from 1) and a scenario among all.
    fn place(&self, stage: usize, scenario: usize) -> usize {
        (stage - 1) * self.formulation.layout().scenarios + scenario
    }
}

impl<'task> Side<'task> {
    /// From the name and shape of the piece of each pair.
    fn new(pieces: impl Iterator<Item = (&'task String, &'task Polytope)>) -> Self {
        let mut side = Self { names: Vec::new(), shapes: Vec::new(), of_pairs: Vec::new() };
        for (name, shape) in pieces {
            let mut known = side.names.iter().zip(&side.shapes);
            let number = known.position(|(known, its)| known == name && *its == shape).unwrap_or(side.names.len());
            if number == side.names.len() {
                side.names.push(name);
                side.shapes.push(shape);
            }
            side.of_pairs.push(number);
        }
        side
    }

    /// The hull that stands for each piece, with its number. Only pieces with the same partners on the other side are merged,
    /// so that nothing touches what it has no pair with.
    fn merged(&self, other: &Side, error: f64) -> Vec<(usize, Polytope)> {
        let mut partners = vec![BTreeSet::new(); self.shapes.len()];
        for (&piece, &partner) in self.of_pairs.iter().zip(&other.of_pairs) {
            partners[piece].insert(partner);
        }
        let mut groups: BTreeMap<BTreeSet<usize>, Vec<usize>> = BTreeMap::new();
        for (piece, partners) in partners.into_iter().enumerate() {
            groups.entry(partners).or_default().push(piece);
        }
        let mut hulls: Vec<(usize, Polytope)> = self.shapes.iter().map(|shape| (0, (*shape).clone())).collect();
        let mut count = 0;
        for group in groups.values() {
            let shapes: Vec<&Polytope> = group.iter().map(|&piece| self.shapes[piece]).collect();
            for merged in merged(&shapes, error) {
                merged.members.iter().for_each(|&member| hulls[group[member]] = (count, merged.hull.clone()));
                count += 1;
            }
        }
        hulls
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNTURNED: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

    fn corner() -> AssemblyTask {
        let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
        scene::Scene::load(&file).unwrap().task(None, None).unwrap()
    }

    /// The corner with its floor in strips and a body of two halves, the second of which may touch some of the pieces only.
    fn in_pieces(touched_by_second: usize) -> Formulation {
        let mut task = corner();
        let half = |side: f64| Polytope::from_box([0.1, 0.2, 0.2]).unwrap().placed([0.05 * side, 0.0, 0.0], UNTURNED);
        let strip = |number: usize| {
            let strip = Polytope::from_box([0.1, 0.6, 0.1]).unwrap();
            strip.placed([-0.25 + 0.1 * number as f64, 0.0, -0.05], UNTURNED)
        };
        let pair = |body: usize, number: usize| ContactPair {
            body: format!("half {body}"),
            environment: format!("strip {number}"),
            shapes: Pair::new(half([-1.0, 1.0][body]), strip(number)),
        };
        let first = (0..6).map(|number| pair(0, number));
        task.pairs = first.chain((0..touched_by_second).map(|number| pair(1, number))).collect();
        task.horizon.steps = 8;
        Formulation::new(&task, Complementarity::Relaxation)
    }

    fn coarse(fine: &Formulation) -> CoarsePieces {
        CoarsePieces::within(1e-6, fine, Complementarity::Relaxation).unwrap()
    }

    #[test]
    fn pieces_with_the_same_partners_are_merged() {
        let all = coarse(&in_pieces(6));
        assert_eq!(all.members, [(0..12).collect::<Vec<_>>()]);
        let floor = all.formulation().task().pairs[0].shapes.environment();
        assert_eq!((floor.vertices().len(), floor.normals().len()), (8, 6));
        // The first two strips may touch both halves, the others the first one.
        let some = coarse(&in_pieces(2));
        assert_eq!(some.members, [vec![0, 1], vec![2, 3, 4, 5], vec![6, 7]]);
        let nothing = CoarsePieces::within(
            1e-6,
            &Formulation::new(&corner(), Complementarity::Relaxation),
            Complementarity::Relaxation,
        );
        assert!(nothing.is_none());
    }

    /// Values of the nearest member come back; the other members have none.
    #[test]
    fn points_are_those_of_the_nearest_pieces_and_come_back() {
        let fine = in_pieces(6);
        let coarse = coarse(&fine);
        let mut x = coarse.formulation().initial_guess();
        // Contact forces differ.
        for (index, value) in x.iter_mut().enumerate().filter(|(_, value)| **value == 1e-3) {
            *value = 1.0 + index as f64;
        }
        let numbered = |count: usize| (1..=count).map(|number| number as f64).collect::<Vec<_>>();
        let bounds = numbered(x.len());
        let constraint_multipliers = numbered(coarse.formulation().layout().constraint_count());
        let point = Iterate { x, constraint_multipliers, lower_multipliers: bounds.clone(), upper_multipliers: bounds };
        let fine_point = coarse.fine_point(&fine, &point);
        let layout = fine.layout();
        assert_eq!(fine_point.x.len(), layout.variable_count());
        let start = fine.task().start;
        let distance = |pair: usize| fine.task().pairs[pair].shapes.exact_distance(&start);
        let nearest = (0..12).map(distance).fold(f64::INFINITY, f64::min);
        let first = layout.variable(CONTACT_FORCE, 1, Owner::Scenario(0));
        let pushed: Vec<usize> = (0..12).filter(|pair| fine_point.x[first + pair] > 0.0).collect();
        assert_eq!(pushed.len(), 1);
        assert!(distance(pushed[0]) < nearest + 1e-9);
        let Start::Warm(back) = coarse.start_of(&fine, &Start::Warm(fine_point)) else { panic!("a warm start") };
        assert_eq!(back, point);
    }
}
