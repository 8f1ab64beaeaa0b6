//! `report` as a user runs it.

use serde_json::Value;

use crate::support::{Dir, list, number};

/// The data of a page.
pub fn data(dir: &Dir, page: &str) -> Value {
    let page = dir.read(page);
    let begin = page.split_once("id=\"data\">").unwrap().1;
    serde_json::from_str(begin.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn the_page_of_a_plan_holds_its_motions() {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan --report").code(0).says("page written to plan/report.html");
    let page = data(&dir, "plan/report.html");
    assert_eq!(page["kind"], "plan");
    let (motions, result) = (list(&page, "motions"), dir.result("plan"));
    let sources: Vec<&str> = motions.iter().map(|motion| motion["source"].as_str().unwrap()).collect();
    let stages = list(&result, "stages").len();
    assert_eq!(sources, [vec!["plan"], vec!["rollouts"; 3], vec!["iteration"; stages]].concat());
    // Distances are known from the start on, forces in each step.
    for scenario in motions.iter().flat_map(|motion| list(motion, "scenarios")) {
        let (knots, steps) = (list(scenario, "poses").len() / 7, list(scenario, "forces").len());
        assert_eq!((list(scenario, "distances").len(), steps), (knots, knots - 1));
        let largest = list(scenario, "forces").iter().map(|force| force.as_f64().unwrap()).fold(0.0, f64::max);
        assert!(number(scenario, "max_force") >= largest - 2e-3, "the mean over 10 ms is not below that over a step");
    }
    // Homotopy steps would be most of the page.
    for iteration in &motions[4..] {
        assert!(list(iteration, "scenarios").iter().all(|scenario| list(scenario, "wrenches").is_empty()));
    }

    // The plan is that of its tables.
    let reference = dir.table("plan/reference.csv");
    assert_eq!(list(&motions[0], "reference").len(), 7 * reference.rows.len());
    let last = &reference.rows[reference.rows.len() - 1];
    for (index, column) in (1..8).enumerate() {
        let expected: f64 = last[column].parse().unwrap();
        let shown = list(&motions[0], "reference")[7 * (reference.rows.len() - 1) + index].as_f64().unwrap();
        assert!((shown - expected).abs() < 1e-5, "column {column}: {shown}, not {expected}");
    }
    for (shown, scenario) in list(&motions[0], "scenarios").iter().zip(list(&result, "scenarios")) {
        assert!((number(shown, "errors.0") - number(scenario, "position_error_m")).abs() < 1e-6);
        for axis in 0..3 {
            let offset = number(scenario, &format!("offset_m.{axis}"));
            assert!((number(shown, &format!("offset.{axis}")) - offset).abs() < 2e-6);
        }
    }

    // Arrows have a force and a direction.
    let contacts = list(&list(&motions[0], "scenarios")[0], "contacts");
    let arrows: Vec<&Value> = contacts.iter().filter(|step| !step.as_array().unwrap().is_empty()).collect();
    assert!(!arrows.is_empty(), "the part is pushed into the corner");
    for arrow in arrows {
        let direction: f64 = (5..8).map(|index| number(arrow, &index.to_string()).powi(2)).sum();
        assert!((direction - 1.0).abs() < 0.01 && number(arrow, "1") > 0.0, "{arrow}");
    }
}

#[test]
fn a_page_is_replaced_and_nothing_else_is() {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan").code(0);
    dir.run("report plan").code(0);
    dir.run("report plan").code(0);
    dir.run("solve corner.toml --out plan").code(0).says("plan/report.html shows an older plan");
    dir.write("mine.html", "<p>mine</p>");
    dir.run("report plan --out mine.html").code(2).says("mine.html: exists and is not an earlier report");
    assert_eq!(dir.read("mine.html"), "<p>mine</p>");
    dir.write("plan/report.html", "<p>mine</p>");
    dir.run("solve corner.toml --out plan --report").code(2).says("is not an earlier report");
    dir.run("simulate corner.toml plan --report").code(2).says("is not an earlier report");
    assert!(!dir.exists("plan/success.csv"), "refused before anything is computed");
}

#[test]
fn a_batch_leads_to_the_pages_of_its_cells() {
    let dir = Dir::new();
    dir.run("batch expand corner.toml --deltas 0.01,0.02 --out runs").code(0);
    dir.run("report runs").code(2).says("no cell of the batch is finished yet");
    dir.run("batch run runs --index 0").code(0);
    dir.run("report runs").code(0).says("with that of 1 plan;");
    let cells = data(&dir, "runs/report.html")["cells"].clone();
    assert_eq!((cells[0]["state"].as_str(), cells[1]["state"].as_str()), (Some("planned"), Some("to do")));
    assert_eq!(cells[1]["page"], Value::Null);
    let page = format!("runs/{}", cells[0]["page"].as_str().unwrap());
    assert_eq!(number(&data(&dir, &page), "result.delta_m"), 0.01);
    dir.run("batch corner.toml --deltas 0.01,0.02 --out runs --report").code(0).says("with those of 2 plans");
}

#[test]
fn a_simulation_has_a_page_and_is_part_of_its_plans() {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan").code(0);
    dir.run("simulate corner.toml plan --random 4 --friction 0,0.1 --out rates --report").code(0);
    let page = data(&dir, "rates/report.html");
    assert_eq!((page["kind"].as_str(), list(&page, "groups").len()), (Some("simulation"), 4));
    let record: Value = serde_json::from_str(&dir.read("rates/simulation.json")).unwrap();
    assert_eq!(page["record"], record);
    assert_eq!((record["scene"].as_str(), record["seed"].as_u64()), (Some("corner"), Some(1)));
    assert_eq!(record["plans"].as_array().unwrap(), &["plan"]);
    dir.write("rates/simulation.json", "mine");
    dir.run("simulate corner.toml plan --out rates").code(2).says("simulation.json: is no record of a simulation");
    dir.run("simulate corner.toml plan --report").code(0);
    assert_eq!(list(&data(&dir, "plan/report.html")["simulation"], "groups").len(), 2);
}

#[test]
fn figures_are_drawn() {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan").code(0);
    dir.run("simulate corner.toml plan --random 4 --magnitude 0.01,0.02").code(0);
    dir.run("report plan --figures figures").code(0).says("success.svg");
    for name in ["keyframes-x", "keyframes-y", "keyframes-z", "forces", "convergence", "success"] {
        let figure = dir.read(format!("figures/{name}.svg"));
        let root = figure.lines().nth(1).unwrap();
        assert!(root.starts_with("<svg ") && figure.trim_end().ends_with("</svg>"), "{name}");
        assert!(!figure.contains("NaN") && !figure.contains("inf"), "{name}");
    }
    // Body and reference are cut in every panel.
    let keyframes = dir.read("figures/keyframes-y.svg");
    assert!(keyframes.matches("stroke-dasharray").count() >= 6, "{keyframes}");
    dir.write("figures/forces.svg", "mine");
    dir.run("report plan --figures figures").code(2).says("figures/forces.svg: exists and is not an earlier figure");
}

#[test]
fn animations_last_as_long_as_the_plan() {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan").code(0);
    dir.run("report plan --animation moving.svg").code(0).says("animation written to moving.svg");
    let page = data(&dir, "plan/report.html");
    let shown = list(&page, "motions").iter().find(|motion| motion["source"] == "rollouts").unwrap();
    let duration = number(shown, "time_step") * (list(shown, "reference").len() / 7 - 1) as f64;
    let svg = dir.read("moving.svg");
    assert!(
        svg.contains(&format!("animation:picture {:.2}s step-end infinite", duration + 1.0)),
        "the end rests for a second"
    );
    let pictures = svg.matches("<g class=\"picture").count();
    assert!((20..=62).contains(&pictures), "{pictures} pictures in {duration} s");
    assert!(!svg.contains("NaN") && !svg.replace("infinite", "").contains("inf"));
    // All scenarios but the solid one are outlines, and the reference is dashed.
    let scenarios = list(shown, "scenarios").len();
    assert!(scenarios > 1);
    assert_eq!(svg.matches("class=\"line\"").count(), pictures * (scenarios - 1));
    assert_eq!(svg.matches("class=\"line dashed\"").count(), pictures);
    // An earlier animation is replaced, and a scenario can be alone.
    dir.run("report plan --animation moving.svg --scenario 2").code(0);
    assert_eq!(dir.read("moving.svg").matches("class=\"line\"").count(), 0);
    dir.run("report plan --animation moving.GIF --scenario 1").code(0);
    dir.run("report plan --animation moving.GIF").code(0);
    let size = std::fs::metadata(dir.path("moving.GIF")).unwrap().len();
    assert!((1_000..2_000_000).contains(&size), "{size} bytes");
    for (arguments, problem) in [
        ("--animation moving.mp4", "moving.mp4: is neither .svg nor .gif"),
        ("--animation moving", "moving: is neither .svg nor .gif"),
        ("--animation mine.svg", "mine.svg: exists and is not an earlier animation"),
        ("--animation mine.gif", "mine.gif: exists and is not an earlier animation"),
        ("--animation other.svg --scenario 0", "must be from 1 to"),
        ("--animation other.svg --scenario 99", "must be from 1 to"),
        ("--scenario 1", "--animation"),
    ] {
        dir.write("mine.svg", "<svg/>");
        dir.write("mine.gif", "GIF89a");
        dir.run(&format!("report plan --out other.html {arguments}")).code(2).says(problem);
        assert!(!dir.exists("other.html") && !dir.exists("other.svg"), "{arguments}: nothing is written");
    }
    assert_eq!((dir.read("mine.svg").as_str(), dir.read("mine.gif").as_str()), ("<svg/>", "GIF89a"));
}

#[test]
fn plans_of_the_same_parts_are_shown_beside_each_other() {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan").code(0);
    dir.run("solve corner.toml --delta 0.005 --out small").code(0);
    dir.run("report plan --beside small --out both.html").code(0);
    let page = data(&dir, "both.html");
    assert_eq!((page["kind"].as_str(), &page["names"]), (Some("beside"), &serde_json::json!(["plan", "small"])));
    for (index, folder) in ["plan", "small"].into_iter().enumerate() {
        let shown = &list(&page, "plans")[index];
        assert_eq!(number(shown, "result.delta_m"), number(&dir.result(folder), "delta_m"));
    }
    let scene = dir.read("corner.toml");
    dir.write("other.toml", scene.replace("box = [0.1, 0.08, 0.06]", "box = [0.1, 0.07, 0.06]"));
    dir.run("solve other.toml --out other");
    dir.run("report plan --beside other --out refused.html")
        .code(2)
        .says("other: has other parts than plan: box of its body differs");
    dir.run("simulate corner.toml plan --random 4 --out rates").code(0);
    dir.run("report plan --beside rates --out refused.html").code(2).says("rates: is no plan");
    dir.run("report rates --beside plan --out refused.html").code(2).says("rates: is no plan");
    assert!(!dir.exists("refused.html"), "nothing is written");
}

#[test]
fn tolerances_are_on_the_page_of_their_plan_or_on_their_own() {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan").code(0);
    let line = "tolerance corner.toml --plan plan --quantity offset --map offset,friction --rows 0,0.3 --cases 40 \
                --target-rate 0.8 --friction 0 --position-tolerance 0.006";
    dir.run(line).code(0).says("`assembly-plan report plan` shows it");
    dir.run(&format!("{line} --out alone")).code(0);
    let record = dir.json("plan/tolerance.json");
    dir.run("report plan").code(0);
    assert_eq!(data(&dir, "plan/report.html")["tolerated"], record);
    dir.run("report alone").code(0);
    let alone = data(&dir, "alone/report.html");
    assert_eq!((alone["kind"].as_str(), &alone["record"]), (Some("tolerance"), &record));
    dir.run("report alone --figures figures").code(2).says("the map of tolerances is tolerance.svg there");
    dir.run("report alone --executed log.csv")
        .code(2)
        .says("alone: is not the folder of a plan that log.csv could have executed");

    dir.run("solve corner.toml --delta 0.01 --out plan").code(0);
    dir.run("report plan").code(0);
    let other = data(&dir, "plan/report.html");
    assert!(other["tolerated"].is_null(), "they are of the plan that was there");
    let warning = "tolerance.json is of another plan and is not shown; measure again with `assembly-plan tolerance`";
    assert!(list(&other, "notes").iter().any(|note| note == warning), "{}", other["notes"]);

    let text = dir.read("alone/tolerance.json");
    dir.write("alone/tolerance.json", &text[..text.len() / 2]);
    dir.run("report alone").code(2).says("alone/tolerance.json: is no record of tolerances: ").says("measure again");
    dir.write("alone/tolerance.json", text.replacen("\"format\": 1", "\"format\": 99", 1));
    dir.run("report alone").code(2).says("format 99 is that of a newer version");
}
