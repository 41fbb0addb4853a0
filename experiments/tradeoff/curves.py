"""The compositions that are compared: one curve each, over its own refinement knob.

A level refines time and mesh together, so that neither is wasted on the other's error: the
tolerance falls with the 4.5th power of the element's length (what the tiers were found to need).
A method whose error estimate has another order gets tolerances at which it takes as many steps.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from snapjump.declare.members import member_class, member_names

from ..compositions import Groups, changed
from .batches import LANES

STANDARD_ELEMENTS, STANDARD_TOLERANCE, STANDARD_STICK_SHARE = 120, 1e-6, 8.0
TOLERANCE_POWER, STICK_POWER = 3.0, 1.25
TOLERANCE_RANGE = (2e-12, 1e-3)
STANDARD_STEP_S = 2.5e-6
STEP_POWER = 1.5
FINEST_FIXED = 160
ESTIMATE_ORDER = 3.0  # of the default method
QUICK_ELEMENTS = (40, 64, 88, 120, 184, 272)
FULL_ELEMENTS = (32, 40, 48, 56, 64, 76, 88, 104, 120, 152, 184, 224, 272, 320)
# Methods that are varied in every way; the others only in their steps.
VARIED = ("generalized_alpha", "tr_bdf2", "esdirk3", "implicit_euler")
PLAIN_METHOD = "generalized_alpha"
CONTACT_STEPS = {
    "half the steps in contact": 4.0,
    "twice the steps in contact": 1.0,
    "blind to contact": 1e9,  # left to the error estimate
}
CHANGES: dict[str, dict[str, Any]] = {
    "two-node clamps": {"discretization": {"clamp": "two_nodes"}},
    "start at 0.85 of the critical angle": {"sim": {"start_fraction": 0.85}},
    "late start": {"sim": {"start_fraction": 0.92}},
}
FINE, TIGHT = 272, 6e-8  # elements and tolerance, where the other alone is refined


@dataclass(frozen=True)
class Curve:
    """A composition: its name, the method it is drawn under, and groups by level."""

    name: str
    method: str
    levels: Mapping[str, Groups]
    lanes: int = LANES

    def cell(self, level: str) -> str:
        return f"{self.name}, {level}"


def tolerance(elements: int, estimate_order: float = ESTIMATE_ORDER) -> float:
    """The tolerance that goes with a mesh."""
    matched: float = STANDARD_TOLERANCE * (STANDARD_ELEMENTS / elements) ** TOLERANCE_POWER
    matched **= estimate_order / ESTIMATE_ORDER
    return min(max(matched, TOLERANCE_RANGE[0]), TOLERANCE_RANGE[1])


def stick_share(elements: int) -> float:
    """The share of eps_v in a step that goes with a mesh."""
    return float(f"{STANDARD_STICK_SHARE * (STANDARD_ELEMENTS / elements) ** STICK_POWER:.2g}")


def estimate_order(name: str) -> float:
    """Order of a method's error estimate."""
    return float(member_class("integrator", name)().scheme().error_power())


def adaptive(base: Groups, name: str, elements: tuple[int, ...], **stepping: Any) -> dict[str, Any]:
    """Levels of mesh and tolerance."""
    rounded = {n: f"{tolerance(n, estimate_order(name)):.1e}" for n in elements}
    steps = {"name": "adaptive", "contact_steps": 2.0, **stepping}
    return {
        f"{n} elements, tol {text}": refined(
            base, name, n, {**steps, "tolerance": float(text), "stick_share": stick_share(n)}
        )
        for n, text in rounded.items()
    }


def fixed(base: Groups, name: str, elements: tuple[int, ...]) -> dict[str, Any]:
    """Levels of mesh and step; without the finest meshes, whose steps nobody would wait for."""
    scale = {n: (STANDARD_ELEMENTS / n) ** STEP_POWER for n in elements if n <= FINEST_FIXED}
    steps = {n: float(f"{STANDARD_STEP_S * factor:.2g}") for n, factor in scale.items()}
    return {
        f"{n} elements, dt {step:.1e} s": refined(base, name, n, {"name": "fixed", "step_s": step})
        for n, step in steps.items()
    }


def refined(base: Groups, name: str, elements: int, stepping: Mapping[str, Any]) -> Groups:
    """A level: a method on a mesh, with these steps."""
    integrator, mesh = {"name": name}, {"elements": elements}
    return changed(
        base, {"integrator": integrator, "discretization": mesh, "stepping": dict(stepping)}
    )


def curves(base: Groups, full: bool) -> list[Curve]:
    """Every composition that is compared; members that come later are in it by their names."""
    elements = FULL_ELEMENTS if full else QUICK_ELEMENTS
    lagged = changed(base, {"friction": {"name": "lagged"}})
    found = []
    for name in member_names("integrator"):
        ways = {"adaptive": adaptive(base, name, elements), "fixed": fixed(base, name, elements)}
        if name in VARIED:
            for words, steps in CONTACT_STEPS.items():
                ways[f"adaptive, {words}"] = adaptive(base, name, elements, contact_steps=steps)
            ways["adaptive, lagged friction"] = adaptive(lagged, name, elements)
            ways["fixed, lagged friction"] = fixed(lagged, name, elements)
        found += [Curve(f"{name} {way}", name, levels) for way, levels in ways.items()]
    return found + plain_curves(base, elements)


def plain_curves(base: Groups, elements: tuple[int, ...]) -> list[Curve]:
    """The default method with other meshes, clamps, starts, backends and refinements."""
    name = PLAIN_METHOD
    meshes = [n for n in member_names("discretization") if n != base["discretization"]["name"]]
    changes = {mesh: {"discretization": {"name": mesh}} for mesh in meshes} | CHANGES
    found = [
        Curve(
            f"{name}, {words}",
            words if words in meshes else name,
            adaptive(changed(base, change), name, elements),
        )
        for words, change in changes.items()
    ]
    found.append(
        Curve(f"{name}, one robot at a time", name, adaptive(base, name, elements), lanes=1)
    )
    matched = {n: tolerance(n) for n in elements}
    alone = {
        "tolerance alone": {
            f"{FINE} elements, tol {t:.1e}": (FINE, t, stick_share(n)) for n, t in matched.items()
        },
        "mesh alone": {
            f"{n} elements, tol {TIGHT:.1e}": (n, TIGHT, stick_share(FINE)) for n in elements
        },
    }
    for words, levels in alone.items():
        groups = {
            level: refined(
                base, name, n, {"name": "adaptive", "tolerance": t, "stick_share": share}
            )
            for level, (n, t, share) in levels.items()
        }
        found.append(Curve(f"{name}, {words}", name, groups))
    return found
