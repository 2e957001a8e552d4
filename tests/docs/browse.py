# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Lets a browser open the built site from disk, as a reader does: the search finds a page and shows a snippet of it, and on a
narrow screen wide tables scroll inside their box, with columns that can be read."""
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "viewer" / "test"))
from browser import Browser  # noqa: E402

NARROW = 420  # px
LEAST = {10: 90, 60: 200}  # px, least width of a cell with more characters than these, in tables of three and more columns
WITH_TABLES = ("cases", "catalogue/mills", "catalogue/materials", "validation", "performance", "formats", "reference/keys/mill")
LARGEST_SNIPPETS = 2_500_000  # bytes
OVERFLOWING = f"""[...document.querySelectorAll("article table")].filter(table => {{
  const box = table.closest(".table-wrapper, .output");
  return box === null ? table.getBoundingClientRect().right > innerWidth + 1
                      : box.getBoundingClientRect().right > innerWidth + 1;
}}).length"""
NARROW_CELLS = """[...document.querySelectorAll("article table.docutils td")].filter(cell =>
  cell.parentElement.children.length > 2 && cell.textContent.trim().length > %d && cell.getBoundingClientRect().width < %d).length"""


def check_search(browser: Browser, site: pathlib.Path) -> list[str]:
    browser.open(str(site / "search.html?q=restitution"))
    if not browser.wait_for("document.querySelectorAll('#search-results li p.context').length > 3", 60):
        return ["the search shows no snippets when the site is opened from disk"]
    snippet = browser.ask("document.querySelector('#search-results li p.context').textContent")
    faults = [f"the search from disk: {fault}" for fault in browser.faults]
    return faults if "restitution" in snippet.lower() else [*faults, f"the first snippet has no such word: {snippet}"]


def check_tables(browser: Browser, site: pathlib.Path) -> list[str]:
    faults = []
    browser.call("Emulation.setDeviceMetricsOverride", width=NARROW, height=900, deviceScaleFactor=1, mobile=True)
    for name in WITH_TABLES:
        browser.open(str(site / f"{name}.html"))
        if (width := browser.ask("document.documentElement.scrollWidth")) > NARROW:
            faults.append(f"{name} is {width} px wide on a screen of {NARROW} px")
        if number := browser.ask(OVERFLOWING):
            faults.append(f"{name}: {number} tables leave the screen of {NARROW} px")
        for length, least in LEAST.items():
            if number := browser.ask(NARROW_CELLS % (length, least)):
                faults.append(f"{name}: {number} cells of more than {length} characters are narrower than {least} px")
    return faults


def check(site: pathlib.Path) -> list[str]:
    """Faults; none, with a remark, without a browser."""
    size = (site / "_static" / "snippets.js").stat().st_size
    faults = [f"snippets.js has {size} bytes"] if size > LARGEST_SNIPPETS else []
    if not (chromium := shutil.which("chromium")):
        print("the site is not opened: chromium is not installed (apt install chromium)")
        return faults
    browser = Browser(chromium)
    try:
        return faults + check_search(browser, site) + check_tables(browser, site)
    finally:
        browser.close()
