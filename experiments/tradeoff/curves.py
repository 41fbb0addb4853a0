"""The compositions that are compared: one curve each, over its own refinement knob.

A level refines time and mesh together, so that neither is wasted on the other's error: the
tolerance falls with the 4.5th power of the element's length (what the tiers were found to need).
A method whose error estimate has another order gets tolerances at which it takes as many steps.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from experiments.compositions import Groups, changed
from experiments.tradeoff.batches import LANES
from snapjump.declare.members import member_class, member_names

STANDARD_ELEMENTS, STANDARD_TOLERANCE = 104, 4.5e-8
TOLERANCE_POWER = 4.5
TOLERANCE_RANGE = (2e-12, 1e-3)
STANDARD_STEP_S = 2.5e-6
STEP_POWER = 1.5
FINEST_FIXED = 160
ESTIMATE_ORDER = 3.0  # of the default method
QUICK_ELEMENTS = (40, 56, 76, 104, 152, 224)
FULL_ELEMENTS = (32, 40, 48, 56, 64, 76, 88, 104, 128, 152, 184, 224, 272)
# Methods that are varied in every way; the others only in their steps.
VARIED = ("tr_bdf2", "sdirk2", "esdirk3", "implicit_euler")
PLAIN_METHOD = "tr_bdf2"
BLIND = 1e9  # contact_steps that leave contact to the error estimate


@dataclass(frozen=True)
class Curve:
    """A composition: its name, the method it is drawn under, and groups by level."""

    name: str
    method: str
    levels: Mapping[str, Groups]
    lanes: int = LANES

    def cell(self, level: str) -> str:
        """Name of the cell of a level."""
        return f"{self.name}, {level}"


def tolerance(elements: int, estimate_order: float = ESTIMATE_ORDER) -> float:
    """The tolerance that goes with a mesh."""
    matched: float = STANDARD_TOLERANCE * (STANDARD_ELEMENTS / elements) ** TOLERANCE_POWER
    matched **= estimate_order / ESTIMATE_ORDER
    return min(max(matched, TOLERANCE_RANGE[0]), TOLERANCE_RANGE[1])


def estimate_order(name: str) -> float:
    """Order of a method's error estimate."""
    return float(member_class("integrator", name)().scheme().error_power())


def adaptive(base: Groups, name: str, elements: tuple[int, ...], **stepping: Any) -> dict[str, Any]:
    """Levels of mesh and tolerance."""
    order = estimate_order(name)
    return {
        f"{n} elements, tol {tolerance(n, order):.1e}": changed(
            base,
            {
                "integrator": {"name": name},
                "discretization": {"elements": n},
                "stepping": {
                    "name": "adaptive",
                    "tolerance": float(f"{tolerance(n, order):.1e}"),
                    "contact_steps": 2.0,
                    **stepping,
                },
            },
        )
        for n in elements
    }


def fixed(base: Groups, name: str, elements: tuple[int, ...]) -> dict[str, Any]:
    """Levels of mesh and step; without the finest meshes, whose steps nobody would wait for."""
    scale = {n: (STANDARD_ELEMENTS / n) ** STEP_POWER for n in elements if n <= FINEST_FIXED}
    steps = {n: float(f"{STANDARD_STEP_S * factor:.2g}") for n, factor in scale.items()}
    return {
        f"{n} elements, dt {step:.1e} s": changed(
            base,
            {
                "integrator": {"name": name},
                "discretization": {"elements": n},
                "stepping": {"name": "fixed", "step_s": step},
            },
        )
        for n, step in steps.items()
    }


def curves(base: Groups, full: bool) -> list[Curve]:
    """Every composition that is compared; members that come later are in it by their names."""
    elements = FULL_ELEMENTS if full else QUICK_ELEMENTS
    lagged = changed(base, {"friction": {"name": "lagged"}})
    found = []
    for name in member_names("integrator"):
        found.append(Curve(f"{name} adaptive", name, adaptive(base, name, elements)))
        found.append(Curve(f"{name} fixed", name, fixed(base, name, elements)))
        if name not in VARIED:
            continue
        found += [
            Curve(
                f"{name} adaptive, half the steps in contact",
                name,
                adaptive(base, name, elements, contact_steps=4.0),
            ),
            Curve(
                f"{name} adaptive, twice the steps in contact",
                name,
                adaptive(base, name, elements, contact_steps=1.0),
            ),
            Curve(
                f"{name} adaptive, blind to contact",
                name,
                adaptive(base, name, elements, contact_steps=BLIND),
            ),
            Curve(f"{name} adaptive, lagged friction", name, adaptive(lagged, name, elements)),
            Curve(f"{name} fixed, lagged friction", name, fixed(lagged, name, elements)),
        ]
    return found + plain_curves(base, elements)


def plain_curves(base: Groups, elements: tuple[int, ...]) -> list[Curve]:
    """The default method with other meshes, clamps, starts, backends and refinements."""
    name = PLAIN_METHOD

    def levels(change: Mapping[str, Any]) -> dict[str, Any]:
        return adaptive(changed(base, change), name, elements)

    found = [
        Curve(f"{name}, {other}", other, levels({"discretization": {"name": other}}))
        for other in member_names("discretization")
        if other != base["discretization"]["name"]
    ]
    found += [
        Curve(f"{name}, two-node clamps", name, levels({"discretization": {"clamp": "two_nodes"}})),
        Curve(f"{name}, from flat clamps", name, levels({"sim": {"start_fraction": 0.0}})),
        Curve(f"{name}, late start", name, levels({"sim": {"start_fraction": 0.92}})),
        Curve(f"{name}, one robot at a time", name, adaptive(base, name, elements), lanes=1),
    ]
    fine = changed(base, {"integrator": {"name": name}, "discretization": {"elements": 224}})
    tight = changed(
        base,
        {"integrator": {"name": name}, "stepping": {"name": "adaptive", "tolerance": 2e-9}},
    )
    found.append(
        Curve(
            f"{name}, tolerance alone",
            name,
            {
                f"224 elements, tol {tolerance(n):.1e}": changed(
                    fine, {"stepping": {"name": "adaptive", "tolerance": tolerance(n)}}
                )
                for n in elements
            },
        )
    )
    found.append(
        Curve(
            f"{name}, mesh alone",
            name,
            {
                f"{n} elements, tol 2.0e-09": changed(tight, {"discretization": {"elements": n}})
                for n in elements
            },
        )
    )
    return found
