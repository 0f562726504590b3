"""Each slip of the print has its section, its proof and its consequence; a proof that fails stops the page."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from page_tools import errata, errata_gradation, errata_kinetic, errata_record
from page_tools.errata_record import SLIPS, proved, stated, summary
from page_tools.markup import Markup

PROOFS: dict[str, tuple[Callable[[], Markup], ...]] = {
    "hypotheses": (lambda: errata.bounds_check("_data/table_ii.csv"),),
    "limits": (errata_gradation.limits_check,),
    "mode": (lambda: errata_gradation.centre_table("_data/table_i.csv"),),
    "lognormal": (lambda: errata_gradation.neglected_check("_data/table_i.csv"),),
    "shear-stiffness": (errata_kinetic.printed_slip_table,),
    "fabric-tensor": (errata.fabric_tensor_check, errata_kinetic.printed_tensor_table),
    "grain-modulus": (errata.grain_modulus_check,),
    "isotropic": (lambda: errata.isotropic_moduli_check("_data/isotropic_28kpa.csv"),),
    "uniformity": (lambda: errata_gradation.uniformity_check("_data/table_i.csv"),),
    "shear": (lambda: errata.shear_order_check("_data/table_ii.csv"),),
    "caption": (errata_kinetic.caption_table,),
    "two-values": (errata_kinetic.table_iv_misprints,),
    "normal-stiffness": (errata_kinetic.normal_stiffness_check,),
    "decimals": (errata_kinetic.decimals_check,),
    "invariant": (errata.level_check,),
    "appendix": (errata.two_estimates_check,)}
"""What the page computes in each section."""


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def sections(book: Path) -> dict[str, tuple[str, str]]:
    """Heading and text of each section with a label of an erratum, in the order of the page."""
    text = (book / "errata.md").read_text(encoding="utf-8")
    parts = re.split(r"^\((sec-erratum-[a-z-]+)\)=\n## (.+)\n", text, flags=re.MULTILINE)
    return dict(zip(parts[1::3], zip(parts[2::3], parts[3::3], strict=True), strict=True))


@pytest.mark.parametrize("key", [slip.key for slip in SLIPS])
def test_every_proof_holds(key: str) -> None:
    """Breaks when what the page gives as a proof no longer proves the slip; the check raises then."""
    assert all("✓ **Checked**" in proof().text for proof in PROOFS[key])


def test_every_slip_has_its_section_and_its_proof(book: Path) -> None:
    """Breaks when a slip is recorded and not shown, shown under another name, or shown without its proof."""
    found = sections(book)
    assert [slip.label for slip in SLIPS] == list(found)
    for slip in SLIPS:
        heading, text = found[slip.label]
        cells = re.findall(r"^```\{code-cell\}[^\n]*\n:tags[^\n]*\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
        called = {node.func.id for cell in cells for node in ast.walk(ast.parse(cell))
                  if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
        assert heading == slip.title
        assert f'stated("{slip.key}")' in text
        assert "**Proof.**" in text
        assert any(name.endswith(("_check", "_table", "_misprints")) for name in called), slip.key


def test_the_summary_leads_to_every_section() -> None:
    """Breaks when a slip is left out of the table at the top, or has no consequence."""
    text = summary().text
    for slip in SLIPS:
        assert f"<{slip.label}>`" in text
        assert slip.consequence.endswith(".")
        assert all(part in stated(slip.key).text for part in (slip.printed, slip.must_be, slip.consequence))


def test_a_proof_that_fails_stops_the_page() -> None:
    """Breaks when a check would be shown as passed whatever it found."""
    with pytest.raises(AssertionError, match="this proof fails: one is two"):
        proved(False, "one is two")


def test_the_printed_form_would_be_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when the checks would pass if the print were right: the printed tensor taken for the average."""
    right = errata.fabric_tensor()
    of_delta, of_fabric = errata.PRINTED_TENSOR
    printed = of_delta - of_fabric * errata.D33 / 2, of_delta + of_fabric * errata.D33
    assert right != printed
    monkeypatch.setattr(errata, "fabric_tensor", lambda: printed)
    with pytest.raises(AssertionError, match="this proof fails"):
        errata.fabric_tensor_check()


def test_keys_are_the_labels_of_the_record() -> None:
    """Breaks when two slips share a key, or a proof belongs to none."""
    assert set(PROOFS) == set(errata_record.OF_KEY)
    assert len(errata_record.OF_KEY) == len(SLIPS)
