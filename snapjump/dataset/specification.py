"""Everything that determines a dataset's numbers, in plain JSON; and back to what computes them."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from snapjump.checks import ParameterError, check_choice, check_group, check_integer
from snapjump.composition import Simulation
from snapjump.dataset.sealed import sha256_of
from snapjump.declare.fields import construct
from snapjump.declare.members import member_group
from snapjump.files.provenance import BEYOND_DATASETS, source_hash
from snapjump.options.plan import PLANS
from snapjump.parameters.environment import Environment
from snapjump.plan.base import Plan
from snapjump.scenes.sensitivities import check_differentiable
from snapjump.simulation import build

FORMAT = 1  # of the files; another number for another hash. Columns are told by each file
LARGEST_SHARD = 1_000_000


@dataclass(frozen=True)
class Specification:
    """``plain``: all of it as JSON; ``simulation``: that of its jumps, but for the design."""

    plain: Mapping[str, Any]
    simulation: Simulation
    plan: Plan
    ranges: tuple[tuple[float, float], ...]

    @property
    def sha256(self) -> str:
        """Of everything, sources included: what one folder holds."""
        return sha256_of(self.plain)

    @property
    def shard_size(self) -> int:
        return int(self.plain["shard_size"])

    @property
    def sensitivities(self) -> bool:
        """Whether rows have the derivatives of their apexes."""
        return bool(self.plain["sensitivities"])

    @property
    def shards(self) -> int:
        return -(-self.plan.count // self.shard_size)

    def stretch(self, shard: int) -> tuple[int, int]:
        """First design of a shard, and the one after its last."""
        first = shard * self.shard_size
        return first, min(first + self.shard_size, self.plan.count)


def plan_of(values: Any) -> Any:
    """Checked options of a plan, from its group. Raises ParameterError."""
    check_group("plan", values)
    values = dict(values)
    name = values.pop("name", None)
    check_choice("plan", name, tuple(PLANS))
    return construct("plan", PLANS[name], values)


def plan_name(options: Any) -> str:
    """The name of a plan."""
    return next(name for name, cls in PLANS.items() if cls is type(options))


def specify(
    config: Mapping[str, Any], shard_size: int, sensitivities: bool = False
) -> Specification:
    """The specification of a configuration's dataset.

    ``config``: groups as for :func:`snapjump.simulation.build`, and ``plan``. Raises
    ParameterError for what no design of the plan could be simulated with.
    """
    check_integer("dataset.shard_size", shard_size, 1, LARGEST_SHARD)
    scene = (config.get("sim") or {}).get("name", "jump")
    if scene != "jump":
        raise ParameterError("sim", scene, "jump, which is what datasets are of")
    simulation = build({**config, "design": {}, "environment": {}})
    if not isinstance(sensitivities, bool):
        raise ParameterError("dataset.sensitivities", sensitivities, "true or false")
    if sensitivities:
        check_differentiable(simulation)
    options = plan_of(config.get("plan"))
    check_lightest(simulation, options)
    configuration = {p.group: member_group(p) for p in simulation.parts if p.group != "backend"}
    plain = {
        "format": FORMAT,
        "plan": {"name": plan_name(options), **asdict(options)},
        "shard_size": shard_size,
        "sensitivities": sensitivities,
        "configuration": {
            "accuracy": {"name": simulation.accuracy},
            "robot": asdict(simulation.robot),
            **configuration,
        },
        "processor": simulation.backend.processor,
        "source_sha256": source_hash(BEYOND_DATASETS),
    }
    plain = json.loads(json.dumps(plain))  # tuples become lists, as in the files
    return Specification(plain, simulation, options.member(), options.ranges)


def restored(plain: Mapping[str, Any], backend: Mapping[str, Any]) -> Specification:
    """The specification that a plain one came from, to be computed by a backend."""
    config = {**plain["configuration"], "plan": plain["plan"], "backend": backend}
    return specify(config, plain["shard_size"], plain["sensitivities"])


def check_lightest(simulation: Simulation, options: Any) -> None:
    """Raise ParameterError for a range that has robots lighter than their beams."""
    try:
        Environment(mass_bar=options.mass_bar[0]).mass_kg(simulation.robot)
    except ParameterError as error:
        if error.key != "environment.mass_bar":
            raise
        raise ParameterError("plan.mass_bar", list(options.mass_bar), error.allowed) from None


def first_difference(ours: Any, theirs: Any, key: str = "") -> tuple[str, Any, Any] | None:
    """The first key that two plain values differ in, with both of its values."""
    if isinstance(ours, Mapping) and isinstance(theirs, Mapping):
        for name in dict.fromkeys([*ours, *theirs]):
            found = first_difference(
                ours.get(name), theirs.get(name), f"{key}.{name}" if key else name
            )
            if found is not None:
                return found
        return None
    return None if ours == theirs else (key, ours, theirs)
