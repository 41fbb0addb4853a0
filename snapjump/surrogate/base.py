"""The contract of a surrogate: the apex of a jump from its design and environment, learned.

A member's module has its options, with a method ``network()``, and the :class:`Surrogate` which
that returns. Everything a surrogate has learned is in its parameters and buffers, so that
safetensors hold all of it. Designs are columns of inputs, by default delta_alpha (rad), epsilon,
mass_bar, mu; apexes are x_bar, y_bar in L.
"""

from abc import ABC, abstractmethod
from typing import ClassVar, NamedTuple

import torch
from torch import Tensor, nn

from snapjump.declare.fields import Part, required

OUTPUTS = 2


class Inputs(NamedTuple):
    """The number of columns of designs, and which is mass_bar (None: it does not vary)."""

    columns: int = 4
    mass: int | None = 2


FOUR = Inputs()


class Rows(NamedTuple):
    """Jumps to learn from: designs (N, I), apexes (N, 2), and their derivatives (N, 2, I) by the
    design, NaN where there are none."""

    designs: Tensor
    apexes: Tensor
    slopes: Tensor


class SurrogateOptions(Part):
    """A surrogate and its numbers."""

    group = "surrogate"

    @required
    def network(self, inputs: Inputs = FOUR) -> "Surrogate":
        """A new surrogate, which has learned nothing yet; torch's generator seeds it."""
        raise NotImplementedError


class Standardisation(nn.Module):
    """Mean and standard deviation of ``size`` quantities, kept as buffers."""

    mean: Tensor
    deviation: Tensor

    def __init__(self, size: int):
        super().__init__()
        self.register_buffer("mean", torch.zeros(size))
        self.register_buffer("deviation", torch.ones(size))

    def fit(self, values: Tensor) -> None:
        """Take them from values (N, size); a quantity that does not vary is only shifted."""
        values = values.double()
        deviation = values.std(dim=0)
        self.mean.copy_(values.mean(dim=0))
        self.deviation.copy_(torch.where(deviation > 0.0, deviation, 1.0))

    def forward(self, values: Tensor) -> Tensor:
        """Mean 0, standard deviation 1."""
        return (values - self.mean) / self.deviation

    def inverse(self, values: Tensor) -> Tensor:
        """Back in their own units."""
        return values * self.deviation + self.mean


class Surrogate(nn.Module, ABC):
    """A forward model (N, I) -> (N, 2), with its standardisation inside.

    ``by_descent``: whether it is trained by gradient descent; otherwise ``fit`` does all of it.
    ``needs_slopes``: whether it learns from derivatives as well, and needs a dataset that has them.
    ``differentiable``: whether it is made of torch's operations, which slopes and ONNX need.
    """

    by_descent: ClassVar[bool] = True
    needs_slopes: ClassVar[bool] = False
    differentiable: ClassVar[bool] = True

    def __init__(self, inputs: Inputs = FOUR) -> None:
        super().__init__()
        self.inputs = Standardisation(inputs.columns)
        self.outputs = Standardisation(OUTPUTS)

    @abstractmethod
    def forward(self, designs: Tensor) -> Tensor:
        """Apexes (N, 2) in L of designs (N, I)."""

    def fit(self, rows: Rows) -> None:
        """Take the standardisation, or everything, from the jumps of the training set."""
        self.inputs.fit(rows.designs)
        self.outputs.fit(rows.apexes)

    def slopes(self, apexes: Tensor, designs: Tensor, create_graph: bool = False) -> Tensor:
        """Derivatives (N, 2, I) of apexes by their designs, which do not see each other: one pass
        serves all."""
        grad = torch.autograd.grad
        grads = [grad(one.sum(), designs, None, True, create_graph) for one in apexes.T]
        return torch.stack([found for (found,) in grads], dim=1)

    def loss(self, rows: Rows) -> Tensor:
        """The loss of descent: by default the mean absolute error in standard deviations."""
        error = self(rows.designs) - rows.apexes
        return (error / self.outputs.deviation).abs().mean()

    def calibrate(self, rows: Rows) -> None:
        """Fit the intervals to jumps that were not learned from; does nothing without intervals."""

    def half_widths(self, designs: Tensor) -> Tensor | None:
        """Half widths (N, 2) in L of intervals that hold 90 % of the apexes; None if unknown."""
        return None


class MassScaled(Surrogate):
    """One that learns apex times mass_bar as a function of log(mass_bar).

    A robot that stores the energy E jumps to about E/(m g): what is left to learn hardly depends
    on the mass. ``spread``: standard deviations of the apexes, which the loss is measured in.
    Where mass_bar does not vary, it learns the apex as it is.
    """

    spread: Tensor

    def __init__(self, inputs: Inputs = FOUR) -> None:
        super().__init__(inputs)
        self.mass = inputs.mass
        self.register_buffer("spread", torch.ones(OUTPUTS))

    def scaled(self, designs: Tensor) -> Tensor:
        """Standardised inputs (N, I), with log(mass_bar)."""
        return self.inputs(self._with_log_mass(designs))

    def apexes(self, learned: Tensor, designs: Tensor) -> Tensor:
        """Apexes (..., N, 2) in L from their standardised products with mass_bar."""
        return self.outputs.inverse(learned) / self.masses(designs)

    def fit(self, rows: Rows) -> None:
        self.inputs.fit(self._with_log_mass(rows.designs))
        self.outputs.fit(rows.apexes * self.masses(rows.designs))
        apexes = Standardisation(OUTPUTS)
        apexes.fit(rows.apexes)
        self.spread.copy_(apexes.deviation)

    def loss(self, rows: Rows) -> Tensor:
        return ((self(rows.designs) - rows.apexes) / self.spread).abs().mean()

    def masses(self, designs: Tensor) -> Tensor:
        """mass_bar (N, 1), or 1 where it does not vary."""
        if self.mass is None:
            return torch.ones_like(designs[:, :1])
        return designs[:, self.mass : self.mass + 1]

    def _with_log_mass(self, designs: Tensor) -> Tensor:
        if self.mass is None:
            return designs
        before, after = designs[:, : self.mass], designs[:, self.mass + 1 :]
        return torch.cat([before, self.masses(designs).log(), after], dim=1)
