"""A simulation as its parts: one option object of each family, checked against each other."""

from dataclasses import dataclass, field
from typing import Any

from snapjump.accuracy import TIERS
from snapjump.checks import ParameterError, check_choice
from snapjump.families import FAMILIES, name_of
from snapjump.parameters.design import Design
from snapjump.parameters.environment import Environment
from snapjump.parameters.robot import Robot

LAWS = ("logbarrier", "penalty", "hunt_crossley", "signorini")
SMALLEST_EXPLICIT_STEP_S = 5.0e-9


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
            self._require("contact", LAWS)
            self.environment.mass_kg(self.robot)
        if scene in ("snap", "static", "cantilever"):
            self._require("contact", ("none",))
            self._require("friction", ("none",))
            self._require("frame", ("fixed",))
        if scene in ("bounce", "slide"):
            self._require("contact", LAWS)
            self._require("frame", ("fixed",))

        if scene != "jump":
            self._require("backend", ("scalar",))
        if self.name("contact") == "signorini":
            self._check_signorini()
        if self.name("integrator") == "central_difference":
            self._check_explicit_damping()

    def _require(self, family: str, names: tuple[str, ...]) -> None:
        if self.name(family) not in names:
            raise ParameterError(
                family, self.name(family), f"{' or '.join(names)} with sim={self.scene_name}"
            )

    def _check_signorini(self) -> None:
        if self.name("integrator") != "implicit_euler":
            raise ParameterError(
                "integrator",
                self.name("integrator"),
                "implicit_euler with contact=signorini, whose impact law is one of velocities "
                "between the ends of a step",
            )
        if self.name("friction") == "lagged":
            raise ParameterError(
                "friction",
                "lagged",
                "implicit or none with contact=signorini, whose force is not one of the position "
                "a step ago",
            )

    def _check_explicit_damping(self) -> None:
        """Material damping stiffens the stretching so much that explicit steps lead nowhere."""
        if self.name("frame") == "elastic":
            raise ParameterError(
                "frame",
                "elastic",
                "rigid with integrator=central_difference, whose stable step an elastic frame's "
                "short stiff elements would make hopeless",
            )
        eta = getattr(self.damping, "relaxation_time_s", 0.0)
        if self.scene_name not in ("jump", "snap") or eta == 0.0:
            return
        robot, scales = self.robot, self.robot.scales
        rate = 2.0 * self.discretization.elements * robot.stretching_stiffness_bar**0.5
        step_s = 2.0 * scales.time_s**2 / (eta * rate**2)
        if step_s < SMALLEST_EXPLICIT_STEP_S:
            raise ParameterError(
                "damping",
                self.name("damping"),
                f"none or mass_proportional with integrator=central_difference, which needs steps "
                f"of {step_s:.1g} s for damping.relaxation_time_s = {eta:g} at this mesh (at "
                f"least {SMALLEST_EXPLICIT_STEP_S:g} s)",
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
