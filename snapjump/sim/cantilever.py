"""``sim=cantilever``: verification: a cantilever bent by a force (in EI/L^2) across its tip."""

from typing import Any

from snapjump.declare.fields import number
from snapjump.sim.base import (
    AT_REST,
    HELD,
    NO_GROUND,
    ONE_AT_A_TIME,
    Progress,
    SceneOptions,
)


class Cantilever(SceneOptions):
    """Verification: a cantilever bent by a force (in EI/L^2) across its tip."""

    chooses = AT_REST
    needs = (*NO_GROUND, HELD, ONE_AT_A_TIME)

    load_bar: float = number(1.0, least=-20.0, most=20.0, unit="EI/L^2")

    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        from snapjump.scenes.cantilever import simulate_cantilever_scene

        return simulate_cantilever_scene(simulation, progress)
