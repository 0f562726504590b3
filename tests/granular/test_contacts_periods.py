"""Contacts across a periodic boundary, interlocking clumps, and volumes: what a list says only as a whole."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import pytest

from granular.contacts.contact_list import ContactList
from granular.contacts.summary import summarise
from granular.errors import ContactImpossible, ValueOutOfRange

sys.path.insert(0, str(Path(__file__).parent))
from contact_lists import EXAMPLE, HEADER, SOUND, refused, written

CELL = (0.02, 0.03, 0.0)


def wrapped(folder, *, force=True):
    """Centres inside a cell that is periodic along 1 and 2, with the branches and forces that they stand for."""
    rng = np.random.default_rng(4)
    start = rng.uniform(0, 1, (3, 400)) * [[CELL[0]], [CELL[1]], [1.0]]
    normal = rng.normal(size=start.shape)
    normal /= np.sqrt(np.sum(normal**2, axis=0))
    end = start + 2e-3 * normal
    end[:2] %= np.array(CELL)[:2, None]
    rows = np.array([*start, *end, *(0.3 * normal if force else [])]).T
    path = folder / "list.csv"
    np.savetxt(path, rows, delimiter=",", header="x1,y1,z1,x2,y2,z2" + (",f1,f2,f3" if force else ""), comments="",
               fmt="%.17g")
    return path, 2e-3 * normal


def test_branches_across_a_periodic_boundary(tmp_path):
    # Breaks when a period is not added, added along an axis that has none, or a branch longer than the cell passes.
    path, branch = wrapped(tmp_path)
    refused(path, ContactImpossible, "tensile", "--cell LX LY LZ", spheres_only=True)
    block = next(ContactList(path, spheres_only=True, cell=CELL).blocks())
    # a difference of two numbers of size 1 is rounded to 1e-16
    assert block.branch == pytest.approx(branch, abs=3e-16)
    assert block.normal_force == pytest.approx(np.full(400, 0.3), rel=1e-12)
    refused(path, ContactImpossible, "longer than the periodic cell", "line ", spheres_only=True, cell=(2e-3, 0.03, 0))
    for cell in ((0.0, 0.0, 0.0), (-1.0, 0.0, 1.0), (math.nan, 1.0, 1.0), (math.inf, 1.0, 1.0), (1.0, 1.0)):
        refused(path, ValueOutOfRange, "cell = ", "--cell 0.02 0.02 0", spheres_only=True, cell=cell)


def test_branches_that_nothing_else_shows_to_be_wrong_are_told(tmp_path):
    # Breaks when branches of nearly a cell go unseen where neither normals nor forces nor radii tell.
    path, _ = wrapped(tmp_path, force=False)
    many, least, others = summarise(path, volume=1.0, spheres_only=True).stragglers
    assert 20 < many < 100
    assert least > 0.01
    assert others == pytest.approx(2e-3, rel=1e-4)  # the width of a class of lengths
    assert summarise(path, volume=1.0, spheres_only=True, cell=CELL).stragglers is None
    assert summarise(EXAMPLE, volume=1.0).stragglers is None


def test_clumps_that_interlock_may_have_a_branch_against_its_normal(tmp_path):
    # Breaks when one hooked contact refuses a list of clumps, or a list with all normals turned round goes through.
    head, rows = "id1,id2,grain1,grain2,l1,l2,l3,n1,n2,n3", ["0,10,1,2,0.003,0,0,1,0,0", "1,11,1,2,0.003,0,0,0.8,0.6,0"]
    hooked = "4,13,1,3,0.0001,0,0,-1,0,0"
    assert next(ContactList(written(tmp_path / "a.csv", head, *rows, hooked)).blocks()).size == 3
    path = written(tmp_path / "b.csv", head, rows[0], hooked, hooked.replace("4,", "5,", 1))
    refused(path, ContactImpossible, "2 contacts", "against its normal")


def test_a_volume_that_cannot_hold_the_grains(tmp_path):
    # Breaks when lengths in mm beside a volume in m^3 go unseen; the grains of a part of a sample are not counted.
    path = written(tmp_path / "list.csv", HEADER, *SOUND)
    with pytest.raises(ValueOutOfRange, match=r"volume = 1.6e-08, allowed 1.676e-08 m\^3 or more, as 4 spheres"):
        summarise(path, volume=1.6e-8, grains=4)
    assert summarise(path, volume=1.7e-8, grains=4).contacts == summarise(path, volume=1e-9).contacts == 4
