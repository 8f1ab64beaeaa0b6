"""What ends a command with a message."""


class InputError(Exception):
    """Something the user gave is wrong."""


class Failure(Exception):
    """Something else went wrong."""
