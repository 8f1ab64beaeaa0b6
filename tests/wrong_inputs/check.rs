//! Wrong words and files of `check`.

use super::Row;

#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    ("check", &[], "<SCENE>"),
    ("check gone.toml", &[], "gone.toml"),
    ("check folder", &[], "folder: the scene cannot be read: it is a folder"),
    ("check ''", &[], "a value is required for '<SCENE>'"),
    ("check latin.toml", &[], "latin.toml:1"),
    ("check binary.toml", &[], "binary.toml: the scene cannot be read: it is not a text file"),
    ("check homotopy.toml", &[], "homotopy.toml"),
    ("check matrix.toml", &[], "matrix.toml"),
    ("check scene.toml scene.toml", &[], "unexpected argument"),
    ("check scene.toml --out out", &[], "--out"),
    ("check scene.toml --homotopy homotopy.toml", &[], "--homotopy"),
    ("check scene.toml --pose", &[], "--pose"),
    ("check scene.toml --pose 1 2 3 1 0 0 0", &[], "unexpected argument '2'"),
    ("check scene.toml --pose '0 0 0 1 0 0 0' --pose '0 0 0 1 0 0 0'", &[], "--pose"),
    ("check scene.toml --tau", &[], "--tau"),
    ("check scene.toml --json --json", &[], "--json"),
    ("check scene.toml --delta 0.01 --delta 0.01", &[], "--delta"),
];
