# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Plots with matplotlib. Each returns its Axes; `ax` draws into given ones."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Optional

from .public import Public
from .replay import outline, replay

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .campaign import Campaign
    from .result import Result

__all__ = ["CampaignPlots", "ResultPlots"]

ENERGIES = {"normal": "normal energy", "contact_point": "contact-point energy",
            "centre": "energy of the centres", "lost": "energy lost"}

DEPTHS = {"wear_depth_rate_m_per_s": "m/s"}  # columns of maps that are not summed over an area


def axes(ax: Optional[Axes], **options: Any) -> Axes:
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise ImportError("plots need matplotlib: install python3-matplotlib") from None
    return plt.subplots(layout="constrained", **options)[1]


def words(name: str) -> str:
    return name.replace("_", " ")


def unit_text(unit: str) -> str:
    """ "W" as " (W)"; units with a stroke as they are."""
    return "" if unit in ("", "1") else f" ({unit})"


def cells(table: Any, low: str, high: str, value: str) -> tuple[Any, Any, Any]:
    """Edges along and across of the cells of a surface, and their values, per area unless a depth."""
    import numpy as np

    a = np.unique(np.concatenate([table[low], table[high]]))
    b = np.unique(np.concatenate([table["across_low_m"], table["across_high_m"]]))
    grid = np.full((len(b) - 1, len(a) - 1), np.nan)
    over = np.where(table["area_m2"] > 0, 1 if value in DEPTHS else table["area_m2"], np.nan)
    grid[np.searchsorted(b, table["across_low_m"]), np.searchsorted(a, table[low])] = table[value] / over
    return a, b, grid


def draw_cells(ax: Axes, x: Any, y: Any, grid: Any, value: str) -> None:
    ax.grid(False)
    mesh = ax.pcolormesh(x, y, grid, cmap="viridis", rasterized=True)
    unit = DEPTHS.get(value) or ("1/(s m²)" if value == "rate_per_s" else value.rpartition("_")[2] + "/m²")
    name = re.sub(r"_(W|per_s|N_m_per_s|m_per_s)$", "", value)
    ax.figure.colorbar(mesh, ax=ax, label=f"{words(name)} ({unit})")


