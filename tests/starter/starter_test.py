#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Tests the starter script with a cmake that builds nothing.

  starter_test.py SCRIPT
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

CMAKE = """#!/bin/sh
[ "$1" = --build ] || exit 0
trap 'echo "ninja: build stopped: interrupted by user."; exit 2' INT
[ -e fails ] && { echo "FAILED: all of it"; exit 1; }
touch begun
while :; do sleep 0.02; done
"""


class Place:
    """A copy of the script, with the files and programs that it needs."""

    def __init__(self, script):
        self.here = pathlib.Path(tempfile.mkdtemp(prefix="mahlwerk-"))
        shutil.copy(script, self.here / "mahlwerk")
        for name in ("src", "apps", "bin"):
            (self.here / name).mkdir()
        for name in ("CMakeLists.txt", "CMakePresets.json"):
            (self.here / name).touch()
        (self.here / "bin/cmake").write_text(CMAKE)
        # The script must not install anything here: every package is reported as installed.
        (self.here / "bin/dpkg-query").write_text(
            "#!/bin/sh\nshift 2\nfor name; do echo \"installed $name\"; done\n")
        for name in ("cmake", "dpkg-query"):
            (self.here / "bin" / name).chmod(0o755)

    def start(self):
        return subprocess.Popen(
            ["./mahlwerk", "list"], cwd=self.here, stderr=subprocess.PIPE, text=True,
            start_new_session=True,
            env={**os.environ, "PATH": f"{self.here}/bin:{os.environ['PATH']}"},
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))

    def begun(self):
        end = time.monotonic() + 60
        while not (self.here / "begun").exists():
            assert time.monotonic() < end
            time.sleep(0.01)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.here, ignore_errors=True)


def lists_the_benchmarks_without_building(script):
    """`bench --help` names every benchmark of bench/benchmarks.hpp, and needs no program."""
    bench = pathlib.Path(script).resolve().parent / "bench"
    known = re.findall(r'Benchmark\{"([a-z-]+)"', (bench / "benchmarks.hpp").read_text())
    with Place(script) as place:
        shutil.copytree(bench, place.here / "bench")
        asked = subprocess.run(["./mahlwerk", "bench", "--help"], cwd=place.here,
                               capture_output=True, text=True, check=True)
        told = re.findall(r"^  ([a-z-]+) ", asked.stdout, re.MULTILINE)
        assert told == known, (told, known)
        assert not (place.here / "build").exists()


def main():
    lists_the_benchmarks_without_building(sys.argv[1])
    for whole in (True, False):  # Ctrl-C reaches the whole group; or only the build is interrupted
        with Place(sys.argv[1]) as place:
            process = place.start()
            place.begun()
            if whole:
                os.killpg(process.pid, signal.SIGINT)
            else:
                child = subprocess.run(["pgrep", "-P", str(process.pid), "-f", "--", "--build"],
                                       capture_output=True, text=True, check=True).stdout.split()[0]
                os.kill(int(child), signal.SIGINT)
            said = process.communicate(timeout=60)[1]
            assert process.returncode == 130, (process.returncode, said)
            assert "interrupted; the next start goes on from here" in said, said
            assert "failed" not in said, said
    with Place(sys.argv[1]) as place:
        (place.here / "fails").touch()
        process = place.start()
        said = process.communicate(timeout=60)[1]
        assert process.returncode == 1, (process.returncode, said)
        assert "building failed" in said and "FAILED: all of it" in said, said
        assert "interrupted" not in said, said
        assert "the first time takes about" in said, said


if __name__ == "__main__":
    main()
