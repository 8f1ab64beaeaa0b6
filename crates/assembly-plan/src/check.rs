//! `check`: explains a scene and finds mistakes, without solving it.

use planner::check::{
    ClearPath, Explanation, MeshReport, PairReport, PosePenetration, RoundSurface, explain, pair_reports,
};
use planner::{Problem, axis_name, warnings};
use task::Pose;

use crate::arguments::CheckArguments;
use crate::console::{print_json, say, tell};
use crate::exit::{CommandError, Exit};

/// Relative difference of radii that are alike.
const ALIKE: f64 = 1e-3;

/// Pieces of one part from which on they are only summed up.
const FEW: usize = 6;
/// Starts, round surfaces and shapes that are listed.
const LISTED: usize = 6;

/// Checks a scene and prints the explanation.
pub fn run(arguments: &CheckArguments) -> Result<Exit, CommandError> {
    let problem = Problem::load(&arguments.task.scene, &arguments.task.choices())?;
    let tau = arguments.tau.unwrap_or(problem.homotopy().tau);
    let (is_refused, warnings) = match arguments.pose {
        Some(pose) => {
            let warnings = warnings::of_problem(&problem);
            warnings.iter().for_each(|warning| tell!("warning: {warning}"));
            let reports = pair_reports(&problem, &pose, tau)?;
            if arguments.json {
                print_json(&reports)?
            } else {
                print_pairs(&reports, tau)
            }
            (false, warnings)
        }
        None => {
            let explanation = explain(&problem, tau)?;
            match arguments.json {
                true => print_json(&explanation)?,
                false => print_explanation(&problem, &explanation, arguments.verbose),
            }
            (explanation.refusal.is_some(), explanation.warnings)
        }
    };
    Ok(if is_refused || arguments.strict && !warnings.is_empty() { Exit::NoPlan } else { Exit::Done })
}

fn print_pairs(reports: &[PairReport], tau: f64) {
    say!("{:<20} {:<20} {:>12} {:>16}", "body", "environment", "exact (mm)", "smoothed (mm)");
    for report in reports {
        say!(
            "{:<20} {:<20} {:>12.4} {:>16.4}",
            report.body,
            report.environment,
            1e3 * report.exact_distance_m,
            1e3 * report.smoothed_distance_m
        );
    }
    say!("smoothed with tau = {tau}");
}

fn print_explanation(problem: &Problem, explanation: &Explanation, is_verbose: bool) {
    print_verdict(explanation);
    print_sizes(problem, explanation);
    if is_verbose {
        print_parts(explanation);
    }
    print_meshes(explanation, is_verbose);
    print_insertion(explanation);
    explanation.penetrations.chunk_by(|one, other| one.pose == other.pose).for_each(print_penetrations);
    print_success(problem, explanation);
    print_size(problem, explanation);
    if !explanation.chosen.is_empty() {
        say!("defaults chosen for this scene: {}", explanation.chosen.join(", "));
    }
}

/// Whether a plan can be made, and warnings.
fn print_verdict(explanation: &Explanation) {
    let title = &explanation.title;
    match (&explanation.refusal, explanation.warnings.len()) {
        (Some(reason), _) => say!("{title}: no plan can be made: {reason}"),
        (None, 0) => say!("{title}: can be planned, all checks pass"),
        (None, 1) => say!("{title}: can be planned, with 1 warning"),
        (None, count) => say!("{title}: can be planned, with {count} warnings"),
    }
    explanation.warnings.iter().for_each(|warning| tell!("warning: {warning}"));
}

