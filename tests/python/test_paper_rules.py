# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Rules of checks, on campaigns made by hand. Each rule says yes and no."""
import math

import pytest

from mahlwerk.papers import Paper, PaperCampaign
from mahlwerk.papers.lines import Point, Points

NAN = math.nan
C = PaperCampaign("c")
SPEED = {"against": "mill.speed"}


def campaign(x, y, ci95, unit="W"):
    """y at x for each key "mill.speed", in rpm, with the same interval everywhere."""
    return Points(["mill.speed"], {"power": unit},
                  [Point([f"{a} rpm"], {"power": b}, {"power": ci95},
                         "cataracting" if a > 250 else "cascading") for a, b in zip(x, y)])


def holds(rule, x, y, ci95=0.1):
    return rule.judge(campaign(x, y, ci95)).holds


def test_a_trend_holds_if_each_step_is_larger_than_both_intervals():
    rises, steps = C.rises("power", **SPEED), [100, 200, 300]
    found = rises.judge(campaign(steps, [1, 2, 3], 0.49))
    assert found.holds == "yes"
    assert "1.00 ± 0.49 W at speed 100 rpm, 3.00 ± 0.49 W at 300 rpm" in found.finding
    assert "at 2 of 2 steps" in found.finding
    some = rises.judge(campaign(steps, [1, 1.5, 3], 0.49))
    assert some.holds == "partly" and "not from 100 rpm to 200 rpm" in some.finding
    assert holds(rises, steps, [3, 2, 1], 0.49) == "no"
    assert holds(C.falls("power", **SPEED), steps, [3, 2, 1], 0.49) == "yes"
    assert holds(C.falls("power", **SPEED), steps, [1, 2, 3], 0.49) == "no"
    assert holds(rises, steps, [1, 2, 3], NAN) == "undecided"


def test_the_order_of_a_trend_is_that_of_the_key_not_of_the_runs():
    assert holds(C.rises("power", **SPEED), [300, 100, 200], [3, 1, 2]) == "yes"


def test_values_in_other_units_stand_where_they_belong():
    c = campaign([1, 2, 3], [1, 2, 3], 0.1)
    for point, text in zip(c.points, ("100 rpm", "3 Hz", "240 rpm")):  # 3 Hz are 180 rpm
        point.values = [text]
    assert C.rises("power", **SPEED).judge(c).holds == "yes"
    c.points[1].value, c.points[2].value = c.points[2].value, c.points[1].value
    assert C.rises("power", **SPEED).judge(c).holds == "partly"


def test_a_comparison_gives_the_ratio_with_its_interval():
    larger = C.larger("power", **SPEED, first="100 rpm", second="300 rpm")
    found = larger.judge(campaign([100, 200, 300], [2, 4, 6], 0.4))
    # 6/2 = 3; its half-width sqrt(0.4^2 + (3*0.4)^2)/2 = 0.632.
    assert found.holds == "yes" and "3.00 ± 0.63 times" in found.finding
    assert holds(larger, [100, 300], [6, 2], 0.4) == "no"
    assert holds(C.smaller("power", **SPEED, first="100 rpm", second="300 rpm"), [100, 300], [6, 2], 0.4) == "yes"
    assert holds(larger, [100, 300], [2, 2.5], 0.4) == "undecided"
    assert holds(larger, [100, 200], [2, 4], 0.4) == "undecided"
    same = C.larger("power", **SPEED, first="36000 deg/min", second="300 rpm")
    assert holds(same, [100, 300], [2, 6], 0.4) == "yes", "the same value in another unit"


def test_what_is_alike_stays_within_its_bound():
    alike, steps = C.is_alike("power", **SPEED, within=0.1), [100, 200, 300]
    assert holds(alike, steps, [1, 1.03, 1.01], 0.01) == "yes"
    assert holds(alike, steps, [1, 2, 1], 0.01) == "no"
    assert holds(alike, steps, [1, 1.03, 1.01], 0.2) == "undecided"


