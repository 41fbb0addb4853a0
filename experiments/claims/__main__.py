"""What jumps claim of their accuracy: ``python -m experiments.claims`` prints one JSON object.

With ``--table docs/accuracy.md`` it also replaces the table there. ``--seed`` chooses the robots:
any but those that the estimate was calibrated with (101 to 105) judges it.
"""

import sys
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.checks import check_integer
from snapjump.files.atomic import write_text
from snapjump.files.cores import own_cores
from snapjump.run.tasks.publish import replaced
from snapjump.show.terminal.block import markdown_table

from ..command import measured
from .judge import JUDGED, SECOND, TRUTH, drawn, judged
from .robots import KINDS

BLOCK = "claims"


def report(
    robots: int = 300, seed: int = 1, threads: int = len(own_cores()), table: str = ""
) -> dict[str, Any]:
    """Rows by kind of robots and tier; ``table``: a Markdown file with the block to replace."""
    check_integer("--robots", robots, 1, 100_000)
    found: dict[str, Any] = {"robots": robots, "seed": seed, "truth": TRUTH, "second truth": SECOND}
    for kind in KINDS:
        print(f"{kind} ...", file=sys.stderr)
        kept, tally = drawn(kind, robots, seed, threads)
        rows, unsure = judged(kept, threads)
        known = unsure[np.isfinite(unsure)]
        found[kind] = {
            "drawn again": dict(tally),
            "error of the truth, median and 95 % (%)": [
                float(f"{np.percentile(known, share):.2g}") for share in (50.0, 95.0)
            ],
            "tiers": rows,
        }
    if table:
        page = Path(table)
        text = replaced(page.read_text(encoding="utf-8"), BLOCK, block(found))
        if text is None:
            raise SystemExit(f"{table} has no block {BLOCK}")
        write_text(page, text)
    return found


def block(found: dict[str, Any]) -> str:
    """The table, and what stands below it."""
    first = next(iter(KINDS))
    header = ["robots", "tier", *found[first]["tiers"][JUDGED[0]]]
    rows = [
        [kind, f"`{name}`", *(f"{value:g}" for value in found[kind]["tiers"][name].values())]
        for kind in KINDS
        for name in JUDGED
    ]
    errors = "; ".join(
        f"{kind} {median:g} and {high:g} %"
        for kind in KINDS
        for median, high in [found[kind]["error of the truth, median and 95 % (%)"]]
    )
    again = "; ".join(
        f"{kind}: " + ", ".join(f"{count} {status}" for status, count in tally.items() if count)
        for kind in KINDS
        for tally in [found[kind]["drawn again"]]
        if any(tally.values())
    )
    return (
        f"{markdown_table(header, rows)}\n\n"
        f"{found['robots']} robots of each kind that end `ok` at `standard` (seed {found['seed']}; "
        f"drawn again: {again}).\nThe truth: {TRUTH['integrator']}, {TRUTH['elements']} elements, "
        f"tolerance {TRUTH['tolerance']:g}; its own error, by a\nsecond one of "
        f"{SECOND['elements']} elements and tolerance {SECOND['tolerance']:g}, median and 95 %: "
        f"{errors}.\n"
        f"`python -m experiments.claims --seed {found['seed']} --table docs/accuracy.md`\n"
    )


if __name__ == "__main__":
    measured(report)
