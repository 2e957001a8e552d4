# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The figures of a paper: panels with letters, captions, and their files."""

from __future__ import annotations

import io
import itertools
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Union

from .curves import Plot
from .pictures import Picture, Pictures
from .style import COLUMN, MM, PAGE, compact, style, wrapped

if TYPE_CHECKING:
    from .lines import Points
    from .paper import Figure, Paper

__all__ = ["MadeFigure", "made_figures"]

LETTERS_OF_PLOT = 44  # characters in a line above or below a plot
LETTERS_OF_PICTURE = {3: 34, 4: 25, 5: 20}  # above a picture, by the pictures in a row
AXES, LABELS, LINE = 44 * MM, 13 * MM, 3.7 * MM  # heights: of axes, of the label of x, of a line of text
TRAJECTORIES = (" Trajectories are those of the centres of the balls, each in its colour; discs are the balls "
                "at the end, the circle is the wall of the jar.")


def parsed(number: str) -> tuple[str, list[str]]:
    """A number of the paper, "7b, c": its stem "7" and its letters."""
    found = re.match(r"(.*\d)([^\d]*)$", number)
    if not found or re.search(r"[a-zA-Z]{2}", found[2]):
        return number, []
    return found[1], re.findall(r"[a-zA-Z]", found[2])


@dataclass
class Panel:
    content: Union[Plot, Picture]
    title: str
    letter: str = ""

    @property
    def heading(self) -> str:
        return f"{self.letter}  {self.title}" if self.letter else self.title


@dataclass
class Section:
    """What one call of `figure` draws: the panels of each point."""

    figure: Figure
    letters: list[str]  #: that the paper's number gives
    points: list[list[Panel]]

    @property
    def is_plot(self) -> bool:
        return not isinstance(self.figure.drawing, Pictures)

    @property
    def panels(self) -> list[Panel]:
        return [panel for point in self.points for panel in point]


@dataclass
class MadeFigure:
    """A figure with all its panels."""

    file: str  #: name without ending: "figure-6"
    number: str  #: of the paper: "6"
    caption: str
    tables: dict[str, str]  #: the drawn numbers: "figure-6a.csv" and its text
    sections: list[Section] = field(repr=False)

    @property
    def empty(self) -> bool:
        """Whether nothing was recorded that it could draw."""
        return not any(section.points for section in self.sections)

    def files(self) -> dict[str, bytes]:
        """The figure as SVG, PDF and PNG."""
        import matplotlib

        with matplotlib.rc_context(style()):
            drawn = sheet(rows_of(self.sections))
            options: dict[str, dict[str, Any]] = {
                "svg": {"metadata": {"Date": None, "Creator": "Mahlwerk", "Title": f"Figure {self.number}"}},
                "pdf": {"metadata": {"CreationDate": None, "Creator": "Mahlwerk"}}, "png": {"dpi": 300}}
            made = {}
            for ending, how in options.items():
                out = io.BytesIO()
                drawn.savefig(out, format=ending, **{"dpi": 300, **how})
                made[f"{self.file}.{ending}"] = out.getvalue()
        made[f"{self.file}.svg"] = compact(made[f"{self.file}.svg"].decode()).encode()
        return made


def made_figures(paper: Paper, points: dict[str, Points]) -> list[MadeFigure]:
    """The figures in the order of their first panels."""
    by_number: dict[str, list[Section]] = {}
    for figure in paper.figures:
        stem, letters = parsed(figure.number)
        by_number.setdefault(stem, []).append(section_of(figure, letters, points[figure.drawing.campaign]))
    used: set[str] = set()
    made = []
    for stem, sections in by_number.items():
        give_letters(sections)
        file = file_of(stem, used)
        tables = {f"{file}{panel.letter}.csv": panel.content.csv()
                  for section in sections for panel in section.panels}
        made.append(MadeFigure(file, stem, caption_of(sections), tables, sections))
    return made


def section_of(figure: Figure, letters: list[str], points: Points) -> Section:
    if isinstance(figure.drawing, Pictures):
        pictures = figure.drawing.pictures(points)
        return Section(figure, letters, [[Panel(one, one.title) for one in point] for point in pictures])
    return Section(figure, letters, [[Panel(figure.drawing.plot(points), figure.title)]])


