# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Lets a browser set every equation of the built site by the copy of MathJax in it.

All equations stand on one page, which ends with two that are wrong: they must be reported, and nothing else.
"""
import html
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "viewer" / "test"))
from browser import Browser  # noqa: E402

MATH = re.compile(r'class="math notranslate nohighlight"[^>]*>\s*(\\[\[(].*?\\[\])])\s*</', re.S)
WRONG = [r"\(\unknowncommand{a}\)", r"\(\frac{a}{b\)"]
PAGE = """<!DOCTYPE html><meta charset="utf-8"><title>equations</title>
<script type="text/x-mathjax-config">
MathJax.Hub.Config({messageStyle: "none", showMathMenu: false, skipStartupTypeset: true});
window.said = [];
for (const what of ["TeX Jax - parse error", "TeX Jax - undefined control sequence", "Math Processing Error"])
  MathJax.Hub.Register.MessageHook(what, message => said.push(String(message[1]) + ": " + String(message[2] || "")));
MathJax.Hub.Queue(["Typeset", MathJax.Hub], () => { window.done = true; });
</script>
<script src="SITE/_static/mathjax/MathJax.js?config=TeX-AMS_SVG"></script>
"""


def equations(site: pathlib.Path) -> list[str]:
    """The equations of all pages, each once, as they stand in the pages."""
    found: dict[str, None] = {}
    for page in sorted(site.rglob("*.html")):
        found.update(dict.fromkeys(MATH.findall(page.read_text())))
    return list(found)


def check(site: pathlib.Path) -> list[str]:
    """Faults; none, with a remark, without a browser."""
    chromium, written = shutil.which("chromium"), equations(site)
    if len(written) < 400:
        return [f"only {len(written)} equations were found in the pages"]
    if not chromium:
        print("equations are not set: chromium is not installed (apt install chromium)")
        return []
    page = site.parent / "equations.html"
    rows = "\n".join(f"<p>{tex}</p>" for tex in [*written, *map(html.escape, WRONG)])
    page.write_text(PAGE.replace("SITE", site.name) + rows)
    browser = Browser(chromium)
    try:
        browser.open(str(page))
        if not browser.wait_for("window.done === true", 300):
            return ["MathJax did not end"]
        said = browser.ask("said")
        number = browser.ask("document.querySelectorAll('svg').length")
    finally:
        browser.close()
    print(f"{len(written)} equations were set")
    faults = [f"MathJax says of an equation: {one}" for one in said[:len(said) - len(WRONG)]]
    if len(said) < len(WRONG) or "unknowncommand" not in said[-2]:
        faults.append(f"the wrong equations were not reported: {said[-2:]}")
    if number < len(written):
        faults.append(f"{number} of {len(written)} equations became pictures")
    return faults
