"""Unity's three BRDFs of the Standard shader, 2017.4, whole: one light, ambient diffuse and ambient specular.

Unity's light colour holds the factor pi of a punctual light: diffuse has no 1 / pi, and specular is pi D V F.
"""

import math

from .diffuse import DisneyDiffuse_Unity
from .distribution import GGXTerm_Unity, PerceptualRoughnessToSpecPower
from .fresnel import F_Schlick, FresnelLerp, FresnelLerpFast
from .registry import term
from .unity import (
    DiffuseAndSpecularFromMetallic,
    Unity_SafeNormalize,
    grazingTerm,
    surfaceReduction_BRDF2_linear,
    surfaceReduction_linear,
)
from .vectors import add, dot, multiply, saturate, scale
from .visibility import SmithJointGGXVisibilityTerm_Unity


def set_up(albedo, metallic, smoothness):
    """Diffuse colour, specular colour and grazing term of a metallic surface."""
    split = DiffuseAndSpecularFromMetallic(albedo, metallic)
    return split["diffColor"], split["specColor"], grazingTerm(smoothness, split["oneMinusReflectivity"])


def total(*parts):
    result = [0.0, 0.0, 0.0]
    for part in parts:
        result = add(result, part)
    return result


@term
def BRDF1_Unity_PBS_linear(albedo, metallic, smoothness, normal, viewDir, lightDir, lightColor, giDiffuse, giSpecular):
    """Disney diffuse, GGX with the approximate joint Smith term, Schlick. Burley 2012."""
    diffuse, specular, grazing = set_up(albedo, metallic, smoothness)
    r = 1 - smoothness
    alpha = max(r * r, 0.002)
    h = Unity_SafeNormalize(add(lightDir, viewDir))
    n_v = abs(dot(normal, viewDir))
    n_l, n_h, l_h = (saturate(dot(a, b)) for a, b in ((normal, lightDir), (normal, h), (lightDir, h)))
    visibility = SmithJointGGXVisibilityTerm_Unity(n_l, n_v, alpha)
    lobe = max(0.0, math.pi * visibility * GGXTerm_Unity(n_h, alpha) * n_l) if any(specular) else 0.0
    scatter = DisneyDiffuse_Unity(n_v, n_l, l_h, r) * n_l
    return total(
        multiply(diffuse, add(giDiffuse, scale(lightColor, scatter))),
        scale(multiply(lightColor, [F_Schlick(f0, l_h) for f0 in specular]), lobe),
        scale(multiply(giSpecular, [FresnelLerp(f0, grazing, n_v) for f0 in specular]), surfaceReduction_linear(alpha)),
    )


def brdf2_angles(smoothness, normal, light, view):
    """alpha, the denominator d of BRDF2's GGX, and l.h."""
    h = Unity_SafeNormalize(add(light, view))
    alpha = (1 - smoothness) ** 2
    n_h = saturate(dot(normal, h))
    return alpha, n_h * n_h * (alpha * alpha - 1) + 1.00001, saturate(dot(light, h))


@term
def BRDF2_Unity_PBS_linear(albedo, metallic, smoothness, normal, viewDir, lightDir, lightColor, giDiffuse, giSpecular):
    """GGX with V F as 1 / (4 (l.h)^2 (alpha + 1/2)). Zioma, Optimizing PBR for Mobile, SIGGRAPH 2015."""
    diffuse, specular, grazing = set_up(albedo, metallic, smoothness)
    alpha, d, l_h = brdf2_angles(smoothness, normal, lightDir, viewDir)
    lobe = alpha * alpha / (max(0.1, l_h * l_h) * (alpha + 0.5) * 4 * d * d)
    n_l, n_v = saturate(dot(normal, lightDir)), saturate(dot(normal, viewDir))
    reduction = surfaceReduction_BRDF2_linear(1 - smoothness)
    return total(
        scale(multiply(add(diffuse, scale(specular, lobe)), lightColor), n_l),
        multiply(giDiffuse, diffuse),
        scale(multiply(giSpecular, [FresnelLerpFast(f0, grazing, n_v) for f0 in specular]), reduction),
    )


@term
def BRDF2_Unity_PBS_gamma_specterm(smoothness, n, l, v):
    """BRDF2's lobe in gamma space, about the root of the linear one: alpha / (max(0.32, l.h)(1.5 + alpha) d)."""
    alpha, d, l_h = brdf2_angles(smoothness, n, l, v)
    return alpha / (max(0.32, l_h) * (1.5 + alpha) * d)


@term
def BRDF3_Unity_PBS_given_LUT(
    albedo, metallic, smoothness, normal, viewDir, lightDir, lightColor, giDiffuse, giSpecular, specularLUTvalue
):
    """Normalised Phong from a table: what it gives, with its factor of 16, is the input `specularLUTvalue`."""
    diffuse, specular, grazing = set_up(albedo, metallic, smoothness)
    n_l, n_v = saturate(dot(normal, lightDir)), saturate(dot(normal, viewDir))
    return total(
        scale(multiply(add(diffuse, scale(specular, specularLUTvalue)), lightColor), n_l),
        multiply(giDiffuse, diffuse),
        multiply(giSpecular, [FresnelLerpFast(f0, grazing, n_v) for f0 in specular]),
    )


@term
def BRDF3_specular_reference_5_0(RdotL, smoothness):
    """(e + 2) / (2 pi^2) (r.l)^e, e a quarter of the Blinn-Phong power: what Unity 5.0 states for its table."""
    exponent = PerceptualRoughnessToSpecPower(1 - smoothness) / 4
    return (exponent + 2) / (2 * math.pi**2) * RdotL**exponent
