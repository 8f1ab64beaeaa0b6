"""What ends a session from outside: signals, and calls that never return. While a robot moves, signals are only noted, so that no
command is cut in half: the session looks for them at every measurement."""

import os
import signal
import threading
import time
from collections.abc import Callable

# A terminal that is closed and a connection that is lost come as SIGHUP.
SIGNALS = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT")
# Longest time of a call to the maker's package, and between two looks at it (s).
LONGEST_CALL, LOOK = 20.0, 0.5


class Interruption:
    """Catches the signals from its making on."""

    def __init__(self) -> None:
        self.reason, self.is_deferred = "", False
        for name in SIGNALS:
            if hasattr(signal, name):
                signal.signal(getattr(signal, name), self.note)

    def note(self, number: int, _frame: object) -> None:
        """A signal has come."""
        self.reason = f"interrupted by {signal.Signals(number).name}"
        if not self.is_deferred:
            raise KeyboardInterrupt(self.reason)

    def defer(self) -> None:
        """From now on, signals wait for `check`."""
        self.is_deferred = True

    def check(self) -> None:
        """Raises KeyboardInterrupt if a signal has come."""
        if self.reason:
            raise KeyboardInterrupt(self.reason)


class Watchdog:
    """Ends the program when the session does not go on: packages wait for ever for a robot that has gone. `give_up` tells why, and
    returns the exit code."""

    def __init__(self, give_up: Callable[[str], int]) -> None:
        self.give_up = give_up
        self.go_on()
        threading.Thread(target=self.watch, daemon=True).start()

    def go_on(self) -> None:
        """The session goes on."""
        self.deadline = time.monotonic() + LONGEST_CALL

    def rest(self) -> None:
        """Nothing is called any more."""
        self.deadline = float("inf")

    def watch(self) -> None:
        """Until the deadline."""
        while time.monotonic() <= self.deadline:
            time.sleep(LOOK)
        os._exit(self.give_up(f"a call to the robot does not return within {LONGEST_CALL:g} s: see that the robot stands"))
