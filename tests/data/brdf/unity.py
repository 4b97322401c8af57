"""Functions of Unity's built-in shaders (2017.4): set-ups, ambient reflections, lights, normals, colour, G-buffer.

Their names are the terms' names; the formulas are Unity's, papers are named where there is one.
"""

import math

from .registry import term
from .vectors import add, dot, lerp, mix, multiply, normalize, saturate, scale, subtract

DIELECTRIC_F0 = {"linear": 0.04, "gamma": 0.220916301}  # unity_ColorSpaceDielectricSpec.rgb


# Set-ups of a surface.


@term
def OneMinusReflectivityFromMetallic(metallic, colorspace="linear"):
    """(1 - F0)(1 - metallic) with the dielectric F0 of the colour space."""
    return (1 - DIELECTRIC_F0[colorspace]) * (1 - metallic)


@term
def DiffuseAndSpecularFromMetallic(albedo, metallic):
    """Diffuse albedo times one minus reflectivity; F0 from 0.04 to albedo by metallic."""
    share = OneMinusReflectivityFromMetallic(metallic)
    return {
        "diffColor": scale(albedo, share),
        "specColor": mix([DIELECTRIC_F0["linear"]] * 3, albedo, metallic),
        "oneMinusReflectivity": share,
    }


@term
def EnergyConservationBetweenDiffuseAndSpecular(albedo, specColor, monochrome):
    """Albedo times one minus the largest channel of F0 (monochrome), or one minus F0 channel by channel."""
    share = 1 - max(specColor)
    kept = [share] * 3 if monochrome else [1 - c for c in specColor]
    return {"diffColor": multiply(albedo, kept), "oneMinusReflectivity": share}


@term
def PreMultiplyAlpha(diffColor, alpha, oneMinusReflectivity):
    """Diffuse times alpha; coverage 1 - (1 - alpha)(1 - reflectivity), so that reflections stay."""
    return {"diffColor": scale(diffColor, alpha), "outAlpha": 1 - oneMinusReflectivity * (1 - alpha)}


@term
def grazingTerm(smoothness, oneMinusReflectivity):
    """The F90 of ambient reflections: smoothness + reflectivity, at most 1."""
    return saturate(smoothness + (1 - oneMinusReflectivity))


@term
def surfaceReduction_linear(roughness):
    """1 / (alpha^2 + 1), the share of a GGX lobe, seen from the normal, that is lit from the hemisphere."""
    return 1 / (roughness * roughness + 1)


@term
def surfaceReduction_gamma(perceptualRoughness):
    """1 - 0.28 r^3, a fit of 1 / (r^4 + 1) to the power of 1 / 2.2."""
    return 1 - 0.28 * perceptualRoughness**3


@term
def surfaceReduction_BRDF2_linear(perceptualRoughness):
    """1 - r^3 (0.6 - 0.08 r), BRDF2's fit."""
    return 1 - perceptualRoughness**3 * (0.6 - 0.08 * perceptualRoughness)


@term
def LerpOneTo(b, t):
    """1 to b by t: occlusion by its strength."""
    return lerp(1.0, b, t)


# Ambient reflections.


@term
def Unity_GlossyEnvironment_mip(perceptualRoughness, UNITY_SPECCUBE_LOD_STEPS):
    """r (1.7 - 0.7 r) times the number of steps."""
    return perceptualRoughness * (1.7 - 0.7 * perceptualRoughness) * UNITY_SPECCUBE_LOD_STEPS


@term
def DecodeHDR(data, decodeInstructions, colorspace):
    """x a^y rgb, where a is 1 or, by the switch w, the texel's alpha: RGBM, doubled LDR or HDR as it is."""
    assert colorspace == "linear"
    factor, power, _, from_alpha = decodeInstructions
    return scale(data[:3], factor * lerp(1.0, data[3], from_alpha) ** power)


@term
def BoxProjectedCubemapDirection(worldRefl, worldPos, cubemapCenter, boxMin, boxMax, centerW):
    """From the probe to where the ray leaves the box; axes that the ray does not move along bound nothing.

    Lagarde and Zanuttini, Local Image-based Lighting with Parallax-corrected Cubemap, SIGGRAPH 2012.
    """
    if centerW <= 0:
        return worldRefl
    ray = normalize(worldRefl)
    distances = [
        ((high if d > 0 else low) - p) / d for d, p, low, high in zip(ray, worldPos, boxMin, boxMax) if d != 0
    ]
    return add(subtract(worldPos, cubemapCenter), scale(ray, min(distances)))


# Lights.


@term
def UnityWorldSpaceLightDir(lightPos0, worldPos):
    """xyz - w P: a direction when w is 0, a position when w is 1. Not normalised."""
    return subtract(lightPos0[:3], scale(worldPos, lightPos0[3]))


