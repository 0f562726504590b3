"""Which names the reference explains, in groups by what they are for, and the page that has each group."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from functools import cache

PACKAGES = ("granular.contacts", "granular.derivatives", "granular.fabric_tensors", "granular.fitting",
            "granular.general", "granular.gradation", "granular.sweeps", "granular.branch_products",
            "derivations.catalogue", "derivations.record", "derivations.symbols", "derivations.sphere",
            "derivations.present")
"""Packages and modules all of whose public functions and classes are explained, beside those of ``granular``."""


@dataclass(frozen=True, slots=True)
class Group:
    """Names that are needed together.

    Attributes
    ----------
    title : str
        What they are for.
    page : str
        The page that explains them.
    names : tuple of str
        Full names of what is called or built.
    returned : tuple of str
        Full names of what is only given back; nobody builds it by hand.
    """

    title: str
    page: str
    names: tuple[str, ...]
    returned: tuple[str, ...] = ()


def _under(package: str, names: str) -> tuple[str, ...]:
    return tuple(f"{package}.{name}" for name in names.split())


GROUPS: dict[str, Group] = {
    "scenes": Group(
        "One scene", "python_scenes", _under("granular", "Scene evaluate plan Hypothesis"),
        (*_under("granular", "Evaluation Plan"), "granular.ratios.Ratio",
         "granular.engineering.EngineeringConstants", "granular.waves.Waves")),
    "tensors": Group("Stiffness and compliance", "python_scenes", _under("granular", "Stiffness Compliance")),
    "refusals": Group("Refusals", "python_scenes", _under("granular", "GranularError")),
    "arrays": Group("Many assemblies at once", "python_many", _under("granular", "axial_stiffness axial_gradient"),
                    ("granular.derivatives.AxialGradient",)),
    "slopes": Group("Slopes of one scene", "python_many", _under("granular", "sensitivity"),
                    ("granular.derivatives.Sensitivity",)),
    "sweeps": Group("Sweeps", "python_many", _under("granular", "sweep open_sweep sweeps.Sweep")),
    "fabric": Group("Fabric and stress", "python_fabric",
                    _under("granular", "AxialFabric GeneralFabric GeneralLoading")),
    "general": Group(
        "Without an axis", "python_fabric",
        _under("granular", "general_stiffness classify general.general_engineering general.general_waves "
                           "general.axis_speeds general.plane_waves"),
        _under("granular.general", "GeneralStiffness Symmetry GeneralEngineering GeneralWaves PlaneWaves ThreeWaves "
                                   "Extreme")),
    "gradation": Group(
        "Grain sizes", "python_fabric", _under("granular", "Lognormal MeasuredCurve read_curve length_moments "
                                                           "gradation.branch_lengths"),
        _under("granular.gradation", "SizeDistribution LengthMoments BranchLengths Moment")),
    "branches": Group("Any branch vectors", "python_fabric",
                      ("granular.stiffness_by_direction",
                       *_under("granular.branch_products", "along_normals lognormal_lengths deviating "
                                                           "spheroid_branches spheroid_deviation"))),
    "directions": Group(
        "Fabric tensors of directions", "python_measured",
        ("granular.fabric_of", *_under("granular.fabric_tensors", "Moments tensors_of axial_tensors isotropic "
                                       "density least_density directions_of axial_fabric symmetry_axis")),
        _under("granular.fabric_tensors", "FabricTensors AxialFit LeastDensity")),
    "scatter": Group(
        "Scatter and significance", "python_measured",
        _under("granular.fabric_tensors", "significance uniformity axial_symmetry orthotropy rank_four "
               "randomised_uniformity randomised_axial_symmetry least_seen component_intervals principal_intervals "
               "axial_intervals axis_interval bootstrap normal_resamples resampled_components"),
        _under("granular.fabric_tensors", "Significance SymmetryTest Interval AxisInterval Resamples")),
    "contacts": Group(
        "Contact lists", "python_measured",
        ("granular.summarise", *_under("granular.contacts", "Material predictions fitted_fabric estimated_forces "
                                       "distance compare_folder ContactList stiffness_sum")),
        _under("granular.contacts", "ContactSummary Predicted FittedFabric ComparedPacking ContactBlock")),
    "fits": Group("Fits", "python_measured", ("granular.fit", "granular.fitting.Data"),
                  _under("granular.fitting", "Fit Estimate Combination Residual")),
    "figures": Group("Figures of a scene", "python_scenes", ("granular.figures.save",)),
    "catalogue": Group("The catalogue", "python_derivations", _under("derivations.catalogue", "names derivation")),
    "records": Group("What a derivation is", "python_derivations",
                     _under("derivations.record", "Derivation Step Claim Output Function BatchFunction")),
    "symbols": Group("Symbols", "python_derivations", _under("derivations.symbols", "Quantity describe latex")),
    "means": Group("Averages over directions", "python_derivations",
                   _under("derivations.sphere", "monomial_mean sphere_mean circle_mean azimuth_mean meridian_form "
                                                "homogeneous axial_moment axial_mean odd_factorial")),
    "shown": Group("Showing one", "python_derivations",
                   _under("derivations.present", "text latex_lines python_source verdict steps facts symbols outputs "
                                                 "label Page")),
}


def found(name: str) -> object:
    """What a full name stands for.

    Raises
    ------
    AttributeError
        There is no such thing.
    """
    module, _, last = name.rpartition(".")
    return getattr(importlib.import_module(module), last)


@cache
def explained() -> dict[str, object]:
    """Every name that the reference explains, with what it stands for, in the order of the pages."""
    return {name: found(name) for group in GROUPS.values() for name in (*group.names, *group.returned)}


@cache
def name_of(what: int) -> str | None:
    """The explained name of the object with an identity; None where the reference does not explain it."""
    return next((name for name, thing in explained().items() if id(thing) == what), None)
