# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures of single balls: trajectories and snapshots, from the films of a campaign."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

from .lines import Points, Where
from .style import COLOURS, INK, SOFT

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Picture", "Pictures"]

BALL, GRAIN, FAST = "#D55E00", "#009E73", "#F0E442"  # red, green and yellow of Okabe and Ito


@dataclass
class Pictures:
    """What panels draw of a campaign: a picture for each point, or several if its replicates are in
    several states of motion."""

    campaign: str
    kind: str  #: "trajectories" or "snapshots"
    where: Where
    seen_from: str

    def pictures(self, points: Points) -> list[list[Picture]]:
        """By point. Points without frames are left out."""
        made = []
        for line in points.lines(self.where, "", ""):
            for spot in line.spots:
                film = film_of(spot.point.folder)
                if film is None or not any(one["times_s"] for one in film["replicates"]):
                    continue
                made.append([Picture(self, film, one, titled(line.others, one)) for one in film["replicates"]])
        return made


def film_of(folder: Optional[Path]) -> Optional[dict[str, Any]]:
    file = None if folder is None else folder / "film.json"
    if file is None or not file.is_file():
        return None
    return dict(json.loads(file.read_text(encoding="utf-8")))


def titled(others: str, replicate: dict[str, Any]) -> str:
    words = replicate["words"] + ("" if replicate["times_s"] else " (it has no frames)")
    return f"{others}: {words}" if others and words else others or words


@dataclass
class Picture:
    """One replicate of a point."""

    drawing: Pictures
    film: dict[str, Any]
    replicate: dict[str, Any]
    title: str

    @property
    def balls(self) -> list[dict[str, Any]]:
        return list(self.replicate["balls"])

    def places(self, ball: dict[str, Any]) -> tuple[list[float], list[float], list[float]]:
        """x, y in the plane of motion and the height above it, by frame [m]; NaN while the ball is not in the jar."""
        x, y, height = ([math.nan if a is None else a for a in one] for one in ball[self.drawing.seen_from])
        return x, y, height

    def last_in_jar(self) -> list[dict[str, Any]]:
        """The balls that are in the jar in the last frame."""
        return [ball for ball in self.balls if not math.isnan(self.places(ball)[0][-1])]

    # Numbers

    def csv(self) -> str:
        return self.trajectories_csv() if self.drawing.kind == "trajectories" else self.snapshot_csv()

    def trajectories_csv(self) -> str:
        text, number = "replicate,ball,time_s,x_m,y_m\n", self.replicate["replicate"]
        for ball in self.balls:
            if ball["grain"]:
                continue
            x, y, _ = self.places(ball)
            text += "".join(f"{number},{ball['number']},{t:.6g},{a:.6g},{b:.6g}\n"
                            for t, a, b in zip(self.replicate["times_s"], x, y) if not math.isnan(a))
        return text

    def snapshot_csv(self) -> str:
        text = "replicate,ball,kind,time_s,radius_m,x_m,y_m,height_m,speed_m_per_s\n"
        for ball in self.last_in_jar():
            x, y, height = self.places(ball)
            text += (f"{self.replicate['replicate']},{ball['number']},{'grain' if ball['grain'] else 'ball'},"
                     f"{self.replicate['times_s'][-1]:.6g},{ball['radius_m']:.6g},{x[-1]:.6g},{y[-1]:.6g},"
                     f"{height[-1]:.6g},{ball['speed_m_per_s']:.6g}\n")
        return text

    # Drawing

    def draw(self, ax: Axes) -> None:
        half = self.film["half_m"]
        if self.film["round"]:
            from matplotlib.patches import Circle
            ax.add_patch(Circle((0, 0), half, fill=False, edgecolor=SOFT, linewidth=1))
        if self.drawing.kind == "trajectories":
            self.draw_trajectories(ax)
        else:
            self.draw_balls(ax)
        ax.set_xlim(-1.03 * half, 1.03 * half)
        ax.set_ylim(-1.03 * half, 1.03 * half)
        ax.set_aspect("equal")
        ax.set_axis_off()
        draw_scale(ax, half)

    def draw_trajectories(self, ax: Axes) -> None:
        from matplotlib.patches import Circle
        balls = [ball for ball in self.balls if not ball["grain"]]
        for number, ball in enumerate(balls):
            colour = COLOURS[number % len(COLOURS)]
            x, y, _ = self.places(ball)
            if not x:
                continue
            ax.add_patch(Circle((x[-1], y[-1]), ball["radius_m"], facecolor=(*rgb(colour), 0.12),
                                edgecolor=(*rgb(colour), 0.7), linewidth=0.6))
            ax.plot(x, y, color=colour, linewidth=0.6, alpha=0.85)

    def draw_balls(self, ax: Axes) -> None:
        """Balls and grains seen along the normal of the plane of motion, the highest on top."""
        import itertools

        if not self.replicate["times_s"]:
            return
        shown = self.last_in_jar()
        speeds = [ball["speed_m_per_s"] for ball in shown if ball["grain"]]
        fast = math.sqrt(sum(v * v for v in speeds) / len(speeds)) if speeds else 0.0
        order = sorted(shown, key=lambda ball: self.places(ball)[2][-1])
        discs = [(b["radius_m"], self.places(b)[0][-1], self.places(b)[1][-1],
                  BALL if not b["grain"] else FAST if b["speed_m_per_s"] > fast else GRAIN) for b in order]
        for radius, alike in itertools.groupby(visible(discs), lambda disc: disc[0]):
            draw_discs(ax, radius, list(alike))


