"""What accuracy costs: every route of this package and others, their error against certified values and their time."""

from __future__ import annotations

from granular.cost.command import ROUNDS, list_of_names, run_cost
from granular.cost.machine import machine
from granular.cost.measurement import ROUTE_NAMES, Measured, measure_scene, settings_of
from granular.cost.records import Cost
from granular.cost.scenes import NAMES, SCENES, CostScene

__all__ = ["NAMES", "ROUNDS", "ROUTE_NAMES", "SCENES", "Cost", "CostScene", "Measured", "list_of_names", "machine",
           "measure_scene", "run_cost", "settings_of"]
