//! What `new`, `check` and `solve` say of parts that a stranger brings: small parts that are written here, as files of
//! CAD are.

use crate::support::Dir;

/// A corner of a part (mm).
type Corner = [f64; 3];
/// Corners of a face, counterclockwise as seen from outside.
type Face = [Corner; 4];

/// Corners of a rectangle at some height, counterclockwise as seen from above.
fn rectangle([x, y]: [f64; 2], height: f64) -> [Corner; 4] {
    [[-x, -y, height], [x, -y, height], [x, y, height], [-x, y, height]]
}

/// Faces between two rectangles, seen from outside.
fn sides(lower: [Corner; 4], upper: [Corner; 4]) -> Vec<Face> {
    (0..4).map(|side| [lower[side], lower[(side + 1) % 4], upper[(side + 1) % 4], upper[side]]).collect()
}

/// Faces seen from the other side.
fn reversed(faces: Vec<Face>) -> Vec<Face> {
    faces.into_iter().map(|[a, b, c, d]| [d, c, b, a]).collect()
}

fn lid(rectangle: [Corner; 4]) -> Vec<Face> {
    vec![rectangle]
}

/// A box with half its edges in the plane, between two heights.
fn block(half: [f64; 2], low: f64, high: f64) -> Vec<Face> {
    let (lower, upper) = (rectangle(half, low), rectangle(half, high));
    [sides(lower, upper), lid(upper), reversed(lid(lower))].concat()
}

/// A block of 40 x 40 mm whose upper face is at height 0, with a pocket.
fn socket(half: [f64; 2], depth: f64) -> Vec<Face> {
    let (bottom, top) = (rectangle([20.0, 20.0], -depth - 5.0), rectangle([20.0, 20.0], 0.0));
    let (rim, floor) = (rectangle(half, 0.0), rectangle(half, -depth));
    let ring = sides(top, rim);
    [sides(bottom, top), reversed(lid(bottom)), ring, reversed(sides(floor, rim)), lid(floor)].concat()
}

/// The text of an OBJ file, its corners moved or turned.
fn obj(faces: &[Face], place: impl Fn(Corner) -> Corner) -> String {
    let vertices = faces.iter().flatten().map(|corner| {
        let [x, y, z] = place(*corner);
        format!("v {x} {y} {z}\n")
    });
    let vertices: String = vertices.collect();
    let face = |index: usize| format!("f {} {} {} {}\n", 4 * index + 1, 4 * index + 2, 4 * index + 3, 4 * index + 4);
    vertices + &(0..faces.len()).map(face).collect::<String>()
}

const FILES: &str = "--body plug.obj --environment socket.obj --unit mm";

/// A folder with a plug of 10 x 10 mm that sinks into a socket, with clearance on every side (all mm), its files placed.
fn plug(depth: f64, play: f64, place: impl Fn(Corner) -> Corner) -> Dir {
    let dir = Dir::new();
    dir.write("plug.obj", obj(&block([5.0, 5.0], -depth, 8.0), &place));
    dir.write("socket.obj", obj(&socket([5.0 + play, 5.0 + play], depth), &place));
    dir
}

fn here(corner: Corner) -> Corner {
    corner
}

