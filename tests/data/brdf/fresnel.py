"""Reflectance: Schlick's approximation and its kin, and the exact equations of Fresnel."""

import cmath

from .registry import term
from .vectors import lerp


@term
def Pow5(x):
    return x**5


@term
def FresnelLerp(F0, F90, cos):
    """F0 to F90 by (1 - c)^5."""
    return lerp(F0, F90, Pow5(1 - cos))


@term
def FresnelLerpFast(F0, F90, cos):
    """F0 to F90 by (1 - c)^4, Unity's cheaper form."""
    return lerp(F0, F90, (1 - cos) ** 4)


@term
def F_Schlick(F0, cos):
    """F0 + (1 - F0)(1 - c)^5. Schlick, Computer Graphics Forum 13(3), 1994."""
    return FresnelLerp(F0, 1.0, cos)


@term
def FresnelSchlickRoughness(F0, cos, roughness):
    """Schlick that ends at max(1 - r, F0). Lagarde, Adopting a physically based shading model, 2011."""
    return FresnelLerp(F0, max(1 - roughness, F0), cos)


@term
def F_SphericalGaussian(F0, cos):
    """F0 + (1 - F0) 2^((-5.55473 c - 6.98316) c). Lagarde 2012, in Karis 2013."""
    return lerp(F0, 1.0, 2 ** ((-5.55473 * cos - 6.98316) * cos))


def reflectance(m, cosine):
    """The mean of both polarisations at the boundary to a medium of relative index m, which may be complex."""
    inside = cmath.sqrt(1 - (1 - cosine * cosine) / (m * m))  # the cosine behind the boundary, by Snell's law
    across = (cosine - m * inside) / (cosine + m * inside)
    along = (m * cosine - inside) / (m * cosine + inside)
    return (abs(across) ** 2 + abs(along) ** 2) / 2


@term
def F_Dielectric_exact(eta, cos):
    """Fresnel's equations; eta = n2 / n1. Born and Wolf, Principles of Optics, section 1.5."""
    return reflectance(complex(eta), cos)


@term
def F_Conductor_exact(n, k, cos):
    """Fresnel's equations with the complex index n + i k. Born and Wolf, section 14.2."""
    return reflectance(complex(n, k), cos)


@term
def F0_from_ior(n1, n2):
    """((n1 - n2) / (n1 + n2))^2."""
    return ((n1 - n2) / (n1 + n2)) ** 2


@term
def F0_conductor(n, k):
    """((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), the conductor at normal incidence."""
    return ((n - 1) ** 2 + k * k) / ((n + 1) ** 2 + k * k)


@term
def disney_F0_from_specular(specular):
    """0.08 specular. Burley 2012: 0.5 is an index of refraction of 1.5."""
    return 0.08 * specular
