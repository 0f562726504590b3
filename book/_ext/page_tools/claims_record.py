"""The record behind the page of claims: every conclusion of the paper that its own model can test, and its verdict."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise

from page_tools.markup import Markup, boxed, table
from page_tools.paper import RATIOS, typeset
from page_tools.paper_tables import Printed, printed_ratios

AXIAL, SHEAR = (name for name, _ in RATIOS)


class Ruling(Enum):
    """What becomes of a claim."""

    HOLDS = "holds"
    MORE = "more than that holds"
    PART = "holds for some assemblies"
    FAILS = "does not follow"


@dataclass(frozen=True, slots=True)
class Claim:
    """One conclusion: its place in the ledger, what is printed, the ruling, what follows, and its section."""

    place: str
    says: str
    ruling: Ruling
    follows: str
    label: str


CLAIMS = (
    Claim("text, curves 1–3", "the stiffness does not depend on the mean grain size",
          Ruling.HOLDS, "exactly", "sec-mean-size"),
    Claim("text, curves 4–6", "the stiffness does not depend on the uniformity",
          Ruling.FAILS, "equation (17) makes it depend", "sec-uniformity"),
    Claim("text, stiffness", "the isotropic assemblies have 5465, 2665 and 134 MPa",
          Ruling.FAILS, "about a tenth of that", "sec-printed-stiffness"),
    Claim("text on $r_{pqik}$", "branches along the contact normals are adequate at small strain",
          Ruling.FAILS, "not for the stiffness", "sec-collinear"),
    Claim("Figure 7", "$k_n$ is hardly influenced by $D^r_{33}$",
          Ruling.MORE, "not at all", "sec-other-claims"),
    Claim("text below Table II", "shear waves are fastest along the horizontal",
          Ruling.PART, "depends on the fabric", "sec-other-claims"),
    Claim("(22)", "an exact distribution of the contact forces is hardly possible",
          Ruling.HOLDS, "for the estimated one the stiffness has a closed form", "sec-other-claims"),
    Claim("Table II", "an isotropic packing under isotropic stress can be anisotropic, by its branches",
          Ruling.HOLDS, "by the exact ratios as well", "sec-claims-that-hold"),
    Claim("Table II", "with more vertical contacts the horizontal can still be stiffer",
          Ruling.HOLDS, "by the exact ratios as well", "sec-claims-that-hold"),
    Claim("Table III", "contact forces make the anisotropy slightly higher",
          Ruling.HOLDS, "in both ratios", "sec-claims-that-hold"),
    Claim("Table III", "slip influences the anisotropy",
          Ruling.HOLDS, "one ratio up, the other down", "sec-claims-that-hold"),
    Claim("Table IV", "the anisotropy grows with $D_{33}$",
          Ruling.HOLDS, "in both ratios", "sec-claims-that-hold"),
    Claim("Table V", "the anisotropy grows with the stress ratio",
          Ruling.HOLDS, "in both ratios", "sec-claims-that-hold"),
)


def counted() -> Markup:
    """Box how many claims have which ruling."""
    counts = Counter(claim.ruling for claim in CLAIMS)
    return boxed("What becomes of the claims", Markup(
        f"Of {len(CLAIMS)} conclusions that the paper draws and its own model can test, {counts[Ruling.HOLDS]} hold "
        f"and {counts[Ruling.FAILS]} do not follow from the equations. In between, more holds than is printed for "
        f"{counts[Ruling.MORE]}, and {counts[Ruling.PART]} holds for some assemblies and not for others."))


def summary() -> Markup:
    """Every claim with its ruling, linked to the section that shows it."""
    rows = [[claim.says, claim.place, f"{{ref}}`{claim.ruling.value} <{claim.label}>`", claim.follows]
            for claim in CLAIMS]
    return table(["the paper says", "where", "verdict", "what follows"], rows, label="tab-claims", align="llll",
                 look="words-first errata", take_away="claims.csv",
                 taken=[["claim", "where", "verdict", "what follows"],
                        *([claim.says, claim.place, claim.ruling.value, claim.follows] for claim in CLAIMS)],
                 caption="Conclusions of the paper, and what its equations make of them.")


def holding() -> Markup:
    """Compute what the claims on Tables II to V say; one that fails stops the build."""
    first, third = (_exact("II", AXIAL)[place] for place in (0, 2))
    axial, shear = _exact("III", AXIAL), _exact("III", SHEAR)
    rows = [
        ("an isotropic packing can be anisotropic by its branches", first > 1,
         f"{typeset(AXIAL)} = {first:.4f} in case 1 of [Table II](table_ii.md)"),
        ("with more vertical contacts the horizontal can still be stiffer", third > 1,
         f"{typeset(AXIAL)} = {third:.4f} in case 3"),
        ("contact forces make the anisotropy slightly higher", _farther(axial[:2]) and _farther(shear[:2]),
         f"{typeset(AXIAL)} from {axial[0]:.4f} to {axial[1]:.4f}, {typeset(SHEAR)} from {shear[0]:.4f} to "
         f"{shear[1]:.4f} in [Table III](table_iii.md)"),
        ("slip influences the anisotropy", axial[2] != axial[1] and shear[2] != shear[1],
         f"on to {axial[2]:.4f} and {shear[2]:.4f}: the one farther from 1, the other nearer"),
        *((f"the anisotropy grows with {what}", _farther(_exact(name, AXIAL)) and _farther(_exact(name, SHEAR)),
           f"{typeset(AXIAL)} = {_listed(_exact(name, AXIAL))} and {typeset(SHEAR)} = {_listed(_exact(name, SHEAR))} "
           f"in [Table {name}](table_{name.lower()}.md)")
          for what, name in (("$D_{33}$", "IV"), ("the stress ratio", "V")))]
    failed = [says for says, holds, _ in rows if not holds]
    assert not failed, f"these claims no longer hold: {failed}"
    return table(["claim", "exact ratios"], [[says, found] for says, _, found in rows], label="tab-claims-that-hold",
                 align="ll", look="words-first", take_away="claims_that_hold.csv",
                 caption="Claims on Tables II to V, by the exact ratios.")


def _exact(name: str, ratio: str) -> list[float]:
    """One ratio of every case of a table."""
    found: tuple[Printed, ...] = printed_ratios(name)
    return [one.exact for one in found if one.name == ratio]


def _farther(values: list[float]) -> bool:
    """Whether each value is farther from 1 than the one before."""
    away = [abs(value - 1) for value in values]
    return all(one < other for one, other in pairwise(away))


def _listed(values: list[float]) -> str:
    return ", ".join(f"{value:.4f}" for value in values)
