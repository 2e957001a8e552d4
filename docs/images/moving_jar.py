#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/images/moving-jar.svg, the picture of the README that moves: the balls of moving-jar.toml, seen along the
axis of the jar from the disc of the mill.

    docs/images/moving_jar.py [PROGRAM]     (default: ./mahlwerk)
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EVERY, SLOWER, SCALE, CENTRE, FASTEST = 4, 15, 4800, (170, 170), 1.6  # frames; times; px/m; px; m/s
COLOURS = ((0x3b, 0x4c, 0xc0), (0x45, 0xb5, 0xaa), (0xf3, 0xc1, 0x3a), (0xd6, 0x3b, 0x2f))


def film(program: str) -> tuple[dict, dict]:
    """film.json and summary.json of the run."""
    with tempfile.TemporaryDirectory() as place:
        subprocess.run([program, "sweep", str(HERE / "moving-jar.toml"), "--films", "--quiet", "--out", place + "/o"],
                       check=True)
        run = next(pathlib.Path(place).glob("o/runs/*"))
        return json.loads((run / "film.json").read_text()), json.loads((run / "summary.json").read_text())


def colour(speed: float) -> str:
    at = min(speed / FASTEST, 0.999) * (len(COLOURS) - 1)
    a, b = COLOURS[int(at)], COLOURS[int(at) + 1]
    return "#" + "".join(f"{round(p + (q - p) * (at % 1)):02x}" for p, q in zip(a, b))


def values(numbers: list, form: str = "{:.1f}") -> str:
    return ";".join(form.format(x) for x in numbers)


def animated(attribute: str, list_of_values: str, seconds: float) -> str:
    return f'<animate attributeName="{attribute}" dur="{seconds:.2f}s" repeatCount="indefinite" values="{list_of_values}"/>'


def circle(ball: dict, times: list, seconds: float) -> str:
    x, y, _ = ball["carrier"]
    px = [CENTRE[0] + SCALE * a for a in x[::EVERY]]
    py = [CENTRE[1] - SCALE * a for a in y[::EVERY]]
    ends = list(zip(x, y, times))[::3 * EVERY]
    speeds = [math.hypot(b[0] - a[0], b[1] - a[1]) / (b[2] - a[2]) for a, b in zip(ends, ends[1:])]
    return (f'<circle class="ball" r="{SCALE * ball["radius_m"]:.1f}" cx="{px[0]:.1f}" cy="{py[0]:.1f}" fill="{colour(speeds[0])}">'
            + animated("cx", values(px), seconds) + animated("cy", values(py), seconds)
            + animated("fill", values([colour(s) for s in speeds], "{}"), seconds) + "</circle>")


def turned(ball: dict) -> float:
    """Degrees by which the jar turns from the first frame to the last, seen from the disc; clockwise in the picture."""
    angles = [math.atan2(cy, cx) - math.atan2(jy, jx)
              for cx, cy, jx, jy in zip(*ball["carrier"][:2], *ball["jar"][:2])]
    total = sum((b - a + math.pi) % (2 * math.pi) - math.pi for a, b in zip(angles, angles[1:]))
    return -math.degrees(total)


def main() -> int:
    film_json, summary = film(sys.argv[1] if len(sys.argv) > 1 else "./mahlwerk")
    shown = film_json["replicates"][0]
    times, balls = shown["times_s"], sorted(shown["balls"], key=lambda b: sum(b["carrier"][2]))
    seconds = SLOWER * (times[-1] - times[0])
    cx, cy = CENTRE
    inner = SCALE * film_json["half_m"]
    power = summary["drawn_power"]
    lines = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 480 340" font-family="sans-serif" font-size="13">',
        "<title>Fifty balls of 10 mm in a 125 ml jar of a planetary mill at 300 rpm, 15 times slower; colour: speed</title>",
        "<style>text{fill:#333}.jar{fill:none;stroke:#888;stroke-width:12}.mark{fill:#444}.ball{stroke:#0006}"
        "@media(prefers-color-scheme:dark){text{fill:#ddd}.jar{stroke:#777}.mark{fill:#ddd}}</style>",
        f'<circle class="jar" cx="{cx}" cy="{cy}" r="{inner + 6:.1f}"/>',
        "<g>" + "".join(f'<circle class="mark" cx="{cx}" cy="{cy - inner - 6:.1f}" r="4" transform="rotate({a} {cx} {cy})"/>'
                        for a in range(0, 360, 60)),
        f'<animateTransform attributeName="transform" type="rotate" dur="{seconds:.2f}s" repeatCount="indefinite" '
        f'from="0 {cx} {cy}" to="{turned(balls[0]):.1f} {cx} {cy}"/></g>',
        *(circle(b, times, seconds) for b in balls),
        f'<text x="340" y="40" font-weight="bold">planetary mill</text><text x="340" y="58">125 ml, 300 rpm</text>'
        f'<text x="340" y="76">50 balls of 10 mm</text>'
        f'<text x="340" y="104">{power["value"]:.1f} W drawn</text>'
        f'<text x="340" y="122">{summary["collision_rate_above_threshold"]["value"] / 1000:.0f} thousand hits/s</text>',
        '<defs><linearGradient id="speed" x1="0" y1="1" x2="0" y2="0">'
        + "".join(f'<stop offset="{k / 3:.2f}" stop-color="{colour(FASTEST * k / 3)}"/>' for k in range(4))
        + '</linearGradient></defs><rect x="340" y="160" width="12" height="120" fill="url(#speed)"/>'
        f'<text x="358" y="170">{FASTEST} m/s</text><text x="358" y="280">0</text>'
        f'<text x="340" y="306" font-size="11">{SLOWER} times slower</text>',
        "</svg>"]
    (HERE / "moving-jar.svg").write_text("\n".join(lines) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
