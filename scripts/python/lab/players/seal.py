"""Seals a folder as `assembly-plan export` does."""

import hashlib
import pathlib

SUMS = "SHA256SUMS"


def seal(folder: pathlib.Path) -> None:
    """Writes the hashes of all files in it."""
    files = sorted(file for file in folder.iterdir() if file.is_file() and file.name != SUMS)
    lines = (f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in files)
    (folder / SUMS).write_text("".join(lines))
