"""The parts in the order of the report. A new one is a folder here and a line below."""

from experiments.paper.base import Part
from experiments.paper.designs.part import Designs
from experiments.paper.imperfections.part import Imperfections
from experiments.paper.regions.part import Regions

PARTS: dict[str, type[Part]] = {}
PARTS["regions"] = Regions
PARTS["designs"] = Designs
PARTS["imperfections"] = Imperfections
