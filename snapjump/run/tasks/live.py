"""The record of a job while it is under way: how far it is, and what it tells of its steps."""

import time
from collections.abc import Mapping

from snapjump.files.json_file import write_json
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks.base import Progress
from snapjump.tracking.base import Record, Tracker, TrackingError
from snapjump.tracking.parts.tracked import MARK, make_record

EVERY_S = 5.0  # between records; a job that is shorter is recorded when it has ended
SHARE = "progress_percent"


class Live:
    """Records a job every few seconds. A store that fails is left alone: the record at the job's
    end says so, and has everything. ``run_id``: of the record, once there is one."""

    def __init__(self, tracker: Tracker, folder: ResultFolder, command: str, **place: str | None):
        """``place``: name and parent_id of a cell's record."""
        self._tracker, self._folder, self._command, self._place = tracker, folder, command, place
        self._curves: dict[str, list[tuple[int, float]]] = {}
        self._sent: dict[str, int] = {}
        self.run_id: str | None = None
        self._begun = self._told = time.monotonic()
        self._works = True

    def step(self, row: Mapping[str, float]) -> None:
        """Numbers of a step, which is the first of them."""
        (_, step), *others = row.items()
        for key, value in others:
            self._curves.setdefault(key, []).append((int(step), float(value)))
        self._send()

    def watched(self, progress: Progress) -> Progress:
        """The progress, which is recorded too: a step is a second."""

        def watch(share: float, text: str) -> None:
            progress(share, text)
            seconds = int(time.monotonic() - self._begun)
            if seconds >= EVERY_S:
                self._curves[SHARE] = [(seconds, 100.0 * share)]
                self._send()

        return watch

    def _send(self) -> None:
        now = time.monotonic()
        if not self._works or now - self._told < EVERY_S:
            return
        self._told = now
        try:
            record = make_record(self._folder, command=self._command, **self._place)
            self._add(record)
        except TrackingError:
            self._works = False

    def _add(self, record: Record) -> None:
        if self.run_id is None:
            self.run_id = self._tracker.open(record, None)
            if self.run_id is None:
                self._works = False
                return
        self._tracker.add(self.run_id, record.params, self._curves)
        self._sent |= {key: curve[-1][0] for key, curve in self._curves.items() if curve}
        place = {"place": self._tracker.place, "parent_id": self._place.get("parent_id")}
        mark = {**place, "run_id": self.run_id, "sent": self._sent}
        write_json(self._folder.path / MARK, mark)
        self._curves = {key: [] for key in self._curves}
