"""Lists of contacts, measured or simulated: reading, checking, summing, and what the continuum model makes of them.

>>> from granular.contacts import predictions, summarise
>>> from granular.contacts.example import example_facts, example_path
>>> packing = summarise(example_path(), volume=example_facts()["V"], grains=example_facts()["N_grains"])
>>> packing.contacts, packing.coordination_number, packing.stress_is_whole
(5753, 5.753, True)
>>> f"{packing.kinematic.component('C3333') / 1e6:.1f} MPa"
'627.9 MPa'
"""

from __future__ import annotations

from granular.contacts.block import ContactBlock
from granular.contacts.comparison import ComparedPacking, compare_folder
from granular.contacts.contact_list import ContactList
from granular.contacts.estimate import estimated_forces
from granular.contacts.kernels import stiffness_sum
from granular.contacts.material import Material
from granular.contacts.prediction import FittedFabric, Predicted, distance, fitted_fabric, predictions
from granular.contacts.summary import ContactSummary, summarise

__all__ = ["ComparedPacking", "ContactBlock", "ContactList", "ContactSummary", "FittedFabric", "Material", "Predicted",
           "compare_folder", "distance", "estimated_forces", "fitted_fabric", "predictions", "stiffness_sum",
           "summarise"]
