# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Papers and sets of measured data: campaigns, figures, tables and checks of statements.

A folder with a paper.py, as those of papers/ and validation/, is run by `mahlwerk papers FOLDER`."""

from __future__ import annotations

from .paper import Paper, PaperCampaign
from .runs import run_paper
from .verdict import Verdict

__all__ = ["Paper", "PaperCampaign", "Verdict", "run_paper"]
