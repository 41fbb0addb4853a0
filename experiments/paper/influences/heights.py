"""Influence of the mounts' height, which the paper has much to say of: a sweep beside h1 and h2."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from snapjump.batch import simulate_batch, variant
from snapjump.composition import Simulation
from snapjump.run.studies.base import Row, column
from snapjump.scenes import strike

from ...compositions import composed
from ...trends import counter_step
from ..base import Statement, verdict, weakest
from ..cells import LANES, LOADING_S, THREADS, batch_rows, followed
from ..limits import LIMITS, judged
from ..settings import BASELINE
from . import words

Sweeps = Mapping[str, Sequence[Row]]  # by tier
FOLLOWED = ("standard", "paper")  # tiers that are looked into
MOUNT_HEIGHT = "mount_height_bar"
# The paper's jump of the mounts' height: symmetric and without friction, all else the baseline.
VERTICAL, UPRIGHT = "vertical", (0.0, *BASELINE[1:3], 0.0)


def mounted(inputs: Mapping[str, Any]) -> list[Simulation]:
    """The robot with its clamps at other heights (in L)."""
    base = variant(composed(inputs["groups"]), inputs["design"])
    length_m = base.robot.length_m
    return [
        replace(base, robot=replace(base.robot, mount_height=height * length_m))
        for height in inputs["heights"]
    ]


def height_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each height of the mounts: the jump."""
    rows = batch_rows(simulate_batch(mounted(inputs), LANES, threads=THREADS))
    return [{MOUNT_HEIGHT: h, **row} for h, row in zip(inputs["heights"], rows, strict=True)]


def pressed_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each height of the mounts: the ground under the beam before it snaps."""
    pairs = zip(inputs["heights"], mounted(inputs), strict=True)
    return [{MOUNT_HEIGHT: h, **strike.pressed(followed(robot, LOADING_S))} for h, robot in pairs]


@dataclass(frozen=True)
class Height:
    """A sweep of the mounts' height beside h1 and h2 (L), by the names of the coordinates.

    off: largest deviation below h1 from the apex at h1 (share); close_from: the lowest h from
    which on all stay within the limit of "about so" up to h1; back: ways back between h1 and h2;
    best: how much higher the highest jump is than that at h1 (share), best_height its h;
    last_jump: the highest h with a jump, NaN without any; rise_beyond: the largest rise (L) of
    the centre of mass from h2 on.
    """

    h1: float
    h2: float
    off: dict[str, float]
    close_from: float
    back: dict[str, float]
    best: float
    best_height: float
    last_jump: float
    rise_beyond: float


def height(rows: Sequence[Row], h1: float, h2: float, names: Sequence[str]) -> Height:
    """The figures; the centre of mass stands where the lowest of the sweep is, which has not
    jumped."""
    h, y = column(rows, MOUNT_HEIGHT), column(rows, "y_bar")
    apex = {name: column(rows, f"{name[0]}_bar") for name in names}
    below, between = h <= h1, (h >= h1) & (h <= h2)
    off = {name: np.abs(one / np.interp(h1, h, one) - 1.0) for name, one in apex.items()}
    about = LIMITS["influences.below_h1"].within
    far = np.flatnonzero(below & (np.max([*off.values()], axis=0) > about))
    rise = y - y.min()
    higher = h[rise > LIMITS["influences.beyond_h2.rise"].confirmed]
    return Height(
        h1,
        h2,
        {name: float(one[below].max()) for name, one in off.items()},
        float(h[far[-1] + 1] if len(far) else h[0]),
        {name: counter_step(one[between], rising=False) for name, one in apex.items()},
        float(y.max() / np.interp(h1, h, y) - 1.0),
        float(h[y.argmax()]),
        float(higher.max()) if len(higher) else float("nan"),
        float(rise[h >= h2].max()),
    )


def height_verdicts(found: Height) -> dict[str, str]:
    """Constant below h1 in all coordinates, or the height at least, about; a decline between h1 and
    h2; no jump from h2 on; and none higher than that at h1."""
    limit = LIMITS["influences.below_h1"]
    return {
        "below_h1": verdict(
            max(found.off.values()) <= limit.confirmed, found.off["y_c"] <= limit.within
        ),
        "decline": judged("influences.decline", *found.back.values()),
        "beyond_h2": weakest(
            judged("influences.beyond_h2.rise", found.rise_beyond),
            judged("influences.beyond_h2.last", found.last_jump - found.h2),
        ),
        "best": judged("influences.best", found.best),
    }


def height_statements(
    sweeps: Mapping[str, Sweeps],
    statics: Mapping[str, Row],
    pressed: Sequence[Row],
    near: Mapping[str, Any],
) -> list[Statement]:
    """Of the paper's vertical jump, and, as our reading, of the baseline's; statics: of each tier's
    own mesh; near: values of the accuracy, by sweep."""
    found: list[Statement] = []
    for name, coordinates in ((VERTICAL, ("y_c",)), (MOUNT_HEIGHT, ("y_c", "x_c"))):
        depths = {tier: (row["h1_bar"], row["h2_bar"]) for tier, row in statics.items()}
        own, papers = (height(sweeps[name][t], *depths[t], coordinates) for t in FOLLOWED)
        came, first = height_verdicts(own), sweeps[name]["standard"][0][MOUNT_HEIGHT]
        said = words.heights(came, own, papers, first=first, near=near[name])
        still = statics["standard"]
        found += said.values() if name == VERTICAL else words.oblique(said, own, pressed, still)
    return found