Disc = tuple[float, float, float, str]  # radius, x, y, colour


def visible(discs: list[Disc]) -> list[Disc]:
    """The discs without those that later ones hide: their middle, and points on two rings."""
    import numpy as np

    radius, x, y = (np.array([disc[i] for disc in discs]) for i in range(3))
    angles = np.linspace(0, 2 * np.pi, 16, endpoint=False)
    ring = np.concatenate([[0], 0.6 * np.exp(1j * angles), 0.99 * np.exp(1j * angles)])
    shown = []
    for i, disc in enumerate(discs):
        places = x[i] + 1j * y[i] + radius[i] * ring
        later = (x + 1j * y)[i + 1:]
        covered = (np.abs(places[:, None] - later[None, :]) < radius[None, i + 1:]).any(axis=1)
        if not covered.all():
            shown.append(disc)
    return shown


def draw_discs(ax: Axes, radius: float, discs: list[Disc]) -> None:
    """Discs of one radius, one on the other. The file has their form once."""
    from matplotlib.collections import PathCollection
    from matplotlib.path import Path as Outline
    from matplotlib.transforms import Affine2D, AffineDeltaTransform

    made = PathCollection([Outline.unit_circle()], offsets=[disc[1:3] for disc in discs],
                          offset_transform=ax.transData, facecolors=[disc[3] for disc in discs],
                          edgecolors="#404040", linewidths=0.25, clip_on=False)
    made.set_transform(Affine2D().scale(radius) + AffineDeltaTransform(ax.transData))
    ax.add_collection(made)


def rgb(colour: str) -> tuple[float, float, float]:
    from matplotlib.colors import to_rgb
    r, g, b = to_rgb(colour)
    return float(r), float(g), float(b)


def draw_scale(ax: Axes, half: float) -> None:
    """A round length below the picture."""
    most = 0.6 * half
    decade = 10.0 ** math.floor(math.log10(most))
    bar = max(m * decade for m in (1, 2, 5) if m * decade <= most)
    y = -1.16 * half
    ax.plot([-0.5 * bar, 0.5 * bar], [y, y], color=INK, linewidth=1, marker="|", markersize=4, clip_on=False)
    ax.annotate(f"{1e3 * bar:g} mm", (0.5 * bar, y), (4, 0), textcoords="offset points", va="center",
                annotation_clip=False)
