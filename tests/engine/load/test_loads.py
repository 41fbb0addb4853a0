import math

import pytest

from snapjump.engine.load.gravity import Gravity
from snapjump.engine.load.none import NoLoad
from snapjump.engine.load.tip import TipLoad
from snapjump.scenes.mass import mass_model
from snapjump.sim.slide import Slide
from snapjump.simulation import build


def test_every_load_pulls_where_it_says():
    loads = [NoLoad(), Gravity(2.0), Gravity(4.0, 0.5, 0.125), TipLoad(1.0, -2.0, 3.0)]
    assert [load.gravity() for load in loads] == [0.0, 2.0, 2.0, 0.0]
    assert [load.pull() for load in loads] == [0.0, 0.0, 0.5, 0.0]
    still = (0.0, 0.0, 0.0)
    assert [load.tip_load() for load in loads] == [still, still, still, (1.0, -2.0, 3.0)]


def test_a_slope_turns_gravity():
    simulation = build({"sim": {"name": "slide"}, "frame": {"name": "fixed"}})
    assert isinstance(simulation.sim, Slide)
    load = mass_model(simulation, 10.0, -math.atan(0.75)).load
    scale = simulation.robot.scales.acceleration_m_s2
    assert math.isclose(math.hypot(load.gravity(), load.pull()) * scale, 10.0)
    assert math.isclose(load.pull() / load.gravity(), 0.75)
    # Straight up is against the pull, and a flight is highest when nothing of it is left.
    assert load.rise(-load.downhill, load.cosine) == pytest.approx(1.0)
    assert load.time_to_apex(load.cosine, load.downhill) == pytest.approx(0.0, abs=1e-15)
