"""Spherical harmonics of three bands, without the Condon-Shortley sign: index l (l + 1) + m, polynomials of x, y, z.

Ramamoorthi and Hanrahan, An Efficient Representation for Irradiance Environment Maps, SIGGRAPH 2001; Green, GDC 2003;
Sloan, Stupid Spherical Harmonics Tricks, GDC 2008. Coefficients are those of radiance unless a term says otherwise.
"""

import math

from .quadrature import gauss_legendre, over_sphere
from .registry import term_within
from .unity import LinearToGammaSpace_approx
from .vectors import dot

term = term_within(relative=1e-12, absolute=1e-14)  # sums in which the parts of opposite sign cancel

BANDS = (0, 1, 1, 1, 2, 2, 2, 2, 2)

# sqrt((2 l + 1) / (4 pi) (l - |m|)! / (l + |m|)!), times sqrt 2 where m is not 0, times the factor of the polynomial.
SCALES = [math.sqrt(k / math.pi) / 4 for k in (4, 12, 12, 12, 60, 60, 5, 60, 15)]


@term
def sh_basis_zup(n):
    """Y_0 to Y_8 with the axis along z."""
    x, y, z = n
    polynomials = (1, y, z, x, x * y, y * z, 3 * z * z - dot(n, n), x * z, x * x - y * y)
    return [k * p for k, p in zip(SCALES, polynomials)]


@term
def sh_basis_source0_yup(n):
    """The same basis with the axis along y: y and z change places, a reflection."""
    x, y, z = n
    return sh_basis_zup([x, z, y])


def legendre(l, x):
    return (1, x, 1.5 * x * x - 0.5)[l]


def cosine_factor(l):
    """A_l = 2 pi times the integral of P_l(x) x from 0 to 1: what convolving with a clamped cosine does to band l."""
    return 2 * math.pi * math.fsum(w * legendre(l, x) * x for x, w in gauss_legendre(8))


@term
def sh_cosine_factors(l):
    """pi, 2 pi / 3, pi / 4. Ramamoorthi and Hanrahan 2001, equation 8."""
    return [cosine_factor(band) for band in l]


ENVIRONMENTS = {  # radiance by height
    "1": lambda z: 1.0,
    "1 if z>0 else 0": lambda z: 1.0 if z > 0 else 0.0,
    "max(0,z)": lambda z: max(z, 0.0),
    "z^2": lambda z: z * z,
}


def projected(environment):
    """The nine integrals of radiance times Y_i; both halves of the sphere apart, so that each is a polynomial."""
    radiance = ENVIRONMENTS[environment]

    def coefficient(i):
        def product(w):
            return radiance(w[2]) * sh_basis_zup(w)[i]

        return over_sphere(product, -1, 0) + over_sphere(product, 0, 1)

    return [coefficient(i) for i in range(9)]


def irradiance(coefficients, n):
    """Sum of A_l c_i Y_i(n)."""
    return math.fsum(cosine_factor(l) * c * y for l, c, y in zip(BANDS, coefficients, sh_basis_zup(n)))


@term
def sh_project_constant(L):
    return projected(L)


@term
def sh_project_hemisphere_up_z(L):
    return projected(L)


@term
def sh_project_clamped_cosine_z(L):
    return projected(L)


@term
def sh_project_z2(L):
    return projected(L)


@term
def sh_irradiance_constant(L, n):
    return irradiance(projected(L), n)


@term
def sh_irradiance_hemisphere(n):
    return irradiance(projected("1 if z>0 else 0"), n)


@term
def sh_irradiance_of_clamped_cosine(n):
    return irradiance(projected("max(0,z)"), n)


@term
def sh_irradiance_z2(n):
    return irradiance(projected("z^2"), n)


@term
def sh_irradiance_delta_unit(lightDir, n):
    """A directional light of unit irradiance: its coefficients are Y_i(l)."""
    return irradiance(sh_basis_zup(lightDir), n)


@term
def sh_directional_normalisation():
    """What makes irradiance towards a directional light 1, and irradiance / pi. Sloan 2008."""
    towards = sh_irradiance_delta_unit([0, 0, 1], [0, 0, 1])
    return {"one_over_17_16": 1 / towards, "16pi_over_17": math.pi / towards}


@term
def unity_sh_pack(radiance_sh_zup):
    """Unity's vectors of one channel: irradiance / pi is SHA.(x, y, z, 1) + SHB.(xy, yz, zz, zx) + SHC (x^2 - y^2)."""
    u = [cosine_factor(l) / math.pi * c * k for l, c, k in zip(BANDS, radiance_sh_zup, SCALES)]
    return {"SHA": [u[3], u[1], u[2], u[0] - u[6]], "SHB": [u[4], u[5], 3 * u[6], u[7]], "SHC": u[8]}


@term
def unity_sh_pack_constant(L):
    return unity_sh_pack(projected(L))


@term
def ShadeSH9_linear(radiance_sh_zup, n):
    """Irradiance / pi from the packed vectors."""
    packed = unity_sh_pack(radiance_sh_zup)
    x, y, z = n
    quadratic = dot(packed["SHB"], [x * y, y * z, z * z, z * x]) + packed["SHC"] * (x * x - y * y)
    return dot(packed["SHA"], [x, y, z, 1]) + quadratic


# The nine coloured coefficients that the first of the source documents lights its material with; irradiance / pi.
SOURCE_COEFFICIENTS = (
    (1.81877, 1.86597, 1.7507),
    (0.155764, 0.164684, 0.186911),
    (0.329662, 0.533947, 0.816486),
    (-0.020924, -0.0446067, -0.076697),
    (0.0514308, 0.0588754, 0.0774349),
    (0.11579, 0.109153, 0.109399),
    (-0.335727, -0.298582, -0.181839),
    (0.0867315, 0.0715153, 0.0523889),
    (-0.150664, -0.0802716, 0.0130783),
)


@term
def source0_calculateSH_linear(normal):
    """The sum of coefficients times the y-up basis."""
    return [dot(channel, sh_basis_source0_yup(normal)) for channel in zip(*SOURCE_COEFFICIENTS)]


@term
def source0_calculateSH_gamma(normal):
    """The same as sRGB by Unity's fit, with a negative sum clamped before the power."""
    return [LinearToGammaSpace_approx(c) for c in source0_calculateSH_linear(normal)]


@term
def sh_source_permutation_L2(c6, c8):
    """The coefficients 6 and 8 in the y-up basis of a function that has these two in the z-up one: projected again."""

    def project(index):
        def value(w):
            basis = sh_basis_zup(w)
            return (c6 * basis[6] + c8 * basis[8]) * sh_basis_source0_yup(w)[index]

        return over_sphere(value)

    return {"c6p": project(6), "c8p": project(8)}
