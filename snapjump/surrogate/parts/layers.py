"""Networks of layers: plain ones, and residual ones of any kind of linear layer."""

from collections.abc import Callable, Sequence
from itertools import pairwise

from torch import Tensor, nn

Layer = Callable[[int, int], nn.Module]  # of so many inputs and outputs


def perceptron(sizes: Sequence[int], activation: type[nn.Module]) -> nn.Sequential:
    """Linear layers of these sizes, with an activation after each but the last."""
    parts: list[nn.Module] = []
    for here, there in pairwise(sizes[:-1]):
        parts += [nn.Linear(here, there), activation()]
    return nn.Sequential(*parts, nn.Linear(sizes[-2], sizes[-1]))


class Block(nn.Module):
    """x + W2 s(W1 s(x)): an identity that the block corrects (He et al., arXiv 1603.05027)."""

    def __init__(self, layer: Layer, width: int):
        super().__init__()
        inner, outer = (layer(width, width) for _ in range(2))
        self.change = nn.Sequential(nn.SiLU(), inner, nn.SiLU(), outer)

    def forward(self, values: Tensor) -> Tensor:
        return values + self.change(values)


def residual(layer: Layer, inputs: int, width: int, blocks: int, outputs: int) -> nn.Sequential:
    """Blocks between two layers."""
    return nn.Sequential(
        layer(inputs, width),
        *[Block(layer, width) for _ in range(blocks)],
        nn.SiLU(),
        layer(width, outputs),
    )
