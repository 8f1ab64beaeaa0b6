//! Files that are something else than their name says.

use crate::error::MeshError;
use crate::read::Format;
use crate::stl;
use crate::text::{is_blank, lines, without_mark, words};

/// How files begin that people take for meshes, in small letters, and what to do about them.
const BEGINNINGS: [(&[u8], &str); 18] = [
    (b"version https://git-lfs", "a Git LFS pointer and not the file itself: run `git lfs pull`"),
    (b"<!doctype html", "a web page and not a mesh: download the file itself"),
    (b"<html", "a web page and not a mesh: download the file itself"),
    (b"<", "an XML file: export the part as STL or OBJ"),
    (b"{", "a JSON file: export the part as STL or OBJ"),
    (b"pk\x03\x04", "a ZIP or 3MF archive: unpack it, or export the part as STL or OBJ"),
    (b"\x1f\x8b", "compressed by gzip: unpack it"),
    (b"iso-10303-21", "a STEP file: make a mesh of it with `scripts/lab step-to-obj`"),
    (b"ply\n", "a PLY file: export the part as STL or OBJ"),
    (b"ply\r", "a PLY file: export the part as STL or OBJ"),
    (b"off\n", "an OFF file: export the part as STL or OBJ"),
    (b"gltf", "a glTF file: export the part as STL or OBJ"),
    (b"#vrml", "a VRML file: export the part as STL or OBJ"),
    (b"\xff\xfe", "text in UTF-16: save it as UTF-8"),
    (b"\xfe\xff", "text in UTF-16: save it as UTF-8"),
    (b"s\0o\0l\0", "text in UTF-16: save it as UTF-8"),
    (b"v\0 \0", "text in UTF-16: save it as UTF-8"),
    (b"#\0", "text in UTF-16: save it as UTF-8"),
];
/// Lines among which an OBJ file has a vertex, but for those with long introductions.
const FIRST_LINES: usize = 200;

/// Refuses files that are known to be something else than the format.
///
/// # Errors
/// With what the file is.
pub fn refuse_foreign(bytes: &[u8], format: Format) -> Result<(), MeshError> {
    let bytes = without_mark(bytes);
    let Some(begin) = bytes.iter().position(|byte| !is_blank(*byte)) else {
        return Err(MeshError::NoContent { size: bytes.len() });
    };
    let head = bytes[begin..].iter().take(32).map(u8::to_ascii_lowercase).collect::<Vec<u8>>();
    let known = BEGINNINGS.iter().find(|(beginning, _)| head.starts_with(beginning));
    let what = known.map(|(_, what)| *what).or_else(|| match format {
        Format::Stl if is_obj(bytes) => Some("an OBJ file: name it .obj"),
        Format::Obj if stl::is_binary(bytes) || stl::is_text(bytes) => Some("an STL file: name it .stl"),
        _ => None,
    });
    what.map_or(Ok(()), |what| Err(MeshError::Foreign { what }))
}

/// Whether a file has a line with a vertex of OBJ files.
fn is_obj(bytes: &[u8]) -> bool {
    let is_vertex = |line: &[u8]| {
        let words: Vec<&[u8]> = words(line).take(4).collect();
        words.len() == 4 && words[0] == b"v"
    };
    lines(bytes).take(FIRST_LINES).any(|(_, line)| is_vertex(line))
}
