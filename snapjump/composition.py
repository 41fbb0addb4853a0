"""A simulation as its parts: one option object of each family, checked against each other."""

from dataclasses import dataclass, field
from typing import Any

from snapjump.accuracy import TIERS
from snapjump.checks import ParameterError, check_choice
from snapjump.families import FAMILIES, name_of
from snapjump.parameters.design import Design
from snapjump.parameters.environment import Environment
from snapjump.parameters.robot import Robot


@dataclass(frozen=True)
class Simulation:
    """Everything that determines a result. Raises ParameterError where parts do not fit."""

    sim: Any = field(default_factory=FAMILIES["sim"]["jump"])
    robot: Robot = field(default_factory=Robot)
    design: Design = field(default_factory=Design)
    environment: Environment = field(default_factory=Environment)
    discretization: Any = field(default_factory=FAMILIES["discretization"]["der"])
    frame: Any = field(default_factory=FAMILIES["frame"]["rigid"])
    contact: Any = field(default_factory=FAMILIES["contact"]["logbarrier"])
    friction: Any = field(default_factory=FAMILIES["friction"]["implicit"])
    damping: Any = field(default_factory=FAMILIES["damping"]["kelvin_voigt"])
    integrator: Any = field(default_factory=FAMILIES["integrator"]["tr_bdf2"])
    stepping: Any = field(default_factory=FAMILIES["stepping"]["adaptive"])
    linear_solver: Any = field(default_factory=FAMILIES["linear_solver"]["banded"])
    backend: Any = field(default_factory=FAMILIES["backend"]["scalar"])
    accuracy: str = "standard"

    def __post_init__(self) -> None:
        check_choice("accuracy.name", self.accuracy, tuple(TIERS))
        scene = self.scene_name
        if scene == "jump":
            self._require("frame", ("rigid", "elastic"))
            if self.name("frame") == "elastic" and self.name("discretization") != "der":
                raise ParameterError(
                    "discretization",
                    self.name("discretization"),
                    "der with frame=elastic, whose mounts have no angle for nodes that turn",
                )
            self._require("contact", ("logbarrier",))
            self.environment.mass_kg(self.robot)
        if scene in ("snap", "static", "cantilever"):
            self._require("contact", ("none",))
            self._require("friction", ("none",))
            self._require("frame", ("fixed",))
        if scene in ("bounce", "slide"):
            self._require("contact", ("logbarrier",))
            self._require("frame", ("fixed",))

        if scene != "jump":
            self._require("backend", ("scalar",))

    def _require(self, family: str, names: tuple[str, ...]) -> None:
        if self.name(family) not in names:
            raise ParameterError(
                family, self.name(family), f"{' or '.join(names)} with sim={self.scene_name}"
            )

    def name(self, family: str) -> str:
        """The member's name in a family, as on the command line."""
        return name_of(family, getattr(self, family))

    @property
    def scene_name(self) -> str:
        return self.name("sim")


def with_tier(name: str, **parts: Any) -> Simulation:
    """A jump at an accuracy tier; explicit parts win over the tier's choice."""
    check_choice("accuracy", name, tuple(TIERS))
    tier = TIERS[name]
    stepping = (
        {"step_s": tier.step_s}
        if tier.stepping == "fixed"
        else {"tolerance": tier.tolerance, "contact_steps": tier.contact_steps}
    )
    chosen: dict[str, Any] = {
        "sim": FAMILIES["sim"]["jump"](start_fraction=tier.start_fraction),
        "discretization": FAMILIES["discretization"]["der"](
            elements=tier.elements, clamp=tier.clamp
        ),
        "contact": FAMILIES["contact"]["logbarrier"](weighting=tier.weighting),
        "friction": FAMILIES["friction"][tier.friction](),
        "damping": FAMILIES["damping"][tier.damping](),
        "integrator": FAMILIES["integrator"][tier.integrator](),
        "stepping": FAMILIES["stepping"][tier.stepping](**stepping),
        "accuracy": name,
    }
    return Simulation(**(chosen | parts))
