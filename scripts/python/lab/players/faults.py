"""What goes wrong with what a robot says of itself, for all stand-ins alike."""

import dataclasses

import numpy as np

# By how much a frame is off: a flange (m), and the base of a robot in the world (m).
FLANGE, BASE = 0.1, np.array([1.0, 0.0, 0.8])
# A force that nothing explains (N), and a time that steps (s).
FORCE, STEP = 500.0, 1.0
WORDS = {"nan": np.nan, "inf": np.inf}


@dataclasses.dataclass(frozen=True)
class Said:
    """What a robot says: time (s), joint positions and speeds, position and rotation matrix of the tool in its base,
    force and torque at the tool."""

    time: float
    positions: np.ndarray
    speeds: np.ndarray
    pose: np.ndarray
    rotation: np.ndarray
    wrench: np.ndarray


def spoiled(kind: str, said: Said, first: Said) -> Said:
    """What is said instead: `nan SIGNAL`, `inf SIGNAL`, `frozen SIGNAL`, or a frame or time that is wrong. `first` is
    what was said when the fault came."""
    word, _, signal = kind.partition(" ")
    if word in WORDS:
        return dataclasses.replace(said, **{signal: WORDS[word] * np.ones_like(getattr(said, signal))})
    if word == "frozen":
        return dataclasses.replace(said, **{signal: getattr(first, signal)})
    half_turn = np.diag([-1.0, -1.0, 1.0])
    changes = {
        "flange": lambda: {"pose": said.pose + FLANGE * said.rotation[:, 2]},
        "half turn": lambda: {"rotation": said.rotation @ half_turn},
        "world": lambda: {"pose": said.pose + BASE},
        "force": lambda: {"wrench": np.array([0.0, 0.0, FORCE, 0.0, 0.0, 0.0])},
        "time back": lambda: {"time": said.time - STEP},
    }
    return dataclasses.replace(said, **changes[kind]()) if kind in changes else said
