# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Fits from Python: measurements as data frames and dicts, sections that replace those of a file."""
import pandas as pd
import pytest

import mahlwerk
from mahlwerk.case_source import without_section

from conftest import HOME

CASES = HOME / "tests" / "docs" / "cases"
OVER = {"breakage.f_mat": ["0.01 kg/J/m", "100 kg/J/m"]}


def test_a_fit_takes_a_file_a_frame_and_a_dict():
    case = mahlwerk.Case(CASES / "fit.toml", {"run.time": "0.2 s"})
    data = pd.read_csv(CASES / "fit.csv", skipinitialspace=True)
    file = case.fit(CASES / "fit.csv", "file")
    bare = case.without("fit")
    frame = bare.fit(data, "frame", over=OVER)
    columns = bare.fit({name: list(data[name]) for name in data}, "columns", over=OVER)
    assert file.parameters == frame.parameters == columns.parameters
    assert "breakage.f_mat = 0.1" in repr(file)
    with pytest.raises(mahlwerk.InputError, match="did you mean \"time\""):
        bare.fit({"tims": [1, 2]}, "wrong", over=OVER)
    with pytest.raises(TypeError, match="a CSV file, a data frame or a dict"):
        case.fit(None, "wrong")
    with pytest.raises(ValueError, match="time has 2, d50 has 1"):  # a value would be lost
        case.fit({"time": [1, 2], "d50": [3]}, "wrong")
    with pytest.raises(TypeError, match="the column time .* is a list"):
        case.fit({"time": 1}, "wrong")
    with pytest.raises(mahlwerk.InputError, match=r'case.without\("fit"\)'):
        case.fit(data, "wrong", over=OVER)


@pytest.mark.parametrize("text, left", [
    ("[run]\nx = 1\n[fit] # one\na = [\n  [1, 2],\n]\n[fit.more]\nb = 1\n[fitted]\nc = 1\n", "[run]\nx = 1\n[fitted]\nc = 1\n"),
    ("a = 1\n[fit]\nb = 2\n", "a = 1\n"), ("[fit]\n[[balls]]\nb = 2\n", "[[balls]]\nb = 2\n"), ("a = 1\n", "a = 1\n")])
def test_a_section_is_taken_from_a_text(text, left):
    assert without_section(text, "fit").split() == left.split()
