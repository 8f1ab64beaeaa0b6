//! `tolerance`: measures which errors a plan tolerates.

mod plans;
mod record;

use planner::files::{require_folder, write_file};
use planner::{PlannerError, RunClock, Session};
use simulation::Reference;
use tolerance::{
    Boundary, Conditions, Fit, Quantity, ToleranceMap, ToleranceRequest, Trials, boundary, map, rows_around, svg,
};

use crate::arguments::ToleranceCommandArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::interrupt::stop_flag;
use crate::progress::Progress;
use crate::tolerance::plans::Plans;
use crate::tolerance::record::{NeedRecord, TOLERANCE, ToleranceRecord, line};
use crate::values::threads;

/// Measures all that is asked for, writes it and prints it.
pub fn run(arguments: &ToleranceCommandArguments, clock: RunClock) -> Result<Exit, CommandError> {
    let mut plans = Plans::of(arguments)?;
    let progress = Progress::new(&arguments.progress)?;
    let stopped = stop_flag();
    let session = Session { threads: threads(arguments.jobs), clock, ..Session::new(&progress, &stopped) };
    let out = plans.out(arguments);
    require_folder(&out)?;
    let measured = measure(arguments, &mut plans, &session)?;
    progress.end();
    let Some((record, nominal)) = measured else {
        tell!("interrupted before all was measured; nothing is written, but the same command uses the plans again");
        return Ok(Exit::Interrupted);
    };
    write_file(&out.join(TOLERANCE), &record.json()?)?;
    if let Some(map) = &record.map {
        write_file(&out.join("tolerance.svg"), svg(map).as_bytes())?;
    }
    show(&record, &nominal);
    say!("written to {}", out.display());
    let is_none_tolerated = record.boundaries.iter().any(|boundary| boundary.value.is_none());
    Ok(if is_none_tolerated { Exit::NoPlan } else { Exit::Done })
}

/// All that is asked for, and the conditions that the plan was made for; `None` after an interrupt.
fn measure(
    arguments: &ToleranceCommandArguments,
    plans: &mut Plans,
    session: &Session,
) -> Result<Option<(ToleranceRecord, Conditions)>, CommandError> {
    let Some((problem, reference)) = plans.nominal(arguments, session)? else { return Ok(None) };
    let request = ToleranceRequest {
        rate: arguments.target_rate,
        frictions: plans.frictions(arguments),
        cases: arguments.cases as usize,
        seed: arguments.seed,
    };
    let trials = Trials::new(&problem, reference, request.clone(), session)?;
    let requested = requested_map(arguments, &trials)?;
    let Some(boundaries) = boundaries(arguments, &trials, session)? else { return Ok(None) };
    let need = match arguments.need {
        Some((quantity, value)) => {
            let base = trials.nominal().with(quantity, value);
            let Some(clearance) = boundary(&trials, &base, Quantity::Clearance, session)? else { return Ok(None) };
            Some(NeedRecord { quantity, value, clearance })
        }
        None => None,
    };
    let map = match requested {
        Some(requested) => match draw(arguments, &trials, &request, &requested, plans, session)? {
            Some(map) => Some(map),
            None => return Ok(None),
        },
        None => None,
    };
    let record = ToleranceRecord::new(&problem, &plans.names(), &request, boundaries, need, map);
    Ok(Some((record, trials.nominal())))
}

/// The boundaries of single quantities; `None` after an interrupt.
fn boundaries(
    arguments: &ToleranceCommandArguments,
    trials: &Trials,
    session: &Session,
) -> Result<Option<Vec<Boundary>>, PlannerError> {
    let is_possible = |quantity: &Quantity| *quantity != Quantity::Clearance || trials.clearance().is_ok();
    let mut quantities = arguments.quantity.clone();
    if quantities.is_empty() {
        quantities.extend(Quantity::ALL.into_iter().filter(is_possible));
    }
    let mut found = Vec::with_capacity(quantities.len());
    for quantity in quantities {
        match boundary(trials, &trials.nominal(), quantity, session)? {
            Some(boundary) => found.push(boundary),
            None => return Ok(None),
        }
    }
    Ok(Some(found))
}

