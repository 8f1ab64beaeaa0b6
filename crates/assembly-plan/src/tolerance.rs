//! `tolerance`: measures which errors a plan tolerates.

mod kept;
mod plans;

use std::path::Path;

use planner::files::{WorkFolder, remove_file, write_file};
use planner::{Problem, RunClock, Session};
use simulation::Reference;
use tolerance::{
    Fit, MapQuestion, Need, NeedRecord, Quantity, Question, TOLERANCE, ToleranceRecord, ToleranceRequest, Trials, Work,
    answer, answer_one, svg,
};

use crate::arguments::ToleranceCommandArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::interrupt::stop_flag;
use crate::progress::Progress;
use crate::shell::word;
use crate::solve::DISCARDED;
use crate::tolerance::kept::Kept;
use crate::tolerance::plans::Plans;
use crate::values;
use crate::values::threads;

/// Name of the picture of the map.
const PICTURE: &str = "tolerance.svg";

/// Measures all that is asked for, writes it and prints it.
pub fn run(arguments: &ToleranceCommandArguments, clock: RunClock) -> Result<Exit, CommandError> {
    let MapFlags { rows, .. } = MapFlags::of(arguments)?;
    if let (Some(name), Some(diameter), [least, most]) = (&arguments.fit, arguments.diameter, &rows[..]) {
        say!("{name} at {} mm: clearance {:.3} to {:.3} mm", 1e3 * diameter, 1e3 * least, 1e3 * most);
    }
    let mut plans = Plans::of(arguments)?;
    let progress = Progress::new(&arguments.progress)?;
    let stopped = stop_flag();
    let session = Session { threads: threads(arguments.jobs), clock, ..Session::new(&progress, &stopped) };
    let out = plans.out(arguments);
    if let Some(index) = arguments.index {
        return measure_one(index, arguments, &mut plans, &out, &progress, &session);
    }
    let folder = WorkFolder::claim(&out)?;
    let kept = Kept::new(&folder, &out);
    if !arguments.resume && kept.discard()? {
        tell!("{DISCARDED}");
    }
    let measured = measure(arguments, &mut plans, &kept, &progress, &session)?;
    progress.end();
    let Some(record) = measured else {
        let again = if arguments.resume { "the same command" } else { "the same command with --resume" };
        tell!("interrupted; finished boundaries and plans are kept, and {again} resumes it");
        return Ok(Exit::Interrupted);
    };
    write_file(&out.join(TOLERANCE), record.json()?.as_bytes())?;
    match &record.map {
        Some(map) => write_file(&out.join(PICTURE), svg(map).as_bytes())?,
        // A picture of an earlier run would look like this run's.
        None => remove_file(&out.join(PICTURE))?,
    }
    kept.discard()?;
    show(&record);
    say!("written to {}; `assembly-plan report {}` shows it", out.display(), word(&out));
    Ok(if record.is_answered() { Exit::Done } else { Exit::NoPlan })
}

