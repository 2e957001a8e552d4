#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The wheel is built without a network, installed into a fresh virtual environment, and runs a case.

  wheel_test.py
"""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77
PROGRAM = """
import pathlib, mahlwerk
place = pathlib.Path(mahlwerk.__file__).parent
assert "site-packages" in str(place), place
names = sorted(p.name for p in (place / "data").iterdir())
assert names == ["catalogue", "examples", "papers", "validation"], names
result = mahlwerk.Case(place / "data/examples/01-one-ball").run()
print(result["collision_rate"])
assert "fritsch-p7-classic" in str(mahlwerk.catalogue("mills"))
"""


def run(*words, **more):
    done = subprocess.run([str(word) for word in words], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **more)
    assert done.returncode == 0, f"{words} ended with {done.returncode}:\n{done.stdout}"
    return done.stdout


def main():
    missing = [one for one in ("setuptools", "wheel", "venv", "ensurepip", "numpy")
               if importlib.util.find_spec(one) is None]
    if missing:
        print("skipped: without", *missing)
        return SKIPPED
    before = run("git", "status", "--short", cwd=SOURCE) if (SOURCE / ".git").exists() else ""
    with tempfile.TemporaryDirectory(prefix="mahlwerk-") as name:
        place = pathlib.Path(name)
        run(sys.executable, "-m", "venv", "--system-site-packages", place / "venv")
        python = place / "venv/bin/python"
        run(python, "-m", "pip", "wheel", "--no-build-isolation", "--no-index", "--no-deps",
            "--wheel-dir", place, SOURCE)
        (wheel,) = place.glob("mahlwerk-*.whl")
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB")
        run(python, "-m", "pip", "install", "--no-index", wheel)
        env = {key: value for key, value in os.environ.items()
               if key not in ("PYTHONPATH", "MAHLWERK_CATALOGUE")}
        print(run(python, "-c", PROGRAM, cwd=place, env=env))
    if before or (SOURCE / ".git").exists():
        after = run("git", "status", "--short", cwd=SOURCE)
        assert before == after, f"building left files among the sources:\n{after}"
    return 0


if __name__ == "__main__":
    sys.exit(main())