def letter(i: int) -> str:
    """The i-th letter of the alphabet; after z: aa, ab."""
    last = chr(ord("a") + i % 26)
    return last if i < 26 else letter(i // 26 - 1) + last


def give_letters(sections: list[Section]) -> None:
    """Letters of the paper's number, else the next ones in alphabetical order. Panels of one point have
    its letter and a number. A single panel without a letter of the paper has none."""
    used = {one for section in sections for one in section.letters}
    if sum(len(section.panels) for section in sections) == 1 and not used:
        return
    free = (one for one in map(letter, range(26 * 27)) if one not in used)
    for section in sections:
        for i, point in enumerate(section.points):
            if len(section.letters) == len(section.points):
                own = section.letters[i]
            elif section.letters:
                own = f"{section.letters[0]}{i + 1}"
            else:
                own = next(free)
            for k, panel in enumerate(point):
                panel.letter = own if len(point) == 1 else f"{own}{'-' if len(own) > 1 else ''}{k + 1}"


def ending_in_stop(text: str) -> str:
    return text if not text or text.endswith(".") else text + "."


def caption_of(sections: list[Section]) -> str:
    """ "a: title of its section. b, c: ..." with the texts below the figure, each once."""
    parts = []
    for section in sections:
        letters = ", ".join(filter(None, (panel.letter for panel in section.panels)))
        parts.append((f"{letters}: " if letters else "") + ending_in_stop(section.figure.title))
    caption = " ".join(parts)
    if any(not s.is_plot and s.points and s.panels[0].content.drawing.kind == "trajectories"  # type: ignore
           for s in sections):
        caption += TRAJECTORIES
    abouts = dict.fromkeys(ending_in_stop(section.figure.about) for section in sections)
    return caption + "".join(f" {about}" for about in abouts if about)


def file_of(stem: str, used: set[str]) -> str:
    name = "figure-" + re.sub(r"[^A-Za-z0-9_-]", "-", stem)
    file, i = name, 2
    while file in used:
        file, i = f"{name}-{i}", i + 1
    used.add(file)
    return file


# Layout


@dataclass
class Row:
    """Panels side by side."""

    panels: list[Panel]
    columns: int
    height: float  # [inch]
    title: str = ""


def rows_of(sections: list[Section]) -> list[Row]:
    """Plots of successive sections share rows of two; pictures have rows of their own."""
    rows: list[Row] = []
    most = max((len(section.panels) for section in sections if not section.is_plot), default=0)
    columns = min(max(most, 3), 5)
    for is_plot, group in itertools.groupby(sections, lambda section: section.is_plot):
        if is_plot:
            panels = [panel for section in group for panel in section.panels]
            alone = len(panels) == 1 and all(section.is_plot for section in sections)
            rows += rows_of_plots(panels, 1 if alone else 2)
        else:
            rows += [row for section in group for row in rows_of_pictures(section, columns)]
    return rows


def rows_of_pictures(section: Section, columns: int) -> list[Row]:
    letters = LETTERS_OF_PICTURE[columns]
    rows = []
    for i in range(0, len(section.panels), columns):
        panels = section.panels[i:i + columns]
        lines = max(len(wrapped(panel.heading, letters)) for panel in panels)
        height = PAGE / columns + LINE * (lines + 1) + 3 * MM
        title = section.figure.title if i == 0 else ""
        rows.append(Row(panels, columns, height + (LINE * 1.6 if title else 0), title))
    return rows


def rows_of_plots(panels: list[Panel], columns: int) -> list[Row]:
    rows = []
    for i in range(0, len(panels), columns):
        part = panels[i:i + columns]
        lines = max(panel.content.entries(LETTERS_OF_PLOT) for panel in part)  # type: ignore[union-attr]
        titles = max(len(wrapped(panel.heading, LETTERS_OF_PLOT)) for panel in part)
        rows.append(Row(part, columns, AXES + LABELS + LINE * (lines + titles)))
    return rows


def sheet(rows: list[Row]) -> Any:
    """The figure: 90 mm wide with one column, else 180 mm."""
    from matplotlib.figure import Figure as Sheet

    width = COLUMN if all(row.columns == 1 for row in rows) else PAGE
    fig = Sheet(figsize=(width, sum(row.height for row in rows)), layout="constrained")
    parts = fig.subfigures(len(rows), 1, squeeze=False, height_ratios=[row.height for row in rows])
    for part, row in zip(parts[:, 0], rows):
        if row.title:
            part.suptitle(row.title, x=0.01, ha="left", fontweight="bold")
        axes = part.subplots(1, row.columns, squeeze=False)[0]
        for ax in axes[len(row.panels):]:
            ax.set_visible(False)
        for ax, panel in zip(axes, row.panels):
            draw_panel(ax, panel, fig, row.columns)
    return fig


def draw_panel(ax: Any, panel: Panel, fig: Any, columns: int) -> None:
    if isinstance(panel.content, Plot):
        panel.content.draw(ax, LETTERS_OF_PLOT)
        legend_below(ax, panel.content.note, fig)
        letters = LETTERS_OF_PLOT
    else:
        panel.content.draw(ax)
        letters = LETTERS_OF_PICTURE[columns]
    title = "\n".join(wrapped(panel.heading, letters))
    if panel.letter:
        title = title.replace(panel.letter, "$\\bf{" + panel.letter + "}$", 1)
    ax.set_title(title, loc="left")


def legend_below(ax: Any, note: str, fig: Any) -> None:
    """The legend below the label of x, where it covers no data; a note ends it."""
    from matplotlib.lines import Line2D
    from matplotlib.transforms import ScaledTranslation

    handles, labels = ax.get_legend_handles_labels()
    if note:
        handles.append(Line2D([], [], linestyle="none"))
        labels.append("\n".join(wrapped(note, LETTERS_OF_PLOT)))
    if not handles:
        return
    below = ax.transAxes + ScaledTranslation(0, -0.42, fig.dpi_scale_trans)
    ax.legend(handles, labels, loc="upper left", bbox_to_anchor=(-0.02, 0.0), bbox_transform=below)


def captions_markdown(figures: list[MadeFigure]) -> str:
    return "\n".join(f"**Figure {one.number}.** {one.caption}\n" for one in figures if not one.empty)
