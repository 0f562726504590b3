"""Fabric tensors of the first, second and third kind, rank two and four, for a fabric without any symmetry."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import combinations_with_replacement

import sympy as sp

from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.sphere import sphere_mean
from derivations.symbols import D33, D3333, FIRST_KIND, latex

N = sp.symbols("n1:4", real=True)
"""Components of a direction."""

Index = tuple[int, ...]
Tensor = Callable[..., sp.Expr]

PAIRS: tuple[Index, ...] = tuple(combinations_with_replacement((1, 2, 3), 2))
QUADRUPLES: tuple[Index, ...] = tuple(combinations_with_replacement((1, 2, 3), 4))
"""Indices of the different components of a symmetric tensor of rank two and four."""


def _symbols(letter: str, indices: tuple[Index, ...]) -> dict[Index, sp.Symbol]:
    return {index: sp.Symbol(letter + "".join(map(str, index)), real=True) for index in indices}


FIRST = dict(zip(QUADRUPLES, FIRST_KIND, strict=True))
FIRST_2, SECOND_2, THIRD_2 = (_symbols(letter, PAIRS) for letter in ("N", "F", "D"))
SECOND, THIRD = (_symbols(letter, QUADRUPLES) for letter in ("F", "D"))
"""Components of each kind as symbols."""


def delta(i: int, j: int) -> sp.Integer:
    """Kronecker's delta."""
    return sp.Integer(i == j)


def delta_times(second: Tensor) -> Tensor:
    """Symmetric part of delta_ij A_kl: the mean over its six different permutations."""
    def component(i: int, j: int, k: int, m: int) -> sp.Expr:
        pairs = (((i, j), (k, m)), ((k, m), (i, j)), ((i, k), (j, m)), ((j, m), (i, k)), ((i, m), (j, k)),
                 ((j, k), (i, m)))
        return sp.expand(sum(delta(*one) * second(*other) for one, other in pairs) / 6)
    return component


DELTAS = delta_times(delta)
"""Symmetric part of delta_ij delta_kl."""


def looked_up(table: dict[Index, sp.Expr]) -> Tensor:
    """Make a symmetric tensor of the table of its different components."""
    return lambda *index: table[tuple(sorted(index))]


def first_kind_2(third_2: Tensor) -> Tensor:
    """N_ij of D_ij."""
    return lambda i, j: delta(i, j) / sp.Integer(3) + sp.Rational(2, 15) * third_2(i, j)


def first_kind_4(third_2: Tensor, third_4: Tensor) -> Tensor:
    """N_ijkl of D_ij and D_ijkl."""
    product = delta_times(third_2)
    return lambda *i: (DELTAS(*i) / 5 + sp.Rational(4, 35) * product(*i) + sp.Rational(8, 315) * third_4(*i))


def third_kind_2(first_2: Tensor) -> Tensor:
    """D_ij of N_ij."""
    return lambda i, j: sp.Rational(15, 2) * first_2(i, j) - sp.Rational(5, 2) * delta(i, j)


def third_kind_4(first_2: Tensor, first_4: Tensor) -> Tensor:
    """D_ijkl of N_ij and N_ijkl."""
    product = delta_times(first_2)
    return lambda *i: sp.Rational(315, 8) * first_4(*i) - sp.Rational(135, 4) * product(*i) + sp.Rational(
        27, 8) * DELTAS(*i)


def second_kind_2(first_2: Tensor) -> Tensor:
    """F_ij of N_ij."""
    return lambda i, j: sp.Rational(15, 2) * first_2(i, j) - sp.Rational(3, 2) * delta(i, j)


def second_kind_4(first_2: Tensor, first_4: Tensor) -> Tensor:
    """F_ijkl of N_ij and N_ijkl."""
    product = delta_times(first_2)
    return lambda *i: sp.Rational(315, 8) * first_4(*i) - sp.Rational(105, 4) * product(*i) + sp.Rational(
        15, 8) * DELTAS(*i)


@cache
def general_third() -> tuple[Tensor, Tensor]:
    """D_ij and D_ijkl without any symmetry: traceless, five and nine coefficients."""
    second = {**THIRD_2, (3, 3): -THIRD_2[1, 1] - THIRD_2[2, 2]}
    traces = [sum(THIRD[tuple(sorted((i, j, k, k)))] for k in (1, 2, 3)) for i, j in PAIRS]
    kept = sp.solve(traces, [THIRD[tuple(sorted((i, j, 3, 3)))] for i, j in PAIRS], dict=True)[0]
    return looked_up(second), looked_up({index: symbol.subs(kept) for index, symbol in THIRD.items()})


