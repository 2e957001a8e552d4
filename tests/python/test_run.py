# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
import json
import math
import multiprocessing
import os
import pickle
import re
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import h5py
import numpy as np
import pytest

import mahlwerk
from mahlwerk.quantities import Quantity

CASES = {"01-one-ball": {"run.time": "3 s"}, "03-planetary-mill": {"run.time": "0.1 s"},
         "05-planetary-soft": {"run.time": "0.02 s", "run.settle": "0.01 s"},
         "08-how-fine": {"run.time": "0.05 s", "run.replicates": 2}}


def content(folder):
    """The files of a result, without what differs from run to run: computing times."""
    made = {}
    for file in sorted(Path(folder).rglob("*")):
        if file.is_dir() or file.name in ("result.h5", "collisions.h5"):
            continue
        text = file.read_bytes().decode()
        made[file.name] = re.sub(r'(wall|cpu)_seconds": [0-9.e-]+|[0-9.]+ m?s of CPU time', "", text)
    return made


@pytest.mark.parametrize("name", CASES)
def test_a_run_gives_the_same_files_as_the_command_line(example, program, name):
    changes = [word for key, value in CASES[name].items() for word in ("--set", f"{key}={value}")]
    assert program("run", example(name), *changes, "--out", "there", "--quiet")[0] == 0
    result = mahlwerk.Case(example(name), CASES[name]).run("here", threads=1)
    assert content("here") == content("there")
    # In memory are the same numbers as in the files.
    opened = mahlwerk.open("there")
    assert result.quantities == opened.quantities
    assert list(result.tables) == sorted(result.tables, key=list(result.tables).index)
    assert set(result.tables) == set(opened.tables)
    for table, array in result.tables.items():
        assert array.dtype.names == opened.tables[table].dtype.names
        for column in array.dtype.names:
            np.testing.assert_array_equal(array[column], opened.tables[table][column])
    assert result.case == opened.case
    again = mahlwerk.Case(example(name), CASES[name]).run(threads=2)
    assert again.quantities == result.quantities, "the same bits on any number of threads"
    again.save("saved")
    assert content("saved") == content("there")


def test_observers_get_every_collision_once_and_in_order(ball):
    seen = {1: [], 2: []}
    case = ball.replace({"run.time": "100 s", "observe.collisions": True})
    result = case.run("out", observers=[lambda records, k: seen[k].append(records)],
                      collisions=True)
    for k in (1, 2):
        got = np.concatenate(seen[k])
        assert len(seen[k]) > 1 and all(len(one) >= 8192 for one in seen[k][:-1])
        kept = result.collisions(k)
        assert not kept.flags.writeable and np.shares_memory(kept, result.collisions(k))
        np.testing.assert_array_equal(got, kept)
        np.testing.assert_array_equal(got, mahlwerk.open("out").collisions(k))
        with h5py.File("out/collisions.h5") as file:
            read = file[f"replicate_{k}/collisions"][:]
            assert set(read.dtype.names) == set(mahlwerk.record_columns())
            np.testing.assert_array_equal(read["time"], got["time"])
    each = result.table("replicates")
    assert each["collision_rate_per_s"] * each["simulated_time_s"] == pytest.approx(
        [len(result.collisions(k)) for k in (1, 2)], rel=1e-12)
    frame = mahlwerk.tables.frame_of(result.collisions(1))
    assert len(frame) == len(result.collisions(1)) and frame["ball"].dtype == np.int32


def test_an_exception_in_an_observer_ends_the_run(ball):
    def fails(records, replicate):
        raise ZeroDivisionError("mine")
    with pytest.raises(ZeroDivisionError, match="mine"):
        ball.replace({"run.time": "100000 s", "run.replicates": 1}).run("out", observers=[fails])
    assert not os.path.exists("out") or not mahlwerk.open("out").complete
    with pytest.raises(ZeroDivisionError):
        ball.replace({"run.time": "100000 s"}).run(progress=lambda share, line: 1 / 0)


def test_what_a_run_cannot_do_is_said_before_it_starts(ball, program, example):
    Path("file").write_text("mine")
    code, _, said = program("run", example("01-one-ball"), "--out", "file", "--json")
    with pytest.raises(mahlwerk.InputError) as caught:
        ball.run("file")
    assert code == 2 and caught.value.faults[0].code == said["faults"][0]["code"]
    assert caught.value.faults[0].what == said["faults"][0]["what"]
    ball.run("out")
    with pytest.raises(mahlwerk.InputError, match="exists"):
        ball.run("out")
    ball.run("out", force=True)
    with pytest.raises(mahlwerk.InputError) as caught:
        ball.replace({"observe.frames": "1 ms"}).run()
    assert caught.value.faults[0].code == "no-folder"
    with pytest.raises(mahlwerk.InputError) as caught:
        ball.run().collisions()
    assert caught.value.faults[0].code == "no-records"
    assert Path("file").read_text() == "mine"


