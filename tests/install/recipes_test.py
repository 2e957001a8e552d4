# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The recipes that no test builds name this version, every library of cmake/libraries.cmake, and files and packages that exist.

  recipes_test.py              packaging/conda/meta.yaml, packaging/Dockerfile, the packages that docs/install.md names
  recipes_test.py self-test

A check whose tool is missing (jinja2, yaml, apt-cache) is left out, with a line that says so.
"""
import importlib.util
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

HOME = pathlib.Path(__file__).resolve().parents[2]
# Names in cmake/libraries.cmake, and the package of conda-forge.
CONDA = {"tomlplusplus": "tomlplusplus", "nlohmann_json": "nlohmann_json", "CLI11": "cli11", "fmt": "fmt", "Eigen3": "eigen",
         "NLopt": "nlopt", "Boost": "libboost-headers", "SQLite3": "libsqlite", "HDF5": "hdf5"}
APT = re.compile(r"apt(?:-get)? install\s+(.*)")


def rendered(recipe: pathlib.Path) -> dict:
    """The recipe as conda-build reads it: jinja2 with its functions, then YAML."""
    import jinja2
    import yaml

    def load_file_regex(load_file: str, regex_pattern: str, from_recipe_dir: bool = False):
        return re.search(regex_pattern, (recipe.parent / load_file).read_text() if from_recipe_dir else "")

    template = jinja2.Environment(undefined=jinja2.StrictUndefined).from_string(recipe.read_text())
    return yaml.safe_load(template.render(load_file_regex=load_file_regex, compiler=lambda language: f"{language}-compiler"))


def libraries() -> dict[str, str]:
    """Libraries that CMake asks for: name, least version."""
    return dict(re.findall(r"find_package\((\w+) ([\d.]+)", (HOME / "cmake/libraries.cmake").read_text()))


def check_conda(recipe: dict) -> list[str]:
    version = re.search(r"project\(mahlwerk VERSION ([\d.]+)", (HOME / "CMakeLists.txt").read_text())[1]
    faults = [] if recipe["package"]["version"] == version else [
        f"the recipe of conda has the version {recipe['package']['version']}, CMake {version}"]
    host = dict(one.split(" >=") for one in recipe["requirements"]["host"])
    wanted = {CONDA.get(name, name): least for name, least in libraries().items()}
    if host != wanted:
        faults.append(f"the recipe of conda wants {host}, CMake {wanted}")
    for file in recipe["about"]["license_file"]:
        if not (HOME / file).exists():
            faults.append(f"the recipe of conda names {file}, which is missing")
    return faults


def commands(text: str) -> str:
    """The text with continued lines joined."""
    return re.sub(r"\\\n\s*", " ", text)


def apt_names(text: str) -> set[str]:
    """Names of Debian's packages that commands of a text install."""
    found = set()
    for line in APT.findall(commands(text)):
        for word in shlex.split(line.split("&&")[0].split("`")[0], comments=True):
            if not word.startswith(("-", ".", "/")):
                found.add(word)
    return found


def unknown_packages(names: set[str]) -> list[str]:
    said = subprocess.run(["apt-cache", "show", "--no-all-versions", "bash", *sorted(names)], capture_output=True, text=True).stdout
    known = set(re.findall(r"^Package: (\S+)", said, re.M))
    if "bash" not in known:
        print("not checked: apt has no list of packages")
        return []
    return sorted(names - known)


def check_dockerfile(text: str) -> list[str]:
    faults = []
    for words in (line.split()[1:-1] for line in commands(text).splitlines() if line.startswith("COPY ")):
        faults += [f"the Dockerfile copies {word}, which is missing" for word in words if not (HOME / word).exists()]
    for word in re.findall(r"(?<=\s)(?:\./mahlwerk|tools/\w+)(?=\s|$)", re.sub(r"^#.*", "", commands(text), flags=re.M)):
        if not (HOME / word).exists():
            faults.append(f"the Dockerfile starts {word}, which is missing")
    ignored = (HOME / "packaging/Dockerfile.dockerignore").read_text().split()
    tracked = subprocess.run(["git", "-C", str(HOME), "ls-files", *ignored], capture_output=True, text=True).stdout.split()
    return faults + [f"the container lacks {file} (Dockerfile.dockerignore)" for file in tracked]


def self_test() -> None:
    assert apt_names("RUN apt-get update \\\n && apt-get install -y --no-install-recommends a b-dev \\\n && c") == {"a", "b-dev"}
    assert apt_names("sudo apt-get install ./x.deb python3-venv  # why") == {"python3-venv"}
    assert check_dockerfile("COPY nowhere /x\nRUN tools/nothing --x\n") == [
        "the Dockerfile copies nowhere, which is missing", "the Dockerfile starts tools/nothing, which is missing"]
    if shutil.which("apt-cache"):
        assert unknown_packages({"bash", "no-such-package-1"}) in (["no-such-package-1"], [])
    print("the reader of recipes is sound")


def main() -> int:
    if sys.argv[1:] == ["self-test"]:
        self_test()
        return 0
    docker, faults = (HOME / "packaging/Dockerfile").read_text(), []
    if missing := [one for one in ("jinja2", "yaml") if importlib.util.find_spec(one) is None]:
        print(f"not checked without {', '.join(missing)}: the recipe of conda")
    else:
        faults += check_conda(rendered(HOME / "packaging/conda/meta.yaml"))
    faults += check_dockerfile(docker)
    if shutil.which("apt-cache"):
        names = apt_names(docker) | apt_names((HOME / "docs/install.md").read_text())
        faults += [f"Debian has no package {name}" for name in unknown_packages(names)]
    else:
        print("not checked without apt-cache: names of Debian's packages")
    print("\n".join(faults + [f"{len(faults)} faults"]))
    return 1 if faults else 0


sys.exit(main())
