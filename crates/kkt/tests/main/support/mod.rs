//! Random matrices with the structure of a transcribed assembly problem, and dense linear algebra as the reference.

use kkt::{Class, Label, Owner};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

const POSE: usize = 7;
const TWIST: usize = 6;

/// Shape of a random matrix.
#[derive(Debug, Clone)]
pub struct Shape {
    pub stages: usize,
    pub scenarios: usize,
    pub pairs: usize,
    /// Complementarity products are equalities.
    pub smoothing: bool,
    /// Added to the diagonal of the variables.
    pub delta_w: f64,
    /// Subtracted from the diagonal of the multipliers.
    pub delta_c: f64,
    pub seed: u64,
}

/// Shapes small enough for a dense eigenvalue solver.
pub fn shapes() -> impl Strategy<Value = Shape> {
    let sizes = (1..4_usize, 1..4_usize, 0..4_usize);
    let delta_w = prop_oneof![Just(0.0), Just(1.0), Just(20.0), Just(1e4)];
    let delta_c = prop_oneof![Just(0.0), Just(1e-8), Just(1e-2)];
    (sizes, any::<bool>(), delta_w, delta_c, any::<u64>()).prop_map(
        |((stages, scenarios, pairs), smoothing, delta_w, delta_c, seed)| Shape {
            stages,
            scenarios,
            pairs,
            smoothing,
            delta_w,
            delta_c,
            seed,
        },
    )
}

/// A symmetric matrix by triplets.
#[derive(Debug, Clone, Default)]
pub struct System {
    pub labels: Vec<Label>,
    pub rows: Vec<usize>,
    pub columns: Vec<usize>,
    pub values: Vec<f64>,
}

impl System {
    /// The matrix of a step of an interior-point method, with random values of very different magnitudes.
    pub fn random(shape: &Shape) -> Self {
        let mut system = Self::default();
        let mut random = Random(shape.seed);
        let stages: Vec<StageRows> = (1..=shape.stages).map(|stage| system.add_rows(stage, shape)).collect();
        for (index, stage) in stages.iter().enumerate() {
            let previous = index.checked_sub(1).map(|index| &stages[index]);
            for trajectory in 0..=shape.scenarios {
                system.add_trajectory(stage, previous, trajectory, &mut random);
            }
            for scenario in 0..shape.scenarios {
                for pair in 0..shape.pairs {
                    system.add_pair(stage, previous, scenario, pair, shape.smoothing, &mut random);
                }
            }
        }
        for row in 0..system.labels.len() {
            let regularisation = if system.labels[row].class.is_multiplier() { -shape.delta_c } else { shape.delta_w };
            system.add(row, row, regularisation);
        }
        system
    }

    pub fn dimension(&self) -> usize {
        self.labels.len()
    }

