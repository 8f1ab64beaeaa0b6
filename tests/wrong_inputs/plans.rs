//! Plans whose files were cut, changed, forged or lost.

use super::Row;

#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    ("simulate scene.toml plan", &[("plan/result.json", "", "")], "plan/result.json:1"),
    ("simulate scene.toml plan", &[("plan/result.json", "", "{}")], "plan/result.json:1: not a result of this version"),
    ("simulate scene.toml plan", &[("plan/result.json", "", "[]")], "plan/result.json:1"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"status\"", "\"state\"")], "missing field `status`"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"delta_m\": 0.01", "\"delta_m\": 1e999")], "plan/result.json"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"delta_m\": 0.01", "\"delta_m\": -1")], "offset magnitude"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"delta_m\": 0.01", "\"delta_m\": 1e300")], "offset magnitude"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"delta_m\": 0.01", "\"delta_m\": null")], "plan/result.json"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"start\": \"a\"", "\"start\": \"c\"")], "there is no start `c`"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"reference.csv\"", "\"../scene.toml\"")], "which is not a file of a plan"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"reference.csv\"", "\"/etc/passwd\"")], "which is not a file of a plan"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"reference.csv\"", "\"stages/1/../reference.csv\"")], "which is not a file of a plan"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"reference.csv\"", "\"stages/99/reference.csv\"")], "belongs to the plan and cannot be read"),
    ("simulate scene.toml plan", &[("plan/reference.csv", "", "")], "plan/reference.csv: was changed since the plan was written"),
    ("simulate scene.toml plan", &[("plan/reference.csv", "", "time_s\n")], "plan/reference.csv: was changed"),
    ("simulate scene.toml plan", &[("plan/reference.csv", "\n0.3,", "\n0.3,1e300")], "plan/reference.csv: was changed"),
    ("simulate scene.toml plan", &[("plan/reference.csv", "\n0.3,", "\n0.3,5")], "plan/reference.csv: was changed"),
    ("simulate scene.toml plan", &[("plan/reference.csv", "time_s", "Time_s")], "plan/reference.csv: was changed"),
    ("simulate scene.toml plan", &[("plan/scenarios.csv", "", "x")], "plan/scenarios.csv: was changed"),
    ("simulate scene.toml plan", &[("plan/stages/1/reference.csv", "", "x")], "plan/stages/1/reference.csv: was changed"),
    ("simulate scene.toml plan", &[("plan/resolved.toml", "small", "large")], "plan/resolved.toml: was changed"),
    ("simulate scene.toml plan", &[("scene.toml", "box = [0.1, 0.08, 0.06]", "box = [0.1, 0.08, 0.05]")], "the plan was made for another scene: part `box`"),
    ("simulate scene.toml plan", &[("scene.toml", "name = \"box\"", "name = \"lid\""), ("scene.toml", "[\"box\", \"floor\"], [\"box\", \"wall\"]", "[\"lid\", \"floor\"], [\"lid\", \"wall\"]")], "another scene: part `box`"),
    ("simulate scene.toml plan", &[("scene.toml", "position = [0.051, 0.0, 0.031]", "position = [0.052, 0.0, 0.031]")], "its goal is another pose"),
    ("simulate scene.toml plan", &[("scene.toml", "position = [0.1, 0.0, 0.08]", "position = [0.1, 0.0, 0.09]")], "its start `a` is another pose"),
    ("simulate scene.toml plan", &[("scene.toml", "name = \"a\"", "name = \"one\"")], "there is no start `a`"),
    ("simulate scene.toml plan", &[("scene.toml", "[contact]", "[[environment.part]]\nname = \"lid\"\nbox = [1, 1, 1]\nposition = [0, 0, 9]\n[contact]")], "its environment has 2 parts, this one 3"),
    ("simulate scene.toml plan", &[("plan/result.json", "\"position_error_m\": ", "\"position_error_m\": null, \"was\": ")], "plan/result.json: is called done, but has a null"),
    ("export gone --to csv", &[], "gone: there is no such folder; `assembly-plan solve"),
    ("export folder --to csv", &[], "folder: no result.json in it"),
    ("export runs --to csv", &[], "runs: is the folder of a batch; name that of one of its plans, such as runs/cells/"),
    ("simulate scene.toml .", &[("plan/result.json", "", "{}")], "plan/result.json:1"),
];
