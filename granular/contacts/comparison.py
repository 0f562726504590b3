"""The model against packings whose stiffness was measured: sums over contacts, the continuum, and probes.

A folder holds ``NAME_contacts.csv.gz`` (or the list in another format) and ``NAME_meta.json`` for every packing: the
list, and beside it what a probe of the same packing gave with all grains following the strain (affine) and with all
grains free (relaxed).
"""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from granular.contacts.material import Material
from granular.contacts.moments import NORMALS
from granular.contacts.prediction import EQUAL_CONTACTS, fitted_fabric, predictions
from granular.contacts.summary import ContactSummary, summarise
from granular.errors import FileUnreadable, MissingKey, WrongType, found_at
from granular.hypothesis import Hypothesis
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from granular.elasticity import Stiffness

AGREEMENT = 5e-3
"""How far eq. (1) may be from the affine probe in any component, over C3333 [-]."""

LIST, KNOWN = "_contacts.", "_meta.json"
"""What stands after the name of a packing: a list in any format, and what is known of it."""

Components = dict[str, float | None]
"""The six components about axis 3 [Pa]; None where they were not probed."""

MEASURED = {"affine": ("affine_probe", "voigt_elastic"), "rotations only": ("network_solve", "voigt_rotations_only"),
            "relaxed": ("network_solve", "voigt_elastic"), "relaxed, friction active": ("relaxed_probe", "voigt")}
"""What was measured: all grains affine; centres affine and spins free; all free and no contact sliding, which is the
elastic stiffness; all free with contacts that may slide while they are probed."""

WRITTEN_BY = "granular contacts --compare FOLDER --out FILE, with the lists and probes of FOLDER"
"""How a record came about; it says so itself."""

