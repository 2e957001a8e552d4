# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The style of figures for print: 8 points, colours that the colour-blind tell apart, a white ground
that is read on a dark page too, fonts in the files."""

from __future__ import annotations

import re
from typing import Any

from .. import _core

__all__ = ["COLOURS", "COLUMN", "DASHES", "INK", "MARKERS", "MM", "PAGE", "SOFT", "compact", "mathtext", "style",
           "wrapped"]

MM = 1 / 25.4  # [inch]
COLUMN, PAGE = 90 * MM, 180 * MM
INK, SOFT = "#000000", "#666666"
# Okabe and Ito 2008, without the yellow that a line on white lacks contrast for.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = ("o", "^", "D", "v", "P", "X", "<")
DASHES: tuple[Any, ...] = ("-", (0, (5, 2)), (0, (1, 1.2)), (0, (5, 1.5, 1, 1.5)))
SIZE = 8  # [pt]


def style() -> dict[str, Any]:
    """Settings of matplotlib."""
    return {"font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans"], "font.size": SIZE,
            "mathtext.fontset": "dejavusans", "axes.titlesize": SIZE, "axes.labelsize": SIZE,
            "xtick.labelsize": SIZE, "ytick.labelsize": SIZE, "legend.fontsize": SIZE,
            "figure.titlesize": SIZE, "axes.linewidth": 0.6, "xtick.major.width": 0.6,
            "ytick.major.width": 0.6, "lines.linewidth": 1.1, "lines.markersize": 4,
            "errorbar.capsize": 2, "legend.frameon": False, "legend.handlelength": 1.8,
            "legend.labelspacing": 0.3, "legend.borderpad": 0, "axes.spines.top": False,
            "axes.spines.right": False, "axes.titlepad": 5, "figure.facecolor": "white",
            "savefig.facecolor": "white", "svg.fonttype": "path", "pdf.fonttype": 42,
            "svg.hashsalt": "mahlwerk", "axes.formatter.limits": (-4, 5), "axes.unicode_minus": True}


def mathtext(text: str) -> str:
    """Text with the marks of labels, "$E_{n}$" and "^{2}", for matplotlib."""
    text = re.sub(r"\$([^$_]+)_\{([^}]*)\}\$", r"$\1_{\\mathrm{\2}}$", text)
    return re.sub(r"\^\{([^}]*)\}", lambda found: "$^{" + found[1].replace("−", "-") + "}$", text)


def wrapped(text: str, letters: int) -> list[str]:
    """Lines of at most `letters` characters, of similar length. Marks of symbols do not count."""
    words = re.findall(r"(?:\$[^$]*\$|\S)+", text)
    lines = filled(words, letters)
    for width in range(letters - 1, 8, -1):
        closer = filled(words, width)
        if len(closer) > len(lines):
            break
        lines = closer
    return lines


def filled(words: list[str], letters: int) -> list[str]:
    lines: list[str] = []
    for word in words:
        if lines and len(_core.plain_text(f"{lines[-1]} {word}")) <= letters:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines


def compact(svg: str) -> str:
    """The SVG of matplotlib without its comments and line breaks, with places to a hundredth of a point."""
    svg = re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", svg, flags=re.S)
    svg = re.sub(r' d="([^"]*)"', lambda found: f' d="{hundredths(found[1])}"', svg)
    svg = re.sub(r' ([xy])="(-?[\d.]+)"', lambda found: f' {found[1]}="{hundredths(found[2])}"', svg)
    svg = with_classes(with_short_names(svg))
    svg = re.sub(r">\s+<", "><", re.sub(r"\s*\n\s*", " ", svg)).strip()
    return svg.replace('<g id="axes_', '\n<g id="axes_').replace('<g id="legend_', '\n<g id="legend_') + "\n"


def hundredths(text: str) -> str:
    return re.sub(r"-?\d+\.\d+", lambda found: f"{float(found[0]):.2f}".rstrip("0").rstrip("."), text)


def with_short_names(svg: str) -> str:
    """Shorter names of what the drawing defines and uses."""
    names = dict.fromkeys(re.findall(r'(?<= id=")([mpC][0-9a-f_]{8,})(?=")', svg))
    short = {name: f"{name[0]}{i}" for i, name in enumerate(names)}
    return re.sub(r'(?<=[#"])([mpC][0-9a-f_]{8,})(?=[")])', lambda found: short.get(found[1], found[1]), svg)


def with_classes(svg: str) -> str:
    """Styles that many elements have stand once at the top."""
    counts: dict[str, int] = {}
    for one in re.findall(r' style="([^"]*)"', svg):
        counts[one] = counts.get(one, 0) + 1
    names = {one: f"c{i}" for i, one in enumerate(one for one, count in counts.items() if count > 5)}
    rules = "".join(f".{name}{{{one}}}" for one, name in names.items())
    svg = re.sub(r' style="([^"]*)"',
                 lambda found: f' class="{names[found[1]]}"' if found[1] in names else found[0], svg)
    return svg.replace("</style>", rules + "</style>", 1)
