"""What was heard of a robot. Knows nothing of ROS, so that it is tested without."""

import dataclasses
import threading

import numpy as np

from failures import ConnectionLost, InputError, Stopped

# Largest age (s) of a measurement, and largest change of the time that messages take.
PATIENCE = 0.1
# Largest difference (s) between the stamp of a first message and the clock of this computer.
SAME_CLOCK = 0.5


@dataclasses.dataclass(frozen=True)
class Message:
    """What a message said: its values, when it came (s, monotonic), and its stamp and age (s, by the clock of ROS), if it has one."""

    values: np.ndarray
    came: float
    stamp: float | None = None
    age: float = 0.0


class Inbox:
    """Keeps the newest message of every topic: `pose` of the tool (position, quaternion w x y z), `wrench` (force, torque), `joint
    states` (positions, then speeds), and what else a controller says. A message that was heard before is dropped, and one that is
    older than the last, or in another frame, is remembered as a failure."""

    def __init__(self, frame: str, needed: list[str]) -> None:
        self.frame, self.needed = frame, needed
        self.lock = threading.Lock()
        self.newest: dict[str, Message] = {}
        self.first: dict[str, Message] = {}
        self.failure: Stopped | InputError | None = None

    def put(self, topic: str, message: Message) -> None:
        """A message of a topic."""
        with self.lock:
            before = self.newest.get(topic)
            if before is not None and message.stamp is not None and before.stamp is not None:
                if message.stamp == before.stamp:
                    return
                if message.stamp < before.stamp:
                    self.fail(Stopped(f"the stamps of {topic} run backwards, by {before.stamp - message.stamp:.3f} s"))
                    return
            self.first.setdefault(topic, message)
            self.newest[topic] = message

    def put_pose(self, message: Message, frame: str) -> None:
        """A pose in a frame."""
        if frame != self.frame:
            with self.lock:
                self.fail(InputError(f"the pose of the tool comes in the frame `{frame}`, not `{self.frame}`: name it with --frame"))
            return
        self.put("pose", message)

    def refuse(self, problem: str) -> None:
        """A message that cannot be taken."""
        with self.lock:
            self.fail(Stopped(problem))

    def fail(self, failure: Stopped | InputError) -> None:
        """The first failure is the reason."""
        self.failure = self.failure or failure

    def missing(self) -> list[str]:
        """Topics that were never heard of."""
        with self.lock:
            if self.failure:
                raise self.failure
            return [topic for topic in self.needed if topic not in self.newest]

    def require_clock(self) -> None:
        """The first messages are not old ones that are sent again."""
        with self.lock:
            for topic, message in self.first.items():
                if not abs(message.age) <= SAME_CLOCK:
                    raise InputError(
                        f"the stamp of the first {topic} is {message.age:.2f} s before the clock of this computer: the message is old, "
                        "or the clocks differ"
                    )

    def take(self, now: float) -> dict[str, Message]:
        """The newest messages at a time (s, monotonic), if they are new enough."""
        with self.lock:
            if self.failure:
                raise self.failure
            for topic, message in self.newest.items():
                if not now - message.came <= PATIENCE:
                    raise ConnectionLost(f"the newest {topic} is {now - message.came:.2f} s old, older than {PATIENCE:g} s")
                late = message.age - self.first[topic].age
                if not abs(late) <= PATIENCE:
                    raise ConnectionLost(f"{topic} comes {late:.2f} s later than at first, or a clock was set")
            return dict(self.newest)
