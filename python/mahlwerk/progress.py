# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Progress of long work: one line on a terminal, one output cell in a notebook."""

from __future__ import annotations

import contextlib
import html
import math
import sys
import time
from collections.abc import Callable
from typing import Any, Optional, Union

__all__ = ["Progress", "shown"]

Progress = Union[bool, None, Callable[[float, str], object]]


def in_notebook() -> bool:
    shell = sys.modules.get("IPython")
    if shell is None:
        return False
    return type(shell.get_ipython()).__name__ == "ZMQInteractiveShell"


class Terminal:
    """A line on stderr that is overwritten."""

    def __init__(self) -> None:
        self.width = 0

    def __call__(self, share: float, line: str) -> None:
        text = line if math.isnan(share) else f"{100 * share:3.0f} %  {line}"
        self.write("\r" + text.ljust(self.width))
        self.width = len(text)

    def write(self, text: str) -> None:
        with contextlib.suppress(OSError, ValueError):  # a closed terminal does not end the work
            sys.stderr.write(text)
            sys.stderr.flush()

    def close(self) -> None:
        if self.width:
            self.write("\r" + " " * self.width + "\r")


class Notebook:
    """A bar in the output of a cell, which disappears at the end."""

    def __init__(self) -> None:
        self.handle: Any = None
        self.last = 0.0

    def __call__(self, share: float, line: str) -> None:
        if time.monotonic() - self.last < 0.2:
            return
        self.last = time.monotonic()
        from IPython.display import HTML, display

        bar = "" if math.isnan(share) else f'<progress max="1" value="{share:.4f}"></progress> '
        page = HTML(f"<div>{bar}{html.escape(line)}</div>")
        if self.handle is None:
            self.handle = display(page, display_id=True)
        else:
            self.handle.update(page)

    def close(self) -> None:
        if self.handle is not None:
            from IPython.display import HTML

            self.handle.update(HTML(""))


class shown:
    """Context of a function `show(share, line)`, or None. `progress`: None shows progress in notebooks
    and on terminals, True always, False never; a function is called instead."""

    def __init__(self, progress: Progress):
        self.show: Optional[Callable[[float, str], object]] = None
        if callable(progress):
            self.show = progress
        elif progress is not False and in_notebook():
            self.show = Notebook()
        elif sys.stderr is not None and (progress or (progress is None and sys.stderr.isatty())):
            self.show = Terminal()

    def __enter__(self) -> Optional[Callable[[float, str], object]]:
        return self.show

    def __exit__(self, *_: object) -> None:
        if isinstance(self.show, (Terminal, Notebook)):
            self.show.close()
