"""Nothing is recorded."""

from typing import Any, NamedTuple

from snapjump.recorder.base import (
    record_end,
    record_robot,
    record_stage,
    record_start,
    record_step,
)


class NoRecorder(NamedTuple):
    """For batches: only the outcome counts."""


def _nothing(recorder: Any, *args: Any) -> None:
    pass


for _function in (record_robot, record_start, record_stage, record_step, record_end):
    _function.member(NoRecorder)(_nothing)
