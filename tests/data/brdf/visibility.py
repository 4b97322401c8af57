"""Masking and shadowing: G in [0, 1], and the visibility term V = G / (4 (n.l)(n.v))."""

import math

from .registry import term


def visible(g, n_l, n_v):
    """V from G."""
    return g / (4 * n_l * n_v)


@term
def Lambda_GGX(alpha, cos):
    """(sqrt(1 + alpha^2 tan^2) - 1) / 2. Walter et al. 2007; Heitz, JCGT 3(2), 2014, equation 72."""
    return (math.sqrt(1 + alpha * alpha * (1 - cos * cos) / (cos * cos)) - 1) / 2


@term
def G1_GGX(alpha, cos):
    """1 / (1 + Lambda). Smith 1967."""
    return 1 / (1 + Lambda_GGX(alpha, cos))


@term
def G2_SmithJoint(alpha, NoV, NoL):
    """1 / (1 + Lambda(v) + Lambda(l)), the height-correlated form. Heitz 2014, equation 99."""
    return 1 / (1 + Lambda_GGX(alpha, NoV) + Lambda_GGX(alpha, NoL))


@term
def V_SmithJointGGX(alpha, NoV, NoL):
    """V of the height-correlated G."""
    return visible(G2_SmithJoint(alpha, NoV, NoL), NoL, NoV)


@term
def V_Smith_separable(alpha, NoV, NoL):
    """V of G1(v) G1(l). Walter et al. 2007, equation 23."""
    return visible(G1_GGX(alpha, NoV) * G1_GGX(alpha, NoL), NoL, NoV)


def joint_denominator(alpha, n_v, n_l):
    """What stands under the 0.5 of the joint V when sqrt(c^2 (1 - a^2) + a^2) is put as c (1 - a) + a."""
    return n_l * (n_v * (1 - alpha) + alpha) + n_v * (n_l * (1 - alpha) + alpha)


@term
def V_SmithJointApprox(alpha, NoV, NoL):
    """0.5 / lerp(2 (n.l)(n.v), n.l + n.v, alpha). Hammon, PBR Diffuse Lighting for GGX+Smith, GDC 2017."""
    return 0.5 / joint_denominator(alpha, NoV, NoL)


@term
def SmithJointGGXVisibilityTerm_Unity(NdotL, NdotV, roughness):
    """The same with Unity's 1e-5 in the denominator. `roughness` is alpha."""
    return 0.5 / (joint_denominator(roughness, NdotV, NdotL) + 1e-5)


def schlick(k, n_v, n_l):
    """V of G1(c) = c / (c (1 - k) + k). Schlick, Computer Graphics Forum 13(3), 1994."""
    return 0.25 / ((n_v * (1 - k) + k) * (n_l * (1 - k) + k))


@term
def V_SchlickGGX_k_half_alpha(alpha, NoV, NoL):
    """k = alpha / 2. Karis, Real Shading in Unreal Engine 4, SIGGRAPH 2013 course (image-based lighting)."""
    return schlick(alpha / 2, NoV, NoL)


@term
def V_SchlickGGX_direct_k(roughness, NoV, NoL):
    """k = (r + 1)^2 / 8 with perceptual roughness r. Karis 2013 (analytic lights)."""
    return schlick((roughness + 1) ** 2 / 8, NoV, NoL)


@term
def SmithBeckmannVisibilityTerm_Unity(NdotL, NdotV, roughness):
    """Schlick's fit of Smith for Beckmann, k = alpha sqrt(2 / pi), with Unity's 1e-5. `roughness` is alpha."""
    k = roughness * math.sqrt(2 / math.pi)
    return 0.25 / (0.25 / schlick(k, NdotV, NdotL) + 1e-5)


@term
def G_Disney2012_G1(roughness, cos):
    """GGX's G1 of width (0.5 + roughness / 2)^2. Burley, Physically-Based Shading at Disney, SIGGRAPH 2012 course."""
    return G1_GGX((0.5 + roughness / 2) ** 2, cos)


@term
def smithG_GGX_clearcoat(cos, alphaG):
    """1 / (c + sqrt(a2 + (1 - a2) c^2)): GGX's G1 over 2 c, Disney's form for the clearcoat with alpha 0.25."""
    return G1_GGX(alphaG, cos) / (2 * cos)


@term
def G_CookTorrance(NoH, NoV, NoL, VoH):
    """min(1, 2 (n.h)(n.v) / v.h, 2 (n.h)(n.l) / v.h), V-cavities. Torrance and Sparrow 1967; Cook, Torrance 1982."""
    return min(1.0, 2 * NoH * NoV / VoH, 2 * NoH * NoL / VoH)


@term
def V_Kelemen(LoH):
    """1 / (4 (l.h)^2). Kelemen and Szirmay-Kalos, Eurographics 2001 short papers."""
    return 1 / (4 * LoH * LoH)


@term
def V_Neubelt(NoV, NoL):
    """1 / (4 (n.l + n.v - (n.l)(n.v))). Neubelt and Pettineo, Crafting a Next-Gen Material Pipeline, 2013."""
    return 1 / (4 * (NoL + NoV - NoL * NoV))
