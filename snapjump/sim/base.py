"""Scenes: the contract that every one fulfils."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from snapjump.checks import ParameterError
from snapjump.declare.fields import Need, Part, required
from snapjump.declare.outputs import Outputs

Progress = Callable[[float, str], None]
MOST_SAMPLES = 200_000
ONE_AT_A_TIME = Need("backend", "one_at_a_time")
NO_GROUND = (Need("contact", "absent"), Need("friction", "absent"))
HELD = Need("frame", "held")


class SceneOptions(Part):
    """A scene and its numbers.

    ``outputs``: the class of what it reports. ``chooses``: members that go with it unless others
    are asked for, by family. ``tells``: paths of the values in its reports' titles; by default all
    of its own.
    """

    group = "sim"
    outputs: ClassVar[type[Outputs]]
    chooses: ClassVar[Mapping[str, str]] = {}
    tells: ClassVar[tuple[str, ...]] = ()
    moves_a_beam: ClassVar[bool] = False

    def check_start(self, simulation: Any) -> None:
        """What only the machine and the robot's statics tell. Raises ParameterError if the scene
        cannot begin."""

    @required
    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        """The :class:`~snapjump.results.Result` of a simulation of this scene."""

    if TYPE_CHECKING:  # fields of a member that only its family is known of

        def __getattr__(self, name: str) -> Any: ...


WITHOUT_GROUND = {"frame": "fixed", "contact": "none", "friction": "none"}
AT_REST = {**WITHOUT_GROUND, "damping": "none"}


def check_samples(duration_s: float, interval_s: float) -> None:
    """Require no more samples than fit in memory."""
    if duration_s > MOST_SAMPLES * interval_s:
        raise ParameterError(
            "sim.sample_interval_s",
            interval_s,
            f"at least {duration_s / MOST_SAMPLES:g} s for {duration_s:g} s, which are "
            f"{MOST_SAMPLES} samples",
        )
