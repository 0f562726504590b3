"""Every symbol of the derivations, declared once: name, LaTeX, unit, domain and meaning."""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import combinations_with_replacement

import sympy as sp


@dataclass(frozen=True)
class Quantity:
    """What a symbol stands for.

    Attributes
    ----------
    symbol : sympy.Symbol
        The symbol used in every derivation.
    latex : str
        How it is typeset.
    unit : str
        SI unit, ``-`` for a pure number.
    domain : str
        Values that it may take.
    meaning : str
        What it measures.
    """

    symbol: sp.Symbol
    latex: str
    unit: str
    domain: str
    meaning: str


# Directions: beta is measured from axis 3, alpha about it.
x = sp.Symbol("x", real=True)
s = sp.Symbol("s", nonnegative=True)
y = sp.Symbol("y", nonnegative=True)
sin_beta = sp.Symbol("sin_beta", nonnegative=True)
cos_alpha, sin_alpha = sp.symbols("cos_alpha sin_alpha", real=True)

# Fabric.
D33, D3333, Dr33 = sp.symbols("D33 D3333 Dr33", real=True)
e0, e1, e2 = sp.symbols("e0 e1 e2", real=True)
w0, w1 = sp.symbols("w0 w1", positive=True)
N11, N33 = sp.symbols("N11 N33", positive=True)
FIRST_KIND = sp.symbols("N1111 N1112 N1113 N1122 N1123 N1133 N1222 N1223 N1233 N1333 N2222 N2223 N2233 N2333 N3333",
                        real=True)
aspect_ratio, varrho = sp.symbols("aspect_ratio varrho", positive=True)

# Fabric without an axis: one symbol for each set of indices, 11, 22, 33, 23, 13, 12 and 1111, 1112, ..., 3333.
PAIRS = ((1, 1), (2, 2), (3, 3), (2, 3), (1, 3), (1, 2))
FOURS = tuple(combinations_with_replacement((1, 2, 3), 4))
NORMALS_2 = tuple(sp.Symbol(f"D{i}{j}", real=True) for i, j in PAIRS)
NORMALS_4 = tuple(sp.Symbol("D" + "".join(map(str, four)), real=True) for four in FOURS)
BRANCHES_2 = tuple(sp.Symbol(f"Dr{i}{j}", real=True) for i, j in PAIRS)
v = sp.Symbol("v", real=True)

# Contacts.
kn, ks, kt, kr = sp.symbols("kn ks kt kr", positive=True)
nu = sp.Symbol("nu", nonnegative=True)
lam = sp.Symbol("lam", positive=True)
one_minus_lam = sp.Symbol("one_minus_lam", nonnegative=True)

# Assembly.
M, V = sp.symbols("M V", positive=True)
branch_length, mean_branch_length, W, radius = sp.symbols("ell ell_e W r", positive=True)

# Moments.
m0, m1, m2 = sp.symbols("m0 m1 m2", positive=True)
p0, p1, p2 = sp.symbols("p0 p1 p2", positive=True)
TENSOR_MOMENTS = tuple(sp.Symbol("M" + "".join(map(str, four)), real=True) for four in FOURS)

# Elasticity.
C1111, C3333, C2323, C1212 = sp.symbols("C1111 C3333 C2323 C1212", positive=True)
C1122, C1133 = sp.symbols("C1122 C1133", real=True)
relaxed_C2323 = sp.Symbol("relaxed_C2323", positive=True)
S1111, S3333, S2323, S1212 = sp.symbols("S1111 S3333 S2323 S1212", positive=True)
S1122, S1133 = sp.symbols("S1122 S1133", real=True)
TWENTY_ONE = tuple(
    next((known for known in (C1111, C3333, C1122, C1133, C2323, C1212) if known.name == name),
         sp.Symbol(name, real=True))
    for name in (f"C{i}{j}{k}{m}" for (i, j), (k, m) in combinations_with_replacement(PAIRS, 2)))
density = sp.Symbol("density", positive=True)
sin_squared, cos_squared = sp.symbols("sin_squared cos_squared", nonnegative=True)
E1, E3, G23, G12, K = sp.symbols("E1 E3 G23 G12 K", positive=True)
nu12, nu13, nu31 = sp.symbols("nu12 nu13 nu31", real=True)
v_P, v_SV, v_SH = sp.symbols("v_P v_SV v_SH", positive=True)
epsilon, gamma, delta = sp.symbols("epsilon gamma delta", real=True)

