# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Markdown of the pages that are made from the program: catalogue and keys of cases."""
import collections
import json
import pathlib
import re
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
    return {f"catalogue/{category}": category_page(program, category, entries[category])
            for category in CATEGORIES}


def category_page(program: str, category: str, names: list[str]) -> str:
    title, key, section, about = CATEGORIES[category]
    described = [ask(program, "describe", name) for name in names]
    head = "[[balls]]" if section == "balls" else f"[{section}]"
    rows = [[f"[{cell(one['name'])}](#{slug(one['name'])})", cell(one["title"]), cell(one.get("kind", "")),
             UNVERIFIED if any(v["unverified"] or v["assumed"] for v in one["values"].values()) else ""]
            for one in described]
    kinds = any(one.get("kind") for one in described)
    if not kinds:
        rows = [row[:2] + row[3:] for row in rows]
    made = [f"# {title}\n\n{about}. In a case: `{key} = \"{names[0]}\"` in `{head}`. A value marked "
            f"{UNVERIFIED} has a weak source.\n",
            table(["name", "what", *(["kind"] if kinds else []), "values"], rows)]
    made += [entry(one) for one in described]
    return "\n".join(made)


def mark(value: dict) -> str:
    if value["assumed"]:
        return f"assumed, {value['from']} to {value['to']}" if "from" in value else "assumed"
    return UNVERIFIED if value["unverified"] else ""


def entry(one: dict) -> str:
    rows = [[f"`{key}`", cell(v["value"]), ": ".join(filter(None, [mark(v), cell(v["source"])]))]
            for key, v in sorted(one["values"].items())]
    lines = [f"## {cell(one['name'])}\n", f"**{cell(one['title'])}**"
             + (f", kind `{one['kind']}`" if one.get("kind") else "") + ".\n"]
    if one.get("about"):
        lines.append(cell(one["about"]) + "\n")
    lines.append(table(["key", "value", "source"], rows))
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
    """Pages of `mahlwerk list keys --json`, one for each section."""
    sections: dict[str, list[dict]] = {}
    for one in described:
        sections.setdefault(one["section"] or "top", []).append(one)
    made = {f"reference/keys/{page_name(section)}": section_page(section, kinds, pictures)
            for section, kinds in sections.items()}
    rows = []
    for section, kinds in sections.items():
        page = page_name(section)
        about = next(text_cell(k["about"]) for k in kinds)
        names = ", ".join(f"[`{k['kind']}`]({page}.md#{slug(k['kind'])})" for k in kinds if k["kind"])
        rows.append([f"[{heading(section)}]({page}.md)", about, names])
    made["reference/keys/index"] = (
        "# Keys of case files\n\nEvery key with its unit, range, default and meaning, as the program knows them. "
        "How the keys work together: [case files](../../cases.md). On the command line: "
        "`mahlwerk describe mill`, `mahlwerk describe planetary`, `mahlwerk list keys`.\n\n"
        + table(["section", "what", "kinds and models"], rows))
    return made


def page_name(section: str) -> str:
    return section.replace(".", "-")


def heading(section: str) -> str:
    if section == "top":
        return "Top of the file"
    return cell(f"[[{section}]]" if section in ("balls", "contact.pairs") else f"[{section}]")


def section_page(section: str, kinds: list[dict], pictures: pathlib.Path) -> str:
    made = [f"# {heading(section)}\n"]
    for one in kinds:
        if one["kind"]:
            chosen = f" Chosen by `{one['choice']} = \"{one['kind']}\"`." if one["choice"] else ""
            made.append(f"## {cell(one['kind'])}\n\n{sentence(one['about'])}{chosen}\n")
            made += [f"![Drawing of the keys of {cell(one['kind'])}](../../pictures/docs/images/keys/{name})\n"
                     for name in (f"{section}-{one['kind']}.svg", f"{section}-{one['kind']}.png")
                     if (pictures / name).exists()]
        else:
            made.append(sentence(one["about"]) + "\n")
        if one["keys"]:
            made.append(table(["key", "value", "default", "meaning"],
                              [key_row(key) for key in one["keys"]]))
        elif one["kind"]:
            made.append("It has no keys of its own.\n")
    return "\n".join(made)


def sentence(text: str) -> str:
    made = text_cell(text).strip()
    return made[:1].upper() + made[1:] + "." * (not made.endswith("."))


def key_row(key: dict) -> list[str]:
    default = f"`{key['default']}`" if key["default"] else text_cell(key["default_source"] or "")
    if key["required"]:
        default = "**required**"
    limits = f"{range_of(key)} {cell(key['unit'] or '')}".strip()
    if key["type"] == "integer":
        limits = f"integer {limits}".strip()
    elif key["type"] != "number":
        limits = key["type"]
    return [f"`{key['key']}`", limits, default, meaning_of(key)]


def text_cell(text: str) -> str:
    """Text of a cell in which `code` stays code."""
    return "".join(part if i % 2 else cell(part) for i, part in enumerate(re.split(r"(`[^`]+`)", text)))


def range_of(key: dict) -> str:
    least, most = key["least"], key["most"]
    low = "" if least is None else f"{'above ' if key['least_excluded'] else ''}{number(least)}"
    high = "" if most is None else f"{'below ' if key['most_excluded'] else ''}{number(most)}"
    if low and high:
        return f"{low} to {high}"
    if low:
        return low if key["least_excluded"] else f"from {low}"
    return high if key["most_excluded"] or not high else f"up to {high}"


def meaning_of(key: dict) -> str:
    made = [text_cell(key["about"])]
    if key["example"] and not key["default"]:
        made[0] += f", e.g. `\"{key['example']}\"`"
    if key["instead_of"]:
        made.append(f"in place of `{key['instead_of']}`")
    if key["alternatives"]:
        made.append("or " + ", ".join(f"`{one}`" for one in key["alternatives"]))
    made += ["only with " + " or ".join(f'`{choice} = "{word}"`' for word in words)
             for choice, words in key["under"].items()]
    text = "; ".join(made)
    if key["type"] == "flag":
        return text
    for word, meaning in zip(key["words"], key["meanings"] or [""] * len(key["words"])):
        text += f"<br>`\"{word}\"`" + f": {text_cell(meaning)}" * bool(meaning)
    return text


def number(value: float) -> str:
    return re.sub(r"e\+?(-?)0*(\d)", r"e\1\2", f"{value:g}")
