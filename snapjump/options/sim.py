"""Options of the scenes."""

from dataclasses import dataclass

from snapjump.checks import ParameterError, check_integer, check_number

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


@dataclass(frozen=True)
class JumpScene:
    """The whole jump: snap, strike, lift-off and ballistic apex.

    The motion starts at ``start_fraction`` of the symmetric arch's critical angle from the static
    solution; ``time_limit_s`` counts from there. States are kept ``sample_interval_s`` apart.
    """

    start_fraction: float = 0.85
    time_limit_s: float = 0.1
    sample_interval_s: float = 2.0e-5

    def __post_init__(self) -> None:
        check_number("sim.start_fraction", self.start_fraction, 0.0, 0.95)
        check_number("sim.time_limit_s", self.time_limit_s, 0.0, above=True, unit="s")
        check_number("sim.sample_interval_s", self.sample_interval_s, 1e-7, above=True, unit="s")
        check_samples(self.time_limit_s, self.sample_interval_s)


@dataclass(frozen=True)
class StaticScene:
    """Slow loading: branches, stability, critical angle and snapped state.

    ``steps``: points along each branch.
    """

    steps: int = 120

    def __post_init__(self) -> None:
        check_integer("sim.steps", self.steps, 10, 100_000)


@dataclass(frozen=True)
class SnapScene:
    """The beam alone snaps in a frame that is held still, without gravity or ground.

    The clamps start from flat and reach their rate within about ``rise_time_s``.
    """

    duration_s: float = 0.06
    rise_time_s: float = 1.0e-3
    sample_interval_s: float = 5.0e-5

    def __post_init__(self) -> None:
        check_number("sim.duration_s", self.duration_s, 0.0, above=True, unit="s")
        check_number("sim.rise_time_s", self.rise_time_s, 0.0, above=True, unit="s")
        check_number("sim.sample_interval_s", self.sample_interval_s, 1e-7, above=True, unit="s")
        check_samples(self.duration_s, self.sample_interval_s)


@dataclass(frozen=True)
class CantileverScene:
    """Verification: a cantilever bent by a force (in EI/L^2) across its tip."""

    load_bar: float = 1.0

    def __post_init__(self) -> None:
        check_number("sim.load_bar", self.load_bar, -20.0, 20.0, unit="EI/L^2")


@dataclass(frozen=True)
class BounceScene:
    """Verification: one mass falls onto the barrier at a given speed and bounces off."""

    mass_kg: float = 7.6e-7
    speed_m_s: float = 10.0
    duration_s: float = 1.0e-4
    sample_interval_s: float = 1.0e-7

    def __post_init__(self) -> None:
        check_number("sim.mass_kg", self.mass_kg, 0.0, above=True, unit="kg")
        check_number("sim.speed_m_s", self.speed_m_s, 0.0, unit="m/s")
        check_number("sim.duration_s", self.duration_s, 0.0, above=True, unit="s")
        check_number("sim.sample_interval_s", self.sample_interval_s, 0.0, above=True, unit="s")
        check_samples(self.duration_s, self.sample_interval_s)


@dataclass(frozen=True)
class SlideScene:
    """Verification: one mass slides on the ground until friction stops it.

    ``incline`` is the tangent of the slope down which gravity also pulls.
    """

    mass_kg: float = 4.0e-3
    speed_m_s: float = 0.1
    duration_s: float = 0.05
    incline: float = 0.0
    sample_interval_s: float = 1.0e-5

    def __post_init__(self) -> None:
        check_number("sim.mass_kg", self.mass_kg, 0.0, above=True, unit="kg")
        check_number("sim.speed_m_s", self.speed_m_s, 0.0, unit="m/s")
        check_number("sim.duration_s", self.duration_s, 0.0, above=True, unit="s")
        check_number("sim.incline", self.incline, 0.0, 1.0)
        check_number("sim.sample_interval_s", self.sample_interval_s, 0.0, above=True, unit="s")
        check_samples(self.duration_s, self.sample_interval_s)
