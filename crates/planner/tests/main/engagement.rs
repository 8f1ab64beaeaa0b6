//! How deep parts engage, and what is chosen for that.

use std::path::Path;

use nalgebra::Vector3;
use plan::clearance::Clearance;
use planner::warnings::of_problem;
use planner::{Choices, Engagement, Problem};
use scene::{Scene, Source};
use task::Pose;

/// A body of 20 x 20 x 10 mm whose goal has its lower face at some height (m), and walls (name, box, position), with offsets
/// of 1 mm in three directions.
fn text(bottom: f64, turn: f64, walls: &[(&str, [f64; 3], [f64; 3])]) -> String {
    let (cosine, sine) = ((0.5 * turn).cos(), (0.5 * turn).sin());
    let orientation = format!("orientation = [{cosine:?}, 0, 0, {sine:?}]");
    let mut text = "[body]\n[[body.part]]\nname = \"plug\"\nbox = [0.02, 0.02, 0.01]\n".to_owned();
    for (name, edges, [x, y, z]) in walls {
        let place = [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos(), *z];
        text +=
            &format!("[[environment.part]]\nname = \"{name}\"\nbox = {edges:?}\nposition = {place:?}\n{orientation}\n");
    }
    let height = bottom + 0.005;
    text + &format!(
        "[[start]]\nname = \"1\"\nposition = [0, 0, {:?}]\n{orientation}\n[goal]\nposition = [0, 0, {height:?}]\n{orientation}\n\
         [robustness]\noffset_magnitude = 0.001\noffset_directions = [[1, 0, 0], [0, 1, 0], [0, -1, 0]]\n",
        height + 0.02
    )
}

/// Walls around the body with some play (m) on every side, and their upper faces at height 0.
fn socket(play: f64) -> Vec<(&'static str, [f64; 3], [f64; 3])> {
    [
        rail(play),
        vec![
            ("front", [0.1, 0.01, 0.02], [0.0, -0.015 - play, -0.01]),
            ("back", [0.1, 0.01, 0.02], [0.0, 0.015 + play, -0.01]),
        ],
    ]
    .concat()
}

/// Walls at both sides along x.
fn rail(play: f64) -> Vec<(&'static str, [f64; 3], [f64; 3])> {
    vec![
        ("left", [0.01, 0.2, 0.02], [-0.015 - play, 0.0, -0.01]),
        ("right", [0.01, 0.2, 0.02], [0.015 + play, 0.0, -0.01]),
    ]
}

fn problem(text: &str) -> Problem {
    problem_with(text, &Choices::default())
}

fn problem_with(text: &str, choices: &Choices) -> Problem {
    let file = Path::new("plug.toml");
    let scene = Scene::parse(Source { file, text }).unwrap_or_else(|error| panic!("{error}"));
    Problem::choose(scene, file, choices).unwrap()
}

fn is_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value}, not {expected}");
}

#[test]
fn a_plug_is_engaged_as_deep_as_its_socket_holds_it() {
    let problem = problem(&text(-0.0018, 0.0, &socket(5e-5)));
    let Engagement { depth_m, free, clearance_m, rest_m, .. } = problem.engagement();
    is_near(depth_m.unwrap(), 0.0018, 2e-5);
    is_near(clearance_m.unwrap(), 1e-4, 5e-6);
    assert!(free.is_empty(), "{free:?}");
    is_near(rest_m.unwrap(), 5e-5 * 2f64.sqrt(), 1e-5);
    is_near(problem.success().position, 0.00045, 5e-6);
    let chosen = problem.chosen();
    assert!(chosen.iter().any(|chosen| chosen.contains("a quarter of the engagement depth of 1.80 mm")), "{chosen:?}");
    assert!(of_problem(&problem).is_empty(), "{:?}", of_problem(&problem));
}

/// Walls of another height than 0 (m).
fn raised<'name>(walls: &[(&'name str, [f64; 3], [f64; 3])], height: f64) -> Vec<(&'name str, [f64; 3], [f64; 3])> {
    walls.iter().map(|(name, edges, [x, y, z])| (*name, *edges, [*x, *y, z + height])).collect()
}

