"""The parts in the order of the report. A new one is a folder here and a line below."""

from experiments.paper.base import Part
from experiments.paper.causes.part import Causes
from experiments.paper.influences.part import Influences
from experiments.paper.trajectories.part import Trajectories

PARTS: dict[str, type[Part]] = {}
PARTS["trajectories"] = Trajectories
PARTS["influences"] = Influences
PARTS["causes"] = Causes
