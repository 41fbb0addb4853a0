"""Nothing is recorded."""

from typing import NamedTuple

from snapjump.engine.recorder.base import Recorder


@Recorder.member
class NoRecorder(NamedTuple):
    """For batches: only the outcome counts."""

    def watches(self) -> bool:
        return False
