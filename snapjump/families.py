"""Every family and its members by name: what can be composed, in one place."""

from snapjump.options.backend import CudaBackend, LanesBackend, ScalarBackend
from snapjump.options.contact import (
    HuntCrossleyOptions,
    LogBarrierOptions,
    NoContactOptions,
    PenaltyOptions,
    SignoriniOptions,
)
from snapjump.options.damping import KelvinVoigtOptions, MassProportionalOptions, NoDampingOptions
from snapjump.options.discretization import (
    CorotationalOptions,
    DiscreteElasticRodOptions,
    GeometricallyExactOptions,
)
from snapjump.options.executor import DaskExecutorOptions, LocalExecutorOptions
from snapjump.options.frame import ElasticFrameOptions, FixedFrameOptions, RigidFrameOptions
from snapjump.options.friction import (
    ImplicitFrictionOptions,
    LaggedFrictionOptions,
    NoFrictionOptions,
)
from snapjump.options.integrator import (
    Bdf2Options,
    CentralDifferenceOptions,
    GeneralizedAlphaOptions,
    NewmarkOptions,
)
from snapjump.options.linear_solver import BandedSolverOptions
from snapjump.options.plan import (
    GridPlanOptions,
    LatinHypercubePlanOptions,
    SobolPlanOptions,
)
from snapjump.options.runge_kutta import tableaux
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
    "discretization": {
        "der": DiscreteElasticRodOptions,
        "corotational": CorotationalOptions,
        "geometrically_exact": GeometricallyExactOptions,
    },
    "frame": {
        "rigid": RigidFrameOptions,
        "elastic": ElasticFrameOptions,
        "fixed": FixedFrameOptions,
    },
    "contact": {
        "logbarrier": LogBarrierOptions,
        "penalty": PenaltyOptions,
        "hunt_crossley": HuntCrossleyOptions,
        "signorini": SignoriniOptions,
        "none": NoContactOptions,
    },
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
        **tableaux(),
        "bdf2": Bdf2Options,
        "newmark": NewmarkOptions,
        "generalized_alpha": GeneralizedAlphaOptions,
        "central_difference": CentralDifferenceOptions,
    },
    "stepping": {"adaptive": AdaptiveStepOptions, "fixed": FixedStepOptions},
    "linear_solver": {"banded": BandedSolverOptions},
    "backend": {"scalar": ScalarBackend, "lanes": LanesBackend, "cuda": CudaBackend},
}

# What a dataset has beside its simulation.
DATASET_FAMILIES: dict[str, dict[str, type]] = {
    "plan": {
        "grid": GridPlanOptions,
        "sobol": SobolPlanOptions,
        "latin_hypercube": LatinHypercubePlanOptions,
    },
    "executor": {"local": LocalExecutorOptions, "dask": DaskExecutorOptions},
}


def name_of(family: str, options: object) -> str:
    """The name under which an option object's class stands in its family."""
    members = (FAMILIES | DATASET_FAMILIES)[family]
    return next(n for n, cls in members.items() if cls is type(options))
