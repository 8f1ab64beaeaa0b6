//! README and `docs/` say what the program does: examples run, and what is named exists.

#[path = "documentation/markdown.rs"]
mod markdown;
#[path = "documentation/result_keys.rs"]
mod result_keys;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use markdown::{Page, spans};
use planner::batch::Matrix;
use planner::{Choices, Problem};

fn project(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap().join(name)
}

/// The pages in some folders.
fn pages_in(folders: &[&str]) -> Vec<Page> {
    let entries = folders.iter().flat_map(|folder| fs::read_dir(project(folder)).unwrap());
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "md"));
    files.sort();
    files.into_iter().map(Page::read).collect()
}

/// The manual: README, CONTRIBUTING and all pages in `docs/`, except for the notebook of experiments.
fn pages() -> Vec<Page> {
    let mut pages = vec![page("README.md"), page("CONTRIBUTING.md")];
    pages.extend(pages_in(&["docs", "docs/guide", "docs/reference", "docs/concepts"]));
    pages
}

/// The notebook of experiments.
fn notebook() -> Vec<Page> {
    pages_in(&["docs/experiments", "docs/experiments/reproduction"])
}

fn page(name: &str) -> Page {
    Page::read(project(name))
}

/// A folder in which examples run: scenes, configurations and meshes, files that examples name, and a plan in `out/corner`.
fn sandbox() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in ["scenes", "configs", "examples", "examples/arms"] {
        fs::create_dir(folder.path().join(name)).unwrap();
        let entries = fs::read_dir(project(name)).unwrap().map(|entry| entry.unwrap().path());
        for file in entries.filter(|file| file.is_file()) {
            fs::copy(&file, folder.path().join(name).join(file.file_name().unwrap())).unwrap();
        }
    }
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("my.toml", &page("docs/reference/scene.md").blocks_of("toml")[0]);
    write("my_homotopy.toml", &page("docs/reference/homotopy.md").blocks_of("toml")[0]);
    write("housing.stl", TETRAHEDRON);
    write("socket.stl", TETRAHEDRON);
    fs::create_dir(folder.path().join("SC_Plug")).unwrap();
    write("SC_Plug/model.sdf", PLUG);
    let run = run(folder.path(), &["solve", "scenes/corner.toml", "--out", "out/corner"]);
    assert!(run.status.success(), "{}", text(&run.stderr));
    folder
}

const PLUG: &str = "\
<sdf version='1.9'><model name='SC Plug'><link name='sc_plug_link'><collision name='housing'>
<geometry><box><size>0.014 0.007 0.007</size></box></geometry>
</collision></link></model></sdf>
";

const TETRAHEDRON: &str = "\
solid housing
facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 30 0\nvertex 30 0 0\nendloop\nendfacet
facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 30 0 0\nvertex 0 0 30\nendloop\nendfacet
facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 30\nvertex 0 30 0\nendloop\nendfacet
facet normal 1 1 1\nouter loop\nvertex 30 0 0\nvertex 0 30 0\nvertex 0 0 30\nendloop\nendfacet
endsolid housing
";

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assembly-plan"));
    // A job array would choose cells.
    command.env_remove("SLURM_ARRAY_TASK_ID").env_remove("HQ_TASK_ID");
    command.current_dir(folder).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Command lines of the program in the `sh` blocks of a page, without its name, comments and redirections.
fn commands(page: &Page) -> Vec<Vec<String>> {
    let blocks = page.blocks_of("sh");
    let lines = blocks.iter().flat_map(|block| block.lines());
    let lines = lines.map(|line| line.split(" #").next().unwrap().split(" > ").next().unwrap().trim());
    let arguments = lines.filter_map(|line| {
        let rest = line.strip_prefix("assembly-plan ").or(line.strip_prefix("scripts/plan "))?;
        Some(rest.split_whitespace().map(str::to_owned).collect())
    });
    arguments.collect()
}

