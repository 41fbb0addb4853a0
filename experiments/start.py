"""What the quasi-static start changes: ``python -m experiments.start`` prints a table.

A jump starts from the static solution at a share of the critical angle. The slow loading before
that is quasi-static as far as starting earlier changes nothing but the cost.
"""

import json
from dataclasses import replace

from experiments.designs import spread_designs
from experiments.errors import relative_errors
from snapjump.batch import simulate_batch, variants
from snapjump.composition import with_tier

SHARES = (0.0, 0.4, 0.7, 0.8, 0.85, 0.88)
DESIGNS = 16


def main() -> None:
    """Compare every share with the earliest start, flat clamps, at the reference tier."""
    base = with_tier("reference")
    batches = {
        share: simulate_batch(
            variants(
                replace(base, sim=base.sim.changed(start_fraction=share)), spread_designs(DESIGNS)
            )
        )
        for share in SHARES
    }
    report = {}
    for share, batch in batches.items():
        earliest = batches[SHARES[0]]
        x, y = relative_errors(batch.x_bar, batch.y_bar, earliest.x_bar, earliest.y_bar)
        report[f"{share:g}"] = {
            "x_change_max_percent": float(f"{x.max():.3g}"),
            "y_change_max_percent": float(f"{y.max():.3g}"),
            "newton_iterations": float(batch.newton_iterations.mean()),
        }
    print(json.dumps(report, indent=2))


if __name__ == "__main__":
    main()
