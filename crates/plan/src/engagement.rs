//! How deep the parts engage: what guides the body across the insertion at its goal, and from where on.

use std::f64::consts::PI;

use nalgebra::Vector3;
use serde::Serialize;
use task::AssemblyTask;

use crate::clearance::Clearance;
use crate::pose_clearance::{largest_offset, longest_travel};

/// Axes across the insertion along which clearance is measured at first.
const AXES: usize = 8;
/// Clearance along the axis across the tightest one, in clearances along that, above which it may be free along an axis nearby.
const MUCH_WIDER: f64 = 2.0;
/// Halvings of the angle in which that axis is looked for.
const TURNS: usize = 16;
/// Poses on the straight path out.
const POSES: usize = 32;
/// Halvings of the last distance between two of them.
const HALVINGS: usize = 12;
/// Share of the path's length along an axis of the world that makes this the insertion axis.
const ALONG: f64 = 0.5;

/// How the environment guides the body across the insertion at its goal. A direction is guided where the body touches
/// something both ways within the range of the search: three times the largest offset or a tenth of the path, whichever
/// is longer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Engagement {
    /// Direction in which the body leaves its goal (unit vector, world frame).
    pub out: [f64; 3],
    /// Distance from the goal along that direction (m) up to which all directions are guided that are guided at the
    /// goal; `None` where nothing guides the body.
    pub depth_m: Option<f64>,
    /// Directions across the insertion along which nothing stops the body, either way (unit vectors, world frame).
    pub free: Vec<[f64; 3]>,
    /// Clearance between the stops of the tightest guided direction (m).
    pub clearance_m: Option<f64>,
    /// Resting error: how far clearance lets the body rest from its goal across the insertion, in guided directions
    /// (m); `None` where something stops it on one side only.
    pub rest_m: Option<f64>,
    /// Where a body that is off meets the environment; `None` where clearance is wide enough for all offsets.
    pub entrance: Option<Entrance>,
}

/// Where an offset body meets what guides it: the greatest distance from the goal at which clearance is less than twice the
/// largest offset.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Entrance {
    /// Distance from the goal along the way out (m).
    pub distance_m: f64,
    /// Clearance there between the stops of the tightest guided direction (m).
    pub clearance_m: f64,
}

/// Travel along an axis both ways (m); infinite where nothing stops the body.
#[derive(Debug, Clone, Copy)]
struct Travels {
    axis: Vector3<f64>,
    backward: Option<f64>,
    forward: Option<f64>,
}

impl Travels {
    fn is_free(&self) -> bool {
        self.backward.is_none() && self.forward.is_none()
    }

    /// Clearance between the two stops (m), infinite without them.
    fn clearance(&self) -> f64 {
        self.backward.zip(self.forward).map_or(f64::INFINITY, |(backward, forward)| backward + forward)
    }

    fn farther(&self) -> Option<f64> {
        Some(self.backward?.max(self.forward?))
    }
}

/// Finds what guides the body of a task at its goal, and how deep.
pub fn engagement(task: &AssemblyTask) -> Engagement {
    Search {
        offset: largest_offset(task),
        clearance: Clearance::new(task),
        goal: task.goal.position(),
        longest: longest_travel(task),
    }
    .run(task)
}

struct Search<'task> {
    clearance: Clearance<'task>,
    goal: Vector3<f64>,
    /// Largest offset, and longest travel that is looked at (m).
    offset: f64,
    longest: f64,
}

