"""Options of the scenes."""

from snapjump.checks import ParameterError
from snapjump.declare.fields import Part, integer, number

MOST_SAMPLES = 200_000


def check_samples(duration_s: float, interval_s: float) -> None:
    """Require no more samples than fit in memory."""
    if duration_s > MOST_SAMPLES * interval_s:
        raise ParameterError(
            "sim.sample_interval_s",
            interval_s,
            f"at least {duration_s / MOST_SAMPLES:g} s for {duration_s:g} s, which are "
            f"{MOST_SAMPLES} samples",
        )


class SceneOptions(Part):
    """A scene and its numbers."""

    group = "sim"


class JumpScene(SceneOptions):
    """The whole jump: snap, strike, lift-off and ballistic apex.

    The motion starts at ``start_fraction`` of the symmetric arch's critical angle from the static
    solution; ``time_limit_s`` counts from there. States are kept ``sample_interval_s`` apart.
    """

    start_fraction: float = number(0.85, least=0.0, most=0.95)
    time_limit_s: float = number(0.1, above=0.0, unit="s")
    sample_interval_s: float = number(2.0e-5, above=1e-7, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.time_limit_s, self.sample_interval_s)


class StaticScene(SceneOptions):
    """Slow loading: branches, stability, critical angle and snapped state.

    ``steps``: points along each branch.
    """

    steps: int = integer(120, least=10, most=100_000)


class SnapScene(SceneOptions):
    """The beam alone snaps in a frame that is held still, without gravity or ground.

    The clamps start from flat and reach their rate within about ``rise_time_s``.
    """

    duration_s: float = number(0.06, above=0.0, unit="s")
    rise_time_s: float = number(1.0e-3, above=0.0, unit="s")
    sample_interval_s: float = number(5.0e-5, above=1e-7, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.duration_s, self.sample_interval_s)


class CantileverScene(SceneOptions):
    """Verification: a cantilever bent by a force (in EI/L^2) across its tip."""

    load_bar: float = number(1.0, least=-20.0, most=20.0, unit="EI/L^2")


class BounceScene(SceneOptions):
    """Verification: one mass falls onto the barrier at a given speed and bounces off."""

    mass_kg: float = number(7.6e-7, above=0.0, unit="kg")
    speed_m_s: float = number(10.0, least=0.0, unit="m/s")
    duration_s: float = number(1.0e-4, above=0.0, unit="s")
    sample_interval_s: float = number(1.0e-7, above=0.0, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.duration_s, self.sample_interval_s)


class SlideScene(SceneOptions):
    """Verification: one mass slides on the ground until friction stops it.

    ``incline`` is the tangent of the slope down which gravity also pulls.
    """

    mass_kg: float = number(4.0e-3, above=0.0, unit="kg")
    speed_m_s: float = number(0.1, least=0.0, unit="m/s")
    duration_s: float = number(0.05, above=0.0, unit="s")
    incline: float = number(0.0, least=0.0, most=1.0)
    sample_interval_s: float = number(1.0e-5, above=0.0, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.duration_s, self.sample_interval_s)
