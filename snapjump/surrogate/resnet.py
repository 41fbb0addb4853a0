"""``surrogate=resnet``: a smooth residual network."""

from torch import Tensor, nn

from snapjump.declare.fields import integer
from snapjump.surrogate.base import FOUR, OUTPUTS, Inputs, MassScaled, SurrogateOptions
from snapjump.surrogate.parts.layers import residual


class ResnetOptions(SurrogateOptions):
    """Residual blocks with SiLU, of apex times mass over log(mass)."""

    width: int = integer(128, least=1, most=4096)
    blocks: int = integer(4, least=1, most=64)

    def network(self, inputs: Inputs = FOUR) -> "Resnet":
        return Resnet(self.width, self.blocks, inputs)


class Resnet(MassScaled):
    """Smooth, so that its slopes can be trusted as its values can."""

    def __init__(self, width: int, blocks: int, inputs: Inputs = FOUR):
        super().__init__(inputs)
        self.body = residual(nn.Linear, inputs.columns, width, blocks, OUTPUTS)

    def forward(self, designs: Tensor) -> Tensor:
        return self.apexes(self.body(self.scaled(designs)), designs)