/// All that is asked for; `None` after an interrupt. Finished boundaries are kept, and those that are kept are not measured again.
fn measure(
    arguments: &ToleranceCommandArguments,
    plans: &mut Plans,
    kept: &Kept,
    progress: &Progress,
    session: &Session,
) -> Result<Option<ToleranceRecord>, CommandError> {
    let Some((problem, reference)) = plans.nominal(arguments, session)? else { return Ok(None) };
    let (trials, question) = asked(arguments, plans, &problem, reference, session)?;
    let keep = |record: &[u8]| write_file(&kept.own, record);
    let mut work = kept.begun(Work::new(&trials, &question), progress)?.kept_by(&keep);
    let over = question.map.as_ref().map(MapQuestion::over);
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

/// One of the boundaries, by its number, for a later run with --resume, which has the others.
fn measure_one(
    index: usize,
    arguments: &ToleranceCommandArguments,
    plans: &mut Plans,
    out: &Path,
    progress: &Progress,
    session: &Session,
) -> Result<Exit, CommandError> {
    let Some((problem, reference)) = plans.nominal(arguments, session)? else { return Ok(Exit::Interrupted) };
    let (trials, question) = asked(arguments, plans, &problem, reference, session)?;
    let file = kept::file_of(out, index);
    let keep = |record: &[u8]| write_file(&file, record);
    let mut work = kept::resumed_if_usable(&file, &trials, &question).kept_by(&keep);
    let mut reference_at = |_| Ok(Some(trials.reference().clone()));
    let found = answer_one(&trials, &question, index, &mut work, &mut reference_at, session)?;
    progress.end();
    let Some(boundary) = found else {
        tell!("interrupted; boundary {index} is not finished, and the same command measures it from the beginning");
        return Ok(Exit::Interrupted);
    };
    say!("boundary {index}: {boundary}");
    say!("kept in {}; the same command with --resume instead of --index answers the whole question", file.display());
    Ok(Exit::Done)
}

/// The rollouts of the plan, and what is asked of it.
fn asked<'problem>(
    arguments: &ToleranceCommandArguments,
    plans: &Plans,
    problem: &'problem Problem,
    reference: Reference,
    session: &Session,
) -> Result<(Trials<'problem>, Question), CommandError> {
    let request = ToleranceRequest {
        rate: arguments.target_rate,
        frictions: plans.frictions(arguments),
        cases: arguments.cases as usize,
        seed: arguments.seed,
    };
    let trials = Trials::new(problem, reference, request, session)?;
    let map = requested_map(arguments, &trials)?;
    let need = arguments.need.map(|(quantity, value)| Need { quantity, value, by: arguments.by });
    Ok((trials, Question { quantities: arguments.quantity.clone(), need, map }))
}

/// The map that is asked for: none by default, where the scene has no clearance.
fn requested_map(arguments: &ToleranceCommandArguments, trials: &Trials) -> Result<Option<MapQuestion>, CommandError> {
    let MapFlags { quantity, over, rows } = MapFlags::of(arguments)?;
    let is_default = rows.is_empty() && over == Quantity::Clearance;
    if arguments.no_map || (is_default && trials.clearance().is_err()) {
        return Ok(None);
    }
    Ok(Some(MapQuestion::new(trials, quantity, over, &rows)?))
}

/// What flags say of the map.
struct MapFlags {
    quantity: Quantity,
    over: Quantity,
    /// Values of `over`; none are chosen by the scene.
    rows: Vec<f64>,
}

impl MapFlags {
    /// Reads the flags, which need no plan.
    fn of(arguments: &ToleranceCommandArguments) -> Result<Self, CommandError> {
        let [quantity, over] = arguments.map[..] else {
            return Err(CommandError::Usage("--map takes two quantities, such as offset,clearance".to_owned()));
        };
        if quantity == over {
            let name = quantity.name();
            return Err(CommandError::Usage(format!("--map {name},{name}: the two quantities must differ")));
        }
        let rows = match (&arguments.fit, arguments.diameter) {
            (Some(_), _) if over != Quantity::Clearance => {
                return Err(CommandError::Usage("--fit needs a map over clearance".to_owned()));
            }
            (Some(name), Some(diameter)) => {
                let fit = Fit::new(name, diameter).map_err(|error| CommandError::Usage(format!("--fit: {error}")))?;
                vec![fit.least, fit.most]
            }
            _ => arguments.rows.clone(),
        };
        let in_range = rows.iter().try_for_each(|&row| values::in_range(over, row));
        in_range.map_err(|problem| CommandError::Usage(format!("--rows: {problem}")))?;
        Ok(Self { quantity, over, rows })
    }
}

fn show(record: &ToleranceRecord) {
    say!(
        "{}: largest tolerated errors ({} % of the rollouts succeed, other errors as planned; 95 % confidence interval in \
         brackets; frictions {} in turn)",
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