# Contact forces, slip.
sigma11, sigma33 = sp.symbols("sigma11 sigma33", real=True)
mean_stress, SR = sp.symbols("p SR", positive=True)
a, c = sp.symbols("a c", positive=True)
d = sp.Symbol("d", real=True)
mu = sp.Symbol("mu", positive=True)
phi = sp.Symbol("phi", positive=True)
fn, fr = sp.symbols("fn fr", nonnegative=True)
f_ref, kn_ref = sp.symbols("f_ref kn_ref", positive=True)
shear_modulus, relative_radius = sp.symbols("G_s R_e", positive=True)
beta, omega, psi = sp.symbols("beta omega psi", real=True)
circle_center, circle_radius = sp.symbols("m R", positive=True)
h0 = sp.Symbol("h0", real=True)
tangent = sp.Symbol("t", positive=True)
log_tangent = sp.Symbol("sigma", real=True)
kappa, psi_s = sp.symbols("kappa psi_s", positive=True)
margin, onset_strength = sp.symbols("margin onset_strength", real=True)

# Moments with contact stiffnesses averaged apart: normal, tangential, normal less tangential; then the flexibilities.
q0, q1, q2 = sp.symbols("q0 q1 q2", nonnegative=True)
d0, d1 = sp.symbols("d0 d1", nonnegative=True)
u0, u1, u2 = sp.symbols("u0 u1 u2", positive=True)
v0, v1, v2 = sp.symbols("v0 v1 v2", positive=True)
g0, g1 = sp.symbols("g0 g1", nonnegative=True)
eta = sp.Symbol("eta", real=True)

# Gradation.
r50, median = sp.symbols("r50 median", positive=True)
log_variance, branch_log_variance = sp.symbols("log_variance branch_log_variance", positive=True)
total_log_variance, mode_ratio = sp.symbols("total_log_variance mode_ratio", positive=True)
order = sp.Symbol("order", real=True)
void_ratio, coordination, mean_cube = sp.symbols("void_ratio coordination mean_cube", positive=True)
kinematic_factor, static_factor = sp.symbols("kinematic_factor static_factor", positive=True)

STIFFNESS = (C1111, C3333, C1122, C1133, C2323, C1212)
COMPLIANCE = (S1111, S3333, S1122, S1133, S2323, S1212)
POWER_MOMENTS = (m0, m1, m2)
POSITIVE_MOMENTS = (p0, p1, p2)
TANGENTIAL_MOMENTS = (q0, q1, q2)
NORMAL_FLEXIBILITIES = (u0, u1, u2)
TANGENTIAL_FLEXIBILITIES = (v0, v1, v2)

