# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The replay in the page of a run: where the balls were, frame by frame."""

from __future__ import annotations

import base64
import json
import re
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .result import Result

OUTSIDE = -32768  # the three coordinates of a ball that is not in the jar


def replay(result: Result, frame: str) -> dict[str, Any]:
    """The frames of the replay: positions in m by time, ball and axis, NaN while a ball is outside
    the jar; speeds; outlines of the jar."""
    import numpy as np

    found = re.search(r'id="replay-data">(.*?)</script>', result.report, re.DOTALL)
    if not found:
        raise ValueError("the report has no replay: the run was too short, or it is a point of a "
                         "campaign, whose reports have none")
    data = json.loads(found[1])

    def numbers(text: str, kind: str) -> Any:
        return np.frombuffer(base64.b64decode(text), kind)

    frames, balls = len(data["times"]), data["count"]
    # The replay has axes parallel to those of the laboratory; its quaternions turn others into them.
    jar, axes = (numbers(data[name], "<f4").reshape(frames, 1, 4).astype(float)
                 for name in ("jar_turn", f"{frame}_turn"))
    stored = numbers(data["positions"], "<i2").reshape(frames, balls, 3)
    outside = (stored == OUTSIDE).all(axis=2, keepdims=True)
    positions = np.where(outside, np.nan, stored * data["position_scale"])
    meshes = [numbers(mesh["vertices"], "<f4").reshape(-1, 3) for mesh in data["meshes"]]
    return {"times": np.array(data["times"]), "positions": turned(positions, inverse(axes)),
            "speeds": numbers(data["speeds"], "<u2").reshape(frames, balls) * data["speed_scale"],
            "outlines": [turned(turned(mesh, jar[0]), inverse(axes[0])) for mesh in meshes]}


def turned(positions: Any, turn: Any) -> Any:
    """Positions turned by quaternions (x, y, z, w)."""
    import numpy as np

    axis, w = turn[..., :3], turn[..., 3:]
    across = 2 * np.cross(axis, positions)
    return positions + w * across + np.cross(axis, across)


def inverse(turn: Any) -> Any:
    return turn * [-1.0, -1.0, -1.0, 1.0]


def outline(vertices: Any, i: int, j: int) -> Any:
    """The convex hull of a mesh seen along an axis, closed."""
    import numpy as np

    points = sorted(set(map(tuple, np.round(vertices[:, [i, j]].astype(float), 7))))

    def half(ordered: Any) -> list[Any]:
        made: list[Any] = []
        for p in ordered:
            while len(made) > 1 and ((made[-1][0] - made[-2][0]) * (p[1] - made[-2][1])
                                     - (made[-1][1] - made[-2][1]) * (p[0] - made[-2][0])) <= 0:
                made.pop()
            made.append(p)
        return made[:-1]

    hull = half(points) + half(reversed(points))
    return np.array(hull + hull[:1])
