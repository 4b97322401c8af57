#!/usr/bin/env python3
"""Compares the `test:` lines of noise nodes with the papers' algorithms, computed here in double, with nothing of Patina.

    noise_values.py          exit status 1 if a value differs
    noise_values.py --write  puts the computed value where one differs

A line like "CellNoise2D(float2(0.5, 1)) == 0.25" is an expression of Python, too: the functions below have the nodes'
names and parameters. Lines of functions that are not here are left to the compiler alone.
"""

import itertools
import math
import pathlib
import re
import sys

NODES = pathlib.Path(__file__).parents[2] / "nodes" / "procedural"
MASK = 0xFFFFFFFF


# --- vectors
class Vector(tuple):
    def __getattr__(self, names):
        picked = [self["xyzw".index(each)] for each in names]
        return picked[0] if len(picked) == 1 else Vector(picked)


def vector(count):
    return lambda *given: Vector(given * count if len(given) == 1 else given)


float2, float3, float4 = vector(2), vector(3), vector(4)


# --- Bob Jenkins, lookup3.c, 2006, of one to five numbers
def rotated(x, k):
    return ((x << k) | (x >> (32 - k))) & MASK


def lookup3(*numbers):
    keys = [n & MASK for n in numbers]
    a = b = c = (0xDEADBEEF + 4 * len(keys) + 13) & MASK
    while len(keys) > 3:
        a, b, c = (a + keys[0]) & MASK, (b + keys[1]) & MASK, (c + keys[2]) & MASK
        keys = keys[3:]
        for k in (4, 6, 8, 16, 19, 4):
            # mix(): a -= c; a ^= rot(c, k); c += b; then the roles move on by one
            a = ((a - c) & MASK) ^ rotated(c, k)
            c = (c + b) & MASK
            a, b, c = b, c, a
    keys += [0] * (3 - len(keys))
    a, b, c = (a + keys[0]) & MASK, (b + keys[1]) & MASK, (c + keys[2]) & MASK
    for k in (14, 11, 25, 16, 4, 14, 24):
        # final(): c ^= b; c -= rot(b, k); then the roles move on by one
        c = ((c ^ b) - rotated(b, k)) & MASK
        a, b, c = b, c, a
    # The number that was changed last is c in the order of the loop, and b after the roles moved on.
    return b


def fraction(*numbers):
    return lookup3(*numbers) / MASK


def cell_of(position):
    return [math.floor(each) for each in position]


def CellNoise1D(x):
    return fraction(math.floor(x))


def CellNoise2D(p):
    return fraction(*cell_of(p))


CellNoise3D = CellNoise4D = CellNoise2D


# --- Perlin, "Improving Noise", 2002, with the scales of MaterialX and Open Shading Language
def fade(t):
    return 6 * t**5 - 15 * t**4 + 10 * t**3


def signed(h, *terms):
    return sum(-term if h >> bit & 1 else term for bit, term in enumerate(terms))


def slope(h, d):
    if len(d) == 2:
        h &= 7
        x, y = d
        return signed(h, x, 2 * y) if h < 4 else signed(h, y, 2 * x)
    if len(d) == 3:
        h &= 15
        x, y, z = d
        return signed(h, x if h < 8 else y, y if h < 4 else x if h in (12, 14) else z)
    h &= 31
    x, y, z, w = d
    return signed(h, x if h < 24 else y, y if h < 16 else z, z if h < 8 else w)


SCALES = {2: 0.6616, 3: 0.982, 4: 0.8344}


def wrapped(cell, period):
    return [c % p for c, p in zip(cell, period)] if period else cell


def perlin(p, shift=0, period=None):
    cell = cell_of(p)
    d = [a - b for a, b in zip(p, cell)]
    total = 0
    for corner in itertools.product((0, 1), repeat=len(p)):
        share = math.prod(fade(t) if c else 1 - fade(t) for c, t in zip(corner, d))
        at = wrapped([a + b for a, b in zip(cell, corner)], period)
        total += share * slope(lookup3(*at) >> shift, [a - b for a, b in zip(d, corner)])
    return SCALES[len(p)] * total


def PerlinNoise2D(p):
    return perlin(p)


PerlinNoise3D = PerlinNoise4D = PerlinNoise2D


def PerlinNoise2DVector(p):
    return Vector(perlin(p, shift) for shift in (0, 8, 16))


