"""Licences of a Python wheel."""

import base64
import csv
import hashlib
import io
import re
import subprocess
import zipfile
from pathlib import Path

from lab import notebook
from lab.errors import Failure
from lab.packaging import debian
from lab.paths import ROOT

PACKAGE = ROOT / "crates/python"

# Libraries of the wheel are those of the table in this page.
PAGE = notebook.PYTHON
LIBRARY = re.compile(r"`(lib\w+)`")
TABLE = re.compile(r"<!-- libraries -->\n(.*?)<!-- end of libraries -->", re.DOTALL)
ARCHITECTURE = re.compile(r"manylinux_\d+_\d+_(\w+)\.whl$")
# A library in the wheel has a hash in its name: libipopt-0123abcd.so.1.9.9.
GRAFTED = re.compile(r"^assembly_plan\.libs/(lib\w+)")


def add_licences(wheel: Path) -> None:
    """Writes a repaired wheel again, with the licences of all libraries and crates that are in it, which its metadata
    lists, and without folders of this machine; refuses libraries that are not known."""
    with zipfile.ZipFile(wheel) as archive:
        files = {info.filename: (info, archive.read(info)) for info in archive.infolist()}
    record = next(name for name in files if name.endswith(".dist-info/RECORD"))
    folder = record.removesuffix("RECORD") + "licenses/"
    architecture = ARCHITECTURE.search(wheel.name)[1]
    added = {f"{folder}{name}": content for name, content in licences(list(files), architecture).items()}
    replaced = {f"{folder.removesuffix('licenses/')}METADATA": metadata(files, added, folder)}
    replaced |= {name: without_places(files[name][1]) for name in files if "/sboms/" in name}
    rows = list(csv.reader(io.StringIO(files[record][1].decode())))
    rows = [
        [name, digest(replaced[name]), str(len(replaced[name]))] if name in replaced else row
        for row in rows
        for name in row[:1]
    ]
    rows += [[name, digest(content), str(len(content))] for name, content in added.items()]
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    whole = wheel.with_suffix(".whole")
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, (info, content) in files.items():
            new = text.getvalue().encode() if name == record else replaced.get(name, content)
            archive.writestr(info, new, zipfile.ZIP_DEFLATED)
        for name, content in added.items():
            archive.writestr(name, content)
    whole.replace(wheel)
    print(f"{wheel.relative_to(ROOT)} ({wheel.stat().st_size / 1e6:.1f} MB)")


def metadata(files: dict, added: dict[str, bytes], folder: str) -> bytes:
    """The metadata of the wheel, with a line for every file of licences (PEP 639)."""
    name = f"{folder.removesuffix('licenses/')}METADATA"
    head, blank, description = files[name][1].decode().partition("\n\n")
    known = set(re.findall(r"^License-File: (.*)$", head, re.MULTILINE))
    new = sorted({path.removeprefix(folder) for path in added} - known)
    return "\n".join([head, *(f"License-File: {path}" for path in new)]).encode() + (blank + description).encode()


def without_places(sbom: bytes) -> bytes:
    """A list of components in which the packages of the workspace have no folder of this machine."""
    return re.sub(rb"(path\+)?file://[^\"#?]*/crates/", rb"\1file:///crates/", sbom)


def licences(names: list[str], architecture: str) -> dict[str, bytes]:
    """Texts of licences by their paths, for all libraries among some files of a wheel for an architecture."""
    texts = {path.name: path.read_bytes() for path in (PACKAGE / "licenses").iterdir()}
    texts["third-party-crates.txt"] = debian.licences_of_crates("python").encode()
    rows = TABLE.search(PAGE.read_text())[1].splitlines()
    rows = [row for row in rows if "only on" not in row or f"only on {architecture} " in row]
    known = {library for row in rows for library in LIBRARY.findall(row)}
    grafted = {match[1] for name in names if (match := GRAFTED.match(name))}
    if grafted != known:
        raise Failure(
            f"the wheel has the libraries {', '.join(sorted(grafted))}; {PAGE.relative_to(ROOT)} lists "
            f"{', '.join(sorted(known))}: look at the licences of those that differ, and correct the table"
        )
    for library in sorted(grafted):
        package = package_of(library)
        texts[f"{package}.txt"] = Path(f"/usr/share/doc/{package}/copyright").read_bytes()
    return texts


def package_of(library: str) -> str:
    """The Debian package that a library is from."""
    found = subprocess.run(["ldconfig", "-p"], capture_output=True, text=True, check=True).stdout
    for path in re.findall(rf"^\s*{re.escape(library)}[-.0-9]*\.so\S* .* => (\S+)$", found, re.MULTILINE):
        # Debian's packages name the folders of libraries with or without /usr, which are the same ones.
        for name in {str(Path(path)), str(Path(path).resolve()), str(Path(path).resolve()).removeprefix("/usr")}:
            owner = subprocess.run(["dpkg", "-S", name], capture_output=True, text=True, check=False).stdout
            if owner:
                return owner.split(":")[0]
    raise Failure(f"{library} is of no Debian package, so its licence is not known")


def digest(content: bytes) -> str:
    """The hash of a file as wheels have it."""
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
