"""Layers of glTF's material extensions: Charlie's sheen, thin films, anisotropy, volumes."""

import math

from .registry import term


@term
def D_Charlie(alpha, NoH):
    """(2 + 1/alpha) sin^(1/alpha) / (2 pi). Estevez and Kulla, SIGGRAPH 2017, equation 2."""
    return (2 + 1 / alpha) * math.sin(math.acos(NoH)) ** (1 / alpha) / (2 * math.pi)


def charlie_curve(x, alpha):
    """a / (1 + b x^c) + d x + e with the constants of Estevez and Kulla's table for alpha 0 and 1."""
    a, b, c, d, e = (
        at_0 * (1 - alpha) ** 2 + at_1 * (1 - (1 - alpha) ** 2)
        for at_0, at_1 in (
            (25.3245, 21.5473),
            (3.32435, 3.82987),
            (0.16801, 0.19823),
            (-1.27393, -1.97760),
            (-4.85967, -4.32054),
        )
    )
    return a / (1 + b * x**c) + d * x + e


@term
def Lambda_Charlie(alpha, cos):
    """exp(L), mirrored above a cosine of 0.5. Estevez and Kulla, SIGGRAPH 2017, section 3."""
    if cos < 0.5:
        return math.exp(charlie_curve(cos, alpha))
    return math.exp(2 * charlie_curve(0.5, alpha) - charlie_curve(1 - cos, alpha))


@term
def V_Charlie(alpha, NoL, NoV):
    """Smith's joint form over Charlie's Lambda. KHR_materials_sheen."""
    return 1 / (1 + Lambda_Charlie(alpha, NoV) + Lambda_Charlie(alpha, NoL)) / (4 * NoL * NoV)


# CIE sensitivities as Gaussians in wave numbers, and linear sRGB from XYZ. Belcour and Barla, SIGGRAPH 2017, code.
GAUSSIANS = (
    ((5.4856e-13, 1.6810e6, 4.3278e9), (9.7470e-14, 2.2399e6, 4.5282e9)),
    ((4.4201e-13, 1.7953e6, 9.3046e9),),
    ((5.2481e-13, 2.2084e6, 6.6121e9),),
)
TO_RGB = (
    (3.2404542, -1.5371385, -0.4985314),
    (-0.9692660, 1.8760108, 0.0415560),
    (0.0556434, -0.2040259, 1.0572252),
)


def sensitivity(path_nm, shifts):
    """RGB of the interference term of an optical path: the Fourier transform of the sensitivities. `shifts`: by channel
    of XYZ."""
    k = 2 * math.pi * path_nm * 1e-9
    xyz = [
        sum(v * math.sqrt(2 * math.pi * s) * math.cos(p * k + shift) * math.exp(-s * k * k) for v, p, s in terms)
        / 1.0685e-7
        for terms, shift in zip(GAUSSIANS, shifts)
    ]
    return [sum(m * x for m, x in zip(row, xyz)) for row in TO_RGB]


def schlick(f0, cos):
    return f0 + (1 - f0) * (1 - cos) ** 5


@term
def F_thin_film(cos, filmIor, thickness, f0):
    """KHR_materials_iridescence: Belcour and Barla's Airy sum with Schlick at both faces and two orders of it."""
    sine2 = (1 - cos * cos) / (filmIor * filmIor)
    inside = math.sqrt(1 - sine2)
    first = schlick(((filmIor - 1) / (filmIor + 1)) ** 2, cos)
    through = 1 - first
    root = [math.sqrt(min(f, 0.9999)) for f in f0]
    base = [(1 + r) / (1 - r) for r in root]
    second = [schlick(((b - filmIor) / (b + filmIor)) ** 2, inside) for b in base]
    shifts = [math.pi + (math.pi if b < filmIor else 0) for b in base]
    path = 2 * filmIor * thickness * inside
    both = [min(first * s, 0.9999) for s in second]
    repeated = [through * through * s / (1 - b) for s, b in zip(second, both)]
    orders = [sensitivity(m * path, [m * shift for shift in shifts]) for m in (1, 2)]
    result = []
    for c in range(3):
        total = first + repeated[c]
        for m in (1, 2):
            total += (repeated[c] - through) * math.sqrt(both[c]) ** m * 2 * orders[m - 1][c]
        result.append(min(max(total, 0.0), 1.0))
    return result


@term
def alpha_anisotropic(alpha, strength):
    """mix(alpha, 1, strength^2). KHR_materials_anisotropy."""
    return alpha * (1 - strength**2) + strength**2


@term
def transmittance(color, distance, depth):
    """exp(ln(c) depth / distance), the law of Beer and Lambert. KHR_materials_volume."""
    return [math.exp(math.log(c) * depth / distance) for c in color]


@term
def dispersed_ior(ior, dispersion):
    """The indices of red, green and blue: half of (n - 1) / V apart, V = 20 / dispersion. KHR_materials_dispersion."""
    half = (ior - 1) / (20 / dispersion) / 2 if dispersion > 0 else 0.0
    return [ior - half, ior, ior + half]


@term
def alpha_transmission(alpha, ior):
    """Rough refraction narrows to nothing as the index goes to 1. Khronos' glTF viewer."""
    return alpha * min(max(2 * ior - 2, 0), 1)
