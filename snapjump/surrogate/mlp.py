"""``surrogate=mlp``: the paper's network."""

from torch import Tensor, nn

from snapjump.declare.fields import integer
from snapjump.surrogate.base import FOUR, OUTPUTS, Inputs, Surrogate, SurrogateOptions
from snapjump.surrogate.parts.layers import perceptron


class MlpOptions(SurrogateOptions):
    """The paper's network: fully connected layers with ReLU."""

    width: int = integer(372, least=1, most=4096)
    layers: int = integer(3, least=1, most=64)

    def network(self, inputs: Inputs = FOUR) -> "Mlp":
        return Mlp(self.width, self.layers, inputs)


class Mlp(Surrogate):
    """Source: the paper, section on the forward model (3 hidden layers of 372)."""

    def __init__(self, width: int, layers: int, inputs: Inputs = FOUR):
        super().__init__(inputs)
        self.body = perceptron([inputs.columns, *[width] * layers, OUTPUTS], nn.ReLU)

    def forward(self, designs: Tensor) -> Tensor:
        return self.outputs.inverse(self.body(self.inputs(designs)))