#[test]
fn a_flat_connector_is_a_success_only_where_it_is_engaged() {
    let dir = plug(1.8, 0.05, here);
    let run = dir.run(&format!("new s.toml {FILES}")).code(0);
    // The goal is lifted by a hundredth of the plug's height.
    let run = run.says("10.00 x 10.00 x 9.80 mm").says("40.00 x 40.00 x 6.80 mm").says("taken out along +z");
    let run = run.says("1.70 mm deep, clearance of 0.100 mm").says("offset         1.00 mm");
    let run = run.says("0.425 mm from the goal is a success: a quarter of the engagement depth of 1.70 mm");
    run.says("at most 60 N").says("next: assembly-plan check s.toml");
    assert!(dir.read("s.toml").contains("\n[limits]\n"));
    let run = dir.run("check s.toml").code(0);
    assert!(run.stdout.starts_with("s: can be planned"), "{}", run.stdout);
    run.says("guided up to 1.70 mm").keeps_silent_about("not engaged");
    let line = format!("new loose.toml {FILES} --position-tolerance 0.003 --offset 0.0005 --contact-force 20");
    dir.run(&line).code(0).says("1.70 mm from the goal the part is not engaged yet; a tolerance of 3.00 mm calls that");
    let text = dir.read("loose.toml");
    for line in ["position_tolerance = 0.003\n", "offset_magnitude = 0.0005\n", "contact_force = 20.0\n"] {
        assert!(text.contains(line), "{line}: {text}");
    }
    dir.run("check loose.toml").code(0).says("1.70 mm from the goal the part is not engaged yet");
    dir.run("check loose.toml --strict").code(1);
    let explanation: serde_json::Value = serde_json::from_str(&dir.run("check s.toml --json").code(0).stdout).unwrap();
    assert!((explanation["engagement"]["depth_m"].as_f64().unwrap() - 0.001702).abs() < 2e-5);
    assert!((explanation["position_tolerance_m"].as_f64().unwrap() - 0.000425).abs() < 5e-6);
}

#[test]
fn parts_that_are_not_assembled_are_refused() {
    for (x, z, distance) in [(60.0, 0.0, "35.1 mm apart"), (0.0, 40.0, "38.3 mm apart")] {
        let dir = plug(1.8, 0.05, here);
        dir.run(&format!("new s.toml {FILES}")).code(0);
        dir.write("plug.obj", obj(&block([5.0, 5.0], -1.8, 8.0), |corner| [corner[0] + x, corner[1], corner[2] + z]));
        dir.run(&format!("new t.toml {FILES}")).code(2).says("nothing is near the body").says(distance);
        dir.run(&format!("new t.toml {FILES}")).says("export both files in one frame, in the assembled pose");
        assert!(!dir.exists("t.toml"));
        dir.run("check s.toml").code(1).says("s: no plan can be made").says("not assembled");
        dir.run("solve s.toml --out out").code(2).says("nothing is near the body");
        assert!(!dir.exists("out"));
    }
}

#[test]
#[ignore = "slow, a fine search for a path: scripts/test and CI run it"]
fn a_goal_inside_of_the_wall_is_refused() {
    let dir = plug(8.0, 0.2, here);
    dir.run(&format!("new s.toml {FILES}")).code(0);
    let text = dir.read("s.toml");
    let (before, goal) = text.split_once("[goal]\nposition = [0.0,").unwrap();
    dir.write("moved.toml", format!("{before}[goal]\nposition = [0.003,{goal}"));
    dir.run("check moved.toml").code(1).says("penetrate there by 2.8").says("cannot be reached");
    dir.run("solve moved.toml --out out").code(2).says("penetrate there by 2.8").says("in the assembled pose");
    // A press fit of a few hundredths is a matter of the fit.
    dir.write("plug.obj", obj(&block([5.23, 5.23], -8.0, 8.0), here));
    dir.run("check s.toml").code(0).says("state the fit by `clearance`");
    // One of more is a press fit.
    dir.write("plug.obj", obj(&block([5.26, 5.26], -8.0, 8.0), here));
    dir.run("check s.toml").code(1).says("penetrate there by 0.060 mm, and no path in clearance leads away from it");
    dir.run("solve s.toml --out out").code(2).says("a press fit cannot be planned");
}

#[test]
fn a_body_that_hovers_where_nothing_guides_it_is_not_assembled() {
    let dir = plug(1.8, 0.05, |corner| corner);
    // A lid that is laid onto a plate is guided by nothing, but touches it.
    dir.write("socket.obj", obj(&block([20.0, 20.0], -8.0, -1.8), here));
    dir.run(&format!("new laid.toml {FILES}")).code(0).says("nothing guides the body");
    dir.write("plug.obj", obj(&block([5.0, 5.0], -1.8, 8.0), |[x, y, z]| [x, y, z + 1.2]));
    dir.run(&format!("new hovering.toml {FILES}"))
        .code(2)
        .says("are 1.3 mm apart, and no offset or clearance is larger than");
}

