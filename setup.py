# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Builds the Python package: CMake makes the module mahlwerk._core, and the data are copied beside it.

MAHLWERK_BUILD names another build folder than build/python, CMAKE_BUILD_PARALLEL_LEVEL limits the
compilers at work.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

HOME = pathlib.Path(__file__).resolve().parent
BUILD = HOME / os.environ.get("MAHLWERK_BUILD", "build/python")
DATA = ("catalogue", "papers", "validation", "examples")


class CMakeModule(build_ext):
    """The module, built by CMake for the Python that runs this. CMake remembers the path of Python:
    it must not be that of a virtual environment, which may be removed."""

    def build_extension(self, extension):
        subprocess.run(["cmake", "-S", HOME, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Release",
                        *([] if (BUILD / "CMakeCache.txt").exists() else generator()),
                        "-DMAHLWERK_PYTHON=ON", "-DMAHLWERK_BENCH=OFF",
                        f"-DPython_EXECUTABLE={os.path.realpath(sys.executable)}"], check=True)
        subprocess.run(["cmake", "--build", BUILD, "--target", "mahlwerk_python"], check=True)
        (made,) = (BUILD / "python/mahlwerk").glob("_core*.so")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(made, target.with_name(made.name))
        if shutil.which("strip"):
            subprocess.run(["strip", "--strip-unneeded", target.with_name(made.name)], check=True)


class WithData(build_py):
    """The files of the package, and the data of Mahlwerk in its folder data."""

    def run(self):
        super().run()
        for part in DATA:
            shutil.copytree(HOME / part, pathlib.Path(self.build_lib) / "mahlwerk/data" / part,
                            dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))


def generator():
    return ["-G", "Ninja"] if shutil.which("ninja") else []


def version():
    return re.search(r"project\(mahlwerk VERSION ([\d.]+)", (HOME / "CMakeLists.txt").read_text())[1]


BUILD.mkdir(parents=True, exist_ok=True)  # everything that is made here stays in the build folder
setup(version=version(), packages=["mahlwerk", "mahlwerk.papers"], package_dir={"": "python"},
      package_data={"mahlwerk": ["py.typed", "*.pyi"]},
      ext_modules=[Extension("mahlwerk._core", sources=[])],
      cmdclass={"build_ext": CMakeModule, "build_py": WithData},
      options={"egg_info": {"egg_base": os.fspath(BUILD)},
               "build": {"build_base": os.fspath(BUILD / "wheel")},
               "bdist_wheel": {"bdist_dir": os.fspath(BUILD / "wheel/unpacked")}})
