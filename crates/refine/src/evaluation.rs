//! Evaluations of robust plans: random offsets of several magnitudes, the planned ones, several frictions.

use std::f64::consts::TAU;

use fastrand::Rng;
use nalgebra::Vector3;
use plan::parameters::EvaluationParameters;
use plan::{OffsetRegion, Problem, RobustnessTarget, SuccessRate, SuccessRates};
use serde::{Deserialize, Serialize};
use simulation::{Disturbance, Evaluator, FrictionIndex, Reference, TestCase, TestResult, offsets};
use task::{AssemblyTask, Coverage, GraspError};

/// Steps of height and of angle from one [axis](training_axis) to the next: powers of 1 / 1.3247, the root of x^3 = x + 1, which
/// never repeat and leave no large gaps.
const AXIS_STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];

/// Largest errors to be tolerated: of the grasp, offsets of up to `delta-hat` (m) and a rotation (rad); of robot and
/// controller, relative ones of inertia and stiffness, a delay (s), and a bias of the sensor (N, Nm); and a radius of edges (m).
#[derive(Debug, Clone, Copy)]
pub struct ErrorRange {
    coverage: Coverage,
    offset_magnitude: f64,
    rotation_error: f64,
    inertia: f64,
    stiffness: f64,
    delay: f64,
    bias: [f64; 2],
    edge_radius: f64,
    evaluation: EvaluationParameters,
    disturbance_seed: u64,
}

impl ErrorRange {
    /// The requirements on a plan of a problem.
    pub fn new(problem: &Problem, target: &RobustnessTarget) -> Self {
        Self {
            coverage: problem.scene().coverage,
            offset_magnitude: problem.offset_magnitude(),
            rotation_error: target.rotation_error,
            inertia: target.inertia_error,
            stiffness: target.stiffness_error,
            delay: target.delay,
            bias: target.bias,
            edge_radius: problem.edge_radius(),
            evaluation: target.parameters.evaluation,
            disturbance_seed: target.parameters.seeds.disturbance,
        }
    }

    /// Rotation errors of full magnitude about random axes (rotation vectors, rad). Smaller ones fail less often, so
    /// these test most with few test cases.
    fn turns(&self, count: usize, seed: u64) -> Vec<[f64; 3]> {
        let largest = |rotation: [f64; 3]| {
            Vector3::from(rotation).try_normalize(0.0).map_or(rotation, |axis| (axis * self.rotation_error).into())
        };
        offsets::rotations(self.rotation_error, count, seed).into_iter().map(largest).collect()
    }

    /// Random offsets of the planned `offsets`' coverage, `count` for each of the fractions, in groups that are counted
    /// together.
    fn groups(&self, offsets: &[[f64; 3]], count: usize, seed: u64) -> Vec<OffsetGroup> {
        let Self { coverage, offset_magnitude, evaluation: EvaluationParameters { fractions, .. }, .. } = self;
        if *coverage == Coverage::Hull {
            let of_fraction = |(seed, fraction): (u64, &f64)| {
                let scaled: Vec<[f64; 3]> = offsets.iter().map(|offset| offset.map(|c| c * fraction)).collect();
                let offsets = offsets::covered(coverage, &scaled, fraction * offset_magnitude, count, seed);
                OffsetGroup { region: OffsetRegion::Hull, magnitude: fraction * offset_magnitude, offsets }
            };
            return (seed..).zip(fractions).map(of_fraction).collect();
        }
        let mut rim = offsets::covered(coverage, offsets, *offset_magnitude, fractions.len() * count, seed);
        let inside = rim.split_off(offsets::rim_count(rim.len()));
        let group = |(region, offsets)| OffsetGroup { region, magnitude: *offset_magnitude, offsets };
        [(OffsetRegion::Inside, inside), (OffsetRegion::Rim, rim)].map(group).into()
    }

    /// A robot, controller and edges within the range, uniformly distributed.
    fn disturbance(&self, random: &mut Rng) -> Disturbance {
        let mut relative = |largest: f64| largest * (2.0 * random.f64() - 1.0);
        let (inertia, stiffness) = (relative(self.inertia), relative(self.stiffness));
        let (delay, edge_radius) = (self.delay * random.f64(), self.edge_radius * random.f64());
        // Without a bias nothing is drawn for it.
        let mut component = |largest: f64| if largest > 0.0 { largest * (2.0 * random.f64() - 1.0) } else { 0.0 };
        let bias = std::array::from_fn(|axis| component(self.bias[axis / 3]));
        Disturbance { inertia, stiffness, delay, joint_friction: 0.0, bias, edge_radius }
    }
}

