"""The specification of a dataset: all that determines its numbers, to plain JSON and back."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from snapjump.batch.loads import check_outputs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.dataset.options import DatasetOptions
from snapjump.declare.inputs import with_inputs
from snapjump.declare.members import make_member
from snapjump.files.provenance import BEYOND_DATASETS, source_hash
from snapjump.files.sealed import sha256_of
from snapjump.plan.base import Plan, PlanOptions
from snapjump.plan.parts.axes import Axis, recorded_axes
from snapjump.scenes.sensitivities import check_differentiable
from snapjump.simulation import build

FORMAT = 1  # of the files; another number for another hash. Columns are told by each file


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
        return bool(self.plain["sensitivities"])

    @property
    def outputs(self) -> list[str]:
        """Names of outputs beside those of all jumps."""
        return list(self.plain.get("outputs", ()))

    @property
    def shards(self) -> int:
        return -(-self.plan.count // self.shard_size)

    def stretch(self, shard: int) -> tuple[int, int]:
        """First design of a shard, and the one after its last."""
        first = shard * self.shard_size
        return first, min(first + self.shard_size, self.plan.count)


def specify(
    config: Mapping[str, Any],
    shard_size: int,
    sensitivities: bool = False,
    outputs: Sequence[str] = (),
) -> Specification:
    """The specification of a configuration's dataset.

    ``config``: groups as for :func:`snapjump.simulation.build`, and ``plan``. Raises
    ParameterError for what no design of the plan could be simulated with.
    """
    given = DatasetOptions(sensitivities=sensitivities, shard_size=shard_size)
    scene = (config.get("sim") or {}).get("name", "jump")
    if scene != "jump":
        raise ParameterError("sim", scene, "jump, which is what datasets are of")
    configured = build(config)
    options: PlanOptions = make_member("plan", config.get("plan"))
    axes = options.axes(configured)
    # What varies is no part of the configuration: a dataset is the same whatever it was there.
    middles = {axis.path: 0.5 * (axis.low + axis.high) for axis in axes}
    simulation = with_inputs(configured, middles)
    plan = options.plan(tuple(axis.range for axis in axes))
    asked = check_outputs(simulation, outputs, sensitivities, "dataset.outputs")
    if given.sensitivities:
        check_differentiable(simulation, [axis.path for axis in axes], "plan.inputs")
    configuration = {
        group: {key: v for key, v in values.items() if f"{group}.{key}" not in middles}
        for group, values in simulation.configuration.items()
        if group != "backend"
    }
    plain = {
        "format": FORMAT,
        "plan": {"name": options.name, **options.settings},
        "inputs": [asdict(axis) for axis in axes],
        "shard_size": given.shard_size,
        "sensitivities": given.sensitivities,
        "configuration": configuration,
        "processor": simulation.backend.processor,
        "source_sha256": source_hash(BEYOND_DATASETS),
    }
    if asked:  # without any a dataset is the one that it was before there were any
        plain["outputs"] = asked
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
    return specify(config, plain["shard_size"], plain["sensitivities"], plain.get("outputs", ()))


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
