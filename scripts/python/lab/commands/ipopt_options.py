"""Writes crates/scene/src/ipopt_options.txt: kinds, ranges and choices of the installed Ipopt's options.

Needs g++ and coinor-libipopt-dev. Options of further versions are added, with the wider range or all choices where
versions differ.
"""

import argparse
import os
import pathlib
import subprocess
import tempfile

from lab.errors import Failure
from lab.paths import ROOT

TABLE = ROOT / "crates/scene/src/ipopt_options.txt"
DEBIAN = pathlib.Path("/usr/include/coin")

# Ipopt 3.11's headers want to know which of C's headers exist.
PROGRAM = r"""
#define HAVE_CSTDDEF
#include <IpIpoptApplication.hpp>
#include <IpoptConfig.h>
#include <cstdio>
using namespace Ipopt;

static void range(bool lower, bool open_below, double from, bool upper, bool open_above, double to) {
    std::printf(lower ? "\t%s\t%.17g" : "\t(\t-inf", open_below ? "(" : "[", from);
    std::printf(upper ? "\t%.17g\t%s" : "\tinf\t)", to, open_above ? ")" : "]");
}

int main() {
    std::puts(IPOPT_VERSION);
    SmartPtr<IpoptApplication> ipopt = new IpoptApplication(false);
    const RegisteredOptions::RegOptionsList& options = ipopt->RegOptions()->RegisteredOptionsList();
    for (RegisteredOptions::RegOptionsList::const_iterator place = options.begin(); place != options.end(); ++place) {
        const RegisteredOption& option = *place->second;
        const bool lower = option.HasLower(), upper = option.HasUpper();
        std::printf("%s", option.Name().c_str());
        if (option.Type() == OT_Integer) {
            const int from = lower ? option.LowerInteger() : 0, to = upper ? option.UpperInteger() : 0;
            std::printf("\tinteger");
            range(lower, false, from, upper, false, to);
        } else if (option.Type() == OT_Number) {
            const bool open_below = lower && option.LowerStrict(), open_above = upper && option.UpperStrict();
            std::printf("\tnumber");
            const double from = lower ? option.LowerNumber() : 0, to = upper ? option.UpperNumber() : 0;
            range(lower, open_below, from, upper, open_above, to);
        } else {
            std::printf("\tstring");
            const std::vector<RegisteredOption::string_entry> choices = option.GetValidStrings();
            for (std::size_t choice = 0; choice < choices.size(); ++choice) {
                std::printf("\t%s", choices[choice].value_.c_str());
            }
        }
        std::puts("");
    }
}
"""


def options_of(include: pathlib.Path, library: list[str]) -> tuple[str, dict[str, list[str]]]:
    """Version and options of one Ipopt; an option is its kind, then bracket, bound, bound, bracket or its choices."""
    with tempfile.TemporaryDirectory() as folder:
        source, program = pathlib.Path(folder, "options.cpp"), pathlib.Path(folder, "options")
        source.write_text(PROGRAM)
        compiler = os.environ.get("CXX", "g++")
        subprocess.run([compiler, "-w", source, f"-I{include}", *library, "-o", program], check=True)
        version, *rows = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    cells = [row.split("\t") for row in rows]
    return version, {name: option for name, *option in cells}


def merged(one: list[str], other: list[str]) -> list[str]:
    """The wider of two ranges, or the choices of both."""
    if one[0] != other[0]:
        raise Failure(f"the kinds differ: {one} and {other}")
    if one[0] == "string":
        return one + [choice for choice in other if choice not in one]
    # A bracket that includes its bound is wider than one that does not.
    lower = min((one, other), key=lambda option: (float(option[2]), option[1] == "("))
    upper = max((one, other), key=lambda option: (float(option[3]), option[4] == "]"))
    return [one[0], *lower[1:3], *upper[3:5]]


def line(name: str, option: list[str]) -> str:
    """A line of the table."""
    if option[0] == "string":
        return " ".join([name, *option])
    kind, opening, lower, upper, closing = option
    return f"{name} {kind} {opening}{float(lower):.15g}, {float(upper):.15g}{closing}"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds its arguments."""
    parser.add_argument(
        "folders",
        nargs="*",
        type=pathlib.Path,
        help="further versions: folders with libipopt.so and include/coin-or, as in the Python package casadi",
    )


def run(arguments: argparse.Namespace) -> None:
    """Writes the table."""
    found = [options_of(DEBIAN, ["-lipopt"])]
    for folder in (folder.resolve() for folder in arguments.folders):
        linked = [str(folder / "libipopt.so"), f"-Wl,-rpath,{folder}", "-Wl,--allow-shlib-undefined"]
        found.append(options_of(folder / "include/coin-or", linked))
    table: dict[str, list[str]] = {}
    for _, options in found:
        for name, option in options.items():
            table[name] = merged(table[name], option) if name in table else option
    versions = " and ".join(version for version, _ in found)
    head = f"# Options of Ipopt {versions}: name, kind, range or choices (* is any text)."
    lines = [f"{head} Written by `scripts/lab ipopt-options`.", *(line(name, table[name]) for name in sorted(table))]
    TABLE.write_text("".join(f"{text}\n" for text in lines))
