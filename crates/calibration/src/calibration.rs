//! The search: fit, hold what the logs do not determine, and fit again.

use faer::Mat;
use plan::{PlannerError, Problem};
use workers::Workers;

use crate::deviation::COMPONENTS;
use crate::least_squares::{Fit, Model, fit, sum_of_squares};
use crate::log::Log;
use crate::model::Comparison;
use crate::parameter::{Parameter, Quantity};
use crate::profile::Valley;
use crate::run::Run;
use crate::statistics::{Information, correlation, standard_error};

/// The estimate of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// The parameter with its initial value.
    pub quantity: Quantity,
    /// Its value: the fitted one, or that of the scene where the logs do not determine it.
    pub value: f64,
    /// Its standard error; `None` where the logs do not determine it.
    pub standard_error: Option<f64>,
    /// The parameter whose effect is most like its own, with the correlation of both.
    pub partner: Option<(Parameter, f64)>,
}

impl Estimate {
    /// For a factor of the gains: whether the robot's gains differ significantly from those that were set, so that they
    /// should be corrected.
    pub fn is_off(&self) -> bool {
        let least = |error: f64| self.quantity.resolution.max(2.0 * error);
        self.standard_error.is_some_and(|error| (self.value - 1.0).abs() > least(error))
    }
}

/// Distance of rollouts from a run, as root mean squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Misfit {
    /// Distance (m).
    pub distance: f64,
    /// Angle (rad).
    pub angle: f64,
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunResult {
    /// Name of its log.
    pub name: String,
    /// Whether the parts could touch.
    pub has_contact: bool,
    /// Reason if only a part of it is used.
    pub end: Option<String>,
    /// Whether rollouts ring otherwise than the robot, which oscillates by itself: it then determines nothing.
    pub is_unexplained: bool,
    /// Length (s).
    pub duration: f64,
    /// Rollouts of the scene as it is; `None` where they diverge.
    pub before: Option<Misfit>,
    /// Rollouts with the fitted parameters.
    pub after: Misfit,
    /// Tracking error of the robot.
    pub tracking_error: Misfit,
}

/// Covariance of the identified parameters, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Covariance {
    /// Parameters of rows and columns.
    pub parameters: Vec<Parameter>,
    /// The rows.
    pub rows: Vec<Vec<f64>>,
}

/// The result of a calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// All parameters.
    pub estimates: Vec<Estimate>,
    /// Covariance of the identified parameters.
    pub covariance: Covariance,
    /// All runs.
    pub runs: Vec<RunResult>,
    /// Whether the search converged.
    pub converged: bool,
}

/// Rollouts follow a robot closely if their misfit is less than this share of its tracking error. Close to instability there
/// are many minima; at a wrong one, rollouts ring otherwise than the robot.
const EXPLAINED: f64 = 0.0075;

/// The start of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Number of parameters.
    pub parameters: usize,
    /// Number of logs.
    pub logs: usize,
}

/// The outcome of a comparison.
struct Outcome {
    values: Vec<f64>,
    /// Indices of the identified parameters, and their covariance.
    known: Vec<usize>,
    covariance: Mat<f64>,
    partners: Vec<Option<(Parameter, f64)>>,
    converged: bool,
}