def test_a_line_is_straight_if_its_curvature_is_surely_small():
    line = C.is_linear("power", **SPEED).judge(campaign([100, 200, 300, 400], [5, 7, 9, 11], 0.1))
    assert line.holds == "yes"
    assert line.finding.startswith("20"), "2 W for each 100 rpm"
    assert "mW for each rpm" in line.finding and "R² = 1.0000" in line.finding
    # y = x^2 over 1 to 5: the middle is at 9, the chord at 13, the rise is 24: 16.7 %.
    steps, square = [100, 200, 300, 400, 500], [1, 4, 9, 16, 25]
    bent = C.is_linear("power", **SPEED).judge(campaign(steps, square, 0.1))
    assert bent.holds == "no" and "deviates by -16.67" in bent.finding
    assert holds(C.is_linear("power", **SPEED, within=0.2), steps, square) == "yes"
    # A scatter as large as the rise leaves both open.
    assert holds(C.is_linear("power", **SPEED), steps, [1, 9, 2, 12, 8], 1) == "undecided"
    assert holds(C.is_linear("power", **SPEED, direction="falls"), [100, 200, 300, 400], [5, 7, 9, 11]) == "no"


def test_an_exponent_is_judged_by_its_interval_alone():
    steps, square, scattered = [100, 200, 300, 400], [1, 4, 9, 16], [1, 6, 6, 20]

    def power(exponent):
        return C.follows_power("power", **SPEED, exponent=exponent, within=0.05)
    assert holds(power(2), steps, square) == "yes"
    assert holds(power(1.9), steps, square) == "no"
    above, below = (side("power", **SPEED, exponent=1) for side in (C.exponent_above, C.exponent_below))
    assert holds(above, steps, square) == "yes" and holds(below, steps, square) == "no"
    # A scatter that hides the exponent decides nothing, whatever R2 is.
    assert holds(C.exponent_below("power", **SPEED, exponent=2), steps, scattered) == "undecided"
    assert holds(power(2), steps, scattered) == "undecided"
    assert holds(power(2), [100, 200, 300], [1, 4, 9]) == "undecided"


def test_a_maximum_lies_where_no_value_outside_may_be_the_largest():
    most, steps = C.largest_between("200 rpm", "300 rpm", "power", **SPEED), [100, 200, 300, 400]
    found = most.judge(campaign(steps, [1, 3, 2.9, 1], 0.1))
    assert found.holds == "yes" and "anywhere from 200 rpm to 300 rpm" in found.finding
    assert holds(most, steps, [1, 3, 2.9, 2.95]) == "undecided"
    assert holds(most, steps, [1, 2, 3, 4]) == "no"


def assumed_friction(x, low, high):
    """Power at frictions 0.2 and 0.8 for each speed."""
    points = [Point([f"{a} rpm", friction], {"power": b}, {"power": 0.1})
              for friction, y in (("0.2", low), ("0.8", high)) for a, b in zip(x, y)]
    return Points(["mill.speed", "contact.friction"], {"power": "W"}, points)


def agreement(status="verified"):
    measured = Paper(title="T", source="S").measured(
        "m", source="s", status=status, values=[("100 rpm", "10 W", "0.5 W"), ("200 rpm", "20 W", "0.5 W")])
    return C.agrees_with(measured, "power", **SPEED)


def test_measured_values_agree_if_their_interval_meets_the_band_over_what_is_assumed():
    both = agreement().judge(assumed_friction([100, 200], [9, 18], [11, 19.6]))
    assert both.holds == "yes"
    assert both.deviation == pytest.approx(0.11), "(9 - 0.1)/10 and (11 + 0.1)/10"
    assert "100 rpm: measured 10.00 ± 0.50 W, predicted 8.90" in both.finding
    assert agreement().judge(assumed_friction([100, 200], [9, 18], [11, 19])).holds == "partly"
    assert agreement().judge(assumed_friction([100, 200], [5, 8], [6, 9])).holds == "no"
    wide = agreement().judge(assumed_friction([100, 200], [5, 10], [15, 30]))
    assert wide.holds == "undecided" and "factor of 2" in wide.finding
    none = agreement("unverified").judge(assumed_friction([100, 200], [9, 18], [11, 19.6]))
    assert none.holds == "undecided" and math.isnan(none.deviation) and "unverified" in none.finding


