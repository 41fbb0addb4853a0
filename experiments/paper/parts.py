"""The parts in the order of the report. A new one is a folder here and a line below."""

from experiments.paper.asymmetry.part import Asymmetry
from experiments.paper.base import Part
from experiments.paper.bifurcation.part import Bifurcation
from experiments.paper.causes.part import Causes
from experiments.paper.designs.part import Designs
from experiments.paper.forward_model.part import ForwardModels
from experiments.paper.imperfections.part import Imperfections
from experiments.paper.influences.part import Influences
from experiments.paper.regions.part import Regions
from experiments.paper.released_energy.part import ReleasedEnergy
from experiments.paper.snaps.part import Snaps
from experiments.paper.trajectories.part import Trajectories

PARTS: dict[str, type[Part]] = {
    part.name: part
    for part in (Bifurcation, ReleasedEnergy, Snaps, Asymmetry, Trajectories, Influences, Causes,
                 Regions, Designs, Imperfections, ForwardModels)
}  # fmt: skip
