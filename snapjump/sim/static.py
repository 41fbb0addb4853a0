"""``sim=static``: slow loading: branches, stability, critical angle and snapped state."""

from typing import Any

from snapjump.declare.fields import integer
from snapjump.sim.base import (
    AT_REST,
    HELD,
    NO_GROUND,
    ONE_AT_A_TIME,
    Progress,
    SceneOptions,
)


class Static(SceneOptions):
    """Slow loading: branches, stability, critical angle and snapped state.

    ``steps``: points along each branch.
    """

    chooses = AT_REST
    needs = (*NO_GROUND, HELD, ONE_AT_A_TIME)

    steps: int = integer(120, least=10, most=100_000)

    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        from snapjump.scenes.static import simulate_static_scene

        return simulate_static_scene(simulation, progress)