@term
def vertex_light_attenuation(lengthSq, lightAttenSq):
    """1 / (1 + d^2 k)."""
    return 1 / (1 + lengthSq * lightAttenSq)


@term
def Shade4PointLights(lightPosX, lightPosY, lightPosZ, colors, attenSq, pos, normal):
    """Four Lambert point lights, each n.l / (1 + d^2 k), where d^2 is at least 1e-6."""
    total = [0.0, 0.0, 0.0]
    for x, y, z, color, k in zip(lightPosX, lightPosY, lightPosZ, colors, attenSq):
        to_light = subtract([x, y, z], pos)
        squared = max(dot(to_light, to_light), 1e-6)
        cosine = max(0.0, dot(to_light, normal) / math.sqrt(squared))
        total = add(total, scale(color, cosine * vertex_light_attenuation(squared, k)))
    return total


@term
def point_light_falloff_fit(distance_over_range):
    """sat(sat(5 (1 - x)) / (1 + 25 x^2)), x = d / range: a fit of the falloff texture."""
    x = distance_over_range
    return saturate(saturate(5 * (1 - x)) / (1 + 25 * x * x))


@term
def SubtractMainLightWithRealtimeAttenuationFromLightmap(
    lightmap, attenuation, normal, lightDir, lightColor, shadowColor, shadowStrength_LightShadowData_x
):
    """The lightmap less what the main light loses to its shadow, between the shadow colour and the lightmap."""
    lost = scale(lightColor, max(0.0, dot(normal, lightDir)) * (1 - attenuation))
    shadowed = [max(x, floor) for x, floor in zip(subtract(lightmap, lost), shadowColor)]
    return [min(x, y) for x, y in zip(lightmap, mix(shadowed, lightmap, shadowStrength_LightShadowData_x))]


# Normals and frames.


@term
def UnpackScaleNormal_RGorAG(packed, scale):
    """x from red times alpha, y from green; z from the unit length of what is left."""
    x = (2 * packed[0] * packed[3] - 1) * scale
    y = (2 * packed[1] - 1) * scale
    return [x, y, math.sqrt(1 - saturate(x * x + y * y))]


@term
def UnpackScaleNormal_plainRGB(packed, scale):
    """2 c - 1, x and y scaled, not normalised."""
    x, y, z = (2 * c - 1 for c in packed[:3])
    return [x * scale, y * scale, z]


@term
def BlendNormals(n1, n2):
    """normalize(xy + xy, z z): whiteout blending."""
    return normalize([n1[0] + n2[0], n1[1] + n2[1], n1[2] * n2[2]])


@term
def TangentToWorld_normal(T, B, N, nTS):
    """normalize(x T + y B + z N)."""
    return normalize(add(add(scale(T, nTS[0]), scale(B, nTS[1])), scale(N, nTS[2])))


@term
def WorldToTangent(T, B, N, v):
    """(T.v, B.v, N.v), the inverse of an orthonormal frame."""
    return [dot(T, v), dot(B, v), dot(N, v)]


@term
def ParallaxOffset1Step(h, height, viewDirTS):
    """(h - 1/2) H v.xy / (v.z + 0.42). Kaneko et al., ICAT 2001; offset limiting after Welsh 2004."""
    x, y, z = normalize(viewDirTS)
    shift = (h * height - height / 2) / (z + 0.42)
    return [shift * x, shift * y]


@term
def Unity_SafeNormalize(v):
    """v / sqrt(max(0.001, |v|^2))."""
    return scale(v, 1 / math.sqrt(max(0.001, dot(v, v))))


# Colour: the exact forms are IEC 61966-2-1 below 1 and a power of 2.2 above, with the constants as Unity rounds them.


@term
def LinearToGammaSpace_approx(x):
    """max(1.055 x^0.416666667 - 0.055, 0)."""
    return max(1.055 * max(x, 0.0) ** 0.416666667 - 0.055, 0)


@term
def LinearToGammaSpaceExact(x):
    if x <= 0.0031308:
        return 12.92 * max(x, 0.0)
    return 1.055 * x**0.4166667 - 0.055 if x < 1 else x**0.45454545


@term
def GammaToLinearSpace_approx(x):
    """x (x (0.305306011 x + 0.682171111) + 0.012522878)."""
    return x * (x * (x * 0.305306011 + 0.682171111) + 0.012522878)


@term
def GammaToLinearSpaceExact(x):
    if x <= 0.04045:
        return x / 12.92
    return ((x + 0.055) / 1.055) ** 2.4 if x < 1 else x**2.2


# The G-buffer.


@term
def GBuffer_normal_encode(normal):
    """n / 2 + 1/2."""
    return [0.5 * c + 0.5 for c in normal]


@term
def GBuffer_LDR_emission_encode(c):
    """2^-c, what a low dynamic range target holds of the light."""
    return 2**-c


@term
def GBuffer_LDR_emission_decode(e):
    """-log2 e."""
    return -math.log2(e)