#[test]
fn commands_are_accepted_and_cheap_ones_succeed() {
    let sandbox = sandbox();
    let mut count = 0;
    // Those of the README run as they are, below.
    for page in pages().into_iter().filter(|page| page.name() != "README.md") {
        for command in commands(&page) {
            let shown = format!("{}: assembly-plan {}", page.name(), command.join(" "));
            let mut arguments: Vec<&str> = command.iter().map(String::as_str).collect();
            let is_cheap =
                ["corner", "my.toml", "shaft.toml", "generate", "schema"].iter().any(|word| shown.contains(word));
            // A plan is exported only where it passes its rollouts, which that of the solver does not.
            let needs_more = ["--robust", "--now", "export"].iter().any(|word| arguments.contains(word));
            if !is_cheap || needs_more {
                // Help is shown only if everything before it is accepted.
                let end = arguments.iter().position(|argument| *argument == "--").unwrap_or(arguments.len());
                arguments.insert(end, "--help");
            }
            let run = run(sandbox.path(), &arguments);
            assert!(run.status.success(), "{shown}: {}", text(&run.stderr));
            count += 1;
        }
    }
    assert!(count > 10, "{count} commands found");
}

#[test]
#[ignore = "slow, whole solves, one of them robust: scripts/test and CI run it"]
fn the_commands_of_the_readme_run() {
    let sandbox = sandbox();
    let commands = commands(&page("README.md"));
    assert!(commands.iter().any(|command| command.contains(&"--robust".to_owned())));
    for command in commands {
        let arguments: Vec<&str> = command.iter().map(String::as_str).collect();
        let run = run(sandbox.path(), &arguments);
        let shown = arguments.join(" ");
        assert!(run.status.success(), "assembly-plan {shown}: {}{}", text(&run.stdout), text(&run.stderr));
    }
    assert!(sandbox.path().join("out/cap/report.html").exists());
}

#[test]
fn toml_blocks_are_valid() {
    let sandbox = sandbox();
    let corner = sandbox.path().join("scenes/corner.toml");
    let base: toml::Table = toml::from_str(&fs::read_to_string(&corner).unwrap()).unwrap();
    let mut count = 0;
    for page in pages() {
        for block in page.blocks_of("toml") {
            let table: toml::Table = toml::from_str(&block).unwrap_or_else(|error| panic!("{}: {error}", page.name()));
            // The file of one's own arm is not there; its keys are.
            if let Some(robot) = table.get("robot").and_then(toml::Value::as_table) {
                let is_key = |name: &str| scene::keys().iter().any(|key| (key.table, key.name) == ("robot", name));
                assert!(robot.keys().all(|name| is_key(name)), "{}: {block}", page.name());
                continue;
            }
            if table.contains_key("dependencies") || table.contains_key("rule") {
                continue;
            }
            let file = sandbox.path().join("block.toml");
            fs::write(&file, &block).unwrap();
            let checked = if table.contains_key("scenes") {
                Matrix::load(&file).and_then(|matrix| planner::batch::expand(&matrix)).map(|_| ())
            } else if table.contains_key("homotopy") || table.contains_key("ipopt") {
                let choices = Choices { homotopy: Some(file), ..Choices::default() };
                Problem::load(&corner, &choices).map(|_| ())
            } else {
                if !table.contains_key("goal") {
                    fs::write(&file, toml::to_string(&merged(&base, &table)).unwrap()).unwrap();
                }
                Problem::load(&file, &Choices::default()).map(|_| ())
            };
            checked.unwrap_or_else(|error| panic!("{}: {error}\n{block}", page.name()));
            count += 1;
        }
    }
    assert!(count >= 6, "{count} blocks found");
}

/// A scene with the tables of a fragment: parts are added, other tables are replaced.
fn merged(scene: &toml::Table, fragment: &toml::Table) -> toml::Table {
    let mut scene = scene.clone();
    scene.remove("homotopy");
    for (key, value) in fragment {
        match value.get("part").and_then(toml::Value::as_array) {
            Some(parts) if scene.contains_key(key) => {
                scene[key]["part"].as_array_mut().unwrap().extend(parts.iter().cloned());
            }
            _ => _ = scene.insert(key.clone(), value.clone()),
        }
    }
    scene
}

