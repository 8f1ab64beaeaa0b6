//! What the tables of a plan show of its limits.

use super::Dir;

/// Largest components, by the keys of `reached` in `result.json`; accelerations are differences of velocities.
pub fn reached(dir: &Dir, folder: &str, time_step: f64) -> Vec<(&'static str, f64)> {
    let table = |name: &str| dir.table(format!("{folder}/{name}.csv"));
    let of_reference = table("reference").numbers_from("vx_m_s").into_iter().map(|twist| (String::new(), twist));
    let scenarios = table("scenarios");
    let of_scenario = scenarios.column("scenario").into_iter().map(str::to_owned);
    let twists: Vec<(String, Vec<f64>)> =
        of_reference.chain(of_scenario.zip(scenarios.numbers_from("vx_m_s"))).collect();
    let accelerations: Vec<Vec<f64>> = twists
        .windows(2)
        .filter(|pair| pair[0].0 == pair[1].0)
        .map(|pair| pair[0].1.iter().zip(&pair[1].1).map(|(one, other)| (other - one) / time_step).collect())
        .collect();
    let velocities: Vec<Vec<f64>> = twists.into_iter().map(|(_, twist)| twist).collect();
    let wrenches = table("wrench").numbers_from("fx_n");
    let forces = table("contacts").numbers_from("force_n");
    vec![
        ("translational_velocity_m_s", largest(&velocities, 0..3)),
        ("rotational_velocity_rad_s", largest(&velocities, 3..6)),
        ("translational_acceleration_m_s2", largest(&accelerations, 0..3)),
        ("rotational_acceleration_rad_s2", largest(&accelerations, 3..6)),
        ("contact_force_n", largest(&forces, 0..1)),
        ("force_n", largest(&wrenches, 0..3)),
        ("torque_nm", largest(&wrenches, 3..6)),
    ]
}

fn largest(rows: &[Vec<f64>], columns: std::ops::Range<usize>) -> f64 {
    rows.iter().flat_map(|row| &row[columns.clone()]).fold(0.0, |largest, number| number.abs().max(largest))
}
