"""The packing that comes with the package, small and real, so that every command and example has something to read."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path
from typing import Any

NAME = "C_A1_SR15"
"""Spheres under sigma33/sigma11 = 1.5, from a periodic cell of an independent program."""


def example_path() -> Path:
    """Where the contact list of the example is.

    Returns
    -------
    Path
        A compressed CSV file with the native columns.

    Notes
    -----
    Source: a simulation with YADE 2023.02a; see ``example_facts()["source"]``.

    Examples
    --------
    >>> example_path().name
    'C_A1_SR15_contacts.csv.gz'
    """
    return example_folder() / f"{NAME}_contacts.csv.gz"


def example_folder() -> Path:
    """The folder of the example, which can be compared as any folder of packings can.

    Returns
    -------
    Path
        With a contact list and what was measured on it.

    Notes
    -----
    Source: the package's data.

    Examples
    --------
    >>> example_folder().name
    'contacts'
    """
    return Path(str(resources.files("granular") / "data" / "contacts"))


def example_facts() -> dict[str, Any]:
    """What is known of the example: volume, grains, material, void ratio, stress, stiffness.

    Returns
    -------
    dict
        As in the file; SI units.

    Notes
    -----
    Source: the same simulation.

    Examples
    --------
    >>> example_facts()["N_grains"], example_facts()["mu"]
    (2000, 0.2126)
    """
    facts: dict[str, Any] = json.loads((example_folder() / f"{NAME}_meta.json").read_text(encoding="utf-8"))
    return facts
