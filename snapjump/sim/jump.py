"""``sim=jump``: the whole jump: snap, strike, lift-off and ballistic apex."""

from typing import Any

from snapjump.declare.fields import Need, number
from snapjump.sim.base import (
    Progress,
    SceneOptions,
    check_samples,
)


class Jump(SceneOptions):
    """The whole jump: snap, strike, lift-off and ballistic apex.

    The motion starts at ``start_fraction`` of the symmetric arch's critical angle from the static
    solution; ``time_limit_s`` counts from there. States are kept ``sample_interval_s`` apart.
    """

    moves_a_beam = True
    needs = (Need("frame", "flies"), Need("contact", "pushes"))

    start_fraction: float = number(0.85, least=0.0, most=0.95)
    time_limit_s: float = number(0.1, above=0.0, unit="s")
    sample_interval_s: float = number(2.0e-5, above=1e-7, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_samples(self.time_limit_s, self.sample_interval_s)

    def check_with(self, simulation: Any) -> None:
        simulation.environment.mass_kg(simulation.robot)

    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        from snapjump.scenes.jump import simulate_jump_scene

        return simulate_jump_scene(simulation, progress)
