"""What a later start leaves out: ``python -m experiments.start`` prints one JSON object.

A jump starts from flat clamps, or, by ``sim.start_fraction``, from the static solution at a share
of the critical angle: the slow loading up to there is then taken as quasi-static, and its steps
are saved.
"""

from dataclasses import replace
from typing import Any

from snapjump.batch import simulate_batch, variants
from snapjump.composition import with_tier

from .command import measured
from .designs import spread_designs
from .errors import relative_errors

SHARES = (0.0, 0.4, 0.7, 0.8, 0.85, 0.88)
DESIGNS = 16


def report() -> dict[str, Any]:
    """Every share compared with flat clamps, the default, at the reference tier."""
    base, designs = with_tier("reference"), spread_designs(DESIGNS)
    starts = [replace(base, sim=base.sim.changed(start_fraction=share)) for share in SHARES]
    batches = [simulate_batch(variants(start, designs)) for start in starts]
    found = {}
    for share, batch in zip(SHARES, batches, strict=True):
        x, y = relative_errors(batch.x_bar, batch.y_bar, batches[0].x_bar, batches[0].y_bar)
        found[f"{share:g}"] = {
            "x_change_max_percent": float(f"{x.max():.3g}"),
            "y_change_max_percent": float(f"{y.max():.3g}"),
            "newton_iterations": float(batch.newton_iterations.mean()),
        }
    return found


if __name__ == "__main__":
    measured(report)
