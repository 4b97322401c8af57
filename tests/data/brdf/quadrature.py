"""Gauss-Legendre quadrature."""

import functools
import math


@functools.lru_cache(maxsize=None)
def gauss_legendre(count):
    """Nodes and weights on [0, 1]: pairs (x, w), exact for polynomials of degree 2 count - 1."""
    rule = []
    for i in range(count):
        x = math.cos(math.pi * (i + 0.75) / (count + 0.5))
        for _ in range(100):
            before, value = 0.0, 1.0  # the Legendre polynomials of degree k - 1 and k at x
            for k in range(count):
                before, value = value, ((2 * k + 1) * x * value - k * before) / (k + 1)
            slope = count * (x * value - before) / (x * x - 1)
            step = value / slope
            x -= step
            if abs(step) < 1e-15:
                break
        rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return tuple(rule)


def over_sphere(function, z_from=-1.0, z_to=1.0, count=16):
    """The integral of `function(direction)` over the part of the unit sphere with z between two heights.

    Exact for polynomials of x, y, z up to degree `count` - 1: Gauss in z, equal steps around the axis.
    """
    values = []
    for x, w in gauss_legendre(count):
        z = z_from + (z_to - z_from) * x
        radius = math.sqrt(1 - z * z)
        for k in range(count):
            phi = 2 * math.pi * (k + 0.5) / count
            weight = w * (z_to - z_from) * 2 * math.pi / count
            values.append(weight * function([radius * math.cos(phi), radius * math.sin(phi), z]))
    return math.fsum(values)
