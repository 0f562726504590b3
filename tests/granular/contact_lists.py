"""Contact lists for tests: a real one, and small ones whose sums are known."""

from __future__ import annotations

import csv
import gzip
import math
from pathlib import Path

import numpy as np
import pytest

from granular.contacts.block import ContactBlock
from granular.contacts.contact_list import ContactList
from granular.contacts.example import example_facts, example_path

EXAMPLE, FACTS = example_path(), example_facts()

DEM = Path(__file__).resolve().parents[3] / "shared" / "dem"
"""Packings of known stiffness that are not part of the repository; tests that need them are skipped without."""

HEADER = "id1,id2,l1,l2,l3,n1,n2,n3,R1,R2,fn,fs1,fs2,fs3,kn,ks"
SOUND = ("0,1,0.0019,0,0,1,0,0,0.001,0.001,0.5,0,0.01,0,1e6,8e5",
         "1,2,0,0.0019,0,0,1,0,0.001,0.001,0.4,0.01,0,0,1.1e6,9e5",
         "2,3,0,0,0.0019,0,0,1,0.001,0.001,0.6,0.01,0,0,1.2e6,9e5",
         "3,0,0,0.00133,0.00133,0,0.70710678,0.70710678,0.001,0.001,0.6,0.01,0,0,1.2e6,9e5")
"""Four contacts of four grains, in no way wrong."""


def table() -> tuple[list[str], list[list[str]]]:
    """The example as text cells."""
    with gzip.open(EXAMPLE, "rt", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    return header, rows


def random_block(size: int, seed: int = 7) -> ContactBlock:
    """Contacts without any symmetry, branches and normals up to 30 degrees apart."""
    rng = np.random.default_rng(seed)
    normal = rng.normal(size=(3, size)) * [[1.0], [1.0], [1.3]]
    normal /= np.sqrt(np.sum(normal**2, axis=0))
    branch = normal + 0.25 * rng.normal(size=(3, size))
    branch *= np.sign(np.sum(branch * normal, axis=0))
    kn = rng.uniform(0.5e6, 1.5e6, size)
    return ContactBlock(branch=2e-3 * branch, normal=normal, kn=kn, ks=rng.uniform(0.3, 1.0, size) * kn,
                        normal_force=rng.uniform(0.1, 1.0, size), shear_force=0.05 * rng.normal(size=(3, size)))


def icosahedron() -> np.ndarray:
    """Six axes that average every polynomial of degree five over the sphere exactly: (3, 6)."""
    golden = (1 + math.sqrt(5)) / 2
    axes = np.array([[0, 1, golden], [0, 1, -golden], [1, golden, 0], [1, -golden, 0], [golden, 0, 1],
                     [golden, 0, -1]]).T
    return axes / np.sqrt(np.sum(axes**2, axis=0))


def written(path: Path, *lines: str) -> Path:
    """Write a file of some lines."""
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def refused(path: Path, kind: type[Exception], *words: str, **options: object) -> None:
    """Read a list that is to be refused with some words."""
    with pytest.raises(kind) as refusal:
        for _ in ContactList(path, **options).blocks():
            pass
    for word in words:
        assert word in str(refusal.value)
