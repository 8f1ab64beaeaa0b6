"""A stub of an older libm.

Linkers choose the newest version of a function that the library has. A program that calls `hypot` and is linked with
glibc 2.36 needs 2.35 for that alone, although older ones have a `hypot` too. The stub has every function of the
installed libm in the newest version that the older one has, with nothing in it.
"""

import re
import subprocess
from pathlib import Path

from lab.errors import InputError

# A function in the table of dynamic symbols: type, section, size, version (in brackets if it is not the default), name.
FUNCTION = re.compile(r" (?:DF|iD) \.text\s+\w+ +\(?GLIBC_([\d.]+)\)? +(\w+)$", re.MULTILINE)


def write(version: str, folder: Path, compiler: str) -> None:
    """Writes `libm.so` for a version of glibc, from the libm of a compiler."""
    library = _printed(compiler, "-print-file-name=libm.so.6")
    table = _printed(_printed(compiler, "-print-prog-name=objdump"), "--dynamic-syms", library)
    functions = newest(FUNCTION.findall(table), version)
    folder.mkdir(parents=True, exist_ok=True)
    versions = sorted({of for _, of in functions}, key=_number)
    (folder / "versions").write_text("".join(f"GLIBC_{of} {{ local: stub_*; }};\n" for of in versions))
    lines = [
        f".globl stub_{index}\n.type stub_{index}, %function\n.symver stub_{index}, {name}@@GLIBC_{of}\nstub_{index}:"
        for index, (name, of) in enumerate(functions)
    ]
    source = folder / "stub.s"
    source.write_text("\n".join([".text", *lines, ""]))
    options = ["-nostdlib", "-shared", "-Wl,-soname,libm.so.6", f"-Wl,--version-script={folder / 'versions'}"]
    subprocess.run([compiler, *options, "-o", folder / "libm.so", source], check=True)


def newest(functions: list[tuple[str, str]], version: str) -> list[tuple[str, str]]:
    """The names of functions, each with the newest of its versions up to one."""
    chosen: dict[str, str] = {}
    for of, name in sorted(functions, key=lambda function: _number(function[0])):
        if _number(of) <= _number(version):
            chosen[name] = of
    if not chosen:
        raise InputError(f"libm has nothing of glibc {version} or older")
    return sorted(chosen.items())


def _number(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def _printed(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
