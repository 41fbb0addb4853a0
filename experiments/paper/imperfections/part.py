"""``figure=imperfections``: the apex of the test design when a parameter is off."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.robot.robot import Robot
from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.targets.manufacturing import ErrorCurves, alone_off
from snapjump.targets.simulator import RESOLVED_STICK_ZONE, JumpSimulator, differentiable

from ...compositions import composed, groups_at
from ...designs import spread_designs
from ..base import Found, Part, Statement, weakest
from ..cells import apexes_of, jumps
from ..limits import LIMITS, judged
from ..settings import BASELINE, NAMES, PLAIN, TIERS
from ..words import Words
from . import figure

Array = NDArray[np.float64]
WORDS = Words(__file__)
# Factors of a parameter: every percent, and the ten of the released program's test.
RELEASED = np.linspace(0.8, 1.2, 10)
FACTORS = np.unique(np.round([*np.linspace(0.8, 1.2, 41), *RELEASED], 12))
ELSEWHERE = (0.8, 1.2)
DESIGNS = 64  # a power of two, as Sobol's points ask for
LINES = ("standard", "reference")
SECANT = 0.02  # error either way, several wrinkles of the map wide
HELD = (0.01, 0.05, 0.2)  # errors at which straight lines are compared
MOST = 0.95  # of the other designs, for which the limit has to hold too if there is to be none
INVERSE = LIMITS["imperfections.robust.design"].within  # of an apex in inverse proportion


def slopes(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each parameter: exact elasticities of x and y at the test design, of the jump with
    a stick zone that the steps resolve."""
    design = np.array([BASELINE])
    simulator = JumpSimulator(composed(inputs["groups"]))
    exact = simulator.slopes(design)[0]
    (apex,) = JumpSimulator(differentiable(simulator.base)).apexes(design)
    return [
        {"parameter": name, "x_elasticity": float(x), "y_elasticity": float(y)}
        for name, (x, y) in zip(NAMES, (exact * design / apex[:, None]).T, strict=True)
    ]


def curves_of(rows: Sequence[Row], factors: Array = FACTORS) -> ErrorCurves:
    """Of the jumps of :func:`alone_off` about the test design."""
    return ErrorCurves.of(apexes_of(rows).reshape(len(NAMES), len(factors), 2), factors)


def elsewhere(rows: Sequence[Row]) -> dict[str, Array]:
    """Largest changes (4, N) of x, y and the apex of N designs at either error, for each parameter:
    infinite where a robot does not jump."""
    apexes = apexes_of(rows)
    count = len(rows) // (1 + len(NAMES) * len(ELSEWHERE))
    right = apexes[:count, None, None]
    moved = apexes[count:].reshape(count, len(NAMES), len(ELSEWHERE), 2) - right
    x, y = np.moveaxis(np.abs(moved / right), -1, 0)
    apex = np.hypot(*np.moveaxis(moved, -1, 0)) / np.hypot(*np.moveaxis(right, -1, 0))
    changes = {"x": x, "y": y, "apex": apex}
    return {k: np.nan_to_num(one, nan=np.inf).max(axis=2).T for k, one in changes.items()}


def by_parameter(columns: Mapping[str, Array]) -> list[Row]:
    """A line for each parameter; columns of four numbers."""
    return [
        {"parameter": name, **{key: float(values[k]) for key, values in columns.items()}}
        for k, name in enumerate(PLAIN.values())
    ]


def tables(
    curves: Mapping[str, ErrorCurves], tangents: Mapping[str, Array], others: Mapping[str, Array]
) -> dict[str, list[Row]]:
    """Changes at every tier, elasticities, deviations of straight lines, and other designs."""
    fine, axes = curves["reference"], [*enumerate("xy")]
    kinds = {"trend": fine.trends, f"secant of {100 * SECANT:g} %": fine.secants(SECANT)}
    kinds |= {f"tangent, {tier}": exact for tier, exact in tangents.items()}
    lines = {"tangent": tangents["reference"], "secant": fine.secants(SECANT)}
    spread = {"median": 0.5, "95 %": MOST, "largest": 1.0}
    columns = {
        "imperfections": {
            f"{a}, {tier}": 100.0 * one.largest[:, j]
            for j, a in axes for tier, one in curves.items()
        },
        "imperfections_slopes": {
            f"{a}: {kind}": one[:, j] for j, a in axes for kind, one in kinds.items()
        },
        "imperfections_lines": {
            f"{kind}, {a} at {100 * error:g} %": 100.0 * fine.deviations(one, error)[:, j]
            for kind, one in lines.items() for j, a in axes for error in HELD
        },
        "imperfections_elsewhere": {
            f"{label}, {name}": 100.0 * np.quantile(values, share, axis=1)
            for label, values in others.items() for name, share in spread.items()
        },
    }  # fmt: skip
    return {name: by_parameter(one) for name, one in columns.items()}


def robust(curves: Mapping[str, ErrorCurves], others: Mapping[str, Array]) -> str:
    """The verdict: of the test design, and of the worst parameter at other designs."""
    worst = [others[axis].max(axis=0) for axis in "xy"]
    return weakest(
        judged("imperfections.robust.design", float(curves["standard"].largest.max())),
        judged("imperfections.robust.most", *(float(np.quantile(one, MOST)) for one in worst)),
        judged("imperfections.robust.half", *(float(np.median(one)) for one in worst)),
    )


