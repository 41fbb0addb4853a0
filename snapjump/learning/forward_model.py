"""A trained forward model to ask: numpy in, numpy out, and nothing outside of what it has seen."""

import json
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor

from snapjump.arrays import Array
from snapjump.checks import ParameterError, of_ours
from snapjump.composition import DEFAULTS, Simulation
from snapjump.dataset.specification import first_difference
from snapjump.declare.families import FAMILIES
from snapjump.declare.former_options import with_present_options
from snapjump.declare.inputs import PARTS
from snapjump.declare.tables import rows_of
from snapjump.learning import STANDARD
from snapjump.learning.checkpoint import read_checkpoint
from snapjump.learning.threads import torch_threads
from snapjump.plan.parts.axes import Range, recorded_axes
from snapjump.surrogate.base import Surrogate

CHUNK = 4096  # designs at a time, so that their activations stay in the processor's cache
ROUNDING = 1e-9  # of a range: how far beyond its end a design may lie
DIFFERENCE = 1e-3  # of a range: step of the slopes of networks that torch cannot differentiate


class ForwardModel:
    """Satisfies :class:`snapjump.inverse.base.ForwardModel`. Designs (N, I) are columns of its
    ``axes``, by default delta_alpha (rad), epsilon, mass_bar, mu, or a DataFrame with columns of
    these names; apexes in L.

    ``about``: what the checkpoint says of it. Methods raise ParameterError, naming the column, for
    designs that are outside of the training ranges or no numbers.
    """

    def __init__(self, network: Surrogate, about: dict[str, Any]):
        self.network, self.about = network, about
        self.axes = recorded_axes(about)
        self._low, self._high = np.array(self.ranges, dtype=float).T

    @property
    def ranges(self) -> tuple[Range, ...]:
        """The box of the designs that it was trained on."""
        return tuple(axis.range for axis in self.axes)

    def predict(self, designs: Array) -> Array:
        """Apexes (N, 2)."""
        with torch.inference_mode():
            return _joined(self._asked(self.network, designs))

    def half_widths(self, designs: Array) -> Array | None:
        """Half widths (N, 2) of intervals that hold 90 % of the apexes; None if it has none."""
        with torch.inference_mode():
            found = self._asked(self.network.half_widths, designs)
            return None if found[0] is None else _joined(found)

    def jacobian(self, designs: Array) -> Array:
        """Derivatives (N, 2, I) of the apexes by the design."""
        if not self.network.differentiable:
            return self._differences(self._checked(designs))
        return _joined(self._asked(self._slopes, designs))

    def check_model(self, simulation: Simulation) -> None:
        """Raise ParameterError if a simulation has another physical model than the dataset had.
        Mesh, integrator and step control may differ: they are errors, and no other robot."""
        kept = self.about["dataset"]["specification"]["configuration"]
        configuration = with_present_options(kept)
        inputs = {axis.path for axis in self.axes}
        given: dict[str, Any] = {"sim": simulation.sim.name}
        learned: dict[str, Any] = {"sim": configuration["sim"]["name"]}
        for part in PARTS:
            known = configuration.get(part, {})
            if part in FAMILIES:
                # A family that there was not yet had what is its default.
                given[part] = getattr(simulation, part).name
                learned[part] = known.get("name", DEFAULTS.get(part))
            for field in fields(getattr(simulation, part)):
                path = f"{part}.{field.name}"
                if path not in inputs:
                    given[path] = getattr(getattr(simulation, part), field.name)
                    # What the dataset had no field for was as it is by default.
                    learned[path] = known.get(field.name, field.default)
        # Tuples become lists, as in the checkpoint.
        found = first_difference(json.loads(json.dumps(given)), learned)
        if found is not None:
            key, ours, theirs = found
            raise ParameterError(key, ours, f"{theirs!r}, which the forward model was trained with")

    def _asked(self, function: Callable[[Tensor], Any], designs: Array) -> list[Any]:
        """Values of a function of designs, chunk by chunk."""
        given = torch.from_numpy(self._checked(designs)).to(self.network.inputs.mean.dtype)
        with torch_threads():
            return [function(chunk) for chunk in given.split(CHUNK)]

    def _slopes(self, designs: Tensor) -> Tensor:
        designs = designs.clone().requires_grad_()
        return self.network.slopes(self.network(designs), designs)

    def _differences(self, designs: Array) -> Array:
        """Central ones, one-sided at the ends of the ranges."""
        step = DIFFERENCE * (self._high - self._low)
        columns = []
        for axis in range(len(self.axes)):
            ahead, behind = designs.copy(), designs.copy()
            ahead[:, axis] = np.minimum(designs[:, axis] + step[axis], self._high[axis])
            behind[:, axis] = np.maximum(designs[:, axis] - step[axis], self._low[axis])
            width = (ahead - behind)[:, axis, None]
            columns.append((self.predict(ahead) - self.predict(behind)) / width)
        return np.stack(columns, axis=2)

    def _checked(self, designs: Array) -> Array:
        """Designs that may be asked, as an array."""
        designs = rows_of(designs, self.axes)
        slack = ROUNDING * (self._high - self._low)
        inside = (designs >= self._low - slack) & (designs <= self._high + slack)
        if not inside.all():
            row, axis = np.argwhere(~inside)[0]
            low, high = self._low[axis], self._high[axis]
            allowed = f"a number in [{low:g}, {high:g}], where the forward model was trained"
            raise ParameterError(self.axes[axis].column, float(designs[row, axis]), allowed)
        return designs


def _joined(chunks: list[Tensor]) -> Array:
    return torch.cat(chunks).numpy().astype(float)


def forward_model(checkpoint: str | Path = "standard") -> ForwardModel:
    """The forward model of a checkpoint: ``standard``, which comes along, or a file that task=train
    left. Raises ParameterError for what is none."""

    def refused(reason: str) -> ParameterError:
        return ParameterError("checkpoint", str(checkpoint), f"a forward model: {reason}")

    network, about = read_checkpoint(STANDARD if checkpoint == STANDARD.stem else checkpoint)
    with of_ours(refused):
        model = ForwardModel(network, about)
        dataset = about["dataset"]
        told = (dataset["sha256"], dataset["specification"]["configuration"]["accuracy"]["name"])
        if not all(isinstance(word, str) for word in told):
            raise refused("it does not name its dataset")
        middle = np.mean(model.ranges, axis=1)[None, :]
        if not np.isfinite([model.predict(middle), model.jacobian(middle)[:, :, 0]]).all():
            raise refused("what it predicts is not finite")
    return model
