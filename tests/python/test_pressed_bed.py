# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""A piston presses a bed deeper than its collisions: dampers of several contacts limit the time step (dem.48)."""
import re

import pytest

import mahlwerk

PRESS = {
    "title": "piston", "seed": 1, "mill": {"kind": "still"},
    "jar": {"kind": "cylinder", "diameter": "20 mm", "height": "40 mm"},
    "parts": [{"name": "piston", "kind": "plane", "axis": [0, 0, -1], "position": ["0 mm", "0 mm", "4 mm"],
               "motion": "oscillating", "amplitude": "8 mm", "frequency": "4 Hz", "phase": "-90 deg"}],
    "balls": [{"diameter": "5 mm", "density": "2500 kg/m3", "count": 50}],
    "contact": {"restitution": 0.3, "friction": 0.3, "rolling_friction": 0.01, "softening": 1e-2},
    "run": {"engine": "soft", "time": "0.125 s", "settle": "0 s", "settle_at_rest": "0.1 s", "replicates": 1}}


def pressed(changes):
    return mahlwerk.Case(PRESS, changes=changes)


def test_a_run_that_a_pressed_bed_makes_unstable_states_the_step_with_which_it_closes():
    with pytest.raises(mahlwerk.RunError) as stopped:
        pressed({}).run()
    step = re.search(r'run.time_step = "([^"]+)" or less', str(stopped.value)).group(1)
    result = pressed({"run.time_step": step}).run()
    overlap, residual = result["deepest_overlap"].value, result["energy_balance"].value
    print(f"with {step}: overlap {overlap:.3g} of the radius, energy balance {residual:.2g}")
    assert overlap > 0.05
    assert abs(residual) < 1e-3


def test_dampers_not_springs_limit_the_step():
    """With a restitution of 0.9 the usual step is stable at the same overlaps."""
    result = pressed({"contact.restitution": 0.9}).run()
    overlap, residual = result["deepest_overlap"].value, result["energy_balance"].value
    print(f"overlap {overlap:.3g} of the radius, energy balance {residual:.2g}")
    assert overlap > 0.05
    assert abs(residual) < 1e-3
