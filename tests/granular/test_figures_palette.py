"""The palette as colour-blind readers and grey prints show it, and curves that differ by more than their colour."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from matplotlib import colormaps
from matplotlib.colors import to_rgb

from granular.figures import look

SERIES = {"blue": look.BLUE, "vermilion": look.VERMILION, "green": look.GREEN, "purple": look.PURPLE,
          "orange": look.ORANGE, "sky": look.SKY, "ink": look.INK}

DEFICIENCIES = {
    "normal": np.eye(3),
    "protanopia": np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
                            [-0.003882, -0.048116, 1.051998]]),
    "deuteranopia": np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
                              [-0.011820, 0.042940, 0.968881]]),
    "tritanopia": np.array([[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602],
                            [0.004733, 0.691367, 0.303900]]),
}
"""Machado, Oliveira & Fernandes (2009), severity 1: what is left of linear red, green and blue."""

TO_XYZ = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750],
                   [0.0193339, 0.1191920, 0.9503041]])
"""Of linear sRGB, white point D65."""

APART = 10.0
"""Distance in CIELAB of two curves that are told apart at a glance; 2.3 is what an eye can just notice side by side."""


def lab(colours: np.ndarray, seen: np.ndarray) -> np.ndarray:
    """CIELAB coordinates of sRGB colours (..., 3) as a reader sees them."""
    linear = np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    xyz = np.clip(linear @ seen.T, 0, 1) @ TO_XYZ.T / (TO_XYZ @ np.ones(3))
    root = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack([116 * root[..., 1] - 16, 500 * (root[..., 0] - root[..., 1]),
                     200 * (root[..., 1] - root[..., 2])], axis=-1)


@pytest.mark.parametrize("deficiency", DEFICIENCIES)
def test_colours_are_told_apart(deficiency):
    """Breaks when a colour is added that some reader cannot tell from another one."""
    seen = {name: lab(np.array(to_rgb(colour)), DEFICIENCIES[deficiency]) for name, colour in SERIES.items()}
    for (one, first), (two, second) in itertools.combinations(seen.items(), 2):
        assert np.linalg.norm(first - second) > APART, (one, two)


@pytest.mark.parametrize("deficiency", DEFICIENCIES)
def test_the_colour_map_rises_in_lightness(deficiency):
    """Breaks with a map whose ends look alike in grey, or whose order some reader does not see."""
    light = lab(colormaps[look.MAP](np.linspace(0, 1, 64))[:, :3], DEFICIENCIES[deficiency])[:, 0]
    assert (np.diff(light) > 0).all()
    assert light[-1] - light[0] > 60  # of 100 between black and white


def test_curves_stand_out_from_the_page():
    """Breaks with a colour that is too pale on white for a thin line, such as yellow."""
    for name, colour in SERIES.items():
        assert lab(np.array(to_rgb(colour)), np.eye(3))[0] < 75, name  # white is 100