/// How large everything is and where it is.
fn print_sizes(problem: &Problem, explanation: &Explanation) {
    let (scene, task) = (problem.scene(), problem.task());
    let edges = |[x, y, z]: [f64; 3]| format!("{:.2} x {:.2} x {:.2} mm", 1e3 * x, 1e3 * y, 1e3 * z);
    let position = |pose: &Pose| format!("{:.2}, {:.2}, {:.2} mm", 1e3 * pose[0], 1e3 * pose[1], 1e3 * pose[2]);
    say!(
        "\nbody: {}, {}, mass {} kg",
        edges(explanation.body_edges_m),
        parts(explanation.body.len()),
        rounded(scene.inertia.mean_mass())
    );
    say!("environment: {}, {}", edges(explanation.environment_edges_m), parts(explanation.environment.len()));
    say!("pairs: {} may touch{}", explanation.pairs, left_out(explanation));
    let names: Vec<&str> = scene.starts.iter().map(|start| start.name.as_str()).take(LISTED).collect();
    let more = if scene.starts.len() > LISTED { ", ..." } else { "" };
    let path = task.start.error(&task.goal);
    say!(
        "start \"{}\" of {} ({}{more}): at {}, {:.2} mm and {:.3} rad from the goal",
        explanation.start,
        scene.starts.len(),
        names.join(", "),
        position(&task.start),
        1e3 * path.position,
        path.orientation
    );
    say!("goal: at {}", position(&task.goal));
    say!("offset: {:.2} mm, planned in {} scenarios", 1e3 * explanation.delta_m, explanation.size.scenarios);
    match &scene.position_robot {
        Some(robot) => say!("robot: {robot}"),
        None => say!(
            "stiffness: {} N/m and {} Nm/rad",
            rounded(task.impedance.translational_stiffness),
            rounded(task.impedance.rotational_stiffness)
        ),
    }
    let named = task.limits.named().into_iter().filter(|(_, _, limit)| limit.is_finite());
    let limits: Vec<String> = named.map(|(name, unit, limit)| format!("{name} {limit} {unit}")).collect();
    say!("limits: {}", if limits.is_empty() { "none".to_owned() } else { limits.join(", ") });
}

fn parts(count: usize) -> String {
    if count == 1 { "1 convex part".to_owned() } else { format!("{count} convex parts") }
}

/// A number with four digits at most.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

fn print_parts(explanation: &Explanation) {
    for (parent, parts) in [("body", &explanation.body), ("environment", &explanation.environment)] {
        say!("\n{parent:<24} {:>10} {:>12} {:>12} {:>7} {:>8}", "longest", "thinnest", "volume", "facets", "corners");
        for part in parts {
            say!(
                "  {:<22} {:7.2} mm {:9.3} mm {:8.2} cm3 {:>7} {:>8}",
                part.name,
                1e3 * part.size_m,
                1e3 * part.thickness_m,
                1e6 * part.volume_m3,
                part.facets,
                part.corners
            );
        }
    }
}

/// Meshes and links, the latter in one line each unless all is asked for, and the tightest round fit.
fn print_meshes(explanation: &Explanation, is_verbose: bool) {
    for meshes in explanation.meshes.chunk_by(|one, other| one.name == other.name) {
        match meshes {
            [mesh] if mesh.shape.is_none() => print_mesh(mesh, is_verbose),
            shapes if is_verbose || shapes.len() <= FEW => print_link(shapes),
            [first, ..] => {
                say!("\nlink of `{}`: {}, {} shapes (--verbose lists them)", first.name, first.file, meshes.len());
            }
            [] => {}
        }
    }
    if let Some(goal) = explanation.gaps.first() {
        let gap =
            |given: f64| if given == 0.0 { "in contact".to_owned() } else { format!("{:.4} mm apart", 1e3 * given) };
        say!("\nat the goal: meshes {}, convex parts {:.4} mm", gap(goal.given_m), 1e3 * goal.parts_m);
        for place in &explanation.gaps[1..] {
            say!(
                "{:.2} mm from it: meshes {}, convex parts {:.4} mm",
                1e3 * place.from_goal_m,
                gap(place.given_m),
                1e3 * place.parts_m
            );
        }
    }
    if let Some(fit) = explanation.fit {
        let [radius, gap, lost, mesh_lost] =
            [fit.hole_radius_m, fit.gap_m, fit.lost_m, fit.mesh_lost_m].map(|m| 1e3 * m);
        if warnings::is_size_on_size(fit.gap_m) {
            say!("\ntightest round fit: hole of radius {radius:.3} mm, no gap");
        } else if gap < 0.0 {
            say!("\ntightest round fit: hole of radius {radius:.3} mm, a part that is {:.4} mm larger", -gap);
        } else {
            let share = 100.0 * lost / gap;
            say!(
                "\ntightest round fit: hole of radius {radius:.3} mm, gap {gap:.4} mm, of which facets take {lost:.4} mm \
                 ({share:.1} %) and flat sides of the mesh up to {mesh_lost:.4} mm more"
            );
        }
    }
}

