//! `tolerance`: measures which errors a plan tolerates.

mod plans;

use std::path::Path;

use planner::files::{WorkFolder, read_text, remove_file, write_file};
use planner::{PlannerError, RunClock, Session};
use tolerance::{
    Fit, MapQuestion, Need, NeedRecord, Quantity, Question, TOLERANCE, ToleranceRecord, ToleranceRequest, Trials, Work,
    answer, svg,
};

use crate::arguments::ToleranceCommandArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::interrupt::stop_flag;
use crate::progress::Progress;
use crate::solve::DISCARDED;
use crate::tolerance::plans::Plans;
use crate::values::threads;

/// Name of the picture of the map.
const PICTURE: &str = "tolerance.svg";

/// Measures all that is asked for, writes it and prints it.
pub fn run(arguments: &ToleranceCommandArguments, clock: RunClock) -> Result<Exit, CommandError> {
    let mut plans = Plans::of(arguments)?;
    let progress = Progress::new(&arguments.progress)?;
    let stopped = stop_flag();
    let session = Session { threads: threads(arguments.jobs), clock, ..Session::new(&progress, &stopped) };
    let out = plans.out(arguments);
    let folder = WorkFolder::claim(&out)?;
    let unfinished = folder.path().join(TOLERANCE);
    if !arguments.resume && unfinished.exists() {
        remove_file(&unfinished)?;
        tell!("{DISCARDED}");
    }
    let measured = measure(arguments, &mut plans, &unfinished, &progress, &session)?;
    progress.end();
    let Some(record) = measured else {
        let again = if arguments.resume { "the same command" } else { "the same command with --resume" };
        tell!("interrupted; finished boundaries and plans are kept, and {again} resumes it");
        return Ok(Exit::Interrupted);
    };
    write_file(&out.join(TOLERANCE), record.json()?.as_bytes())?;
    match &record.map {
        Some(map) => write_file(&out.join(PICTURE), svg(map).as_bytes())?,
        // One of an earlier run would be taken for this one's.
        None => remove_file(&out.join(PICTURE))?,
    }
    remove_file(&unfinished)?;
    show(&record);
    say!("written to {0}; `assembly-plan report {0}` shows it", out.display());
    let is_none_tolerated = record.boundaries.iter().any(|boundary| boundary.value.is_none());
    Ok(if is_none_tolerated { Exit::NoPlan } else { Exit::Done })
}

/// All that is asked for; `None` after an interrupt. Finished boundaries are kept in the file `unfinished`, and those that it has
/// are not measured again.
fn measure(
    arguments: &ToleranceCommandArguments,
    plans: &mut Plans,
    unfinished: &Path,
    progress: &Progress,
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
    let need = arguments.need.map(|(quantity, value)| Need { quantity, value, by: arguments.by });
    let question = Question { quantities: arguments.quantity.clone(), need, map };
    let keep = |record: &[u8]| write_file(unfinished, record);
    let mut work = begun(Work::new(&trials, &question), unfinished, progress)?.kept_by(&keep);
    let mut reference_at = |at: f64| match over {
        Some(over) => plans.for_row(arguments, &trials, over, at, session),
        None => Ok(None),
    };
    let mut answered = answer(&trials, &question, &mut work, &mut reference_at, session)?;
    if let Some(record) = &mut answered {
        record.plans = plans.names();
    }
    Ok(answered)
}

/// Work with the boundaries that an earlier run has kept in a file, if there is one.
fn begun<'store>(work: Work<'store>, unfinished: &Path, progress: &Progress) -> Result<Work<'store>, PlannerError> {
    if unfinished.symlink_metadata().is_err() {
        return Ok(work);
    }
    let work = work.resumed(&read_text(unfinished)?).map_err(|error| {
        let advice = "repeat the command that was interrupted, or leave out --resume to measure from the beginning";
        PlannerError::file(unfinished, format!("cannot be resumed: {error}; {advice}"))
    })?;
    let noun = if work.count() == 1 { "boundary" } else { "boundaries" };
    progress.say(&format!("resuming after {} finished {noun} of an earlier run", work.count()));
    Ok(work)
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
    if let Some(NeedRecord { quantity, value, boundary }) = &record.need {
        say!("to tolerate {} of {}: {}", quantity.in_words(*value), quantity.name(), boundary);
    }
    let Some(map) = &record.map else { return };
    say!("\n{} by {}:", map.quantity.name(), map.over.name());
    for row in &map.rows {
        say!("  at {}: {}", map.over.in_words(row.at), row.boundary);
    }
    if let Some(sensitivity) = &map.sensitivity {
        say!("{}", sensitivity.sentence);
    }
}