/// Random offsets of one magnitude (m) and region.
struct OffsetGroup {
    region: OffsetRegion,
    magnitude: f64,
    offsets: Vec<[f64; 3]>,
}

/// Identifies an evaluation of a problem.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Drawn {
    /// Largest number of random offsets per friction and magnitude.
    pub random: usize,
    /// Their seed.
    pub seed: u64,
}

/// Test cases of a reference, in groups of one friction, magnitude and region.
pub struct Evaluation {
    drawn: Drawn,
    parameters: EvaluationParameters,
    groups: Vec<SuccessRate>,
    /// The planned grasp errors first, then one of each group in turn, so that the first ones represent all groups.
    cases: Vec<TestCase>,
    /// Group of every test case.
    group: Vec<usize>,
}

/// What an evaluation asks for: success rates from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    /// At each friction.
    pub each: f64,
    /// Of all rollouts.
    pub overall: f64,
}

impl Wanted {
    /// The target rate at each friction, and no more.
    pub fn target(target: &RobustnessTarget) -> Self {
        Self { each: target.target_rate, overall: 0.0 }
    }

    fn is_met_by(self, rates: &SuccessRates) -> bool {
        rates.satisfy(self.each) && rates.overall() >= self.overall
    }

    fn is_shown_by(self, rates: &SuccessRates, confidence: f64) -> bool {
        rates.show(self.each, confidence) && rates.overall() >= self.overall
    }
}

/// The result of an evaluation.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// Of the test cases that were played.
    pub rates: SuccessRates,
    /// Whether every planned grasp error succeeds, and rates are as wanted in the whole evaluation, or shown by a part of it.
    pub reached: bool,
    /// The evaluation.
    pub evaluation: Drawn,
    /// Rollouts that were not played because it was stopped; 0 where it is decided.
    pub unplayed: usize,
    /// Test cases that failed.
    pub failures: Vec<(TestCase, TestResult)>,
}

impl Judgement {
    /// The test cases that failed.
    pub fn failing(&self) -> Vec<TestCase> {
        self.failures.iter().map(|(case, _)| *case).collect()
    }
}

impl Evaluation {
    /// At most `count` random offsets per friction and fraction of delta-hat, each with a rotation error, errors of
    /// robot and controller and rounded edges, and the planned grasp errors without other errors.
    pub fn new(task: &AssemblyTask, range: &ErrorRange, frictions: &[f64], count: usize, seed: u64) -> Self {
        let offset_magnitude = range.offset_magnitude;
        let mut random = Rng::with_seed(seed + range.disturbance_seed);
        let (mut groups, mut placed) = (Vec::new(), Vec::new());
        for (index, &friction) in frictions.iter().enumerate() {
            let mut add = |group: SuccessRate, errors: &mut dyn Iterator<Item = GraspError>| {
                let errors = GraspError::distinct(errors);
                let case = |(place, grasp)| {
                    let disturbance =
                        if group.planned { Disturbance::default() } else { range.disturbance(&mut random) };
                    (
                        !group.planned,
                        place,
                        groups.len(),
                        TestCase { friction: FrictionIndex(index), grasp, disturbance },
                    )
                };
                placed.extend(errors.into_iter().enumerate().map(case));
                groups.push(group);
            };
            let group = |region, magnitude, planned| SuccessRate::unplayed(friction, magnitude, region, planned);
            let random_groups = range.groups(&task.offsets(), count, seed);
            for (seed, OffsetGroup { region, magnitude, offsets }) in (seed..).zip(random_groups) {
                let spread = offsets::ball(range.evaluation.spread * offset_magnitude, offsets.len(), seed);
                let turns = range.turns(offsets.len(), seed);
                let error = |((offset, spread), rotation): (([f64; 3], &[f64; 3]), [f64; 3])| GraspError {
                    offset: std::array::from_fn(|axis| offset[axis] + spread[axis]),
                    rotation,
                };
                let errors = offsets.into_iter().zip(&spread).zip(turns).map(error);
                add(group(region, magnitude, false), &mut { errors });
            }
            let region = if range.coverage == Coverage::Hull { OffsetRegion::Hull } else { OffsetRegion::Rim };
            add(group(region, offset_magnitude, true), &mut task.grasps.iter().copied());
        }
        placed.sort_by_key(|&(is_random, place, group, _)| (is_random, place, group));
        let (group, cases) = placed.into_iter().map(|(_, _, group, case)| (group, case)).unzip();
        Self { drawn: Drawn { random: count, seed }, parameters: range.evaluation, groups, cases, group }
    }