KINEMATIC, STATIC = "eq. (1)", "eq. (5)"
FROM_LIST = {Hypothesis.KINEMATIC: "model, mean kn, kinematic", Hypothesis.STATIC: "model, mean kn, static"}
FROM_SCENE = {Hypothesis.KINEMATIC: "model alone, kinematic", Hypothesis.STATIC: "model alone, static"}
"""Names of what is computed: sums over the list; the model with the mean kn and ks of the list; the model from D33,
Dr33, void ratio, coordination number, branch length over grain size, and stress alone."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ComparedPacking:
    """One packing.

    Attributes
    ----------
    name : str
        Of its files.
    made_by, preparation : str
        The program that made it, and how it was prepared, as what is known of it says; empty where it does not.
    contacts, grains : int
        M and N [-].
    void_ratio, coordination_number : float
        e and 2 M/N [-].
    mean_stress, stress_ratio : float
        p [Pa] and sigma33/sigma11 [-].
    D33, Dr33 : float
        Fabric of normals and branch lengths about axis 3 [-].
    D33_error : float
        Standard error of D33 [-].
    D33_of_branches : float
        The same of the directions of branches [-].
    collinear : bool
        Whether branches follow the normals.
    length_ratio : float
        l_e over twice the radius of the mean volume of a grain [-]: 1 for equal spheres.
    stiffer_where_longer : float
        <l^2 kn> over <l^2> <kn> [-], which the model does not know.
    stiffness : dict
        What it is -> six components about axis 3 [Pa], horizontal ones averaged.
    affine_miss : float
        Largest difference of eq. (1) from the affine probe over all 36 components, over C3333 [-].
    bound : dict
        Component -> eq. (1) over the relaxed stiffness [-].
    recovered : dict
        Component -> share of the distance from eq. (1) down to the relaxed stiffness that eq. (5) covers [-].
    """

    name: str
    made_by: str
    preparation: str
    contacts: int
    grains: int
    void_ratio: float
    coordination_number: float
    mean_stress: float
    stress_ratio: float
    D33: float
    Dr33: float
    D33_error: float
    D33_of_branches: float
    collinear: bool
    length_ratio: float
    stiffer_where_longer: float
    stiffness: dict[str, Components]
    affine_miss: float
    bound: Components
    recovered: Components

    @property
    def agrees(self) -> bool:
        """Whether eq. (1) is within ``AGREEMENT`` of the affine probe."""
        return self.affine_miss <= AGREEMENT


def compare_folder(folder: Path) -> list[ComparedPacking]:
    """Compare every packing of a folder.

    Parameters
    ----------
    folder : Path
        With ``NAME_contacts.csv.gz`` and ``NAME_meta.json`` for every packing.

    Returns
    -------
    list of ComparedPacking
        In the order of their names.

    Raises
    ------
    FileUnreadable
        There is no such folder, or no packing in it.
    GranularError
        A list or what belongs to it cannot be used.

    Notes
    -----
    Source: eqs (1), (5), (20)-(24).

    Examples
    --------
    >>> from granular.contacts.example import example_folder
    >>> [(packing.name, packing.agrees) for packing in compare_folder(example_folder())]
    [('C_A1_SR15', True)]
    """
    lists = sorted(folder.glob(f"*{LIST}*")) if folder.is_dir() else []
    if not lists:
        raise FileUnreadable(f"{folder.name or str(folder)} has no packing", allowed=f"needed: a folder with "
                             f"NAME{LIST}csv.gz and NAME{KNOWN}", remedy="Check the path.")
    return [compare_packing(path, path.with_name(_name(path) + KNOWN)) for path in lists]


def compare_packing(contacts: Path, meta: Path) -> ComparedPacking:
    """Compare one packing.

    Parameters
    ----------
    contacts : Path
        Its contact list.
    meta : Path
        What is known of it: V, N_grains, Gs, nu, mu, e and the probes.

    Returns
    -------
    ComparedPacking
        Everything side by side.

    Raises
    ------
    FileUnreadable, WrongType, MissingKey
        What is known of it cannot be read or is not complete.
    GranularError
        The list cannot be used.

    Notes
    -----
    Source: eqs (1), (5), (20)-(24).
    """
    known = _known(meta)
    summary = summarise(contacts, volume=known["V"], grains=known["N_grains"],
                        material=Material(shear_modulus=known["Gs"], poisson_ratio=known["nu"], friction=known["mu"]))
    kinematic, stress = summary.kinematic, summary.stress
    if kinematic is None or stress is None or summary.stiffer_where_longer is None:
        raise MissingKey(f"{contacts.name} has no contact forces or stiffnesses", allowed="needed: fn, kn and ks",
                         remedy="Export them too.")
    across, fabric = float(stress[0, 0] + stress[1, 1]) / 2, fitted_fabric(summary)
    ratio, mean = float(stress[2, 2]) / across, float(stress.trace()) / 3
    stiffness = {KINEMATIC: _axial(kinematic)}
    if summary.static is not None:
        stiffness[STATIC] = _axial(summary.static)
    stiffness |= {_labelled(one.directions, FROM_LIST[one.hypothesis], summary): _axial(one.stiffness)
                  for one in predictions(summary) if one.stiffness is not None and one.source == EQUAL_CONTACTS}
    sizes = fabric.length / (2 * math.cbrt(3 * known["V"] / (4 * math.pi * known["N_grains"] * (1 + known["e"]))))
    stiffness |= {name: _alone(summary, known, hypothesis, mean, ratio, sizes)
                  for hypothesis, name in FROM_SCENE.items()}
    measured = {name: _block(known, *keys) for name, keys in MEASURED.items()}
    stiffness |= {name: _averaged(matrix) for name, matrix in measured.items() if matrix is not None}
    return ComparedPacking(
        name=_name(contacts), made_by=_said(known, "code"), preparation=_said(known.get("extra"), "prep"),
        contacts=summary.contacts, grains=known["N_grains"], void_ratio=known["e"],
        coordination_number=2 * summary.contacts / known["N_grains"], mean_stress=mean,
        stress_ratio=ratio, D33=fabric.D33, Dr33=fabric.Dr33, D33_error=summary.doubt_of(NORMALS),
        D33_of_branches=7.5 * (float(summary.branches[2, 2]) - 1 / 3), collinear=summary.is_collinear,
        length_ratio=sizes, stiffer_where_longer=summary.stiffer_where_longer, stiffness=stiffness,
        affine_miss=_miss(kinematic, measured["affine"]),
        bound=_pairwise(stiffness, lambda one, _, relaxed: one / relaxed, needs_static=False),
        recovered=_pairwise(stiffness, lambda one, static, relaxed: (one - static) / (one - relaxed),
                            needs_static=True))


def write_comparison(packings: Sequence[ComparedPacking], out: Path) -> None:
    """Write a comparison as data for the book.

    Parameters
    ----------
    packings : sequence of ComparedPacking
        Compared packings.
    out : Path
        JSON file.

    Raises
    ------
    OutputUnwritable
        The file cannot be written; nothing is left half done.

    Notes
    -----
    Source: the records, as they are.
    """
    from granular.output import write_text

    write_text(out, as_data(packings))


def as_data(packings: Sequence[ComparedPacking]) -> str:
    """A comparison as one JSON object.

    Parameters
    ----------
    packings : sequence of ComparedPacking
        Compared packings.

    Returns
    -------
    str
        Its text, ``written_by``, ``agreement`` [-] and ``packings``, with the end of the line.

    Notes
    -----
    Source: the records, as they are.
    """
    content = {"written_by": WRITTEN_BY, "agreement": AGREEMENT,
               "packings": [asdict(packing) | {"agrees": packing.agrees} for packing in packings]}
    return json.dumps(content, indent=1, allow_nan=False) + "\n"


def read_comparison(path: Path) -> list[ComparedPacking]:
    """Read back what ``write_comparison`` wrote, for the book.

    Parameters
    ----------
    path : Path
        JSON file.

    Returns
    -------
    list of ComparedPacking
        The records.

    Raises
    ------
    FileUnreadable, WrongType
        There is no such file, or it is no JSON.

    Notes
    -----
    Source: the records, as they are.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise FileUnreadable(f"{path.name} cannot be read ({(error.strerror or str(error)).lower()})",
                             allowed="needed: a recorded comparison", remedy="Check the path.") from None
    except ValueError:
        raise WrongType(f"{path.name} is no JSON", allowed="needed: a recorded comparison",
                        remedy="Write it again with granular contacts --compare FOLDER --out FILE.") from None
    return [ComparedPacking(**{key: value for key, value in packing.items() if key != "agrees"})
            for packing in content["packings"]]


