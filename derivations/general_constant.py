"""Stiffness of an assembly whose fabric has no axis, for contacts of equal stiffness: isotropic tensor algebra."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from itertools import combinations_with_replacement

import sympy as sp

from derivations.harmonics import PRODUCT, N, of_direction, product_parts
from derivations.kinematic import EQUAL_TANGENTS, LAM, ONE_MINUS_LAM, closed_moments
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.sphere import monomial_mean, sphere_mean
from derivations.symbols import (
    BRANCHES_2,
    D33,
    D3333,
    FOURS,
    NORMALS_2,
    NORMALS_4,
    PAIRS,
    TENSOR_MOMENTS,
    TWENTY_ONE,
    Dr33,
    lam,
    latex,
    nu,
    one_minus_lam,
)

Powers = tuple[int, int, int]
Form = dict[Powers, sp.Expr]
"""A homogeneous polynomial in the direction: coefficient of n1^a n2^b n3^c by (a, b, c)."""

MOMENT: dict[tuple[int, ...], sp.Symbol] = dict(zip(FOURS, TENSOR_MOMENTS, strict=True))

INDICES = tuple((*first, *second) for first, second in combinations_with_replacement(PAIRS, 2))
"""Indices of the 21 components, in the order of :data:`derivations.symbols.TWENTY_ONE`."""

NORMAL_2 = dict(zip(PAIRS, NORMALS_2, strict=True)) | {(j, i): s for (i, j), s in zip(PAIRS, NORMALS_2, strict=True)}
NORMAL_4: dict[tuple[int, ...], sp.Symbol] = dict(zip(FOURS, NORMALS_4, strict=True))


def powers_of(indices: tuple[int, ...]) -> Powers:
    """How often each of the three indices occurs."""
    return indices.count(1), indices.count(2), indices.count(3)


def moment(*indices: int) -> sp.Symbol:
    """The moment of the weight with four components of the normal, whatever their order."""
    return MOMENT[tuple(sorted(indices))]


def second_moment(i: int, k: int) -> sp.Expr:
    """Mean of the weight times n_i n_k: a trace, because n has the length one."""
    return sum(moment(i, k, a, a) for a in (1, 2, 3))


def component(indices: tuple[int, int, int, int], fourth: Callable[..., sp.Expr] = moment,
              second: Callable[..., sp.Expr] = second_moment) -> sp.Expr:
    """C_ijkl over (M/V) l_e^2 k_n in the moments of E W^2 of rank four and two, minor-symmetrised."""
    i, j, k, m = indices
    shear = sum(second(p, q) for p, r, q, t in ((i, j, k, m), (j, i, k, m), (i, j, m, k), (j, i, m, k)) if r == t)
    return one_minus_lam * fourth(i, j, k, m) + lam * shear / 4


def components() -> tuple[sp.Expr, ...]:
    """All 21, in the order of :data:`derivations.symbols.TWENTY_ONE`."""
    return tuple(component(indices) for indices in INDICES)


def _multiplicity(indices: tuple[int, ...]) -> sp.Integer:
    """How many components of a symmetric tensor are the same one."""
    a, b, c = powers_of(indices)
    return sp.Integer(sp.factorial(len(indices)) / (sp.factorial(a) * sp.factorial(b) * sp.factorial(c)))


def tensor_form(symbols: tuple[sp.Symbol, ...], indices: tuple[tuple[int, ...], ...]) -> Form:
    """The polynomial T_ij.. n_i n_j .. of a symmetric tensor."""
    return {powers_of(index): _multiplicity(index) * s for s, index in zip(symbols, indices, strict=True)}


def raised(form: Form) -> Form:
    """The same on the unit sphere, two degrees higher: times n_i n_i."""
    found: Form = {}
    for (a, b, c), coefficient in form.items():
        for key in ((a + 2, b, c), (a, b + 2, c), (a, b, c + 2)):
            found[key] = found.get(key, sp.S.Zero) + coefficient
    return found


def added(one: Form, other: Form) -> Form:
    """Sum of two forms of one degree."""
    return {key: one.get(key, sp.S.Zero) + other.get(key, sp.S.Zero) for key in {**one, **other}}


def multiplied(one: Form, other: Form) -> Form:
    """Product of two forms."""
    found: Form = {}
    for (a, b, c), left in one.items():
        for (p, q, r), right in other.items():
            key = a + p, b + q, c + r
            found[key] = found.get(key, sp.S.Zero) + left * right
    return found


def mean_with(form: Form, indices: tuple[int, ...]) -> sp.Expr:
    """Mean over the sphere of a form times some components of the direction."""
    a, b, c = powers_of(indices)
    return sum(coefficient * monomial_mean(a + p, b + q, c + r) for (p, q, r), coefficient in form.items())


ONE: Form = {(0, 0, 0): sp.S.One}


def branch_form() -> Form:
    """W = 1 + Dr_ij n_i n_j as a form of degree two."""
    return added(raised(ONE), tensor_form(BRANCHES_2, PAIRS))


def density_form() -> Form:
    """4 pi E = 1 + D_ij n_i n_j + D_ijkl n_i n_j n_k n_l as a form of degree four."""
    return added(added(raised(raised(ONE)), raised(tensor_form(NORMALS_2, PAIRS))), tensor_form(NORMALS_4, FOURS))


def closed_tensor_moments(substitution: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The fifteen moments of E W^2 after a substitution into the fabric."""
    branch, density = ({key: sp.sympify(c).xreplace(dict(substitution)) for key, c in form.items()}
                       for form in (branch_form(), density_form()))
    weight = multiplied(density, multiplied(branch, branch))
    return {symbol: sp.expand(mean_with(weight, four)) for four, symbol in MOMENT.items()}