#[test]
fn a_body_that_is_off_enters_where_clearance_is_less_than_twice_its_offset() {
    let entrance = |walls: &[(&str, [f64; 3], [f64; 3])]| problem(&text(-0.0018, 0.0, walls)).engagement().entrance;
    let found = entrance(&socket(5e-5)).unwrap();
    is_near(found.distance_m, 0.0018, 2e-5);
    is_near(found.clearance_m, 1e-4, 5e-6);
    // Offsets of 1 mm do not reach the walls of a recess that is 3 mm wider, but those of one that is 1 mm wider.
    let names = |walls: Vec<(&'static str, [f64; 3], [f64; 3])>, names: [&'static str; 4]| {
        walls.into_iter().zip(names).map(|((_, edges, place), name)| (name, edges, place)).collect::<Vec<_>>()
    };
    let recess = |play: f64| names(raised(&socket(play), 0.003), ["a", "b", "c", "d"]);
    let found = entrance(&[socket(5e-5), recess(1.5e-3)].concat()).unwrap();
    is_near(found.distance_m, 0.0018, 2e-5);
    let found = entrance(&[socket(5e-5), recess(5e-4)].concat()).unwrap();
    is_near(found.distance_m, 0.0048, 2e-5);
    is_near(found.clearance_m, 1e-3, 5e-5);
    assert_eq!(entrance(&socket(1.1e-3)), None, "every offset fits");
}

#[test]
fn a_tolerance_that_calls_an_unassembled_part_a_success_is_warned_of() {
    let stated = Choices { position_tolerance: Some(0.003), ..Choices::default() };
    let problem = problem_with(&text(-0.0018, 0.0, &socket(5e-5)), &stated);
    assert_eq!(problem.success().position, 0.003, "whoever states a tolerance gets it");
    let warnings = of_problem(&problem).join("\n");
    assert!(
        warnings
            .contains("1.80 mm from the goal the part is not engaged yet; a tolerance of 3.00 mm calls that a success"),
        "{warnings}"
    );
}

#[test]
fn play_that_lets_the_body_rest_farther_than_its_depth_allows_raises_no_tolerance() {
    // Pushed into a corner of its recess, the body rests 0.7 mm from its goal; on the rim, 0.5 mm.
    let problem = problem(&text(-0.0005, 0.0, &socket(5e-4)));
    is_near(problem.success().position, 0.25 * 0.0005, 5e-6);
    // A deeper one may rest where play lets it.
    let problem = problem_with(&text(-0.0075, 0.0, &socket(1e-3)), &Choices::default());
    is_near(problem.success().position, 0.25 * 0.0075, 3e-5);
}

#[test]
fn a_start_close_to_the_goal_lowers_the_tolerance() {
    let near = text(-0.0075, 0.0, &socket(1e-4)).replace("position = [0, 0, 0.0175]", "position = [0, 0, -0.0005]");
    is_near(problem(&near).success().position, 0.25 * 0.002, 1e-9);
}

#[test]
fn a_rail_guides_across_itself_and_offsets_along_it_stay() {
    for turn in [0.0, 0.4, 1.1] {
        let problem = problem(&text(-0.008, turn, &rail(2e-4)));
        let engagement = problem.engagement();
        is_near(engagement.depth_m.unwrap(), 0.008, 5e-5);
        is_near(engagement.clearance_m.unwrap(), 4e-4, 2e-5);
        let [free] = engagement.free[..] else { panic!("{engagement:?}") };
        let along = free[0] * -turn.sin() + free[1] * turn.cos();
        assert!(along.abs() > 0.999, "turned by {turn}: free along {free:?}");
        // A tenth of the size, and offsets along the rail as far as evaluations let them be.
        is_near(problem.success().position, 0.002f64.hypot(1.05e-3), 2e-5);
        assert!(problem.chosen().iter().any(|chosen| chosen.contains("stay in free ones")), "{:?}", problem.chosen());
    }
    let stated = Choices { position_tolerance: Some(1e-4), ..Choices::default() };
    let warnings = of_problem(&problem_with(&text(-0.008, 0.0, &rail(2e-4)), &stated)).join("\n");
    assert!(
        warnings.contains("nothing guides the body along y at its goal: an offset of 1.00 mm along y stays, more than"),
        "{warnings}"
    );
}