PerlinNoise3DVector = PerlinNoise2DVector


def fractal(p, octaves, lacunarity, gain, shift=0):
    return sum(gain**i * perlin([lacunarity**i * each for each in p], shift) for i in range(octaves))


def PerlinFractal2D(p, octaves=3, lacunarity=2, gain=0.5):
    return fractal(p, octaves, lacunarity, gain)


PerlinFractal3D = PerlinFractal2D


def PerlinFractal2DVector(p, octaves=3, lacunarity=2, gain=0.5):
    return Vector(fractal(p, octaves, lacunarity, gain, shift) for shift in (0, 8, 16))


PerlinFractal3DVector = PerlinFractal2DVector


# --- for graphs: from 0 to 1, with a scale
def scaled(p, scale):
    return [each * scale for each in p]


def GradientNoise3D(p, scale=4):
    return 0.5 + 0.5 * perlin(scaled(p, scale))


GradientNoise4D = GradientNoise3D


def value(p, period=None):
    cell = cell_of(p)
    d = [a - b for a, b in zip(p, cell)]
    return sum(
        math.prod(fade(t) if c else 1 - fade(t) for c, t in zip(corner, d))
        * fraction(*wrapped([a + b for a, b in zip(cell, corner)], period))
        for corner in itertools.product((0, 1), repeat=len(p)))


def ValueNoise3D(p, scale=4):
    return value(scaled(p, scale))


ValueNoise4D = ValueNoise3D


def tiled(p, cells):
    cells = Vector([cells] * len(p)) if not isinstance(cells, tuple) else cells
    period = [max(round(each), 1) for each in cells]
    return [a * b for a, b in zip(p, period)], period


def ValueNoise3DTiled(p, scale=4):
    return value(*tiled(p, scale))


def GradientNoise3DTiled(p, scale=4):
    at, period = tiled(p, scale)
    return 0.5 + 0.5 * perlin(at, 0, period)


Smooth, Turbulence, Ridged = range(3)


def layers(noises, gain, kind):
    total, weights, before = 0, 0, 1
    for i, noise in enumerate(noises):
        layer = noise
        if kind == Turbulence:
            layer = abs(noise)
        if kind == Ridged:
            layer = before * max(1 - abs(noise), 0) ** 2
            before = min(2 * layer, 1)
        total += gain**i * layer
        weights += gain**i
    return 0.5 + 0.5 * total / weights if kind == Smooth else total / weights


def FractalNoise3D(p, scale=4, octaves=4, lacunarity=2, gain=0.5, kind=Smooth):
    return layers([perlin(scaled(p, scale * lacunarity**i)) for i in range(octaves)], gain, kind)


FractalNoise4D = FractalNoise3D


def FractalNoise3DTiled(p, scale=4, octaves=4, gain=0.5, kind=Smooth):
    at, period = tiled(p, scale)
    return layers([perlin(scaled(at, 2**i), 0, scaled(period, 2**i)) for i in range(octaves)], gain, kind)


# --- Perlin 2001, as Gustavson, "Simplex Noise Demystified", 2005, describes it
def simplex(p):
    n = len(p)
    skew, unskew = (math.sqrt(n + 1) - 1) / n, (1 - 1 / math.sqrt(n + 1)) / n
    cell = [math.floor(each + sum(p) * skew) for each in p]
    inside = [a - b + sum(cell) * unskew for a, b in zip(p, cell)]
    order = sorted(range(n), key=lambda i: -inside[i])
    total = 0
    for count in range(n + 1):
        corner = [1 if order.index(i) < count else 0 for i in range(n)]
        away = [a - b + count * unskew for a, b in zip(inside, corner)]
        kernel = max(0.5 - sum(each * each for each in away), 0) ** 4
        total += kernel * slope(lookup3(*[a + b for a, b in zip(cell, corner)]), away)
    return total


SIMPLEX = {2: 45.1, 3: 76.8, 4: 62.7}  # 1 over the greatest sum of any slopes, found by a search


def SimplexNoise2D(p, scale=4):
    return 0.5 + 0.5 * SIMPLEX[len(p)] * simplex(scaled(p, scale))


SimplexNoise3D = SimplexNoise4D = SimplexNoise2D

# --- Worley, "A Cellular Texture Basis Function", 1996
Distance, Cell, CellVector = range(3)
Euclidean, Manhattan, Chebyshev = range(3)
METRICS = (lambda d: math.dist(d, [0] * len(d)), lambda d: sum(map(abs, d)), lambda d: max(map(abs, d)))


