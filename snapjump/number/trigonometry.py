"""Sine, cosine and arctangent, of the same bits on every processor: polynomials of fdlibm."""

from typing import Any

from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, any_true, fma, nearest, sqrt, where

# pi / 2 in two parts, and the polynomials of sine and cosine on [-pi/4, pi/4] from fdlibm.
HALF_PI = 1.5707963267948966
HALF_PI_REST = 6.123233995736766e-17
SINE = (
    -1.66666666666666324348e-01,
    8.33333333332248946124e-03,
    -1.98412698298579493134e-04,
    2.75573137070700676789e-06,
    -2.50507602534068634195e-08,
    1.58969099521155010221e-10,
)
COSINE = (
    4.16666666666666019037e-02,
    -1.38888888888741095749e-03,
    2.48015872894767294178e-05,
    -2.75573143513906633035e-07,
    2.08757232129817482790e-09,
    -1.13596475577881948265e-11,
)


@kernel
def reduced_sine_cosine(x: Any) -> Any:
    """Sine and cosine of x less a number of quarter turns, and that number from -2 to 2.

    In plain arithmetic, which is as fast for lanes as for one number, and equal in both; good to
    about one unit in the last place for the angles of a robot (|x| < 1e5).
    """
    quarters = nearest(x * (1.0 / HALF_PI))
    r = fma(-quarters, HALF_PI_REST, fma(-quarters, HALF_PI, x))
    z = r * r
    s = fma(z, SINE[5], SINE[4])
    s = fma(z, s, SINE[3])
    s = fma(z, s, SINE[2])
    s = fma(z, s, SINE[1])
    s = fma(z, s, SINE[0])
    c = fma(z, COSINE[5], COSINE[4])
    c = fma(z, c, COSINE[3])
    c = fma(z, c, COSINE[2])
    c = fma(z, c, COSINE[1])
    c = fma(z, c, COSINE[0])
    half = 0.5 * z
    near_one = 1.0 - half
    cosine = near_one + ((1.0 - near_one - half) + z * z * c)
    return fma(z * r, s, r), cosine, quarters - 4.0 * nearest(0.25 * quarters)


@kernel
def sin(x: Any) -> Any:
    """Sine of an angle (rad)."""
    sine, cosine, quarters = reduced_sine_cosine(x)
    value = where(absolute(quarters) == 1.0, cosine, sine)
    return where((quarters == -1.0) | (absolute(quarters) == 2.0), -value, value)


@kernel
def cos(x: Any) -> Any:
    """Cosine of an angle (rad)."""
    sine, cosine, quarters = reduced_sine_cosine(x)
    value = where(absolute(quarters) == 1.0, sine, cosine)
    return where((quarters == 1.0) | (absolute(quarters) == 2.0), -value, value)


# The polynomial of the arctangent on [-7/16, 7/16] from fdlibm.
ARCTANGENT = (
    3.33333333333329318027e-01,
    -1.99999999998764832476e-01,
    1.42857142725034663711e-01,
    -1.11111104054623557880e-01,
    9.09088713343650656196e-02,
    -7.69187620504482999495e-02,
    6.66107313738753120669e-02,
    -5.83357013379057348645e-02,
    4.97687799461593236017e-02,
    -3.65315727442169155270e-02,
    1.62858201153657823623e-02,
)


@kernel
def arctan(t: Any) -> Any:
    """Angle (rad, from -pi/2 to pi/2) whose tangent is t, for |t| < 1e150.

    Beyond 7/16 the angle is halved twice, tan(a/2) = t / (1 + sqrt(1 + t^2)); that is left out
    where no lane needs it.
    """
    beyond = absolute(t) > 0.4375
    r = t
    scale = 1.0 + 0.0 * t
    if any_true(beyond):
        half = t / (1.0 + sqrt(fma(t, t, 1.0)))
        quarter = half / (1.0 + sqrt(fma(half, half, 1.0)))
        r = where(beyond, quarter, t)
        scale = where(beyond, 4.0, scale)
    z = r * r
    p = fma(z, ARCTANGENT[10], ARCTANGENT[9])
    p = fma(z, p, ARCTANGENT[8])
    p = fma(z, p, ARCTANGENT[7])
    p = fma(z, p, ARCTANGENT[6])
    p = fma(z, p, ARCTANGENT[5])
    p = fma(z, p, ARCTANGENT[4])
    p = fma(z, p, ARCTANGENT[3])
    p = fma(z, p, ARCTANGENT[2])
    p = fma(z, p, ARCTANGENT[1])
    p = fma(z, p, ARCTANGENT[0])
    return scale * fma(-(z * r), p, r)
