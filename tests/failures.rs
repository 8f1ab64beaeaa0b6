//! What `solve` says and writes of plans that are not done.

use crate::support::{Dir, list, number};

/// A start above a shelf that is wider than the floor.
const SHELF: [(&str, &str); 2] = [
    ("position = [0.1, 0.0, 0.08]", "position = [0.1, 0.0, 0.16]"),
    (
        "[[start]]",
        "[[environment.part]]\nname = \"shelf\"\nbox = [0.6, 0.6, 0.02]\nposition = [0.0, 0.0, 0.08]\n\n[[start]]",
    ),
];

#[test]
fn a_shelf_in_the_way_is_printed_and_written() {
    let dir = Dir::new();
    dir.add_variant("shelf.toml", &SHELF);
    let run = dir.run("solve shelf.toml --out out").code(1);
    run.says("held by box/shelf").says("which lies towards -z").says("hint: [[start]]");
    let result = dir.result("out");
    let explanation = &result["explanation"];
    assert_eq!((&result["done"], &result["converged"]), (&false.into(), &true.into()));
    for (stuck, scenario) in list(explanation, "scenarios").iter().zip(list(&result, "scenarios")) {
        assert_eq!(stuck["offset_m"], scenario["offset_m"]);
        assert_eq!(number(stuck, "end.position_error_m"), number(scenario, "position_error_m"));
    }
    let advice = list(explanation, "advice");
    assert!(advice.iter().any(|advice| advice.as_str().unwrap().contains("box/shelf")), "{advice:?}");
}

#[test]
fn a_plan_that_is_done_explains_nothing() {
    let dir = Dir::new();
    let run = dir.run("solve corner.toml --out out").code(0);
    assert!(!run.has("hint: "));
    assert!(dir.result("out").get("explanation").is_none());
}

#[test]
fn what_a_plan_loses_that_is_not_robust_is_printed_and_written() {
    let dir = Dir::new();
    let run = dir.run("solve corner.toml --robust --stall-limit 0 --friction 0.2 --position-tolerance 1e-4 --out out");
    run.code(1).says("most is lost at friction 0.2, where 0.0 % succeed").says("with the offset");
    let loss = &dir.result("out")["robust"]["loss"];
    assert_eq!((number(loss, "rate"), number(loss, "worst.successes")), (0.0, 0.0));
    assert!(number(loss, "end.position_error_m") > 1e-4);
    assert!(dir.result("out").get("explanation").is_none());
}
