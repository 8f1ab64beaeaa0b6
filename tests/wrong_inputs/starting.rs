//! Wrong words and files of `new`, `generate` and `schema`.

use super::Row;

/// A part of 30 units, and one of 0.03 units.
const TETRAHEDRON: &str = "v 0 0 0\nv 30 0 0\nv 0 30 0\nv 0 0 30\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const SPECK: &str = "v 0 0 0\nv 0.03 0 0\nv 0 0.03 0\nv 0 0 0.03\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    ("new", &[], "<FILE>"),
    ("new scene.toml", &[], "scene.toml: already exists; name another file, or replace it with --force"),
    ("new folder", &[], "ends with .toml"),
    ("new offsets.csv --force", &[], "ends with .toml"),
    ("new ''", &[], "a value is required for '<FILE>'"),
    ("new scene.toml/new.toml", &[], "scene.toml"),
    ("new new.toml --body part.stl", &[], "--environment"),
    ("new new.toml --body part.stl --environment part.stl", &[], "--unit"),
    ("new new.toml --unit mm", &[], "--body"),
    ("new new.toml --axis x", &[], "--body"),
    ("new new.toml --body gone.stl --environment gone.stl --unit mm", &[], "gone.stl: mesh: cannot be read"),
    ("new new.toml --body scene.toml --environment scene.toml --unit mm", &[], "is not a known format: use .stl or .obj"),
    ("new new.toml --body part.stl --environment part.stl --unit mm", &[("part.stl", "", "hello")], "part.stl: mesh"),
    ("new new.toml --body part.obj --environment part.obj --unit m", &[("part.obj", "", TETRAHEDRON)], "part.obj: the mesh is 30 m long: is `--unit m` right?"),
    ("new new.toml --body part.obj --environment part.obj --unit mm", &[("part.obj", "", SPECK)], "part.obj: the mesh is 0.00003 m long: is `--unit mm` right?"),
    ("generate", &[], "Usage"),
    ("generate square --out new.toml", &[], "unrecognized subcommand 'square'"),
    ("generate round", &[], "--out"),
    ("generate round --out scene.toml", &[], "scene.toml: already exists"),
    ("generate round --out peg.txt", &[], "ends with .toml"),
    ("generate round --out new.toml --width 0.01", &[], "--width"),
    ("generate rectangular --out new.toml --diameter 0.01", &[], "--diameter"),
    ("generate keyed --out new.toml", &[], "--diameter"),
    ("generate keyed --out new.toml --width 0.01", &[], "--depth"),
    ("generate keyed --out new.toml --diameter 0.01 --width 0.01 --depth 0.01", &[], "cannot be used with"),
    ("generate keyed --out new.toml --diameter 0.01 --depth 0.01", &[], "cannot be used with"),
    ("generate keyed --out new.toml --width 0.01 --depth 0.01 --facets 8", &[], "cannot be used with"),
    ("schema scene.toml", &[], "unexpected argument"),
    ("completions", &[], "<SHELL>"),
    ("completions tcsh", &[], "invalid value 'tcsh'"),
    ("man", &[], "<FOLDER>"),
];
