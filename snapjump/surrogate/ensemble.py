"""``surrogate=ensemble``: residual networks of different seeds, and intervals from their spread."""

import math
from functools import partial

import torch
from torch import Tensor, nn

from snapjump.declare.fields import integer
from snapjump.surrogate.base import FOUR, OUTPUTS, Inputs, MassScaled, Rows, SurrogateOptions
from snapjump.surrogate.parts.layers import residual

CONFIDENCE = 0.9


class EnsembleOptions(SurrogateOptions):
    """Several residual networks: their mean, and calibrated intervals from their spread."""

    members: int = integer(5, least=2, most=64)
    width: int = integer(64, least=1, most=4096)
    blocks: int = integer(4, least=1, most=64)

    def network(self, inputs: Inputs = FOUR) -> "Ensemble":
        return Ensemble(self.members, self.width, self.blocks, inputs)


class Layers(nn.Module):
    """A linear layer of every network, (M, N, inputs) -> (M, N, outputs), begun as torch's are."""

    def __init__(self, networks: int, inputs: int, outputs: int):
        super().__init__()
        bound = inputs**-0.5
        self.weight = nn.Parameter(torch.empty(networks, inputs, outputs).uniform_(-bound, bound))
        self.bias = nn.Parameter(torch.empty(networks, 1, outputs).uniform_(-bound, bound))

    def forward(self, values: Tensor) -> Tensor:
        return torch.baddbmm(self.bias, values, self.weight)


class Ensemble(MassScaled):
    """The networks see the same batches, side by side; each has its own loss.

    Intervals are conformal (Lei et al., arXiv 1604.04173): half widths are ``scale`` times the
    networks' spread plus ``least``, of the size that holds 90 % of the validation set. ``least``
    keeps them honest where the networks agree by chance.
    """

    scale: Tensor
    least: Tensor

    def __init__(self, networks: int, width: int, blocks: int, inputs: Inputs = FOUR):
        super().__init__(inputs)
        self.networks = networks
        self.body = residual(partial(Layers, networks), inputs.columns, width, blocks, OUTPUTS)
        self.register_buffer("scale", torch.ones(OUTPUTS))
        self.register_buffer("least", torch.zeros(OUTPUTS))

    def each(self, designs: Tensor) -> Tensor:
        """Apexes (M, N, 2) of every network."""
        scaled = self.scaled(designs).expand(self.networks, -1, -1)
        return self.apexes(self.body(scaled), designs)

    def forward(self, designs: Tensor) -> Tensor:
        return self.each(designs).mean(dim=0)

    def loss(self, rows: Rows) -> Tensor:
        return ((self.each(rows.designs) - rows.apexes) / self.spread).abs().mean()

    def calibrate(self, rows: Rows) -> None:
        each = self.each(rows.designs)
        spread = each.std(dim=0)
        self.least.copy_(spread.mean(dim=0))
        scores = (each.mean(dim=0) - rows.apexes).abs() / (spread + self.least)
        # One more than there are: the jump that is asked for counts as one of them.
        rank = min(math.ceil(CONFIDENCE * (len(scores) + 1)), len(scores))
        self.scale.copy_(scores.kthvalue(rank, dim=0).values)

    def half_widths(self, designs: Tensor) -> Tensor:
        return self.scale * (self.each(designs).std(dim=0) + self.least)
