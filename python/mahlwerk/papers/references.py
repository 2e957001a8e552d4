# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a paper asks of its campaigns, checked before any of them runs."""

from __future__ import annotations

import difflib
from typing import Any, Optional

from .. import _core
from ..case import Case
from .captures import CapturesInBounds, has_bounds
from .curves import Curve
from .lines import Where, same_value
from .measured import Agreement, Measurement
from .paper import Paper
from .tables import CapturedTable

__all__ = ["reference_faults"]


class References:
    """The references of one figure, check or table to its campaign."""

    def __init__(self, line: str, name: str, case: Case, faults: list[Any]):
        self.line, self.name, self.case, self.faults = line, name, case, faults
        self.keys = {key: (values, spans) for key, values, spans in case._resolved.swept_keys()}
        self.units = dict(case._resolved.quantities())

    def fault(self, what: str, remedy: str, code: str) -> None:
        self.faults.append(_core.Fault(self.line, what, remedy, code))

    def key(self, name: str) -> bool:
        if name and name not in self.keys:
            self.fault(f"{self.name}.toml does not vary {name}",
                       f"name a key of its [sweep], or put {name} there", "paper-unknown-key")
        return name in self.keys

    def value(self, key: str, text: str) -> None:
        if not text or not self.key(key):
            return
        values, spans = self.keys[key]
        if not spans and not any(same_value(v, text) for v in values):
            self.fault(f"{key} does not take the value {text} in {self.name}.toml",
                       "its values are " + ", ".join(values), "paper-unknown-value")

    def where(self, where: Where) -> None:
        for key, values in where.items():
            for value in values:
                self.value(key, value)

    def quantity(self, name: str) -> None:
        if not name or name in self.units:
            return
        near = difflib.get_close_matches(name, self.units, n=1)
        self.fault(f"a result of {self.name}.toml has no quantity {name}",
                   f"do you mean {near[0]}?" if near else "docs/formats.md lists them",
                   "paper-unknown-quantity")

    def computed(self, name: str) -> None:
        """The paper computes no quantity that the results have."""
        if name in self.units:
            self.fault(f"a result of {self.name}.toml has a quantity {name} already", "give yours another name",
                       "bad-paper")

    def capture(self) -> None:
        """The campaign has captures whose bounds are known."""
        if not has_bounds(self.case):
            self.fault(f"{self.name}.toml has no captures with known bounds",
                       'give it [capture] model = "barrios" and a cylinder', "paper-no-capture")

    def measured(self, measured: Measurement, quantity: str, against: str, relative_to: str) -> None:
        """The values are quantities of that dimension at points of the campaign."""
        unit = "" if relative_to else self.units.get(quantity, "")
        for value in measured.values:
            if bool(against) != bool(value.at):
                self.fault(f'the measured values "{measured.name}" and the check do not both have a key',
                           "give `against` and a value of this key in each row, or neither",
                           "paper-unknown-measurement")
            self.value(against, value.at)
            self.in_unit(value, unit, quantity)

    def drawn(self, measured: Measurement, quantity: str) -> None:
        """The values are numbers on both axes of a figure."""
        for value in measured.values:
            self.in_unit(value, self.units.get(quantity, ""), quantity)
            try:
                _core.si_value(value.at)
            except ValueError as error:
                self.fault(f'the measured values "{measured.name}" have no place on the axis: {error}',
                           "draw only values against a number", "bad-quantity")

    def in_unit(self, value: Any, unit: str, quantity: str) -> None:
        try:
            value.numbers(unit)
        except ValueError as error:
            self.fault(str(error), f"{quantity} is in {unit or '1'}", "bad-quantity")

    def band(self, curve: Curve) -> None:
        for name in curve.band_over:
            if name == curve.against:
                self.fault(f"the band is over {name}, which is the axis of the figure",
                           "name other keys in `band_over`", "paper-unknown-key")
            else:
                self.key(name)
        for name, text in curve.nominal.items():
            if name not in curve.band_over:
                self.fault(f"`nominal` gives {name}, which is not in `band_over`",
                           "add it to `band_over`, or remove it", "paper-unknown-key")
            else:
                self.value(name, text)


def reference_faults(paper: Paper, cases: dict[str, Case]) -> list[Any]:
    """References to keys, values or quantities that the campaigns do not have."""
    faults: list[Any] = []

    def references(line: str, campaign: str) -> References:
        made = References(line, campaign, cases[campaign], faults)
        made.units.update({one.name: one.unit for one in paper.computed if one.campaign == campaign})
        return made

    for one in paper.computed:
        if one.campaign in cases:
            References(one.line, one.campaign, cases[one.campaign], faults).computed(one.name)

    for figure in paper.figures:
        drawing = figure.drawing
        asked = references(figure.line, drawing.campaign)
        asked.where(drawing.where)
        if isinstance(drawing, Curve):
            curve(asked, drawing)
    for check in paper.checks:
        rule = check.rule
        asked = references(check.line, rule.campaign)
        asked.key(rule.against)
        asked.where(rule.where)
        for value in rule.values():
            asked.value(rule.against, value)
        asked.quantity(rule.quantity)
        if isinstance(rule, Agreement):
            asked.measured(rule.measured, rule.quantity, rule.against, rule.relative_to)
        if isinstance(rule, CapturesInBounds):
            asked.capture()
    for table in paper.tables:
        content = table.content
        asked = references(table.line, content.campaign)
        asked.key(content.against)
        asked.where(content.where)
        asked.quantity(content.quantity)
        if isinstance(content, CapturedTable):
            asked.capture()
    return faults


def curve(asked: References, drawing: Curve) -> None:
    asked.key(drawing.against)
    asked.quantity(drawing.quantity)
    measured: Optional[Measurement] = drawing.measured
    if measured is not None:
        asked.drawn(measured, drawing.quantity)
    asked.band(drawing)
