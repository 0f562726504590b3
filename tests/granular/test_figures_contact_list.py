"""Figures of contact lists: what is drawn is what was counted, in every format, and the same every time."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from granular.contacts.estimate import estimated_forces
from granular.contacts.material import Material
from granular.contacts.summary import summarise
from granular.errors import FigureNotKnown, FigureNotWritten
from granular.figures.contact_list import (
    ALL,
    FORCES,
    LIST_FIGURES,
    ROSES,
    STIFFNESS,
    contact_list_figure,
    panels_of,
    save_contact_list,
)
from granular.figures.contact_list_interactive import contact_list_interactive

sys.path.insert(0, str(Path(__file__).parent))
from contact_lists import EXAMPLE, FACTS, written

HEAD = "l1,l2,l3,n1,n2,n3"


@pytest.fixture(scope="module")
def packing():
    return summarise(EXAMPLE, volume=FACTS["V"], material=Material(shear_modulus=29e9, poisson_ratio=0.2))


@pytest.fixture
def bare(tmp_path):
    """Three normals along the axes, branches turned about axis 1, and nothing else."""
    path = written(tmp_path / "a.csv", HEAD, "1,0,0,1,0,0", "0,0.8,0.6,0,1,0", "0,0.6,0.8,0,0,1")
    return summarise(path, volume=1.0)


def traces(figure, kind):
    return [trace for trace in figure.data if trace.type == kind]


def test_panels_are_those_that_the_list_has(packing, bare):
    # Breaks when a panel is drawn of what is not there, or refused though it is.
    assert panels_of(packing, ALL) == (ROSES, FORCES, STIFFNESS)
    assert panels_of(bare, ALL) == panels_of(bare, ROSES) == (ROSES,)
    for what, word in ((FORCES, "without contact forces"), (STIFFNESS, "without contact stiffnesses")):
        with pytest.raises(FigureNotKnown, match=word):
            panels_of(bare, what)


def test_roses_show_normals_and_branches_apart(bare):
    # Breaks when branches are drawn by the angle of their normals: here two of three lie elsewhere.
    normals, branches = traces(contact_list_interactive(bare, ROSES), "barpolar")
    filled = [[theta for theta, r in zip(rose.theta, rose.r, strict=True) if r] for rose in (normals, branches)]
    assert filled == [[2.5, 87.5], [37.5, 52.5, 87.5]]  # acos 0.8 = 36.9 and acos 0.6 = 53.1 degrees


def test_curves_carry_means_scatter_and_estimates(packing):
    # Breaks when a curve has another unit, class or scatter than the report.
    figure = contact_list_interactive(packing, ALL)
    low, high, mean, estimate = traces(figure, "scatter")[:4]
    classes = packing.by_angle
    # five digits are written
    assert mean.y == pytest.approx(classes.mean("normal_force"), rel=1e-4)
    assert np.subtract(high.y, low.y) == pytest.approx(2 * classes.scatter("normal_force"), rel=1e-4)
    assert estimate.y == pytest.approx(estimated_forces(packing)[0], rel=1e-4)
    stiffness = traces(contact_list_interactive(packing, STIFFNESS), "scatter")[2]
    assert stiffness.y == pytest.approx(classes.mean("kn") / 1e3, rel=1e-4)
    assert f"{classes.contacts[0]:.0f} contacts" in stiffness.hovertext[0]
    line = contact_list_figure(packing, FORCES).axes[0].lines[0]
    assert line.get_ydata() == pytest.approx(classes.mean("normal_force"), rel=1e-14)


def test_empty_classes_leave_a_gap(bare, tmp_path):
    # Breaks when a class without contacts is drawn as zero, or as a word that no browser reads.
    path = written(tmp_path / "b.csv", HEAD + ",fn", "1,0,0,1,0,0,1", "0,1,0,0,1,0,1", "0,0,1,0,0,1,1")
    mean = traces(contact_list_interactive(summarise(path, volume=1.0), FORCES), "scatter")[2]
    assert (mean.y[0], mean.y[1], mean.y[17]) == (1.0, None, 1.0)
    assert "NaN" not in contact_list_interactive(bare, ALL).to_json()


@pytest.mark.parametrize("what", LIST_FIGURES)
def test_the_same_file_every_time(packing, tmp_path, what):
    # Breaks when a figure carries a date or a random name, or cannot be drawn.
    files = [save_contact_list(packing, tmp_path / name, what) for name in ("a.svg", "b.svg")]
    assert files[0].read_bytes() == files[1].read_bytes()


def test_a_page_needs_no_network(packing, bare, tmp_path):
    # Breaks when plotly.js is left out, or something is fetched.
    text = save_contact_list(packing, tmp_path / "a.html", ROSES).read_text("utf-8")
    assert "C_A1_SR15_contacts.csv.gz" in text.partition("</title>")[0]
    assert len(text) > 3e6
    assert '<script src="http' not in text
    assert save_contact_list(bare, tmp_path / "c.png").stat().st_size > 1000


def test_refusals_come_before_any_drawing(bare, tmp_path):
    # Breaks when a file is begun for a figure that cannot be.
    for what, out, kind in ((FORCES, "a.svg", FigureNotKnown), ("rose", "a.svg", FigureNotKnown),
                            (ROSES, "a.jpg", FigureNotKnown), (ROSES, "no/a.svg", FigureNotWritten)):
        with pytest.raises(kind):
            save_contact_list(bare, tmp_path / out, what)
    assert not list(tmp_path.glob("*.svg"))