fn print_success(problem: &Problem, explanation: &Explanation) {
    let success = problem.success();
    say!(
        "\nsuccess: to end within {:.3} mm and {} rad of the goal, with exact shapes that penetrate by at most {:.3} mm",
        1e3 * success.position,
        success.orientation,
        1e3 * explanation.allowed_penetration_m
    );
    say!("--robust also tolerates edge radii of up to {:.3} mm", 1e3 * problem.edge_radius());
}

fn print_size(problem: &Problem, explanation: &Explanation) {
    let size = explanation.size;
    say!(
        "problem: {} steps of {} s, {} scenarios, {} variables, {} constraints; {} to {} homotopy steps; about \
         {:.0} s on an idle machine and {:.0} MB for the first plan",
        size.steps,
        size.time_step_s,
        size.scenarios,
        size.variables,
        size.constraints,
        problem.homotopy().iterations,
        problem.homotopy().most_iterations(),
        size.seconds.max(1.0),
        size.megabytes
    );
}

/// The deepest of the penetrations at a pose.
fn print_penetrations(penetrations: &[PosePenetration]) {
    let deepest = penetrations.iter().min_by(|one, other| one.distance_m.total_cmp(&other.distance_m));
    let Some(PosePenetration { pose, pair, distance_m }) = deepest else { return };
    let others = match penetrations.len() - 1 {
        0 => String::new(),
        count => format!(", less in {count} more (--json lists them)"),
    };
    say!("penetration at the {pose}: {pair} by {:.3} mm{others}", -1e3 * distance_m);
}

fn left_out(explanation: &Explanation) -> String {
    match explanation.culled_pairs.len() {
        0 => String::new(),
        count => format!("; {count} never come near each other and are left out (--json lists them)"),
    }
}

fn print_mesh(mesh: &MeshReport, is_verbose: bool) {
    let deviation = &mesh.deviation;
    say!("\nmesh of `{}`: {} ({} triangles, {:.3} cm3)", mesh.name, mesh.file, mesh.triangles, 1e6 * mesh.volume_m3);
    mesh.repairs.iter().for_each(|repair| say!("  repaired: {repair}"));
    print_round_surfaces(&mesh.round_surfaces, if is_verbose { usize::MAX } else { LISTED });
    let dropped = match mesh.pieces_dropped {
        0 => String::new(),
        count => format!(" ({count} too thin, dropped)"),
    };
    say!(
        "  {} convex parts{dropped}, up to {:.4} mm from the mesh, the mesh up to {:.4} mm from them, {:.4} mm uncovered",
        mesh.pieces,
        1e3 * deviation.parts_to_mesh_m,
        1e3 * deviation.mesh_to_parts_m,
        1e3 * deviation.uncovered_m
    );
    say!(
        "  volume missing {:.2} mm3, outside {:.2} mm3 (+- {:.2} mm3)",
        1e9 * deviation.missing_m3,
        1e9 * deviation.outside_m3,
        1e9 * deviation.volume_error_m3
    );
}

/// Round surfaces, those that are alike in one line.
fn print_round_surfaces(surfaces: &[RoundSurface], most: usize) {
    let mut groups: Vec<(&RoundSurface, usize)> = Vec::new();
    for surface in surfaces {
        match groups.iter_mut().find(|(other, _)| is_alike(surface, other)) {
            Some((_, count)) => *count += 1,
            None => groups.push((surface, 1)),
        }
    }
    if groups.len() > most {
        say!("  {} kinds of round surfaces (--verbose lists all)", groups.len());
    }
    for (surface, count) in groups.into_iter().take(most) {
        let times = if count == 1 { String::new() } else { format!("{count} times ") };
        let [first, second] = surface.radii_m.map(|radius| 1e3 * radius);
        say!(
            "  {times}{} {}, radius {:.3} to {:.3} mm, {:.0} degrees: {} facets of a full turn, error {:.4} mm",
            surface.kind,
            if surface.is_convex { "outside" } else { "inside" },
            first.min(second),
            first.max(second),
            surface.angle_rad.to_degrees(),
            surface.facets_per_turn,
            1e3 * surface.error_m
        );
    }
}

