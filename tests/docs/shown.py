# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Whether a command printed what a document shows of its output.

The lines of the block stand in the output one after the other, blank lines apart. Words are equal. A number lies within the
half-width that the document gives behind it (41.1 ± 1.2), any other within a tenth.
"""
import re

NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e-?\d+)?")
SHARE = 0.1  # of a number without a half-width
WIDTHS = 0.5  # of a half-width, which scatters itself


def alike(shown: str, found: str) -> bool:
    words = [" ".join(text.split()) for text in NUMBER.split(shown)]
    if words != [" ".join(text.split()) for text in NUMBER.split(found)]:
        return False
    wanted, made = ([float(one) for one in NUMBER.findall(text)] for text in (shown, found))
    for i, (want, have) in enumerate(zip(wanted, made)):
        half_width = words[i + 1] == "±" and wanted[i + 1]
        allowed = half_width or (WIDTHS if words[i] == "±" else SHARE) * want
        if abs(have - want) > allowed:
            return False
    return True


def fault(shown: list[str], output: str) -> str:
    """The first line that the output does not have in its place; "" if it has all."""
    found = [line for line in output.splitlines() if line.strip()]
    starts = [i for i, line in enumerate(found) if alike(shown[0], line)]
    if not starts:
        return f"the output has no line '{shown[0]}'"
    for offset, line in enumerate(shown):
        at = starts[0] + offset
        if at >= len(found) or not alike(line, found[at]):
            return f"the document shows '{line}', the output has '{found[at] if at < len(found) else ''}'"
    return ""


def self_test() -> None:
    table = "power   41.1 ± 1.2 mW   40 to 66 mW\nhits 137 ± 9 /s\n"
    for shown, good in (("power 41.1 ± 1.2 mW  40 to 66 mW", True), ("power 40.0 ± 1.2 mW  40 to 66 mW", True),
                        ("power 39.8 ± 1.2 mW  40 to 66 mW", False), ("power 41.1 ± 1.2 mW  40 to 80 mW", False),
                        ("power 41.1 ± 0.5 mW  40 to 66 mW", False), ("power 41.1 ± 1.2 W  40 to 66 mW", False),
                        ("hits 137 ± 9 /s", True), ("loss 137 ± 9 /s", False)):
        assert (fault([shown], table) == "") == good, shown
    assert fault(["power 41.1 ± 1.2 mW 40 to 66 mW", "other"], table)
