"""Normal distribution functions D(n.h), normalised so that the integral of D (n.h) over the hemisphere is 1.

alpha is the width of the distribution, perceptual roughness squared (Burley 2012).
"""

import math

from .registry import term
from .vectors import dot


def tangent_squared(cosine):
    return (1 - cosine * cosine) / (cosine * cosine)


@term
def D_GGX(a2, NoH):
    """a2 / (pi cos^4 (a2 + tan^2)^2). Trowbridge and Reitz 1975; Walter et al., EGSR 2007, equation 33."""
    return a2 / (math.pi * NoH**4 * (a2 + tangent_squared(NoH)) ** 2)


@term
def D_Beckmann(a2, NoH):
    """exp(-tan^2 / a2) / (pi a2 cos^4). Beckmann and Spizzichino 1963; Walter et al. 2007, equation 25."""
    return math.exp(-tangent_squared(NoH) / a2) / (math.pi * a2 * NoH**4)


@term
def blinn_specpower_from_alpha(alpha):
    """e = 2 / alpha^2 - 2, which gives Blinn's lobe the curvature of Beckmann's at its peak. Walter et al. 2007."""
    return 2 / (alpha * alpha) - 2


@term
def D_Blinn(a2, NoH):
    """(e + 2) / (2 pi) (n.h)^e. Blinn 1977, normalised as in Walter et al. 2007, equation 30."""
    exponent = blinn_specpower_from_alpha(math.sqrt(a2))
    return (exponent + 2) / (2 * math.pi) * NoH**exponent


@term
def NDFBlinnPhongNormalizedTerm(NdotH, n):
    """(n + 2) / (2 pi) (n.h)^n, by exponent."""
    return (n + 2) / (2 * math.pi) * NdotH**n


@term
def PerceptualRoughnessToRoughness(perceptualRoughness):
    """alpha = perceptual roughness squared. Burley, SIGGRAPH 2012 course."""
    return perceptualRoughness**2


@term
def SmoothnessToRoughness(smoothness):
    """alpha = (1 - smoothness)^2."""
    return PerceptualRoughnessToRoughness(1 - smoothness)


@term
def PerceptualRoughnessToSpecPower(perceptualRoughness):
    """2 / alpha^2 - 2 in Unity's bounds: alpha^2 not below 1e-4, the exponent not below 1e-4."""
    squared = max(1e-4, PerceptualRoughnessToRoughness(perceptualRoughness) ** 2)
    return max(2 / squared - 2, 1e-4)


@term
def GGXTerm_Unity(NdotH, roughness):
    """GGX as Unity's BRDF1 guards it: 1e-7 under the fraction. `roughness` is alpha."""
    a2 = roughness * roughness
    d = NdotH * NdotH * (a2 - 1) + 1
    return a2 / math.pi / (d * d + 1e-7)


@term
def GGX_Mobile(Roughness, NoH):
    """(alpha / (sin^2 + alpha^2 cos^2))^2 in at most 65504, without the 1 / pi; takes perceptual roughness.

    GGX by Lagrange's identity |n x h|^2 = 1 - (n.h)^2, which keeps the digits that half precision loses. Guy and
    Agopian, Physically Based Rendering in Filament, section 4.4.1.
    """
    alpha = Roughness * Roughness
    sine_squared = (1 - NoH) * (1 + NoH)
    return min((alpha / (sine_squared + (alpha * NoH) ** 2)) ** 2, 65504.0)


@term
def D_GTR_c(alpha, gamma):
    """The constant of GTR: (gamma - 1)(a2 - 1) / (pi (1 - a2^(1 - gamma))), (a2 - 1) / (pi ln a2) at gamma 1.

    Over the hemisphere D (n.h) is, with u = cos^2, the integral of pi c / (1 - (1 - a2) u)^gamma du from 0 to 1.
    Burley 2012, appendix B.
    """
    a2 = alpha * alpha
    if gamma == 1:
        return (a2 - 1) / (math.pi * math.log(a2))
    return (gamma - 1) * (a2 - 1) / (math.pi * (1 - a2 ** (1 - gamma)))


@term
def D_GTR(alpha, gamma, NoH):
    """c / (alpha^2 cos^2 + sin^2)^gamma. Burley 2012: gamma 1 is Berry's distribution, gamma 2 is GGX."""
    squared = alpha * alpha * NoH * NoH + (1 - NoH) * (1 + NoH)
    return D_GTR_c(alpha, gamma) / squared**gamma


@term
def GTR1(NoH, alpha):
    """GTR of gamma 1, the clearcoat's distribution; 1 / pi at alpha 1, where it is constant."""
    return 1 / math.pi if alpha >= 1 else D_GTR(alpha, 1, NoH)


@term
def GTR2_aniso(h, n, x, y, ax, ay):
    """1 / (pi ax ay ((h.x / ax)^2 + (h.y / ay)^2 + (n.h)^2)^2). Burley 2012, appendix B.2."""
    stretched = (dot(h, x) / ax) ** 2 + (dot(h, y) / ay) ** 2 + dot(h, n) ** 2
    return 1 / (math.pi * ax * ay * stretched**2)
