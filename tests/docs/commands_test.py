# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Every command of the documents works.

    commands_test.py PROGRAM quick|slow|list [DOCUMENT...]    list: prints the commands
    commands_test.py PROGRAM self-test

The commands of a document run in their order, in one scratch folder with a copy of what they name
(examples, papers, ...), so that they find the results of earlier ones and never write into the
sources. `quick` runs all commands except those annotated as slow; of these it checks the case. What a document shows as
the output of a command is compared with what the command prints (shown.py).
`slow` runs the documents that have slow commands, whole. A run of an example as its README has it is
compared with the numbers in its expected.toml.
"""
import json
import os
import pathlib
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import commands
import shown
from commands import Faulty, Step
from scratch import HOME, scratch_folder

LIMIT = 600  # [s] of one command


class Runner:
    def __init__(self, program: str) -> None:
        self.program, self.failed, self.skipped, self.run, self.times = program, [], [], 0, []
        self.helps: dict[str, str] = {}

    def fail(self, where: str, what: str) -> None:
        self.failed.append(where)
        print(f"FAILED {where}: {what}", flush=True)

    def shell(self, where: str, text: str, place, env, wanted: int = 0, shows: list | None = None) -> None:
        begin = time.monotonic()
        running = subprocess.Popen(["bash", "-c", text], cwd=place, env=env, text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, start_new_session=True)
        try:
            output = running.communicate(timeout=LIMIT)[0]
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGKILL)
            running.communicate()
            return self.fail(where, f"'{text}' takes more than {LIMIT} s; annotate it "
                             "(docs/developers/tests.md, \"Commands in the documents\")")
        took = time.monotonic() - begin
        self.run += 1
        self.times.append((took, where))
        if running.returncode != wanted:
            return self.fail(where, f"'{text}' ends with {running.returncode}, expected {wanted}:\n"
                             + output[-2000:])
        if shows and (what := shown.fault(shows, output)):
            return self.fail(where, f"'{text}': {what}")
        print(f"ok {where}: {text}  ({took:.1f} s)", flush=True)

    def known_help(self, command: str) -> str:
        if command not in self.helps:
            self.helps[command] = subprocess.run([self.program, *command.split(), "--help"],
                                                 text=True, capture_output=True).stdout
        return self.helps[command]

    def document(self, name: str, steps: list[Step], slow: bool) -> None:
        with tempfile.TemporaryDirectory(prefix="mahlwerk-docs-") as folder:
            place = pathlib.Path(folder)
            env = scratch_folder(self.program, place)
            for step in steps:
                if step.file:
                    with (place / step.file).open("a" if step.append else "w") as out:
                        out.write("\n" * step.append + step.text)
                elif why := step.skip or next((f"no {p}" for p in step.needs if not shutil.which(p)), ""):
                    self.skipped.append((step, why))
                    self.preset(step.where, shlex.split(step.text))
                elif step.slow and not slow:
                    if check := as_check(step.text):
                        self.shell(step.where, check, place, env)
                else:
                    for text in step.first:
                        self.shell(step.where, text, place, env)
                    self.shell(step.where, step.text, place, env, step.exit, step.shows)
                    self.example(step, place, env)

    def example(self, step: Step, place: pathlib.Path, env) -> None:
        """The result of an example that ran as its README says holds the numbers of its expected.toml."""
        ran = re.fullmatch(r"\./mahlwerk run (examples/([\w-]+))", step.text)
        if ran and (place / ran[1] / "expected.toml").exists():
            self.shell(step.where, f"tools/check_example {ran[1]} results/{ran[2]}", place, env)

    # Code in running text: its command, options, paths and presets exist.

    def span(self, where: str, text: str) -> None:
        try:
            words = shlex.split(text)
        except ValueError:
            return
        if len(words) < 2:
            return
        if words[0] in ("./mahlwerk", "mahlwerk"):
            self.program_span(where, words)
        elif words[0] in ("cmake", "ctest"):
            self.preset(where, words)
        elif re.match(r"(tools|viewer|papers|bench|tests|\.ci)/", words[0]):
            if not (HOME / words[0]).exists():
                self.fail(where, f"there is no {words[0]}")

    def preset(self, where: str, words: list[str]) -> None:
        if words[0] in ("cmake", "ctest") and "--preset" in words and (what := unknown_preset(words)):
            self.fail(where, what)

    def program_span(self, where: str, words: list[str]) -> None:
        command = words[1]
        options = [w.partition("=")[0] for w in words[2:] if re.match(r"--[a-z]", w)]
        if command in ("test", "device") or not re.match(r"[a-z]+$", command):
            return  # arguments of ctest; code for cards, by the starter; COMMAND; --help
        if command == "bench":
            known = (HOME / "bench" / "help.txt").read_text()
            if not re.search(rf"^\s+{re.escape(words[2])}\b", known, re.M):
                self.fail(where, f"there is no benchmark '{words[2]}'")
            return
        if not re.search(rf"^  {command}\s", self.known_help(""), re.M):
            return self.fail(where, f"there is no command '{command}'")
        for option in options:
            if not re.search(rf"{option}\b", self.known_help(command)):
                self.fail(where, f"'{command}' has no option '{option}'")
        paths = [w for w in words[2:] if re.match(r"(examples|papers|validation)/", w)]
        if command in ("list", "describe", "check") and words[2:] and words[2] == words[2].lower():
            self.shell(where, shlex.join([self.program, *words[1:]]), HOME, os.environ)
        elif paths:
            if check := as_check(shlex.join([self.program, *words[1:]])):
                self.shell(where, check, HOME, os.environ)

    def settings(self, where: str, document: pathlib.Path, text: str) -> None:
        """`--set ...` in the text of an example or paper is accepted by its case (one of its)."""
        words = shlex.split(text)
        folder = document.parent
        cases = [folder] if (folder / "case.toml").exists() else [
            f for f in sorted(folder.rglob("*.toml"))]
        if folder.parent not in (HOME / "examples", HOME / "papers") or words[-1].endswith("="):
            return
        self.run += 1
        for case in cases:
            done = subprocess.run([self.program, "check", str(case), *words], text=True, cwd=HOME,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if done.returncode == 0:
                return
        self.fail(where, f"'check' refuses '{text}':\n{done.stdout[-2000:]}")


def as_check(text: str) -> str:
    """A command that runs a case as the check of this case; empty for other commands."""
    words = shlex.split(text)
    if len(words) < 3 or words[1] not in ("run", "sweep", "compare", "optimise", "fit"):
        return ""
    kept, i = [], 3
    while i < len(words):
        if words[i] == "--set":
            kept += words[i:i + 2]
        i += 2 if words[i].startswith("--") else 1
    return shlex.join([words[0], "check", words[2], *kept])


def unknown_preset(words: list[str]) -> str:
    kind = {"ctest": "testPresets"}.get(words[0], "workflowPresets" if "--workflow" in words else
                                        "configurePresets")
    name = words[words.index("--preset") + 1]
    presets = json.loads((HOME / "CMakePresets.json").read_text())
    known = [one["name"] for one in presets[kind]]
    return "" if name in known else f"there is no preset '{name}' among the {kind}"


def self_test() -> int:
    """The reader refuses what it does not know, and finds every command."""
    block = "```sh\n./mahlwerk a \\\n  b   # comment\n\necho '# no comment'\n```\n"
    found = commands.steps("x.md", block)
    assert [s.text for s in found] == ["./mahlwerk a b", "echo '# no comment'"], found
    noted = commands.steps("x.md", "<!-- test: skip `echo`: why -->\n<!-- test: with a=c -->\n\n"
                           + block)
    assert [(s.text, s.skip) for s in noted] == [("./mahlwerk c b", ""),
                                                 ("echo '# no comment'", "why")], noted
    for faulty in ("<!-- test: jump -->\n" + block, "<!-- test: skip -->\n" + block,
                   "<!-- test: slow `none` -->\n" + block, "<!-- test: slow -->\ntext\n" + block,
                   "<!-- test: slow -->\n```toml\n```\n", "<!-- test: slow -->\n",
                   "<!-- test: exit: 1 -->\n```python\nx = 1\n```\n", "<!-- test: shows -->\n```\n1\n```\n"):
        try:
            commands.steps("x.md", faulty)
        except Faulty:
            continue
        raise AssertionError(f"accepted: {faulty}")
    python = commands.steps("x.md", "<!-- test: with: a=c -->\n```python\nx = a\n\ny = 2\n```\n")
    assert [(s.text, s.language, s.where) for s in python] == [
        ("x = c\n\ny = 2", "python", "x.md:3")], python
    shown.self_test()
    printed = commands.steps("x.md", "```sh\necho 12 W\n```\n<!-- test: shows -->\n```\n14 W\n```\n")
    assert printed[0].shows == ["14 W"], printed
    runner = Runner("false")
    runner.document("x.md", printed, False)
    assert runner.failed == ["x.md:2"], runner.failed
    runner = Runner("false")
    runner.document("x.md", commands.steps("x.md", "```sh\nfalse\n```\n"), False)
    assert runner.failed == ["x.md:2"], runner.failed
    assert unknown_preset(["ctest", "--preset", "none"])
    print("the reader of commands is sound")
    return 0


def main() -> int:
    if sys.argv[2:] == ["self-test"]:
        return self_test()
    if len(sys.argv) < 3 or sys.argv[2] not in ("quick", "slow", "list"):
        print(__doc__, file=sys.stderr)
        return 2
    part, runner = sys.argv[2], Runner(os.path.abspath(sys.argv[1]))
    files = [pathlib.Path(f).resolve() for f in sys.argv[3:]] or commands.documents(HOME)
    for file in files:
        name, text = file.relative_to(HOME).as_posix(), file.read_text()
        try:
            steps = [s for s in commands.steps(name, text) if s.language == "sh"]
        except (Faulty, ValueError) as fault:
            runner.fail(name, str(fault))
            continue
        if part == "list":
            for s in steps:
                print(f"{s.where}: {'slow ' * s.slow}{'skip ' * bool(s.skip)}{s.file or s.text}")
            continue
        has_slow = any(s.slow for s in steps)
        if steps and (part == "quick" or has_slow):
            runner.document(name, steps, part == "slow")
        for where, span in commands.spans(name, text) if part == "quick" else ():
            runner.span(where, span)
            if span.startswith("--set "):
                runner.settings(where, file, span)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    for step, why in runner.skipped:
        print(f"skipped {step.where}: {step.text}  ({why})")
    print(f"{runner.run} commands run, {len(runner.skipped)} skipped, {len(runner.failed)} failed,"
          f" {used.ru_utime + used.ru_stime:.0f} s of CPU; the longest: "
          + ", ".join(f"{where} {took:.0f} s" for took, where in sorted(runner.times)[:-4:-1]))
    return 1 if runner.failed else 0


sys.exit(main())
