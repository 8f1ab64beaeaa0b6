//! A starter scene from two files: direction and depth of the insertion, and the start.

use std::path::{Path, PathBuf};

use diagnosis::check::refusal;
use mesh::{Penetration, Separation};
use plan::{Choices, PlannerError, Problem};
use scene::{KnownMeshes, Scene, Source};
use scene_templates::{Axis, FilePair, PartPair, StarterPoses, StarterValues, starter_scene};

/// Height (m) of the goal above the place in the files, where parts touch; at most this share of the body's height.
const LIFT: f64 = 2e-4;
const LARGEST_LIFT: f64 = 0.01;
/// Nothing is as near to the body at its start, in offsets.
const ROOM: f64 = 3.0;
/// Steps in which a start is looked for, in heights of the body.
const STEP: f64 = 0.1;
/// Distance (m) beyond the place where both boxes are apart.
const BEYOND: f64 = 1e-3;

/// Parts that penetrate by less (m) than this do so by rounding, and by more than this share of their shortest edge since
/// they are not assembled; in between they are press or snap fits.
const ROUNDING: f64 = 1e-5;
const ELASTIC: f64 = 0.1;
/// Parts that penetrate by this share of the deepest penetration on the way out when assembled are pressed in.
const PRESSED: f64 = 0.8;
/// Places on the way out at which penetrations are looked at.
const WAY_STEPS: u32 = 25;

/// A starter scene, and how the parts of its files fit.
#[derive(Debug)]
pub struct Starter {
    /// Text of the scene.
    pub text: String,
    /// The problem that it describes.
    pub problem: Problem,
    /// How the two files fit; `None` for the example without files.
    pub fit: Option<StarterFit>,
}

/// How the body of one file leaves the environment of another one.
#[derive(Debug)]
pub struct StarterFit {
    /// Edges (m) of the boxes around body and environment.
    pub edges_m: [[f64; 3]; 2],
    /// Direction in which the body is taken out.
    pub out: Axis,
    /// Other directions in which it could be, too.
    pub others: Vec<Axis>,
    /// Distance of the start from the goal (m).
    pub distance_m: f64,
}

/// Makes the scene that is written to `file`: with two files, whose body is taken out along a given axis or one that is
/// found, or the example.
///
/// # Errors
/// When a file cannot be read, both are the same part, the parts are not assembled, or the body gets out along no axis of the
/// files.
pub fn starter(
    file: &Path,
    files: Option<&FilePair>,
    axis: Option<Axis>,
    values: &StarterValues,
) -> Result<Starter, PlannerError> {
    let Some(files) = files else {
        let text = starter_scene(file, None, values)?;
        let problem = read(file, &text, &KnownMeshes::default())?;
        return Ok(Starter { text, problem, fit: None });
    };
    let standing = in_standing_folder(file);
    let parts = files.read()?;
    if parts.body.triangles() == parts.environment.triangles() {
        let body = files.body.display();
        let problem = format!("it is the same part in the same place as the body, {body}: name the other part");
        return Err(PlannerError::file(&files.environment, problem));
    }
    let separation = Separation::new(parts.body.triangles(), parts.environment.triangles());
    let (poses, fit) = fit(&files.body, &parts, &separation, axis, values)?;
    let text = starter_scene(&standing, Some((&parts, &poses)), values)?;
    let problem = read(&standing, &text, &parts.meshes())?;
    match refusal(&problem) {
        Some(reason) => {
            let tight = tight_fit(&parts, &separation, fit.out, fit.distance_m);
            Err(PlannerError::file(&files.body, tight.unwrap_or(reason)))
        }
        None => Ok(Starter { text: starter_scene(file, Some((&parts, &poses)), values)?, problem, fit: Some(fit) }),
    }
}

/// Refuses the text of a generated scene of which no plan can be made.
///
/// # Errors
/// With the reason.
pub fn require_plannable(file: &Path, text: &str) -> Result<(), PlannerError> {
    let problem = read(&in_standing_folder(file), text, &KnownMeshes::default())?;
    match refusal(&problem) {
        Some(reason) => {
            Err(PlannerError::Choice { name: "peg", problem: format!("no plan can be made of it: {reason}") })
        }
        None => Ok(()),
    }
}

/// The file, or one of its name in the nearest folder above that exists: from a folder that is still to be made, no other
/// file is found.
fn in_standing_folder(file: &Path) -> PathBuf {
    let is_folder = |folder: &&Path| folder.as_os_str().is_empty() || folder.is_dir();
    let folder = file.ancestors().skip(1).find(is_folder).unwrap_or(Path::new(""));
    folder.join(file.file_name().unwrap_or_default())
}

fn read(file: &Path, text: &str, known: &KnownMeshes) -> Result<Problem, PlannerError> {
    Problem::choose(Scene::parse_knowing(Source { file, text }, known)?, file, &Choices::default())
}

