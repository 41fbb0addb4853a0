import math

from snapjump.load.gravity import Gravity
from snapjump.load.inclined import InclinedGravity
from snapjump.load.none import NoLoad
from snapjump.load.tip import TipLoad


def test_every_load_pulls_where_it_says():
    loads = [NoLoad(), Gravity(2.0), InclinedGravity(2.0, 0.5), TipLoad(1.0, -2.0, 3.0)]
    assert [load.gravity() for load in loads] == [0.0, 2.0, 2.0, 0.0]
    assert [load.pull() for load in loads] == [0.0, 0.0, 0.5, 0.0]
    still = (0.0, 0.0, 0.0)
    assert [load.tip_load() for load in loads] == [still, still, still, (1.0, -2.0, 3.0)]


def test_a_slope_turns_gravity():
    from snapjump.scenes.mass import mass_model
    from snapjump.sim.slide import Slide
    from snapjump.simulation import build

    simulation = build({"sim": {"name": "slide"}, "frame": {"name": "fixed"}})
    assert isinstance(simulation.sim, Slide)
    load = mass_model(simulation, 10.0, 0.75).load
    scale = simulation.robot.scales.acceleration_m_s2
    assert math.hypot(load.normal, load.tangential) * scale == 10.0
    assert math.isclose(load.tangential / load.normal, 0.75)
