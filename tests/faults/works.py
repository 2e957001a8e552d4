# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What faults are injected into: each command of the program that computes or writes, in a small case."""

import os
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "campaign"))
import campaign  # noqa: E402

BALL = campaign.CASE.replace("TIME", "0.3 s").partition("[sweep]")[0]
RANGE = '{ from = "8 Hz", to = "16 Hz" }'
PYTHON = """import ctypes, json, sys
import mahlwerk
case = mahlwerk.Case("ball.toml")
faults = ctypes.CDLL(None)
faults.mahlwerk_fault_begin()
try:
    result = case.run(out="out", force=True, threads=THREADS)
    value = result["dissipated_power"].value
    ended = {"ended": "", "exit": 0, "faults": []}
except mahlwerk.InputError as e:
    faults.mahlwerk_fault_end()
    if e.result is not None:
        print("dissipated_power", e.result["dissipated_power"].value)
    ended = {"ended": "bad-input", "exit": 2, "faults": [
        {"code": f.code, "where": f.where, "what": f.what, "remedy": f.remedy} for f in e.faults]}
except (MemoryError, OSError) as e:
    ended = {"ended": "bad-input", "exit": 2, "faults": [
        {"code": "not-enough-memory", "where": "", "what": repr(e), "remedy": "-"}]}
faults.mahlwerk_fault_end()
print(json.dumps(ended), file=sys.stderr)
sys.exit(ended["exit"])
"""


class Work:
    """A command, the files that it starts from, and what its output holds when it has ended.

    marks: words of the table on standard output, of a command that computes
    most: calls of each kind that fail if all are asked for; 0: all of them
    """

    def __init__(self, name, words, files, first=(), marks=(), threads=True, most=0):
        self.name, self.words, self.files, self.first = name, list(words), files, first
        self.marks, self.threads, self.most = marks, threads, most

    def command(self, program, jobs, as_json):
        words = list(self.words)
        if self.threads:
            words += ["--jobs", str(jobs)]
        return [program, *words, *(["--json"] if as_json else [])]

    def environment(self):
        return {}

    takes_json = True


class PythonWork(Work):
    """The same from Python, whose own calls are not counted."""

    takes_json = False

    def __init__(self, name, package):
        super().__init__(name, [], {"ball.toml": BALL}, marks=["dissipated_power"], threads=False)
        self.package = package

    def command(self, program, jobs, as_json):
        return [sys.executable, "-B", "-c", PYTHON.replace("THREADS", str(jobs))]

    def environment(self):
        return {"PYTHONPATH": self.package, "MAHLWERK_FAULT_WAIT": "1"}


def swept(keys='"mill.frequency" = ["10 Hz", "12 Hz"]'):
    return BALL + "[sweep]\n" + keys + "\n"