#[test]
fn links_lead_somewhere() {
    for page in pages().into_iter().chain(notebook()) {
        for link in page.links() {
            if link.starts_with("http") {
                continue;
            }
            let (path, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = if path.is_empty() { page.file.clone() } else { page.folder().join(path) };
            assert!(target.exists(), "{}: {link}", page.name());
            if !anchor.is_empty() {
                let anchors = Page::read(target).anchors();
                assert!(anchors.iter().any(|known| known == anchor), "{}: {link}, not of {anchors:?}", page.name());
            }
        }
    }
}

#[test]
fn every_page_is_in_the_index() {
    let index = page("docs/README.md").links();
    for page in pages_in(&["docs/guide", "docs/reference", "docs/concepts", "docs/experiments"]) {
        let link = page.file.strip_prefix(project("docs")).unwrap().to_str().unwrap();
        assert!(index.iter().any(|known| known == link), "{link}");
    }
}

#[test]
fn files_that_are_named_exist() {
    let folders = ["scenes/", "configs/", "examples/", "scripts/", "docs/", "crates/", "tests/", ".ci/"];
    for page in pages() {
        let spans = page.code_spans();
        let blocks = page.blocks_of("sh").concat();
        let words = spans.iter().flat_map(|span| span.split_whitespace()).chain(blocks.split_whitespace());
        for word in words {
            let word = word.trim_end_matches(['.', ',', ':', ')']);
            let is_path = folders.iter().any(|folder| word.starts_with(folder));
            assert!(!is_path || word.ends_with('/') || project(word).exists(), "{}: {word}", page.name());
        }
    }
}

/// Long flags of the program, but for hidden ones.
fn flags_of_program() -> BTreeSet<String> {
    let commands: [&[&str]; 22] = [
        &[],
        &["solve"],
        &["check"],
        &["new"],
        &["generate", "random"],
        &["generate", "round"],
        &["generate", "rectangular"],
        &["generate", "keyed"],
        &["schema"],
        &["completions"],
        &["man"],
        &["simulate"],
        &["tolerance"],
        &["report"],
        &["export"],
        &["calibrate"],
        &["batch"],
        &["batch", "expand"],
        &["batch", "run"],
        &["batch", "status"],
        &["batch", "collect"],
        &["batch", "submit"],
    ];
    let help = |command: &&[&str]| text(&run(&project(""), &[command, &["--help"][..]].concat()).stdout);
    flags(&commands.iter().map(help).collect::<String>())
}

/// All long flags in a text.
fn flags(text: &str) -> BTreeSet<String> {
    let is_flag = |letter: char| letter.is_ascii_lowercase() || letter == '-';
    let words = text.split(|letter: char| !is_flag(letter));
    // Lines in drawings are none.
    let flags = words.map(|word| word.trim_end_matches('-')).filter(|word| word.starts_with("--") && word.len() > 3);
    flags.map(str::to_owned).collect()
}

#[test]
fn flags_that_are_named_exist_and_those_of_the_program_are_named() {
    /// Flags of cargo, sbatch and hq.
    const FOREIGN: [&str; 10] = [
        "--no-deps",
        "--open",
        "--bench",
        "--features",
        "--path",
        "--example",
        "--partition",
        "--time",
        "--array",
        "--wrap",
    ];
    let program = flags_of_program();
    let mut scripts = String::new();
    let players = ["shared", "topics", "ur_rtde", "franka", "ros2", "ros2_control"]
        .map(|name| format!("crates/export/players/{name}"));
    let folders = ["scripts", "scripts/python/lab/commands", "scripts/python/lab/validation", "crates/python/examples"]
        .map(str::to_owned);
    for folder in folders.iter().chain(&players) {
        let files = fs::read_dir(project(folder)).unwrap().map(|entry| entry.unwrap().path());
        files.filter_map(|file| fs::read_to_string(file).ok()).for_each(|text| scripts += &text);
    }
    let scripts = flags(&scripts);
    let mut named = BTreeSet::new();
    for page in pages() {
        let blocks = [page.blocks_of("sh"), page.blocks_of("text")].concat();
        let code = [page.code_spans(), blocks].concat().join(" ");
        for flag in flags(&code) {
            let is_known = program.contains(&flag) || scripts.contains(&flag) || FOREIGN.contains(&flag.as_str());
            assert!(is_known, "{}: {flag} does not exist", page.name());
            named.insert(flag);
        }
    }
    let missing: Vec<&String> =
        program.difference(&named).filter(|flag| !["--help", "--version"].contains(&flag.as_str())).collect();
    assert!(missing.is_empty(), "documented nowhere: {missing:?}");
}

/// The code spans of a page that are headers of tables, by the name of the file in the same row or in the sentence.
fn documents_header(page: &Page, file: &Path) {
    let table = fs::read_to_string(file).unwrap();
    let header = table.lines().next().unwrap();
    let name = file.file_name().unwrap().to_str().unwrap();
    let is_documented = page.code_spans().iter().any(|span| span == header);
    assert!(is_documented, "{}: the columns of {name} are {header}", page.name());
}

#[test]
fn columns_of_tables_are_documented() {
    let sandbox = sandbox();
    let results = page("docs/reference/results.md");
    for name in ["reference.csv", "scenarios.csv", "wrench.csv", "contacts.csv"] {
        documents_header(&results, &sandbox.path().join("out/corner").join(name));
    }
    run(sandbox.path(), &["simulate", "scenes/corner.toml", "out/corner"]);
    for name in ["rollouts.csv", "success.csv"] {
        documents_header(&page("docs/reference/simulate.md"), &sandbox.path().join("out/corner").join(name));
    }
    run(sandbox.path(), &["batch", "expand", "scenes/corner.toml", "--out", "runs/corner"]);
    run(sandbox.path(), &["batch", "collect", "runs/corner"]);
    documents_header(&page("docs/guide/batches.md"), &sandbox.path().join("runs/corner/cells.csv"));
}

#[test]
fn settings_of_the_homotopy_are_those_of_the_scene_page() {
    let settings = |page: Page, mark: &str| -> Vec<Vec<String>> {
        let tables = page.marked_tables(mark);
        tables[0].1.iter().map(|row| row[..4].to_vec()).collect()
    };
    assert_eq!(
        settings(page("docs/reference/homotopy.md"), "settings"),
        settings(page("docs/reference/scene.md"), "keys of homotopy"),
        "key, values, unit, default"
    );
}

#[test]
fn functions_of_the_method_exist() {
    let mut count = 0;
    for (_, rows) in page("docs/concepts/method.md").marked_tables("functions") {
        for row in rows {
            let [.., crates, functions] = row.as_slice() else { panic!("{row:?}") };
            let source: String =
                spans(crates).iter().map(|name| sources(&project("crates").join(name).join("src"))).collect();
            for name in spans(functions) {
                let is_module = source.contains(&format!("mod {name};"));
                let is_item = ["fn", "struct", "enum", "trait"].iter().any(|kind| {
                    let item = format!("{kind} {name}");
                    source
                        .match_indices(&item)
                        .any(|(at, _)| !source[at + item.len()..].starts_with(char::is_alphanumeric))
                });
                assert!(is_item || is_module, "{}: {name} is not in {crates}", row[0]);
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count} functions found");
}

/// All sources below a folder.
fn sources(folder: &Path) -> String {
    let mut text = String::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        text += &if path.is_dir() { sources(&path) } else { fs::read_to_string(&path).unwrap() };
    }
    text
}

#[test]
fn the_table_of_crates_is_that_of_the_workspace() {
    let mut documented = Vec::new();
    for row in &page("docs/concepts/architecture.md").marked_tables("crates")[0].1 {
        documented.push((spans(&row[0])[0].clone(), spans(&row[2])));
    }
    let mut crates = Vec::new();
    let names: BTreeSet<String> = documented.iter().map(|(name, _)| name.clone()).collect();
    for (name, _) in &documented {
        let manifest = fs::read_to_string(project("crates").join(name).join("Cargo.toml")).unwrap();
        let manifest: toml::Table = toml::from_str(&manifest).unwrap();
        let used = manifest.get("dependencies").and_then(toml::Value::as_table).into_iter().flat_map(toml::Table::keys);
        let mut used: Vec<String> = used.filter(|name| names.contains(*name)).cloned().collect();
        used.sort();
        crates.push((name.clone(), used));
    }
    assert_eq!(documented, crates);
    assert_eq!(fs::read_dir(project("crates")).unwrap().count(), crates.len(), "crates that are not documented");
}

#[test]
fn pages_that_everybody_reads_are_short() {
    for (name, largest) in [("README.md", 130), ("CONTRIBUTING.md", 90), ("docs/concepts/robust-plans.md", 150)] {
        let lines = page(name).text.lines().count();
        assert!(lines <= largest, "{name} has {lines} lines");
    }
}

/// What was tried and measured belongs into the notebook.
#[test]
fn the_manual_speaks_of_now() {
    for page in pages_in(&["docs/guide", "docs/reference", "docs/concepts"]) {
        let prose = page.prose().to_lowercase();
        for words in ["no longer", "not kept", "earlier version", "older version", "at first"] {
            assert!(!prose.contains(words), "{}: {words}", page.name());
        }
    }
}
