"""The contract of a tracker: what ``tracking=<name>`` does with a job that has ended."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from snapjump.checks import check_text
from snapjump.declare.fields import Part, settings

State = Literal["FINISHED", "FAILED", "KILLED"]


class TrackingError(RuntimeError):
    """A record could not be written; the message is one line."""


@dataclass(frozen=True)
class DatasetUse:
    """A dataset that a job made or used: ``digest`` is its hash, ``context`` says for what."""

    name: str
    digest: str
    path: str
    rows: int
    context: str


# Numbers of a job by their names, against its steps: (step, value), one after the other.
Curves = Mapping[str, Sequence[tuple[int, float]]]


@dataclass(frozen=True)
class Model:
    """A trained model to be kept among others: ``file``: as ONNX; ``name``: in the registry;
    ``inputs``, ``outputs``: the columns of its two tensors."""

    file: Path
    name: str
    inputs: Sequence[str]
    outputs: Sequence[str]


@dataclass(frozen=True)
class Record:
    """The record of one job, written at once at its end. Times are in ms since 1970."""

    name: str
    state: State
    started_ms: int
    ended_ms: int
    params: Mapping[str, Any] = field(default_factory=dict)
    metrics: Mapping[str, float] = field(default_factory=dict)
    tags: Mapping[str, str] = field(default_factory=dict)
    files: Sequence[Path] = ()
    parent_id: str | None = None
    datasets: Sequence[DatasetUse] = ()
    curves: Curves = field(default_factory=dict)
    model: Model | None = None


class Tracker(Part):
    """A tracker that records nothing. Only ``check`` may be called before there is a record."""

    group = "tracking"

    def __post_init__(self) -> None:
        super().__post_init__()
        for key in settings(self):
            check_text(f"tracking.{key}", getattr(self, key), "a text that is not empty")

    @property
    def place(self) -> str:
        """Where the records are, for people; empty if there are none."""
        return ""

    def check(self) -> None:
        """Find out quickly whether records can be written; raises ParameterError."""

    def open(self, record: Record, run_id: str | None) -> str | None:
        """Begin a record, or go on with an earlier one if that can be; returns its id.
        Raises TrackingError, as all of these do, within a bounded time."""
        return None

    def add(self, run_id: str, params: Mapping[str, Any], curves: Curves) -> None:
        """Write what is known of a job that is under way."""

    def write(self, run_id: str, record: Record) -> None:
        """Write all of a record but its files."""

    def send(self, run_id: str, record: Record) -> None:
        """Put the record's files beside it."""
