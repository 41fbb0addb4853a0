"""``surrogate=resnet``: a smooth residual network."""

from torch import Tensor, nn

from snapjump.declare.fields import integer
from snapjump.surrogate.base import FOUR, OUTPUTS, Inputs, MassScaled, SurrogateOptions


class ResnetOptions(SurrogateOptions):
    """Residual blocks with SiLU, of apex times mass over log(mass)."""

    width: int = integer(128, least=1, most=4096)
    blocks: int = integer(4, least=1, most=64)

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
