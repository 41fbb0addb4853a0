"""Scenes: the contract that every one fulfils, and what several of them need and choose."""

from snapjump.checks import ParameterError
from snapjump.declare.fields import Need
from snapjump.declare.scenes import Progress as Progress
from snapjump.declare.scenes import SceneOptions as SceneOptions

MOST_SAMPLES, MOST_ELEMENT_SAMPLES = 200_000, 200_000_000
ONE_AT_A_TIME = Need("backend", "one_at_a_time")
NO_DRAG = Need("drag", "absent", "in which nothing flies")
NO_GROUND = (Need("contact", "absent"), Need("friction", "absent"), NO_DRAG)
HELD = Need("frame", "held")
TURNS = Need("drive", "turns", "which begins in equilibrium, its clamps as far apart as they stay")
NEEDS_NO_GROUND = (*NO_GROUND, HELD, ONE_AT_A_TIME)
NEEDS_A_GROUND = (Need("contact", "pushes"), NO_DRAG, HELD, ONE_AT_A_TIME)
WITHOUT_GROUND = {"frame": "fixed", "contact": "none", "friction": "none"}
AT_REST = {**WITHOUT_GROUND, "damping": "none"}


def check_samples(duration_s: float, interval_s: float, elements: int = 1) -> None:
    """Require no more samples, of so many elements, than fit in memory."""
    most = min(MOST_SAMPLES, MOST_ELEMENT_SAMPLES // elements)
    shortest_s = duration_s / most
    # What the message says, with its six digits, is accepted.
    if interval_s < (1.0 - 1e-5) * shortest_s:
        allowed = f"at least {shortest_s:g} s for {duration_s:g} s, which are {most} samples"
        raise ParameterError("sim.sample_interval_s", interval_s, allowed)


class SampledScene(SceneOptions):
    """A scene of ``duration_s``, whose states are kept ``sample_interval_s`` apart."""

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.duration_s, self.sample_interval_s)
