# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The functions of validation/vibrated-layers/paper.py find patterns that are put into them."""
import runpy
from pathlib import Path

import numpy as np
import pytest

HOME = Path(__file__).resolve().parents[2]
LAYERS = runpy.run_path(str(HOME / "validation/vibrated-layers/paper.py"))
DIAMETER, CELLS = LAYERS["DIAMETER"], 25
SIDE = CELLS * LAYERS["CELL"]


def pattern(directions, wavelength, turn=0.3, noise=0.3):
    """Waves of this length [diameters] in evenly spaced directions, and noise."""
    x, y = np.indices((CELLS, CELLS)) * LAYERS["CELL"] / DIAMETER
    angles = turn + np.pi * np.arange(directions) / directions
    waves = sum(np.cos(2 * np.pi / wavelength * (x * np.cos(a) + y * np.sin(a)) + shift)
                for a, shift in zip(angles, (0.3, 1.1, -1.4)))
    return waves + noise * np.random.default_rng(1).normal(size=x.shape)


@pytest.mark.parametrize("turn", [0, 0.3, 0.8])
@pytest.mark.parametrize("wavelength", [20, 25])
@pytest.mark.parametrize("directions, peaks", [(1, 2), (2, 4), (3, 6)])
def test_stripes_squares_and_hexagons_are_told_by_their_peaks_and_wavelength(directions, peaks, wavelength, turn):
    field = pattern(directions, wavelength, turn)
    assert LAYERS["peaks"](field) == peaks
    found, half = LAYERS["wavelength"](field, SIDE)
    print(f"wavelength: expected {wavelength}, found {found / DIAMETER:.2f}, tolerance {half / DIAMETER:.2f}")
    assert abs(found / DIAMETER - wavelength) <= half / DIAMETER, "half the distance of two waves of the box"


@pytest.mark.parametrize("period, factors", [(1, [1]), (2, [1, -1]), (4, [1, 0.3, -1, -0.3])])
def test_a_pattern_repeats_after_its_period(period, factors):
    noise = np.random.default_rng(2)
    series = np.array([factors[i % len(factors)] * pattern(3, 25, noise=0) + 0.1 * noise.normal(size=(CELLS, CELLS))
                       for i in range(17)])
    assert LAYERS["repeats_after"](series) == period


def test_a_height_field_holds_the_mean_height_of_the_balls_of_each_cell():
    places = LAYERS["CELL"] * (np.arange(CELLS) + 0.5) - 0.5 * SIDE
    x, y = map(np.ravel, np.meshgrid(places, places, indexing="ij"))
    low, high = np.column_stack([x, y, np.zeros_like(x)]), np.column_stack([x, y, 2 * x])
    field = LAYERS["height_field"](np.concatenate([low, high]), SIDE)
    assert field == pytest.approx(np.repeat(places[:, None], CELLS, axis=1), abs=1e-12), "mean of 0 and 2 x"
