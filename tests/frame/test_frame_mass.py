"""Mass, centre and inertia of a rigid frame: against sums over points, and jumps of such frames."""

import numpy as np
import pytest
from refusals import refused

from snapjump import Design, Environment
from snapjump.batch import simulate_batch
from snapjump.composition import with_tier
from snapjump.frame.parts.mass_layout import evenly, evenly_with_ends, measured, with_ends
from snapjump.frame.rigid import RigidFrame
from snapjump.scenes.jump_start import jump_model

MASS, WIDTH, HEIGHT, END, MOUNT = 70.0, 0.8, 0.5, 0.3, 0.07
HEIGHT_M, SPAN_M = 0.01, 0.016


def points():
    """Masses along leg, top, leg and at the clamps, and their places."""
    length, count = 2.0 * HEIGHT + WIDTH, 40_000
    s = (np.arange(count) + 0.5) * length / count
    x = np.clip(s - HEIGHT, 0.0, WIDTH) - 0.5 * WIDTH
    y = np.minimum(np.minimum(s, HEIGHT), length - s)
    masses = np.append(np.full(count, MASS / count), [END, END])
    return masses, np.append(x, [-0.5 * WIDTH, 0.5 * WIDTH]), np.append(y, [MOUNT, MOUNT])


def test_a_mass_evenly_along_the_outline_is_that_of_its_points():
    masses, x, y = points()
    found = evenly_with_ends(MASS, WIDTH, HEIGHT, END, MOUNT)
    centre = np.average(y, weights=masses)
    assert (found.mass, found.x) == (pytest.approx(masses.sum()), 0.0)
    assert found.y == pytest.approx(centre, rel=1e-8)
    assert found.inertia == pytest.approx(masses @ (x**2 + (y - centre) ** 2), rel=1e-8)


def test_what_is_not_measured_is_evenly():
    expected = evenly_with_ends(MASS, WIDTH, HEIGHT, END, MOUNT)
    own = measured(MASS, WIDTH, HEIGHT, (0.0, None), None)
    assert with_ends(own, END, 0.5 * WIDTH, MOUNT) == pytest.approx(expected, rel=1e-14)


def test_ends_move_a_measured_centre():
    own = measured(MASS, WIDTH, HEIGHT, (0.1, 0.6), 3.0)
    found = with_ends(own, END, 0.5 * WIDTH, MOUNT)
    masses = np.array([MASS, END, END])
    x, y = np.array([0.1, -0.4, 0.4]), np.array([0.6, MOUNT, MOUNT])
    at = np.average([x, y], axis=1, weights=masses)
    assert found[1:3] == pytest.approx(tuple(at), rel=1e-14)
    far = masses @ ((x - at[0]) ** 2 + (y - at[1]) ** 2)
    assert found.inertia == pytest.approx(3.0 + far, rel=1e-14)


@pytest.mark.parametrize(
    ("key", "value", "allowed"),
    [
        ("mass_centre_height_m", 0.0, "in (0, inf) m"),
        ("mass_centre_offset_m", -0.008, "between -0.008 and 0.008 m"),
        ("inertia_kg_m2", -1e-7, "in (0, inf) kg m^2"),
        ("clamp_mass_kg", 0.002, "less than 0.001975 kg"),
    ],
)
def test_what_is_refused(key, value, allowed):
    with refused(f"frame.{key}", allowed):
        with_tier("draft", frame={key: value})
    with refused(f"frame.{key}", "frame has bending_ratio"):
        with_tier("draft", frame={"name": "elastic", key: value})


def evenly_si(mass_kg: float) -> tuple[float, float]:
    """Height of the centre (m) and inertia (kg m^2) of the paper's layout of a mass."""
    moment, _ = evenly(mass_kg, SPAN_M, HEIGHT_M, 0.0)
    return moment / mass_kg, evenly(mass_kg, SPAN_M, HEIGHT_M, moment / mass_kg)[1]


def test_the_paper_s_layout_by_its_numbers_is_the_paper_s_robot():
    base = with_tier("draft")
    mass_kg = base.environment.mass_kg(base.robot) - base.robot.beam_mass_kg
    height_m, inertia = evenly_si(mass_kg)
    other = with_tier("draft", frame={"mass_centre_height_m": height_m, "inertia_kg_m2": inertia})
    np.testing.assert_allclose(jump_model(other).frame, jump_model(base).frame, rtol=1e-12)


def apexes(frames: list[RigidFrame], signs: list[float]) -> np.ndarray:
    jumps = [
        with_tier("draft", frame=frame, design=Design(0.2, 0.1 * sign), environment=Environment())
        for frame, sign in zip(frames, signs, strict=True)
    ]
    batch = simulate_batch(jumps)
    assert batch.status == ["ok"] * len(jumps)
    return np.array([batch.x_bar, batch.y_bar])


def test_a_robot_s_mirror_image_jumps_to_the_mirrored_apex():
    aside = [RigidFrame(mass_centre_offset_m=at, clamp_mass_kg=3e-4) for at in (1e-3, -1e-3)]
    (x, _), (other, _) = apexes(aside, [1.0, -1.0]).T, apexes([RigidFrame()] * 2, [1.0, -1.0]).T
    found = apexes(aside, [1.0, -1.0])
    assert found[0, 1] == pytest.approx(-found[0, 0], rel=1e-3)
    assert found[1, 1] == pytest.approx(found[1, 0], rel=1e-4)
    assert abs(x[0] - other[0]) > 0.05 * abs(other[0])


def test_where_the_mass_is_matters():
    """All of it on top against the paper's layout, and all in the legs."""
    base = with_tier("draft")
    mass_kg = base.environment.mass_kg(base.robot) - base.robot.beam_mass_kg
    half_m = 0.5 * SPAN_M
    top = RigidFrame(HEIGHT_M, inertia_kg_m2=mass_kg * SPAN_M**2 / 12.0)
    legs = RigidFrame(0.5 * HEIGHT_M, inertia_kg_m2=mass_kg * (HEIGHT_M**2 / 12.0 + half_m**2))
    paper, on_top, in_legs = apexes([RigidFrame(), top, legs], [1.0] * 3)[0]
    # An independent simulation found 37 % more and 22 % less.
    assert on_top / paper == pytest.approx(1.37, abs=0.02)
    assert in_legs / paper == pytest.approx(0.78, abs=0.02)
