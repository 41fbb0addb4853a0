"""What is said of the paper's choices, and of the convergence of its settings."""

from collections.abc import Mapping, Sequence

from experiments.errors import Shift
from experiments.paper.base import Said, paragraphs, prose

TITLE = "What causes the difference"
EXCHANGED = "Shift of the apex by one exchanged choice; y's medians with their signs"
Moved = Mapping[tuple[str, str], Shift]
# Shifts (%) in the median that are seen in the paper's settings, and not in the converged ones.
SEEN_PERCENT, UNSEEN_PERCENT = 1.0, 1.0
# Of a first-order scheme's gain by a shorter step: a strike that gains less is not resolved.
SLOWNESS = 0.5


def figure(designs: int) -> str:
    """Below the figure."""
    return prose(f"""How far the apex moves when one choice is exchanged: median (mark) to 95 % of
        {designs} designs (bar)""")


def medians(one: Shift) -> str:
    """Of x and y."""
    return f"{one.x_median:.2g} and {one.y_median:.2g} %"


def tails(one: Shift) -> str:
    """Of x and y."""
    return f"{one.x_p95:.2g} and {one.y_p95:.2g} %"


def moves(one: Shift) -> str:
    """Both, as a clause."""
    return (
        f"x_c moves by {one.x_median:.2g} % and y_c by {one.y_median:.2g} % in the median, by at "
        f"most {tails(one)} in 95 % of the designs"
    )


def frame(
    designs: int,
    at_paper: Shift,
    ladder: Mapping[float, Shift],
    off: Shift,
    epsilon: tuple[float, float],
    lost: int,
) -> Said:
    """ladder: shifts by how many times stiffer than the beam the frame is; off: of the softest
    from reference; epsilon: of the baseline, and what is left of it where the motion starts in the
    softest frame; lost: failed jumps in that."""
    softest = min(ladder)
    stiffer = "; ".join(
        f"{medians(one)} ({ratio:,.0f} EI)" for ratio, one in ladder.items() if ratio > softest
    )
    far = " and count as infinitely far" if lost else ""
    return Said(
        "A frame that is 1,000 times as stiff as the beam is rigid",
        f"""Against a rigid frame {moves(ladder[softest])} (with the paper's settings by
        {medians(at_paper)}, {tails(at_paper)}). {lost} of {designs} jumps fail{far}. With stiffer
        frames the medians are {stiffer}. The beam's thrust pushes the legs apart: before the snap
        only ε = {epsilon[1]:.3f} is left of the baseline's {epsilon[0]:g}, and the clamps turn
        with the legs.""",
        f"""`standard`, {designs} designs, against `reference` within {off.x_median:.1g} % in x and
        {off.y_median:.1g} % in y in the median, {off.x_p95:.1g} and {off.y_p95:.1g} % in 95 % of
        them; the paper's settings""",
    )


def step(designs: int, steps: Mapping[float, Shift], finest_s: float) -> Said:
    """steps: shifts from the finest step, by step."""
    own, shortest = max(steps), min(steps)
    last = steps[shortest]
    slowly = steps[own].x_median / last.x_median < SLOWNESS * own / shortest
    others = "; ".join(f"{s:g} s: {medians(one)}" for s, one in steps.items() if s < own)
    return Said(
        f"A time step of {own:g} s is small enough: it is of a convergence study",
        f"""Against a step of {finest_s:g} s, all else as in the paper, {moves(steps[own])}
        ({others}).{" Shorter steps come nearer only slowly." if slowly else ""} The limit itself
        is no better known than the two smallest steps agree: to {last.x_median:.2g} % in x_c and
        {last.y_median:.2g} % in y_c.""",
        f"""the paper's settings, {designs} designs; the two smallest steps are {last.x_median:.2g}
        % apart in x and {last.y_median:.2g} % in y""",
    )


def nodes(designs: int, own: Shift, converged: Shift, noise: Shift) -> Said:
    """Shifts by the mesh at both ends, and what an exchange that changes nothing shifts."""
    return Said(
        "190 nodes, 67 of them on the beam, are enough: they are of a convergence study",
        f"""With the 224 elements of `reference` on the beam instead of 66, all else as in the
        paper, {moves(own)}. Most of it is the noise of a strike that the step does not resolve:
        another start of the same jump moves x_c by {noise.x_median:.2g} % in the median and
        {noise.x_p95:.2g} % in 95 % of the designs. In the converged settings 66 elements move the
        apex by {medians(converged)} in the median, by {tails(converged)} in 95 % of the
        designs.""",
        f"the paper's settings and `reference`, {designs} designs",
    )


def contact(designs: int, harder: Mapping[str, Shift]) -> Said:
    """Shifts by each number of the contact."""
    told = "; ".join(f"{title}: {moves(one)}" for title, one in harder.items())
    return Said(
        """K_c = 10⁴ N/m, d̃ = 0.5 mm and ε_v = 10⁻⁴ m/s are of a convergence study: a harder ground
        and a smaller velocity would change nothing""",
        f"""In the converged model, with one number changed at a time: {told}. How hard the ground
        is, convergence cannot tell: it is to be measured.""",
        f"`standard`, {designs} designs",
    )


