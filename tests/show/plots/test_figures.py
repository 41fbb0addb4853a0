"""The files that `figures` leaves: which, of what size, and that nothing makes it crash."""

import copy
import pathlib
from typing import Any

import numpy as np
import pytest
from command_line import python
from pictures import has, picture
from PIL import Image

from snapjump.composition import with_tier
from snapjump.show.plots import figures, palette
from snapjump.show.plots.branches import stable_runs
from snapjump.show.plots.film import ACTION, FLIGHT, LEAD, SIZE
from snapjump.simulation import simulate

from .conftest import of


def names(paths: list[pathlib.Path]) -> set[str]:
    return {path.name for path in paths}


def part(result: Any, keep: slice | np.ndarray) -> Any:
    """The same result with some of its samples."""
    arrays = {name: values[keep] for name, values in result.arrays.items()}
    return of(result, status="stalled", summary={}, arrays=arrays)


def test_jump_files_are_images_of_the_right_size(jump, tmp_path):
    told: list[tuple[float, str]] = []
    paths = figures(jump, tmp_path / "new", lambda done, text: told.append((done, text)))
    assert names(paths) == {"jump.png", "jump.gif", "energy.png"}
    assert sorted(paths) == sorted((tmp_path / "new").iterdir()), "and no temporary files"
    for path in paths:
        with Image.open(path) as image:
            image.load()
            assert image.size == (SIZE if path.suffix == ".gif" else (1440, 960))
    assert [done for done, _ in told] == [0.0, pytest.approx(1 / 3), pytest.approx(2 / 3)]
    assert all(any(path.name in text for _, text in told) for path in paths)


def test_the_largest_strain_is_marked(jump, tmp_path):
    """On the beam, and in the key."""
    marked = picture(figures(jump, tmp_path, film=False)[0])
    summary = {name: value for name, value in jump.summary.items() if name != "max_strain"}
    plain = picture(figures(of(jump, summary=summary), tmp_path, film=False)[0])
    assert has(marked, palette.PLUM, 100) and not has(plain, palette.PLUM, 0)


def test_film_shows_snap_strike_and_flight(jump, tmp_path):
    figures(jump, tmp_path)
    with Image.open(tmp_path / "jump.gif") as film:
        assert film.n_frames == LEAD + ACTION + FLIGHT
        first = np.asarray(film.convert("RGB")).copy()
        film.seek(film.n_frames - 1)
        last = np.asarray(film.convert("RGB"))
    assert (first != last).any(axis=2).mean() > 0.1
    assert (tmp_path / "jump.gif").stat().st_size < 3_000_000


def test_film_is_optional(jump, tmp_path):
    assert names(figures(jump, tmp_path, film=False)) == {"jump.png", "energy.png"}


def test_snap_has_neither_ground_nor_flight(snap, tmp_path):
    assert names(figures(snap, tmp_path)) == {"snap.png", "snap.gif", "energy.png"}
    with Image.open(tmp_path / "snap.gif") as film:
        assert film.n_frames == LEAD + ACTION


@pytest.mark.parametrize("count", [1, 2, 3, 7, 120, 200])
@pytest.mark.parametrize("which", ["jump", "snap"])
def test_truncated_runs_are_drawn(which, count, request, tmp_path):
    short = part(request.getfixturevalue(which), slice(0, count))
    assert f"{which}.png" in names(figures(short, tmp_path))


def test_samples_that_are_not_finite_are_left_out(jump, tmp_path):
    broken = copy.deepcopy(jump)
    broken.arrays["node_y_m"][-3:] = np.nan
    broken.arrays["kinetic_J"][-1] = np.inf
    broken.summary.update(x_bar=None, y_bar=float("nan"), apex_time_s=None)
    assert len(figures(broken, tmp_path)) == 3


def test_no_finite_samples_no_figures(jump, tmp_path):
    lost = {name: np.full_like(values, np.nan) for name, values in jump.arrays.items()}
    nothing = of(jump, status="failed", summary={}, arrays={})
    for result in (of(jump, arrays=lost), part(jump, slice(0, 0)), nothing):
        assert figures(result, tmp_path) == []


@pytest.mark.compiles
@pytest.mark.parametrize("scene", ["bounce", "slide"])
def test_one_node_is_drawn_against_time(scene, tmp_path):
    result = simulate(with_tier("draft", sim=scene))
    assert names(figures(result, tmp_path)) == {f"{scene}.png", "energy.png"}


@pytest.mark.parametrize(
    ("scene", "kept"), [("static", ""), ("cantilever", "shapes"), ("static", "branch")]
)
def test_branches_and_shapes(scene, kept, tmp_path):
    result = simulate(with_tier("draft", sim=scene))
    arrays = {name: values for name, values in result.arrays.items() if name.startswith(kept)}
    (path,) = figures(of(result, arrays=arrays), tmp_path)
    with Image.open(path) as image:
        assert path.name == f"{scene}.png" and image.size == (1440, 780)


def test_pictures_are_lazy():
    """matplotlib and Pillow cost most of a second: only who draws pays for them."""
    code = "import sys, snapjump.show.plots; print({'matplotlib', 'PIL'} & set(sys.modules))"
    assert python("-c", code).stdout.strip() == "set()"


def test_runs_part_at_another_branch_and_join_at_a_change_of_stability():
    number = np.array([0, 0, 0, 0, 1, 1, 1])
    negative = np.array([0, 0, 1, 1, 0, 0, 0])
    runs = [(run.start, run.stop, stable) for run, stable in stable_runs(number, negative)]
    assert runs == [(0, 3, True), (2, 4, False), (4, 7, True)]
    assert list(stable_runs(np.array([]), np.array([]))) == []
