//! Tolerances of plans.

use std::path::Path;

use ::scene::Scene;
use planner::PlannerError;
use tolerance::{MapQuestion, Need, Quantity, Question, ToleranceRequest, Trials, Work, answer};

use crate::background::Watch;
use crate::options::ToleranceOptions;
use crate::plan::PlayedPlan;
use crate::simulation::problem;

/// As the command `tolerance` does with a plan; the content of `tolerance.json`.
pub fn measure(
    scene: &Scene,
    file: &Path,
    plan: &PlayedPlan,
    options: &ToleranceOptions,
    watch: &Watch,
) -> Result<String, PlannerError> {
    let problem = problem(scene, file, plan, options.position_tolerance, options.angle_tolerance)?;
    if !plan.require_made_for(&problem)? {
        watch.warn(format!("the plan was made with other settings than {} has", file.display()));
    }
    let session = watch.session(options.jobs);
    let frictions = options.friction.clone().unwrap_or_else(|| problem.scene().robustness.frictions.clone());
    let ToleranceOptions { target_rate: rate, cases, seed, .. } = *options;
    let request = ToleranceRequest { rate, frictions, cases, seed };
    let Some((_, reference)) = plan.motions.last() else {
        return Err(PlannerError::Internal("a plan without a motion"));
    };
    let trials = Trials::new(&problem, reference.clone(), request, &session)?;
    let named = |(name, value): &(String, f64)| {
        Ok::<_, PlannerError>(Need { quantity: quantity(name)?, value: *value, by: by(&options.by)? })
    };
    let map = match &options.map {
        Some((of, over)) => Some(MapQuestion::new(&trials, quantity(of)?, quantity(over)?, &options.rows)?),
        None => None,
    };
    let quantities = options.quantities.iter().map(|name| quantity(name)).collect::<Result<_, _>>()?;
    let question = Question { quantities, need: options.need.as_ref().map(named).transpose()?, map };
    let mut work = Work::new(&trials, &question);
    match answer(&trials, &question, &mut work, &mut |_| Ok(Some(reference.clone())), &session)? {
        Some(record) => record.json(),
        // Python raises the interrupt itself.
        None => Ok("{}".to_owned()),
    }
}

fn quantity(name: &str) -> Result<Quantity, PlannerError> {
    let names = Quantity::ALL.map(Quantity::name).join(", ");
    let unknown = || PlannerError::value("quantity", name, &format!("unknown; choose one of {names}"));
    Quantity::from_name(name).ok_or_else(unknown)
}

fn by(name: &str) -> Result<Quantity, PlannerError> {
    let names = Quantity::OF_PARTS.map(Quantity::name).join(" or ");
    let known = Quantity::from_name(name).filter(|quantity| Quantity::OF_PARTS.contains(quantity));
    known.ok_or_else(|| PlannerError::value("by", name, &format!("unknown; choose {names}")))
}
