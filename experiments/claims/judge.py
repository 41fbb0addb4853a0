"""Jumps of drawn robots at every tier, and the truth that they are judged by.

The truth has another integrator than the tiers, a finer mesh and tighter steps, and a second truth
of other mesh and steps that says how well it is known itself.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array
from snapjump.batch import Batch, simulate_batch
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.declare.members import make_member
from snapjump.scenes.jump_start import jump_model
from snapjump.tiers import TIERS

from ..errors import relative_errors
from .robots import KINDS, Values, robot_of

JUDGED = ("draft", "standard", "reference")
DRAWN_AT = "standard"
MOST_ITERATIONS, TRUTH_ITERATIONS = 2e5, 2e6
TRUTH: dict[str, Any] = {"integrator": "tr_bdf2", "tolerance": 2e-10, "elements": 544}
SECOND: dict[str, Any] = {"integrator": "tr_bdf2", "tolerance": 1e-9, "elements": 320}
# The truth's mesh error over the difference of both, which is of second order.
TRUTH_SHARE = 1.0 / ((TRUTH["elements"] / SECOND["elements"]) ** 2 - 1.0)
LANES = 8


class Found(NamedTuple):
    """Of R robots at one setting: statuses, apexes (L), what they claim (True, False, None), and
    Newton iterations."""

    status: list[str]
    x: Array
    y: Array
    within: list[bool | None]
    iterations: Array


def true_setting(chosen: dict[str, Any]) -> Simulation:
    """The setting of a truth."""
    base = with_tier("reference")
    return with_tier(
        "reference",
        integrator=make_member("integrator", {"name": chosen["integrator"]}),
        stepping=base.stepping.changed(
            tolerance=chosen["tolerance"], contact_steps=0.5, stick_share=1.0
        ),
        discretization=base.discretization.changed(elements=chosen["elements"]),
    )


def jumped(
    base: Simulation, draws: Sequence[Values | None], most: float, threads: int
) -> Iterator[tuple[list[int], Batch]]:
    """The jumps of the draws that make a robot, with their places: a batch of each drive, since
    clamps of two rates are another program than those of one."""
    robots: dict[Any, dict[int, Simulation]] = {}
    for k, values in enumerate(draws):
        if values is None:
            continue
        try:
            simulation = robot_of(base, values)
            jump_model(simulation)
        except ParameterError:
            continue
        robots.setdefault(simulation.drive.in_common, {})[k] = simulation
    for alike in robots.values():
        yield list(alike), simulate_batch(list(alike.values()), LANES, most, threads)


def drawn(kind: str, count: int, seed: int, threads: int) -> tuple[list[Values], Counter[str]]:
    """Robots that end ``ok`` with an apex, and how the others that were drawn ended."""
    base = with_tier(DRAWN_AT)
    draws, tally = KINDS[kind](base, seed), Counter[str]()
    kept: list[Values] = []
    while len(kept) < count:
        more = list(islice(draws, count - len(kept)))
        ended = dict(enumerate(["refused"] * len(more)))
        for places, batch in jumped(base, more, MOST_ITERATIONS, threads):
            ended.update(zip(places, batch.statuses(), strict=True))
        tally.update(status for status in ended.values() if status != "ok")
        kept += [values for k, values in enumerate(more) if values and ended[k] == "ok"]
    return kept, tally


def found(base: Simulation, robots: Sequence[Values], most: float, threads: int) -> Found:
    """The jumps of robots at one setting; what it refuses is ``refused``."""
    count = len(robots)
    status, within = ["refused"] * count, list[bool | None]([None]) * count
    x, y, iterations = (np.full(count, np.nan) for _ in range(3))
    for places, batch in jumped(base, robots, most, threads):
        x[places], y[places] = batch.x_bar, batch.y_bar
        iterations[places] = batch.newton_iterations
        for k, ended, told in zip(places, batch.statuses(), batch.within_tier, strict=True):
            status[k], within[k] = ended, told
    return Found(status, x, y, within, iterations)


def errors(of: Found, truth: Found) -> Array:
    """The larger error of x and y (%); infinite where one jumps and the other does not, NaN where
    the truth failed."""
    x, y = relative_errors(of.x, of.y, truth.x, truth.y)
    worst = np.maximum(x, y)
    for k, (ours, true) in enumerate(zip(of.status, truth.status, strict=True)):
        if true not in ("ok", "no_jump"):
            worst[k] = np.nan
        elif ours == "ok" and true != "ok":
            worst[k] = np.inf
    return worst


def judged(robots: Sequence[Values], threads: int) -> tuple[dict[str, dict[str, Any]], Array]:
    """A row for each tier, and the truth's own errors (%)."""
    truth = found(true_setting(TRUTH), robots, TRUTH_ITERATIONS, threads)
    second = found(true_setting(SECOND), robots, TRUTH_ITERATIONS, threads)
    unsure = TRUTH_SHARE * errors(second, truth)
    rows = {}
    for name in JUDGED:
        ours = found(with_tier(name), robots, MOST_ITERATIONS, threads)
        rows[name] = row(ours, errors(ours, truth), unsure, TIERS[name].promise_percent)
    return rows, unsure


def row(ours: Found, worst: Array, unsure: Array, promise: float) -> dict[str, Any]:
    """How well a tier's robots keep to what they claim. Robots whose truth is not known to half of
    the promise are not judged."""
    ended = np.array([status == "ok" for status in ours.status])
    known = ended & ~np.isnan(worst) & ~(unsure > 0.5 * promise)
    told = np.array([within is True for within in ours.within]) & known
    unknown = np.array([within is None for within in ours.within]) & known
    good = known & (worst <= promise)
    return {
        "judged": int(known.sum()),
        "truth not known": int((ended & ~known).sum()),
        "truly within": int(good.sum()),
        "told within": int(told.sum()),
        "told, of those truly within (%)": percent(told & good, good),
        "not known here (%)": percent(unknown, known),
        "told and beyond the promise (%)": percent(told & ~good, told),
        "beyond twice (%)": percent(told & (worst > 2.0 * promise), told),
        "beyond three times": int((told & (worst > 3.0 * promise)).sum()),
    }


def percent(some: Any, of: Any) -> float:
    """A share in percent."""
    return float(f"{100.0 * some.sum() / max(int(of.sum()), 1):.3g}")
