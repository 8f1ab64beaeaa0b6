//! What to expect during the execution of a plan, and thresholds at which a player stops.

use plan::PlannerError;
use serde::Serialize;
use store::trajectory::read_tables;
use store::{MotionTables, StoredPlan};
use task::GraspError;

use crate::frames::Frames;
use crate::joints::Held;

/// A measured force or deviation may be this many times the largest planned one.
const MARGIN: f64 = 2.0;
/// The force at the tool may be this many times the limit of one contact: several push at once.
const CONTACTS: f64 = 1.5;
/// Guards that are tighter than these stop for noise (N, Nm, m, rad).
const LEAST_FORCE: f64 = 20.0;
const LEAST_TORQUE: f64 = 5.0;
const LEAST_DISTANCE: f64 = 0.01;
const LEAST_ANGLE: f64 = 0.05;
/// In free air the tool may be this far from its reference (m, rad), besides its tracking error and what joint friction holds.
const FREE_DISTANCE: f64 = 0.005;
const FREE_ANGLE: f64 = 0.02;
/// More than joint friction may hold (m, rad): where it could, the arm is close to a singular configuration.
const MOST_HELD: Held = Held { distance: 0.01, angle: 0.06 };

/// Largest values in all planned scenarios.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Expectation {
    /// Force of the controller (N).
    pub force_n: f64,
    /// Torque of the controller about the tool point (Nm).
    pub torque_nm: f64,
    /// Force of a contact (N).
    pub contact_force_n: f64,
    /// Distance of the tool from the reference (m).
    pub deviation_m: f64,
    /// Angle between the tool and the reference (rad).
    pub deviation_rad: f64,
    /// How far joint friction can hold the tool (m).
    pub held_m: f64,
    /// Angle by which joint friction can hold the tool (rad).
    pub held_rad: f64,
}

/// Values beyond which a player stops the robot, in every phase.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PhaseGuards {
    /// On the path to the start and in the test of the frames, where nothing may touch.
    pub approach: Guards,
    /// In a dry run, where nothing may touch either.
    pub dry_run: Guards,
    /// While parts are put together.
    pub insertion: Guards,
}

/// Values beyond which a player stops the robot.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Guards {
    /// Measured force at the tool, as a mean over 10 ms (N).
    pub force_n: f64,
    /// Measured torque at the tool (Nm).
    pub torque_nm: f64,
    /// Distance of the tool from the reference (m).
    pub deviation_m: f64,
    /// Angle between the tool and the reference (rad).
    pub deviation_rad: f64,
}

impl Expectation {
    /// From the tables of a plan, and from what joint friction can hold.
    ///
    /// # Errors
    /// When a table is missing or wrong.
    pub fn of(plan: &StoredPlan, frames: &Frames, held: Held) -> Result<Self, PlannerError> {
        let tables = read_tables(&plan.folder)?;
        let grasps: Vec<GraspError> =
            plan.result.scenarios.iter().map(|scenario| GraspError::from(&scenario.grasp)).collect();
        let contact_force_n = plan.result.reached.contact_force_n;
        let (held_m, held_rad) = (held.distance.min(MOST_HELD.distance), held.angle.min(MOST_HELD.angle));
        Ok(Self { contact_force_n, held_m, held_rad, ..Self::of_tables(&tables, &grasps, frames) })
    }

    fn of_tables(tables: &MotionTables, grasps: &[GraspError], frames: &Frames) -> Self {
        let mut largest = Self::default();
        for (scenario, grasp) in tables.scenarios.iter().zip(grasps) {
            for (index, (state, reference)) in scenario.states.iter().zip(&tables.reference).enumerate() {
                let believed = state.pose().isometry() * grasp.believed();
                let (tool, wanted) = (frames.tool(&believed), frames.tool(&reference.pose().isometry()));
                let distance = (tool.translation.vector - wanted.translation.vector).norm();
                largest.deviation_m = largest.deviation_m.max(distance);
                largest.deviation_rad = largest.deviation_rad.max(tool.rotation.angle_to(&wanted.rotation));
                // There is a wrench for every step but the first.
                let Some(wrench) = index.checked_sub(1).and_then(|step| scenario.wrenches.get(step)) else { continue };
                let wrench = frames.tool_wrench(&state.pose().isometry(), wrench);
                largest.force_n = largest.force_n.max(wrench.fixed_rows::<3>(0).norm());
                largest.torque_nm = largest.torque_nm.max(wrench.fixed_rows::<3>(3).norm());
            }
        }
        largest
    }

    /// Thresholds for a limit of contact forces (N), which may be infinite, and the tracking error of the tool on the
    /// path to the start and in the plan.
    pub fn guards(&self, contact_force_limit: f64, approach: Held, plan: Held) -> PhaseGuards {
        let free = |error: Held| Guards {
            force_n: LEAST_FORCE,
            torque_nm: LEAST_TORQUE,
            deviation_m: FREE_DISTANCE + error.distance + self.held_m,
            deviation_rad: FREE_ANGLE + error.angle + self.held_rad,
        };
        let planned = MARGIN * self.force_n.max(self.contact_force_n);
        let force = if contact_force_limit.is_finite() { CONTACTS * contact_force_limit } else { planned };
        let insertion = Guards {
            force_n: force.max(LEAST_FORCE),
            torque_nm: (MARGIN * self.torque_nm).max(LEAST_TORQUE),
            deviation_m: (MARGIN * self.deviation_m).max(LEAST_DISTANCE) + self.held_m,
            deviation_rad: (MARGIN * self.deviation_rad).max(LEAST_ANGLE) + self.held_rad,
        };
        PhaseGuards { approach: free(approach), dry_run: free(plan), insertion }
    }
}
