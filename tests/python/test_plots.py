# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
import matplotlib.pyplot as plt
import numpy as np
import pytest

import mahlwerk
from quantity_runs import CASES


@pytest.fixture(autouse=True)
def close_figures():
    yield
    plt.close("all")


def test_the_area_of_a_spectrum_is_the_collision_rate_and_the_power(ball):
    result = ball.run()
    for per, quantity in (("rate", "collision_rate"), ("power", "dissipated_power_of_collisions")):
        ax = result.plot.spectrum("lost", per=per)
        x, y = ax.lines[0].get_data()
        assert np.trapz(y, np.log(x)) == pytest.approx(result[quantity].value, rel=1e-6)
        assert "J" in ax.get_xlabel() and ax.get_legend()
    assert result.plot.spectrum(ax=ax) is ax
    with pytest.raises(ValueError, match="normal, contact_point"):
        result.plot.spectrum("kinetic")


def test_the_wall_map_holds_the_power_of_the_wall(ball):
    result = ball.run()
    for part in ("side", "bottom", "top"):
        table = result.table("wall_map")
        table = table[(table["part"] == part) & (table["area_m2"] > 0)]
        mesh = result.plot.wall_map(part).collections[0]
        drawn = np.ma.masked_invalid(np.ma.asarray(mesh.get_array()).ravel()).compressed()
        np.testing.assert_allclose(np.sort(drawn),
                                   np.sort(table["power_normal_W"] / table["area_m2"]))
    with pytest.raises(ValueError, match="bottom, side, top"):
        result.plot.wall_map("lid")


def test_the_map_of_a_part_holds_its_power(ball):
    result = mahlwerk.Case({**CASES["blades"], "run": {**CASES["blades"]["run"], "time": "0.05 s"}}).run()
    table = result.table("part_map")
    table = table[(table["side"] == "plus_y") & (table["area_m2"] > 0)]
    deep = result.plot.part_map("paddle", "plus_y", value="wear_depth_rate_m_per_s")
    assert np.nanmax(deep.collections[0].get_array()) == pytest.approx(table["wear_depth_rate_m_per_s"].max())
    ax = result.plot.part_map("paddle", "plus_y")
    drawn = np.ma.masked_invalid(np.ma.asarray(ax.collections[0].get_array()).ravel()).compressed()
    np.testing.assert_allclose(np.sort(drawn), np.sort(table["power_normal_W"] / table["area_m2"]))
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x (mm)", "z (mm)")
    with pytest.raises(ValueError, match="paddle"):
        result.plot.part_map("lid")
    with pytest.raises(ValueError, match="minus_x, minus_y"):
        result.plot.part_map("paddle", "up")


def test_the_trajectory_stays_in_the_jar(ball):
    ax = ball.run().plot.trajectory()
    path = np.concatenate(ax.collections[0].get_segments())
    assert np.abs(path[:, 0]).max() <= 6 - 4 + 0.01, "jar of 12 mm, ball of 8 mm"
    jar = ax.lines[0].get_data()
    assert np.abs(jar[0]).max() == pytest.approx(6, abs=0.01)
    with pytest.raises(ValueError, match="1 balls"):
        ball.run().plot.trajectory(5)


def test_sizes_are_those_of_the_table(example, ball):
    result = mahlwerk.Case(example("08-how-fine"), {"run.time": "0.05 s",
                                                        "run.replicates": 1}).run()
    ax = result.plot.sizes()
    assert ax.lines[1].get_ydata()[-1] == pytest.approx(1e6 * result.table("grinding")["d50_m"][-1])
    with pytest.raises(ValueError, match="grinding"):
        ball.run().plot.sizes()


def test_maps_and_curves_of_a_campaign_hold_its_values(ball):
    campaign = ball.sweep({"mill.frequency": ["10 Hz", "12 Hz", "15 Hz"],
                           "contact.restitution": [0.5, 0.9]}, "out")
    mesh = campaign.plot.map("mill.frequency", "contact.restitution", "collision_rate").collections[0]
    assert sorted(mesh.get_array().ravel()) == sorted(campaign.column("collision_rate"))
    ax = campaign.plot.curve("mill.frequency", "collision_rate")
    assert len(ax.containers) == 2 and "Hz" in ax.get_xlabel()
    drawn = np.concatenate([one.lines[0].get_ydata() for one in ax.containers])
    assert sorted(drawn) == sorted(campaign.column("collision_rate"))
