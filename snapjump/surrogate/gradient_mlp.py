"""``surrogate=gradient_mlp``: a network that is trained on apexes and their exact derivatives."""

import torch
from torch import Tensor, nn

from snapjump.declare.fields import integer, number
from snapjump.surrogate.base import FOUR, OUTPUTS, Inputs, MassScaled, Rows, SurrogateOptions
from snapjump.surrogate.parts.layers import perceptron


class GradientMlpOptions(SurrogateOptions):
    """Fully connected layers with SiLU, trained on apexes and their sensitivities."""

    width: int = integer(128, least=1, most=4096)
    layers: int = integer(4, least=1, most=64)
    slope_weight: float = number(0.1, least=0.0, most=1e6)

    def network(self, inputs: Inputs = FOUR) -> "GradientMlp":
        return GradientMlp(self.width, self.layers, self.slope_weight, inputs)


class GradientMlp(MassScaled):
    """Sobolev training (Czarnecki et al., arXiv 1706.04859).

    The loss is the mean absolute error of the apexes and ``slope_weight`` times that of the
    slopes, both in standard deviations of the apexes and of the scaled inputs; slopes that are NaN
    do not count.
    """

    needs_slopes = True

    def __init__(self, width: int, layers: int, slope_weight: float, inputs: Inputs = FOUR):
        super().__init__(inputs)
        self.slope_weight = slope_weight
        self.body = perceptron([inputs.columns, *[width] * layers, OUTPUTS], nn.SiLU)

    def forward(self, designs: Tensor) -> Tensor:
        return self.apexes(self.body(self.scaled(designs)), designs)

    def loss(self, rows: Rows) -> Tensor:
        designs = rows.designs.clone().requires_grad_()
        apexes = self(designs)
        values = ((apexes - rows.apexes) / self.spread).abs().mean()
        slopes = self.slopes(apexes, designs, create_graph=True)
        known = torch.isfinite(rows.slopes)
        # What a standard deviation of a scaled input is in the design's own unit; d log(m) = dm/m.
        strides = self.inputs.deviation.repeat(len(designs), 1)
        if self.mass is not None:
            strides[:, self.mass] *= rows.designs[:, self.mass]
        error = (slopes - rows.slopes) * strides[:, None] / self.spread[:, None]
        return values + self.slope_weight * error[known].abs().sum() / known.sum().clamp(min=1)