    /// The test cases, in the order in which they are played.
    pub fn cases(&self) -> &[TestCase] {
        &self.cases
    }

    /// The first training set: the test cases of an evaluation with few random ones, with the largest rotation errors,
    /// each about another [axis](training_axis). A reference robust to these rotations is usually robust to smaller
    /// ones.
    pub fn into_training(self, range: &ErrorRange) -> Vec<TestCase> {
        let mut turns = (0..).map(|index| training_axis(index).map(|component| component * range.rotation_error));
        let Self { groups, mut cases, group, .. } = self;
        for (case, group) in cases.iter_mut().zip(group) {
            if !groups[group].planned {
                case.grasp.rotation = turns.next().unwrap_or_default();
            }
        }
        cases
    }

    /// Plays a reference in the test cases until it is decided whether it succeeds as often as wanted, and enough of them are
    /// known; or until `stop` returns true.
    pub fn judge(
        &self,
        evaluator: &Evaluator,
        reference: &Reference,
        wanted: Wanted,
        stop: &(dyn Fn() -> bool + Sync),
    ) -> Judgement {
        let (mut results, mut unplayed) = (Vec::new(), 0);
        for batch in self.cases.chunks(self.parameters.batch) {
            let Judgement { rates, failures, reached, .. } = self.judgement(&results, wanted);
            let EvaluationParameters { enough_failures, enough_rollouts, .. } = self.parameters;
            let is_enough = failures.len() >= enough_failures || results.len() >= enough_rollouts;
            if reached || is_enough && !self.can_satisfy(&rates.0, wanted) {
                break;
            }
            let Some(new) = evaluator.evaluate_all(reference, batch, stop) else {
                unplayed = self.cases.len() - results.len();
                break;
            };
            results.extend(new);
        }
        Judgement { unplayed, ..self.judgement(&results, wanted) }
    }

    /// The judgement from the results of the first test cases.
    pub fn judgement(&self, results: &[TestResult], wanted: Wanted) -> Judgement {
        let (mut groups, mut failures) = (self.groups.clone(), Vec::new());
        for ((result, case), &group) in results.iter().zip(&self.cases).zip(&self.group) {
            groups[group].count(result.passed, result.contact_force);
            if !result.passed {
                failures.push((*case, *result));
            }
        }
        let rates = SuccessRates(groups);
        let EvaluationParameters { enough_rollouts, confidence, .. } = self.parameters;
        let is_whole = results.len() == self.cases.len();
        let reached = is_whole && wanted.is_met_by(&rates)
            || results.len() >= enough_rollouts && wanted.is_shown_by(&rates, confidence);
        Judgement { reached, evaluation: self.drawn, unplayed: 0, rates, failures }
    }

    /// Whether rates could be as wanted if all remaining test cases succeeded.
    fn can_satisfy(&self, groups: &[SuccessRate], wanted: Wanted) -> bool {
        let mut hoped = groups.to_vec();
        for (index, group) in hoped.iter_mut().enumerate() {
            let all = self.group.iter().filter(|&&of| of == index).count();
            group.successes += all - group.rollouts;
            group.rollouts = all;
        }
        wanted.is_met_by(&SuccessRates(hoped))
    }
}

/// Axis number `index` of the rotation errors in training: any few in a row point in all directions, as the test cases
/// of one friction should.
fn training_axis(index: u32) -> [f64; 3] {
    let [height, turns] = AXIS_STEPS.map(|step| (0.5 + step * f64::from(index)).fract());
    let height = 1.0 - 2.0 * height;
    let (sin, cos) = (TAU * turns).sin_cos();
    let radius = (1.0 - height * height).sqrt();
    [radius * cos, radius * sin, height]
}

#[cfg(test)]
mod tests;
