"""Lanes are their scalars side by side: bit for bit, special values included."""

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numba import njit

from snapjump.number.exponentials import exp, log
from snapjump.number.functions import absolute, any_true, fma, maximum, minimum, negate, sqrt, where
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros
from snapjump.number.trigonometry import arctan, cos, sin

# What is done in place comes first.
OPERATIONS = (
    "iadd isub imul idiv sum_from_number "
    "add sub mul div neg int_add number_sub number_div power_sum "
    "sqrt log exp sin cos arctan absolute "
    "fma fma_number minimum maximum where where_number less_than_number "
    "lt le gt ge eq ne and or not"
).split()
WIDTHS = (1, 2, 4, 8)


@njit
def one(mask: Any) -> Any:
    return where(mask, 1.0, 0.0)


@njit(error_model="numpy")
def evaluate(a: Any, b: Any, c: Any, out: Any, any_out: Any, lanes: Any) -> None:
    x, y, z = view_numbers(a, lanes), view_numbers(b, lanes), view_numbers(c, lanes)
    r = view_numbers(out, lanes)
    for i in range(x.shape[0]):
        p, q, s = x[i], y[i], z[i]
        r[0, i] = r[1, i] = r[2, i] = r[3, i] = p
        r[0, i] += q
        r[1, i] -= q
        r[2, i] *= q
        r[3, i] /= q
        total = 0.0
        for _ in range(3):
            total = total + p
        r[4, i] = total
        others = (
            p + q, p - q, p * q, p / q, -p, 3 + p, 0.1 - p, p / 0.3, p * p * p + q * q,
            sqrt(p), log(p), exp(p), sin(p), cos(p), arctan(p), absolute(p),
            fma(p, q, s), fma(0.1, p, 3), minimum(p, q), maximum(p, q),
            where(p < s, p, q), where(p < s, 1, q), one(p < 0.5),
            one(p < q), one(p <= q), one(p > q), one(p >= q), one(p == q), one(p != q),
            one((p < q) & (q < s)), one((p < q) | (q < s)), one(negate(p < q)),
        )  # fmt: skip
        for k in range(len(others)):
            r[5 + k, i] = others[k]
        any_out[i] = any_true(p < q)


TINY = np.nextafter(0.0, 1.0)
SPECIALS = (0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, np.nan, TINY, -1e-310, 1e308, 0.1, 0.3)


def inputs() -> tuple[Any, Any, Any]:
    """Pairs of all special values, then random ones; a multiple of 8."""
    rng = np.random.default_rng(0)
    p, q = np.meshgrid(SPECIALS, SPECIALS)
    random = rng.normal(size=(3, 256)) * 10.0 ** rng.integers(-3, 3, (3, 256))
    random[0, ::4] = random[1, ::4]
    a, b = np.concatenate([p.ravel(), random[0]]), np.concatenate([q.ravel(), random[1]])
    c = np.concatenate([np.roll(p.ravel(), 5), random[2]])
    return a, b, c


