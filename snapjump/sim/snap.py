"""``sim=snap``: the beam alone snaps in a frame that is held still, without gravity or ground."""

from typing import Any

from snapjump.declare.fields import number
from snapjump.sim.base import (
    HELD,
    NO_GROUND,
    ONE_AT_A_TIME,
    WITHOUT_GROUND,
    Progress,
    SceneOptions,
    check_samples,
)


class Snap(SceneOptions):
    """The beam alone snaps in a frame that is held still, without gravity or ground.

    The clamps start from flat and reach their rate within about ``rise_time_s``.
    """

    moves_a_beam = True
    chooses = WITHOUT_GROUND
    needs = (*NO_GROUND, HELD, ONE_AT_A_TIME)

    duration_s: float = number(0.06, above=0.0, unit="s")
    rise_time_s: float = number(1.0e-3, above=0.0, unit="s")
    sample_interval_s: float = number(5.0e-5, above=1e-7, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.duration_s, self.sample_interval_s)

    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        from snapjump.scenes.snap import simulate_snap_scene

        return simulate_snap_scene(simulation, progress)
