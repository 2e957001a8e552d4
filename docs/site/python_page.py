# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The page of the Python interface: the modules of the package that exist, by autodoc."""
from pages import HOME

# module: title
MODULES = {
    "case": "Cases",
    "result": "Results",
    "campaign": "Campaigns",
    "searches": "Fit, optimum, match, comparison",
    "plots": "Plots",
    "plotting": "Plots",
    "commands": "Catalogue and descriptions",
    "errors": "Errors",
}


def page() -> str:
    folder = HOME / "python" / "mahlwerk"
    made = ["# Python interface\n",
            "`import mahlwerk` gives everything on this page except `mahlwerk.commands.command`. "
            "[Installation](../install.md#python), [tutorial](../tutorial/index.md).\n"]
    for module, title in MODULES.items():
        if (folder / (module + ".py")).exists():
            made.append(f"## {title}\n\n```{{eval-rst}}\n.. automodule:: mahlwerk.{module}\n   :members:\n"
                        "   :special-members: __getitem__\n```\n")
    return "\n".join(made)
