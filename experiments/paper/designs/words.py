"""What is said of inverse designs."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.inverse_benchmark.methods import LENGTH_MM, PAPER
from experiments.paper.base import Said, paragraphs, prose
from experiments.paper.settings import BASELINE
from snapjump.run.studies.base import Row, column

TITLE = "Inverse designs"
FLIGHTS = prose("""Simulated flights of designs by the forward model (`gauss_newton`), from lift-off
    to the apex and on past it (dashed); crosses: targets. Left: one robot; right: eight, of which
    R4 and R5 share a target""")
MISSES = "Misses of all targets at L = 20 mm, judged at three tiers; line: the paper's mean"


def millimetres(lines: Mapping[str, Row], learned: Sequence[str], off: Mapping[str, float]) -> Said:
    """Misses of all methods, and of those that ask the forward model alone at the paper's
    settings; off: how far the misses are from those at other tiers (mm)."""
    told = "; ".join(
        f"`{name}` {one['mean at standard']:.2g} ± {one['std at standard']:.2g} mm "
        f"(largest {one['max at standard']:.2g}; judged at reference "
        f"{one['mean at reference']:.2g} ± {one['std at reference']:.2g}) in "
        f"{one['seconds, median']:.2g} s"
        for name, one in lines.items()
    )
    theirs = f"{PAPER[0]['mean_mm']} ± {PAPER[0]['std_mm']} mm in {PAPER[0]['seconds']} s"
    at_paper = " and ".join(f"{lines[name]['mean at paper']:.2g} mm (`{name}`)" for name in learned)
    return Said(
        "A design found with the forward model reaches its target within millimetres",
        f"""{lines[learned[0]]["targets"]} targets, misses at L = 20 mm: {told}. The paper tells
        {theirs}, judged by its own program. Simulated at the paper's settings, which move the
        apexes, those by the forward model alone miss by {at_paper} in the mean.""",
        f"""`standard`; the misses at `reference` differ by up to {off["reference"]:.2g} mm, those
        at `paper` by up to {off["paper"]:.2g} mm""",
    )


def told(methods: Mapping[str, Sequence[Row]], groups: Mapping[str, Sequence[Any]]) -> list[str]:
    """What is shown, what is found, what differs and why."""
    designs, physics = methods["gauss_newton"], methods["physics"]
    learned = column(designs, "miss_standard_mm")
    reachable = sum(bool(row["reachable"]) for row in designs)
    own, finer, papers = (
        np.nanmean(column(physics, f"miss_{tier}_mm"))
        for tier in ("standard", "reference", "paper")
    )
    pair = [row for row in designs if row["robot"] in ("R4", "R5")]
    controls = " and ".join(
        f"Δα = {row['delta_alpha_rad']:.3f} rad, ε = {row['epsilon']:.3f} for m̄ = "
        f"{row['mass_bar']:g}, μ = {row['mu']:g}"
        for row in pair
    )
    far = designs[int(np.nanargmax(learned))]
    share = np.nanmax(learned) / (LENGTH_MM * far["target_y_bar"])
    one, many = (len(cases) for cases in groups.values())
    return paragraphs(f"""{one} targets within the region of one robot (m̄ = {BASELINE[2]:g}, μ =
        {BASELINE[3]:g}), and {many} robots of different masses on different grounds, each with a
        target within its region; {reachable} of the {len(physics)} are called reachable by the
        forward model. Every target is designed for in three ways: `adam`, the paper's gradient
        descent on the forward model; `gauss_newton`, which asks the same model; and `physics`,
        which corrects by simulations.

        Half of the designs by `gauss_newton` are within {np.nanmedian(learned):.2g} mm of their
        targets. The farthest, {far["robot"]} with m̄ = {far["mass_bar"]:g}, is
        {np.nanmax(learned):.2g} mm off, {100 * share:.2g} % of its flight's height. Two robots
        reach the same target ({pair[0]["target_x_bar"]:g}, {pair[0]["target_y_bar"]:g}) L, on the
        same parabola, with {controls}.

        `physics` takes the forward model's error out: {own:.2g} mm in the mean for
        {np.mean(column(physics, "simulations")):.2g} simulations a target. Judged at `reference`
        it is {finer:.2g} mm, the error of the tier that it searched at.

        The paper's settings move the apexes themselves, so that designs that are right for
        converged jumps are off by {papers:.2g} mm in the mean there; and they scatter from one
        design to the next, which limits what a forward model can learn from them. The benchmark of
        inverse design has random targets.""")