/// Direction, depth and start of the body, found by moving its surface past that of the environment.
fn fit(
    file: &Path,
    parts: &PartPair,
    separation: &Separation,
    axis: Option<Axis>,
    values: &StarterValues,
) -> Result<(StarterPoses, StarterFit), PlannerError> {
    let [body, environment] = [&parts.body, &parts.environment].map(|part| part.bounds());
    let height = |axis: Axis| body.edges()[axis.index];
    let apart = |axis: Axis| body.distance_apart(&environment, axis).max(height(axis)) + BEYOND;
    let free = Axis::ALL.map(|axis| separation.is_free(&axis.times(1.0), apart(axis)));
    let is_free = |axis: &Axis| Axis::ALL.iter().zip(free).any(|(other, is_free)| other == axis && is_free);
    // A body that is put in ends at a stop: it can be moved no farther.
    let ways: Vec<Axis> = Axis::ALL.into_iter().filter(is_free).collect();
    let ends: Vec<Axis> = ways.iter().copied().filter(|axis| !is_free(&axis.opposite())).collect();
    let out = axis.or_else(|| ends.first().or(ways.first()).copied()).ok_or_else(|| {
        let tight = Axis::ALL.iter().find_map(|axis| tight_fit(parts, separation, *axis, apart(*axis)));
        if let Some(tight) = tight {
            return PlannerError::file(file, tight);
        }
        let problem = format!(
            "the body gets out of the environment along no axis of the files, whichever way: export both files in the assembled \
             pose, with an axis along the insertion; where a motion of several parts leads out, name the axis of the last \
             (--axis). {}",
            in_the_way(separation, &Axis::ALL, &apart)
        );
        PlannerError::file(file, problem)
    })?;
    if !ways.contains(&out)
        && let Some(tight) = tight_fit(parts, separation, out, apart(out))
    {
        return Err(PlannerError::file(file, tight));
    }
    if !ways.is_empty() && !ways.contains(&out) {
        let names: Vec<String> = ways.iter().map(Axis::to_string).collect();
        let problem = format!(
            "the body does not get out of the environment along {out}, but along {}: name such a direction (--axis), or none. {}",
            names.join(", "),
            in_the_way(separation, &[out], &apart)
        );
        return Err(PlannerError::file(file, problem));
    }
    if ways.is_empty() && separation.penetration(&[0.0; 3]).depth <= ROUNDING {
        let problem = format!(
            "the body gets out of the environment along no axis of the files. {}",
            in_the_way(separation, &[out], &apart)
        );
        return Err(PlannerError::file(file, problem));
    }
    // Where the environment also blocks the path out, the body is lifted to the middle between both.
    let lift = LIFT.min(LARGEST_LIFT * height(out));
    let room_above = separation.travel(&out.times(1.0), 2.0 * lift);
    let lift = room_above.map_or(lift, |room| lift.min(0.5 * room));
    let room = ROOM * values.offset_magnitude();
    let has_room = |distance: &f64| separation.at(&out.times(*distance)) >= room;
    let steps = (0..).map(|step| height(out) * (1.0 + STEP * f64::from(step)));
    let farthest = apart(out) + room;
    let distance = steps.take_while(|distance| *distance < farthest).find(has_room).unwrap_or(farthest);
    let poses = StarterPoses { starts: vec![out.times(distance)], goal: out.times(lift) };
    let others = ways.into_iter().filter(|way| *way != out).collect();
    let edges_m = [body.edges(), environment.edges()];
    Ok((poses, StarterFit { edges_m, out, others, distance_m: distance - lift }))
}

/// Why parts that penetrate on the way out along an axis, as given, cannot be planned, and where: a press fit does so when
/// assembled, a snap fit on its way there. `None` for parts that do not, or that are not assembled.
fn tight_fit(parts: &PartPair, separation: &Separation, out: Axis, longest: f64) -> Option<String> {
    let is_fit = |depth: f64| ROUNDING < depth && depth <= ELASTIC * smallest_edge(parts);
    let assembled = separation.penetration(&[0.0; 3]);
    let (travelled, deepest) = deepest_on_path(separation, out, longest)?;
    let is_press = assembled.depth >= PRESSED * deepest.depth;
    let Penetration { depth, place } = if is_press { assembled } else { deepest };
    is_fit(deepest.depth).then(|| {
        let found =
            format!("body and environment, as given, penetrate by {:.3} mm at ({}) mm", 1e3 * depth, millimetres(place));
        if is_press {
            format!(
                "a press fit: {found} when assembled. Parts need clearance; where CAD draws parts as large as their holes, \
                 `clearance` of a mesh states the fit"
            )
        } else {
            format!(
                "a snap fit: {found} {:.3} mm from the assembled pose, on the way out along {out}. Parts are rigid here: \
                 export them without hooks, or name another direction (--axis)",
                1e3 * travelled
            )
        }
    })
}

/// Where parts penetrate most on the path out along an axis, after which distance (m).
fn deepest_on_path(separation: &Separation, out: Axis, longest: f64) -> Option<(f64, Penetration)> {
    let steps = (0..=WAY_STEPS).map(|step| longest * f64::from(step) / f64::from(WAY_STEPS));
    let path = steps.map(|travelled| (travelled, separation.penetration(&out.times(travelled))));
    path.max_by(|one, other| one.1.depth.total_cmp(&other.1.depth))
}

/// What keeps the body in the environment, along that of some axes where this is the least.
fn in_the_way(separation: &Separation, axes: &[Axis], longest: &dyn Fn(Axis) -> f64) -> String {
    let paths = axes.iter().filter_map(|&axis| Some((axis, deepest_on_path(separation, axis, longest(axis))?)));
    let least = paths.min_by(|one, other| one.1.1.depth.total_cmp(&other.1.1.depth));
    least.map_or_else(String::new, |(axis, (travelled, Penetration { depth, place }))| {
        format!(
            "Least is in the way along {axis}: body and environment penetrate by {:.3} mm at ({}) mm, {:.3} mm from the assembled \
             pose. Hooks of a snap fit bend, and a bayonet is rotated; here parts are rigid and are not rotated out: export them \
             without what is in the way",
            1e3 * depth,
            millimetres(place),
            1e3 * travelled
        )
    })
}

fn millimetres(place: [f64; 3]) -> String {
    place.map(|coordinate| format!("{:.2}", 1e3 * coordinate)).join(", ")
}

/// Shortest edge (m) of the boxes around both parts.
fn smallest_edge(parts: &PartPair) -> f64 {
    let edges = [&parts.body, &parts.environment].map(|part| part.bounds().edges());
    edges.iter().flatten().copied().fold(f64::INFINITY, f64::min)
}
