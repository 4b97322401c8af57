"""Vectors as lists of numbers, and the few functions of numbers that every family needs."""

import math


def dot(a, b):
    return math.fsum(x * y for x, y in zip(a, b))


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def multiply(a, b):
    return [x * y for x, y in zip(a, b)]


def scale(a, factor):
    return [x * factor for x in a]


def normalize(a):
    return scale(a, 1 / math.sqrt(dot(a, a)))


def half_between(l, v):
    """The half vector of two unit vectors."""
    return normalize(add(l, v))


def saturate(x):
    return min(max(x, 0.0), 1.0)


def lerp(a, b, t):
    return a + (b - a) * t


def mix(a, b, t):
    """lerp of two vectors."""
    return [lerp(x, y, t) for x, y in zip(a, b)]
