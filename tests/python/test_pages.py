# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
import mahlwerk
from conftest import HOME


def test_the_page_of_a_run_is_its_report_in_a_frame_and_in_a_file(tmp_path):
    case = mahlwerk.Case(HOME / "examples/01-one-ball", {"run.time": "1 s", "run.replicates": 1})
    result = case.run(out=tmp_path / "run")
    page = result.page()
    assert str(page) == result.report == (tmp_path / "run/report.html").read_text(encoding="utf-8")
    assert page._repr_html_().startswith("<iframe srcdoc=")
    assert page.save(tmp_path / "saved.html").read_text(encoding="utf-8") == result.report


def test_the_page_of_a_campaign_is_that_of_its_folder(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text((HOME / "examples/01-one-ball/case.toml").read_text(encoding="utf-8")
                    + '\n[sweep]\n"mill.frequency" = ["10 Hz", "12 Hz"]\n', encoding="utf-8")
    campaign = mahlwerk.Case(file, {"run.time": "1 s", "run.replicates": 1}).sweep(out=tmp_path / "sweep")
    assert str(campaign.page()) == (tmp_path / "sweep/campaign.html").read_text(encoding="utf-8")