def smooth(last: float) -> Said:
    """The law of friction as it is printed; last: its share of full friction at ε_v."""
    return Said(
        "The friction between sticking and sliding is smooth, and its law differentiable",
        f"""As the text prints it, μ N (v/ε_v - v²/ε_v²) below ε_v and μ N from there on, the law
        has come back to {last:g} at ε_v and leaps to full friction. With 2 v/ε_v in the place of
        v/ε_v, as in the source of the law (Li et al. 2020) and in this library, it is continuous
        with its slope. A slip of the text: the released program's jumps are met by the continuous
        law.""",
        "the text's equations",
    )


def stability(counted: Mapping[float, tuple[int, int, float]], barrier_m: float) -> Said:
    """By step (s), the paper's first: failed jumps, all, and the smallest gap (m)."""
    (_, (lost, count, gap_m)), *others = counted.items()
    longer = "; ".join(f"{s:g} s: {a} of {b}, {1e3 * gap:.2g} mm" for s, (a, b, gap) in others)
    gaps = [1e3 * gap for _, _, gap in counted.values()]
    return Said(
        """Implicit Euler is robust, and with the logarithmic barrier no gap becomes negative, as
        Signorini's condition demands""",
        f"""{lost} of {count} jumps over the paper's ranges fail. The smallest gap at the end of
        any step is {1e3 * gap_m:.2g} mm, {gap_m / barrier_m:.2g} of the barrier's distance. That
        none closes is no finding: Newton's steps are limited so that no gap can, and failures
        alone are judged. With longer steps, which are halved where Newton's method fails, failures
        and smallest gaps: {longer}. Stability says nothing of accuracy.""",
        f"""the paper's settings; smallest gaps at all steps {min(gaps):.2g} to {max(gaps):.2g}
        mm""",
    )


def told(moved: Moved, apart: Shift, lost: Sequence[str]) -> list[str]:
    """What is exchanged, what matters most, and what only seems to; lost: cells with failures."""
    y = {key: f"{one.y_signed:+.2g} %" for key, one in moved.items()}
    own = {title: one for (end, title), one in moved.items() if end == "reference"}
    first = sorted(own, key=lambda title: -own[title].x_median)[:4]
    most = ", ".join(f"{title} ({own[title].x_median:.2g} %)" for title in first)
    text = f"""The paper's settings and the converged ones differ in several choices. Each is
        exchanged alone, once in the paper's settings and once in the converged ones, over the same
        designs spread over the paper's ranges. In the converged settings implicit Euler brings its
        fixed step along; in the paper's settings the step is made ten times shorter. With 66
        elements K per node and per length are the same by definition. Both ends have a rigid
        frame; the paper's own is elastic, which comes on top.

        The paper's settings are {apart.x_median:.2g} % off in x_c and {apart.y_median:.2g} % in
        y_c in the median (at most {tails(apart)} in 95 % of them). Their y_c is
        {apart.y_signed:+.2g} % from the converged one in the median. Without material damping the
        converged y_c moves by {y["reference", "no material damping"]}, and with it the paper's by
        {y["paper", "no material damping"]}; the paper's implicit Euler at 1e-5 s, which damps what
        oscillates, moves the converged y_c by {y["reference", "implicit Euler"]}. In x_c most is
        moved, put into the converged settings, by {most}."""
    failures = [f"Failed jumps count as infinitely far: {'; '.join(lost)}."] if lost else []
    return [*paragraphs(text), noise(moved), *failures]


def noise(moved: Moved) -> str:
    """How much of the shifts in the paper's settings is sensitivity alone."""
    start, frame = "start from flat clamps", "frame of 1000 EI"
    papers, converged = moved["paper", start], moved["reference", start]
    seeming = [
        title
        for title in dict.fromkeys(title for _, title in moved)
        if title not in (start, frame)
        and moved["paper", title].x_median >= SEEN_PERCENT
        and moved["reference", title].x_median <= UNSEEN_PERCENT
    ]
    largest = max((moved["reference", title].x_median for title in seeming), default=0.0)
    told = (
        f"So do {', '.join(seeming)}: they seem to matter in the paper's settings, and in the "
        f"converged ones they move x_c by at most {largest:.2g} % in the median."
        if seeming
        else "No other choice moves x_c in the paper's settings alone."
    )
    return prose(f"""Much of this is noise of a strike that the step does not resolve. A start
        nearer to the snap is the same jump, and moves the converged x_c by
        {converged.x_median:.1g} %; with the paper's settings it moves x_c by {papers.x_median:.2g}
        % in the median and by at most {papers.x_p95:.2g} % in 95 % of the designs. {told}""")
