# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
import json
import warnings

import matplotlib.pyplot as plt
import pytest

from conftest import HOME

NOTEBOOKS = sorted((HOME / "examples/python").glob("*.ipynb"))


def test_there_are_five_notebooks_without_outputs():
    assert len(NOTEBOOKS) == 5
    for file in NOTEBOOKS:
        for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
            assert not cell.get("outputs") and cell.get("execution_count") is None, file.name


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_every_cell_of_a_notebook_works(file):
    names = {"__name__": "__main__"}
    with warnings.catch_warnings():
        warnings.simplefilter("error", category=UserWarning)
        for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
            if cell["cell_type"] == "code":
                exec(compile("".join(cell["source"]), file.name, "exec"), names)
    plt.close("all")
