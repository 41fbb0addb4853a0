"""Results show themselves: text, pictures, films, tables, attributes that an editor completes."""

import io
import pickle
import typing

import numpy as np
import pytest
from PIL import Image

from snapjump import simulate, simulate_designs, simulate_jump
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.declare.outputs import FLAG, INTEGER, NUMBER, WORD
from snapjump.results import JumpResult
from snapjump.scenes.jump_outputs import RecordedJump
from snapjump.views.picture import Picture

KINDS = {NUMBER: float, INTEGER: int, FLAG: bool | None, WORD: str}


@pytest.fixture(scope="module")
def jump():
    return simulate_jump(accuracy="draft")


@pytest.fixture(scope="module")
def batch():
    lags = np.linspace(0.01, 0.19, 8)
    designs = np.column_stack([lags, *np.broadcast_to([[0.2], [0.768], [0.3]], (3, 8))])
    designs[-1, 1] = 0.9  # refused
    return simulate_designs("draft", designs)


def opened(picture: Picture) -> typing.Any:
    return Image.open(io.BytesIO(picture.data))


def test_a_jump_in_a_line_and_as_the_terminal_has_it(jump):
    line = repr(jump)
    assert line.startswith("<jump ok, epsilon 0.2") and "\n" not in line and "apex x 5.3" in line
    text = str(jump)
    assert (
        text.startswith("jump  epsilon 0.2")
        and "  build " in text
        and "4 g in all where g = 10 m/s^2" in text
    )


def test_its_pictures(jump, tmp_path):
    assert opened(jump.plot()).format == "PNG" and jump.plot()._repr_png_()
    assert jump.plot("energy").name == "energy.png"
    with pytest.raises(ParameterError, match="one of jump, energy"):
        jump.plot("enregy")
    film = jump.film()
    assert opened(film).format == "GIF" and opened(film).n_frames > 20
    assert "data:image/gif;base64," in (film._repr_html_() or "")
    page = jump._repr_html_()
    assert page.startswith("<pre>jump") and "data:image/png;base64," in page
    assert film.save(tmp_path / "a.gif").stat().st_size == len(film.data)


def test_its_figures_are_typed_attributes_that_are_completed(jump):
    declared = {each.name: KINDS[each.kind] for each in RecordedJump.declared()}
    hints = typing.get_type_hints(JumpResult)
    assert {name: hints[name] for name in declared} == declared
    assert isinstance(jump, JumpResult) and {*declared} <= {*dir(jump)}
    assert jump.x_bar == jump.summary["x_bar"]
    with pytest.raises(AttributeError, match="nothing"):
        _ = jump.nothing
    assert repr(pickle.loads(pickle.dumps(jump))) == repr(jump)


def test_its_trajectory_is_a_table(jump):
    table = jump.to_frame()
    assert len(table) == len(jump.arrays["time_s"]) and {"com_x_m", "elastic_J"} <= {*table}


def test_what_has_nothing_to_draw_says_so():
    lanes = simulate_jump(accuracy="draft", backend="lanes")
    for view in (lanes.plot, lanes.film):
        with pytest.raises(ParameterError, match="a result with"):
            view()
    assert lanes._repr_html_() == f"<pre>{lanes}</pre>"
    static = simulate(Simulation(sim="static", accuracy="draft"))
    assert opened(static.plot()).format == "PNG" and repr(static).startswith("<static ok")
    with pytest.raises(ParameterError, match="a beam that moves"):
        static.film()


def test_a_batch(batch):
    assert repr(batch).startswith("<8 jumps at draft: 7 ok, 1 bad_design; x_bar ")
    assert "\n" not in repr(batch) and "ms a jump" in str(batch)
    assert opened(batch.plot()).format == "PNG" and "<img" in batch._repr_html_()
    table = batch.to_frame()
    assert [*table][:5] == ["delta_alpha_rad", "epsilon", "mass_bar", "mu", "x_bar"]
    assert table.status.tolist() == batch.status and table.epsilon.iloc[-1] == 0.9
    with pytest.raises(ParameterError, match="a single jump"):
        batch.film()


def test_a_batch_without_an_apex():
    refused = simulate_designs(with_tier("draft"), [[0.1, 0.9, 0.768, 0.3]])
    with pytest.raises(ParameterError, match="a batch with an apex"):
        refused.plot()
    assert "bad_design" in repr(refused)