impl Search<'_> {
    fn run(mut self, task: &AssemblyTask) -> Engagement {
        let path = task.start.position() - self.goal;
        let Some(out) = self.out(&path) else {
            return Engagement {
                out: [0.0; 3],
                depth_m: None,
                free: Vec::new(),
                clearance_m: None,
                rest_m: None,
                entrance: None,
            };
        };
        let first = out.cross(&Vector3::ith(out.iamin(), 1.0)).normalize();
        let turned = |angle: f64| first * angle.cos() + out.cross(&first) * angle.sin();
        let goal = self.goal;
        let axes: Vec<Vector3<f64>> = (0..AXES).map(|index| turned(PI * index as f64 / AXES as f64)).collect();
        let around = self.travels(&goal, &axes);
        let tightest = around
            .iter()
            .copied()
            .min_by(|one, other| one.clearance().total_cmp(&other.clearance()))
            .unwrap_or(around[0]);
        let across = self.widest_near(&out.cross(&tightest.axis), &out, &tightest);
        // Where one direction is free, the guided one is across it.
        let tightest = if across.is_free() { self.along(&goal, &across.axis.cross(&out)) } else { tightest };
        let axes = [tightest, across];
        let guided: Vec<Vector3<f64>> =
            axes.iter().filter(|travels| travels.clearance().is_finite()).map(|travels| travels.axis).collect();
        let free: Vec<[f64; 3]> =
            axes.iter().filter(|travels| travels.is_free()).map(|travels| travels.axis.into()).collect();
        let rest_m = match free.len() {
            0 => around.iter().map(Travels::farther).try_fold(0.0, |most: f64, farther| Some(most.max(farther?))),
            _ => tightest.farther(),
        };
        let clearance_m = Some(tightest.clearance()).filter(|clearance| clearance.is_finite());
        let length = path.dot(&out);
        let depth_m = (!guided.is_empty()).then(|| {
            self.last(&out, length, |search, from| {
                search.travels(from, &guided).iter().all(|travels| travels.clearance().is_finite())
            })
        });
        let entrance = self.entrance(&out, length, &guided);
        Engagement { out: out.into(), depth_m, free, clearance_m, rest_m, entrance }
    }

    fn entrance(&mut self, out: &Vector3<f64>, length: f64, guided: &[Vector3<f64>]) -> Option<Entrance> {
        let tightest = |search: &mut Self, from: &Vector3<f64>| {
            search.travels(from, guided).iter().map(Travels::clearance).fold(f64::INFINITY, f64::min)
        };
        let catches = |clearance: f64, offset: f64| clearance < 2.0 * offset;
        let (goal, offset) = (self.goal, self.offset);
        if !catches(tightest(self, &goal), offset) {
            return None;
        }
        let distance_m = self.last(out, length, |search, from| catches(tightest(search, from), offset));
        Some(Entrance { distance_m, clearance_m: tightest(self, &(goal + out * distance_m)) })
    }

    /// The direction in which the body leaves its goal: along the path to the start or, where that leads through the
    /// environment, along the closest axis of the world that leads out.
    fn out(&mut self, path: &Vector3<f64>) -> Option<Vector3<f64>> {
        let straight = path.try_normalize(f64::EPSILON)?;
        let mut axes: Vec<Vector3<f64>> = (0..3).map(|axis| Vector3::ith(axis, straight[axis].signum())).collect();
        axes.retain(|axis| axis.dot(&straight) > ALONG);
        axes.sort_by(|one, other| other.dot(&straight).total_cmp(&one.dot(&straight)));
        let goal = self.goal;
        let leads_out = |axis: &Vector3<f64>| self.clearance.travel(&goal, axis, path.dot(axis)).is_none();
        Some(std::iter::once(straight).chain(axes).find(leads_out).unwrap_or(straight))
    }

    fn travels(&mut self, from: &Vector3<f64>, axes: &[Vector3<f64>]) -> Vec<Travels> {
        let directions: Vec<Vector3<f64>> = axes.iter().flat_map(|axis| [-axis, *axis]).collect();
        let travels = self.clearance.travels(from, &directions, self.longest);
        let both = axes.iter().zip(travels.chunks_exact(2));
        both.map(|(axis, travels)| Travels { axis: *axis, backward: travels[0], forward: travels[1] }).collect()
    }

    fn along(&mut self, from: &Vector3<f64>, axis: &Vector3<f64>) -> Travels {
        self.travels(from, std::slice::from_ref(axis))[0]
    }

    /// Travel at the goal along the axis of largest clearance near one across the tightest: a rail need not lie along
    /// one of the sampled axes.
    fn widest_near(&mut self, axis: &Vector3<f64>, out: &Vector3<f64>, tightest: &Travels) -> Travels {
        let goal = self.goal;
        let turned = |angle: f64| axis * angle.cos() + out.cross(axis) * angle.sin();
        let mut widest = self.along(&goal, axis);
        let (mut middle, mut angle) = (0.0, 0.5 * PI / AXES as f64);
        for _ in 0..TURNS {
            if widest.is_free() || !(widest.clearance() > MUCH_WIDER * tightest.clearance()) {
                break;
            }
            angle *= 0.5;
            for sign in [-1.0, 1.0] {
                let other = self.along(&goal, &turned(middle + sign * angle));
                if other.is_free() || other.clearance() > widest.clearance() {
                    (widest, middle) = (other, middle + sign * angle);
                    break;
                }
            }
        }
        widest
    }

    /// The distance from the goal up to which something holds of the body's position, looked at on a path of some length (m).
    fn last(
        &mut self,
        out: &Vector3<f64>,
        length: f64,
        mut holds: impl FnMut(&mut Self, &Vector3<f64>) -> bool,
    ) -> f64 {
        let goal = self.goal;
        let mut holds_at = |distance: f64| holds(self, &(goal + out * distance));
        let at = |pose: usize| length * pose as f64 / POSES as f64;
        let Some(first) = (1..=POSES).find(|&pose| !holds_at(at(pose))) else { return length };
        let (mut low, mut high) = (at(first - 1), at(first));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if holds_at(middle) { low = middle } else { high = middle }
        }
        low
    }
}