/// Fits the robot of a scene to logs. With `per_joint`, every joint has its own rotor inertia and friction. `observe`
/// gets every fit before it starts.
///
/// # Errors
/// When a log does not fit the scene, or no rollout can be made.
pub fn calibrate(
    problem: &Problem,
    logs: &[Log],
    per_joint: bool,
    workers: &Workers,
    observe: &dyn Fn(Progress),
) -> Result<Calibration, PlannerError> {
    let runs: Vec<Run> = logs.iter().map(|log| Run::new(log, problem)).collect::<Result<_, _>>()?;
    let quantities = Quantity::all(problem, &runs, per_joint);
    let mut comparison = Comparison::new(problem, &runs, &quantities, workers);
    let before: Vec<f64> = quantities.iter().map(|quantity| quantity.before).collect();
    let misfits_before: Vec<Option<Misfit>> = (0..runs.len()).map(|run| comparison.misfit(run, &before)).collect();
    let (in_air, touching): (Vec<usize>, Vec<usize>) = (0..runs.len()).partition(|&run| !runs[run].has_contact());
    let mut outcome = Outcome::nothing(&before);
    if !in_air.is_empty() {
        // Contacts depend on all parameters: free motions are fitted first.
        comparison.compared = in_air;
        let is_free = |quantity: &Quantity| !quantity.parameter.is_of_contact();
        let begin = comparison.with_best_delay(before.clone(), is_free);
        outcome = comparison.search(&begin, is_free, observe)?;
    }
    if !touching.is_empty() {
        comparison.compared = (0..runs.len()).collect();
        // Contacts pull the delay out of the valley of free motions, whose width then says nothing.
        comparison.delay_error = None;
        let begin = comparison.with_best_friction(outcome.values);
        outcome = comparison.search(&begin, |_| true, observe)?;
    }
    let results = runs.iter().enumerate().zip(misfits_before).map(|((index, run), before)| {
        let after = comparison.misfit(index, &outcome.values).unwrap_or(Misfit { distance: f64::NAN, angle: f64::NAN });
        RunResult {
            name: run.name.clone(),
            has_contact: run.has_contact(),
            end: run.end.clone(),
            is_unexplained: run.swings && !comparison.explains(index, &outcome.values),
            duration: run.samples.last().map_or(0.0, |(time, _)| *time),
            before,
            after,
            tracking_error: Misfit::of(&run.tracking_errors),
        }
    });
    let results: Vec<RunResult> = results.collect();
    if results.iter().any(|run| run.is_unexplained) {
        outcome = Outcome::nothing(&before);
    }
    Ok(Calibration {
        estimates: (0..quantities.len()).map(|index| outcome.estimate(index, &quantities)).collect(),
        covariance: outcome.covariance(&quantities),
        runs: results,
        converged: outcome.converged,
    })
}

impl Outcome {
    fn nothing(values: &[f64]) -> Self {
        let partners = vec![None; values.len()];
        Self { values: values.to_vec(), known: Vec::new(), covariance: Mat::zeros(0, 0), partners, converged: true }
    }
}

impl Outcome {
    fn estimate(&self, index: usize, quantities: &[Quantity]) -> Estimate {
        let place = self.known.iter().position(|&known| known == index);
        Estimate {
            quantity: quantities[index].clone(),
            value: self.values[index],
            standard_error: place.map(|place| standard_error(&self.covariance, place)),
            partner: self.partners[index],
        }
    }

    fn covariance(&self, quantities: &[Quantity]) -> Covariance {
        let row = |row: usize| (0..self.known.len()).map(move |column| self.covariance[(row, column)]).collect();
        Covariance {
            parameters: self.known.iter().map(|&index| quantities[index].parameter).collect(),
            rows: (0..self.known.len()).map(row).collect(),
        }
    }
}

/// All columns up to `count` that are not in `columns`.
fn others(columns: &[usize], count: usize) -> Vec<usize> {
    (0..count).filter(|column| !columns.contains(column)).collect()
}