def _name(contacts: Path) -> str:
    return contacts.name.partition(LIST)[0]


def _known(meta: Path) -> dict[str, Any]:
    name = meta.name
    try:
        known = json.loads(meta.read_text(encoding="utf-8"))
    except OSError as error:
        raise FileUnreadable(f"{name} cannot be read ({(error.strerror or str(error)).lower()})",
                             allowed="needed beside the contact list", remedy="Copy it there.") from None
    except ValueError:
        raise WrongType(f"{name} is no JSON", allowed="needed: what is known of the packing, as JSON",
                        remedy="Copy it again.") from None
    needed = ("V", "N_grains", "Gs", "nu", "mu", "e")
    missing = [key for key in needed if not isinstance(known, dict) or not isinstance(known.get(key), int | float)]
    if missing:
        raise MissingKey(f"{name} has no number {' '.join(missing)}", allowed=f"needed: {' '.join(needed)}",
                         remedy="Add what is missing.")
    found: dict[str, Any] = known
    return found


def _said(known: Any, key: str) -> str:
    """What is known in words, where it is."""
    return str(known.get(key, "")) if isinstance(known, dict) else ""


def _block(known: dict[str, Any], part: str, key: str) -> list[list[float]] | None:
    found: list[list[float]] | None = (known.get(part) or {}).get(key)
    return found


def _averaged(voigt: list[list[float]]) -> Components:
    """Six components of a Voigt matrix in the standard order, horizontal axes and transposes averaged."""
    places = {"C1111": ((0, 0), (1, 1)), "C3333": ((2, 2),), "C1122": ((0, 1), (1, 0)),
              "C1133": ((0, 2), (1, 2), (2, 0), (2, 1)), "C2323": ((3, 3), (4, 4)), "C1212": ((5, 5),)}
    probed = {name: [voigt[i][j] for i, j in at if voigt[i][j] is not None and voigt[i][j] == voigt[i][j]]
              for name, at in places.items()}
    return {name: sum(values) / len(values) if values else None for name, values in probed.items()}


def _axial(stiffness: Stiffness) -> Components:
    return _averaged(stiffness.voigt().tolist())


def _labelled(directions: str, name: str, summary: ContactSummary) -> str:
    return name if summary.is_collinear else f"{name}, fabric of {directions}"


def _alone(summary: ContactSummary, known: dict[str, Any], hypothesis: Hypothesis, mean: float, ratio: float,
           length_ratio: float) -> Components:
    """The model from what a scene file would say, without anything else of the list.

    The length ratio carries gradation and shape: with it the model has <l^2>/<r^3>^(2/3) of the packing.
    """
    from granular.evaluation import evaluate
    from granular.scene import Scene

    fabric = fitted_fabric(summary)
    with found_at(f"{summary.name}: "):
        scene = Scene.model_validate({
            "grains": {"shear_modulus": known["Gs"], "poisson_ratio": known["nu"]},
            "packing": {"void_ratio": known["e"], "coordination_number": summary.coordination_number,
                        "contact_normals": {"D33": fabric.D33}},
            "branches": {"anisotropy": {"D33": fabric.Dr33}, "length_ratio": length_ratio},
            "stress": {"mean": mean, "ratio": ratio}, "model": {"hypothesis": str(hypothesis)}})
        return dict(evaluate(scene).stiffness.components)


def _miss(kinematic: Stiffness, affine: list[list[float]] | None) -> float:
    import numpy as np

    if affine is None:
        raise MissingKey("affine_probe.voigt_elastic is missing", allowed="needed: the stiffness with all grains "
                         "following the strain", remedy="Probe the packing.")
    voigt = kinematic.voigt()
    return float(np.abs(voigt - np.array(affine)).max() / voigt[2, 2])


def _pairwise(stiffness: dict[str, Components], of: Any, *, needs_static: bool) -> Components:
    """A number for each component that eq. (1), eq. (5) where needed, and the relaxed packing have."""
    found: Components = {}
    for name in COMPONENTS:
        values = [stiffness.get(key, {}).get(name) for key in (KINEMATIC, STATIC, "relaxed")]
        complete = values[0] is not None and values[2] is not None and not (needs_static and values[1] is None)
        found[name] = of(*values) if complete else None
    return found
