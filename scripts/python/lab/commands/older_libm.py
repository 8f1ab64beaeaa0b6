"""Makes a stub of the C library's mathematics of an older glibc, to link with: what is linked then runs there too."""

import argparse
import pathlib

from lab.packaging import older_libm


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    add = parser.add_argument
    add("version", metavar="VERSION", help="version of that glibc, such as 2.34")
    add("folder", type=pathlib.Path, metavar="FOLDER", help="where libm.so is written, for `cc -L FOLDER`")
    add("--compiler", default="gcc", metavar="CC", help="compiler of the machine that it is for [default: gcc]")


def run(arguments: argparse.Namespace) -> None:
    """Writes the stub."""
    older_libm.write(arguments.version, arguments.folder, arguments.compiler)
