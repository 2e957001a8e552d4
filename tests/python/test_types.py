# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
import ast
import inspect
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

import mahlwerk
from mahlwerk import _core

PACKAGE = Path(mahlwerk.__file__).parent


def test_the_stub_names_what_the_compiled_module_has():
    stub = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
    named = {one.name for one in stub.body if isinstance(one, (ast.FunctionDef, ast.ClassDef))} | {
        one.target.id for one in stub.body if isinstance(one, ast.AnnAssign)}
    assert named == {name for name in dir(_core) if not name.startswith("__")}
    for one in stub.body:
        if isinstance(one, ast.ClassDef):
            members = {f.name for f in one.body if isinstance(f, ast.FunctionDef)} - {"__init__"}
            real = {n for n in vars(getattr(_core, one.name)) if not n.startswith("_")}
            assert members == real, one.name


def test_everything_public_has_a_docstring_and_types():
    for name in mahlwerk.__all__:
        thing = getattr(mahlwerk, name)
        assert inspect.getdoc(thing), name
        members = vars(thing).items() if inspect.isclass(thing) else []
        for member, value in [(name, thing), *members]:
            if member.startswith("_") or not inspect.isfunction(value):
                continue
            assert inspect.signature(value).return_annotation is not inspect.Signature.empty, member


@pytest.mark.skipif(find_spec("mypy") is None, reason="mypy is not installed")
def test_mypy_finds_no_fault():
    ended = subprocess.run([sys.executable, "-m", "mypy", "--ignore-missing-imports", "--exclude", "/data/",
                            "--cache-dir", "/dev/null", str(PACKAGE)], capture_output=True,
                           text=True, check=False)
    assert ended.returncode == 0, ended.stdout
