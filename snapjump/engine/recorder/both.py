"""Two recorders of one march, each of which may be two again."""

from typing import Any, NamedTuple

from snapjump.engine.recorder.base import Recorder


@Recorder.member
class BothRecorders(NamedTuple):
    """``first`` and then ``second`` are called, whatever there is to record."""

    first: Any
    second: Any

    def watches(self) -> Any:
        return self.first.watches() or self.second.watches()

    def record_robot(self, lane: Any, robot: Any) -> None:
        self.first.record_robot(lane, robot)
        self.second.record_robot(lane, robot)

    def record_start(self, model: Any, masses: Any, work: Any) -> None:
        self.first.record_start(model, masses, work)
        self.second.record_start(model, masses, work)

    def record_stage(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, converged: Any
    ) -> None:
        self.first.record_stage(model, masses, motion, scheme, work, converged)
        self.second.record_stage(model, masses, motion, scheme, work, converged)

    def follow(
        self, model: Any, masses: Any, motion: Any, scheme: Any, work: Any, course: Any, good: Any
    ) -> None:
        self.first.follow(model, masses, motion, scheme, work, course, good)
        self.second.follow(model, masses, motion, scheme, work, course, good)

    def record_step(self, model: Any, masses: Any, scheme: Any, work: Any, good: Any) -> None:
        self.first.record_step(model, masses, scheme, work, good)
        self.second.record_step(model, masses, scheme, work, good)

    def record_end(self, model: Any, masses: Any, lane: Any, robot: Any) -> None:
        self.first.record_end(model, masses, lane, robot)
        self.second.record_end(model, masses, lane, robot)
