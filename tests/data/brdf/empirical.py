"""The models that came before physics: Lambert, half Lambert, Phong, Blinn-Phong."""

import math

from .registry import term
from .vectors import dot, half_between, normalize, scale, subtract


@term
def lambert_ndotl(n, l):
    """max(0, n.l). Lambert, Photometria, 1760."""
    return max(0.0, dot(n, l))


@term
def lambert_brdf(albedo):
    """albedo / pi: the directional albedo of a constant c is pi c."""
    return albedo / math.pi


@term
def half_lambert(ndotl, alpha, beta):
    """alpha n.l + beta, the linear form, not clamped."""
    return alpha * ndotl + beta


@term
def half_lambert_valve_squared(ndotl):
    """(n.l / 2 + 1/2)^2. Mitchell, McTaggart, Green, Shading in Valve's Source Engine, SIGGRAPH 2006 course."""
    return (0.5 * ndotl + 0.5) ** 2


@term
def reflect(i, n):
    """i - 2 (n.i) n, as every shading language defines it: i runs towards the surface."""
    return subtract(i, scale(n, 2 * dot(n, i)))


@term
def half_vector(l, v):
    """(l + v) / |l + v|."""
    return half_between(l, v)


@term
def phong(n, l, v, exponent):
    """max(0, r.v)^e with r = 2 (n.l) n - l, the mirrored light. Phong, CACM 18(6), 1975."""
    mirrored = subtract(scale(n, 2 * dot(n, l)), l)
    return max(0.0, dot(mirrored, v)) ** exponent


@term
def phong_source0_wrong_reflect(n, l, v, exponent):
    """What `phong` becomes when the light direction, which points to the light, is given to reflect() as it is."""
    return max(0.0, dot(reflect(l, n), v)) ** exponent


@term
def blinn_phong(n, l, v, exponent):
    """max(0, n.h)^e. Blinn, SIGGRAPH 1977."""
    return max(0.0, dot(n, normalize(half_between(l, v)))) ** exponent
