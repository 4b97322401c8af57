"""The integral of a GGX lobe over the hemisphere of light: directional albedo and the split-sum table. Karis 2013.

With F = F0 + (1 - F0)(1 - v.h)^5 the albedo of D V F is F0 A + B. Every half vector h stands for one direction of
light, l = 2 (v.h) h - v with dl = 4 (v.h) dh (Walter et al. 2007), so that

    A + B = the integral over h of 4 D V (v.h)(n.l) where n.l > 0,   B = the same with a weight of (1 - v.h)^5.

How it is made smooth for Gauss-Legendre quadrature:

* The angle of h to the normal is replaced by t, tan^2 = alpha^2 (e^t - 1): GGX's D (n.h) dh is then
  e^-t dt dphi / (2 pi) for every alpha.
* n.l = 0 at cos(phi) = ((n.v) / (2 n.h) - (n.h)(n.v)) / (sin sin_v); phi runs from 0 to there. All phi are lit below
  the angle theta_1 = (90 degrees - theta_v) / 2 and none above theta_2 = (90 degrees + theta_v) / 2. The bound leaves
  both ends like a square root, which a squared sine in place of t takes out.
"""

import math

from .quadrature import gauss_legendre
from .registry import term, term_within
from .visibility import V_SchlickGGX_k_half_alpha, V_SmithJointApprox, V_SmithJointGGX

integral = term_within(relative=1e-6, absolute=1e-12)
NODES = 96  # an axis; 192 change no value by more than 1e-13


def around(alpha, n_v, sin_v, t, visibility):
    """The integral over phi at the angle of the half vector that t stands for, with both weights."""
    tangent = alpha * math.sqrt(math.expm1(t))
    n_h = 1 / math.sqrt(1 + tangent * tangent)
    along, across = n_h * n_v, tangent * n_h * sin_v
    bound = (n_v / (2 * n_h) - along) / across if across > 0 else -1.0
    phi_end = math.acos(min(max(bound, -1.0), 1.0))
    plain = weighted = 0.0
    for x, w in gauss_legendre(NODES):
        v_h = along + across * math.cos(phi_end * x * (2 - x))  # nodes gather at phi_end, where n.l leaves zero
        n_l = 2 * v_h * n_h - n_v
        if n_l <= 0:
            continue
        value = 2 * (1 - x) * w * visibility(alpha, n_v, n_l) * n_l * v_h
        plain += value
        weighted += value * (1 - v_h) ** 5
    factor = 4 / n_h * math.exp(-t) * phi_end / math.pi  # both signs of phi
    return factor * plain, factor * weighted


def split_sum(alpha, n_v, visibility):
    """[A, B] of a lobe with the visibility term `visibility(alpha, n_v, n_l)`."""
    theta_v = math.acos(n_v)
    sin_v = math.sin(theta_v)
    t_1, t_2 = (math.log1p((math.tan(math.pi / 4 + side * theta_v / 2) / alpha) ** 2) for side in (-1, 1))
    pieces = []
    for x, w in gauss_legendre(NODES):
        pieces.append((t_1 * x, t_1 * w))
        gathered = t_1 + (t_2 - t_1) * math.sin(math.pi / 2 * x) ** 2
        pieces.append((gathered, (t_2 - t_1) * math.pi / 2 * math.sin(math.pi * x) * w))
    both = [(width, around(alpha, n_v, sin_v, t, visibility)) for t, width in pieces if width > 0]
    everything = math.fsum(width * value[0] for width, value in both)
    weighted = math.fsum(width * value[1] for width, value in both)
    return [everything - weighted, weighted]


@integral
def DFG_AB_smith_joint_exact(roughness, NoV):
    """A and B with the height-correlated V; takes perceptual roughness."""
    return split_sum(roughness**2, NoV, V_SmithJointGGX)


@integral
def DFG_AB_smith_joint_approx(roughness, NoV):
    """A and B with the approximation of it."""
    return split_sum(roughness**2, NoV, V_SmithJointApprox)


@integral
def DFG_AB_schlick_k_half_alpha_karis2013(roughness, NoV):
    """A and B with Schlick's V, k = alpha / 2, as the course has them."""
    return split_sum(roughness**2, NoV, V_SchlickGGX_k_half_alpha)


@integral
def directional_albedo_GGX_F1_joint(alpha, NoV):
    """A + B: what a lobe with F = 1 sends back."""
    return math.fsum(split_sum(alpha, NoV, V_SmithJointGGX))


@term
def DFG_white_furnace_closed_form(alpha, NoV):
    """1 - ln 2, A + B for alpha = 1 and the view along the normal: 2 V is 1 / (1 + n.l), D is 1 / pi."""
    assert alpha == 1 and NoV == 1
    return 1 - math.log(2)
