# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The page of the C++ interface: doxygen reads the headers, breathe sets them."""
import pathlib
import subprocess

from pages import HOME

HEADERS = {
    "cases/read.hpp": "Reading cases",
    "campaign/run/run.hpp": "Running a case",
    "results/outcome.hpp": "Outcomes",
    "results/summary.hpp": "Summaries",
    "scene/collision.hpp": "Collision records",
    "scene/observer.hpp": "Observers",
    "report/report.hpp": "Report",
    "base/error.hpp": "Errors",
    "base/units.hpp": "Units",
}
DOXYFILE = """
PROJECT_NAME = Mahlwerk
INPUT = {inputs}
STRIP_FROM_PATH = {source}
OUTPUT_DIRECTORY = {out}
GENERATE_XML = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
HIDE_UNDOC_MEMBERS = NO
MACRO_EXPANSION = YES
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
JAVADOC_AUTOBRIEF = YES
MARKDOWN_SUPPORT = YES
INPUT_FILTER = "sed -E 's/ --([a-z])/ \\\\--\\1/g'"
"""


def doxygen(out: pathlib.Path) -> pathlib.Path:
    """Runs doxygen on the headers; returns the folder of its XML."""
    source = HOME / "src" / "mahlwerk"
    out.mkdir(parents=True, exist_ok=True)
    text = DOXYFILE.format(inputs=" ".join(str(source / h) for h in HEADERS), source=HOME / "src", out=out)
    done = subprocess.run(["doxygen", "-"], input=text, text=True, capture_output=True)
    if done.returncode or done.stderr.strip():
        raise SystemExit(f"doxygen:\n{done.stderr}")
    return out / "xml"


def page() -> str:
    made = ["# C++ interface\n",
            "The entry points of the library `mahlwerk`. The layers and their order: "
            "[architecture](../architecture.md).\n"]
    for header, title in HEADERS.items():
        made.append(f"## {title}\n\n`#include \"mahlwerk/{header}\"`\n\n```{{eval-rst}}\n"
                    f".. doxygenfile:: mahlwerk/{header}\n```\n")
    return "\n".join(made)
