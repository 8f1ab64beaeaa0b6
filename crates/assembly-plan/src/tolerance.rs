//! `tolerance`: measures which errors a plan tolerates.

mod plans;

use planner::files::{require_folder, write_file};
use planner::{RunClock, Session};
use tolerance::{
    Fit, MapQuestion, NeedRecord, Quantity, Question, TOLERANCE, ToleranceRecord, ToleranceRequest, Trials, answer, svg,
};

use crate::arguments::ToleranceCommandArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::interrupt::stop_flag;
use crate::progress::Progress;
use crate::tolerance::plans::Plans;
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
    let Some(record) = measured else {
        tell!("interrupted before all was measured; nothing is written, but the same command uses the plans again");
        return Ok(Exit::Interrupted);
    };
    write_file(&out.join(TOLERANCE), record.json()?.as_bytes())?;
    if let Some(map) = &record.map {
        write_file(&out.join("tolerance.svg"), svg(map).as_bytes())?;
    }
    show(&record);
    say!("written to {}", out.display());
    let is_none_tolerated = record.boundaries.iter().any(|boundary| boundary.value.is_none());
    Ok(if is_none_tolerated { Exit::NoPlan } else { Exit::Done })
}

/// All that is asked for; `None` after an interrupt.
fn measure(
    arguments: &ToleranceCommandArguments,
    plans: &mut Plans,
    session: &Session,
) -> Result<Option<ToleranceRecord>, CommandError> {
    let Some((problem, reference)) = plans.nominal(arguments, session)? else { return Ok(None) };
    let request = ToleranceRequest {
        rate: arguments.target_rate,
        frictions: plans.frictions(arguments),
        cases: arguments.cases as usize,
        seed: arguments.seed,
    };
    let trials = Trials::new(&problem, reference, request, session)?;
    let map = requested_map(arguments, &trials)?;
    let over = map.as_ref().map(MapQuestion::over);
    let question = Question { quantities: arguments.quantity.clone(), need: arguments.need, map };
    let mut reference_at = |at: f64| match over {
        Some(over) => plans.for_row(arguments, &trials, over, at, session),
        None => Ok(None),
    };
    let mut answered = answer(&trials, &question, &mut reference_at, session)?;
    if let Some(record) = &mut answered {
        record.plans = plans.names();
    }
    Ok(answered)
}

/// The map that is asked for: none by default, where the scene has no clearance.
fn requested_map(arguments: &ToleranceCommandArguments, trials: &Trials) -> Result<Option<MapQuestion>, CommandError> {
    let [quantity, over] = arguments.map[..] else {
        return Err(CommandError::Usage("--map takes two quantities, such as offset,clearance".to_owned()));
    };
    let is_default = arguments.rows.is_empty() && arguments.fit.is_none() && over == Quantity::Clearance;
    if arguments.no_map || (is_default && trials.clearance().is_err()) {
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
        _ => arguments.rows.clone(),
    };
    Ok(Some(MapQuestion::new(trials, quantity, over, &rows)?))
}

fn show(record: &ToleranceRecord) {
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
            Quantity::Offset => Some(format!(", planned for {}", Quantity::Offset.in_words(record.planned_offset_m))),
            _ => None,
        };
        say!("  {}{}", boundary, note.unwrap_or_default());
    }
    if let Some(NeedRecord { quantity, value, clearance }) = &record.need {
        say!("{} of {} needs a {}", quantity.in_words(*value), quantity.name(), clearance);
    }
    let Some(map) = &record.map else { return };
    say!("\n{} by {}:", map.quantity.name(), map.over.name());
    for row in &map.rows {
        say!("  at {}: {}", map.over.in_words(row.at), row.boundary);
    }
    let at = match map.over {
        Quantity::Clearance => record.clearance_m.unwrap_or_default(),
        Quantity::Offset => record.planned_offset_m,
        _ => 0.0,
    };
    if let Some(sentence) = map.sensitivity(at) {
        say!("{sentence}");
    }
}
