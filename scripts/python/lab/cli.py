"""The command line: one command for every module in `lab.commands`, whose documentation is its help."""

import argparse
import functools
import importlib
import pkgutil
import subprocess
import sys

import lab.commands
from lab import environment
from lab.errors import Failure, InputError

FORMAT = functools.partial(argparse.RawDescriptionHelpFormatter, width=128, max_help_position=20)
EPILOG = "Exit codes: 0 done, 1 a check failed, 2 wrong input or usage, 3 anything else, 130 interrupted."


def main() -> int:
    """Runs what the command line asks for; returns the exit code."""
    arguments = parser().parse_args()
    try:
        environment.enter(arguments.packages)
        return arguments.run(arguments) or 0
    except InputError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except (Failure, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 3
    except subprocess.CalledProcessError as error:
        print(f"error: {' '.join(map(str, error.cmd))} ended with code {error.returncode}", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        return 130


def parser() -> argparse.ArgumentParser:
    """The parser of all commands. Their modules import nothing but Python's own library before they run."""
    whole = argparse.ArgumentParser(prog="scripts/lab", description=lab.__doc__, epilog=EPILOG, formatter_class=FORMAT)
    commands = whole.add_subparsers(metavar="COMMAND", required=True)
    for found in pkgutil.iter_modules(lab.commands.__path__):
        add(commands, found.name.replace("_", "-"), importlib.import_module(f"lab.commands.{found.name}"))
    return whole


def add(commands: argparse._SubParsersAction, name: str, command: object) -> None:
    """Adds a command: an object with documentation, names of the packages that it needs, arguments and `run`."""
    parser = commands.add_parser(
        name,
        # Only this one is a format.
        help=command.__doc__.splitlines()[0].replace("%", "%%"),
        description=command.__doc__,
        epilog=getattr(command, "EPILOG", EPILOG),
        formatter_class=FORMAT,
    )
    parser.set_defaults(run=getattr(command, "run", None), packages=getattr(command, "PACKAGES", ()))
    command.add_arguments(parser)
