#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Tests what `cmake --install` makes: the program with its data, manual pages and completions, and
the library for users' programs.

  install_test.py BUILD_FOLDER TEST
"""
import contextlib
import gzip
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77


def run(*words, code=0, **more):
    done = subprocess.run([str(word) for word in words], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **more)
    assert done.returncode == code, f"{words} ended with {done.returncode}:\n{done.stdout}"
    return done.stdout


@contextlib.contextmanager
def installation(build):
    """An installation that was moved after it was made, in a folder with a space in its name."""
    with tempfile.TemporaryDirectory(prefix="mahlwerk-") as name:
        place = pathlib.Path(name)
        run("cmake", "--install", build, "--prefix", place / "first")
        moved = place / "moved here"
        (place / "first").rename(moved)
        yield moved, place


def clean():
    return {name: value for name, value in os.environ.items() if not name.startswith("MAHLWERK")}


def a_moved_installation_finds_its_data_and_reads_nothing_of_the_sources(build):
    with installation(build) as (moved, place):
        program = moved / "bin/mahlwerk"
        assert str(SOURCE).encode() not in program.read_bytes(), "a path of the sources is compiled in"
        for part in ("catalogue", "papers", "validation", "examples"):
            there = sorted(p.relative_to(SOURCE) for p in (SOURCE / part).rglob("*.toml"))
            assert there == sorted(p.relative_to(moved / "share/mahlwerk")
                                   for p in (moved / "share/mahlwerk" / part).rglob("*.toml"))
        assert "fritsch-p7-classic" in run(program, "list", "mills", cwd=place, env=clean())
        start = re.search(r"Start with: +mahlwerk run (.*)", run(program, "--help", cwd=place))
        assert pathlib.Path(start[1]) == moved / "share/mahlwerk/examples/01-one-ball", start[1]
        said = run(program, "run", start[1], "--set", "run.time=1 s", cwd=place, env=clean())
        assert "collision rate" in said
        link = place / "link"
        link.symlink_to(program)
        assert "fritsch-p7-classic" in run(link, "list", "mills", cwd=place, env=clean())


def an_incomplete_installation_says_what_is_missing(build):
    with installation(build) as (moved, place):
        shutil.rmtree(moved / "share/mahlwerk/catalogue")
        said = run(moved / "bin/mahlwerk", "list", code=2, cwd=place, env=clean())
        assert "share/mahlwerk/catalogue" in said and "#no-data" in said, said
        run(moved / "bin/mahlwerk", "--help", cwd=place, env=clean())
        other = {**clean(), "MAHLWERK_CATALOGUE": str(SOURCE / "catalogue")}
        assert "fritsch-p7-classic" in run(moved / "bin/mahlwerk", "list", cwd=place, env=other)


def pages_of(moved):
    for file in sorted((moved / "share/man/man1").iterdir()):
        data = file.read_bytes()
        yield file.name.split(".")[0], (gzip.decompress(data) if file.suffix == ".gz" else data).decode()


def every_command_has_a_manual_page_with_all_its_options(build):
    with installation(build) as (moved, place):
        program, pages = moved / "bin/mahlwerk", dict(pages_of(moved))
        commands = re.findall(r"^  ([\w-]+) ", run(program, "--help").split("\nCommands:")[1], re.M)
        assert sorted(pages) == sorted(["mahlwerk"] + [f"mahlwerk-{one}" for one in commands])
        for command in commands:
            text = pages[f"mahlwerk-{command}"].replace("\\-", "-")
            shown = run(program, command, "--help")
            for part in re.findall(r"^  ([\w-]+) ", shown.partition("\nCommands:")[2], re.M):
                shown += run(program, command, part, "--help")
            options = set(re.findall(r"^ +(?:-\w,)?(--[\w,-]+)", shown, re.M)) - {"--help", "--color"}
            assert command in ("completion", "help", "manual") or options, shown
            for option in ",".join(options).split(","):
                assert f"\\fB{option}\\fR" in text or not option, f"{command}: no {option} in\n{text}"
            assert f"\\fBmahlwerk-{command}\\fR(1)" in pages["mahlwerk"].replace("\\-", "-")
        if shutil.which("groff"):
            for name, text in pages.items():
                said = run("groff", "-man", "-ww", "-Tutf8", "-z", input=text)
                assert not said, f"{name}: {said}"


def completions_are_installed_where_shells_look_for_them(build):
    with installation(build) as (moved, place):
        (file,) = moved.glob("share/bash-completion/completions/mahlwerk")
        asks = (f"source '{file}'; COMP_WORDS=(mahlwerk sw) COMP_CWORD=1; _mahlwerk; "
                "echo ${COMPREPLY[@]}; COMP_WORDS=(mahlwerk te); _mahlwerk; echo none: ${COMPREPLY[@]}; "
                "COMP_WORDS=(./mahlwerk te); _mahlwerk; echo ${COMPREPLY[@]}")
        assert run("bash", "-c", asks, cwd=place).split("\n") == ["sweep", "none:", "test", ""]
        (file,) = moved.glob("share/zsh/*/_mahlwerk")
        assert file.read_text().startswith("#compdef mahlwerk\n")


def rate_of_the_program(moved, place):
    run(moved / "bin/mahlwerk", "run", SOURCE / "examples/01-one-ball", "--out", place / "out",
        "--quiet")
    one = json.loads((place / "out/summary.json").read_text())["collision_rate"]
    return f"{one['value']:.6g}"


def commands_of(file, heading):
    """The commands of the first block below a heading of a document."""
    text = (SOURCE / file).read_text().split(f"\n## {heading}\n")[1]
    return re.search(r"```sh\n(.*?)```", text, re.S)[1].splitlines()


def the_commands_of_the_page_install_build_a_program_of_a_user_and_uninstall(build):
    with tempfile.TemporaryDirectory(prefix="mahlwerk-") as name:
        here = pathlib.Path(name)
        (here / "build").mkdir()
        (here / "build/release").symlink_to(build)
        (here / "examples").symlink_to(SOURCE / "examples")
        env = {**clean(), "HOME": str(here)}
        lines = [line for heading in ("From the sources", "C++")
                 for line in commands_of("docs/install.md", heading) if line[0] != "."]
        assert len(lines) == 6, lines
        for line in lines:
            said = run("sh", "-c", line, cwd=here, env=env)
        rate = said.split()[0]
        assert rate == rate_of_the_program(here / "mahlwerk", here), said
        said = run(here / "build/own/collision_rate", code=2, cwd=here)
        assert "case.toml: there is no such case file" in said, said
        (uninstall,) = commands_of("docs/install.md", "Uninstall")
        run("sh", "-c", uninstall, cwd=here, env=env)
        left = [str(p) for p in (here / "mahlwerk").rglob("*") if p.is_symlink() or not p.is_dir()]
        assert not left, left


ROUNDING = """
#include <cstdio>
#include <mahlwerk/base/vec3.hpp>
int main() {
  const volatile double third = 1.0 / 3, seventh = 1.0 / 7;
  for (int i = 1; i < 100; ++i) {
    const mahlwerk::Vec3 a{third * i, seventh, 1.1}, b{seventh * i, third, 0.7 * i};
    std::printf("%a %a\\n", dot(a, b), cross(a, b).x);
  }
}
"""
PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(rounding LANGUAGES CXX)
find_package(Mahlwerk REQUIRED)
add_executable(rounding rounding.cpp)
target_link_libraries(rounding PRIVATE Mahlwerk::mahlwerk)
"""