def ordered(values: Array) -> str:
    """The parameters in the order of (4,) values, each with its own in percent."""
    names = [*PLAIN.values()]
    return ", ".join(f"{names[k]} {100.0 * values[k]:.2g} %" for k in np.argsort(-values))


def worst(largest: Array) -> tuple[str, float]:
    """Of the largest changes (4, 2): which coordinate by which parameter, and how much (%)."""
    k, j = np.unravel_index(int(largest.argmax()), largest.shape)
    return f"{'xy'[j]} by {PLAIN[NAMES[k]]}", 100.0 * float(largest[k, j])


def statement(curves: Mapping[str, ErrorCurves], others: Mapping[str, Array]) -> Statement:
    """At the test design, and at other designs by their worst parameters."""
    here, both = curves["standard"].largest, [others[axis] for axis in "xy"]
    half, limit = (
        [100.0 * float(np.quantile(one.max(axis=0), share)) for one in both]
        for share in (0.5, MOST)
    )
    apart = 100.0 * np.abs(curves["standard"].relative - curves["reference"].relative)
    return WORDS.statement(
        "robust", robust(curves, others), here=[ordered(one) for one in here.T], worst=worst(here),
        paper=worst(curves["paper"].largest), inverse=100 * INVERSE,
        beyond=[100.0 * float(np.mean(one.max(axis=0) > INVERSE)) for one in both],
        medians=[ordered(np.median(one, axis=1)) for one in both], half=half, most=100 * MOST,
        limit=limit, off=np.nanmax(apart, axis=(0, 1)),
    )  # fmt: skip


def told(
    curves: Mapping[str, ErrorCurves], tangents: Mapping[str, Array], others: Mapping[str, Array]
) -> dict[str, Any]:
    """Values of the text: changes by the mismatch, and how far straight lines are off (%)."""
    first, fine = NAMES.index("delta_alpha_rad"), curves["reference"]
    secants, exact = fine.secants(SECANT), tangents["reference"]
    return {
        "baseline": BASELINE,
        "here": 100.0 * curves["standard"].largest[first],
        "there": {axis: 100.0 * np.median(others[axis][first]) for axis in "xy"},
        "stick_zone_m_s": RESOLVED_STICK_ZONE * Robot().scales.velocity_m_s,
        "secant": 100 * SECANT,
        "apart": {tier: float(np.abs(one - secants).max()) for tier, one in tangents.items()},
        "held": [100.0 * error for error in HELD],
        "off": [100.0 * fine.deviations(exact, error).max(axis=0) for error in HELD],
        "wide": 100.0 * fine.deviations(secants, HELD[-1]).max(axis=0),
        "rough": {tier: 100.0 * one.roughness for tier, one in curves.items()},
    }


class Imperfections(Part):
    """Curves at every tier, exact slopes at two, and other designs."""

    name = "imperfections"
    title = "Imperfections"
    kinds = {"jumps": jumps, "slopes": slopes}

    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """Six cells."""
        at = {tier: groups_at(groups, tier) for tier in TIERS}
        curves = {"kind": "jumps", "designs": alone_off(BASELINE, FACTORS).tolist()}
        nominal = spread_designs(DESIGNS, seed)
        wrong = [design for one in nominal for design in alone_off(one, ELSEWHERE).tolist()]
        others = {"kind": "jumps", "groups": at["standard"], "designs": [*nominal, *wrong]}
        return [
            *(Cell(f"curves, {tier}", {"groups": at[tier], **curves}) for tier in TIERS),
            *(Cell(f"slopes, {tier}", {"groups": at[tier], "kind": "slopes"}) for tier in LINES),
            Cell("elsewhere", others),
        ]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Errors in the released program's form, straight lines beside them, one statement."""
        curves = {tier: curves_of(done[f"curves, {tier}"].rows) for tier in TIERS}
        tangents = {
            tier: np.stack([column(done[f"slopes, {tier}"].rows, f"{a}_elasticity") for a in "xy"],
                           axis=-1)
            for tier in LINES
        }  # fmt: skip
        others, exact = elsewhere(done["elsewhere"].rows), tangents["reference"]
        figures = {
            "imperfections": partial(figure.draw_errors, curves, RELEASED - 1.0),
            "imperfections_lines": partial(figure.draw_lines, curves, exact, 100 * SECANT),
        }
        rows = tables(curves, tangents, others)
        digits = {"imperfections_slopes": dict.fromkeys(rows["imperfections_slopes"][0], 3)}
        summary = {
            f"{kind[0]}_{name.removesuffix('_rad')}_{axis}_{kind[1]}": float(values[k, j])
            for kind, values in {
                ("imperfection", "percent"): 100.0 * curves["standard"].largest,
                ("elasticity", "trend"): curves["standard"].trends,
                ("elasticity", "tangent_reference"): exact,
            }.items()
            for k, name in enumerate(NAMES)
            for j, axis in enumerate("xy")
        }
        values = told(curves, tangents, others)
        section = WORDS.section(self.title, figures, rows, digits, **values)
        return Found(section, [statement(curves, others)], summary)
