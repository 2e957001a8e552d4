# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Markdown of the pages that are made from the program: catalogue and keys of cases."""
import collections
import json
import pathlib
import subprocess

CATEGORIES = {
    "mills": ("Mills", "model", "mill", "How a machine moves its jars"),
    "jars": ("Jars", "model", "jar", "Inner shapes and sizes"),
    "materials": ("Materials", "material", "balls", "Balls, walls and powders"),
    "media": ("Ball sets", "model", "balls", "Balls by number and size, for a jar"),
}
UNVERIFIED = '<span class="unverified">unverified</span>'


def ask(program: str, *words: str):
    done = subprocess.run([program, *words, "--json"], text=True, capture_output=True)
    if done.returncode:
        raise SystemExit(f"'{' '.join([program, *words])} --json' failed:\n{done.stderr}")
    return json.loads(done.stdout)


def cell(text) -> str:
    """Text of a cell of a table: the marks of Markdown and HTML are shown as they are."""
    made = str(text)
    for mark in "\\`*_<>[]|$#":
        made = made.replace(mark, f"\\{mark}")
    return made.replace("\n", " ")


def table(heading: list[str], rows: list[list[str]]) -> str:
    return "\n".join("| " + " | ".join(row) + " |"
                     for row in [heading, ["---"] * len(heading), *rows]) + "\n"


# The catalogue

def catalogue_pages(program: str) -> dict[str, str]:
    entries = collections.defaultdict(list)
    for one in ask(program, "list"):
        entries[one.get("room") or one["category"]].append(one["name"])
    return {f"catalogue/{category}": category_page(program, category, names)
            for category, names in entries.items()}


def category_page(program: str, category: str, names: list[str]) -> str:
    title, key, section, about = CATEGORIES[category]
    described = [ask(program, "describe", name) for name in names]
    head = "[[balls]]" if section == "balls" else f"[{section}]"
    rows = [[f"[{cell(one['name'])}](#{slug(one['name'])})", cell(one["title"]), cell(one.get("kind", "")),
             UNVERIFIED if any(v["unverified"] for v in one["values"].values()) else ""]
            for one in described]
    kinds = any(one.get("kind") for one in described)
    if not kinds:
        rows = [row[:2] + row[3:] for row in rows]
    made = [f"# {title}\n\n{about}. In a case: `{key} = \"{names[0]}\"` in `{head}`. A value marked "
            f"{UNVERIFIED} has a weak source.\n",
            table(["name", "what", *(["kind"] if kinds else []), "values"], rows)]
    made += [entry(one) for one in described]
    return "\n".join(made)


def entry(one: dict) -> str:
    rows = [[f"`{key}`", cell(v["value"]), UNVERIFIED if v["unverified"] else "", cell(v["source"])]
            for key, v in sorted(one["values"].items())]
    lines = [f"## {cell(one['name'])}\n", f"**{cell(one['title'])}**"
             + (f", kind `{one['kind']}`" if one.get("kind") else "") + ".\n"]
    if one.get("about"):
        lines.append(cell(one["about"]) + "\n")
    lines.append(table(["key", "value", "", "source"], rows))
    if one.get("jars"):
        lines.append("Jars that fit: " + ", ".join(f"[{cell(j)}](jars.md#{slug(j)})"
                                                   for j in one["jars"]) + "\n")
    return "\n".join(lines)


def slug(name: str) -> str:
    """Anchor of a heading, as code-hosting pages and MyST make it."""
    kept = "".join(c for c in name.lower() if c.isalnum() or c in "-_ ")
    return kept.replace(" ", "-")


# Keys of case files

def key_pages(described: list[dict], pictures: pathlib.Path) -> dict[str, str]:
    sections = collections.OrderedDict()
    for one in described:
        sections.setdefault(one["section"] or "top", []).append(one)
    rows = []
    made = {}
    for section, kinds in sections.items():
        page = section.replace(".", "-")
        names = ", ".join(f"[`{k['kind']}`]({page}.md#{slug(k['kind'])})" for k in kinds if k.get("kind"))
        about = next((k["about"] for k in kinds if not k.get("kind") and k.get("about")), "")
        rows.append([f"[{heading(section)}]({page}.md)", cell(about), names])
        made[f"reference/keys/{page}"] = section_page(section, kinds, pictures)
    made["reference/keys/index"] = (
        "# Keys of case files\n\nEvery key with its type, unit, range and default, as the program knows them. "
        "How the keys work together: [case files](../../cases.md). The same on the command line: "
        "`mahlwerk describe --keys`.\n\n" + table(["section", "what", "kinds"], rows))
    return made


def heading(section: str) -> str:
    if section == "top":
        return "Top of the file"
    return f"`[[{section}]]`" if section in ("balls", "contact.pairs") else f"`[{section}]`"


def section_page(section: str, kinds: list[dict], pictures: pathlib.Path) -> str:
    made = [f"# {heading(section)}\n"]
    for one in kinds:
        kind = one.get("kind")
        if kind:
            made.append(f"## {cell(kind)}\n")
        if one.get("about"):
            made.append(cell(one["about"]) + "\n")
        for suffix in (".svg", ".png") if kind else ():
            if (pictures / (kind + suffix)).exists():
                made.append(f"![Meaning of the keys of {cell(kind)}](../../pictures/docs/images/keys/{kind}{suffix})\n")
        if one["keys"]:
            made.append(table(["key", "type", "range", "default", "meaning"], [key_row(k) for k in one["keys"]]))
    return "\n".join(made)


def key_row(key: dict) -> list[str]:
    unit = key.get("unit") or ""
    kind = cell(key.get("type") or "") + (f", {cell(unit)}" if unit and unit != "1" else "")
    least, most = key.get("least"), key.get("most")
    if least is not None and most is not None:
        limits = f"{cell(least)} to {cell(most)}"
    elif least is not None:
        limits = f"from {cell(least)}"
    else:
        limits = f"up to {cell(most)}" if most is not None else ""
    words = key.get("words") or []
    if words:
        limits = ", ".join(f"`{w}`" for w in words)
    default = "**required**" if key.get("required") else ""
    if key.get("default") not in (None, ""):
        default = f"`{key['default']}`"
    elif key.get("default_source"):
        default = cell(key["default_source"])
    return [f"`{key['key']}`", kind, limits, default, cell(key.get("about") or "")]
