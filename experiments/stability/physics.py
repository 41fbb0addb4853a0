"""Expectations from physics for cells of the maps (the extremes), and what was found."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from snapjump.run.studies.base import REFUSED, Row
from snapjump.scenes.jump_outputs import ENDED

from .jumps import by_status

Rows = Sequence[Row]
Maps = Mapping[str, Rows]
# The beam's own mass is mass_bar = 0.0096, what it stores when flat clamps hold it 8 pi^2 epsilon.
BEAM_MASS_BAR = 0.0096
STORED = 78.957


@dataclass(frozen=True)
class Check:
    """An expectation, what was found, and whether that meets it."""

    name: str
    expected: str
    found: str
    holds: bool

    def row(self) -> Row:
        verdict = "yes" if self.holds else "NO"
        return {"case": self.name, "expected": self.expected, "found": self.found, "holds": verdict}


def known(rows: Rows) -> list[Row]:
    """The rows with an apex."""
    return [row for row in rows if row["status"] in ENDED]


def jumps(row: Row) -> bool:
    """Whether it jumps."""
    return bool(row["status"] == "ok")


def warns(row: Row) -> bool:
    """Whether it fails by name, or is marked as not within its tier."""
    return row["status"] not in ENDED or not row["within_tier"]


def spread(values: Sequence[float]) -> float:
    """Largest less smallest, over the mean (%)."""
    return 100.0 * float(np.ptp(values) / abs(np.mean(values))) if len(values) > 1 else 0.0


def all_are(rows: Rows, name: str, expected: str, meets: Callable[[Row], bool]) -> Check:
    """A check that every one of some rows meets."""
    good = sum(meets(row) for row in rows)
    counts = ", ".join(f"{count} {status}" for status, count in by_status(rows).items())
    text = f"{good} of {len(rows)}: {counts or 'none'}"
    return Check(name, expected, text, bool(rows) and good == len(rows))


def checks(found: Maps) -> list[Check]:
    """All expectations that the maps can answer."""
    return [
        *of_steps(found["steps"]),
        *of_mesh(found["mesh"]),
        *of_barrier(found["barrier"], found["law"]),
        *of_friction(found["friction"]),
        *of_design(found["design"]),
        *of_mass(found["mass"], found["gravity"]),
    ]


def of_steps(rows: Rows) -> list[Check]:
    """Steps that are far too long, and far too short."""
    return [
        all_are([r for r in rows if r["across"] >= 1e-3], "step of 1 ms and more",
                "a named failure, or marked as not within its tier", warns),
        all_are([r for r in rows if r["across"] <= 1e-8], "step of 1e-8 s",
                "ends by the bound on iterations", lambda r: r["status"] == "iteration_limit"),
        all_are([r for r in rows if r["across"] == 1e-6], "step of 1e-6 s",
                "every method jumps", jumps),
    ]  # fmt: skip


def of_mesh(rows: Rows) -> list[Check]:
    """Meshes that are too coarse, and tolerances from loose to tight."""
    return [
        all_are([r for r in rows if r["across"] <= 16], "at most 16 elements",
                "refused, failed, or marked as not within its tier", warns),
        all_are([r for r in rows if r["across"] >= 56 and r["up"] <= 1e-6],
                "fine mesh, tight tolerance", "jumps (or the bound on iterations is reached)",
                lambda r: r["status"] in ("ok", "iteration_limit")),
        all_are([r for r in rows if r["across"] >= 32 and r["up"] >= 1e-4],
                "loose tolerance", "jumps, and is marked as not within its tier",
                lambda r: jumps(r) and not r["within_tier"]),
    ]  # fmt: skip


def of_barrier(rows: Rows, law: Rows) -> list[Check]:
    """The rigid limit of a stiff and thin barrier, and of other stiff laws."""
    stiff = [r["y_bar"] for r in known(rows) if r["across"] >= 1e5 and r["up"] <= 3e-5]
    elastic = [r["y_bar"] for r in known(law) if r["across"] >= 1e7 and r["up"] != "hunt_crossley"]
    return [
        Check("K huge, d_hat tiny", "y converges to that of a rigid ground (within 5 %)",
              f"y of {len(stiff)} cells spreads by {spread(stiff):.2g} %",
              len(stiff) > 2 and spread(stiff) < 5.0),
        Check("K from 1e7 N/m, elastic laws", "the same y (within 10 %)",
              f"{len(elastic)} cells spread by {spread(elastic):.2g} %",
              len(elastic) > 1 and spread(elastic) < 10.0),
    ]  # fmt: skip


def of_friction(rows: Rows) -> list[Check]:
    """No friction, much of it, and a threshold that hardly smooths it."""
    smooth = [r["x_bar"] for r in rows if r["up"] == 0.0 and jumps(r)] or [np.inf]
    sticky = [r for r in known(rows) if r["up"] >= 1.0 and r["across"] <= 1e-4]
    by_mu = [[r["y_bar"] for r in sticky if r["up"] == mu] for mu in {r["up"] for r in sticky}]
    worst = max((spread(y) for y in by_mu), default=np.inf)
    return [
        Check("mu = 0", "x stays where it was, small, whatever eps_v (1e-10 L)",
              f"{len(smooth)} cells, x = {np.mean(smooth):.2g} L, apart by {np.ptp(smooth):.2g} L",
              len(smooth) > 1 and abs(np.mean(smooth)) < 1e-3 and np.ptp(smooth) < 1e-10),
        Check("mu >= 1, eps_v <= 1e-4 m/s", "y does not depend on the threshold (3 %)",
              f"{len(sticky)} cells, y spreads by at most {worst:.2g} %",
              bool(sticky) and worst < 3.0),
        all_are([r for r in rows if r["across"] <= 1e-6], "eps_v <= 1e-6 m/s",
                "implicit friction works", jumps),
    ]  # fmt: skip


def of_design(rows: Rows) -> list[Check]:
    """Symmetric designs, and energy that cannot come from nowhere."""
    even = [abs(r["x_bar"]) for r in known(rows) if r["up"] == 0.0]
    return [
        Check("delta_alpha = 0", "x = 0 (1e-6 L)",
              f"{len(even)} cells, largest |x| {max(even, default=np.inf):.2g} L",
              bool(even) and max(even) < 1e-6),
        all_are(known(rows), "every epsilon and delta_alpha",
                "the apex needs no more than twice the energy that flat clamps store",
                lambda r: 0.768 * r["y_bar"] <= 2.0 * STORED * max(r["across"], 0.01) + 0.768),
    ]  # fmt: skip


def of_mass(rows: Rows, gravity: Rows) -> list[Check]:
    """Lighter than the beam, too heavy to jump, and no gravity."""
    return [
        all_are([r for r in rows if r["across"] <= BEAM_MASS_BAR], "mass_bar at most the beam's",
                "refused", lambda r: r["status"] == REFUSED),
        all_are([r for r in rows if r["across"] >= 100.0], "mass_bar = 100",
                "no_jump (or, where slow clamps take seconds, the bound on iterations)",
                lambda r: r["status"] == "no_jump"
                or (r["up"] <= 1.0 and r["status"] == "iteration_limit")),
        all_are([r for r in gravity if r["across"] == 0.0], "no gravity",
                "refused, since the apex is undefined", lambda r: r["status"] == REFUSED),
        all_are([r for r in gravity if r["across"] >= 1.0], "the Moon to 10 g", "jumps", jumps),
    ]  # fmt: skip
