"""Image-based lighting: fits of the split-sum table, sampling, and the index of a measured table."""

import math

from .registry import term


def karis_fit(roughness, n_v):
    """a, and the two numbers that it is scaled onto."""
    x, y = 1 - roughness, 0.0425 - 0.0275 * roughness
    a = min(x * x, 2 ** (-9.28 * n_v)) * x + y
    return a, 1.04 - 0.572 * roughness, 0.022 * roughness - 0.04


@term
def EnvBRDFApprox_Karis_mobile_AB(roughness, NoV):
    """A = z - 1.04 a, B = w + 1.04 a. Karis, Physically Based Shading on Mobile, 2014."""
    a, z, w = karis_fit(roughness, NoV)
    return [z - 1.04 * a, w + 1.04 * a]


@term
def EnvBRDFApproxNonmetal_Karis(roughness, NoV):
    """a itself, the value at F0 = 0.04. Karis 2014."""
    return karis_fit(roughness, NoV)[0]


@term
def EnvironmentBRDF_Lazarov_AB(gloss, NoV):
    """F0 A + B, not yet clamped. Lazarov, Getting More Physical in Call of Duty: Black Ops II, SIGGRAPH 2013."""
    t = (gloss / 0.96, 0.475 * gloss, (0.0275 - 0.01) / 0.96 * gloss + (0.015 - 0.03) / 0.96, 0.25 * gloss + 0.75)
    at_black = t[0] * min(t[1], 2 ** (-9.28 * NoV)) + t[2]
    return [t[3] - at_black, at_black]


@term
def splitsum_specular(prefiltered, F0, A, B):
    """Prefiltered radiance times F0 A + B. Karis 2013."""
    return [light * (f0 * A + B) for light, f0 in zip(prefiltered, F0)]


@term
def importance_sample_ggx_cosThetaH(u, alpha):
    """cos^2 = (1 - u) / (1 + (alpha^2 - 1) u). Walter et al. 2007, equation 35, as a cosine."""
    return math.sqrt((1 - u) / (1 + (alpha * alpha - 1) * u))


@term
def hammersley_vdc(i):
    """The digits of i in base 2 mirrored at the point. van der Corput 1935."""
    return [sum((number >> k & 1) / 2 ** (k + 1) for k in range(32)) for number in i]


@term
def merl_theta_half_index(theta_half):
    """floor(90 sqrt(theta / (pi / 2))), at most 89. Matusik et al., A Data-Driven Reflectance Model, SIGGRAPH 2003."""
    return min(int(90 * math.sqrt(theta_half / (math.pi / 2))), 89)
