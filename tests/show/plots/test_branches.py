"""Branches: solid where stable, dashed where not, parted where another begins."""

import numpy as np
from PIL import Image

from snapjump.show.plots import figures
from snapjump.show.plots.branches import stable_runs

from .conftest import of


def test_runs_part_at_another_branch_and_join_at_a_change_of_stability():
    number = np.array([0, 0, 0, 0, 1, 1, 1])
    negative = np.array([0, 0, 1, 1, 0, 0, 0])
    runs = [(run.start, run.stop, stable) for run, stable in stable_runs(number, negative)]
    assert runs == [(0, 3, True), (2, 4, False), (4, 7, True)]
    assert list(stable_runs(np.array([]), np.array([]))) == []


def test_static_and_cantilever(jump, tmp_path):
    alpha = np.linspace(0.0, 1.2, 60)
    arch = 0.28 - 0.05 * alpha**2
    arrays = {
        "branch_alpha_rad": np.concatenate([alpha, alpha]),
        "branch_midpoint_bar": np.concatenate([arch, -0.3 - 0.05 * alpha]),
        "branch_energy_bar": np.concatenate([5.0 + 3.0 * alpha, 9.0 - 3.0 * alpha]),
        "branch_negative_pivots": np.concatenate([alpha > 0.9, 0 * alpha]),
        "branch_number": np.repeat([0, 1], len(alpha)),
    }
    x = np.linspace(-0.4, 0.4, 50)
    arrays["shapes_x_bar"] = np.stack([x, x])
    arrays["shapes_y_bar"] = np.stack([0.2 * np.cos(4 * x) ** 2, -0.3 * np.cos(3.9 * x)])
    arrays["shapes_label"] = np.array(["critical, 0.9117 rad", "snapped"])
    for scene, keep in (("static", ""), ("cantilever", "shapes"), ("static", "branch")):
        kept = {name: values for name, values in arrays.items() if name.startswith(keep)}
        result = of(jump, scene, summary={"alpha_critical_rad": 0.911665}, arrays=kept)
        paths = figures(result, tmp_path / f"{scene}{keep}")
        assert [path.name for path in paths] == [f"{scene}.png"]
        with Image.open(paths[0]) as image:
            assert image.size == (1440, 780)