def form(tensor: Tensor, indices: tuple[Index, ...]) -> sp.Expr:
    """Contraction of a symmetric tensor with n in every index."""
    return sp.expand(sum(_times(index) * tensor(*index) * _monomial(index) for index in indices))


def _times(index: Index) -> sp.Integer:
    """How many components of the full tensor are the same one."""
    return sp.factorial(len(index)) / sp.prod(sp.factorial(index.count(axis)) for axis in (1, 2, 3))


def _monomial(index: Index) -> sp.Expr:
    return sp.prod(N[axis - 1] for axis in index)


@cache
def density() -> sp.Expr:
    """4 pi E of a fabric of rank two and four without any symmetry."""
    second, fourth = general_third()
    return 1 + form(second, PAIRS) + form(fourth, QUADRUPLES)


@cache
def moments(indices: tuple[Index, ...]) -> dict[Index, sp.Expr]:
    """Mean of n_i n_j ... over the contacts of that fabric, by averaging over the whole sphere."""
    return {index: sphere_mean(_monomial(index) * density(), N) for index in indices}


def same(left: Tensor, right: Tensor, indices: tuple[Index, ...]) -> Claim:
    """Two symmetric tensors agree: an arbitrary combination of their components does."""
    weights = sp.symbols(f"c1:{len(indices) + 1}")
    return Claim(sum(w * left(*i) for w, i in zip(weights, indices, strict=True)),
                 sum(w * right(*i) for w, i in zip(weights, indices, strict=True)))


def trace(tensor: Tensor) -> Tensor:
    """Contract the last two indices."""
    return lambda *i: sp.expand(sum(tensor(*i, k, k) for k in (1, 2, 3)))


def axial_third() -> tuple[Tensor, Tensor]:
    """D_ij and D_ijkl of the density 1 + D33 P2 + D3333 P4 about axis 3."""
    across = sp.Rational(3, 8) * D3333
    table = {index: sp.Integer(0) for index in QUADRUPLES}
    table |= {(1, 1, 1, 1): across, (2, 2, 2, 2): across, (1, 1, 2, 2): D3333 / 8, (1, 1, 3, 3): -D3333 / 2,
              (2, 2, 3, 3): -D3333 / 2, (3, 3, 3, 3): D3333}
    second = {index: sp.Integer(0) for index in PAIRS}
    return looked_up(second | {(1, 1): -D33 / 2, (2, 2): -D33 / 2, (3, 3): D33}), looked_up(table)


def _first_step() -> Step:
    second, fourth = general_third()
    return Step(
        "First kind: means of products",
        r"A density that is even and of rank four at most has five coefficients $D_{ij}$ and nine $D_{ijkl}$, both "
        "symmetric and traceless. Averages of products of the components of $n$ follow from monomial moments over the "
        "sphere.",
        (r"4\pi E = 1 + D_{ij}n_in_j + D_{ijkl}n_in_jn_kn_l",
         r"N_{ij} = \langle n_in_j\rangle = \tfrac13\delta_{ij} + \tfrac{2}{15}D_{ij}",
         r"N_{ijkl} = \langle n_in_jn_kn_l\rangle = \tfrac15\delta_{(ij}\delta_{kl)} + "
         r"\tfrac{4}{35}\delta_{(ij}D_{kl)} + \tfrac{8}{315}D_{ijkl}"),
        (same(looked_up(moments(PAIRS)), first_kind_2(second), PAIRS),
         same(looked_up(moments(QUADRUPLES)), first_kind_4(second, fourth), QUADRUPLES),
         same(trace(looked_up(moments(QUADRUPLES))), looked_up(moments(PAIRS)), PAIRS)), result=True)


def _third_step() -> Step:
    second, fourth = general_third()
    first_2, first_4 = looked_up(moments(PAIRS)), looked_up(moments(QUADRUPLES))
    return Step(
        "Third kind: the parts that vary",
        "Solved for the coefficients. Each rank of the third kind is free of traces, so that one rank can be read "
        "without the other, and adding a rank leaves the ones below as they are.",
        (r"D_{ij} = \tfrac{15}{2}\left(N_{ij} - \tfrac13\delta_{ij}\right)",
         r"D_{ijkl} = \tfrac{315}{8}\left(N_{ijkl} - \tfrac67\delta_{(ij}N_{kl)} + "
         r"\tfrac{3}{35}\delta_{(ij}\delta_{kl)}\right)", r"D_{ii} = 0,\qquad D_{iikl} = 0"),
        (same(third_kind_2(first_2), second, PAIRS), same(third_kind_4(first_2, first_4), fourth, QUADRUPLES),
         Claim(sum(second(k, k) for k in (1, 2, 3)), sp.Integer(0)),
         same(trace(fourth), lambda *_: sp.Integer(0), PAIRS)), result=True)