def points(p, jitter, reach, metric=Euclidean, period=None):
    cell = cell_of(p)
    found = []
    for step in itertools.product(range(-reach, reach + 1), repeat=len(p)):
        own = [a + b for a, b in zip(cell, step)]
        hashed = wrapped(own, period)
        at = [c + 0.5 + (fraction(*hashed, i) - 0.5) * jitter for i, c in enumerate(own)]
        away = [a - b for a, b in zip(at, p)]
        found.append((METRICS[metric](away), hashed, away))
    return sorted(found)


def worley(p, jitter=1, style=Distance):
    found = points(p, jitter, 1)
    home = found[0][1]
    if style == Cell:
        return Vector([fraction(*home)] * 3)
    return Vector(fraction(*home, i) if style == CellVector else found[i][0] for i in range(3))


WorleyNoise2D = WorleyNoise3D = worley


class Outputs(float):
    pass


def Worley3D(p, scale=4, jitter=1, metric=Euclidean, period=None):
    found = points(scaled(p, scale) if period is None else p, jitter, 1, metric, period)
    made = Outputs(found[0][0])
    made.f2, made.random, made.toPoint = found[1][0], fraction(*found[0][1]), Vector(found[0][2])
    return made


def Worley3DTiled(p, scale=4, jitter=1, metric=Euclidean):
    at, period = tiled(p, scale)
    return Worley3D(at, 1, jitter, metric, period)


# --- noise in the plane: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020: pcg2d
def random2(cell):
    x, y = [(each * 1664525 + 1013904223) & MASK for each in cell]
    for _ in range(2):
        x = (x + y * 1664525) & MASK
        y = (y + x * 1664525) & MASK
        x, y = x ^ (x >> 16), y ^ (y >> 16)
    return [(x >> 8) / 2**24, (y >> 8) / 2**24]


def Random(p):
    made = Outputs(random2(cell_of(p))[0])
    made.second = random2(cell_of(p))[1]
    return made


def lattice2(p, height, period=None):
    """What `height` gives for each corner of a cell and the way from it, interpolated."""
    cell = cell_of(p)
    d = [a - b for a, b in zip(p, cell)]
    made = 0
    for corner in itertools.product((0, 1), repeat=2):
        at = wrapped([a + b for a, b in zip(cell, corner)], period)
        share = math.prod(fade(t) if c else 1 - fade(t) for c, t in zip(corner, d))
        made += share * height(random2(at), [a - b for a, b in zip(d, corner)])
    return made


def slope2(random, away):
    return sum((2 * r - 1) * a for r, a in zip(random, away))


def ValueNoise(p, scale=8):
    return lattice2(scaled(p, scale), lambda random, away: random[0])


def ValueNoiseTiled(p, scale=8):
    at, period = tiled(p, scale)
    return lattice2(at, lambda random, away: random[0], period)


def GradientNoise(p, scale=8):
    return 0.5 + 0.5 * lattice2(scaled(p, scale), slope2)


def GradientNoiseTiled(p, scale=8):
    at, period = tiled(p, scale)
    return 0.5 + 0.5 * lattice2(at, slope2, period)


def FractalNoise(p, scale=4, octaves=4, lacunarity=2, gain=0.5, kind=Smooth):
    at, noises = scaled(p, scale), []
    for _ in range(octaves):
        noises.append(lattice2(at, slope2))
        at = [a * lacunarity + b for a, b in zip(at, (37, 17))]
    return layers(noises, gain, kind)


def FractalNoiseTiled(p, scale=4, octaves=4, gain=0.5, kind=Smooth):
    at, period = tiled(p, scale)
    return layers([lattice2(scaled(at, 2**i), slope2, scaled(period, 2**i)) for i in range(octaves)], gain, kind)


def WarpedNoise(p, scale=3, strength=1, octaves=4):
    at = Vector(scaled(p, scale))
    moved = [2 * FractalNoise([at.x + x, at.y + y], 1, octaves) - 1 for x, y in ((0, 0), (5.2, 1.3))]
    made = Outputs(FractalNoise([a + strength * b for a, b in zip(at, moved)], 1, octaves))
    made.moved = Vector(moved)
    return made


