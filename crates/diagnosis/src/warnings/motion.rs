//! Warnings about forces, duration and departures of a plan.

use plan::Plan;
use plan::records::MotionRecord;

/// Contact force (N) beyond which a plan without a limit is warned of.
const FORCE: f64 = 60.0;
/// Rotation away from the straight motion (degrees) beyond which a plan is warned of.
const ROTATION: f64 = 15.0;

/// Forces without a limit, rotations, and departures in free air.
pub fn warnings(plan: &Plan) -> Vec<String> {
    let reach = plan.problem.offset_magnitude() + plan.problem.success().position;
    of(&plan.motion(), plan.task.limits.contact_force, reach)
}

/// For a motion with a limit of contact forces (N), infinite without one, and with errors of up to `reach` (m): offset
/// and tolerance together.
fn of(motion: &MotionRecord, limit: f64, reach: f64) -> Vec<String> {
    let MotionRecord { max_force_n: force, rotation, free_departure, .. } = motion;
    let mut warnings = Vec::new();
    // Comparisons are false for what is no number.
    if limit.is_infinite() && !(*force <= FORCE) {
        warnings.push(format!(
            "the plan pushes with {force:.0} N: set contact_force in [limits], for example contact_force = {FORCE:.1}"
        ));
    }
    let degrees = rotation.largest.to_degrees();
    if !(degrees <= ROTATION) {
        warnings.push(format!(
            "the plan rotates by up to {degrees:.0} degrees away from the straight motion, at {:.2} s, more than \
             {ROTATION:.0}: look at it in the page of `assembly-plan report` first, and make sure that nothing else is near",
            rotation.time_s
        ));
    }
    if !(free_departure.largest <= reach) {
        warnings.push(format!(
            "in free air the body leaves the straight path by up to {:.2} mm, at {:.2} s, more than offset and tolerance \
             together ({:.2} mm): make sure that nothing else is near",
            1e3 * free_departure.largest,
            free_departure.time_s,
            1e3 * reach
        ));
    }
    warnings
}

#[cfg(test)]
mod tests {
    use plan::records::Extreme;

    use super::*;

    fn motion(force: f64, degrees: f64, free: f64) -> MotionRecord {
        let extreme = |largest: f64| Extreme { largest, time_s: 0.5 };
        MotionRecord {
            duration_s: 3.0,
            max_force_n: force,
            rotation: extreme(degrees.to_radians()),
            departure: extreme(0.01),
            free_departure: extreme(free),
        }
    }

    #[test]
    fn a_gentle_straight_motion_is_not_warned_of() {
        assert_eq!(of(&motion(59.0, 14.9, 0.0029), f64::INFINITY, 0.003), Vec::<String>::new());
    }

    #[test]
    fn a_large_force_is_warned_of_where_no_limit_holds() {
        let warnings = of(&motion(299.8, 1.0, 0.0), f64::INFINITY, 0.003);
        let expected = "the plan pushes with 300 N: set contact_force in [limits], for example contact_force = 60.0";
        assert_eq!(warnings, [expected]);
        assert_eq!(of(&motion(299.8, 1.0, 0.0), 350.0, 0.003), Vec::<String>::new());
    }

    #[test]
    fn large_rotations_and_departures_in_free_air_are_warned_of() {
        let warnings = of(&motion(1.0, 59.0, 0.0112), 60.0, 0.003);
        assert!(
            warnings[0].starts_with("the plan rotates by up to 59 degrees away from the straight motion, at 0.50 s")
        );
        assert!(warnings[1].starts_with("in free air the body leaves the straight path by up to 11.20 mm, at 0.50 s"));
        assert_eq!(of(&motion(f64::NAN, f64::NAN, f64::NAN), f64::INFINITY, 0.003).len(), 3, "checks fail closed");
    }
}
