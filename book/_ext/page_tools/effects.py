"""Effects on a page: their records, bounds beside true changes, what an accuracy leaves out, and what each costs."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Iterable
from itertools import pairwise

from granular import Evaluation, Scene, evaluate
from granular.checks.effect_examples import ADDED, EXAMPLES, GROWING, Measured, measured, relative_change, scene_with
from granular.checks.effect_sweeps import SWEEPS, as_columns
from granular.effects import CATALOGUE, Effect
from granular.effects.selection import SHARE, rounded_up
from granular.figures import effect_bounds, effect_decision
from granular.figures.page import Static
from page_tools.markup import Markup, numbers_to_take_away, plain, table

NEARLY = "_data/nearly_isotropic.toml"
"""The scene of the worked example."""

LOOSE, TIGHT = 1e-3, 1e-9
"""Its two accuracies."""

SHOWN_AT = 1e-6
"""Wanted accuracy at which costs are shown."""

RANGES = {
    "packing": r"$1/(4\pi E)$; of $k_n$ under `kinetic`: $(1 - D_{33}/5)^{1/3}$ to $(1 + 2D_{33}/5)^{1/3}$; of $k_r$ "
               "under `slip`: what another tilt of the forces does to it",
    "branches": r"$1/W^2$, with $W$ between $1 - D^{r}_{33}/2$ and $1 + D^{r}_{33}$",
    "gradation": r"$4\,\langle r^3\rangle^{2/3}/\langle\ell^2\rangle$, one number",
    "deviation": r"$\chi^{2/3}Q$ over 1, $\chi^2$ or $\chi^4$, with $\chi = b/a$ and $Q$ between 1 and $\chi^2$",
    "kinetic": r"$(a s + c x^2)^{-1/3}$, between $a^{-1/3}$ and $c^{-1/3}$",
    "slip": r"of $k_r$: 1 to $(1-\kappa)^{-1/3}$; of $k_n - k_r$: $(1-\lambda_0)/(1-\lambda_0(1-\kappa)^{1/3})$ to 1",
    "opening": "none: the cube root of a tension is no stiffness",
}
"""Effect -> ratio of the integrands without it to those with it, in any direction, by the kinematic hypothesis."""

WRITTEN_OUT = ("[shape]\naspect_ratio = 1.0", "[branches]\nanisotropy = { D33 = 0.0 }",
               "[packing]\ncontact_normals = { D33 = 0.0, D3333 = 0.0 }", "[stress]\nratio = 1.0",
               '[grains]\nfriction_angle = "30 deg"')
"""Features that are there in the scene file and absent from the scene."""

MODULES = """
import json, sys
import granular
from granular.scene import Scene
granular.evaluate(Scene.model_validate_json(sys.argv[1]), rtol=float(sys.argv[2]))
print(sum(name.startswith("granular.") for name in sys.modules))
"""


def effects_table() -> Markup:
    """List the records: what each effect is, when a scene is without it, and what goes with it."""
    rows = [[f"`{effect.name}`<br>{plain(effect.title)}, {plain(effect.equations)}{_companions(effect)}",
             f"*no:* {plain(effect.called_for(scene_with()).reason)}<br>"
             f"*yes:* {plain(measured_example(effect.name).reason)}", plain(effect.without)] for effect in CATALOGUE]
    return table(["effect", "called for?", "left out, it means"], rows, label="tab-effects", take_away="effects.csv",
                 taken=[["effect", "title", "equations", "requires", "excludes", "not called for", "called for",
                         "left out"],
                        *([effect.name, effect.title, effect.equations, " ".join(effect.requires),
                           " ".join(effect.excludes), effect.called_for(scene_with()).reason,
                           measured_example(effect.name).reason, effect.without] for effect in CATALOGUE)],
                 caption="The effects, with the reasons that a plan gives: *no* for the plain scene of this page, "
                         "*yes* for the one that calls for the effect.")


def bounds_table() -> Markup:
    """List what the bounds come from."""
    rows = [[f"`{effect.name}`", RANGES[effect.name], plain(measured_example(effect.name).bound.reason)]
            for effect in CATALOGUE]
    return table(["effect", "ratio without/with", "the bound is"], rows, label="tab-effect-bounds",
                 take_away="effect_bounds.csv",
                 caption="Ratio of the integrands without an effect to those with it, in any direction, by the "
                         "kinematic hypothesis.")


def examples_table() -> Markup:
    """List the smallest change that calls for each effect, with bound, true change and cost."""
    found = [measured_example(name) for name in EXAMPLES]
    rows = [[f"*{one.name}*<br>{_code(EXAMPLES[one.name])}", bound(one.bound.value).removeprefix("no bound") or "none",
             "–" if one.change is None else power(one.change), *_costs(one)] for one in found]
    taken = [["effect", "added to the plain scene", "simulated", "bound", "change", "directions with", "without",
              "operations with", "without"],
             *([one.name, EXAMPLES[one.name].replace("\n", "; "), " ".join(one.simulated), repr(one.bound.value),
                repr(one.change), *_counts(one)] for one in found)]
    return table(["added to the plain scene", "bound", "change", "directions", "operations"], rows,
                 label="tab-effect-examples", align="lrrrr", take_away="effect_examples.csv", taken=taken,
                 caption=f"For each effect the smallest change to the plain scene that calls for it: bound and true "
                         f"change of the worst component without it, and cost with/without it for a wanted accuracy "
                         f"of {power(SHOWN_AT)}.")


def measured_example(name: str) -> Measured:
    """What an effect does to its example."""
    return measured(name, rtol=SHOWN_AT)


def bounds_figure() -> Static:
    """Draw bounds and changes along the parameter of each effect."""
    return Static(effect_bounds.effect_bounds())


def bounds_numbers() -> Markup:
    """Offer the numbers of that figure."""
    return numbers_to_take_away("effect_sweeps.csv", {
        f"{sweep.name}: {column}": numbers for sweep in SWEEPS for column, numbers in as_columns(sweep).items()})


def decision_figure() -> Static:
    """Draw the choice of effects for the worked example at the looser accuracy."""
    return Static(effect_decision.effect_decision(Scene.from_toml(NEARLY), LOOSE), data=False)


def share_spent() -> Markup:
    """Say how much of an accuracy effects may spend."""
    return Markup(f"Effects may spend {100 * SHARE:g} % of what is wanted.")


def worked_table() -> Markup:
    """Show what two accuracies leave of the worked example."""
    results = [_worked(rtol) for rtol in (LOOSE, TIGHT)]
    lines = {
        "simulated": [_names(result.effects_simulated) for result in results],
        "left out for it": [_names(result.plan.selection.spent) for result in results],
        "what that may change": [bound(result.plan.left_out_error) for result in results],
        "error stated": [bound(result.relative_error) for result in results],
        "route": [f"`{result.route}`" for result in results],
        "directions": [str(result.evaluations) for result in results],
        "operations + functions": [_work(result) for result in results],
    }
    return table(["wanted", *(power(rtol) for rtol in (LOOSE, TIGHT))], [[name, *line] for name, line in lines.items()],
                 label="tab-left-out", take_away="left_out.csv",
                 caption="One soil at two wanted accuracies: the looser one buys a closed form.")


def worked_difference() -> Markup:
    """Hold the two results against each other."""
    loose, tight = _worked(LOOSE), _worked(TIGHT)
    difference = relative_change(loose, tight)
    if not difference <= loose.relative_error + tight.relative_error:
        raise AssertionError("what was left out changes more than the result says")
    return Markup(f"The two results differ by {power(difference)} in the worst component. The first states "
                  f"{bound(loose.relative_error)}, nearly all of which is the bound of what it left out: "
                  f"{loose.relative_error / difference:.1f} times the difference.")


def growing_table() -> Markup:
    """Show the work of one scene as its effects are added, and the modules of the library that it loads."""
    rows = []
    for count in range(len(ADDED) + 1):
        scene = scene_with(GROWING, effects=ADDED[:count])
        chosen, axial = (evaluate(scene, rtol=TIGHT, route=route) for route in ("auto", "axial"))
        rows.append([f"+\u00a0`{ADDED[count - 1]}`" if count else "none", f"`{chosen.route}`", _work(chosen),
                     str(axial.evaluations), _work(axial), str(_modules(scene))])
    if rows[-1][1:] != rows[-2][1:]:
        raise AssertionError("contacts that never open cost something")
    return table(["effects", "route", "its work", "`axial`, directions", "`axial`, work", "modules"], rows,
                 label="tab-growing", align="llrrrr", take_away="growing.csv",
                 caption=f"Work of one scene, operations + functions, as its effects are added, at a wanted accuracy "
                         f"of {power(TIGHT)}: by the route that the plan chooses, and by the rule along the meridian. "
                         "No contact of it is pulled, so that `opening` adds nothing. Modules are those of the library "
                         "that a fresh interpreter has loaded.")


def growing_steps() -> Markup:
    """Say which effects add no operation, and what slip takes."""
    works = {}
    for one, other in pairwise(range(len(ADDED) + 1)):
        before, after = (evaluate(scene_with(GROWING, effects=ADDED[:count]), rtol=TIGHT) for count in (one, other))
        assert before.work is not None
        assert after.work is not None
        works[ADDED[one]] = before.work.operations, after.work.operations
    free = [f"`{name}`" for name, (before, after) in works.items() if before == after]
    dearest = max(works, key=lambda name: works[name][1] - works[name][0])
    return Markup(f"{', '.join(free[:-1])} and {free[-1]} add no operation to this scene; `{dearest}` multiplies them "
                  f"by {works[dearest][1] / works[dearest][0]:.0f}.")


def absent_features() -> Markup:
    """Write absent features out, and see that nothing changes."""
    before = evaluate(scene_with(), rtol=SHOWN_AT)
    for change in WRITTEN_OUT:
        after = evaluate(scene_with(change), rtol=SHOWN_AT)
        if (after.stiffness, after.work, after.relative_error) != (before.stiffness, before.work,
                                                                   before.relative_error):
            raise AssertionError(f"an absent feature changes the result: {change}")
    features = [change.rpartition("\n")[2] for change in WRITTEN_OUT]
    return Markup(f"`{'`, `'.join(features[:-1])}` and `{features[-1]}` were each written into the plain scene when "
                  "this page was built: same bits, same operations, same error.")


def _worked(rtol: float) -> Evaluation:
    return evaluate(Scene.from_toml(NEARLY), rtol=rtol)


def _work(result: Evaluation) -> str:
    work = result.work
    assert work is not None
    return f"{work.operations} + {work.functions}"


def _names(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names) or "–"


def _modules(scene: Scene) -> int:
    """Modules of the library that an evaluation loads in a fresh interpreter."""
    content = json.dumps(scene.model_dump(mode="json", exclude_none=True))
    done = subprocess.run([sys.executable, "-c", MODULES, content, repr(TIGHT)], check=True, capture_output=True,
                          encoding="utf-8")
    return int(done.stdout)


def _companions(effect: Effect) -> str:
    words = [f"needs `{name}`" for name in effect.requires] + [f"never with `{name}`" for name in effect.excludes]
    return "".join(f"; {one}" for one in words)


def _code(lines: str) -> str:
    return "<br>".join(f"`{line}`" for line in lines.split("\n"))


def _counts(one: Measured) -> list[str]:
    """Directions and operations, with and without the effect."""
    found = []
    for count in ("evaluations", "operations"):
        for plan in (one.with_it, one.without_it):
            source = plan if plan is None or count == "evaluations" else plan.work
            found.append("" if source is None else str(getattr(source, count)))
    return found


def _costs(one: Measured) -> list[str]:
    directions, fewer, operations, less = (count or "–" for count in _counts(one))
    return [f"{directions}/{fewer}", f"{operations}/{less}"]


def bound(number: float) -> str:
    """Write a bound with two digits, rounded up."""
    return "no bound" if math.isinf(number) else power(float(rounded_up(number)))


def power(number: float) -> str:
    """Write a number with two digits, a power of ten where it is small."""
    if number == 0 or number >= 0.01:
        return f"{number:.2g}"
    mantissa, _, exponent = f"{number:.1e}".partition("e")
    return f"${'' if mantissa == '1.0' else mantissa + chr(92) + 'cdot'}10^{{{int(exponent)}}}$"