GLOSSARY: tuple[Quantity, ...] = (
    Quantity(x, r"x", "-", "-1 to 1", "cosine of the angle from axis 3"),
    Quantity(s, r"s", "-", "0 to 1", "squared sine of the angle from axis 3"),
    Quantity(y, r"y", "-", "0 to 1", "squared cosine of the angle from axis 3"),
    Quantity(sin_beta, r"\sin\beta", "-", "0 to 1", "sine of the angle from axis 3"),
    Quantity(cos_alpha, r"\cos\alpha", "-", "-1 to 1", "cosine of the azimuth about axis 3"),
    Quantity(sin_alpha, r"\sin\alpha", "-", "-1 to 1", "sine of the azimuth about axis 3"),
    Quantity(D33, r"D_{33}", "-", "-1 to 2 without a rank-four part", "P2 coefficient of the contact-normal density"),
    Quantity(D3333, r"D_{3333}", "-", "density not negative", "P4 coefficient of the contact-normal density"),
    Quantity(Dr33, r"D^{r}_{33}", "-", "-1 to 2, ends excluded", "P2 coefficient of the branch-length weight"),
    Quantity(e0, r"e_0", "-", ">= 0", "contact-normal density at the equator, over that of an isotropic packing"),
    Quantity(e1, r"e_1", "-", "density not negative", "middle coefficient of the contact-normal density"),
    Quantity(e2, r"e_2", "-", ">= 0", "contact-normal density at the pole, over that of an isotropic packing"),
    Quantity(w0, r"w_0", "-", "> 0", "branch-length weight at the equator"),
    Quantity(w1, r"w_1", "-", "> 0", "branch-length weight at the pole"),
    Quantity(N11, r"N_{11}", "-", "1/5 to 2/5", "horizontal component of the fabric tensor"),
    Quantity(N33, r"N_{33}", "-", "1/5 to 3/5", "vertical component of the fabric tensor"),
    *(Quantity(c, rf"N_{{{c.name[1:]}}}", "-", "-1 to 1", f"mean of {' '.join(f'n{i}' for i in c.name[1:])} over the "
               "contacts") for c in FIRST_KIND),
    Quantity(aspect_ratio, r"\chi", "-", "> 0", "semi-axis of a spheroid along axis 3 over the one across"),
    Quantity(varrho, r"\varrho", "-", "> 0", "form linear in y, pole over equator: squared aspect ratio of a spheroid"),
    Quantity(v, r"v", "-", "-1 to 1", "contrast of the roots of the branch-length weight at pole and equator"),
    Quantity(kn, r"k_n", "N/m", "> 0", "normal contact stiffness"),
    Quantity(ks, r"k_s", "N/m", "> 0", "tangential contact stiffness along the meridian"),
    Quantity(kt, r"k_t", "N/m", "> 0", "tangential contact stiffness along the parallel"),
    Quantity(kr, r"k_r", "N/m", "> 0", "tangential contact stiffness when it is the same in all directions"),
    Quantity(nu, r"\nu", "-", "0 to 1/2", "Poisson's ratio of the grain material"),
    Quantity(lam, r"\lambda", "-", "2/3 to 1", "tangential over normal contact stiffness without slip"),
    Quantity(one_minus_lam, r"\bar\lambda", "-", "0 to 1/3", "one minus the stiffness ratio, entered as itself"),
    Quantity(m0, r"m_0", "-", "> 0", "mean of the weight over the directions"),
    Quantity(m1, r"m_1", "-", "> 0", "moment of the weight with the squared cosine"),
    Quantity(m2, r"m_2", "-", "> 0", "moment of the weight with the fourth power of the cosine"),
    Quantity(p0, r"p_0", "-", "> 0", "moment of the weight with the fourth power of the sine"),
    Quantity(p1, r"p_1", "-", "> 0", "moment of the weight with squared sine and squared cosine"),
    Quantity(p2, r"p_2", "-", "> 0", "moment of the weight with the fourth power of the cosine"),
    *(Quantity(c, rf"C_{{{c.name[1:]}}}", "Pa", "positive definite", f"stiffness component {c.name[1:]}")
      for c in (*STIFFNESS, *(c for c in TWENTY_ONE if c not in STIFFNESS))),
    *(Quantity(c, rf"D_{{{c.name[1:]}}}", "-", "density not negative",
               f"component {c.name[1:]} of the contact-normal tensor, traceless") for c in NORMALS_2 if c != D33),
    *(Quantity(c, rf"D_{{{c.name[1:]}}}", "-", "density not negative",
               f"component {c.name[1:]} of the contact-normal tensor of rank four, symmetric and traceless")
      for c in NORMALS_4 if c != D3333),
    *(Quantity(c, rf"D^{{r}}_{{{c.name[2:]}}}", "-", "branch lengths positive",
               f"component {c.name[2:]} of the branch tensor, traceless") for c in BRANCHES_2 if c != Dr33),
    *(Quantity(c, rf"M_{{{c.name[1:]}}}", "-", "any",
               f"mean of the weight times the normal's components {', '.join(c.name[1:])}") for c in TENSOR_MOMENTS),
    Quantity(relaxed_C2323, r"\tilde C_{2323}", "Pa", "> 0", "stiffness component 2323 when grains are free to spin"),
    *(Quantity(c, rf"S_{{{c.name[1:]}}}", "1/Pa", "positive definite", f"compliance component {c.name[1:]}")
      for c in COMPLIANCE),
    Quantity(M, r"M", "-", "> 0", "number of contacts in the representative volume"),
    Quantity(V, r"V", "m^3", "> 0", "representative volume"),
    Quantity(branch_length, r"\ell", "m", "> 0", "length of a branch vector"),
    Quantity(mean_branch_length, r"\ell_e", "m", "> 0", "mean length of the branch vectors"),
    Quantity(W, r"W", "-", "> 0", "branch-length weight of a direction"),
    Quantity(radius, r"r", "m", "> 0", "radius of equal spheres"),
    Quantity(E1, r"E_1", "Pa", "> 0", "Young's modulus across axis 3"),
    Quantity(E3, r"E_3", "Pa", "> 0", "Young's modulus along axis 3"),
    Quantity(nu12, r"\nu_{12}", "-", "-1 to 1", "Poisson's ratio between two directions across axis 3"),
    Quantity(nu13, r"\nu_{13}", "-", "positive definite", "contraction along axis 3 under a pull across it"),
    Quantity(nu31, r"\nu_{31}", "-", "positive definite", "contraction across axis 3 under a pull along it"),
    Quantity(G23, r"G_{23}", "Pa", "> 0", "shear modulus of planes through axis 3"),
    Quantity(G12, r"G_{12}", "Pa", "> 0", "shear modulus of the plane across axis 3"),
    Quantity(K, r"K", "Pa", "> 0", "bulk modulus under equal pressure from all sides"),
    Quantity(v_P, r"v_P", "m/s", "> 0", "phase speed of the faster wave polarised in the plane of axis 3"),
    Quantity(v_SV, r"v_{SV}", "m/s", "> 0", "phase speed of the slower wave polarised in the plane of axis 3"),
    Quantity(v_SH, r"v_{SH}", "m/s", "> 0", "phase speed of the wave polarised across axis 3"),
    Quantity(epsilon, r"\epsilon", "-", "any", "Thomsen's parameter of compression across and along axis 3"),
    Quantity(gamma, r"\gamma", "-", "any", "Thomsen's parameter of shear across and along axis 3"),
    Quantity(delta, r"\delta", "-", "any", "Thomsen's parameter of compression near axis 3"),
    Quantity(density, r"\rho", "kg/m^3", "> 0", "bulk density of the assembly"),
    Quantity(sin_squared, r"\sin^2\theta", "-", "0 to 1", "squared sine of the angle of propagation from axis 3"),
    Quantity(cos_squared, r"\cos^2\theta", "-", "0 to 1", "squared cosine of the angle of propagation from axis 3"),
    Quantity(sigma11, r"\sigma_{11}", "Pa", "compression positive", "principal stress across axis 3"),
    Quantity(sigma33, r"\sigma_{33}", "Pa", "compression positive", "principal stress along axis 3"),
    Quantity(mean_stress, r"p", "Pa", "> 0", "mean stress, compression positive"),
    Quantity(SR, r"\mathrm{SR}", "-", "> 0", "stress ratio, principal stress along over across axis 3"),
    Quantity(a, r"a", "-", "> 0 unless contacts open", "normal contact force at the equator, 1 when all is isotropic"),
    Quantity(c, r"c", "-", "> 0 unless contacts open", "normal contact force at the pole, 1 when all is isotropic"),
    Quantity(d, r"d", "-", "any", "normal contact force at the pole less that at the equator"),
    Quantity(mu, r"\mu", "-", "> 0", "friction coefficient between grains"),
    Quantity(phi, r"\phi", "-", "0 to pi/2", "friction angle between grains"),
    Quantity(fn, r"f_n", "N", "> 0 unless the contact opens", "normal contact force"),
    Quantity(fr, r"f_r", "N", ">= 0", "shear contact force"),
    Quantity(f_ref, r"f^{\circ}", "N", "> 0", "normal contact force of the isotropic assembly"),
    Quantity(kn_ref, r"k_n^{\circ}", "N/m", "> 0", "normal contact stiffness under that force"),
    Quantity(shear_modulus, r"G_s", "Pa", "> 0", "shear modulus of the grain material"),
    Quantity(relative_radius, r"R_e", "m", "> 0", "relative radius of two grains in contact"),
    Quantity(beta, r"\beta", "-", "0 to pi/2", "angle of a direction from axis 3"),
    Quantity(omega, r"\omega", "-", "-pi/2 to pi/2", "angle from the direction nearest to sliding"),
    Quantity(psi, r"\psi", "-", "0 to pi", "angle by which the Coulomb line turns Mohr's circle"),
    Quantity(circle_center, r"m", "-", "> 0", "centre of Mohr's circle of the contact forces"),
    Quantity(circle_radius, r"R", "-", ">= 0", "amplitude of normal force less shear force over friction"),
    Quantity(h0, r"h_0", "-", "any", "least value of normal force less shear force over friction"),
    Quantity(tangent, r"t", "-", "> 0", "tangent of the angle from axis 3"),
    Quantity(log_tangent, r"\sigma", "-", "any", "log-tangent: logarithm of t over its value nearest to sliding"),
    Quantity(kappa, r"\kappa", "-", ">= 0", "largest share of its friction that a contact uses up"),
    Quantity(margin, r"\bar\kappa", "-", "<= 1", "friction left where contacts are nearest to sliding, 1 - kappa"),
    Quantity(onset_strength, r"B_\pm", "-", "any", "factor of what is not smooth at the onset, one on either side"),
    Quantity(psi_s, r"\psi_s", "-", "> 0", "log-tangent at the edge of the sliding directions"),
    Quantity(q0, r"q_0", "-", ">= 0", "moment of the tangential stiffness with the fourth power of the sine"),
    Quantity(q1, r"q_1", "-", ">= 0", "moment of the tangential stiffness with squared sine and squared cosine"),
    Quantity(q2, r"q_2", "-", ">= 0", "moment of the tangential stiffness with the fourth power of the cosine"),
    Quantity(d0, r"d_0", "-", ">= 0", "normal less tangential stiffness, moment with the fourth power of the sine"),
    Quantity(d1, r"d_1", "-", ">= 0", "normal less tangential stiffness, moment with squared sine and squared cosine"),
    Quantity(u0, r"u_0", "-", "> 0", "moment of the normal flexibility with the fourth power of the sine"),
    Quantity(u1, r"u_1", "-", "> 0", "moment of the normal flexibility with squared sine and squared cosine"),
    Quantity(u2, r"u_2", "-", "> 0", "moment of the normal flexibility with the fourth power of the cosine"),
    Quantity(v0, r"v_0", "-", "> 0", "moment of the tangential flexibility with the fourth power of the sine"),
    Quantity(v1, r"v_1", "-", "> 0", "moment of the tangential flexibility with squared sine and squared cosine"),
    Quantity(v2, r"v_2", "-", "> 0", "moment of the tangential flexibility with the fourth power of the cosine"),
    Quantity(g0, r"g_0", "-", ">= 0", "tangential less normal flexibility, moment with the fourth power of the sine"),
    Quantity(g1, r"g_1", "-", ">= 0", "tangential less normal flexibility, moment with squared sine and cosine"),
    Quantity(eta, r"\eta", "-", "-1 to 1", "contrast of the roots of the normal contact force at pole and equator"),
    Quantity(r50, r"r_{50}", "m", "> 0", "size at which the density of eq. (18) is largest, its mode"),
    Quantity(median, r"\tilde r", "m", "> 0", "median of a lognormal density in its classical form"),
    Quantity(log_variance, r"L", "-", ">= 0", "variance of the logarithm of the grain size, the squared log of s_r"),
    Quantity(total_log_variance, r"L_t", "-", ">= 0", "log variance of the lognormal in place of all branch lengths"),
    Quantity(branch_log_variance, r"L_\ell", "-", ">= 0", "variance of the logarithm of the branch length, eq. (19)"),
    Quantity(mode_ratio, r"\ell_{50}/r_{50}", "-", "> 0", "modes of branch length and grain radius, eqs (19) and (18)"),
    Quantity(order, r"k", "-", "any", "order of a moment"),
    Quantity(void_ratio, r"e", "-", "> 0", "volume of voids over volume of solids"),
    Quantity(coordination, r"\bar N", "-", "> 0", "mean number of contacts of a grain"),
    Quantity(mean_cube, r"\langle r^3\rangle_p", "m^3", "> 0", "mean cube of the grain radius over the grains"),
    Quantity(kinematic_factor, r"\Gamma_{\mathrm{kin}}", "-", "> 0",
             "gradation in the kinematic stiffness by eq. (19), 1 for equal spheres"),
    Quantity(static_factor, r"\Gamma_{\mathrm{sta}}", "-", "> 0",
             "gradation in the static stiffness by eq. (19), 1 for equal spheres"),
)

LATEX = {quantity.symbol: quantity.latex for quantity in GLOSSARY}


def describe(symbol: sp.Symbol) -> Quantity:
    """Look up what a symbol stands for.

    Raises
    ------
    KeyError
        The symbol is not declared in :data:`GLOSSARY`.
    """
    for quantity in GLOSSARY:
        if quantity.symbol == symbol:
            return quantity
    raise KeyError(f"{symbol} is not declared in derivations.symbols; add it to GLOSSARY")


def latex(expression: sp.Basic) -> str:
    """Typeset an expression with the declared LaTeX of every symbol."""
    typeset = str(sp.latex(expression, symbol_names=LATEX, fold_short_frac=False))
    return re.sub(r"\\(sin|cos)(\\alpha|\\beta)\^\{(\d+)\}", r"\\\1^{\3}\2", typeset)
