//! Files of a plan. Each is written under a temporary name and then renamed, so that none is ever half there.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::Path;

use task::{ContactPair, Trajectory};
use tempfile::NamedTempFile;

use crate::failure::Failure;

/// Columns of a state (pose, twist) in every table.
pub const STATE_COLUMNS: [&str; 13] =
    ["px_m", "py_m", "pz_m", "qw", "qx", "qy", "qz", "vx_m_s", "vy_m_s", "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s"];
const WRENCH_COLUMNS: [&str; 6] = ["fx_n", "fy_n", "fz_n", "tx_nm", "ty_nm", "tz_nm"];

/// Writes a file whole or not at all.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), Failure> {
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(|error| Failure::io(folder, &error))?;
    let mut file = NamedTempFile::new_in(folder).map_err(|error| Failure::io(folder, &error))?;
    file.write_all(content).map_err(|error| Failure::io(path, &error))?;
    make_readable(file.path()).map_err(|error| Failure::io(path, &error))?;
    file.persist(path).map_err(|error| Failure::io(path, &error.error))?;
    Ok(())
}

/// Removes a file, if there is one.
pub fn remove_file(path: &Path) -> Result<(), Failure> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(Failure::io(path, &error)),
        _ => Ok(()),
    }
}

/// Temporary files are private; results are not.
#[cfg(unix)]
fn make_readable(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(path, fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn make_readable(_path: &Path) -> std::io::Result<()> {
    Ok(())
}

/// Writes the four tables of a trajectory into a folder.
pub fn write_trajectory(folder: &Path, trajectory: &Trajectory, pairs: &[ContactPair]) -> Result<(), Failure> {
    write_file(&folder.join("reference.csv"), &reference(trajectory)?)?;
    write_file(&folder.join("scenarios.csv"), &scenarios(trajectory)?)?;
    write_file(&folder.join("wrench.csv"), &wrenches(trajectory)?)?;
    write_file(&folder.join("contacts.csv"), &contacts(trajectory, pairs)?)
}

fn reference(trajectory: &Trajectory) -> Result<Vec<u8>, Failure> {
    let header = std::iter::once("time_s").chain(STATE_COLUMNS);
    let rows =
        trajectory.reference.iter().enumerate().map(|(step, state)| {
            std::iter::once(time(trajectory, step)).chain(state.iter().map(f64::to_string)).collect()
        });
    table(header, rows)
}

fn scenarios(trajectory: &Trajectory) -> Result<Vec<u8>, Failure> {
    let header = ["time_s", "scenario"].into_iter().chain(STATE_COLUMNS);
    let rows = trajectory.scenarios.iter().enumerate().flat_map(|(scenario, motion)| {
        motion.states.iter().enumerate().map(move |(step, state)| {
            let place = [time(trajectory, step), (scenario + 1).to_string()];
            place.into_iter().chain(state.iter().map(f64::to_string)).collect()
        })
    });
    table(header, rows)
}

fn wrenches(trajectory: &Trajectory) -> Result<Vec<u8>, Failure> {
    let header = ["time_s", "scenario"].into_iter().chain(WRENCH_COLUMNS);
    let rows = trajectory.scenarios.iter().enumerate().flat_map(|(scenario, motion)| {
        motion.wrenches.iter().enumerate().map(move |(step, wrench)| {
            let place = [time(trajectory, step + 1), (scenario + 1).to_string()];
            place.into_iter().chain(wrench.iter().map(f64::to_string)).collect()
        })
    });
    table(header, rows)
}

fn contacts(trajectory: &Trajectory, pairs: &[ContactPair]) -> Result<Vec<u8>, Failure> {
    let header = ["time_s", "scenario", "pair", "distance_m", "force_n"];
    let rows = trajectory.scenarios.iter().enumerate().flat_map(|(scenario, motion)| {
        motion.contacts.iter().enumerate().flat_map(move |(step, contacts)| {
            contacts.iter().zip(pairs).map(move |(contact, pair)| {
                vec![
                    time(trajectory, step + 1),
                    (scenario + 1).to_string(),
                    pair.to_string(),
                    contact.distance.to_string(),
                    contact.force.to_string(),
                ]
            })
        })
    });
    table(header.into_iter(), rows)
}

fn time(trajectory: &Trajectory, step: usize) -> String {
    in_seconds(step as f64 * trajectory.time_step)
}

/// A time (s) without the rounding of its computation.
pub fn in_seconds(time: f64) -> String {
    const NANOSECONDS: f64 = 1e9;
    ((time * NANOSECONDS).round() / NANOSECONDS).to_string()
}

/// A table as CSV.
pub fn table<'header>(
    header: impl Iterator<Item = &'header str>,
    rows: impl Iterator<Item = Vec<String>>,
) -> Result<Vec<u8>, Failure> {
    let internal = |error: &dyn std::fmt::Display| Failure::Internal(format!("a table cannot be written: {error}"));
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header).map_err(|error| internal(&error))?;
    for row in rows {
        writer.write_record(&row).map_err(|error| internal(&error))?;
    }
    writer.into_inner().map_err(|error| internal(&error))
}
