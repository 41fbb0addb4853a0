"""Critical angles of slender arches on fine meshes: ``python -m experiments.slender``.

Arches of b/L 5e-5 to 1e-3, 40 to 640 elements, three discretizations, epsilon 0.05 to 0.35; each is
computed several times, with a relative noise of 1e-15 on its first guess, both ways (the threshold
of a jump, and the walk from flat clamps). Prints one JSON object: how many were found or refused,
how often an angle lies farther from the median of its arch than it states, and the largest share
of what is stated that an angle is off.
"""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np

from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.robot.robot import Robot
from snapjump.statics.arch import StaticArch
from snapjump.statics.critical import find_snap
from snapjump.statics.rounding import LostToRoundingError
from snapjump.statics.threshold import computed_threshold

from .command import measured

NOISE = 1e-15
MESHES = (DiscreteElasticRod, Corotational, GeometricallyExact)
Arch = tuple[Robot, Any, float]


def slender_arches(count: int) -> list[Arch]:
    """Robots, meshes and pre-compressions."""
    random = np.random.default_rng(14)
    arches = []
    for k in range(count):
        ratio, elements = 5e-5 * 20.0 ** random.uniform(), 40.0 * 16.0 ** random.uniform()
        robot = Robot(thickness_m=0.02 * ratio)
        mesh = MESHES[k % 3](elements=2 * round(0.5 * elements))
        arches.append((robot, mesh, float(random.uniform(0.05, 0.35))))
    return arches


WAYS: dict[str, Callable[..., Any]] = {
    "threshold": computed_threshold.__wrapped__,
    "walk": lambda robot, mesh, epsilon: find_snap(robot, mesh, epsilon, 0.0),
}


def shake_guesses(seed: int) -> None:
    """Multiply every first guess from now on by a noise of its own."""
    random, plain = np.random.default_rng(seed), StaticArch.guess

    def guess(arch: StaticArch, upward: bool = True) -> Any:
        state = plain(arch, upward)
        return state * (1.0 + NOISE * random.uniform(-1.0, 1.0, len(state)))

    StaticArch.guess = guess  # type: ignore[assignment, method-assign]


def spread(way: Callable[..., Any], arch: Arch, tries: int) -> tuple[list[float], list[float], int]:
    """Angles and the errors they state (rad), and how many tries were refused by name."""
    angles, errors, refused = [], [], 0
    for _ in range(tries):
        try:
            found = way(*arch)
        except LostToRoundingError:
            refused += 1
        else:
            angles.append(found.alpha_rad)
            errors.append(found.alpha_error_rad)
    return angles, errors, refused


def walked(name: str, arches: int, tries: int) -> tuple[dict[str, Any], list[float], list[float]]:
    """The report of one way, and by arch its median angle and the error it states."""
    failed, refused, shares = 0, 0, []
    medians, stated = [], []
    for arch in slender_arches(arches):
        try:
            angles, errors, lost = spread(WAYS[name], arch, tries)
        except ArithmeticError as error:
            print(name, arch, error, file=sys.stderr)
            angles, errors, lost = [], [], 0
            failed += 1
        refused += lost > 0
        medians.append(float(np.median(angles)) if angles else np.nan)
        stated.append(max(errors, default=np.nan))
        shares += [abs(a - medians[-1]) / e for a, e in zip(angles, errors, strict=True)]
    told = {
        "failed": failed,
        "refused": refused,
        "beyond_what_is_stated": int(np.sum(np.array(shares) > 1.0)),
        "largest_share": round(float(np.max(shares)), 3),
        "largest_stated_rad": float(np.nanmax(stated)),
    }
    return told, medians, stated


def report(arches: int = 500, tries: int = 3) -> dict[str, Any]:
    """Both ways, and how often they are apart by more than they state together."""
    shake_guesses(seed=1)
    found = {name: walked(name, arches, tries) for name in WAYS}
    told, medians, stated = zip(*found.values(), strict=True)
    apart = np.abs(np.subtract(*medians)) / np.sum(stated, axis=0)
    return {
        "arches": arches,
        "tries": tries,
        **dict(zip(WAYS, told, strict=True)),
        "apart_beyond_what_is_stated": int(np.sum(apart > 1.0)),
    }


if __name__ == "__main__":
    measured(report)
