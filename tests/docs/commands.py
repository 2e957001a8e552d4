# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Shell commands and Python blocks of Markdown files, with the annotations that tell tests how to run them.

An annotation is a comment before a fenced block (docs/developers/tests.md, "Commands in the documents"):

    <!-- test: VERB `PREFIX`: TEXT -->     PREFIX: only the commands of the block that begin so
"""
import dataclasses
import pathlib
import re
import shlex

SHELLS = ("sh", "bash", "console", "shell")
#         verb: whether a text must follow
VERBS = {"skip": True, "slow": False, "with": True, "add": True, "exit": True, "first": True,
         "write": True, "append": True, "needs": True, "quick": True, "then": True, "shows": False}
OF_FILES = ("write", "append")
OF_PYTHON = ("skip", "slow", "with", "first", "needs", "quick", "then")  # a block of Python is one step
COMMENT = re.compile(r"^\s*<!--\s*test:(.*?)-->\s*$")
ANNOTATION = re.compile(r"^\s*(\w+)(?:\s+`([^`]+)`)?(?:\s*:\s*|\s+|$)(.*?)\s*$")
FENCE = re.compile(r"^(\s*)(`{3,}|~{3,})\s*(\w*)\s*$")
SPAN = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")


class Faulty(Exception):
    """A document or an annotation that cannot be read."""


@dataclasses.dataclass
class Annotation:
    where: str
    verb: str
    prefix: str
    text: str


@dataclasses.dataclass
class Step:
    """A command of a document, a block of Python, or a file that a block holds."""
    where: str
    text: str
    language: str = "sh"   # or "python"
    file: str = ""         # the block is written to this file
    append: bool = False   # at its end
    skip: str = ""         # why it is not run
    slow: bool = False
    exit: int = 0
    first: list = dataclasses.field(default_factory=list)
    then: list = dataclasses.field(default_factory=list)   # statements of Python that hold after it
    needs: list = dataclasses.field(default_factory=list)  # modules, or programs; without them not run
    quick: str = ""        # the text for the quick tests, if it differs
    shows: list = dataclasses.field(default_factory=list)  # lines that the document shows as its output


def annotation(where: str, text: str) -> Annotation:
    found = ANNOTATION.match(text)
    if not found or found[1] not in VERBS:
        raise Faulty(f"{where}: unknown annotation 'test:{text}'; known are {', '.join(VERBS)}")
    if VERBS[found[1]] != bool(found[3]):
        raise Faulty(f"{where}: '{found[1]}' must be followed by "
                     + ("a text" if VERBS[found[1]] else "nothing"))
    return Annotation(where, found[1], found[2] or "", found[3])


def command_lines(lines: list[str]) -> list[tuple[int, str]]:
    """The commands of a block with the index of their first line: continuation lines are joined,
    comments are left out; if a line has the prompt '$ ', the others are output."""
    prompts = any(line.startswith("$ ") for line in lines)
    found, begun = [], None
    for i, line in enumerate(lines):
        if begun is None and prompts and not line.startswith("$ "):
            continue
        line = line.removeprefix("$ ") if prompts else line
        number, text = (i, line) if begun is None else (begun[0], begun[1] + line.strip())
        begun = (number, text[:-1]) if text.endswith("\\") else None
        if begun is None and shlex.split(text, comments=True):
            found.append((number, text.strip()))
    return found


def without_comment(text: str) -> str:
    """The command without the comment at its end."""
    for at in (m.start() for m in re.finditer(r"(?<=\s)#", text)):
        try:
            if shlex.split(text[:at]) == shlex.split(text, comments=True):
                return text[:at].rstrip()
        except ValueError:  # inside quotes
            continue
    return text


def replaced(text: str, pairs: str) -> str:
    for pair in shlex.split(pairs):
        name, _, value = pair.partition("=")
        text = re.sub(rf"(?<![\w-]){re.escape(name)}(?![\w-])", lambda _: value, text)
    return text


def step(where: str, text: str, notes: list[Annotation], used: set[int]) -> Step:
    made = Step(where, without_comment(text))
    for i, note in enumerate(notes):
        if not text.startswith(note.prefix):
            continue
        used.add(i)
        if note.verb == "skip":
            made.skip = note.text
        elif note.verb == "slow":
            made.slow = True
        elif note.verb == "exit":
            made.exit = int(note.text)
        elif note.verb in ("first", "needs"):
            getattr(made, note.verb).append(note.text)
        elif note.verb == "add":
            made.text += " " + note.text
        elif note.verb != "with":
            raise Faulty(f"{note.where}: '{note.verb}' is not for commands")
    for note in (n for n in notes if n.verb == "with" and text.startswith(n.prefix)):
        made.text = replaced(made.text, note.text)
        made.first = [replaced(one, note.text) for one in made.first]
    return made


def python_step(where: str, text: str, notes: list[Annotation]) -> Step:
    made = Step(where, text, language="python")
    for note in notes:
        if note.verb not in OF_PYTHON or note.prefix:
            raise Faulty(f"{note.where}: for Python there are {', '.join(OF_PYTHON)}, for the whole block")
        if note.verb == "skip":
            made.skip = note.text
        elif note.verb == "slow":
            made.slow = True
        elif note.verb in ("first", "needs", "then"):
            getattr(made, note.verb).append(note.text)
        elif note.verb == "quick":
            made.quick = replaced(made.text, note.text)
        else:
            made.text = replaced(made.text, note.text)
    return made


def block_steps(name: str, begin: int, language: str, lines: list[str],
                notes: list[Annotation], before: list[Step]) -> list[Step]:
    files = [n for n in notes if n.verb in OF_FILES]
    if files:
        return [Step(f"{name}:{begin}", "\n".join(lines) + "\n", file=n.text,
                     append=n.verb == "append") for n in files]
    if language == "python":
        return [python_step(f"{name}:{begin + 1}", "\n".join(lines), notes)]
    if [n.verb for n in notes] == ["shows"] and before and before[-1].language == "sh":
        before[-1].shows = [line for line in lines if line.strip()]
        return []
    if language not in SHELLS:
        if notes:
            raise Faulty(f"{notes[0].where}: the block that follows has no shell commands")
        return []
    used: set[int] = set()
    made = [step(f"{name}:{begin + 1 + i}", text, notes, used) for i, text in command_lines(lines)]
    for i, note in enumerate(notes):
        if i not in used:
            raise Faulty(f"{note.where}: no command of the block begins with '{note.prefix}'")
    return made


def steps(name: str, text: str) -> list[Step]:
    """All commands and files of a document, in order. Throws Faulty."""
    made, notes, block = [], [], None
    for number, line in enumerate(text.split("\n"), 1):
        fence, comment = FENCE.match(line), COMMENT.match(line)
        if block is not None:
            if fence and fence[2].startswith(block[2]) and not fence[3]:
                made += block_steps(name, block[0], block[1], block[4], notes, made)
                notes, block = [], None
            else:
                block[4].append(line.removeprefix(block[3]))
        elif fence:
            block = (number, fence[3], fence[2], fence[1], [])
        elif comment:
            notes.append(annotation(f"{name}:{number}", comment[1]))
        elif line.strip() and notes:
            raise Faulty(f"{notes[0].where}: a block must follow the annotation")
    if block is not None or notes:
        raise Faulty(f"{name}: ends in a block or after an annotation")
    return made


def spans(name: str, text: str) -> list[tuple[str, str]]:
    """Code in running text, with its place."""
    found, inside = [], False
    for number, line in enumerate(text.split("\n"), 1):
        if FENCE.match(line):
            inside = not inside
        elif not inside:
            found += [(f"{name}:{number}", m[1]) for m in SPAN.finditer(line)]
    return found


def documents(home: pathlib.Path) -> list[pathlib.Path]:
    """README files, CONTRIBUTING.md and docs: every Markdown file except the history of changes."""
    left_out = {".git", "build", "node_modules", "results", "shared"}
    return sorted(f for f in home.rglob("*.md")
                  if not left_out & set(f.relative_to(home).parts[:-1])
                  and f.name != "CHANGELOG.md")
