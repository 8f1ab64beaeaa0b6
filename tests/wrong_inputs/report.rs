//! Folders that have no page.

use super::Row;

#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    ("report", &[], "DIR"),
    ("report nowhere", &[], "nowhere: is not a folder"),
    ("report scene.toml", &[], "scene.toml: is not a folder"),
    ("report folder", &[], "folder: holds no result.json"),
    ("report runs", &[], "runs: no cell of the batch is finished yet"),
    ("report plan --out folder", &[], "folder: exists and is not an earlier report"),
    ("report plan --out scene.toml", &[], "scene.toml: exists and is not an earlier report"),
    ("report plan --out page.html --figures scene.toml", &[], "scene.toml: is a file"),
    ("report plan", &[("plan/reference.csv", "", "x")], "plan/reference.csv: was changed"),
    ("report plan", &[("plan/stages/1/contacts.csv", "", "x")], "plan/stages/1/contacts.csv: was changed"),
    ("report plan", &[("plan/result.json", "", "{}")], "plan/result.json:1: not a result of this version"),
    ("report plan", &[("plan/result.json", "\"format\": 1,", "")], "was written by version"),
    ("report plan", &[("plan/result.json", "\"format\": 1,", "\"format\": 9,")], "plan/result.json:2: not a result of this version of `assembly-plan solve`: format 9"),
    ("report plan", &[("plan/result.json", "\"start\": \"a\"", "\"start\": \"c\"")], "start is `c`, and resolved.toml makes it `a`"),
    ("report folder", &[(".folder.unfinished/lock", "", "")], "folder: holds an unfinished plan"),
    ("report folder", &[(".folder.unfinished/tolerance.json", "", "")], "folder: holds unfinished tolerances"),
    ("report folder", &[("folder/tolerance.json", "", "{}")], "folder/tolerance.json: is no record of tolerances"),
    ("report folder", &[("folder/success.csv", "", "motion\nplan\n")], "folder/success.csv:2"),
    ("report folder", &[("folder/success.csv", "", "")], "folder/success.csv: has no rows"),
];