class ResultPlots(Public):
    """Plots of a result."""

    def __init__(self, result: Result):
        self._result = result

    def spectrum(self, *energies: str, ax: Optional[Axes] = None, per: str = "rate") -> Axes:
        """Collisions per second, or power, by energy. `energies` of "normal", "contact_point", "centre"
        and "lost" (default: normal and lost); `per` is "rate" or "power". Steps are the bins of the
        table "spectrum", per factor e of energy, so that areas are sums."""
        import numpy as np

        if per not in ("rate", "power"):
            raise ValueError(f'per is "rate" or "power", not {per!r}')
        table = self._result.table("spectrum")
        table = table[table["energy_low_J"] > 0]  # without the bin of what is too small to count
        ax = axes(ax)
        low, high = table["energy_low_J"], table["energy_high_J"]
        unit = "per_s" if per == "rate" else "W"
        for energy in energies or ("normal", "lost"):
            if energy not in ENERGIES:
                raise ValueError(f"there is no energy {energy!r}; use one of {', '.join(ENERGIES)}")
            height = table[f"{per}_{energy}_{unit}"] / np.log(high / low)
            x, y = steps(low, high, height)
            ax.plot(x, y, label=ENERGIES[energy], linewidth=1.2)
        ax.set_xscale("log")
        first, last = shown_bins(table, per, energies or ("normal", "lost"), unit)
        if len(table):
            ax.set_xlim(low[first], high[last])
        ax.set_ylim(bottom=0)
        ax.set_xlabel("energy of a collision (J)")
        ax.set_ylabel(("collisions per second" if per == "rate" else "power (W)")
                      + " per factor e of energy")
        ax.legend(frameon=False)
        return ax

    def wall_map(self, part: str = "side", *, ax: Optional[Axes] = None,
                 value: str = "power_normal_W") -> Axes:
        """Where the balls hit the wall: a column of the table "wall_map" per area. `part` is "side",
        "bottom" or "top"; `value` for instance "rate_per_s", "power_normal_W", "power_lost_W", or, of
        a case with [wear], "wear_depth_rate_m_per_s", which is no value per area."""
        import numpy as np

        table = self._result.table("wall_map")
        table = table[table["part"] == part]
        if not table.size:
            raise ValueError(f"the wall has no part {part!r}; it has "
                             + ", ".join(sorted(set(self._result.table("wall_map")["part"]))))
        flat = part == "side"
        ax = axes(ax, subplot_kw={} if flat else {"projection": "polar"})
        if (ax.name == "polar") == flat:
            raise ValueError(f"{part} needs {'plain' if flat else 'polar'} axes")
        a, b, grid = cells(table, "angle_low_rad", "angle_high_rad", value)
        draw_cells(ax, np.degrees(a) if flat else a, 1e3 * b, grid, value)
        if flat:
            ax.set_xlabel("angle about the axis (°)")
            ax.set_ylabel("height (mm)")
            ax.set_xticks(range(0, 361, 90))
        else:
            ax.set_title(f"{part}, radius in mm")
            ax.tick_params("y", labelcolor="white")
        return ax

    def part_map(self, part: str, side: str = "plus_z", *, ax: Optional[Axes] = None,
                 value: str = "power_normal_W") -> Axes:
        """Where the balls hit a part in the jar: a column of the table "part_map" per area, in the
        part's own axes. `part` is its name, `side` the direction that the surface faces ("minus_x" to
        "plus_z"), `value` as in wall_map()."""
        table = self._result.table("part_map")
        if part not in table["part"]:
            raise ValueError(f"there is no part {part!r}; there are "
                             + ", ".join(sorted(set(table["part"]))))
        table = table[table["part"] == part]
        if side not in table["side"]:
            raise ValueError(f"{part} has no surface {side!r}; it has "
                             + ", ".join(sorted(set(table["side"]))))
        ax = axes(ax)
        a, b, grid = cells(table[table["side"] == side], "along_low_m", "along_high_m", value)
        draw_cells(ax, 1e3 * a, 1e3 * b, grid, value)
        along, across = [axis for axis in "xyz" if axis != side[-1]]
        ax.set_xlabel(f"{along} (mm)")
        ax.set_ylabel(f"{across} (mm)")
        ax.set_aspect("equal")
        return ax

    def trajectory(self, *balls: int, ax: Optional[Axes] = None, plane: Optional[str] = None,
                   frame: str = "carrier") -> Axes:
        """Paths of balls relative to the jar's centre, from the frames of the report's replay (first
        replicate). `balls` count from 0; default: the first three. `frame` is "carrier" (axes that
        rotate with the disc of a planetary mill; in other mills those of the laboratory) or "jar" (the
        jar's own axes). `plane` is "xy", "xz" or "yz"; default: the one in which the balls move most.
        Brighter is faster."""
        import numpy as np
        from matplotlib.collections import LineCollection

        if frame not in ("carrier", "jar"):
            raise ValueError(f'frame is "carrier" or "jar", not {frame!r}')
        if plane is not None and plane not in ("xy", "xz", "yz"):
            raise ValueError(f'plane is "xy", "xz" or "yz", not {plane!r}')
        film = replay(self._result, frame)
        ax = axes(ax)
        count = film["positions"].shape[1]
        chosen = balls or tuple(range(min(3, count)))
        if not all(0 <= one < count for one in chosen):
            raise ValueError(f"the replay shows {count} balls, from 0 to {count - 1}")
        inside = film["positions"][:, list(chosen)].reshape(-1, 3)
        inside = inside[np.isfinite(inside).all(axis=1)]
        if not len(inside):
            raise ValueError("these balls are outside the jar in all frames of the replay")
        if plane is None:
            order = np.argsort(-np.ptp(inside, axis=0))[:2]
            plane = "".join("xyz"[k] for k in sorted(order))
        i, j = "xyz".index(plane[0]), "xyz".index(plane[1])
        for vertices in film["outlines"]:
            edges = outline(vertices, i, j)
            ax.plot(1e3 * edges[:, 0], 1e3 * edges[:, 1], color="0.5", linewidth=0.8)
        fastest = film["speeds"].max()
        for ball in chosen:
            path = 1e3 * film["positions"][:, ball][:, [i, j]]
            steps_inside = np.isfinite(path[:-1] + path[1:]).all(axis=1)
            lines = LineCollection(np.stack([path[:-1], path[1:]], axis=1)[steps_inside],
                                   cmap="viridis", linewidths=1.0)
            lines.set_array(film["speeds"][1:, ball][steps_inside])
            lines.set_clim(0, fastest)
            ax.add_collection(lines)
        ax.figure.colorbar(lines, ax=ax, label="speed relative to the jar's centre (m/s)")
        ax.autoscale_view()
        ax.set_aspect("equal")
        ax.set_xlabel(f"{plane[0]} (mm)")
        ax.set_ylabel(f"{plane[1]} (mm)")
        return ax

    def sizes(self, *, ax: Optional[Axes] = None) -> Axes:
        """D10, D50 and D90 of the powder over the milling time. Needs [grinding]."""
        if "grinding" not in self._result.tables:
            raise ValueError("the result has no sizes of a powder: the case needs [grinding]")
        table = self._result.table("grinding")
        ax = axes(ax)
        time, unit = time_axis(table["time_s"])
        for name, label in (("d90_m", "D90"), ("d50_m", "D50"), ("d10_m", "D10")):
            ax.plot(time, 1e6 * table[name], label=label)
        ax.set_yscale("log")
        ax.set_xlim(0, time.max())
        ax.set_xlabel(f"milling time ({unit})")
        ax.set_ylabel("particle size (µm)")
        ax.legend(frameon=False)
        return ax


