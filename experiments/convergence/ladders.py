"""Refinement ladders: levels of one refined thing each, their reference cells, and the observables
of every level's jump."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from snapjump.checks import ParameterError
from snapjump.declare.members import make_member, member_names
from snapjump.run.studies.base import Row
from snapjump.scenes.observed import observe_jump

from ..compositions import Groups, changed, composed, has_field

OBSERVABLES = ("snap_time_s", "peak_force_N", "liftoff_speed_m_s", "x_bar", "y_bar")
COSTS = ("steps", "newton_iterations", "kernel_seconds")

# In everything but the ladder of time, time is resolved so finely that it does not matter.
TIGHT = {"name": "adaptive", "tolerance": 2e-10, "contact_steps": 1.0}
TIGHTER = 100.0  # of the reference in time, against the finest level
LOOSER = 10.0  # of the reference, to see how far it is converged itself
TIGHTEST = 2e-12  # rounding comes through below
# Other methods, the first that there is and that is not the method itself.
OTHER_INTEGRATORS = ("esdirk3", "sdirk2", "tr_bdf2")
ACCURATE = "tr_bdf2"


class Model(NamedTuple):
    """A number of the contact or friction law: its place, what it and its axis are called, what
    tends to zero with it, and the levels over the configured value, of which the first is the
    coarsest, each next one ``ratio`` times as large."""

    family: str
    key: str
    name: str
    label: str
    size: str
    first: float
    ratio: float


MODELS = (
    Model("contact", "distance_m", "barrier", "barrier distance d_hat (m)", "value", 4.0, 0.5),
    Model("contact", "stiffness_N_m", "stiffness", "inverse contact stiffness 1/K (m/N)", "inverse",
          1.0 / 64.0, 4.0),
    Model("friction", "velocity_threshold_m_s", "threshold", "friction threshold eps_v (m/s)",
          "value", 64.0, 0.25),
)  # fmt: skip


@dataclass(frozen=True)
class Ladder:
    """Levels by value, coarsest first, each with its groups.

    ``size``: what tends to zero: the value, its inverse, or the inverse number of steps.
    ``references``: cells that the levels are judged by, the best that succeeds first; without
    any, the levels' own limit. ``declared``: the order that the method promises, if it does.
    """

    name: str
    label: str
    size: str
    levels: Mapping[float, Groups]
    references: Mapping[str, Groups] = field(default_factory=dict)
    declared: float | None = None

    def cell(self, value: float) -> str:
        return f"{self.name} {value:.4g}"


def resolved(groups: Groups) -> Groups:
    """The composition with time resolved tightly, by its own method if that is of second order."""
    tight = changed(groups, {"stepping": TIGHT})
    if make_member("integrator", groups["integrator"]).order >= 2:
        with suppress(ParameterError):  # not every method can adapt its steps
            composed(tight)
            return tight
    return changed(tight, {"integrator": {"name": ACCURATE}})


def ladders(groups: Groups, count: int) -> list[Ladder]:
    """All ladders of at most ``count`` levels that the composition has."""
    tight = resolved(groups)
    models = [m for m in MODELS if has_field(groups, m.family, m.key)]
    return [
        in_time(groups, count),
        in_space(tight, count),
        *(in_model(tight, model, count) for model in models),
    ]


def in_time(groups: Groups, count: int) -> Ladder:
    """Halved steps, or tolerances divided by four; judged by another, much tighter method."""
    name = groups["integrator"]["name"]
    fixed = groups["stepping"]["name"] == "fixed"
    key, ratio = ("step_s", 2.0) if fixed else ("tolerance", 4.0)
    base = float(groups["stepping"][key])
    first = base if fixed else 16.0 * base
    values = [first * ratio**-k for k in range(count)]
    # Fixed steps have no tolerance: theirs is tighter than that of any ladder.
    tolerance = TIGHTEST if fixed else max(values[-1] / TIGHTER, TIGHTEST)
    other = next(n for n in OTHER_INTEGRATORS if n in member_names("integrator") and n != name)
    steps = {"name": "adaptive", "contact_steps": 0.5}
    references = {
        f"time reference {label}": changed(
            groups, {"integrator": {"name": other}, "stepping": {**steps, "tolerance": tight}}
        )
        for label, tight in (("tight", tolerance), ("looser", LOOSER * tolerance))
    }
    return Ladder(
        name="time",
        label="time step (s)" if fixed else "1/steps, by tolerance",
        size="value" if fixed else "steps",
        levels={v: changed(groups, {"stepping": {key: v}}) for v in values},
        references=references,
        declared=make_member("integrator", groups["integrator"]).order,
    )


def in_space(groups: Groups, count: int) -> Ladder:
    """Elements by factors of sqrt(2); judged by another discretization twice as fine as the
    finest where there is one, else by the same."""
    base = int(groups["discretization"]["elements"])
    values = [max(8, 2 * round(base * 2.0 ** (0.5 * k) / 4.0)) for k in range(count)]
    finest = 2 * values[-1]
    own = groups["discretization"]["name"]
    references = {}
    for other in [*(n for n in member_names("discretization") if n != own), own]:
        change = {"discretization": {"name": other, "elements": finest}}
        references[f"nodes reference {other}"] = changed(groups, change)
    levels = {float(v): changed(groups, {"discretization": {"elements": v}}) for v in values}
    return Ladder("nodes", "1/elements", "inverse", levels, references, declared=2.0)


def in_model(groups: Groups, model: Model, count: int) -> Ladder:
    """A number of the contact or friction law towards the limit it stands for."""
    base = float(groups[model.family][model.key])
    values = [base * (model.first * model.ratio**k) for k in range(count)]
    levels = {v: changed(groups, {model.family: {model.key: v}}) for v in values}
    return Ladder(model.name, model.label, model.size, levels)


def observed_row(groups: Mapping[str, Any]) -> Row:
    """Status, observables and cost of the composition's jump."""
    seen = observe_jump(composed(groups))
    return {key: seen[key] for key in ("status", *OBSERVABLES, *COSTS)}
