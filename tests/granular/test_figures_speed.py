"""Pictures of the speed study: curves and bars stand where the records say, and nothing that was measured is lost."""

import pytest

from granular.figures.speed import curves, effect_costs, scaling, scaling_interactive
from granular.speed.interleaved import Measured
from granular.speed.store import Row, Study


def way(name, elements, nanoseconds, error=None):
    return Measured(name=name, elements=elements, ratio=1.0, least=1.0, spread=0.0, nanoseconds=nanoseconds, rounds=3,
                    error=error)


def row(name, size, *ways, each="assembly"):
    return Row(name=name, title=name, each=each, errors="", size=size, ways=ways, failure=None)


STUDY = Study(command="granular speed", rounds=3, machine={}, agreements=[], rows=[
    *(row(name, size, way("moving the same arrays", size, 8.0), way(f"{name}, compiled", size, 1e5 / size),
          *([way(f"{name}, numpy", size, 2e5 / size)] if (name, size) != ("slip", 100) else []))
      for size in (100, 1) for name in ("kinetic", "slip")),
    row("per-item", 100, way("constant, all at once", 100, 9.0), way("closed form, one a call", 10, 700.0))])


def test_curves_are_what_was_measured():
    # a curve that joins two engines, runs in the order of the file, or is lost; sizes of another comparison
    found = {curve.name: (curve.sizes, curve.nanoseconds) for curve in curves(STUDY)}
    assert found == {
        "closed form, one a call": ([1, 100], [700.0, 700.0]), "slip, numpy": ([1], [2e5]),
        "slip, compiled": ([1, 100], [1e5, 1e3]), "kinetic, numpy": ([1, 100], [2e5, 2e3]),
        "kinetic, compiled": ([1, 100], [1e5, 1e3]), "moving the same arrays": ([1, 100], [8.0, 8.0])}


def test_both_pictures_have_every_curve():
    # a curve in one of the two only, or a legend that names another
    names = [curve.name for curve in curves(STUDY)]
    figure = scaling(STUDY)
    (axes,) = figure.axes
    assert [line.get_label() for line in axes.lines] == names
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
    traces = scaling_interactive(STUDY).data
    assert [trace.name for trace in traces] == names
    assert [list(trace.y) for trace in traces] == [list(line.get_ydata()) for line in axes.lines]


def test_engines_and_effects_can_be_told_apart_without_colour():
    # two curves of one look: colour, line and marker must not all be the same
    (axes,) = scaling(STUDY).axes
    looks = {(line.get_color(), line.get_linestyle(), line.get_marker()) for line in axes.lines}
    assert len(looks) == len(axes.lines)


@pytest.mark.parametrize(("nanoseconds", "length", "unit"), [(250.0, 250.0, "ns"), (2.5e6, 2500.0, "µs")])
def test_bars_are_as_long_as_the_times(nanoseconds, length, unit):
    # a unit on the axis that is not that of the bars, or an error at the bar of another
    drawn = effect_costs(row("effects", 10, way("packing", 10, nanoseconds, 3e-16), way("more", 10, 2 * nanoseconds)))
    (axes,) = drawn.axes
    assert [bar.get_width() for bar in axes.patches] == pytest.approx([length, 2 * length])
    assert f"[{unit}]" in axes.get_xlabel()
    assert ["3e−16" in text.get_text() for text in axes.texts] == [True, False]