def test_a_run_that_physics_stops_keeps_what_it_computed(ball):
    case = ball.replace({"contact.lasting": "none", "contact.restitution": 0.5, "run.time": "5 s"})
    with pytest.raises(mahlwerk.RunError) as caught:
        case.run("out")
    assert not caught.value.result.complete and mahlwerk.open("out").quantities == (
        caught.value.result.quantities)


INTERRUPTED = """
import os, signal, sys, threading, mahlwerk
case = mahlwerk.Case(sys.argv[1], {"run.time": "1000000 s"})
started = threading.Event()
def interrupt(share, line):
    if not started.is_set():
        started.set()
        os.kill(os.getpid(), signal.SIGINT)
try:
    %s
except mahlwerk.Interrupted as error:
    assert isinstance(error, KeyboardInterrupt)
    print("kept", error.result)
try:  # the signal's handler is Python's own, as before
    os.kill(os.getpid(), signal.SIGINT)
    while True: pass
except KeyboardInterrupt:
    print("ours")
"""


def python(text, *words):
    return subprocess.run([sys.executable, "-c", text, *words], capture_output=True, text=True,
                          check=False, timeout=100)


def test_ctrl_c_keeps_what_was_computed(example):
    ended = python(INTERRUPTED % 'case.run("out", progress=interrupt)', example("01-one-ball"))
    assert ended.stdout.splitlines()[-1] == "ours" and "kept <Result" in ended.stdout, ended.stderr
    opened = mahlwerk.open("out")
    assert not opened.complete and opened["collision_rate"].value > 0


def test_ctrl_c_ends_a_campaign_that_goes_on_later(example):
    sweep = 'case.sweep({"mill.frequency": ["10 Hz", "11 Hz"]}, "out", progress=interrupt)'
    ended = python(INTERRUPTED % sweep, example("01-one-ball"))
    assert "kept <Campaign" in ended.stdout and ended.stdout.endswith("ours\n"), ended.stderr
    case = mahlwerk.Case(example("01-one-ball"), {"run.time": "1 s"})
    campaign = case.sweep({"mill.frequency": ["10 Hz", "11 Hz"]}, "out", force=True)
    assert list(campaign.table["status"]) == ["done", "done"]


def rate(seed):
    case = mahlwerk.Case.from_text(TEXT, None).replace({"seed": seed})
    return case.run(threads=1)["collision_rate"].value


TEXT = """
mill = { kind = "vibration", frequency = "10 Hz", amplitude = "25 mm" }
jar = { kind = "capsule", diameter = "12 mm", volume = "5 ml" }
balls = [{ count = 1, diameter = "8 mm", density = "7850 kg/m3" }]
run = { engine = "event", time = "1 s" }
"""


def test_threads_and_processes_do_not_disturb_each_other():
    seeds = range(1, 5)
    alone = [rate(seed) for seed in seeds]
    assert len(set(alone)) > 1
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(rate, seeds)) == alone
    for start in ("fork", "spawn"):
        with multiprocessing.get_context(start).Pool(2) as pool:
            assert pool.map(rate, seeds) == alone


def test_commands_in_two_threads_keep_their_results_apart(example):
    def sweep(name):
        case = mahlwerk.Case(example("01-one-ball"), {"run.time": "0.5 s", "seed": name})
        return case.sweep({"mill.frequency": ["10 Hz", "12 Hz"]}, f"out-{name}").column(
            "collision_rate").tolist()
    alone = [sweep(1), sweep(2)]
    for name in (1, 2):
        import shutil
        shutil.rmtree(f"out-{name}")
    with ThreadPoolExecutor(2) as pool:
        assert list(pool.map(sweep, (1, 2))) == alone
    assert alone[0] != alone[1]


def test_other_python_threads_go_on_while_a_run_computes(ball):
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            done.wait(0.001)
    thread = threading.Thread(target=count)
    thread.start()
    steps = []
    ball.replace({"run.time": "2000 s"}).run(progress=lambda share, line: steps.append(share))
    done.set()
    thread.join()
    assert counted[0] > 20, "the interpreter's lock is released"
    assert steps and steps == sorted(steps) and 0 <= steps[0] <= steps[-1] <= 1


