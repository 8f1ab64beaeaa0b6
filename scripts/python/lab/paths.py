"""Where things are."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[3]
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
PROGRAM = TARGET / "release/assembly-plan"
# Arms of six and seven joints as [robot] tables, `six.toml` and `seven.toml`.
ARMS = ROOT / "examples/arms"
OUT, SCENES = ROOT / "out", ROOT / "scenes"
LAB = ROOT / "scripts/lab"
PLAYERS = ROOT / "crates/export/players"