impl Comparison<'_> {
    /// Fits the free parameters until the runs determine all that remain free.
    fn search(
        &mut self,
        begin: &[f64],
        is_free: impl Fn(&Quantity) -> bool,
        observe: &dyn Fn(Progress),
    ) -> Result<Outcome, PlannerError> {
        let all: Vec<usize> = (0..self.quantities.len()).filter(|&index| is_free(&self.quantities[index])).collect();
        let mut free: Vec<usize> = (0..all.len()).collect();
        let mut outcome = Outcome::nothing(begin);
        loop {
            observe(Progress { parameters: free.len(), logs: self.compared.len() });
            let fitted: Vec<usize> = free.iter().map(|&column| all[column]).collect();
            let fit = self.fit_with_noise(&outcome.values, &fitted)?;
            let jacobian = self.jacobian(&fit.values, &fit.residuals, &all);
            let information = Information::new(&jacobian, &fit.residuals, &self.samples());
            let known = self.known(&information, &all, &free);
            let covariance = self.covariance(&information, &free, &all);
            for (place, &index) in fitted.iter().enumerate() {
                outcome.partners[index] = self.partner(&covariance, &fitted, place);
            }
            (outcome.values, outcome.converged) = (fit.values, fit.converged);
            if known.len() == free.len() {
                outcome.covariance = self.in_units(&covariance, &fitted, &outcome.values);
                outcome.known = fitted;
                return Ok(outcome);
            }
            for &column in free.iter().filter(|column| !known.contains(column)) {
                outcome.values[all[column]] = self.quantities[all[column]].before;
            }
            free = known;
        }
    }

    /// Covariance of free columns while the others are held. The error of the delay is that of its valley, with the same
    /// correlations: derivatives at one delay tell little of the next.
    fn covariance(&self, information: &Information, columns: &[usize], all: &[usize]) -> Mat<f64> {
        let covariance = information.covariance(columns, &others(columns, all.len()));
        let is_delay = |&column: &usize| self.quantities[all[column]].parameter == Parameter::Delay;
        let place = columns.iter().position(is_delay);
        let Some((place, error)) = place.zip(self.delay_error) else { return covariance };
        let factor = error / self.scale(all[columns[place]]) / standard_error(&covariance, place);
        let scale = |index: usize| if index == place { factor } else { 1.0 };
        Mat::from_fn(columns.len(), columns.len(), |row, column| scale(row) * covariance[(row, column)] * scale(column))
    }

    /// A covariance in SI units. A motion determines forces relative to the one that is assumed known, so all
    /// proportional parameters share its uncertainty.
    fn in_units(&self, covariance: &Mat<f64>, fitted: &[usize], values: &[f64]) -> Mat<f64> {
        /// Relative uncertainty of the masses of links, or of the stiffness of a robot without an arm.
        const DOUBT: f64 = 0.02;
        let scale = |place: usize| self.scale(fitted[place]);
        let doubt = |place: usize| {
            let index = fitted[place];
            if self.quantities[index].parameter.is_of_forces() { DOUBT * values[index] } else { 0.0 }
        };
        let least = |place: usize| self.quantities[fitted[place]].parameter.least_error(values[fitted[place]]);
        Mat::from_fn(fitted.len(), fitted.len(), |row, column| {
            let own = if row == column { least(row).powi(2) } else { 0.0 };
            scale(row) * covariance[(row, column)] * scale(column) + doubt(row) * doubt(column) + own
        })
    }

    /// A fit, and another one in which deviations are weighted with the noise after the first.
    fn fit_with_noise(&mut self, begin: &[f64], free: &[usize]) -> Result<Fit, PlannerError> {
        let first = fit(self, begin, free).ok_or_else(|| self.refusal(begin))?;
        self.noise = self.noise_of(&first.residuals);
        fit(self, &first.values, free).ok_or_else(|| self.refusal(&first.values))
    }

    fn refusal(&self, values: &[f64]) -> PlannerError {
        let diverges = self.compared.iter().find(|&&run| self.deviations(run, values).is_none());
        let name = diverges.map_or("", |&run| self.runs[run].name.as_str());
        let advice = match self.runs.iter().any(|run| run.robot.is_some()) {
            true => "robot.control_period, robot.delay, robot.bandwidth and robot.contact_stiffness",
            false => "robot.base, robot.grasp, robot.control_period and rotor_inertia",
        };
        let problem =
            format!("a rollout of the scene with these gains swings up or leaves the arm's reach: check {advice}");
        PlannerError::file(std::path::Path::new(name), problem)
    }

    /// Standard deviations of a component of positions (m) and orientations (rad), from residuals in units of the
    /// present noise.
    fn noise_of(&self, residuals: &[f64]) -> [f64; 2] {
        /// Smaller noise (m, rad) is numerical.
        const LEAST: [f64; 2] = [1e-7, 1e-6];
        std::array::from_fn(|kind| {
            let of_kind = residuals.chunks(3).skip(kind).step_by(2).flatten().copied();
            let squares: Vec<f64> = of_kind.collect();
            let count = squares.len().max(1) as f64;
            (self.noise[kind] * (sum_of_squares(&squares) / count).sqrt()).max(LEAST[kind])
        })
    }

    /// The free columns that the runs determine. While one is not determined, the least determined one is removed: the
    /// others may be determined without it.
    fn known(&self, information: &Information, all: &[usize], free: &[usize]) -> Vec<usize> {
        let mut columns = free.to_vec();
        loop {
            let covariance = self.covariance(information, &columns, all);
            let excess = |place: usize| {
                let quantity = &self.quantities[all[columns[place]]];
                quantity.scale * standard_error(&covariance, place) / quantity.resolution
            };
            let worst = (0..columns.len()).max_by(|&one, &other| excess(one).total_cmp(&excess(other)));
            match worst {
                Some(place) if !(excess(place) <= 1.0) => columns.remove(place),
                _ => return columns,
            };
        }
    }

    /// The parameter that is most correlated with that of a column.
    fn partner(&self, covariance: &Mat<f64>, free: &[usize], column: usize) -> Option<(Parameter, f64)> {
        let others = (0..free.len()).filter(|&other| other != column);
        let correlations = others.map(|other| (other, correlation(covariance, column, other)));
        let (other, correlation) = correlations.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()))?;
        Some((self.quantities[free[other]].parameter, correlation))
    }

    /// Numbers of samples of the compared runs.
    fn samples(&self) -> Vec<usize> {
        self.compared.iter().map(|&run| self.runs[run].samples.len()).collect()
    }

    /// Values at the best delay, from which a search over all free parameters ends at the least sum of squares; keeps the
    /// error of that delay.
    fn with_best_delay(&mut self, begin: Vec<f64>, is_free: impl Fn(&Quantity) -> bool) -> Vec<f64> {
        let Some(place) = self.place(Parameter::Delay) else { return begin };
        let is_other = |&index: &usize| index != place && is_free(&self.quantities[index]);
        let others: Vec<usize> = (0..self.quantities.len()).filter(is_other).collect();
        let valley = Valley::find(self, &begin, place, &others);
        self.delay_error = valley.error(&self.samples());
        valley.best().map_or(begin, |fit| fit.values.clone())
    }

    /// Whether rollouts follow a run closely.
    fn explains(&self, run: usize, values: &[f64]) -> bool {
        let tracking_error = Misfit::of(&self.runs[run].tracking_errors).distance;
        self.misfit(run, values).is_some_and(|misfit| misfit.distance < EXPLAINED * tracking_error)
    }

    fn place(&self, parameter: Parameter) -> Option<usize> {
        self.quantities.iter().position(|quantity| quantity.parameter == parameter)
    }

    /// With the candidate for contact friction that explains the runs best: a motion that jams where the robot's did
    /// not has no useful derivative.
    fn with_best_friction(&self, mut values: Vec<f64>) -> Vec<f64> {
        const FRICTIONS: [f64; 6] = [0.0, 0.1, 0.2, 0.3, 0.5, 0.8];
        let Some(place) = self.place(Parameter::Friction) else { return values };
        let mut best = (f64::INFINITY, values[place]);
        for friction in FRICTIONS {
            values[place] = friction;
            let squares = self.residuals(&values).map_or(f64::INFINITY, |residuals| sum_of_squares(&residuals));
            if squares < best.0 {
                best = (squares, friction);
            }
        }
        values[place] = best.1;
        values
    }

    fn misfit(&self, run: usize, values: &[f64]) -> Option<Misfit> {
        self.deviations(run, values).map(|deviations| Misfit::of(&deviations))
    }
}

impl Misfit {
    /// From deviations (m, rad).
    fn of(deviations: &[[f64; COMPONENTS]]) -> Self {
        let mean = |first: usize| {
            let squares = deviations.iter().map(|deviation| sum_of_squares(&deviation[first..first + 3]));
            (squares.sum::<f64>() / deviations.len().max(1) as f64).sqrt()
        };
        Self { distance: mean(0), angle: mean(3) }
    }
}
