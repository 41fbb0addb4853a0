"""Choices of words about the parameters' influences, and shares for reading, beside ``words.md``:
thirteen statements make ``part.py`` long enough.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column

from ..base import LIMITED, Statement, percent, span
from ..limits import LIMITS
from ..words import Words

WORDS = Words(__file__)
ABOUT = LIMITS["influences.below_h1"].within
ROUGHLY_FLAT = LIMITS["influences.plateau"].within
# Of the normal impulse: where no more of it acts on a contact that sticks, sticking explains
# nothing. Of the energy: shares below it are not worth a word.
STICKS, TOLD = 0.05, 0.01
SHARES = ("rise", "friction", "damping", "numerical", "turning")


def percents(shares: Iterable[float]) -> list[str]:
    """Shares for reading."""
    return [percent(share) for share in shares]


def each(shares: Mapping[str, float]) -> str:
    """Shares of coordinates, by their names."""
    return ", ".join(f"{name} {percent(share)}" for name, share in shares.items())


def heights(came: Mapping[str, str], own: Any, papers: Any, **values: Any) -> dict[str, Statement]:
    """Of a sweep, with what limited verdicts are limited to."""
    level = "About so" if max(own.off.values()) <= ABOUT else "In y_c only"
    limits = {
        "below_h1": f"{level}, to within {percent(ABOUT)}. ",
        "best": "",
        "decline": "With waves. ",
        "beyond_h2": f"From {own.last_jump - own.h2:.3f} L beyond it on. ",
    }
    values |= {"own": own, "papers": papers, "limits": LIMITS, "about": percent(ABOUT)}
    values |= {
        name: [each(getattr(one, name)) for one in (own, papers)] for name in ("off", "back")
    }
    values["higher"] = percents([own.best, papers.best])
    return {
        key: WORDS.statement(key, came[key], limit=told if came[key] == LIMITED else "", **values)
        for key, told in limits.items()
    }


def oblique(
    said: Mapping[str, Statement], own: Any, rows: Sequence[Row], still: Row
) -> list[Statement]:
    """The same of the baseline, whose apex has two coordinates, and what the ground does to a beam
    that touches it before it snaps."""
    low = [row for row in rows if row["mount_height_bar"] <= own.h1]
    loads, angles = column(low, "load_over_weight"), column(low, "alpha_snap_rad")
    turned = own.off["x_c"] > ABOUT >= own.off["y_c"]
    values = {
        "loads": span(loads),
        "angles": span(angles),
        "still": still,
        "turned": ": the height remains, the direction changes" if turned else "",
    }
    more = {"below_h1": " " + WORDS("pressed", **values), "decline": "", "beyond_h2": ""}
    return [
        said[name]._replace(
            key=f"{said[name].key}.oblique",
            says=WORDS(f"{name}.oblique: says"),
            found=said[name].found + text,
        )
        for name, text in more.items()
    ]


def shares(rows: Sequence[Row]) -> str:
    """Where the energy goes, of the lightest and of the heaviest robot."""
    first, last = rows[0], rows[-1]
    told = {name: [row[f"{name}_share"] for row in rows] for name in SHARES}
    kept = [
        WORDS(f"share: {name}", first=percent(values[0]), last=percent(values[-1]))
        for name, values in told.items()
        if max(map(abs, values)) >= TOLD
    ]
    return WORDS("shares", first=first, last=last, told=", ".join(kept))


def limit_of_level(came: str, found: Mapping[str, Any]) -> str:
    """What a limited verdict on plateaus is limited to, in front of what is found."""
    if came != LIMITED:
        return ""
    kept = [name for name, one in found.items() if one.relative_swing <= ROUGHLY_FLAT]
    if len(kept) < len(found):
        return f"In {' and '.join(kept)} only. "
    return f"To within {percent(max(found[name].relative_swing for name in kept))}. "


def why(sliding: Sequence[Row], threshold: float) -> str:
    """What becomes of the contact beyond the threshold, from the shares of its normal impulse."""
    stuck, low, high = float(column(sliding, "sticking_share").max()), sliding[0], sliding[-1]
    if stuck > STICKS:
        return WORDS("the contact sticks", stuck=percent(stuck))
    from_there = column(sliding, "mu") >= min(threshold, high["mu"])
    beyond = column(sliding, "friction_over_normal")[from_there]
    return WORDS(
        "the contact slides", stuck=percent(stuck),
        brakes=percents([low["braking_share"], high["braking_share"]]), mu=(low["mu"], high["mu"]),
        beyond=span(beyond),
    )  # fmt: skip


def differences(sweeps: Iterable[Mapping[str, Sequence[Row]]]) -> dict[str, Any]:
    """How the paper's settings differ over the baseline's sweeps: higher (%), and aside (L)."""
    x_off, y_off = [], []
    for tiers in sweeps:
        x, y, paper_x, paper_y = (
            column(tiers[tier], key) for tier in ("standard", "paper") for key in ("x_bar", "y_bar")
        )
        jumps = y > 1.0
        x_off.append((paper_x - x)[jumps])
        y_off.append(100.0 * (paper_y / y - 1.0)[jumps])
    aside, higher = np.abs(np.concatenate(x_off)), np.concatenate(y_off)
    return {
        "higher": (higher.min(), np.median(higher), higher.max()),
        "aside": (np.median(aside), aside.max()),
    }
