# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The folder in which the commands and the Python blocks of a document run."""
import os
import pathlib
import shutil

HOME = pathlib.Path(__file__).resolve().parents[2]
COPIED = ("examples", "papers", "validation", "catalogue", "docs", "tools")
# A scheduler that accepts every job. campaign.slurm_jobs_... runs real ones where Slurm is installed.
SBATCH = "#!/bin/sh\ncase \"$*\" in *--parsable*) echo 1;; *) echo Submitted batch job 1;; esac\n"


def copy_sources(place: pathlib.Path) -> None:
    for name in COPIED:
        shutil.copytree(HOME / name, place / name)
    shutil.copytree(HOME / "tests" / "docs" / "cases", place / "cases")


def scratch_folder(program: str, place: pathlib.Path) -> dict[str, str]:
    """Makes the folder in which commands run; returns their environment."""
    copy_sources(place)
    (place / "mahlwerk").symlink_to(program)
    tools = place / ".bin"
    tools.mkdir()
    (tools / "mahlwerk").symlink_to(program)
    (tools / "sbatch").write_text(SBATCH)
    (tools / "sbatch").chmod(0o755)
    return dict(os.environ, PATH=f"{tools}:{os.environ['PATH']}", PYTHONDONTWRITEBYTECODE="1")
