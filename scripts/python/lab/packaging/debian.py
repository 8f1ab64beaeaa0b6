"""Licences of a program."""

import json
import pathlib
import subprocess

from lab.paths import ROOT


def linked(metadata: dict, name: str) -> list[dict]:
    """The packages that end up in a program, sorted by name: dependencies that are neither for building nor for
    tests."""
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    found: set[str] = set()
    waiting = [package["id"] for package in packages.values() if package["name"] == name]
    while waiting:
        identity = waiting.pop()
        if identity not in found:
            found.add(identity)
            for dependency in nodes[identity]["deps"]:
                if any(kind["kind"] is None for kind in dependency["dep_kinds"]):
                    waiting.append(dependency["pkg"])
    return sorted((packages[identity] for identity in found), key=lambda package: (package["name"], package["version"]))


def texts(package: dict) -> list[pathlib.Path]:
    """The files in which a package states its licence."""
    files = pathlib.Path(package["manifest_path"]).parent.iterdir()
    words = ("LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE")
    return sorted(file for file in files if file.is_file() and file.name.upper().startswith(words))


def licences_of_crates(package: str) -> str:
    """The licences of all crates that a package of the workspace is linked with, as `cargo metadata` finds them: one
    section per text, with all crates that have it."""
    host = next(
        line.removeprefix("host: ")
        for line in subprocess.run(["rustc", "-vV"], check=True, capture_output=True, text=True).stdout.splitlines()
        if line.startswith("host: ")
    )
    command = ["cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", host]
    metadata = json.loads(subprocess.run(command, check=True, capture_output=True, text=True, cwd=ROOT).stdout)
    users: dict[str, list[str]] = {}
    for crate in linked(metadata, package):
        if crate["source"] is None:
            continue
        found = [file.read_text(errors="replace").strip() for file in texts(crate)]
        for text in found or [f"Licensed under {crate['license']}; its package holds no text."]:
            users.setdefault(text, []).append(f"{crate['name']} {crate['version']} ({crate['license']})")
    return "\n".join(f"{', '.join(names)}\n\n{text}\n\n{'-' * 80}\n" for text, names in users.items())
