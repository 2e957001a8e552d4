# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The page of the Python interface: every public name of the package, by autodoc."""
import ast

from pages import HOME

SECTIONS = {
    "Cases": ["Case", "Check", "Origin"],
    "Commands as functions": ["run", "check", "new", "cite", "sweep", "fit", "optimise", "match", "compare",
                              "evolve_wear", "bond_test", "surrogate", "ask", "report", "export", "papers.run_paper",
                              "command"],
    "Measurements": ["measure.film", "measure.sound", "measure.power", "measure.jar", "measure.drop", "Measurement",
                     "Finding"],
    "Estimates": ["estimate", "Estimate", "Band", "Cause"],
    "Results": ["Result", "Quantity", "Influence", "Notice", "Citation", "open", "record_columns"],
    "Campaigns": ["Campaign", "SweptKey", "WearEvolution"],
    "Searches and comparisons": ["BondTest", "LargestBall", "Fit", "Optimum", "Match", "Comparison", "Surrogate", "Prediction"],
    "Plots": ["plots.ResultPlots", "plots.CampaignPlots"],
    "Catalogue and keys": ["catalogue", "describe", "list_keys", "list_units", "list_quantities", "CatalogueName",
                           "KeyInfo", "UnitInfo", "QuantityInfo"],
    "Errors": ["MahlwerkError", "InputError", "RunError", "Interrupted"],
}
ELSEWHERE = {"Fault"}  # of the compiled part


def public_names() -> set[str]:
    tree = ast.parse((HOME / "python" / "mahlwerk" / "__init__.py").read_text())
    for node in tree.body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return set(ast.literal_eval(node.value))
    raise SystemExit("python/mahlwerk/__init__.py has no __all__")


def page() -> str:
    listed = {name for names in SECTIONS.values() for name in names if "." not in name}
    if wrong := (public_names() - ELSEWHERE) ^ listed:
        raise SystemExit(f"docs/site/python_page.py: SECTIONS and mahlwerk.__all__ differ in {sorted(wrong)}")
    made = ["# Python interface\n",
            "The package `mahlwerk`: [installation](../install.md#python), [tutorial](../tutorial/index.md). "
            "A call does the same as the command of this name, with the same numbers.\n"]
    for title, names in SECTIONS.items():
        made.append(f"## {title}\n\n```{{eval-rst}}\n.. currentmodule:: mahlwerk\n")
        for name in names:
            kind = "class" if name.split(".")[-1][0].isupper() else "function"  # as the package names them
            members = "" if kind == "function" else "   :members:\n   :special-members: __getitem__\n"
            if title == "Errors":
                members += "   :show-inheritance:\n"
            elif members:
                members += "   :inherited-members: tuple, dict\n"  # those of bases of the package
            made.append(f".. auto{kind}:: {'mahlwerk.' * ('.' in name)}{name}\n{members}")
        made.append("```\n")
    made.append("An entry of `InputError.faults` is a `Fault`: `where`, `what`, `remedy` and `code`, a heading "
                "of [errors](../errors.md).\n")
    return "\n".join(made)
