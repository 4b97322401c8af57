"""Disney's principled BRDF of 2012, whole."""

import math

from .diffuse import DisneyDiffuse_Unity
from .distribution import GTR1, GTR2_aniso
from .fresnel import F_Schlick, FresnelLerp, Pow5, disney_F0_from_specular
from .registry import term
from .vectors import add, dot, half_between, lerp, mix, scale
from .visibility import smithG_GGX_clearcoat


def stretched_g(cosine, along_x, along_y, ax, ay):
    """Smith's G1 of the anisotropic GGX over 2 c. Heitz 2014: alpha^2 tan^2 becomes (x^2 ax^2 + y^2 ay^2) / c^2."""
    return 1 / (cosine + math.sqrt((along_x * ax) ** 2 + (along_y * ay) ** 2 + cosine**2))


@term
def disney_principled_2012(
    L,
    V,
    N,
    X,
    Y,
    baseColor,
    metallic=0,
    subsurface=0,
    specular=0.5,
    roughness=0.5,
    specularTint=0,
    anisotropic=0,
    sheen=0,
    sheenTint=0.5,
    clearcoat=0,
    clearcoatGloss=1,
):
    """f(l, v), not times n.l. Burley, Physically-Based Shading at Disney, SIGGRAPH 2012 course, and Disney's own code.

    The masking terms are those of the code: Smith's with alpha itself, where the notes remap it; 0.25 for clearcoat.
    Base colour is gamma 2.2, as there.
    """
    n_l, n_v = dot(N, L), dot(N, V)
    if n_l < 0 or n_v < 0:
        return [0.0, 0.0, 0.0]
    H = half_between(L, V)
    n_h, l_h = dot(N, H), dot(L, H)

    color = [c**2.2 for c in baseColor]
    luminance = dot([0.3, 0.6, 0.1], color)
    white = [1.0, 1.0, 1.0]
    tint = scale(color, 1 / luminance) if luminance > 0 else white
    dielectric = scale(mix(white, tint, specularTint), disney_F0_from_specular(specular))
    f0 = mix(dielectric, color, metallic)

    flat90 = l_h * l_h * roughness
    flattened = lerp(1.0, flat90, Pow5(1 - n_l)) * lerp(1.0, flat90, Pow5(1 - n_v))
    flat = 1.25 * (flattened * (1 / (n_l + n_v) - 0.5) + 0.5)
    diffuse = lerp(DisneyDiffuse_Unity(n_v, n_l, l_h, roughness), flat, subsurface)
    cloth = scale(mix(white, tint, sheenTint), sheen * Pow5(1 - l_h))
    body = scale(add(scale(color, diffuse / math.pi), cloth), 1 - metallic)

    aspect = math.sqrt(1 - 0.9 * anisotropic)
    ax, ay = max(0.001, roughness**2 / aspect), max(0.001, roughness**2 * aspect)
    visibility = stretched_g(n_l, dot(L, X), dot(L, Y), ax, ay) * stretched_g(n_v, dot(V, X), dot(V, Y), ax, ay)
    lobe = scale([F_Schlick(f, l_h) for f in f0], visibility * GTR2_aniso(H, N, X, Y, ax, ay))

    coat = GTR1(n_h, lerp(0.1, 0.001, clearcoatGloss)) * FresnelLerp(0.04, 1.0, l_h)
    coat *= smithG_GGX_clearcoat(n_l, 0.25) * smithG_GGX_clearcoat(n_v, 0.25) * 0.25 * clearcoat
    return add(add(body, lobe), scale(white, coat))