#[test]
fn a_corner_holds_the_body_along_a_diagonal_and_leaves_no_direction_free() {
    let walls = [("left", [0.01, 0.2, 0.02], [-0.015, 0.0, 0.0]), ("back", [0.1, 0.01, 0.02], [0.0, 0.015, 0.0])];
    let engagement = problem(&text(-0.005, 0.0, &walls)).engagement().clone();
    is_near(engagement.depth_m.unwrap(), 0.015, 5e-5);
    assert_eq!(
        (engagement.free.len(), engagement.rest_m),
        (0, None),
        "along the other diagonal it is stopped on one side"
    );
}

#[test]
fn a_path_that_leads_through_a_wall_is_no_insertion_axis() {
    let slanted = text(-0.0018, 0.0, &socket(5e-5)).replace("position = [0, 0, 0.0232", "position = [0.01, 0, 0.0232");
    let engagement = problem(&slanted).engagement().clone();
    assert_eq!(engagement.out, [0.0, 0.0, 1.0]);
    is_near(engagement.depth_m.unwrap(), 0.0018, 2e-5);
}

#[test]
fn overlaps_that_are_allowed_follow_the_clearance() {
    is_near(problem(&text(-0.0018, 0.0, &socket(4e-4))).allowed_penetration(), 2e-4, 1e-9);
    is_near(problem(&text(-0.0018, 0.0, &socket(2e-5))).allowed_penetration(), 5e-5, 1e-12);
}

#[test]
fn travels_end_where_a_pair_first_penetrates() {
    let socket = problem(&text(-0.005, 0.0, &socket(3e-4)));
    // A lid above the body on one side, turned.
    let roof = text(-0.005, 0.3, &[("lid", [0.02, 0.004, 0.004], [0.003, 0.001, 0.009])]);
    let mut touched = Vec::new();
    for problem in [socket, self::problem(&roof)] {
        let task = problem.task();
        let mut clearance = Clearance::new(task);
        let (goal, longest) = (task.goal.position(), 0.02);
        let directions: Vec<Vector3<f64>> = (0..40)
            .map(|index| {
                let (turn, height) = (2.4 * f64::from(index), (f64::from(index) - 19.5) / 20.0);
                Vector3::new(turn.cos(), turn.sin(), 0.0) * (1.0 - height * height).sqrt() + Vector3::z() * height
            })
            .collect();
        let touching = clearance.at(&goal).min(0.0);
        let travels = clearance.travels(&goal, &directions, longest);
        for (direction, travel) in directions.iter().zip(&travels) {
            let at = |distance: f64| {
                task.clearance(&Pose::new((goal + direction * distance).into(), task.goal.quaternion()))
            };
            let floor = touching - 1.01e-4 * longest;
            let free = travel.unwrap_or(longest);
            let deepest = |from: f64, to: f64| {
                let steps = (0..=400).map(|step| at(from + (to - from) * f64::from(step) / 400.0));
                steps.fold(f64::INFINITY, f64::min)
            };
            assert!(deepest(0.0, free) >= floor, "{direction}: deeper before {free}");
            if let Some(travel) = travel {
                assert!((at(*travel) - touching).abs() <= 1.5e-4 * longest, "{direction}: {} at {travel}", at(*travel));
                assert!(
                    deepest(*travel, travel + 1e-3) < touching - 0.9e-4 * longest,
                    "{direction}: free after {travel}"
                );
            }
        }
        touched.push(travels.iter().flatten().count());
    }
    assert_eq!(touched[0], 40, "there are walls all around");
    assert!((1..20).contains(&touched[1]), "the lid is on one side: {touched:?}");
}
