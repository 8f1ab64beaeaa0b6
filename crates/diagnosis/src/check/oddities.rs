//! Likely mistakes in a scene, and the key to change.

use plan::pose_clearance::PoseClearance;
use plan::{Millimetres, Problem};
use task::{AssemblyTask, Penetration};

use crate::check::clear_path::ClearPath;
use crate::check::delay::delay;
use crate::check::explanation::Explanation;
use crate::check::pairs;
use crate::check::sliding::sliding;
use crate::warnings::is_size_on_size;

/// Share of the gap of a round fit that facets may take.
const FACETS_SHARE: f64 = scene::SHARE;
/// Share of it that the mesh itself may take.
const COARSE_SHARE: f64 = 0.1;
/// Distance from the mesh that is worth a word: in errors of its facets, and in sizes of the part.
const DEVIATION: f64 = 3.0;
const DEVIATION_IN_SIZES: f64 = 3e-4;

/// A step this many times as long as the clearance gets a warning.
const LONG_STEP: f64 = 2.0;

/// Everything odd, in the words of the scene.
pub fn oddities(problem: &Problem, explanation: &Explanation) -> Vec<String> {
    let task = problem.task();
    let own = [
        facets(explanation),
        deviation(explanation),
        rest(problem, explanation.farthest_rest_m),
        path(explanation),
        first_smoothing(task, problem.homotopy().tau),
        last_smoothing(problem, explanation),
        step(task, &explanation.insertion),
        delay(problem),
        sliding(problem),
        pairs::warning(problem.scene()),
    ];
    own.into_iter().flatten().collect()
}

fn facets(explanation: &Explanation) -> Option<String> {
    let fit = explanation.fit?;
    if is_size_on_size(fit.gap_m) {
        // Where the part is guided, a warning says so.
        let is_said = explanation.engagement.clearance_m.is_some_and(is_size_on_size);
        let words = "a round part is as large as its hole: state the fit by `clearance` of one of the meshes";
        return (!is_said).then(|| words.to_owned());
    }
    if fit.gap_m < 0.0 {
        return Some(format!(
            "a round part is {:.3} mm larger than its hole: state the fit by `clearance` of one of the meshes",
            -1e3 * fit.gap_m
        ));
    }
    if fit.mesh_lost_m > COARSE_SHARE * fit.gap_m {
        return Some(format!(
            "the mesh of a round hole has flat sides that take up to {:.3} mm of a gap of {:.3} mm: export it with smaller \
             chord errors",
            1e3 * fit.mesh_lost_m,
            1e3 * fit.gap_m
        ));
    }
    (fit.lost_m > FACETS_SHARE * fit.gap_m).then(|| {
        format!(
            "facets take {:.3} mm of a gap of {:.3} mm between a round part and its hole: raise `facets` of the meshes",
            1e3 * fit.lost_m,
            1e3 * fit.gap_m
        )
    })
}

/// A mesh that its parts stand for badly.
fn deviation(explanation: &Explanation) -> Option<String> {
    explanation.meshes.iter().find_map(|mesh| {
        let errors = mesh.round_surfaces.iter().map(|surface| surface.error_m + surface.mesh_error_m);
        let expected = errors.fold(0.0, f64::max) + mesh.growth_m + mesh.clearance_m;
        let found = mesh.deviation.parts_to_mesh_m;
        (found > DEVIATION * expected + DEVIATION_IN_SIZES * mesh.volume_m3.cbrt()).then(|| {
            format!(
                "convex parts of `{}` are up to {:.3} mm away from the mesh, more than its facets explain: check it \
                 against the CAD program",
                mesh.name,
                1e3 * found
            )
        })
    })
}

/// The clearance at the goal exceeds the tolerance.
pub fn rest(problem: &Problem, farthest_rest: Option<f64>) -> Option<String> {
    let tolerance = problem.success().position;
    let farthest = farthest_rest.filter(|&farthest| farthest > tolerance)?;
    Some(format!(
        "the clearance at the goal lets the body rest {:.2} mm from it, more than the tolerance of {:.2} mm, so any plan may \
         miss it: raise --position-tolerance",
        1e3 * farthest,
        1e3 * tolerance
    ))
}

fn path(explanation: &Explanation) -> Option<String> {
    let ClearPath::None { step_m, nearest_m } = explanation.path else { return None };
    Some(format!(
        "no path in clearance was found from start to goal, in steps of {:.2} mm and without rotation: backwards from the \
         goal, the search ended {:.1} mm from the start; check the goal, the fit and the insertion axis",
        1e3 * step_m,
        1e3 * nearest_m
    ))
}

/// The first smoothing is smaller than the offset: the plan may then end in a wrong optimum. It often does not, and
/// success is not monotone in the first smoothing, so that this is no more than a hint.
pub fn first_smoothing(task: &AssemblyTask, tau: f64) -> Option<String> {
    let norm = |offset: &[f64; 3]| offset.iter().map(|component| component * component).sum::<f64>().sqrt();
    let largest = task.offsets().iter().map(norm).fold(0.0, f64::max);
    let rows = task.pairs.iter().map(|pair| pair.shapes.row_count()).min()?;
    let reach = tau * rows as f64;
    (reach < 1.5 * largest).then(|| {
        format!(
            "the smoothing gap bound of the first homotopy step is {} mm, the offset is {} mm: if plans miss the goal, raise \
             homotopy.tau",
            Millimetres(reach),
            Millimetres(largest)
        )
    })
}

/// The last smoothing must be small compared with the clearance.
fn last_smoothing(problem: &Problem, explanation: &Explanation) -> Option<String> {
    let last = problem.homotopy().schedule().last()?;
    let clearance = explanation.insertion.first()?.clearance_m;
    let gap = problem.task().smoothing_gap(last.tau);
    (clearance > 0.0 && Penetration::excess(problem.task(), gap) > 1.0).then(|| {
        format!(
            "the smoothing gap bound of the last homotopy step is {:.3} mm, the clearance at the goal is {:.3} mm: raise \
             homotopy.further_iterations",
            1e3 * gap,
            1e3 * clearance
        )
    })
}

/// Distances are linearised in each step: it must not be long compared with the clearance.
pub fn step(task: &AssemblyTask, insertion: &[PoseClearance]) -> Option<String> {
    let path = insertion.last()?.distance_from_goal_m;
    let per_step = path / task.horizon.steps as f64;
    let narrowest = insertion.iter().filter_map(PoseClearance::narrowest).fold(f64::INFINITY, f64::min);
    (narrowest > 0.0 && narrowest.is_finite() && per_step > LONG_STEP * narrowest).then(|| {
        format!(
            "the body moves {:.2} mm per step on average, the clearance is {:.2} mm: use more, shorter steps in [horizon]",
            1e3 * per_step,
            1e3 * narrowest
        )
    })
}
