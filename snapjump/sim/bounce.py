"""``sim=bounce``: one mass falls onto the ground and bounces off, without gravity."""

from typing import Any

from snapjump.declare.fields import Need, number
from snapjump.sim.base import (
    HELD,
    ONE_AT_A_TIME,
    Progress,
    SceneOptions,
    check_samples,
)


class Bounce(SceneOptions):
    """Verification: one mass falls onto the barrier at a given speed and bounces off."""

    chooses = {"frame": "fixed", "friction": "none", "damping": "none"}
    needs = (Need("contact", "pushes"), HELD, ONE_AT_A_TIME)

    mass_kg: float = number(7.6e-7, above=0.0, unit="kg")
    speed_m_s: float = number(10.0, least=0.0, unit="m/s")
    duration_s: float = number(1.0e-4, above=0.0, unit="s")
    sample_interval_s: float = number(1.0e-7, above=0.0, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.duration_s, self.sample_interval_s)

    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        from snapjump.scenes.mass import simulate_bounce_scene

        return simulate_bounce_scene(simulation, progress)