def results(width: int) -> tuple[Any, Any]:
    flat = inputs()
    packed = []
    for values in flat:
        array = aligned_zeros((len(values) // width, width))
        array[...] = values.reshape(-1, width)
        packed.append(array)
    rows = len(flat[0]) // width
    out = aligned_zeros((len(OPERATIONS), rows, width))
    some = np.zeros(rows, dtype=np.bool_)
    evaluate(*packed, out, some, (0,) * width)
    return out.reshape(len(OPERATIONS), -1), some


@pytest.fixture(scope="session")
def computed() -> dict[int, tuple[Any, Any]]:
    return {width: results(width) for width in WIDTHS}


def same_bits(a: Any, b: Any) -> Any:
    """Equal to the last bit and in the sign of zero; any NaN is a NaN."""
    return (a.view(np.int64) == b.view(np.int64)) | (np.isnan(a) & np.isnan(b))


@pytest.mark.parametrize("width", WIDTHS[1:])
@pytest.mark.parametrize("name", OPERATIONS)
def test_lanes_equal_their_scalars(computed, width, name):
    row = OPERATIONS.index(name)
    lanes, scalars = computed[width][0][row], computed[1][0][row]
    wrong = np.flatnonzero(~same_bits(lanes, scalars))
    a, b, c = inputs()
    assert not len(wrong), [(a[i], b[i], c[i], lanes[i], scalars[i]) for i in wrong[:5]]


@pytest.mark.parametrize("width", WIDTHS[1:])
def test_any_true_is_any_of_the_lanes(computed, width):
    single = computed[1][1].reshape(-1, width)
    assert np.array_equal(computed[width][1], single.any(axis=1))
    assert 0 < computed[width][1].sum() < len(single)


def test_scalars_are_numpy_s(computed):
    a, b, c = inputs()
    less, low = a < b, b < c
    with np.errstate(all="ignore"):
        wanted = {
            "add": a + b, "sub": a - b, "idiv": a / b, "number_sub": 0.1 - a,
            "sum_from_number": 0.0 + a + a + a, "sqrt": np.sqrt(a), "absolute": np.abs(a),
            "minimum": np.where(less, a, b), "maximum": np.where(a > b, a, b),
            "where": np.where(a < c, a, b), "less_than_number": a < 0.5,
            "le": a <= b, "gt": a > b, "eq": a == b, "ne": a != b,
            "not": ~less, "and": less & low, "or": less | low,
        }  # fmt: skip
    for name, values in wanted.items():
        assert same_bits(scalars_of(computed, name), 1.0 * values).all(), name


def scalars_of(computed: Any, name: str) -> Any:
    return computed[1][0][OPERATIONS.index(name)]


@pytest.mark.parametrize("name", ["log", "exp", "sin", "cos"])
def test_transcendental_functions_are_accurate(computed, name):
    given, actual = inputs()[0], scalars_of(computed, name)
    angle = name in ("sin", "cos")
    sane = np.abs(given) < 1e5 if angle else np.full(len(given), True)
    with np.errstate(all="ignore"):
        wanted = getattr(np, name)(given[sane])
    np.testing.assert_allclose(actual[sane], wanted, rtol=4e-16, atol=1e-16 if angle else 0.0)
    assert not angle or np.isnan(actual[~np.isfinite(given)]).all()


def test_arctangent_is_accurate(computed):
    tangents = inputs()[0]
    actual, sane = scalars_of(computed, "arctan"), np.abs(tangents) < 1e150
    np.testing.assert_allclose(actual[sane], np.arctan(tangents[sane]), rtol=0.0, atol=1e-15)
    for t in (*np.linspace(-5.0, 5.0, 2001), *np.logspace(-12, 12, 200)):
        assert arctan(float(t)) == pytest.approx(math.atan(t), rel=1e-15)
    for t in (0.3, 3.0):
        slope = arctan(np.complex128(complex(t, 1e-30))).imag / 1e-30
        assert slope == pytest.approx(1.0 / (1.0 + t * t), rel=1e-14)


def test_fma_rounds_once(computed):
    a = inputs()[0]
    row = computed[8][0][OPERATIONS.index("fma_number")]
    exact = [float(Fraction(0.1) * Fraction(a[i]) + 3) for i in range(144, len(a))]
    assert row[144:].tolist() == exact
    assert (row[144:] != 0.1 * a[144:] + 3).any()  # rounding twice shows


def test_plain_python_takes_real_and_complex_numbers():
    z = complex(0.3, 0.4)
    assert sqrt(4.0) == 2.0
    assert sqrt(z) ** 2 == pytest.approx(z)
    assert exp(log(z)) == pytest.approx(z)
    assert sin(z) ** 2 + cos(z) ** 2 == pytest.approx(1.0)
    assert (log(math.e), exp(0.0), sin(0.0), cos(0.0)) == (1.0, 1.0, 0.0, 1.0)
    assert (absolute(-2.0), absolute(-z), absolute(z)) == (2.0, z, z)
    assert fma(2.0, 3.0, z) == 6.0 + z
    assert (minimum(1.0, 2.0), maximum(1.0, 2.0)) == (1.0, 2.0)
    assert where(True, 1, 2) == 1
    assert any_true(3 > 2)
    assert negate(2 > 3)


def test_memory_for_lanes_is_zeroed_and_aligned():
    for shape in ((3, 8), (5,), (2, 7, 4)):
        for _ in range(5):
            array = aligned_zeros(shape)
            assert array.shape == shape
            assert array.flags.c_contiguous
            assert array.ctypes.data % 64 == 0
            assert not array.any()


def test_only_contiguous_doubles_can_be_viewed():
    @njit
    def first(values):
        return view_numbers(values, (0, 0)).shape[0]

    assert first(np.zeros((4, 2))) == 4
    for others in (np.zeros((4, 2), dtype=np.float32), np.asfortranarray(np.zeros((4, 3, 2)))):
        with pytest.raises(TypeError, match="C-contiguous doubles"):
            first(others)
