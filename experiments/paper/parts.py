"""The parts in the order of the report. A new one is a folder here and a line below."""

from experiments.paper.base import Part
from experiments.paper.forward_model.part import ForwardModelPart

PARTS: dict[str, type[Part]] = {
    "forward_model": ForwardModelPart,
}
