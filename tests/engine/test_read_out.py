"""What is compiled to be read off states, against the same functions in plain Python."""

import numpy as np
import pytest

from snapjump.composition import with_tier
from snapjump.engine.assemble import Motion
from snapjump.engine.points import Touch, friction_force, normal_force, point_at, share_of
from snapjump.scenes.compile_ahead import bare_march
from snapjump.scenes.trajectory import read

STILL = Motion(0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize("contact", ["logbarrier", "penalty"])
def test_forces_and_places_are_those_of_the_points(contact):
    march = bare_march(with_tier("draft", contact=contact))
    model, masses, mesh = march.models[0], march.masses, march.mesh
    rng = np.random.default_rng(1)
    states, velocities = (rng.uniform(1e-4, 0.05, (2, march.states.shape[1])) for _ in "qv")
    states[:, 1] -= model.frame.foot_y  # the frame upright, feet near the ground
    times = np.array([0.0, 0.3])
    readings = read(march, times, states, velocities)
    for n, (state, velocity) in enumerate(zip(states, velocities, strict=True)):
        stored = 0.0
        for k in range(readings.gap.shape[1]):
            point, share = (
                point_at(model, masses, mesh, k, state, velocity),
                share_of(model, masses, mesh, k),
            )
            normal = friction = 0.0
            if share > 0.0 and point.gap < model.contact.reach():
                touch = Touch(point, point, 0.0, share)
                normal = share * normal_force(model, STILL, touch)
                friction = -share * friction_force(model, STILL, touch)
                stored += share * model.contact.energy(point.gap)
            found = readings.gap[n, k], readings.normal[n, k], readings.friction[n, k]
            np.testing.assert_allclose(found, (point.gap, normal, friction), rtol=1e-12)
        assert readings.contact[n] == pytest.approx(stored, rel=1e-12)
        angles = model.clamp.angles(times[n])
        np.testing.assert_allclose(readings.angles[n], (angles.left, angles.right), rtol=1e-14)
        corners = [model.frame.corner_point(mesh, k, state, velocity)[:2] for k in range(4)]
        np.testing.assert_allclose(readings.corners[n], corners, rtol=1e-12)
