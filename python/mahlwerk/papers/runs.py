# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""A paper at work: its campaigns are run or resumed, its checks judged, its files written."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional, Union

from .. import _core
from ..campaign import Campaign
from ..case import Case
from ..errors import InputError, RunError
from ..progress import Progress
from .computed import add_computed
from .figures import captions_markdown, made_figures
from .lines import points_of
from .page import PaperResult, checks_csv, checks_markdown, page, paper_data
from .paper import Paper, read_paper
from .pictures import Pictures
from .references import reference_faults
from .tables import markdown

__all__ = ["PaperJob", "Settings", "run_paper"]

OURS = ("paper.html", "paper.json", "claims.csv", "claims.md")  # none of them stays beside other results


@dataclass
class Settings:
    """How a paper is run."""

    changes: Mapping[str, Optional[str]] = field(default_factory=dict)  #: of the settings of every campaign
    force: bool = False  #: runs everything again
    threads: int = 0  #: 0: all cores
    progress: Any = None
    leave_out: tuple[str, ...] = ()  #: campaigns
    checkpoint: Optional[float] = None  #: [s] between two saves of the state of a run


class PaperJob:
    """A paper and the folder of its results. Raises InputError for what is wrong, before anything
    runs."""

    def __init__(self, folder: Path, out: Path, settings: Settings, paper: Optional[Paper] = None):
        self.paper = paper or read_paper(folder / "paper.py")
        self.paper.without(settings.leave_out)
        self.out, self.settings = out, settings
        self.cases: dict[str, Case] = {}
        faults: list[Any] = []
        for name in self.paper.campaigns:
            try:
                case = Case(folder / f"{name}.toml", settings.changes)
                faults += _core.campaign_faults(*case._source.parts())
                self.cases[name] = case
            except InputError as error:
                faults += error.faults
        faults = faults or reference_faults(self.paper, self.cases) or foreign(out)
        if faults:
            raise InputError(faults)

    def run(self) -> tuple[PaperResult, Optional[RunError]]:
        """Runs what is missing in the stores of the campaigns, then writes the files of the paper. A
        RunError of a campaign is returned; others are raised."""
        for name in OURS:
            (self.out / name).unlink(missing_ok=True)
        failed: Optional[RunError] = None
        filmed = {f.drawing.campaign for f in self.paper.figures
                  if isinstance(f.drawing, Pictures) and f.drawing.kind != "maps"}
        for name, case in self.cases.items():
            try:
                case.sweep(out=self.out / name, force=self.settings.force, threads=self.settings.threads,
                           films=name in filmed, checkpoint=self.settings.checkpoint,
                           progress=self.settings.progress)
            except RunError as error:
                failed = error
        return self.write(), failed

    def write(self) -> PaperResult:
        """Judges the results in the folder and writes the files of the paper."""
        campaigns = {name: Campaign(self.out / name) for name in self.cases}
        result = result_of(self.paper, campaigns, self.settings.changes)
        files: dict[str, bytes] = {}
        for figure in result.figures:
            files.update({f"figures/{name}": text.encode() for name, text in figure.tables.items()})
            if not figure.empty:
                files.update({f"figures/{name}": content for name, content in figure.files().items()})
        files["figures/captions.md"] = captions_markdown(result.figures).encode()
        for table, made in result.tables:
            files[f"tables/{table.name}.md"] = markdown(made).encode()
            files[f"tables/{table.name}.csv"] = made.csv.encode()
        svg = {Path(name).stem: content for name, content in files.items() if name.endswith(".svg")}
        files.update({"paper.json": (json.dumps(paper_data(result), indent=2) + "\n").encode(),
                      "claims.csv": checks_csv(result).encode(), "claims.md": checks_markdown(result).encode(),
                      "paper.html": page(result, svg).encode()})
        write_files(self.out, files)
        return result


def result_of(paper: Paper, campaigns: Mapping[str, Campaign], changes: Mapping[str, Optional[str]]) -> PaperResult:
    """The figures, tables and verdicts of a paper from campaigns that have run."""
    points = {name: points_of(campaign) for name, campaign in campaigns.items()}
    for name in points:
        add_computed([one for one in paper.computed if one.campaign == name], points[name])
    lines, boxes, notices = _core.notice_texts([os.fspath(c.folder) for c in campaigns.values()], "point")
    return PaperResult(
        paper, [check.rule.judge(points[check.rule.campaign]) for check in paper.checks],
        made_figures(paper, points),
        [(table, table.content.made(points[table.content.campaign])) for table in paper.tables],
        {name: seconds_of(campaign) for name, campaign in campaigns.items()},
        [f"{key} = {value}" if value is not None else f"without {key}" for key, value in changes.items()], lines, boxes, json.loads(notices))


def seconds_of(campaign: Campaign) -> float:
    _, rows = campaign._ask("SELECT total(cpu_seconds) FROM runs WHERE hash IN (SELECT hash FROM points)")
    return float(rows[0][0])


def foreign(out: Path) -> list[Any]:
    """A fault if the folder holds something else than the results of a paper."""
    if not out.exists() or not any(out.iterdir()):
        return []
    if any((out / name).exists() for name in OURS) or any(out.glob("*/campaign.sqlite")):
        return []
    return [_core.Fault(os.fspath(out), "the folder holds no results of a paper, and is not empty",
                        "choose another folder with --out", "result-exists")]


def write_file(file: Path, content: bytes) -> None:
    """Writes a file as a whole: another name first, then the change of the name."""
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=file.parent, prefix=".", suffix=".part", delete=False) as part:
            try:
                part.write(content)
                part.close()
                os.chmod(part.name, 0o644)
                os.replace(part.name, file)
            except BaseException:
                os.unlink(part.name)
                raise
    except OSError as error:
        raise InputError([_core.Fault(os.fspath(file), f"cannot be written: {error.strerror}",
                                      "free space, or choose another folder", "cannot-write")]) from None


def write_files(out: Path, files: Mapping[str, bytes]) -> None:
    """Writes files of a paper by their paths below the folder. Those that an earlier run wrote into
    figures and tables go, if they are not written again; files of others stay."""
    before = _core.listed_files(out)
    _core.list_files(out, list(files))
    for name, content in files.items():
        write_file(out / name, content)
    for name in before - set(files):
        if name.startswith(("figures/", "tables/")) and ".." not in name:
            (out / name).unlink(missing_ok=True)


def run_paper(folder: Union[str, os.PathLike[str]], out: Union[str, os.PathLike[str]],
              changes: Optional[Mapping[str, Optional[str]]] = None, *, force: bool = False, threads: int = 0,
              progress: Progress = None, leave_out: Iterable[str] = (),
              checkpoint: Optional[float] = None) -> PaperResult:
    """Runs the paper in a folder and writes its results, as `mahlwerk papers FOLDER --out OUT`.

    changes     of keys of every campaign, as --set
    force       runs everything again; without it only what is missing
    leave_out   campaigns whose figures, checks and tables are left out
    checkpoint  seconds between two saves of the state of a run

    Raises InputError; RunError if physics stopped a run.
    """
    settings = Settings(changes or {}, force, threads, progress, tuple(leave_out), checkpoint)
    result, failed = PaperJob(Path(folder), Path(out), settings).run()
    if failed is not None:
        raise failed
    return result