#[test]
fn a_start_within_the_tolerance_is_warned_of() {
    let dir = plug(1.8, 0.05, here);
    dir.run(&format!("new s.toml {FILES}")).code(0);
    let words = "within the tolerance of 50.00 mm, so that a body that never moves is a success";
    dir.run(&format!("new loose.toml {FILES} --position-tolerance 0.05")).code(0).says(words);
    dir.run("check loose.toml").code(0).says(words);
    dir.run("check s.toml").keeps_silent_about("never moves");
}

#[test]
fn a_goal_that_the_environment_encloses_is_refused() {
    let dir = Dir::new();
    let walls = [([0.1, 0.1, 0.02], [0.0, 0.0, 0.03]), ([0.1, 0.1, 0.02], [0.0, 0.0, -0.03])];
    let sides = [[0.03, 0.0, 0.0], [-0.03, 0.0, 0.0], [0.0, 0.03, 0.0], [0.0, -0.03, 0.0]];
    let walls = walls
        .into_iter()
        .chain(sides.map(|place| (if place[0] == 0.0 { [0.1, 0.02, 0.06] } else { [0.02, 0.1, 0.06] }, place)));
    let walls = (1..).zip(walls).map(|(number, (edges, place))| {
        format!("[[environment.part]]\nname = \"wall{number}\"\nbox = {edges:?}\nposition = {place:?}\n")
    });
    let scene = format!(
        "[body]\n[[body.part]]\nname = \"cube\"\nbox = [0.036, 0.036, 0.036]\n{}[[start]]\nname = \"1\"\nposition = [0, 0, 0.1]\n\
         orientation = [1, 0, 0, 0]\n[goal]\nposition = [0, 0, 0]\norientation = [1, 0, 0, 0]\n\
         [robustness]\noffset_magnitude = 0.001\n",
        walls.collect::<String>()
    );
    dir.write("s.toml", &scene);
    dir.run("check s.toml").code(1).says("the environment encloses the body");
    dir.run("solve s.toml --out out").code(2).says("cannot be reached without rotation");
    // With an open side, there is a path.
    dir.write("open.toml", scene.replacen("position = [0.0, 0.0, 0.03]", "position = [0.3, 0.0, 0.03]", 1));
    dir.run("check open.toml").keeps_silent_about("encloses");
}

#[test]
fn an_offset_along_a_free_axis_stays_and_is_said_to() {
    let dir = Dir::new();
    dir.write("plug.obj", obj(&block([5.0, 5.0], -8.0, 8.0), here));
    dir.write("socket.obj", obj(&socket([5.2, 15.0], 8.0), here));
    let run = dir.run(&format!("new s.toml {FILES}")).code(0);
    run.says("the body is free along y").says("offsets of up to 1.0").says("mm stay in free ones");
    dir.run("check s.toml")
        .code(0)
        .says("nothing guides the body along y")
        .keeps_silent_about("warning: nothing guides");
    dir.run(&format!("new t.toml {FILES} --position-tolerance 0.0001")).code(0).says("an offset of");
    let run = dir.run("check t.toml").code(0);
    run.says("along y stays, more than the tolerance of 0.10 mm").says("leave y out of robustness.offset_directions");
}

#[test]
fn flags_in_millimetres_are_asked_about_like_keys() {
    let dir = plug(1.8, 0.05, here);
    dir.run(&format!("new s.toml {FILES}")).code(0);
    dir.run("check s.toml --delta 2").says("an offset of 2 m is larger than the body").says("is it in metres?");
    dir.run("check s.toml --delta 0.008").says("more than half of the body's size");
    dir.run(&format!("new t.toml {FILES} --position-tolerance 3"))
        .says("a position tolerance of 3 m")
        .says("in metres?");
}

