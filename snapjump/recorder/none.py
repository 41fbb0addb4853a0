"""Nothing is recorded."""

from typing import Any, NamedTuple

from snapjump.recorder.base import record_stage, record_start, record_step


class NoRecorder(NamedTuple):
    """For batches: only the outcome counts."""


@record_start.member(NoRecorder)
def _record_start(recorder: NoRecorder, model: Any, masses: Any, work: Any) -> None:
    pass


@record_stage.member(NoRecorder)
def _record_stage(
    recorder: NoRecorder,
    model: Any,
    masses: Any,
    motion: Any,
    scheme: Any,
    work: Any,
    converged: Any,
) -> None:
    pass


@record_step.member(NoRecorder)
def _record_step(recorder: NoRecorder, work: Any) -> None:
    pass
