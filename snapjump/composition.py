"""A simulation as its parts: one option object of each family, checked against each other."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any

from snapjump.backend.base import BackendOptions
from snapjump.checks import ParameterError, check_choice
from snapjump.contact.base import ContactOptions
from snapjump.damping.base import DampingOptions
from snapjump.declare.families import FAMILIES
from snapjump.declare.fields import Need, Part, construct
from snapjump.declare.inputs import inputs_of
from snapjump.declare.members import make_member, member_group, members_with
from snapjump.declare.scenes import SceneOptions
from snapjump.discretization.base import DiscretizationOptions
from snapjump.drag.base import DragOptions
from snapjump.drive.base import DriveOptions
from snapjump.frame.base import FrameOptions
from snapjump.friction.base import FrictionOptions
from snapjump.integrator.base import IntegratorOptions
from snapjump.robot.design import Design
from snapjump.robot.environment import Environment
from snapjump.robot.other_units import in_own_units
from snapjump.robot.robot import Robot
from snapjump.stepping.base import SteppingOptions
from snapjump.tiers import TIERS

# Members that neither a tier nor a scene chooses.
DEFAULTS = {
    "sim": "jump",
    "discretization": "der",
    "frame": "rigid",
    "drive": "constant_rate",
    "contact": "logbarrier",
    "drag": "none",
    "backend": "scalar",
}
CHOSEN: Any = None  # by the accuracy tier, or by the scene
# Parts that are no family: there is one kind of each.
PLAIN: Mapping[str, Any] = {"robot": Robot, "design": Design, "environment": Environment}


@dataclass(frozen=True)
class Simulation:
    """Everything that determines a simulation. Raises ParameterError where parts do not fit.

    A part that is left out is chosen by the scene or the accuracy tier, and a field of a part that
    is left out, where the tier has a value for it, by the tier. A part may be the name of a member,
    or a group: a mapping of ``name`` and fields.
    """

    sim: SceneOptions = CHOSEN
    robot: Robot = Robot()
    design: Design = Design()
    environment: Environment = Environment()
    discretization: DiscretizationOptions = CHOSEN
    frame: FrameOptions = CHOSEN
    drive: DriveOptions = CHOSEN
    contact: ContactOptions = CHOSEN
    friction: FrictionOptions = CHOSEN
    damping: DampingOptions = CHOSEN
    drag: DragOptions = CHOSEN
    integrator: IntegratorOptions = CHOSEN
    stepping: SteppingOptions = CHOSEN
    backend: BackendOptions = CHOSEN
    accuracy: str = "standard"

    def __post_init__(self) -> None:
        check_choice("accuracy", self.accuracy, tuple(TIERS))
        tier = TIERS[self.accuracy]
        chosen = {**DEFAULTS, **tier.members}
        for group, kind in PLAIN.items():
            part = getattr(self, group)
            if isinstance(part, Mapping):
                given = {f"{group}.{key}" for key in part}
                part = in_own_units({group: part}, given, self.robot)[group]
                object.__setattr__(self, group, construct(group, kind, part))
            elif not isinstance(part, kind):
                allowed = f"a {kind.__name__}, or a mapping of its fields"
                raise ParameterError(group, part, allowed)
        for family in FAMILIES:
            part = getattr(self, family)
            if part is None or isinstance(part, str):
                part = make_member(family, {"name": part or chosen[family]})
            elif isinstance(part, Mapping):
                part = make_member(family, {"name": chosen[family], **part})
            elif getattr(part, "group", None) != family:
                allowed = f"the name of a member of {family}, a group with one, or its options"
                raise ParameterError(family, part, allowed)
            part = part.with_defaults(tier.numbers_of(family))
            object.__setattr__(self, family, part)
            if family == "sim":
                chosen |= part.chooses
        for part in self.parts:
            for need in part.needs:
                self._check(part, need)
            part.check_with(self)

    @property
    def parts(self) -> tuple[Part, ...]:
        """One of each family."""
        return tuple(getattr(self, family) for family in FAMILIES)

    @property
    def configuration(self) -> dict[str, Any]:
        """The nested groups that :func:`snapjump.simulation.build` makes it of, in full."""
        plain = {group: asdict(getattr(self, group)) for group in PLAIN}
        members = {part.group: member_group(part) for part in self.parts}
        return {"accuracy": {"name": self.accuracy}, **plain, **members}

    def _check(self, part: Part, need: Need) -> None:
        """Raises ParameterError where another part lacks what one needs."""
        other = getattr(self, need.family)
        if getattr(other, need.capability):
            return
        able = " or ".join(members_with(need.family, need.capability))
        why = f", {need.why}" if need.why else ""
        raise ParameterError(need.family, other.name, f"{able} with {part.group}={part.name}{why}")


def with_tier(name: str, **parts: Any) -> Simulation:
    """A jump at an accuracy tier; explicit parts win over the tier's choice.
    Raises ParameterError for a part that there is not, and says where a number belongs."""
    known = [field.name for field in fields(Simulation) if field.name != "accuracy"]
    for key, value in parts.items():
        if key not in known:
            paths = [path for path in inputs_of({**dict.fromkeys(FAMILIES), **PLAIN})
                     if path.rpartition(".")[2] in (key, f"{key}_m")]  # fmt: skip
            meant = f"did you mean {', '.join(paths)}? " if paths else ""
            raise ParameterError(key, value, f"{meant}one of {', '.join(known)}")
    return Simulation(**{**parts, "accuracy": name})
