# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Every Python block of the documents works.

    python_blocks_test.py PACKAGE quick|slow|list [DOCUMENT...]
    python_blocks_test.py PACKAGE pictures DOCUMENT...   writes the pictures that these documents show
    python_blocks_test.py PACKAGE self-test

PACKAGE is the folder that holds the built package `mahlwerk`. The blocks of a document run in their
order, in one interpreter and one scratch folder with a copy of what they name (examples, ...). `quick`
leaves out the blocks annotated as slow; `slow` runs the documents that have such blocks, whole.
Annotations: commands.py. Exit code 77: the package is not built.
"""
import importlib.util
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

import commands
from commands import Faulty, Step
from scratch import HOME, copy_sources

LIMIT = 600  # [s] of one document
SKIPPED = 77
# Runs files named in its arguments as one program; line numbers are those of the document.
RUNNER = """
import sys, time
names = {"__name__": "__main__"}
for place in sys.argv[1:]:
    with open(place, encoding="utf-8") as block:
        where = block.readline().strip()
        text = block.read()
    name, _, line = where.rpartition(":")
    begin = time.monotonic()
    exec(compile("\\n" * (int(line) - 2) + text, name, "exec"), names)
    print(f"ok {where}  ({time.monotonic() - begin:.1f} s)", flush=True)
"""
# Pictures are the same each time, and their text is text.
MATPLOTLIBRC = """
svg.hashsalt: mahlwerk
svg.fonttype: none
figure.figsize: 6.4, 3.6
font.size: 10
savefig.dpi: 130
"""
IMAGE = re.compile(r"!\[[^\]]*\]\(([^()\s]+\.(?:svg|png))\)")


class Runner:
    def __init__(self, package: str) -> None:
        self.package, self.run, self.failed, self.skipped = package, 0, [], 0

    def fail(self, where: str, what: str) -> None:
        self.failed.append(where)
        print(f"FAILED {where}: {what}", flush=True)

    def document(self, name: str, steps: list[Step], slow: bool, keep=None) -> None:
        with tempfile.TemporaryDirectory(prefix="mahlwerk-docs-") as folder:
            place = pathlib.Path(folder)
            copy_sources(place)
            blocks = []
            for step in steps:
                if step.file:
                    with (place / step.file).open("a" if step.append else "w") as out:
                        out.write("\n" * step.append + step.text)
                elif step.language != "python":
                    continue
                elif why := self.reason_to_skip(step, slow):
                    self.leave_out(step, why)
                else:
                    first, text = "; ".join(step.first), step.text if slow else step.quick or step.text
                    blocks.append(place / f".block-{len(blocks)}")
                    blocks[-1].write_text("\n".join([step.where, first, text, *step.then]) + "\n")
            if blocks:
                self.execute(name, place, blocks)
            if keep:
                keep(place)

    @staticmethod
    def reason_to_skip(step: Step, slow: bool) -> str:
        missing = [name for name in step.needs if importlib.util.find_spec(name) is None]
        return step.skip or (f"no {missing[0]}" if missing else "slow" if step.slow and not slow else "")

    def leave_out(self, step: Step, why: str) -> None:
        self.skipped += 1
        print(f"skipped {step.where}: {why}")
        try:
            compile(step.text, step.where, "exec")
        except SyntaxError as error:
            self.fail(step.where, str(error))

    def execute(self, name: str, place: pathlib.Path, blocks: list[pathlib.Path]) -> None:
        settings = place / ".matplotlib"
        settings.mkdir()
        (settings / "matplotlibrc").write_text(MATPLOTLIBRC)
        env = dict(os.environ, PYTHONPATH=self.package, MPLBACKEND="Agg", MPLCONFIGDIR=str(settings),
                   SOURCE_DATE_EPOCH="0", PYTHONDONTWRITEBYTECODE="1",
                   MAHLWERK_CATALOGUE=str(place / "catalogue"))
        running = subprocess.Popen([sys.executable, "-c", RUNNER, *map(str, blocks)], cwd=place, env=env,
                                   text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, start_new_session=True)
        try:
            output = running.communicate(timeout=LIMIT)[0]
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGKILL)
            running.communicate()
            return self.fail(name, f"takes more than {LIMIT} s; annotate it")
        done = len(re.findall(r"^ok ", output, re.M))
        self.run += done
        if running.returncode:
            self.fail(name, f"block {done + 1} of {len(blocks)} fails:\n{output[-4000:]}")
        else:
            print(output, end="", flush=True)


def keep_pictures(document: pathlib.Path):
    """Copies the pictures that the document shows from the scratch folder to their places."""
    def keep(place: pathlib.Path) -> None:
        for target in IMAGE.findall(document.read_text()):
            made = place / pathlib.PurePosixPath(target).name
            if made.exists():
                wanted = (document.parent / target).resolve()
                wanted.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(made, wanted)
                print(f"wrote {wanted.relative_to(HOME)}")
    return keep


def self_test() -> int:
    """A block that fails is reported with its line, and later blocks see the names of earlier ones."""
    runner = Runner("")
    runner.document("x.md", commands.steps("x.md", "```python\nx = 1\n```\n```python\nassert x == 1\n```\n"),
                    False)
    assert (runner.run, runner.failed) == (2, []), (runner.run, runner.failed)
    runner.document("y.md", commands.steps("y.md", "```python\nx\n```\n"), False)
    assert runner.failed == ["y.md"], runner.failed
    runner.document("z.md", commands.steps("z.md", "<!-- test: slow -->\n```python\nx = (\n```\n"), False)
    assert runner.failed == ["y.md", "z.md:3"], runner.failed
    text = "<!-- test: quick: 2=1 -->\n<!-- test: then: assert x == 2 -->\n```python\nx = 2\n```\n"
    runner.document("long.md", commands.steps("long.md", text), True)
    runner.document("quick.md", commands.steps("quick.md", text), False)
    assert runner.failed == ["y.md", "z.md:3", "quick.md"], runner.failed
    print("the runner of Python blocks is sound")
    return 0


def main() -> int:
    if sys.argv[2:] == ["self-test"]:
        return self_test()
    if len(sys.argv) < 3 or sys.argv[2] not in ("quick", "slow", "list", "pictures"):
        print(__doc__, file=sys.stderr)
        return 2
    package, part = os.path.abspath(sys.argv[1]), sys.argv[2]
    if part != "list" and not list(pathlib.Path(package).glob("mahlwerk/_core*.so")):
        print(f"skipped: no package mahlwerk with its compiled part in {package} (-DMAHLWERK_PYTHON=ON)")
        return SKIPPED
    runner = Runner(package)
    files = [pathlib.Path(f).resolve() for f in sys.argv[3:]] or commands.documents(HOME)
    for file in files:
        name = file.relative_to(HOME).as_posix()
        try:
            steps = commands.steps(name, file.read_text())
        except (Faulty, ValueError) as fault:
            runner.fail(name, str(fault))
            continue
        python = [s for s in steps if s.language == "python"]
        if part == "list":
            for s in python:
                print(f"{s.where}: {'slow ' * s.slow}{'skip ' * bool(s.skip)}{s.text.splitlines()[0]}")
        elif python and (part != "slow" or any(s.slow for s in python)):
            runner.document(name, steps, part != "quick",
                            keep_pictures(file) if part == "pictures" else None)
    print(f"{runner.run} blocks run, {runner.skipped} skipped, {len(runner.failed)} failed")
    return 1 if runner.failed else 0


sys.exit(main())
