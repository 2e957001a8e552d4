# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The notebooks have no outputs in the repository; their cells are executed when the site is built (docs.the_site_builds_...)."""
import base64
import json
import sys

import pytest

from conftest import HOME

sys.path.insert(0, str(HOME / "docs" / "site"))
import notebooks  # noqa: E402

FILES = sorted((HOME / "examples/python").glob("*.ipynb"))


def cells(*sources):
    return [{"cell_type": "code", "source": [source]} for source in sources]


def test_there_are_five_notebooks_without_outputs():
    assert len(FILES) == 5
    for file in FILES:
        for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
            assert not cell.get("outputs") and cell.get("execution_count") is None, file.name


def test_a_cell_shows_what_it_prints_returns_and_draws():
    printed, returned, frame, drawn = notebooks.execute(cells(
        "x = 2\nprint('x is', x)\nx;", "x + 1", "import pandas\npandas.DataFrame({'mill': [x]})",
        "import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.xlabel('time (s)')\nplt.ylabel('power (W)')"))
    assert printed == [{"kind": "text", "data": "x is 2\n"}]
    assert returned == [{"kind": "text", "data": "3"}]
    assert [one["kind"] for one in frame] == ["html"] and "<th>mill</th>" in frame[0]["data"]
    (picture,) = drawn
    assert picture["words"] == "power (W) over time (s)"
    assert b"<svg" in base64.b64decode(picture["data"])


@pytest.mark.parametrize("source", ["unknown", "import warnings\nwarnings.warn('clipped', UserWarning)"])
def test_a_cell_that_fails_is_named(source, tmp_path):
    file = tmp_path / "n.ipynb"
    file.write_text(json.dumps({"cells": cells("x = 1", source)}))
    with pytest.raises(SystemExit, match=r"n\.ipynb: cell 2 fails:"):
        notebooks.outputs(file, HOME / "python", tmp_path / "kept")


def test_without_the_compiled_package_notebooks_are_not_executed():
    assert notebooks.why_not(HOME / "python") == "the Python package was not built"
