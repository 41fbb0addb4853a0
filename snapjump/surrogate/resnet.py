"""``surrogate=resnet``: a smooth residual network."""

from dataclasses import dataclass

from torch import Tensor, nn

from snapjump.checks import check_integer
from snapjump.surrogate.base import FOUR, OUTPUTS, Inputs, MassScaled


@dataclass(frozen=True)
class ResnetOptions:
    """Residual blocks with SiLU, of apex times mass over log(mass)."""

    width: int = 128
    blocks: int = 4

    def __post_init__(self) -> None:
        check_integer("surrogate.width", self.width, 1, 4096)
        check_integer("surrogate.blocks", self.blocks, 1, 64)

    def network(self, inputs: Inputs = FOUR) -> "Resnet":
        """A new network."""
        return Resnet(self.width, self.blocks, inputs)


class Block(nn.Module):
    """x + W2 s(W1 s(x)): an identity that the block corrects (He et al., arXiv 1603.05027)."""

    def __init__(self, width: int):
        super().__init__()
        self.change = nn.Sequential(
            nn.SiLU(), nn.Linear(width, width), nn.SiLU(), nn.Linear(width, width)
        )

    def forward(self, values: Tensor) -> Tensor:
        return values + self.change(values)


class Resnet(MassScaled):
    """Smooth, so that its slopes can be trusted as its values can."""

    def __init__(self, width: int, blocks: int, inputs: Inputs = FOUR):
        super().__init__(inputs)
        self.body = nn.Sequential(
            nn.Linear(inputs.columns, width),
            *[Block(width) for _ in range(blocks)],
            nn.SiLU(),
            nn.Linear(width, OUTPUTS),
        )

    def forward(self, designs: Tensor) -> Tensor:
        return self.apexes(self.body(self.scaled(designs)), designs)


MEMBER = ResnetOptions