def _named(letter: str, form: Form) -> tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], Form]:
    """Give every coefficient of a form a name of its own, in a fixed order."""
    assignments, names = [], {}
    for key in sorted(form, reverse=True):
        names[key] = sp.Symbol(letter + "".join(map(str, key)), real=True)
        assignments.append((names[key], form[key]))
    return tuple(assignments), names


def moment_function() -> Function:
    """Emit the moments: the weight as a form of degree eight, then its means."""
    first, branch = _named("w", branch_form())
    second, squared = _named("v", multiplied(branch, branch))
    third, density = _named("e", density_form())
    fourth, weight = _named("o", multiplied(density, squared))
    means = []
    for four, symbol in MOMENT.items():
        numerator, denominator = sp.fraction(sp.together(mean_with(weight, four)))
        means.append((symbol, numerator / denominator))
    return Function(
        "tensor_moments", "Moments <E W^2 n_i n_j n_k n_l> of the kinematic weight.",
        (*NORMALS_2, *NORMALS_4, *BRANCHES_2), (*first, *second, *third, *fourth, *means), TENSOR_MOMENTS,
        notes="Exact for exact fractions. With a branch tensor of zero they are the moments of E.")


def stiffness_function() -> Function:
    """Emit the 21 components from the moments."""
    return Function(
        "stiffness_from_tensor_moments", "All 21 components over (M/V) l_e^2 k_n from the moments of E W^2.",
        (*TENSOR_MOMENTS, nu), ((lam, LAM), (one_minus_lam, ONE_MINUS_LAM),
                                *zip(TWENTY_ONE, components(), strict=True)), TWENTY_ONE, unit="-")


AXIAL: dict[sp.Symbol, sp.Expr] = {
    **{s: D33 * value for s, value in zip(NORMALS_2, (-sp.S.Half, -sp.S.Half, 1, 0, 0, 0), strict=True)},
    **{s: Dr33 * value for s, value in zip(BRANCHES_2, (-sp.S.Half, -sp.S.Half, 1, 0, 0, 0), strict=True)},
}
"""Tensors of rank two about axis 3."""


def axial_substitution() -> dict[sp.Symbol, sp.Expr]:
    """All tensors about axis 3, the one of rank four as the traceless part of n3^4 that is P4."""
    form = of_direction((sp.S.Zero, sp.S.Zero, sp.S.One), 4) * sp.Rational(35, 8)
    tensor = {s: D3333 * form.coeff_monomial(powers_of(four)) / _multiplicity(four)
              for four, s in zip(FOURS, NORMALS_4, strict=True)}
    return {**AXIAL, **tensor}