#[test]
fn the_insertion_axis_is_found() {
    for (place, out) in [
        ((|[x, y, z]: Corner| [z, x, y]) as fn(Corner) -> Corner, "+x"),
        (|[x, y, z]| [x, -z, y], "-y"),
        (|[x, y, z]| [x, -y, -z], "-z"),
    ] {
        let dir = plug(8.0, 0.2, place);
        dir.run(&format!("new s.toml {FILES}")).code(0).says(&format!("taken out along {out}"));
        dir.run("check s.toml").code(0).says("the straight motion from start to goal touches nothing");
    }
    let dir = plug(8.0, 0.2, here);
    for axis in ["z", "+z", "Z"] {
        dir.run(&format!("new s.toml {FILES} --axis {axis} --force")).code(0).says("taken out along +z");
    }
    dir.run(&format!("new t.toml {FILES} --axis x"))
        .code(2)
        .says("does not get out of the environment along +x, but along +z");
}

#[test]
fn the_start_is_outside_however_deep_the_body_sits() {
    let dir = Dir::new();
    dir.write("plug.obj", obj(&block([5.0, 5.0], -14.0, -2.0), here));
    dir.write("socket.obj", obj(&socket([5.3, 5.3], 14.0), here));
    dir.run(&format!("new s.toml {FILES}")).code(0);
    let run = dir.run("check s.toml").code(0);
    run.keeps_silent_about("penetration at the start").says("the straight motion from start to goal touches nothing");
    let explanation: serde_json::Value = serde_json::from_str(&dir.run("check s.toml --json").code(0).stdout).unwrap();
    let last = explanation["insertion"].as_array().unwrap().last().unwrap();
    assert!(
        last["clearance_m"].as_f64().unwrap() > 0.0029 && explanation["engagement"]["depth_m"].as_f64() > Some(0.0135)
    );
}

#[test]
fn a_link_of_a_model_is_chosen() {
    let dir = plug(8.0, 0.2, here);
    let geom = |half: &str, place: &str| format!("<geom type=\"box\" size=\"{half}\" pos=\"{place}\"/>");
    let body = [geom("0.005 0.005 0.008", "0 0 0"), geom("0.02 0.02 0.02", "0 0 0")]
        .map(|geom| format!("<body>{geom}</body>"))
        .concat();
    dir.write("two.xml", format!("<mujoco><worldbody>{body}</worldbody></mujoco>"));
    let files = "--body two.xml --environment socket.obj --unit mm";
    dir.run(&format!("new s.toml {files}")).code(2).says("several links").says("--link").says("#1, #2");
    dir.run(&format!("new s.toml {files} --link #1")).code(0).says("10.00 x 10.00 x 16.00 mm");
    assert!(dir.read("s.toml").contains("link = \"#1\"\n"));
    dir.run("check s.toml").code(0);
    dir.run(&format!("new t.toml {files} --link #3")).code(2).says("no link `#3`");
}

#[test]
fn many_pairs_are_named_and_pieces_are_summed_up() {
    let dir = Dir::new();
    let parts = |parent: &str, height: f64| -> String {
        let part = |number: usize| {
            format!(
                "[[{parent}.part]]\nname = \"{parent}{number}\"\nbox = [0.001, 0.02, 0.01]\nposition = [{:.4}, 0, {height}]\n",
                0.0015 * number as f64
            )
        };
        (0..13).map(part).collect()
    };
    let scene = format!(
        "[body]\n{}{}[[start]]\nname = \"1\"\nposition = [0, 0, 0.05]\norientation = [1, 0, 0, 0]\n[goal]\n\
         position = [0, 0, 0.0005]\norientation = [1, 0, 0, 0]\n[robustness]\noffset_magnitude = 0.001\n",
        parts("body", 0.005),
        parts("environment", -0.005)
    );
    dir.write("s.toml", scene);
    let run = dir.run("check s.toml").code(0);
    let run = run.says("169 pairs make planning slow").says("contact.pairs");
    assert!(run.stdout.lines().count() < 40 && !run.stdout.contains("body12"), "{}", run.stdout);
    dir.run("check s.toml --verbose").code(0).says("body12");
}