/// Whether two round surfaces differ by no more than rounding in a mesh explains.
fn is_alike(one: &RoundSurface, other: &RoundSurface) -> bool {
    let sorted = |[first, second]: [f64; 2]| [first.min(second), first.max(second)];
    let mut radii = sorted(one.radii_m).into_iter().zip(sorted(other.radii_m));
    (one.kind, one.is_convex, one.facets_per_turn) == (other.kind, other.is_convex, other.facets_per_turn)
        && (one.angle_rad - other.angle_rad).abs() < 1f64.to_radians()
        && radii.all(|(radius, other)| (radius - other).abs() <= ALIKE * other)
}

/// The shapes of a link, and the convex parts that stand for them.
fn print_link(shapes: &[MeshReport]) {
    let MeshReport { name, file, .. } = &shapes[0];
    say!("\nlink of `{name}`: {file}");
    let is_alone = shapes.iter().map(|shape| shape.pieces).sum::<usize>() == 1;
    let mut first = 1;
    for shape in shapes {
        let last = first + shape.pieces - 1;
        let parts = match shape.pieces {
            0 => "(inside of others)".to_owned(),
            1 if is_alone => name.clone(),
            1 => format!("{name}.{first}"),
            _ => format!("{name}.{first} to {last}"),
        };
        let distance = 1e3 * shape.deviation.parts_to_mesh_m;
        say!("  {parts:<22} {}, up to {distance:.4} mm from it", shape.shape.as_deref().unwrap_or_default());
        shape.repairs.iter().for_each(|repair| say!("    repaired: {repair}"));
        first += shape.pieces;
    }
}

fn print_insertion(explanation: &Explanation) {
    let length =
        |length: Option<f64>| length.map_or_else(|| "free".to_owned(), |length| format!("{:.3}", 1e3 * length));
    say!("\nclearance in mm, from the goal straight back to the start (free: nothing within reach)");
    say!("  {:>10} {:>10} {:>18} {:>18} {:>18}", "from goal", "clearance", "-x, +x", "-y, +y", "-z, +z");
    for clearance in &explanation.insertion {
        let axes = clearance.axes.iter().map(|axis| format!("{}, {}", length(axis.backward_m), length(axis.forward_m)));
        let axes: Vec<String> = axes.map(|axis| format!("{axis:>18}")).collect();
        say!(
            "  {:>10.2} {:>10.3} {}",
            1e3 * clearance.distance_from_goal_m,
            1e3 * clearance.clearance_m,
            axes.join(" ")
        );
    }
    print_engagement(explanation);
    match explanation.path {
        ClearPath::Straight => say!("the straight motion from start to goal touches nothing"),
        ClearPath::OnGrid { step_m } => {
            say!("the goal can be reached in clearance, in steps of {:.2} mm", 1e3 * step_m)
        }
        ClearPath::None { .. } | ClearPath::Enclosed { .. } => {}
    }
}

/// What guides the body, and what the offsets are beside that.
fn print_engagement(explanation: &Explanation) {
    let engagement = &explanation.engagement;
    if let Some(depth) = engagement.depth_m {
        say!("engagement: the body is guided up to {:.2} mm from its goal", 1e3 * depth);
    }
    if !engagement.free.is_empty() {
        let names: Vec<String> = engagement.free.iter().map(axis_name).collect();
        let axes = names.join(" and ");
        say!("nothing guides the body along {axes} at its goal: offsets along {axes} stay");
    }
    if let Some(farthest) = explanation.farthest_rest_m {
        say!("clearance lets the body rest up to {:.2} mm from its goal", 1e3 * farthest);
    }
    let offset = explanation.delta_m;
    if let Some(clearance) = engagement.clearance_m.filter(|clearance| *clearance < 2.0 * offset) {
        say!(
            "offsets of {:.2} mm to either side, clearance of {:.3} mm from side to side where it is tightest: contact at \
             chamfers and edges must lead the body in",
            1e3 * offset,
            1e3 * clearance
        );
    }
}
