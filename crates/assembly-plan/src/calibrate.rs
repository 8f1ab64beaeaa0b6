//! `calibrate`: fits the robot of a scene to logs of executed plans.

use calibration::{CalibrationRecord, Entries, Log, ParameterRecord, RunRecord, calibrate};
use planner::{Choices, Problem};
use workers::Workers;

use crate::arguments::CalibrateArguments;
use crate::console::{print_json, say, tell};
use crate::exit::{CommandError, Exit};
use crate::values::threads;

/// Fits, prints the estimates, and writes the new entries of the scene.
pub fn run(arguments: &CalibrateArguments) -> Result<Exit, CommandError> {
    let problem = Problem::load(&arguments.scene, &Choices::default())?;
    let logs: Vec<Log> =
        arguments.logs.iter().map(|file| Log::read(file, problem.scene())).collect::<Result<_, _>>()?;

    let workers = Workers::new(threads(arguments.jobs));
    let calibration = calibrate(&problem, &logs, arguments.per_joint, &workers, &|progress| {
        if !arguments.quiet {
            tell!("fitting {} parameters to {} logs", progress.parameters, progress.logs);
        }
    })?;
    let entries = Entries::new(&calibration, &problem);
    let record = CalibrationRecord::new(&calibration, &entries, &problem);
    if arguments.json {
        print_json(&record)?
    } else {
        print(&record)
    }
    record.warnings.iter().for_each(|warning| tell!("warning: {warning}"));
    if entries.is_empty() {
        tell!("these logs determine no entry of the scene; the remarks above say which runs would");
        return Ok(Exit::NoPlan);
    }
    match &arguments.out {
        Some(out) => {
            entries.write(&arguments.scene, out, arguments.force)?;
            tell!("written to {}", out.display());
        }
        None if !arguments.json => {
            say!("\nThe scene should say (--out FILE writes a copy that does):\n\n{}", entries.fragment())
        }
        None => {}
    }
    Ok(if calibration.converged { Exit::Done } else { Exit::NoPlan })
}

fn print(record: &CalibrationRecord) {
    say!("{}: distance between robot and rollout, as root mean squares", record.scene);
    say!("{:<28} {:<9} {:>8} {:>12} {:>12} {:>12}", "log", "", "time", "tracking", "before", "after");
    record.logs.iter().for_each(print_log);
    say!("\n{:<26} {:>12} {:>12} {:>11} {:<7} remark", "parameter", "before", "fitted", "error", "");
    record.parameters.iter().for_each(print_parameter);
}

fn print_log(log: &RunRecord) {
    let millimetres = |distance: f64| format!("{:.3} mm", 1e3 * distance);
    say!(
        "{:<28} {:<9} {:>6.1} s {:>12} {:>12} {:>12}",
        log.log,
        if log.has_contact { "contact" } else { "free air" },
        log.duration_s,
        millimetres(log.tracking_error_m),
        log.before_m.map_or("diverges".to_owned(), millimetres),
        millimetres(log.after_m)
    );
}

fn print_parameter(parameter: &ParameterRecord) {
    let (unit, scale) = parameter.unit;
    let (fitted, error) = match parameter.standard_error {
        Some(error) => (format!("{:.4}", scale * parameter.value), format!("+- {:.4}", scale * error)),
        None => ("held".to_owned(), String::new()),
    };
    let before = format!("{:.4}", scale * parameter.before);
    say!("{:<26} {before:>12} {fitted:>12} {error:>11} {unit:<7} {}", parameter.name, parameter.remark);
}
