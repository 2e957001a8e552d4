# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Repairs of the theme furo as Debian 12 packages it (2022.12.07+dfsg-1), in the built site.

- Its style sheet imports normalize.css from the web server's root, where a site has no such file.
- Its style sheet lacks the dark colours for browsers that ask for them (a nested media query was lost).
- Its script is an ES module, which the pages load as a plain script, so that it does not run: the
  switch between light and dark does nothing.

Each repair does nothing where the fault is absent.
"""
import pathlib
import re

NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.min.css")
IMPORT = re.compile(r'@import url\("?/javascript/normalize.css/normalize.css"?\);\n?')
DARK = re.compile(r'^ *body\[data-theme="dark"\] \{([^{}]*--color-background-primary[^{}]*)\}', re.M)


def repair(static: pathlib.Path) -> None:
    repair_styles(static / "styles" / "furo.css")
    repair_script(static / "scripts")


def repair_styles(file: pathlib.Path) -> None:
    text = file.read_text()
    text = IMPORT.sub(lambda _: NORMALIZE.read_text(), text)
    if "prefers-color-scheme" not in text:
        colours = DARK.search(text)[1]
        text += ("\n@media not print { @media (prefers-color-scheme: dark) {\n"
                 'body:not([data-theme="light"]) {' + colours + "}\n"
                 'html body:not([data-theme="light"]) .only-light { display: none !important; }\n'
                 'body:not([data-theme="light"]) .only-dark { display: block !important; }\n} }\n')
    file.write_text(text)


def repair_script(folder: pathlib.Path) -> None:
    script, gumshoe = folder / "furo.js", folder / "gumshoe-patched.js"
    text = script.read_text()
    plain = re.sub(r'^import Gumshoe from "\./gumshoe-patched\.js";\n', "", text)
    if plain != text:
        script.write_text(gumshoe.read_text() + "\n" + plain)