/// A map that is asked for.
struct Requested {
    quantity: Quantity,
    over: Quantity,
    rows: Vec<f64>,
}

fn requested_map(arguments: &ToleranceCommandArguments, trials: &Trials) -> Result<Option<Requested>, CommandError> {
    let [quantity, over] = arguments.map[..] else {
        return Err(CommandError::Usage("--map takes two quantities, such as offset,clearance".to_owned()));
    };
    if quantity == over {
        return Err(CommandError::Usage(format!("--map {0},{0}: the two quantities must differ", over.name())));
    }
    let has_no_clearance = [quantity, over].contains(&Quantity::Clearance) && trials.clearance().is_err();
    if arguments.no_map || (has_no_clearance && arguments.rows.is_empty() && arguments.fit.is_none()) {
        return Ok(None);
    }
    let rows = match (&arguments.fit, arguments.diameter) {
        (Some(_), _) if over != Quantity::Clearance => {
            return Err(CommandError::Usage("--fit needs a map over clearance".to_owned()));
        }
        (Some(name), Some(diameter)) => {
            let fit = Fit::new(name, diameter).map_err(|error| CommandError::Usage(format!("--fit: {error}")))?;
            say!("{name} at {} mm: clearance {:.3} to {:.3} mm", 1e3 * diameter, 1e3 * fit.least, 1e3 * fit.most);
            vec![fit.least, fit.most]
        }
        _ if arguments.rows.is_empty() => rows_around(trials, over)?,
        _ => arguments.rows.clone(),
    };
    Ok(Some(Requested { quantity, over, rows }))
}

/// Draws a map: of the one plan, or of a plan for each of its rows.
fn draw(
    arguments: &ToleranceCommandArguments,
    trials: &Trials,
    request: &ToleranceRequest,
    requested: &Requested,
    plans: &mut Plans,
    session: &Session,
) -> Result<Option<ToleranceMap>, PlannerError> {
    let Requested { quantity, over, rows } = requested;
    let mut was_interrupted = false;
    let mut reference_at = |at: f64| -> Result<Reference, PlannerError> {
        match plans.for_row(arguments, trials, *over, at, session)? {
            Some(reference) => Ok(reference),
            None => {
                was_interrupted = true;
                Ok(trials.reference().clone())
            }
        }
    };
    let mut plan_at = |at: f64| Trials::new(trials.problem(), reference_at(at)?, request.clone(), session);
    let drawn = map(*quantity, *over, rows, &mut plan_at, session)?;
    Ok(drawn.filter(|_| !was_interrupted))
}

fn show(record: &ToleranceRecord, nominal: &Conditions) {
    say!(
        "{}: largest errors at which {} % of the rollouts succeed, each with the others as planned, in brackets the \
         confidence interval of 95 %; frictions {} in turn",
        record.scene,
        100.0 * record.rate,
        record.frictions.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
    );
    for boundary in &record.boundaries {
        let note = match boundary.quantity {
            Quantity::Clearance => {
                record.clearance_m.map(|own| format!(", the scene's is {}", Quantity::Clearance.in_words(own)))
            }
            Quantity::Offset => Some(format!(", planned for {}", Quantity::Offset.in_words(nominal.offset))),
            _ => None,
        };
        say!("  {}{}", line(boundary), note.unwrap_or_default());
    }
    if let Some(NeedRecord { quantity, value, clearance }) = &record.need {
        say!("{} of {} needs a {}", quantity.in_words(*value), quantity.name(), line(clearance));
    }
    let Some(map) = &record.map else { return };
    say!("\n{} by {}:", map.quantity.name(), map.over.name());
    for row in &map.rows {
        say!("  at {}: {}", map.over.in_words(row.at), line(&row.boundary));
    }
    let at = match map.over {
        Quantity::Clearance => record.clearance_m.unwrap_or_default(),
        Quantity::Offset => nominal.offset,
        _ => 0.0,
    };
    if let Some(sentence) = map.sensitivity(at) {
        say!("{sentence}");
    }
}
