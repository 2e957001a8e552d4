#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Makes the example recordings of this folder: synthetic, with noise, the same at every call.

    make_examples.py [FOLDER]

The true numbers are in TRUE; tests/unit/measure compares what `mahlwerk measure` finds with them.
"""
import math
import pathlib
import random
import struct
import sys

TRUE = {"frequency": 25.0, "arm": 136.0, "swing": 3.9, "scale": 0.25, "idle": 120.0, "load": 141.0,
        "hits": 60.0, "restitution": 0.62, "diameter": 26.7, "depth": 53.6}


def film_track(rng):
    """Two marks on the arm of a mixer mill, 1 at the middle of the jar, 2 60 mm nearer to the pivot; in pixels."""
    lines = ["frame,x1 (px),y1 (px),x2 (px),y2 (px)"]
    swing = math.radians(TRUE["swing"])
    for n in range(400):
        angle = swing * math.sin(2 * math.pi * TRUE["frequency"] * n / 800 + 0.4)
        cells = []
        for radius in (TRUE["arm"], TRUE["arm"] - 60):
            x = 200 + radius / TRUE["scale"] * math.sin(angle)
            y = 700 - radius / TRUE["scale"] * math.cos(angle)
            cells += [x + rng.gauss(0, 0.3), y + rng.gauss(0, 0.3)]
        lines.append(f"{n}," + ",".join(f"{c:.2f}" for c in cells))
    return "\n".join(lines) + "\n"


def film_pictures(rng):
    """A vibration mill: a bright mark of 3 px that moves 7 px up and down, 12.5 times in 80 pictures of 28 x 32 px."""
    pictures = b""
    for n in range(80):
        centre = 16 + 7 * math.sin(2 * math.pi * 12.5 * n / 80)
        row_of = lambda y: bytes(max(0, min(255, round(  # noqa: E731
            60 + 150 * math.exp(-((x - 13.3) ** 2 + (y - centre) ** 2) / 8) + rng.gauss(0, 4)))) for x in range(28))
        pictures += b"P5\n28 32\n255\n" + b"".join(row_of(y) for y in range(32))
    return pictures


def wav(samples, rate):
    data = b"".join(struct.pack("<h", max(-32767, min(32767, round(32767 * s)))) for s in samples)
    return (b"RIFF" + struct.pack("<I", 36 + len(data)) + b"WAVEfmt "
            + struct.pack("<IHHIIHH", 16, 1, 1, rate, 2 * rate, 2, 16) + b"data" + struct.pack("<I", len(data)) + data)


def add_hit(samples, rate, time, strength, tone, decay):
    begin = round(time * rate)
    for i in range(min(len(samples) - begin, round(8 * decay * rate))):
        samples[begin + i] += strength * math.exp(-i / (decay * rate)) * math.sin(2 * math.pi * tone * i / rate)


def mill_sound(rng):
    """Two seconds with 60 random hits per second that ring at 3.2 kHz, noise, and the hum of a motor."""
    rate = 16000
    samples = [rng.gauss(0, 0.002) + 0.05 * math.sin(2 * math.pi * 100 * i / rate) for i in range(2 * rate)]
    time = rng.expovariate(TRUE["hits"])
    while time < 2:
        add_hit(samples, rate, time, rng.uniform(0.1, 0.5), 3200, 0.0004)
        time += rng.expovariate(TRUE["hits"])
    return wav(samples, rate)


def drop_sound(rng):
    """A ball that falls 300 mm and bounces four times; the fall itself is silent."""
    rate = 8000
    samples = [rng.gauss(0, 0.002) for _ in range(round(1.3 * rate))]
    speed, time = math.sqrt(2 * 9.81 * 0.3), 0.1
    for _ in range(5):
        add_hit(samples, rate, time, 0.3 * speed, 2400, 0.0005)
        speed *= TRUE["restitution"] + rng.gauss(0, 0.005)
        time += 2 * speed / 9.81
    return wav(samples, rate)


def drop_heights(rng):
    """Eight drops onto powder: height of the fall and of the rebound."""
    lines = ["fall_height (mm),rebound_height (mm)"]
    for _ in range(8):
        lines.append(f"300,{300 * (TRUE['restitution'] + rng.gauss(0, 0.015)) ** 2:.0f}")
    return "\n".join(lines) + "\n"


def power_log(rng):
    """A plug meter in German: switched on, idle for 100 s, off, loaded for three minutes."""
    lines = ["Messgerät 7;;", "Zeit;Leistung (W);Spannung (V)"]
    slow = 0.0
    for second in range(310):
        slow = 0.8 * slow + rng.gauss(0, 0.6)
        level = TRUE["idle"] if 10 <= second < 110 else TRUE["load"] if second >= 130 else 4.0
        power = level + (slow if level > 10 else 0)
        clock = f"14:{30 + second // 60:02d}:{second % 60:02d}"
        lines.append(f"{clock};{power:.1f};230,{rng.randrange(10)}".replace(".", ","))
    return "\n".join(lines) + "\n"


def jar_readings(rng):
    """A jar with half-sphere ends, each length read three times, weighed empty and full of water."""
    d, length = TRUE["diameter"] / 10, TRUE["depth"] / 10
    water = 0.9982 * math.pi * (d * d * (length - d) / 4 + d ** 3 / 6)
    lines = ["diameter (mm),depth (mm),empty (g),full (g)"]
    for _ in range(3):
        lines.append(f"{TRUE['diameter'] + rng.gauss(0, 0.05):.2f},{TRUE['depth'] + rng.gauss(0, 0.05):.2f},"
                     f"{312.4 + rng.gauss(0, 0.03):.2f},{312.4 + water + rng.gauss(0, 0.05):.2f}")
    return "\n".join(lines) + "\n"


FILES = {"film-track.csv": film_track, "film.pgm": film_pictures, "mill.wav": mill_sound, "drop.wav": drop_sound,
         "drop-heights.csv": drop_heights, "power-log.csv": power_log, "jar.csv": jar_readings}


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
    for seed, (name, make) in enumerate(FILES.items(), 1):
        made = make(random.Random(seed))
        (folder / name).write_bytes(made if isinstance(made, bytes) else made.encode())


if __name__ == "__main__":
    main()
