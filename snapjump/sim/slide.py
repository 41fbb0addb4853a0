"""``sim=slide``: verification: one mass slides on the ground until friction stops it."""

from typing import Any

from snapjump.declare.fields import Need, number
from snapjump.sim.base import (
    HELD,
    ONE_AT_A_TIME,
    Progress,
    SceneOptions,
    check_samples,
)


class Slide(SceneOptions):
    """Verification: one mass slides on the ground until friction stops it.

    ``incline`` is the tangent of the slope down which gravity also pulls.
    """

    chooses = {"frame": "fixed", "friction": "implicit", "damping": "none"}
    needs = (Need("contact", "pushes"), HELD, ONE_AT_A_TIME)

    mass_kg: float = number(4.0e-3, above=0.0, unit="kg")
    speed_m_s: float = number(0.1, least=0.0, unit="m/s")
    duration_s: float = number(0.05, above=0.0, unit="s")
    incline: float = number(0.0, least=0.0, most=1.0)
    sample_interval_s: float = number(1.0e-5, above=0.0, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.duration_s, self.sample_interval_s)

    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        from snapjump.scenes.mass import simulate_slide_scene

        return simulate_slide_scene(simulation, progress)