def test_results_are_pickled_whole(ball):
    result = ball.run(collisions=True)
    copy = pickle.loads(pickle.dumps(result))
    assert copy.quantities == result.quantities and copy.case == result.case
    np.testing.assert_array_equal(copy.collisions(2), result.collisions(2))
    np.testing.assert_array_equal(copy.table("spectrum"), result.table("spectrum"))
    assert copy.report == result.report
    ball.run("out")
    assert pickle.loads(pickle.dumps(mahlwerk.open("out"))).quantities == result.quantities


def test_import_loads_no_other_package():
    ended = python("import sys, mahlwerk; print([m for m in ('numpy', 'pandas', 'matplotlib', "
                   "'sqlite3', 'IPython') if m in sys.modules])")
    assert ended.stdout.strip() == "[]", ended.stderr


def test_a_page_of_a_result_shows_numbers_and_replay(ball):
    page = ball.run()._repr_html_()
    assert "collision_rate" in page and "replay-data" in page and "<iframe" in page
    assert "mill.frequency" in ball._repr_html_() and "filling" in ball.check()._repr_html_()


def test_observers_in_several_threads_may_be_the_first_to_use_numpy(example):
    ended = python("import sys, mahlwerk\n"
                   "case = mahlwerk.Case(sys.argv[1], {'run.time': '1 s', 'run.settle': '0 s'})\n"
                   "seen = []\n"
                   "case.run(observers=[lambda records, k: seen.append(len(records))])\n"
                   "print(len(seen))", example("01-one-ball"))
    assert ended.stdout == "5\n", ended.stderr


def test_a_saved_result_has_the_records_that_were_kept(ball):
    result = ball.run(collisions=True)
    result.save("out")
    np.testing.assert_array_equal(mahlwerk.open("out").collisions(2), result.collisions(2))
    copy = pickle.loads(pickle.dumps(result))
    assert copy.folder == result.folder == Path("out").absolute()


def test_the_interpreter_ends_regularly_while_a_thread_computes(example):
    ended = python("import sys, threading, time, mahlwerk\n"
                   "case = mahlwerk.Case(sys.argv[1], {'run.time': '1000000 s'})\n"
                   "threading.Thread(target=case.run, args=('out',), daemon=True).start()\n"
                   "time.sleep(0.3); sys.exit(3)", example("01-one-ball"))
    assert ended.returncode == 3, ended.stderr
    assert not [p for p in Path(".").iterdir() if "lock" in p.name or "partial" in p.name]


def test_ctrl_c_ends_a_loop_of_short_commands():
    ended = python("import os, signal, threading, time, mahlwerk\n"
                   "threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
                   "end = time.monotonic() + 60\n"
                   "while time.monotonic() < end: mahlwerk.describe('retsch-mm400')")
    assert "Interrupt" in ended.stderr, ended.stderr


def test_what_is_wrong_with_arguments_is_said_at_once(ball):
    for observers in ([None], [print, 5]):
        with pytest.raises(TypeError, match="observer"):
            ball.run("out", observers=observers)
    for threads in (-1, 5000):
        with pytest.raises(ValueError, match="threads"):
            ball.run(threads=threads)
    with pytest.raises(mahlwerk.InputError, match="empty"):
        ball.run("")
    assert not os.path.exists("out")


def test_what_assumed_values_decide_is_in_the_result(example):
    source = mahlwerk.Case(example("03-planetary-mill"), {"run.time": "0.2 s"}).text
    lines = [line for line in source.splitlines()
             if not line.startswith(("restitution =", "restitution_law"))]
    case = mahlwerk.Case.from_text("\n".join(lines)).replace(
        {"run.time": "0.2 s", "run.settle": "0.1 s", "run.replicates": 5, "run.engine": "event"})
    result = case.run()
    first = result.sensitivity[0]
    assert first.key == "contact.restitution" and first.range == ("0.3", "0.9")
    low, high = result.assumed_range("dissipated_power")
    assert low <= min(first.at_ends["dissipated_power"]) < high
    assert low <= result["dissipated_power"].value <= high
    assert "over assumed values" in str(result)
    assert sum(map(len, result.groups.values())) == len(result.quantities)
    off = case.replace({"run.sensitivity": "off"}).run()
    assert off.sensitivity == [] and off.quantities == result.quantities


def test_numbers_have_the_texts_that_the_program_prints():
    table = json.loads((Path(__file__).parents[1] / "unit/report/numbers.json").read_text())
    assert len(table) > 60
    for told in table:
        quantity = Quantity("x", told["value"], told["ci95"], told["unit"], "", range=(
            -math.inf if told["least"] is None else told["least"],
            math.inf if told["most"] is None else told["most"]))
        assert quantity.text() == told["text"], told


def test_a_quantity_has_the_label_and_range_of_its_record(ball):
    made = ball.run()["grazing_share"]
    assert (made.label, made.range) == ("grazing share", (0, 1))
