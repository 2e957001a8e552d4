# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Which Markdown files are pages of the site, under which names, and in which order."""
import pathlib

HOME = pathlib.Path(__file__).resolve().parents[2]

THEORY = ["bond", "mill-power", "mixing", "flow", "geometry", "kinematics", "event", "many-balls", "soft", "engine-choice", "elastic-plastic", "capillary",
          "hollow-balls", "bodies", "liquid", "charge", "statistics", "observe", "regimes", "lammps", "wear-heat", "powder",
          "bed-breakage", "kinetics", "sensors", "measure", "fit",
          "calibration", "campaigns", "sensitivity", "optimum"]
DEVELOPERS = ["case", "step", "adding", "tests", "releases"]
# Pages of the top folder of the repository.
TOP = ("CONTRIBUTING.md", "CHANGELOG.md", "GOVERNANCE.md", "CODE_OF_CONDUCT.md", "SECURITY.md", "SUPPORT.md")
TUTORIAL = ["first-run", "own-mill", "numbers", "sweep", "powder"]
# Caption of the navigation: pages as the site names them. A folder with * takes all of its pages.
NAVIGATION = {
    "Start": ["install", "tutorial/index", "features"],
    "How-to": ["howto/index", "howto/*"],
    "Use": ["cases", "cli", "measure", "formats", "campaigns", "cluster", "papers", "examples/index"],
    "Reference": ["reference/keys/index", "catalogue/index", "reference/python", "reference/cpp", "errors",
                  "warnings", "conventions", "glossary"],
    "Trust": ["limits", "validation", "verification", "performance", "publications/index"],
    "Theory": [f"theory/{name}" for name in THEORY],
    "Development": ["developers/index", "architecture", "contributing", "viewer", "governance", "code_of_conduct", "security", "support",
                    "changelog"],
}
# Index pages that list others: page, title, sentence, pages below.
LISTS = {
    "examples/index": ("Examples", "Each example is a case file with a page that explains its result.",
                       "examples/*"),
    "publications/index": ("Recomputed papers", "Two published simulations, recomputed figure by figure.",
                           "publications/*"),
}
HOWTO = ["settings", "machine", "product", "trust", "results", "computing",
         "planetary", "mixer", "drum", "vibration", "stirred", "own-jar", "browser", "notebook"]
# Pages below another page that is no list.
BELOW = {"validation": "validation/*", "catalogue/index": "catalogue/*",
         "reference/keys/index": "reference/keys/*",
         "tutorial/index": [f"tutorial/{name}" for name in TUTORIAL],
         "developers/index": [f"developers/{name}" for name in DEVELOPERS]}


def site_name(source: str) -> str:
    """Name of the page, without suffix, of a Markdown file or notebook of the repository; "" for no page."""
    path = pathlib.PurePosixPath(source)
    first, rest = path.parts[0], path.parts[1:]
    if first == "docs":
        return path.relative_to("docs").with_suffix("").as_posix()
    if source in TOP:
        return path.stem.lower()
    if path.suffix == ".ipynb":
        return path.with_suffix("").as_posix()
    if path.name == "README.md" and rest:
        folder = path.parent.as_posix()
        if folder == "catalogue":
            return "catalogue/index"
        if first == "papers":
            return "publications/" + path.parent.name
        return folder
    return ""


def sources() -> dict[str, str]:
    """Markdown file or notebook of the repository: name of its page."""
    found = [*(HOME / name for name in TOP), HOME / "viewer" / "README.md",
             HOME / "catalogue" / "README.md", *(HOME / "docs").rglob("*.md"),
             *(HOME / "examples").glob("*/README.md"),
             *(HOME / "examples").glob("*/*.ipynb"), *(HOME / "papers").glob("*/README.md"), *(HOME / "validation").glob("*/README.md")]
    names = sorted(f.relative_to(HOME).as_posix() for f in found)
    return {name: site_name(name) for name in names}