def _second_step() -> Step:
    second, fourth = general_third()
    first_2, first_4 = looked_up(moments(PAIRS)), looked_up(moments(QUADRUPLES))
    f2, f4 = second_kind_2(first_2), second_kind_4(first_2, first_4)
    left_2 = {index: sphere_mean(_monomial(index) * form(f2, PAIRS), N) for index in PAIRS}
    left_4 = {index: sphere_mean(_monomial(index) * form(f4, QUADRUPLES), N) for index in QUADRUPLES}
    on_sphere = {N[2] ** 2: 1 - N[0] ** 2 - N[1] ** 2, N[2] ** 4: (1 - N[0] ** 2 - N[1] ** 2) ** 2,
                 N[2] ** 3: N[2] * (1 - N[0] ** 2 - N[1] ** 2)}
    whole = sp.expand(sp.expand(form(f4, QUADRUPLES) - density()).subs(on_sphere))
    product = delta_times(second)
    return Step(
        "Second kind: the density in one tensor",
        "The homogeneous form of one rank that is nearest to the density in the mean square. Nearest means that what "
        "is left has no moment of that rank. On the sphere it is the same function as the sum of the third kind up to "
        "that rank.",
        (r"F_{ij} = \tfrac{15}{2}\left(N_{ij} - \tfrac15\delta_{ij}\right) = \delta_{ij} + D_{ij}",
         r"F_{ijkl} = \tfrac{315}{8}\left(N_{ijkl} - \tfrac23\delta_{(ij}N_{kl)} + "
         r"\tfrac{1}{21}\delta_{(ij}\delta_{kl)}\right) = \delta_{(ij}\delta_{kl)} + \delta_{(ij}D_{kl)} + D_{ijkl}",
         r"F_{ii} = 3,\qquad F_{iikl} = \tfrac53\delta_{kl} + \tfrac76D_{kl}"),
        (same(looked_up(left_2), first_2, PAIRS), same(looked_up(left_4), first_4, QUADRUPLES),
         same(f2, lambda i, j: delta(i, j) + second(i, j), PAIRS),
         same(f4, lambda *i: DELTAS(*i) + product(*i) + fourth(*i), QUADRUPLES),
         Claim(sp.expand(whole.subs(on_sphere)), sp.Integer(0)),
         same(trace(f4), lambda k, m: sp.Rational(5, 3) * delta(k, m) + sp.Rational(7, 6) * second(k, m), PAIRS)),
        result=True)


def _axial_step() -> Step:
    second, fourth = axial_third()
    legendre = 1 + D33 * sp.legendre(2, N[2]) + D3333 * sp.legendre(4, N[2])
    across = {N[0]: sp.sqrt(1 - N[2] ** 2), N[1]: 0}
    n4 = first_kind_4(second, fourth)
    return Step(
        "Axial fabric",
        "About axis 3 one number of each rank is left. It is the component along the axis, and the coefficient of a "
        "Legendre polynomial. The rank-two number alone decides $N_{33}$; both enter $N_{3333}$.",
        (r"D_{11} = D_{22} = -\tfrac12D_{33},\qquad D_{1111} = 3D_{1122} = \tfrac38D_{3333},\qquad "
         r"D_{1133} = -\tfrac12D_{3333}",
         r"1 + D_{ij}n_in_j + D_{ijkl}n_in_jn_kn_l = 1 + D_{33}P_2(x) + D_{3333}P_4(x)",
         rf"N_{{3333}} = {latex(sp.expand(n4(3, 3, 3, 3)))}"),
        (Claim(sp.expand((1 + form(second, PAIRS) + form(fourth, QUADRUPLES)).subs(across)), sp.expand(legendre)),
         Claim(sum(second(k, k) for k in (1, 2, 3)), sp.Integer(0)),
         same(trace(fourth), lambda *_: sp.Integer(0), PAIRS),
         Claim(sphere_mean(N[2] ** 4 * legendre, N), n4(3, 3, 3, 3))), result=True)