def test_a_ratio_to_one_point_is_measured_without_unit():
    measured = Paper(title="T", source="S").measured("m", source="s", status="verified",
                                                     values=[("200 rpm", "2.0", "0.1")])
    rule = C.agrees_with(measured, "power", **SPEED, relative_to="100 rpm")
    assert rule.judge(campaign([100, 200], [10, 20], 0.1)).holds == "yes"
    assert rule.judge(campaign([100, 200], [10, 30], 0.1)).holds == "no"


def test_many_combinations_of_other_keys_are_counted():
    c = assumed_friction([100, 200, 300], [1, 2, 3], [3, 2, 1])
    first = c.points[:3]
    for more in ("0.3", "0.4", "0.5"):
        c.points += [Point([p.values[0], more], p.value, p.ci95) for p in first]
    found = C.rises("power", **SPEED).judge(c)
    assert found.holds == "partly"
    assert found.finding == "yes in 4, no in 1 of 5 combinations of the other keys"


def test_regimes_are_counted_and_told():
    c = campaign([100, 200, 300], [1, 2, 3], 0.1)
    found = C.regime("cascading", **SPEED).judge(c)
    assert found.holds == "partly"
    assert found.finding == "cascading at speed 100 rpm, 200 rpm; cataracting at speed 300 rpm"
    assert C.regime("rolling", **SPEED).judge(c).holds == "no"
    assert C.regime("cascading", **SPEED, at={"mill.speed": ["100 rpm", "200 rpm"]}).judge(c).holds == "yes"


def test_a_bound_is_kept_by_more_than_the_interval():
    above = C.above("0.8", "power")
    assert holds(above, [100, 200], [1, 2]) == "yes"
    assert holds(above, [100, 200], [0.5, 2]) == "partly"
    assert holds(above, [100, 200], [0.5, 0.6]) == "no"
    assert holds(above, [100, 200], [0.8, 0.8]) == "undecided"
    assert holds(C.below("0.8", "power"), [100, 200], [0.5, 0.6]) == "yes"
    assert holds(C.below("0.8", "power"), [100, 200], [1, 2]) == "no"


def test_a_bound_is_compared_in_the_unit_of_its_quantity():
    doses = campaign([100, 200], [100, 200], 10, "J/g")
    assert C.above("50 kJ/kg", "power").judge(doses).holds == "yes"
    assert C.above("300 kJ/kg", "power").judge(doses).holds == "no"


def test_other_keys_make_lines_of_their_own_but_not_those_that_go_together():
    points = [Point([f"{100 * i} rpm", f"{i} s", friction], {"power": float(i) if rough else 1.0},
                    {"power": 0.1})
              for rough, friction in ((False, "0"), (True, "0.5")) for i in (1, 2, 3)]
    c = Points(["mill.speed", "run.time", "contact.friction"], {"power": "W"}, points)
    found = C.rises("power", **SPEED).judge(c)
    assert found.holds == "partly"
    assert found.finding.startswith("friction 0: ") and "; friction 0.5: " in found.finding
    assert "time" not in found.finding
    c.keys[0] = "wall.friction"  # then the last word of the key is ambiguous
    assert C.rises("power", against="wall.friction").judge(c).finding.startswith("contact friction 0: ")


def test_a_point_that_gave_nothing_is_no_evidence():
    assert holds(C.rises("power", **SPEED), [100, 200, 300], [1, NAN, 3]) == "undecided"
    assert C.rises("power", **SPEED).judge(campaign([], [], 0.1)).finding == "no such point was run"
