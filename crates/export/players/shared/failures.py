"""Why a session does not begin, or ends early."""


class InputError(Exception):
    """Something the user gave is wrong, or the robot is not ready."""


class Stopped(Exception):
    """Something is not as planned: the robot has to stop."""


class ConnectionLost(Stopped):
    """The robot does not answer, or does not do any more what it is told."""