/// The outline of a D: a circle of some radius without what is beyond a chord of a quarter turn.
fn d_outline(radius: f64) -> Vec<[f64; 2]> {
    let angle = |index: u32| (45.0 + 270.0 * f64::from(index) / 51.0).to_radians();
    (0..52).map(|index| [radius * angle(index).cos(), radius * angle(index).sin()]).collect()
}

/// Faces along an outline, each made of an edge from one point to the next.
fn along(outline: &[[f64; 2]], face: impl Fn([f64; 2], [f64; 2]) -> Face) -> Vec<Face> {
    (0..outline.len()).map(|index| face(outline[index], outline[(index + 1) % outline.len()])).collect()
}

/// A prism with an outline of an even number of points, between two heights.
fn prism(outline: &[[f64; 2]], [low, high]: [f64; 2]) -> Vec<Face> {
    let at = |[x, y]: [f64; 2], height: f64| [x, y, height];
    let walls = along(outline, |from, to| [at(from, low), at(to, low), at(to, high), at(from, high)]);
    let cap = |height: f64| -> Vec<Face> {
        let point = |index: usize| at(outline[index % outline.len()], height);
        (0..outline.len()).step_by(2).map(|i| [[0.0, 0.0, height], point(i), point(i + 1), point(i + 2)]).collect()
    };
    [walls, cap(high), reversed(cap(low))].concat()
}

/// A square block of 40 x 40 mm with a hole through it, whose outline has points in the directions of the corners.
fn bored(outline: &[[f64; 2]], [low, high]: [f64; 2]) -> Vec<Face> {
    let at = |[x, y]: [f64; 2], height: f64| [x, y, height];
    let outer = |[x, y]: [f64; 2]| {
        let largest = x.abs().max(y.abs());
        [20.0 * x / largest, 20.0 * y / largest]
    };
    let face = |height: f64| {
        along(outline, |from, to| [at(from, height), at(outer(from), height), at(outer(to), height), at(to, height)])
    };
    let walls = |side: &dyn Fn([f64; 2]) -> [f64; 2]| {
        along(outline, |from, to| [at(side(from), low), at(side(to), low), at(side(to), high), at(side(from), high)])
    };
    [face(high), reversed(face(low)), walls(&outer), reversed(walls(&|point| point))].concat()
}

#[test]
fn a_shaft_with_a_flat_keeps_it_in_its_bore() {
    let dir = Dir::new();
    dir.write("plug.obj", obj(&prism(&d_outline(3.0), [-8.0, 8.0]), here));
    dir.write("socket.obj", obj(&bored(&d_outline(3.1), [-10.0, 0.0]), here));
    dir.run(&format!("new s.toml {FILES} --axis z")).code(0);
    // A tenth on the round side, and 0.1 cos(45 degrees) on the flat.
    dir.run("check s.toml").code(0).says("at the goal: meshes 0.0707 mm apart, convex parts 0.07");
    // A round pin that the bore has room for.
    let circle: Vec<[f64; 2]> = (0..48)
        .map(|index| {
            let angle = (7.5 * f64::from(index)).to_radians();
            [1.9 * angle.cos(), 1.9 * angle.sin()]
        })
        .collect();
    dir.write("plug.obj", obj(&prism(&circle, [-8.0, 8.0]), here));
    dir.run(&format!("new pin.toml {FILES} --axis z")).code(0);
    dir.run("check pin.toml").code(0).says("at the goal: meshes 0.29");
}

#[test]
fn parts_that_are_size_on_size_are_warned_of() {
    let dir = plug(8.0, 0.0, here);
    let words = "the parts have no clearance where the environment guides the body";
    dir.run(&format!("new s.toml {FILES}")).code(0).says(words);
    dir.run("check s.toml").code(0).says(words);
    dir.run("check s.toml --strict").code(1).says(words);
    // A hundredth is a fit.
    let dir = plug(8.0, 0.01, here);
    dir.run(&format!("new s.toml {FILES}")).code(0).keeps_silent_about(words);
}