def _weights_step() -> Step:
    u, v = sp.symbols("a1 a3", real=True)
    generic = u, sp.S.Zero, v  # axis 3 and this direction stand for any two
    length = sum(c**2 for c in generic)
    along = sum(a * c for a, c in zip(generic, N, strict=True))
    claims = [Claim(sphere_mean(sp.expand(along**power), N), sp.expand(length ** (power // 2)) / (power + 1))
              for power in (2, 4, 6)]
    first, second, fourth = sp.symbols("w0 w2 w4", real=True)
    axis = (sp.S.Zero, sp.S.Zero, sp.S.One)
    two, four = of_direction(axis, 2).as_expr(), of_direction(axis, 4).as_expr()
    at = dict(zip(N, generic, strict=True))
    weight = first + second * two + fourth * four
    claims.append(Claim(sphere_mean(sp.expand(weight * along**4), N),
                        first * length**2 / 5 + second * sp.Rational(12, 105) * length * two.subs(at)
                        + fourth * sp.Rational(8, 315) * four.subs(at)))
    six = of_direction(axis, 6).as_expr()
    claims.append(Claim(sphere_mean(sp.expand(six * along**4), N), sp.S.Zero))
    return Step(
        "Isotropic averages",
        "The mean of an even product of components of the direction is a sum over all ways to pair its indices. "
        r"Hence only three parts of a weight enter its moments of rank four: with $w = w_0 + w_{ij}n_in_j + "
        r"w_{ijkl}n_in_jn_kn_l + \ldots$, each tensor symmetric and traceless, the parts of order six and more drop "
        "out.",
        (r"\langle n_in_j\rangle = \tfrac13\delta_{ij},\qquad "
         r"\langle n_in_jn_kn_l\rangle = \tfrac1{15}(\delta_{ij}\delta_{kl} + \delta_{ik}\delta_{jl} + "
         r"\delta_{il}\delta_{jk})",
         r"M_{ijkl} = \langle w\,n_in_jn_kn_l\rangle = \tfrac1{15}w_0\,(\delta_{ij}\delta_{kl} + "
         r"\delta_{ik}\delta_{jl} + \delta_{il}\delta_{jk}) + \tfrac2{105}(\delta_{ij}w_{kl} + \delta_{kl}w_{ij} + "
         r"\delta_{ik}w_{jl} + \delta_{jl}w_{ik} + \delta_{il}w_{jk} + \delta_{jk}w_{il}) + "
         r"\tfrac8{315}w_{ijkl}"), tuple(claims), result=True)


def _product_step() -> Step:
    return Step(
        "Products of harmonic tensors",
        r"The weight is a product of harmonics: $E W^2$ with $4\pi E = 1 + D + D^{(4)}$ and $W = 1 + D^r$. The part of "
        "one order of a product is a contraction of the two tensors, made symmetric and traceless (braces), with a "
        r"factor that depends on the orders alone. Applied twice, to $P = W^2$ and to $EP$, it gives $w_0$, $w_{ij}$ "
        "and $w_{ijkl}$.",
        (r"P_0 = 1 + \tfrac2{15}D^r_{ij}D^r_{ij},\quad P_{ij} = 2D^r_{ij} + \tfrac47\{D^r_{ia}D^r_{aj}\},\quad "
         r"P_{ijkl} = \{D^r_{ij}D^r_{kl}\}",
         r"w_0 = P_0 + \tfrac2{15}D_{ij}P_{ij} + \tfrac8{315}D_{ijkl}P_{ijkl}",
         r"w_{ij} = P_{ij} + P_0D_{ij} + \tfrac47\{D_{ia}P_{aj}\} + \tfrac4{21}(D_{ab}P_{abij} + D_{abij}P_{ab}) + "
         r"\tfrac{32}{231}\{D_{iabc}P_{abcj}\}",
         r"w_{ijkl} = P_{ijkl} + P_0D_{ijkl} + \{D_{ij}P_{kl}\} + \tfrac8{11}(\{D_{ia}P_{ajkl}\} + "
         r"\{P_{ia}D_{ajkl}\}) + \tfrac{72}{143}\{D_{ijab}P_{abkl}\}"),
        tuple(Claim(*product_parts(*orders)) for orders in PRODUCT), result=True)


def _component_step() -> Step:
    axial = closed_tensor_moments(axial_substitution())
    p = closed_moments()
    expected = {(1, 1, 1, 1): 3 * p[0] / 8, (1, 1, 2, 2): p[0] / 8, (1, 1, 3, 3): p[1] / 2, (3, 3, 3, 3): p[2],
                (2, 2, 2, 2): 3 * p[0] / 8, (2, 2, 3, 3): p[1] / 2}
    compression = sum(component((i, i, k, k)) for i in (1, 2, 3) for k in (1, 2, 3)).subs(one_minus_lam, 1 - lam)
    return Step(
        "Twenty-one components in fifteen moments",
        r"With $k_r = \lambda k_n$ in all directions the sum over the contacts needs $M_{ijkl}$ and its trace alone. "
        "Compression from all sides shears no contact, and about an axis the moments are those of the axial form.",
        (r"\frac{C_{ijkl}}{(M/V)\,\ell_e^2k_n} = \bar\lambda M_{ijkl} + \tfrac14\lambda(\delta_{jl}M_{ikaa} + "
         r"\delta_{il}M_{jkaa} + \delta_{jk}M_{ilaa} + \delta_{ik}M_{jlaa})",
         r"C_{iikk} = (M/V)\,\ell_e^2k_n\,\langle w\rangle"),
        (Claim(sp.expand(compression), sum(second_moment(i, i) for i in (1, 2, 3))),
         *(Claim(axial[MOMENT[four]], expected.get(four, sp.S.Zero)) for four in FOURS)), result=True)


def plain_moment(i: int, j: int, k: int, m: int) -> sp.Expr:
    """Mean of E n_i n_j n_k n_l by pairs of indices."""
    pairs = (((i, j), (k, m)), ((i, k), (j, m)), ((i, m), (j, k)))
    isotropic = sum(sp.Rational(int(a == b) * int(c == d), 15) for (a, b), (c, d) in pairs)
    rank2 = sum(int(a == b) * NORMAL_2[c, d] + int(c == d) * NORMAL_2[a, b] for (a, b), (c, d) in pairs)
    rank4 = NORMAL_4[tuple(sorted((i, j, k, m)))]
    return isotropic + sp.Rational(2, 105) * rank2 + sp.Rational(8, 315) * rank4


def fabric_tensor(i: int, k: int) -> sp.Expr:
    """N_ik, the mean of E n_i n_k."""
    return sp.Rational(int(i == k), 3) + sp.Rational(2, 15) * NORMAL_2[i, k]


def _rank_two_step() -> Step:
    """Without branches the moments are linear in the fabric: all 21 components in full."""
    closed = closed_tensor_moments(dict.fromkeys(BRANCHES_2, sp.S.Zero) | _traceless())
    fourth = (Claim(closed[symbol], sp.expand(plain_moment(*four).xreplace(_traceless())))
              for four, symbol in MOMENT.items())
    second = (Claim(second_moment(i, k).xreplace(closed), fabric_tensor(i, k).xreplace(_traceless()))
              for i, k in PAIRS)
    shown = (sp.collect(sp.expand(component(four, plain_moment, fabric_tensor)), (lam, one_minus_lam))
             for four in INDICES)
    return Step(
        "Branches of one length",
        r"Without a branch tensor the weight is the density itself: $w_0 = 1$, $w_{ij} = D_{ij}$, "
        r"$w_{ijkl} = D_{ijkl}$ and $M_{ikaa} = N_{ik} = \tfrac13\delta_{ik} + \tfrac2{15}D_{ik}$. The "
        r"components, over $(M/V)\,\ell_e^2k_n$, are linear in the fabric.",
        tuple(f"{latex(c)} = {latex(value)}" for c, value in zip(TWENTY_ONE, shown, strict=True)),
        (*fourth, *second), result=True)


@cache
def _traceless() -> dict[sp.Symbol, sp.Expr]:
    """The last of each three traces by the other two."""
    rank2 = {NORMALS_2[2]: -NORMALS_2[0] - NORMALS_2[1]}
    rank4: dict[sp.Symbol, sp.Expr] = {}
    for pair in ((1, 1), (1, 2), (2, 2), (1, 3), (2, 3), (3, 3)):
        key = tuple(sorted((*pair, 3, 3)))
        total = sp.Add(*(NORMAL_4[tuple(sorted((*pair, a, a)))] for a in (1, 2)))
        rank4[NORMAL_4[key]] = sp.expand((-total).xreplace(rank4))
    return {**rank2, **rank4}


ASSUMPTIONS = (
    "Every contact displaces with the mean strain (kinematic hypothesis): an upper bound.",
    "Branch vectors are parallel to contact normals.",
    "All contacts have the same stiffness.",
    EQUAL_TANGENTS,
    "The density is even in n and of rank four at most; the branch length is of rank two.",
)


@cache
def general_constant() -> Derivation:
    """Derive the stiffness for any traceless D_ij, D_ijkl and Dr_ij."""
    ratios = {lam: LAM, one_minus_lam: ONE_MINUS_LAM}
    return Derivation(
        name="general_constant",
        title="Stiffness of a fabric without an axis, constant contact stiffness",
        sources=("(2)", "(4)", "(6)", "(7)", "(14)"),
        assumptions=ASSUMPTIONS,
        domain=("E nowhere negative", "1 + Dr_ij n_i n_j > 0", "tensors symmetric and traceless", "0 <= nu <= 1/2"),
        inputs=(*NORMALS_2, *NORMALS_4, *BRANCHES_2, *TENSOR_MOMENTS, nu),
        outputs=tuple(Output(c, e.xreplace(ratios)) for c, e in zip(TWENTY_ONE, components(), strict=True)),
        steps=(_weights_step(), _product_step(), _component_step(), _rank_two_step()),
        functions=(moment_function(), stiffness_function()),
    )
