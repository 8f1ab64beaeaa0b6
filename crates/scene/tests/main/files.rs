//! Files that cannot be read as they are, and files of other systems.

use std::path::Path;

use scene::{Scene, SceneError, read_text};

use crate::support::{SCENE, parse, replaced};

fn load(bytes: &[u8]) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, bytes).unwrap();
    Scene::load(&file)
}

fn message(bytes: &[u8]) -> String {
    load(bytes).unwrap_err().message().to_owned()
}

#[test]
fn a_file_that_cannot_be_read_is_named_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let reason = |file: &Path| Scene::load(file).unwrap_err().message().to_owned();
    assert_eq!(reason(&folder.path().join("none.toml")), "the scene cannot be read: there is no such file");
    assert_eq!(reason(folder.path()), "the scene cannot be read: it is a folder; name a file");
    assert_eq!(
        read_text(folder.path(), "matrix").unwrap_err().message(),
        "the matrix cannot be read: it is a folder; name a file"
    );
}

#[test]
fn an_empty_file_is_named_as_such() {
    for text in ["", "  \n\t\n", "\u{feff}", "\r\n"] {
        assert_eq!(message(text.as_bytes()), "the scene is empty");
    }
    assert!(message(b"# only a comment\n").contains("the scene has no [[body.part]]"));
}

#[test]
fn a_file_of_more_than_16_mebibytes_is_refused() {
    let comment = "# padding\n".repeat(1_700_000);
    assert_eq!(message(format!("{SCENE}{comment}").as_bytes()), "the scene cannot be read: it is larger than 16 MiB");
}

#[test]
fn a_file_that_is_not_utf_8_is_refused_at_its_first_wrong_byte() {
    let latin = SCENE.replace("\"wall\"", "\"Wand f\u{fc}r St\u{f6}\u{df}e\"");
    let latin: Vec<u8> = latin.chars().map(|character| character as u8).collect();
    let error = load(&latin).unwrap_err();
    assert_eq!((error.line(), error.column()), (Some(6), Some(15)), "{error}");
    assert!(error.message().ends_with("save it as UTF-8"), "{error}");
    let wide: Vec<u8> = [0xff, 0xfe].into_iter().chain(SCENE.bytes().flat_map(|byte| [byte, 0])).collect();
    assert_eq!(load(&wide).unwrap_err().line(), Some(1));
}

#[test]
fn byte_order_marks_and_windows_line_ends_change_nothing() {
    let windows = |text: &str| format!("\u{feff}{}", text.replace('\n', "\r\n"));
    assert_eq!(load(windows(SCENE).as_bytes()).unwrap().goal, parse(SCENE).unwrap().goal);
    let wrong = replaced("steps = 10", "steps = 0");
    let (one, other) = (parse(&wrong).unwrap_err(), parse(&windows(&wrong)).unwrap_err());
    assert_eq!((one.line(), one.column(), one.to_string()), (other.line(), other.column(), other.to_string()));
    let first = parse("\u{feff}titel = 1\n").unwrap_err();
    assert_eq!((first.line(), first.column()), (Some(1), Some(1)));
}

#[test]
fn a_title_that_is_not_given_is_the_name_of_the_file_as_far_as_it_can_be_one() {
    let title = |file: &str| {
        Scene::parse(scene::Source { file: Path::new(file), text: SCENE })
            .unwrap_or_else(|error| panic!("{error}"))
            .title
    };
    assert_eq!(title("some/folder/peg.toml"), "peg");
    assert_eq!(title("a\nb.toml"), "ab");
    assert_eq!(title(&format!("{}.toml", "x".repeat(200))), "x".repeat(100));
    assert_eq!(title(""), "scene");
}

#[test]
fn long_lines_and_control_characters_are_not_repeated_in_messages() {
    let long = replaced("[0.02, 0.02, 0.1]", &format!("[{}]", "0.02, ".repeat(100_000)));
    assert!(parse(&long).unwrap_err().to_string().len() < 1000);
    let late = replaced("box = [0.02, 0.02, 0.1]", &format!("vertices = [{} [0, 0]]", "[0, 0, 0],".repeat(1000)));
    let error = parse(&late).unwrap_err();
    let text = error.to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert!(text.len() < 1000 && error.column() > Some(10_000), "{text}");
    let mark = lines[3].find('^').unwrap();
    assert_eq!(&lines[2][mark..mark + 6], "[0, 0]");
    assert!(!parse("title = \"\u{1b}[2J\"").unwrap_err().to_string().contains('\u{1b}'));
    assert!(parse(&format!("{} = 1", "k".repeat(1_000_000))).unwrap_err().to_string().len() < 1000);
}

#[test]
fn deep_nesting_is_refused_without_exhausting_the_stack() {
    let deep = [
        format!("x = {}{}", "[".repeat(100_000), "]".repeat(100_000)),
        format!("x = {}1{}", "{a = ".repeat(100_000), "}".repeat(100_000)),
        format!("{} = 1", "a.".repeat(100_000) + "a"),
        format!("[{}]", "a.".repeat(100_000) + "a"),
        format!("x = {}1{}", format!("{{ {}a = ", "a.".repeat(78)).repeat(78), "}".repeat(78)),
    ];
    for text in deep {
        let error = parse(&text).unwrap_err();
        assert!(error.to_string().len() < 1000, "{error}");
    }
}
