#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/images/speed.svg, bars of the table "Against whom" of docs/performance.md.

    docs/images/speed_bars.py [--check]     --check: writes nothing, ends with 1 if the picture is another
"""
import html
import pathlib
import re
import sys

DOCS = pathlib.Path(__file__).resolve().parents[1]
LEFT, PER_UNIT, ROW = 330, 18, 26  # px


def plain(cell: str) -> str:
    """A cell without links and what stands in brackets."""
    cell = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", cell)
    return re.sub(r"\s*\([^()]*\)", "", cell).strip()


def bars() -> list[tuple[str, str, float, float]]:
    """Charge, other code, and the least and largest ratio where the table gives a span ('1.2 to 0.96'), else twice
    the median."""
    section = (DOCS / "performance.md").read_text().split("## Against whom\n", 1)[1].split("\n## ", 1)[0]
    found, others = [], ""
    for line in section.splitlines():
        cells = [c.strip() for c in line.split("|")[1:-1]]
        if len(cells) != 4 or cells[0] in ("charge", "---"):
            continue
        others = others if cells[1] == "the same" else plain(cells[1])
        names = [n for n in others.split(", ") if n != "best script"]
        for name, ratio in zip(names, re.split(r", (?=\d)", plain(cells[2]))):
            ends = sorted(float(x) for x in ratio.split(" to "))
            found.append((plain(cells[0]), name, ends[0], ends[-1]))
    return found


def picture() -> str:
    rows = bars()
    height = ROW * len(rows) + 46
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 700 {height}" font-family="sans-serif" font-size="13">',
             "<title>Speed of Mahlwerk over that of other codes</title>",
             "<style>text{fill:#333}.bar{fill:#2a7f9e}.one{stroke:#c33;stroke-width:1.5}"
             "@media(prefers-color-scheme:dark){text{fill:#ddd}.bar{fill:#4fb3d1}.one{stroke:#f77}}</style>"]
    said = ""
    for k, (charge, other, least, most) in enumerate(rows):
        y = 8 + ROW * k
        label = charge if charge != said else ""
        said = charge
        ratio = f"{most:g}" if least == most else f"{least:g} to {most:g}"
        lines += [f'<text x="{LEFT - 10}" y="{y + 14}" text-anchor="end">{html.escape(label)}</text>',
                  f'<rect class="bar" x="{LEFT}" y="{y}" width="{PER_UNIT * most:.1f}" height="18"/>',
                  f'<text x="{LEFT + PER_UNIT * most + 6:.1f}" y="{y + 14}">{ratio} × {html.escape(other)}</text>']
    bottom = 8 + ROW * len(rows)
    lines += [f'<line class="one" x1="{LEFT + PER_UNIT}" x2="{LEFT + PER_UNIT}" y1="2" y2="{bottom}"/>',
              f'<text x="{LEFT}" y="{bottom + 18}" font-size="12">ratio of speeds on one core; the line is 1</text>', "</svg>"]
    return "\n".join(lines) + "\n"


def main() -> int:
    file = DOCS / "images" / "speed.svg"
    if sys.argv[1:] != ["--check"]:
        file.write_text(picture())
    elif file.read_text() != picture():
        print(f"{file}: not that of the table in docs/performance.md; docs/images/speed_bars.py draws it")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
