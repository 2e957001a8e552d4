# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""A bed has a known packing fraction, and flow keeps number and mass of balls."""
import math

import numpy as np
import pytest

from quantity_runs import run_of


def test_a_random_bed_in_a_thin_slice_has_its_packing_fraction():
    """Without friction, balls come to rest in random close packing, 0.637 (Scott and Kilgour 1969). The places hold
    some five separate spheres, whose packing scatters by about 0.03."""
    run = run_of("packed")
    assert run["packing_fraction"] == pytest.approx(0.637, abs=0.015)
    profile = run.result.table("packing_profile")
    mean = np.average(profile["packing_fraction"], weights=profile["points"])
    assert mean == pytest.approx(run["packing_fraction"], abs=0.005)  # samples differ in their number of points


def test_flow_keeps_the_number_and_the_mass_of_balls():
    """Inside + left - entered is the same in every row (flo.2), and balls stay as long as Little's law says (flo.5)."""
    run = run_of("hopper")
    table = run.result.table("flow")
    assert np.ptp(table["inside"] + table["left"] - table["entered"]) == 0
    assert np.ptp(table["mass_inside_kg"] + table["mass_left_kg"] - table["mass_entered_kg"]) < 1e-12
    left = table["left"][-1]
    print(f"{left:.0f} left; residence times {run['residence_time']:.4g} s, {run['tracer_residence_time']:.4g} s")
    assert left > 100
    # The mean of n tracers is off by spread/sqrt(n); what is inside at the ends counts half a residence time each.
    tolerance = 3 * run["residence_time_spread"] / math.sqrt(left) + run["residence_time"]**2 / run.time / 2
    assert run["tracer_residence_time"] == pytest.approx(run["residence_time"], abs=tolerance)
