"""Every family and its members by name: what can be composed, in one place."""

from snapjump.integrator.implicit_euler import ImplicitEuler
from snapjump.integrator.sdirk2 import Sdirk2
from snapjump.integrator.tr_bdf2 import TrBdf2
from snapjump.options.backend import LanesBackend, ScalarBackend
from snapjump.options.contact import LogBarrierOptions, NoContactOptions
from snapjump.options.damping import KelvinVoigtOptions, MassProportionalOptions, NoDampingOptions
from snapjump.options.discretization import DiscreteElasticRodOptions
from snapjump.options.frame import ElasticFrameOptions, FixedFrameOptions, RigidFrameOptions
from snapjump.options.friction import (
    ImplicitFrictionOptions,
    LaggedFrictionOptions,
    NoFrictionOptions,
)
from snapjump.options.linear_solver import BandedSolverOptions
from snapjump.options.sim import (
    BounceScene,
    CantileverScene,
    JumpScene,
    SlideScene,
    SnapScene,
    StaticScene,
)
from snapjump.options.stepping import AdaptiveStepOptions, FixedStepOptions

FAMILIES: dict[str, dict[str, type]] = {
    "sim": {
        "jump": JumpScene,
        "snap": SnapScene,
        "static": StaticScene,
        "cantilever": CantileverScene,
        "bounce": BounceScene,
        "slide": SlideScene,
    },
    "discretization": {"der": DiscreteElasticRodOptions},
    "frame": {
        "rigid": RigidFrameOptions,
        "elastic": ElasticFrameOptions,
        "fixed": FixedFrameOptions,
    },
    "contact": {"logbarrier": LogBarrierOptions, "none": NoContactOptions},
    "friction": {
        "implicit": ImplicitFrictionOptions,
        "lagged": LaggedFrictionOptions,
        "none": NoFrictionOptions,
    },
    "damping": {
        "kelvin_voigt": KelvinVoigtOptions,
        "mass_proportional": MassProportionalOptions,
        "none": NoDampingOptions,
    },
    "integrator": {
        "tr_bdf2": TrBdf2,
        "sdirk2": Sdirk2,
        "implicit_euler": ImplicitEuler,
    },
    "stepping": {"adaptive": AdaptiveStepOptions, "fixed": FixedStepOptions},
    "linear_solver": {"banded": BandedSolverOptions},
    "backend": {"scalar": ScalarBackend, "lanes": LanesBackend},
}


def name_of(family: str, options: object) -> str:
    """The name under which an option object's class stands in its family."""
    return next(n for n, cls in FAMILIES[family].items() if cls is type(options))