    pub fn multipliers(&self) -> usize {
        self.labels.iter().filter(|label| label.class.is_multiplier()).count()
    }

    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        self.rows.push(row);
        self.columns.push(column);
        self.values.push(value);
    }

    pub fn row(&self, stage: usize, class: Class, index: usize) -> usize {
        let found = |label: &Label| label.stage == stage && label.class == class && label.index == index;
        self.labels.iter().position(found).expect("a row of this label")
    }

    pub fn dense(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.dimension(), self.dimension());
        for ((&row, &column), &value) in self.rows.iter().zip(&self.columns).zip(&self.values) {
            matrix[(row, column)] += value;
            if row != column {
                matrix[(column, row)] += value;
            }
        }
        matrix
    }

    /// Number of negative eigenvalues, by the dense QR algorithm. Rows are scaled first, which does not change it.
    pub fn negative_eigenvalues(&self) -> usize {
        let mut matrix = self.dense();
        for _ in 0..5 {
            let scale: Vec<f64> = matrix.row_iter().map(|row| 1.0 / row.amax().sqrt()).collect();
            matrix = DMatrix::from_fn(scale.len(), scale.len(), |row, column| {
                scale[row] * matrix[(row, column)] * scale[column]
            });
        }
        let eigenvalues = matrix.symmetric_eigenvalues();
        assert!(eigenvalues.iter().all(|value| value.abs() > 1e-13), "the test's matrix is singular");
        eigenvalues.iter().filter(|&&value| value < 0.0).count()
    }

    /// `|A x - b|` relative to `|A| |x| + |b|`, the largest of all rows.
    pub fn backward_error(&self, x: &[f64], b: &[f64]) -> f64 {
        let (matrix, x) = (self.dense(), DVector::from_column_slice(x));
        let residual = &matrix * &x - DVector::from_column_slice(b);
        let terms = matrix.abs() * x.abs() + DVector::from_column_slice(b).abs();
        residual.iter().zip(&terms).map(|(residual, term)| residual.abs() / (term + 1e-300)).fold(0.0, f64::max)
    }

    fn add_rows(&mut self, stage: usize, shape: &Shape) -> StageRows {
        let mut block = |owner: Owner, class: Class, count: usize| {
            let first = self.labels.len();
            self.labels.extend((0..count).map(|index| Label { stage, owner, class, index }));
            first
        };
        let owners = (0..shape.scenarios).map(Owner::Scenario).chain([Owner::Reference]);
        let trajectories = owners
            .map(|owner| {
                let pairs = if owner == Owner::Reference { 0 } else { shape.pairs };
                let (product, slacks) = match shape.smoothing {
                    true => (Class::ComplementarityMultiplier, pairs),
                    false => (Class::InequalityMultiplier, 2 * pairs),
                };
                let is_compliant = owner != Owner::Reference;
                TrajectoryRows {
                    pose: block(owner, Class::Pose, POSE),
                    twist: block(owner, Class::Velocity, TWIST),
                    force: block(owner, Class::ContactForce, pairs),
                    slack: block(owner, Class::InequalitySlack, slacks),
                    kinematics: block(owner, Class::PoseMultiplier, POSE),
                    dynamics: is_compliant.then(|| block(owner, Class::VelocityMultiplier, TWIST)),
                    gap: block(owner, Class::InequalityMultiplier, pairs),
                    product: block(owner, product, pairs),
                }
            })
            .collect();
        StageRows { trajectories }
    }

    /// Cost, kinematics and velocity dynamics of a trajectory.
    fn add_trajectory(&mut self, stage: &StageRows, previous: Option<&StageRows>, number: usize, random: &mut Random) {
        let rows = &stage.trajectories[number];
        let reference = stage.trajectories.last().unwrap();
        self.add_block((rows.pose, POSE), (rows.pose, POSE), 0.3, 1.0, random);
        self.add_block((rows.twist, TWIST), (rows.twist, TWIST), 0.3, 1.0, random);
        self.add_block((rows.pose, POSE), (rows.twist, TWIST), 0.2, 1.0, random);
        for index in 0..POSE {
            self.add(rows.kinematics + index, rows.pose + index, 1.0);
            self.add(rows.pose + index, rows.pose + index, 0.5);
        }
        for index in 0..TWIST {
            self.add(rows.twist + index, rows.twist + index, 0.5);
        }
        self.add_block((rows.kinematics, POSE), (rows.pose, POSE), 0.2, 0.1, random);
        self.add_block((rows.kinematics, POSE), (rows.twist, TWIST), 0.4, 0.04, random);
        if let Some(dynamics) = rows.dynamics {
            for index in 0..TWIST {
                self.add(dynamics + index, rows.twist + index, 1.0);
            }
            self.add_block((dynamics, TWIST), (rows.twist, TWIST), 0.3, 0.1, random);
            self.add_block((rows.pose, POSE), (reference.pose, POSE), 0.3, 1.0, random);
        }
        let Some(previous) = previous else { return };
        let (before, reference) = (&previous.trajectories[number], previous.trajectories.last().unwrap());
        for index in 0..POSE {
            self.add(before.pose + index, rows.kinematics + index, -1.0);
        }
        if let Some(dynamics) = rows.dynamics {
            self.add_block((dynamics, TWIST), (before.pose, POSE), 0.5, 2.0, random);
            self.add_block((dynamics, TWIST), (before.twist, TWIST), 0.3, 1.0, random);
            self.add_block((dynamics, TWIST), (reference.pose, POSE), 0.5, 2.0, random);
        }
    }

    /// Gap and complementarity of a pair: the force and the states of its own and the previous stage.
    fn add_pair(
        &mut self,
        stage: &StageRows,
        previous: Option<&StageRows>,
        scenario: usize,
        pair: usize,
        smoothing: bool,
        random: &mut Random,
    ) {
        let rows = &stage.trajectories[scenario];
        let (force, gap, product) = (rows.force + pair, rows.gap + pair, rows.product + pair);
        let barrier = 10.0_f64.powf(random.between(-4.0, 6.0));
        self.add(force, force, barrier);
        let mut couple = |row: usize, size: f64, with_force: bool| {
            self.add_block((row, 1), (rows.twist, TWIST), 0.8, 0.04 * size, random);
            if let Some(previous) = previous {
                self.add_block((row, 1), (previous.trajectories[scenario].pose, POSE), 0.8, size, random);
            }
            if with_force {
                self.add(row, force, random.between(0.0, 0.1));
            }
        };
        couple(gap, 1.0, false);
        couple(product, 0.1, true);
        couple(force, 0.5, false);
        if let Some(dynamics) = rows.dynamics {
            self.add_block((dynamics, TWIST), (force, 1), 0.8, 1.0, random);
        }
        let pairs = rows.product - rows.gap;
        let slacks: &[(usize, usize)] = &[(gap, rows.slack + pair), (product, rows.slack + pairs + pair)];
        for &(multiplier, slack) in &slacks[..if smoothing { 1 } else { 2 }] {
            self.add(multiplier, slack, -1.0);
            self.add(slack, slack, 10.0_f64.powf(random.between(-4.0, 6.0)));
        }
    }

    /// Random values in a fraction of a block's entries; of diagonal blocks in the lower triangle.
    fn add_block(
        &mut self,
        (row, height): (usize, usize),
        (column, width): (usize, usize),
        density: f64,
        size: f64,
        random: &mut Random,
    ) {
        for i in 0..height {
            for j in 0..width {
                let stored = row != column || j <= i;
                if stored && random.between(0.0, 1.0) < density {
                    self.add(row + i, column + j, random.between(-size, size));
                }
            }
        }
    }
}

struct StageRows {
    /// Scenarios, then the reference.
    trajectories: Vec<TrajectoryRows>,
}

/// First rows of every kind.
struct TrajectoryRows {
    pose: usize,
    twist: usize,
    force: usize,
    slack: usize,
    kinematics: usize,
    dynamics: Option<usize>,
    gap: usize,
    product: usize,
}

/// Pseudorandom numbers that are the same on every machine (splitmix).
pub struct Random(pub u64);

impl Random {
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        low + (high - low) * (bits >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn vector(&mut self, length: usize) -> Vec<f64> {
        (0..length).map(|_| self.between(-1.0, 1.0)).collect()
    }
}