def CurlNoise(p, scale=4):
    """The derivatives of the interpolation by the product rule; slopes from -1 to 1."""
    at = scaled(p, scale)
    cell = cell_of(at)
    d = [a - b for a, b in zip(at, cell)]
    height, change = 0, [0, 0]
    for corner in itertools.product((0, 1), repeat=2):
        slope_here = [2 * each - 1 for each in random2([a + b for a, b in zip(cell, corner)])]
        own = sum(s * (a - c) for s, a, c in zip(slope_here, d, corner))
        share = [fade(t) if c else 1 - fade(t) for c, t in zip(corner, d)]
        steep = [(1 if c else -1) * 30 * (t * (1 - t)) ** 2 for c, t in zip(corner, d)]
        height += share[0] * share[1] * own
        change[0] += steep[0] * share[1] * own + share[0] * share[1] * slope_here[0]
        change[1] += share[0] * steep[1] * own + share[0] * share[1] * slope_here[1]
    made = CurlOutputs((change[1], -change[0]))
    made.height = height
    return made


class CurlOutputs(Vector):
    pass


def Voronoi(p, scale=8, jitter=1, period=None, reach=1, metric=Euclidean):
    at = scaled(p, scale) if period is None else p
    found = []
    for step in itertools.product(range(-reach, reach + 1), repeat=2):
        cell = [a + b for a, b in zip(cell_of(at), step)]
        hashed = random2(wrapped(cell, period))
        away = [c + 0.5 + (h - 0.5) * jitter - a for c, h, a in zip(cell, hashed, at)]
        found.append((METRICS[metric](away), step[::-1], hashed, away))
    found.sort()
    made = Outputs(found[0][0])
    made.f2, made.random, made.toPoint = found[1][0], found[0][2][0], Vector(found[0][3])
    nearest = made.toPoint
    edges = [9]
    for _, _, _, away in found[1:]:
        between = [b - a for a, b in zip(nearest, away)]
        length = math.hypot(*between)
        if length > 1e-3:
            edges.append(sum((a + b) / 2 * c for a, b, c in zip(nearest, away, between)) / length)
    made.edge = min(edges)
    return made


def Worley(p, scale=8, jitter=1, metric=Euclidean):
    return Voronoi(p, scale, jitter, None, 3, metric)


def VoronoiTiled(p, scale=8, jitter=1):
    at, period = tiled(p, scale)
    return Voronoi(at, 1, jitter, period)


# --- patterns that have random numbers
def Bricks(p, frequency=(4, 8), shift=0.5, mortar=0.01, bevel=0.005):
    x, y = p.x * frequency[0], p.y * frequency[1]
    x += shift * (math.floor(y) % 2)
    local = Vector([x - math.floor(x), y - math.floor(y)])
    t = (min(min(a, 1 - a) / b for a, b in zip(local, frequency)) - mortar) / bevel
    t = min(max(t, 0), 1)
    made = Outputs(t * t * (3 - 2 * t))
    made.local, made.random = local, random2([math.floor(x), math.floor(y)])[0]
    return made


# --- the lines
LINE = re.compile(r"(/// test: )(\w+)(\(.*?) == (.*?)( within .*)?$")


def text(value):
    if isinstance(value, tuple):
        return f"float{len(value)}({', '.join(text(each) for each in value)})"
    return repr(float(value)) if value else "0"


def close(a, b):
    a, b = [each if isinstance(each, tuple) else (each,) for each in (a, b)]
    return len(a) == len(b) and all(math.isclose(x, y, rel_tol=1e-7, abs_tol=1e-12) for x, y in zip(a, b))


def main():
    count, wrong = 0, 0
    for path in sorted(NODES.glob("*.node.hlsl")):
        lines = path.read_text(encoding="utf-8").split("\n")
        for i, line in enumerate(lines):
            found = LINE.match(line)
            if not found or found[2] not in globals():
                continue
            count += 1
            computed = eval(found[2] + found[3])
            if close(computed, eval(found[4])):
                continue
            wrong += 1
            print(f"{path.name}:{i + 1}: {line}\n  but it is {text(computed)}")
            lines[i] = f"{found[1]}{found[2]}{found[3]} == {text(computed)}{found[5] or ''}"
        if "--write" in sys.argv:
            path.write_text("\n".join(lines), encoding="utf-8")
    print(f"{count} values compared, {wrong} differ")
    return 1 if (wrong and "--write" not in sys.argv) or count < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
