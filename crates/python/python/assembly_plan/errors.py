"""Exceptions and warnings, with the messages of the command line."""


class PlannerError(Exception):
    """Something could not be done: a file cannot be written, a linear solver failed (exit code 3 of the command)."""


class SceneError(PlannerError, ValueError):
    """The input is wrong: the message names file, line and key, and says what would be right (exit code 2)."""


class NoPlanError(PlannerError):
    """The time ended before there was a plan (exit code 1)."""


class SceneWarning(UserWarning):
    """Something of a scene or plan looks like a mistake."""
