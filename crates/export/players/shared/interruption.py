"""Signals that end a session. While a robot moves they are only noted, so that no command is cut in half: the session looks for them
at every measurement."""

import signal

# A terminal that is closed and a connection that is lost come as SIGHUP.
SIGNALS = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT")


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
