"""energy.png: stored energies, work and losses against time, and their balance."""

import pathlib
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.ledger import Ledger
from snapjump.show.plots.saving import picture

# Label, colour and width of each line.
LINES = {
    "elastic": ("elastic", palette.BEAM, 2.2),
    "kinetic": ("kinetic", palette.CLAMP, 2.2),
    "gravitational": ("gravitational", palette.CENTRE, 2.0),
    "contact": ("contact", palette.FORCE, 1.6),
    "friction_loss": ("lost to friction", palette.PLUM, 2.2),
    "damping_loss": ("lost to damping", palette.VIOLET, 2.2),
    "contact_loss": ("lost to contact", palette.FORCE, 2.2),
    "drag_loss": ("lost to the air", palette.CENTRE, 2.2),
    "numerical_loss": ("lost to numerics", palette.SKY, 2.2),
}


def energy_picture(
    ledger: Ledger, headline: str, window: tuple[float, float] | None, path: pathlib.Path
) -> None:
    """Stored energies above, work and losses below; on the right the same, close to `window`."""
    whole = float(ledger.time[0]), float(ledger.time[-1])
    struck = np.any(ledger.stored.get("contact", 0.0))
    close_up = "snap and strike" if struck else "snap"
    zooms = [("whole run", whole)] if window is None else [("whole run", whole), (close_up, window)]
    width = 0.675 if window is None else 0.325
    with picture(path, (12.0, 8.0), headline) as figure:
        for place, (title, limits) in enumerate(zooms):
            upper = figure.add_axes((0.075 + 0.35 * place, 0.43, width, 0.46))
            lower = figure.add_axes((0.075 + 0.35 * place, 0.08, width, 0.28))
            _draw_stored(upper, ledger)
            _draw_balance(lower, ledger)
            for axes in (upper, lower):
                axes.grid(True)
                axes.set_xlim(limits)
                axes.tick_params(labelbottom=axes is lower, labelleft=place == 0)
                if place == 0 and window is not None:
                    axes.axvspan(*window, color=palette.SHADE, zorder=0)
            lower.set_xlabel("time (ms)")
            upper.set_title(title, loc="left")
            if place == 0:
                lower.set_title("balance = stored − initial − work + losses")
                upper.set_ylabel("stored energy (EI/L)")
                lower.set_ylabel("work and losses (EI/L)")
        for axes, top in ((upper, 0.89), (lower, 0.36)):
            _second_scale(axes, ledger)
            corner = {"loc": "upper left", "bbox_to_anchor": (0.805, top + 0.015)}
            figure.legend(*axes.get_legend_handles_labels(), handlelength=1.5, **corner)


def _draw_stored(axes: Any, ledger: Ledger) -> None:
    """Each stored energy and their sum."""
    for name, values in ledger.stored.items():
        label, colour, width = LINES[name]
        if np.any(values):
            axes.plot(ledger.time, values, label=label, color=colour, lw=width)
    axes.plot(ledger.time, ledger.total, color=palette.INK, lw=1.6, ls="--", label="total stored")
    axes.axhline(0.0, color=palette.QUIET, lw=0.8, zorder=1)


def _draw_balance(axes: Any, ledger: Ledger) -> None:
    """Work of the clamps, losses, and the balance, which is zero."""
    if np.any(ledger.work):
        axes.plot(ledger.time, ledger.work, color=palette.QUIET, lw=2.2, label="work of the clamps")
    for name, values in ledger.lost.items():
        label, colour, width = LINES[name]
        if name == "numerical_loss":
            label = f"{label} ({values[-1]:.1g})"
        if np.any(values):
            axes.plot(ledger.time, values, label=label, color=colour, lw=width)
    worst = float(np.max(np.abs(ledger.balance)))
    label = f"balance (within {worst:.0e})"
    axes.plot(ledger.time, ledger.balance, color=palette.INK, lw=1.6, ls=":", label=label, zorder=5)


def _second_scale(axes: Any, ledger: Ledger) -> None:
    """A scale of millijoule, or microjoule, on the right."""
    name, factor = (
        ("mJ", 1e3) if ledger.unit_J * np.max(np.abs(ledger.total)) > 2e-4 else ("µJ", 1e6)
    )
    right = axes.secondary_yaxis(
        "right",
        functions=(lambda e: e * ledger.unit_J * factor, lambda e: e / ledger.unit_J / factor),
    )
    right.spines["right"].set_visible(True)
    axes.text(1.03, 1.02, name, transform=axes.transAxes, va="bottom")
