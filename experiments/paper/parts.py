"""The parts in the order of the report. A new one is a folder here and a line below."""

from experiments.paper.asymmetry.part import AsymmetryPart
from experiments.paper.base import Part
from experiments.paper.snaps.part import SnapsPart

PARTS: dict[str, type[Part]] = {
    "snaps": SnapsPart,
    "asymmetry": AsymmetryPart,
}
