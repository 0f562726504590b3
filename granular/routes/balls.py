"""What the certified routines share: exact weights of a fabric, and the step from fractions to balls and back."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from granular.errors import CertifiedArithmeticMissing
from granular.fabric import AxialFabric


def arithmetic() -> Any:
    """Load python-flint.

    Returns
    -------
    module
        ``flint``.

    Raises
    ------
    CertifiedArithmeticMissing
        It is not installed.
    """
    try:
        import flint
    except ImportError as error:
        raise CertifiedArithmeticMissing(
            "python-flint is not installed", allowed="ball arithmetic needs it",
            remedy="Install it with: pip install 'granular[certified]'.") from error
    return flint


def ball(flint: Any, value: Fraction | int) -> Any:
    """Enclose a fraction at the working precision; zero stays exactly zero."""
    exact = Fraction(value)
    return flint.arb(flint.fmpq(exact.numerator, exact.denominator))


def fraction(end_point: Any) -> Fraction:
    """Turn the end point of a ball, a dyadic number, into a fraction."""
    mantissa, exponent = (int(part) for part in end_point.man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent


def exact_weights(fabric: AxialFabric) -> tuple[tuple[Fraction, Fraction, Fraction], Fraction, Fraction]:
    """4 pi E = sum_j e_j s^(2-j) x^(2j) and W = w0 s + w1 x^2 with s = 1 - x^2, exactly."""
    d33, d3333, dr33 = Fraction(fabric.D33), Fraction(fabric.D3333), Fraction(fabric.Dr33)
    density = (1 - d33 / 2 + 3 * d3333 / 8, 2 + d33 / 2 - 3 * d3333, 1 + d33 + d3333)
    return density, 1 - dr33 / 2, 1 + dr33


def normal_tensor(flint: Any, fabric: AxialFabric) -> tuple[Any, Any]:
    """N11 and N33 of the mean of n_i n_k over the contacts, exactly up to the conversion."""
    d33 = Fraction(fabric.D33)
    return ball(flint, Fraction(1, 3) - d33 / 15), ball(flint, Fraction(1, 3) + 2 * d33 / 15)


def inverse_moment(flint: Any, form: tuple[Fraction, Fraction], power: Fraction, of_s: int, of_y: int) -> Any:
    """Enclose <s^i x^(2j) (w0 s + w1 x^2)^-p>, with the larger coefficient taken out of the form.

    The argument of the hypergeometric function then lies in [0, 1).

    Parameters
    ----------
    flint : module
        python-flint, its working precision set.
    form : tuple of 2 Fraction
        w0 and w1 [-], > 0.
    power : Fraction
        p [-], > 0.
    of_s, of_y : int
        i and j [-], >= 0.

    Returns
    -------
    arb
        The integral over x from 0 to 1 [-].

    Notes
    -----
    Accuracy: an enclosure. Source: Euler's integral for the hypergeometric function.
    """
    w0, w1 = form
    upper = ball(flint, Fraction(2 * (of_s + of_y) + 3, 2))
    if w0 >= w1:
        argument, other = (w0 - w1) / w0, Fraction(2 * of_y + 1, 2)
    else:
        argument, other = (w1 - w0) / w1, Fraction(of_s + 1)
    series = ball(flint, argument).hypgeom_2f1(ball(flint, power), ball(flint, other), upper)
    return ball(flint, half_beta(of_s, of_y)) * ball(flint, max(w0, w1)) ** ball(flint, -power) * series


def half_beta(power_of_s: int, power_of_square: int) -> Fraction:
    """Int_0^1 s^a x^(2b) dx = B(b + 1/2, a + 1)/2, a rational number."""
    value = Fraction(1, 2 * power_of_square + 1)
    for j in range(1, power_of_s + 1):
        value *= Fraction(2 * j, 2 * power_of_square + 1 + 2 * j)
    return value


def magnitude(value: Fraction) -> int:
    """Number of bits by which a positive fraction is far from 1."""
    return abs(value.numerator.bit_length() - value.denominator.bit_length())


def stiffness_from_compliance(flint: Any, fabric_tensor: tuple[Any, Any], normal_less_shear: Sequence[Any],
                              shear: Sequence[Any]) -> tuple[Any, ...]:
    """Six static components from moments of the contact compliances.

    Parameters
    ----------
    flint : module
        python-flint, its working precision set.
    fabric_tensor : tuple of 2 arb
        Its components across and along axis 3, N11 and N33 [-].
    normal_less_shear, shear : sequence of 3 arb
        Moments <E W^-2 f s^(2-i) x^(2i)>, i = 0, 1, 2, of f = 1/k_n - 1/k_r and of f = 1/k_r [-].

    Returns
    -------
    tuple of arb, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Notes
    -----
    Accuracy: enclosures. Source: eq. (23) with s_jl = n_j n_l/k_n + (delta_jl - n_j n_l)/k_r, minor-symmetrised, then
    inverted by Cramer's rule, in the form in which C1122 is exactly zero where S1122 and S1133 are.
    """
    a1, a3 = 1 / fabric_tensor[0], 1 / fabric_tensor[1]
    n4, n2x2, x4 = normal_less_shear
    n2, x2 = shear[0] + shear[1], shear[1] + shear[2]
    s1111 = a1**2 * (3 * n4 / 8 + n2 / 2)
    s3333 = a3**2 * (x4 + x2)
    s1122 = a1**2 * n4 / 8
    s1133 = a1 * a3 * n2x2 / 2
    s2323 = (a1**2 * (n2x2 / 2 + n2 / 2) + 2 * a1 * a3 * n2x2 / 2 + a3**2 * (n2x2 / 2 + x2)) / 4
    s1212 = (s1111 - s1122) / 2
    apart, together = s1111 - s1122, (s1111 + s1122) * s3333 - 2 * s1133**2
    return ((s1111 * s3333 - s1133**2) / (apart * together), (s1111 + s1122) / together,
            (s1133**2 - s1122 * s3333) / (apart * together), -s1133 / together, 1 / (4 * s2323), 1 / (4 * s1212))
