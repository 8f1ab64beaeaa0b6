"""The file of a log. A thread of its own writes rows as they come: no disk delays the robot, a kill loses no more than the last rows,
and a loss of power the last second."""

import collections
import json
import os
import pathlib
import threading
import time
from typing import Any

from failures import InputError, Stopped

DEFAULT = "executed.csv"
# Room in the first line for the reason of a stop (bytes), and the longest reason that fits in (characters).
ROOM, LONGEST_REASON = 4096, 600
# What the first line says until the session has ended.
UNFINISHED = "the player ended without a word: it was killed, crashed, or its computer lost power"
# Time between two times at which rows are written, and at which they are forced to the disk (s).
WRITTEN, SYNCHRONISED = 0.05, 1.0


class LogFile:
    """A new file: nothing is replaced. Its first line is `#` and a JSON object, which is rewritten at the end."""

    def __init__(self, file: pathlib.Path | None, header: dict[str, Any], columns: str) -> None:
        self.path, self.stream = create(file)
        self.header = header
        self.failure: OSError | None = None
        self.rows: collections.deque[str] = collections.deque()
        self.is_ended = threading.Event()
        self.length = len(json.dumps(header)) + ROOM
        try:
            self.stream.write(self.first_line(UNFINISHED) + f"{columns}\n".encode())
        except OSError as error:
            raise InputError(f"{self.path}: the log cannot be written: {error.strerror}") from error
        self.thread = threading.Thread(target=self.write_rows, daemon=True)
        self.thread.start()

    def add(self, row: str) -> None:
        """A row; Stopped when an earlier one could not be written."""
        if self.failure:
            raise Stopped(f"the log cannot be written any more: {self.failure.strerror}")
        self.rows.append(row)

    def close(self, stopped: str | None) -> None:
        """Writes what is left, and why the session was stopped, if it was."""
        self.is_ended.set()
        self.thread.join()
        self.stream.seek(0)
        # In its place: this works on a full disk too.
        self.stream.write(self.first_line(stopped))
        self.stream.close()

    def first_line(self, stopped: str | None) -> bytes:
        """`#` and the header, as long as it may become."""
        header = self.header if stopped is None else {**self.header, "stopped": stopped[:LONGEST_REASON]}
        return f"# {json.dumps(header).ljust(self.length)}\n".encode()

    def write_rows(self) -> None:
        """Until there are no more."""
        synchronised = time.monotonic()
        is_last = False
        while not is_last and self.failure is None:
            is_last = self.is_ended.wait(WRITTEN)
            rows = [self.rows.popleft() for _ in range(len(self.rows))]
            whole = self.stream.tell()
            try:
                write_all(self.stream.fileno(), "".join(f"{row}\n" for row in rows).encode())
                if time.monotonic() > synchronised + SYNCHRONISED:
                    os.fsync(self.stream.fileno())
                    synchronised = time.monotonic()
            except OSError as error:
                self.failure = error
                # Half a row is dropped.
                self.stream.truncate(whole)


def write_all(file: int, content: bytes) -> None:
    """All of it: a disk that is nearly full takes a part."""
    while content:
        content = content[os.write(file, content) :]


def create(file: pathlib.Path | None) -> tuple[pathlib.Path, Any]:
    """A new file of this name, or else of the first free one: `executed.csv`, `executed-2.csv` and so on."""
    numbered = [pathlib.Path(DEFAULT)] + [pathlib.Path(f"executed-{number}.csv") for number in range(2, 1000)]
    for path in [file] if file else numbered:
        try:
            return path, path.open("xb", buffering=0)
        except FileExistsError:
            if file:
                raise InputError(f"{path} exists: name another file with --log, or move it away") from None
        except OSError as error:
            raise InputError(f"{path}: the log cannot be written: {error.strerror}") from error
    raise InputError(f"{DEFAULT} and all its numbers exist: name a file with --log")