def _spread_step() -> Step:
    second, fourth = general_third()
    two, four = form(second, PAIRS), form(fourth, QUADRUPLES)
    squares_2 = sum(_times(i) * second(*i) ** 2 for i in PAIRS)
    squares_4 = sum(_times(i) * fourth(*i) ** 2 for i in QUADRUPLES)
    return Step(
        "How much a sample of an isotropic fabric scatters",
        "The parts of different rank are orthogonal over the sphere, and the mean square of each is a multiple of the "
        "squared tensor. This is the information that one direction carries about $D$ where the density is uniform. "
        "For $n$ independent directions the score test of a uniform density is therefore $n$ times the mean square of "
        "the fitted part, with as many degrees of freedom as coefficients: 5 and 9.",
        (r"\langle(D_{ij}n_in_j)^2\rangle = \tfrac{2}{15}D_{ij}D_{ij},\qquad "
         r"\langle(D_{ijkl}n_in_jn_kn_l)^2\rangle = \tfrac{8}{315}D_{ijkl}D_{ijkl}",
         r"\chi^2_5 = \tfrac{2}{15}\,n\,D_{ij}D_{ij},\qquad \chi^2_9 = \tfrac{8}{315}\,n\,D_{ijkl}D_{ijkl}"),
        (Claim(sphere_mean(two**2, N), sp.Rational(2, 15) * sp.expand(squares_2)),
         Claim(sphere_mean(sp.expand(four**2), N), sp.Rational(8, 315) * sp.expand(squares_4)),
         Claim(sphere_mean(sp.expand(two * four), N), sp.Integer(0)),
         Claim(sphere_mean(two, N), sp.Integer(0)), Claim(sphere_mean(four, N), sp.Integer(0))), result=True)


def _lower_rank() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    contracted = trace(looked_up(FIRST))
    return tuple((FIRST_2[index], contracted(*index)) for index in PAIRS)


def _assigned(second: Tensor, fourth: Tensor, names_2: dict[Index, sp.Symbol],
              names_4: dict[Index, sp.Symbol]) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    return (*((names_2[i], _one_quotient(second(*i))) for i in PAIRS),
            *((names_4[i], _one_quotient(fourth(*i))) for i in QUADRUPLES))


def _one_quotient(expression: sp.Expr) -> sp.Expr:
    """Whole numbers over one denominator: nothing is rounded before the division."""
    numerator, denominator = sp.expand(expression).as_numer_denom()
    return sp.Mul(sp.Rational(1, denominator), sp.expand(numerator), evaluate=False)


def functions() -> tuple[Function, ...]:
    """Third and second kind of the moments of rank four, and the moments of the third kind."""
    n2, n4 = looked_up(FIRST_2), looked_up(FIRST)
    thirds = (*THIRD_2.values(), *THIRD.values())
    d2, d4 = looked_up(THIRD_2), looked_up(THIRD)
    given = tuple(symbol for symbol in thirds if symbol != D33)
    back = first_kind_4(d2, d4)
    return (
        Function("third_kind", "D_ij and D_ijkl from the moments of rank four.", FIRST_KIND,
                 (*_lower_rank(), *_assigned(third_kind_2(n2), third_kind_4(n2, n4), THIRD_2, THIRD)), thirds),
        Function("second_kind", "F_ij and F_ijkl from the moments of rank four.", FIRST_KIND,
                 (*_lower_rank(), *_assigned(second_kind_2(n2), second_kind_4(n2, n4), SECOND_2, SECOND)),
                 (*SECOND_2.values(), *SECOND.values())),
        Function("first_kind", "Moments of rank four from D_ij, whose trace is zero, and D_ijkl.", given,
                 ((D33, -THIRD_2[1, 1] - THIRD_2[2, 2]),
                  *((FIRST[i], _one_quotient(back(*i))) for i in QUADRUPLES)), FIRST_KIND),
    )


@cache
def fabric_kinds() -> Derivation:
    """Derive the three kinds from one another, what axial fabrics are in them, and how samples scatter."""
    third, second, _ = functions()
    return Derivation(
        name="fabric_kinds",
        title="Fabric tensors of three kinds",
        sources=("N_ij below (23)", "(14)"),
        assumptions=("The density is even in n: a contact has two normals, n and -n.",
                     "Directions of different contacts are independent, in the test of a uniform density only."),
        domain=("N_ii = 1", "density of rank four at most, or its part of rank four at most"),
        inputs=FIRST_KIND,
        outputs=tuple(Output(symbol, expression) for function in (third, second)
                      for symbol, expression in function.substituted().items()),
        steps=(_first_step(), _third_step(), _second_step(), _axial_step(), _spread_step()),
        functions=functions(),
    )
