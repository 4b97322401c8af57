"""Disney's diffuse term."""

import math

from .registry import term
from .vectors import lerp


@term
def DisneyDiffuse_Unity(NdotV, NdotL, LdotH, perceptualRoughness):
    """(1 + (F90 - 1)(1 - n.l)^5)(1 + (F90 - 1)(1 - n.v)^5), F90 = 0.5 + 2 (l.h)^2 r. Burley 2012; no 1 / pi."""
    f90 = 0.5 + 2 * LdotH * LdotH * perceptualRoughness
    return lerp(1.0, f90, (1 - NdotL) ** 5) * lerp(1.0, f90, (1 - NdotV) ** 5)


@term
def DisneyDiffuse_source0_div_pi(NdotV, NdotL, LdotH, perceptualRoughness):
    """The same as a BRDF of a white surface: with the 1 / pi."""
    return DisneyDiffuse_Unity(NdotV, NdotL, LdotH, perceptualRoughness) / math.pi
