# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Executes a notebook: for each of its cells, what it prints, returns and draws.

As a program, `notebooks.py NOTEBOOK OUT` writes this into the file OUT, as JSON: a list for each cell, of outputs
{"kind": "text" | "html" | "svg" | "png", "data": text or base64, "words": what a picture shows}. A cell fails by its error or
a UserWarning. Jupyter is not needed: the cells use nothing of it.
"""
import ast
import base64
import contextlib
import hashlib
import importlib.util
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import traceback
import warnings

NEEDED = ("numpy", "pandas", "matplotlib")
LIMIT = 300  # [s] of one notebook
LARGEST_SVG = 200_000  # bytes; larger pictures are written as PNG
SETTINGS = {"svg.hashsalt": "mahlwerk", "savefig.dpi": 130}  # pictures are the same each time


def why_not(package: pathlib.Path) -> str:
    """Why notebooks cannot be executed with this folder of the Python package; "" if they can."""
    if not list(package.glob("mahlwerk/_core*.so")):
        return "the Python package was not built"
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    return f"{', '.join(missing)} was not installed" if missing else ""


def key(notebook: pathlib.Path, package: pathlib.Path) -> str:
    """Fingerprint of all that the outputs depend on."""
    made = hashlib.sha256()
    for file in [pathlib.Path(__file__), notebook, *sorted((package / "mahlwerk").rglob("*.py")),
                 *sorted(package.glob("mahlwerk/_core*.so"))]:
        made.update(hashlib.sha256(file.read_bytes()).digest())
    return made.hexdigest()[:20]


def outputs(notebook: pathlib.Path, package: pathlib.Path, kept: pathlib.Path) -> list[list[dict]]:
    """The outputs of each cell, from the folder `kept` if nothing has changed. Ends the program if a cell fails."""
    made = kept / f"{notebook.stem}-{key(notebook, package)}.json"
    if not made.exists():
        kept.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="mahlwerk-notebook-") as place:
            env = dict(os.environ, PYTHONPATH=str(package), MPLBACKEND="Agg", SOURCE_DATE_EPOCH="0", PYTHONHASHSEED="0")
            new = pathlib.Path(place) / "outputs.json"
            done = subprocess.run([sys.executable, "-B", __file__, notebook.resolve(), new], cwd=place, env=env, text=True,
                                  capture_output=True, timeout=LIMIT)
            if done.returncode:
                raise SystemExit(f"{notebook}: {done.stderr or f'ended with {done.returncode}'}")
            for old in kept.glob(f"{notebook.stem}-*.json"):
                old.unlink()
            made.write_text(new.read_text())
    return json.loads(made.read_text())


def shown(value) -> list[dict]:
    """The value of the last line of a cell, as Jupyter shows it."""
    if value is None:
        return []
    if make := getattr(value, "_repr_html_", None):
        return [{"kind": "html", "data": make()}]
    return [{"kind": "text", "data": repr(value)}]


def pictures() -> list[dict]:
    """The figures that are open; they are closed."""
    plt, made = sys.modules.get("matplotlib.pyplot"), []
    for number in plt.get_fignums() if plt else []:
        figure = plt.figure(number)
        words = "; ".join(f"{ax.get_ylabel()} over {ax.get_xlabel()}" for ax in figure.axes if ax.get_xlabel() and ax.get_ylabel())
        svg, png = io.BytesIO(), io.BytesIO()
        figure.savefig(svg, format="svg", metadata={"Date": None})
        if len(svg.getvalue()) > LARGEST_SVG:
            figure.savefig(png, format="png")
        kind, data = ("png", png) if png.getvalue() else ("svg", svg)
        made.append({"kind": kind, "data": base64.b64encode(data.getvalue()).decode(), "words": words or "Plot of this cell"})
        plt.close(figure)
    return made


def run_cell(source: str, name: str, names: dict) -> list[dict]:
    tree, value, printed = ast.parse(source, name), None, io.StringIO()
    last = tree.body[-1] if tree.body and not source.rstrip().endswith(";") else None
    with contextlib.redirect_stdout(printed):
        if isinstance(last, ast.Expr):
            exec(compile(ast.Module(tree.body[:-1], []), name, "exec"), names)
            value = eval(compile(ast.Expression(last.value), name, "eval"), names)
        else:
            exec(compile(tree, name, "exec"), names)
        drawn = pictures()
    said = [{"kind": "text", "data": printed.getvalue()}] if printed.getvalue() else []
    return said + ([] if drawn else shown(value)) + drawn


def execute(cells: list[dict]) -> list[list[dict]]:
    import matplotlib

    matplotlib.rcParams.update(SETTINGS)
    made, names = [], {"__name__": "__main__"}
    for number, cell in enumerate(cells, 1):
        made.append([])
        if cell["cell_type"] == "code":
            try:
                made[-1] = run_cell("".join(cell["source"]), f"cell {number}", names)
            except Exception:
                sys.exit(f"cell {number} fails:\n{''.join(cell['source'])}\n\n{traceback.format_exc(limit=-3)}")
    return made


if __name__ == "__main__":
    warnings.simplefilter("error", category=UserWarning)
    read = json.loads(pathlib.Path(sys.argv[1]).read_text())
    pathlib.Path(sys.argv[2]).write_text(json.dumps(execute(read["cells"])))