def inline_code_of_the_headers_rounds_alike_for_any_march(build):
    with installation(build) as (moved, place):
        (place / "rounding.cpp").write_text(ROUNDING)
        (place / "CMakeLists.txt").write_text(PROJECT)
        said = set()
        for flags in ("-O0", "-O3 -march=native"):
            run("cmake", "-G", "Ninja", "-S", place, "-B", place / "own", f"-DCMAKE_PREFIX_PATH={moved}",
                f"-DCMAKE_CXX_FLAGS={flags}")
            run("cmake", "--build", place / "own")
            said.add(run(place / "own/rounding"))
        assert len(said) == 1, "-march=native changes the last bits"


def a_program_that_finds_the_library_by_pkg_config_runs(build):
    if not shutil.which("pkg-config"):
        sys.exit(SKIPPED)
    with installation(build) as (moved, place):
        (file,) = moved.rglob("mahlwerk.pc")
        env = {**clean(), "PKG_CONFIG_PATH": str(file.parent)}
        data = run("pkg-config", "--variable=datadir", "mahlwerk", env=env).strip()
        code = SOURCE / "examples/cpp/collision_rate.cpp"
        run("sh", "-c", 'eval "c++ -O1 \'$0\' -o own \'-DMAHLWERK_DATA_FOLDER=\\"$1\\"\' '
            '$(pkg-config --cflags --libs mahlwerk)"', code, data.replace("\\", ""), cwd=place, env=env)
        said = run(place / "own", SOURCE / "examples/01-one-ball/case.toml", cwd=place)
        assert said.split()[0] == rate_of_the_program(moved, place), said


if __name__ == "__main__":
    globals()[sys.argv[2]](pathlib.Path(sys.argv[1]).resolve())
