"""Options of the contact laws."""

from dataclasses import dataclass

from snapjump.checks import check_choice, check_number
from snapjump.contact.logbarrier import LogBarrier
from snapjump.contact.none import NoContact
from snapjump.options.discretization import DiscretizationOptions
from snapjump.units import Scales

WEIGHTINGS = ("per_length", "per_node")
PAPER_ELEMENTS = 66  # of the mesh whose every node the paper gives the stiffness K_c


@dataclass(frozen=True)
class LogBarrierOptions:
    """Logarithmic barrier (the paper, IPC): no gap ever closes.

    ``stiffness_N_m`` is K_c at a frame corner and at a node of the paper's mesh of 66 elements;
    per length it is spread so that refining the mesh does not stiffen the ground.
    """

    stiffness_N_m: float = 1.0e4  # noqa: N815 (the unit is a capital)
    distance_m: float = 5.0e-4
    weighting: str = "per_length"

    def __post_init__(self) -> None:
        check_number("contact.stiffness_N_m", self.stiffness_N_m, 0.0, above=True, unit="N/m")
        check_number("contact.distance_m", self.distance_m, 0.0, above=True, unit="m")
        check_choice("contact.weighting", self.weighting, WEIGHTINGS)

    def member(self, scales: Scales, discretization: DiscretizationOptions) -> LogBarrier:
        """The dimensionless law."""
        by_length = PAPER_ELEMENTS / discretization.elements
        return LogBarrier(
            stiffness=self.stiffness_N_m / scales.stiffness_N_m,
            distance=self.distance_m / scales.length_m,
            node_weight=by_length if self.weighting == "per_length" else 1.0,
            corner_weight=1.0,
        )


@dataclass(frozen=True)
class NoContactOptions:
    """No ground: every contact term is left out of the compiled program."""

    def member(self, scales: Scales, discretization: DiscretizationOptions) -> NoContact:
        """The empty law."""
        return NoContact()