class CampaignPlots(Public):
    """Plots of a campaign."""

    def __init__(self, campaign: Campaign):
        self._campaign = campaign

    def _label(self, name: str) -> str:
        return words(name) + unit_text(self._campaign.unit(name))

    def curve(self, x: str, quantity: str, *, ax: Optional[Axes] = None) -> Axes:
        """A quantity over a key, with its 95 % interval: a curve for each combination of the other
        keys."""
        import numpy as np

        campaign = self._campaign
        ax = axes(ax)
        column = campaign.column_name(quantity)
        half = campaign.quantities[quantity][3] if quantity in campaign.quantities else None
        x = campaign.key_of(x)
        others = [k for k in campaign.keys if k.key != x and not k.follows]
        groups: dict[tuple[Any, ...], list[int]] = {}
        for row, point in enumerate(campaign.table):
            groups.setdefault(tuple(point[k.column] for k in others), []).append(row)
        for values, rows in groups.items():
            part = campaign.table[rows]
            part = part[np.argsort(part[campaign.column_name(x)], kind="stable")]
            label = ", ".join(f"{k.key} = {v if isinstance(v, str) else format(v, '.4g')}"
                              + (f" {k.unit}" if k.unit not in ("", "1") else "")
                              for k, v in zip(others, values))
            error = None if half is None else np.nan_to_num(part[half])
            ax.errorbar(part[campaign.column_name(x)], part[column], yerr=error, marker="o",
                        markersize=4, capsize=2, linewidth=1.2, label=label or None)
        if others:
            ax.legend(frameon=False)
        ax.set_xlabel(self._label(x))
        ax.set_ylabel(self._label(quantity))
        return ax

    def map(self, x: str, y: str, quantity: str = "dissipated_power", *,
            ax: Optional[Axes] = None) -> Axes:
        """A quantity over two keys with numbers, as cells of colour; the mean where several points share
        a cell."""
        import numpy as np

        campaign = self._campaign
        ax = axes(ax)
        xs, i = np.unique(campaign.column(x), return_inverse=True)
        ys, j = np.unique(campaign.column(y), return_inverse=True)
        if xs.dtype.kind == "U" or ys.dtype.kind == "U":
            raise ValueError("a map needs two keys whose values are numbers")
        values = campaign.column(quantity)
        if values.dtype.kind == "U":
            raise ValueError(f"a map needs a quantity with numbers, and {quantity} has words")
        known = np.isfinite(values)
        total, count = np.zeros((2, len(ys), len(xs)))
        np.add.at(total, (j[known], i[known]), values[known])
        np.add.at(count, (j[known], i[known]), 1)
        with np.errstate(invalid="ignore"):
            mean = total / count
        mesh = ax.pcolormesh(cell_edges(xs), cell_edges(ys), mean, cmap="viridis", rasterized=True)
        ax.figure.colorbar(mesh, ax=ax, label=self._label(quantity))
        ax.set_xlabel(self._label(x))
        ax.set_ylabel(self._label(y))
        return ax


def steps(low: Any, high: Any, height: Any) -> tuple[Any, Any]:
    """The outline of a histogram; gaps between bins are at 0."""
    import numpy as np

    x: list[float] = []
    y: list[float] = []
    for a, b, h in zip(low, high, height):
        if not x or not np.isclose(a, x[-1], rtol=1e-6):
            if x:
                x.append(x[-1])
                y.append(0.0)
            x.append(a)
            y.append(0.0)
        x += [a, b]
        y += [h, h]
    return np.array(x + x[-1:]), np.array(y + [0.0] if y else y)


def shown_bins(table: Any, per: str, energies: Any, unit: str) -> tuple[int, int]:
    """First and last bin to show: those outside hold less than a thousandth of the sum each side."""
    import numpy as np

    first, last = len(table) - 1, 0
    for energy in energies:
        share = np.cumsum(table[f"{per}_{energy}_{unit}"])
        if share[-1] > 0:
            first = min(first, int(np.searchsorted(share, 0.001 * share[-1])))
            last = max(last, int(np.searchsorted(share, 0.999 * share[-1])))
    return min(first, last), max(first, last)


def time_axis(seconds: Any) -> tuple[Any, str]:
    longest = float(seconds.max()) if len(seconds) else 0.0
    for size, unit in ((3600.0, "h"), (60.0, "min")):
        if longest >= 2 * size:
            return seconds / size, unit
    return seconds, "s"


def cell_edges(centres: Any) -> Any:
    """Edges between neighbouring values."""
    import numpy as np

    if len(centres) == 1:
        half = 0.5 * abs(centres[0]) or 0.5
        return np.array([centres[0] - half, centres[0] + half])
    middle = 0.5 * (centres[1:] + centres[:-1])
    return np.concatenate([[2 * centres[0] - middle[0]], middle, [2 * centres[-1] - middle[-1]]])