def works(home, package=""):
    home = pathlib.Path(home)
    cases = home / "tests" / "docs" / "cases"
    few = ('maximise = "dissipated_power"\nsettings = 6\nreplicates = 2\n'
           'over = { "mill.frequency" = %s }\n' % RANGE)
    records = BALL + '[observe]\ncollisions = true\nframes = "0.1 s"\nframes_format = "xyz"\n'
    soft = BALL.replace('engine = "event"', 'engine = "soft"').replace("0.3 s", "0.05 s").replace(
        'lasting = "tc"\ncontact_time = "1e-4 s"\n', "").replace(
        "tangential_restitution = 0.9\n", "").replace("count = 1", "count = 2").replace(
        '"8 mm"', '"5 mm"')
    fit = (cases / "fit.toml").read_text().replace('time = "10 s"', 'time = "1 s"')
    mill_fit = (cases / "mill-fit.toml").read_text().replace('"0.5 s"', '"0.1 s"').replace(
        '"0.2 s"', '"0.02 s"')
    campaign = [["sweep", "sweep.toml", "--out", "campaign", "--quiet", "--results", "summary"]]
    settings = swept('"mill.frequency" = { from = "8 Hz", to = "16 Hz", steps = 9 }')
    power = ["dissipated power"]
    made = [
        Work("run", ["run", "ball.toml", "--out", "out"], {"ball.toml": BALL}, marks=power),
        Work("run-soft", ["run", "soft.toml", "--out", "out"], {"soft.toml": soft}, marks=power),
        Work("run-records", ["run", "records.toml", "--out", "out"], {"records.toml": records},
             marks=power),
        Work("run-checkpoint", ["run", "ball.toml", "--out", "out", "--checkpoint", "0.001"],
             {"ball.toml": BALL}, marks=power),
        Work("compare", ["compare", "soft.toml", "--out", "out"],
             {"soft.toml": soft.replace("[run]", 'restitution_law = "constant"\n[run]', 1)
              if "restitution_law" in soft else soft}, marks=power, most=40),
        Work("sweep", ["sweep", "sweep.toml", "--out", "out"], {"sweep.toml": swept()}),
        Work("sweep-summary", ["sweep", "sweep.toml", "--out", "out", "--results", "summary"],
             {"sweep.toml": swept()}),
        Work("export", ["sweep", "export", "campaign", "--out", "table.csv"],
             {"sweep.toml": swept()}, first=campaign, threads=False),
        Work("status", ["sweep", "status", "campaign"], {"sweep.toml": swept()}, first=campaign,
             threads=False),
        Work("report", ["report", "campaign"], {"sweep.toml": swept()}, first=campaign, threads=False),
        Work("report-run", ["report", "out"], {"ball.toml": BALL},
             first=[["run", "ball.toml", "--out", "out", "--quiet"]], threads=False),
        Work("surrogate", ["surrogate", "campaign", "--out", "it.surrogate"],
             {"sweep.toml": settings}, first=campaign, threads=False),
        Work("ask", ["ask", "it.surrogate", "--set", "mill.frequency=11 Hz"],
             {"sweep.toml": settings},
             first=[*campaign, ["surrogate", "campaign", "--out", "it.surrogate"]], threads=False),
        Work("optimise", ["optimise", "fast.toml", "--out", "out"],
             {"fast.toml": BALL + "[optimise]\n" + few}, marks=["mill.frequency"]),
        Work("match", ["match", "ball.toml", "--in", "in.toml", "--out", "out"],
             {"ball.toml": BALL,
              "in.toml": BALL + "[match]\nsettings = 6\nreplicates = 2\nover = { "
                                '"mill.frequency" = %s }\n' % RANGE}, marks=["mill.frequency"], most=40),
        Work("fit", ["fit", "fit.toml", "fit.csv", "--out", "out"],
             {"fit.toml": fit, "fit.csv": (cases / "fit.csv").read_text()},
             marks=["breakage.f_mat"]),
        Work("calibrate", ["fit", "mill-fit.toml", "mill-fit.csv", "--settings", "5", "--out",
                           "out"],
             {"mill-fit.toml": mill_fit, "mill-fit.csv": (cases / "mill-fit.csv").read_text()},
             marks=["contact.restitution"], most=12),
        Work("check", ["check", "ball.toml"], {"ball.toml": BALL}, threads=False),
        Work("new", ["new", "--mill", "retsch-mm400", "made.toml"], {},
             threads=False),
        Work("list", ["list", "mills"], {}, threads=False),
        Work("describe", ["describe", "mill"], {}, threads=False),
    ]
    if package:
        made.append(PythonWork("python", package))
    for work in made:
        if work.name in ("new", "export"):
            work.takes_json = False
    return made


def prepared(work, program, place):
    """The folder from which each start of a work begins."""
    import subprocess
    place.mkdir(parents=True)
    for name, text in work.files.items():
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_text(text)
    for words in work.first:
        subprocess.run([program, *words], cwd=place, check=True, capture_output=True,
                       env=dict(os.environ))
    return place


def copied(template, place):
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(template, place)
    return place
