"""Everything that determines a dataset's numbers, in plain JSON; and back to what computes them."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from snapjump.checks import ParameterError, check_choice, check_group, check_integer
from snapjump.composition import Simulation
from snapjump.dataset.sealed import sha256_of
from snapjump.declare.inputs import with_inputs
from snapjump.families import DATASET_FAMILIES, FAMILIES, name_of
from snapjump.files.provenance import BEYOND_DATASETS, source_hash
from snapjump.options.plan import PlanOptions
from snapjump.plan.axes import Axis, recorded_axes
from snapjump.plan.base import Plan
from snapjump.scenes.sensitivities import check_differentiable
from snapjump.simulation import build, construct

FORMAT = 1  # of the files; another number for other columns or another hash
LARGEST_SHARD = 1_000_000
# Lanes, threads and the kind of processor change nothing to the last bit.
CPU = ("scalar", "lanes")


@dataclass(frozen=True)
class Specification:
    """``plain``: all of it as JSON; ``simulation``: that of its jumps, in the middle of the
    ``axes``, along which the designs of the ``plan`` differ."""

    plain: Mapping[str, Any]
    simulation: Simulation
    plan: Plan
    axes: tuple[Axis, ...]

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


def dataset_member(family: str, values: Any) -> Any:
    """Checked options of a plan or an executor, from its group. Raises ParameterError."""
    check_group(family, values)
    values = dict(values)
    name = values.pop("name", None)
    check_choice(family, name, tuple(DATASET_FAMILIES[family]))
    return construct(family, DATASET_FAMILIES[family][name], values)


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
    configured = build(config)
    options: PlanOptions = dataset_member("plan", config.get("plan"))
    axes = options.axes(configured)
    # What varies is no part of the configuration: a dataset is the same whatever it was there.
    middles = {axis.path: 0.5 * (axis.low + axis.high) for axis in axes}
    simulation = with_inputs(configured, middles)
    plan = options.member(tuple(axis.range for axis in axes))
    if not isinstance(sensitivities, bool):
        raise ParameterError("dataset.sensitivities", sensitivities, "true or false")
    if sensitivities:
        check_differentiable(simulation, [axis.path for axis in axes], "plan.inputs")
    families = [family for family in FAMILIES if family != "backend"]
    configuration = {
        part: {
            **({"name": simulation.name(part)} if part in FAMILIES else {}),
            **{
                name: value
                for name, value in asdict(getattr(simulation, part)).items()
                if f"{part}.{name}" not in middles
            },
        }
        for part in ("robot", "design", "environment", *families)
    }
    backend = simulation.name("backend")
    plain = {
        "format": FORMAT,
        "plan": {"name": name_of("plan", options), **options.settings},
        "inputs": [asdict(axis) for axis in axes],
        "shard_size": shard_size,
        "sensitivities": sensitivities,
        "configuration": {
            "accuracy": {"name": simulation.accuracy},
            **configuration,
        },
        "processor": "cpu" if backend in CPU else backend,
        "source_sha256": source_hash(BEYOND_DATASETS),
    }
    plain = json.loads(json.dumps(plain))  # tuples become lists, as in the files
    return Specification(plain, simulation, plan, axes)


def restored(plain: Mapping[str, Any], backend: Mapping[str, Any]) -> Specification:
    """The specification that a plain one came from, to be computed by a backend."""
    axes = recorded_axes(plain)
    given = {axis.path: list(axis.range) for axis in axes}
    plan = {**plain["plan"], "inputs": given}
    config = {**plain["configuration"], "plan": plan, "backend": backend}
    for axis in axes:
        group, _, name = axis.path.partition(".")
        config[group] = {**config[group], name: 0.5 * (axis.low + axis.high)}
    return specify(config, plain["shard_size"], plain["sensitivities"])


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
