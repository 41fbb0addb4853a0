"""``surrogate=rbf``: interpolation between the nearest jumps, as a measure for networks."""

from functools import cached_property
from typing import Any

import torch
from numpy.linalg import LinAlgError
from scipy.interpolate import RBFInterpolator
from torch import Tensor

from snapjump.checks import ParameterError
from snapjump.declare.fields import choice, integer, number
from snapjump.surrogate.base import FOUR, OUTPUTS, Inputs, MassScaled, Rows, SurrogateOptions

KERNELS = ("linear", "thin_plate_spline", "cubic")


class RbfOptions(SurrogateOptions):
    """Radial basis functions through the nearest jumps: no network."""

    # A polynomial of degree 1 goes with the kernels: five coefficients in four inputs.
    neighbours: int = integer(120, least=5, most=4096)
    kernel: str = choice("cubic", KERNELS)
    smoothing: float = number(0.0, least=0.0, most=1e6)

    def network(self, inputs: Inputs = FOUR) -> "Rbf":
        return Rbf(self, inputs)


class Rbf(MassScaled):
    """All training jumps are its buffers: ``points`` (N, I) and ``values`` (N, 2), standardised."""

    by_descent = False
    differentiable = False
    points: Tensor
    values: Tensor

    def __init__(self, options: RbfOptions, inputs: Inputs = FOUR):
        super().__init__(inputs)
        self.options = options
        self.register_buffer("points", torch.empty(0, inputs.columns))
        self.register_buffer("values", torch.empty(0, OUTPUTS))
        self.register_load_state_dict_pre_hook(_make_room)

    @cached_property
    def interpolator(self) -> Any:
        """Scipy's, which solves a small system of equations for every design."""
        options = self.options
        return RBFInterpolator(
            self.points.numpy(),
            self.values.numpy(),
            neighbors=min(options.neighbours, len(self.points)),
            smoothing=options.smoothing,
            kernel=options.kernel,
        )

    def forward(self, designs: Tensor) -> Tensor:
        if not len(designs):
            return designs[:, :OUTPUTS]
        try:
            learned = self.interpolator(self.scaled(designs).numpy())
        except LinAlgError:
            allowed = "more, for the nearest jumps of some designs lie in one plane"
            raise ParameterError("surrogate.neighbours", self.options.neighbours, allowed) from None
        return self.apexes(torch.from_numpy(learned).to(designs.dtype), designs)

    def fit(self, rows: Rows) -> None:
        super().fit(rows)
        self.points = self.scaled(rows.designs)
        self.values = self.outputs(rows.apexes * self.masses(rows.designs))


def _make_room(network: Rbf, state: dict[str, Any], prefix: str, *others: Any) -> None:
    """There are as many points in a checkpoint as were learned from."""
    for name in ("points", "values"):
        there = state.get(prefix + name)
        if there is not None:
            setattr(network, name, torch.empty_like(there))
