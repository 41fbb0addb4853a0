"""Sentences of the report that are not about one part."""

from collections.abc import Sequence

from experiments.paper.statement import VERDICTS, Statement
from snapjump.terminal.block import markdown_table
from snapjump.tiers import TIERS

# Of the tier `paper`, as in conf/accuracy/paper.yaml.
SETTINGS = (
    f"implicit Euler at {TIERS['paper'].numbers['stepping.step_s']:g} s, lagged friction, clamps "
    "of two fixed nodes, contact stiffness per node, no material damping"
)
TITLE = "The paper, reproduced and judged"
INTRODUCTION = [
    "The paper is *Inverse Design of Snap-Actuated Jumping Robots Powered by Mechanics-Aided "
    "Machine Learning* (Tong, Hao, Liu, Huang, arXiv 2408.10470). Every figure below is simulated "
    "anew by this library and every number is computed by the command above, at the tier "
    "`standard` unless it says otherwise; `paper` is the tier of the paper's settings: "
    f"{SETTINGS}. A verdict is decided by the program from the numbers beside it. What still "
    "counts as linear, flat or alike is our choice, in places made when the numbers were known: "
    "read the numbers, not the verdict alone.",
    "Statements are in our words. Where the paper assumes something, or draws a curve without a "
    "claim, the statement is our reading of it, and says so.",
    "The converged model differs from the paper's in three respects. Its material damps "
    "(Kelvin-Voigt with η = 1e-5 s, the size of the paper's time step; the paper's implicit Euler "
    "damps what oscillates too, but not what buckles). Its frame is rigid, also at the tier "
    "`paper`; the paper's is an elastic chain of 1000 EI. And the ground is as stiff on every mesh "
    "as on the paper's, whose nodes have a spring each. What these do to a jump, and what the "
    "numerical choices do, is taken apart below.",
]


def readme_block(statements: Sequence[Statement]) -> str:
    """Statements and verdicts alone, for the README."""
    rows = [[str(k), one.says.rstrip("."), one.verdict] for k, one in enumerate(statements, 1)]
    told = ", ".join(
        f"{sum(one.verdict == verdict for one in statements)} {verdict}" for verdict in VERDICTS
    )
    return (
        markdown_table(["", "the paper says", "verdict"], rows)
        + f"\n\n{told}; the numbers, figures and causes: [docs/paper.md](docs/paper.md).\n"
        "`python run.py task=paper publish=docs` makes this table and that report."
    )
