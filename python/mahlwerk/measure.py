# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Numbers of a mill from films, sounds, power logs, weighed jars and drop tests, as `mahlwerk measure`.

Each function reads a recording and returns a `Measurement`. A length, a time or another quantity is a text with its
unit, and with its error where it has one: "80 +- 0.5 mm". All raise InputError for a file that cannot be used.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Optional, Union

from .case_source import Place
from .measurement import Measurement, texts

__all__ = ["drop", "film", "jar", "power", "sound"]

Number = Union[float, str]  # of frames or pixels, which have no unit


def __dir__() -> list[str]:
    return __all__


def number_text(value: Optional[Number]) -> Optional[str]:
    return None if value is None else str(value)


def film(file: Place, *, mill: Optional[str] = None, kind: Optional[str] = None, fps: Optional[Number] = None,
         frequency: Optional[str] = None, speed: Optional[str] = None, scale: Optional[str] = None,
         distance: Optional[str] = None, arm: Optional[str] = None, marks: Sequence[tuple[float, float]] = (),
         window: Optional[Number] = None, columns: Optional[str] = None, tracks: Optional[Place] = None,
         title: Optional[str] = None) -> Measurement:
    """Stroke, arm, swing, radius and ratio of a mill from marks in a film.

    >>> mahlwerk.measure.film("examples/measure/film-track.csv", mill="MM 400", fps=800, distance="60 +- 0.3 mm")

    file       a table of positions (CSV: time or frame, x1, y1, x2, y2) or pictures, one behind the other (PGM, PPM)
    mill       a mill of the catalogue, whose other values the entry keeps; or `kind` of a mill that is not there
    fps        frames per second of the camera, where the table has no times; or `frequency` or `speed`, as set
    scale      length of a pixel; or `distance` between marks 1 and 2
    arm        of a mixer mill with one mark: from the pivot to the middle of the jar
    marks      (x, y) of each mark in the first picture, in pixels from the left and the top
    window     side of the square in which a mark is searched, in pixels
    columns    headings in place of those of the table: "time (s), x1 (px), y1 (px)"
    tracks     file for the positions that were found in the pictures
    title      of the catalogue entry
    """
    return Measurement("film", {
        "file": os.fspath(file), "mill": mill, "kind": kind, "fps": number_text(fps), "frequency": frequency,
        "speed": speed, "scale": scale, "distance": distance, "arm": arm,
        "mark": [f"{x},{y}" for x, y in marks], "window": number_text(window), "columns": columns,
        "tracks": tracks, "title": title})


def sound(file: Place, *, start: Optional[str] = None, end: Optional[str] = None,
          definition_time: Optional[str] = None, rise: Optional[Number] = None, low_cut: Optional[str] = None,
          spectrum: Optional[Place] = None) -> Measurement:
    """Hits per second and the spectrum of a recording (WAV).

    >>> mahlwerk.measure.sound("examples/measure/mill.wav").findings[0].value

    start            begin of the part to use: "2 s" (--from)
    end              its end (--to)
    definition_time  hits with shorter intervals are one; 1 ms without it
    rise             how far a hit rises above the noise and what is before it, in dB; 12 without it
    low_cut          frequencies below are left out; 1 kHz without it, "0 Hz": none
    spectrum         file for the spectrum (CSV)
    """
    return Measurement("sound", {"file": os.fspath(file), "from": start, "to": end,
                                 "definition_time": definition_time, "rise": number_text(rise),
                                 "low_cut": low_cut, "spectrum": spectrum})


def power(file: Place, *, idle: Union[None, str, Place] = None, load: Optional[str] = None,
          columns: Optional[str] = None, accuracy: Optional[str] = None, efficiency: Optional[str] = None,
          jars: int = 1) -> Measurement:
    """Idle and loaded power of a mill from the log of a power meter.

    >>> mahlwerk.measure.power("examples/measure/power-log.csv", accuracy="1 %")["power_meter.idle_power"].value

    file        a log (CSV: power, and time where parts are given)
    idle        the mill with empty jars: a part of the log, "15 s to 105 s", or another log; without it the lower of
                two levels
    load        the part with the filled jars: "135 s to 300 s"
    columns     headings in place of those of the log
    accuracy    error of the meter
    efficiency  of the drive, if you know it: "0.8 +- 0.1"
    jars        number of filled jars, 1 to 100
    """
    return Measurement("power", {"file": os.fspath(file), "idle": None if idle is None else os.fspath(idle),
                                 "load": load, "columns": columns, "accuracy": accuracy,
                                 "efficiency": efficiency, "jars": jars})


def jar(file: Place, shape: str, *, columns: Optional[str] = None, caliper: Optional[str] = None,
        balance: Optional[str] = None, material: Optional[str] = None, title: Optional[str] = None) -> Measurement:
    """Sizes and volume of a jar from a caliper, a balance and water.

    >>> mahlwerk.measure.jar("examples/measure/jar.csv", "capsule")["jar.diameter"].value

    file      readings (CSV: diameter, depth, water or empty and full, wall), repeated in rows
    shape     of the inside: "cylinder", "capsule", "sphere", "rounded-cylinder"
    columns   headings in place of those of the table
    caliper   error of a length; 0.1 mm without it
    balance   error of a mass; 0.1 g without it
    material  of the wall, of the catalogue
    title     of the catalogue entry
    """
    return Measurement("jar", {"file": os.fspath(file), "shape": shape, "columns": columns, "caliper": caliper,
                               "balance": balance, "material": material, "title": title})


def drop(files: Union[Place, list[Place], tuple[Place, ...]], *, height: Optional[str] = None,
         columns: Optional[str] = None, start: Optional[str] = None, end: Optional[str] = None,
         definition_time: Optional[str] = None, rise: Optional[Number] = None,
         low_cut: Optional[str] = None) -> Measurement:
    """Restitution from the bounces of a dropped ball.

    >>> mahlwerk.measure.drop("examples/measure/drop.wav", height="300 mm")["contact.restitution"].value

    files   heights or times of bounces (CSV), or recordings (WAV)
    height  of the fall, where the files have times or sound
    columns  headings in place of those of the tables

    `start`, `end`, `definition_time`, `rise` and `low_cut` are those of `sound`; hits within 2 ms are one.
    """
    return Measurement("drop", {"files": texts(files), "height": height, "columns": columns, "from": start,
                                "to": end, "definition_time": definition_time, "rise": number_text(rise),
                                "low_cut": low_cut})
