"""Tables of the benchmark: misses, times and unsolved targets by method."""

from collections.abc import Mapping, Sequence

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.terminal.block import markdown_table

from .methods import PAPER, SOLVED_MM, TIERS


def summary_row(method: str, rows: Sequence[Row]) -> Row:
    """One line of the table: misses in mm at L = 20 mm at both tiers, those that are known."""
    found: Row = {"method": method, "problems": len(rows)}
    for tier in TIERS:
        misses = column(rows, f"miss_{tier}_mm")
        known = misses[np.isfinite(misses)]
        found[f"failed_{tier}"] = len(misses) - len(known)
        words = ("mean", "std", "median", "p95", "max")
        found |= {f"{word}_mm_{tier}": figure(word, known) for word in words}
    found["solved"] = sum(solved(row) for row in rows)
    found["called_unreachable"] = sum(not row["reachable"] for row in rows)
    seconds = column(rows, "seconds")
    found |= {f"seconds_{word}": figure(word, seconds) for word in ("mean", "median", "p95", "max")}
    found["simulations_mean"] = float(column(rows, "simulations").mean())
    return found


def figure(word: str, values: np.ndarray) -> float:
    """A mean, std, median, max or 95th percentile; NaN of no values."""
    if len(values) == 0:
        return float("nan")
    return float(np.quantile(values, 0.95) if word == "p95" else getattr(np, word)(values))


def solved(row: Row) -> bool:
    """Whether a target was hit, judged at the tier that the method finished at."""
    miss = row[f"miss_{row['finished_at']}_mm"]
    return bool(row["reachable"]) and miss is not None and miss < SOLVED_MM


def readme_block(table: Sequence[Row], problems: int) -> str:
    """The table for people, beside the paper's."""
    header = [
        "method",
        "judged at `standard`: mean ± std, 95 %, max (mm)",
        "judged at `reference` (mm)",
        "solved",
        "time: median, 95 % (s)",
        "simulations",
    ]
    lines = []
    for row in table:
        member, comma, how = row["method"].partition(",")
        misses = [
            f"{row[f'mean_mm_{tier}']:.2g} ± {row[f'std_mm_{tier}']:.2g}, "
            f"{row[f'p95_mm_{tier}']:.2g}, {row[f'max_mm_{tier}']:.2g}"
            + (f" ({row[f'failed_{tier}']} failed)" if row[f"failed_{tier}"] else "")
            for tier in TIERS
        ]
        tally = f"{row['solved']} of {row['problems']}"
        times = f"{row['seconds_median']:.2g}, {row['seconds_p95']:.2g}"
        cost = [times, f"{row['simulations_mean']:.3g}"]
        lines.append([f"`{member}`{comma}{how}", *misses, tally, *cost])
    for row in PAPER:
        spread = f" ± {row['std_mm']}" if "std_mm" in row else ""
        told = f"{row['mean_mm']}{spread} (by its own program)"
        lines.append([str(row["method"]), told, "", "", f"{row['seconds']:g}", ""])
    told = markdown_table(header, lines)
    return told + (
        f"\n\n{problems} random environments, each with a target that a hidden design reaches\n"
        "at `standard`. Misses are simulated, in mm at L = 20 mm; solved: below "
        f"{SOLVED_MM} mm at the tier that\nthe method finished at. Times are of one core.\n"
        "`python run.py task=inverse_benchmark publish=docs/studies` makes this table."
    )


def unsolved(methods: Mapping[str, Sequence[Row]]) -> list[Row]:
    """Every target that ``physics`` did not hit, with what was found when looking about its answer.
    Where even the nearest of those designs misses, the map jumps over the target."""
    keys = ("problem", "reachable", "target_x_bar", "target_y_bar", "mass_bar", "mu",
            "hidden_delta_alpha_rad", "hidden_epsilon", "delta_alpha_rad", "epsilon",
            "miss_own_mm", "miss_standard_mm", "miss_reference_mm", "simulations")  # fmt: skip
    return [
        {
            "method": name,
            **{key: row[key] for key in keys},
            "nearest_around_mm": row.get("nearest_around_mm"),
        }
        for name, rows in methods.items()
        if name.startswith("physics")
        for row in rows
        if not solved(row)
    ]
