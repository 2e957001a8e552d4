# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
import functools

import numpy as np

from mahlwerk.papers import Paper

DIAMETER = 0.165e-3  # [m]
CELL = 2 * DIAMETER  # of the height field: 24 balls stand in it
FRAMES = 4           # in a period of the drive


# The height field


def positions(file):
    """Centres of the balls [m], frame by frame, of a frames-1.xyz."""
    with open(file, encoding="utf-8") as lines:
        while line := lines.readline():
            count = int(line)
            lines.readline()
            rows = np.array("".join(next(lines) for _ in range(count)).split(), dtype=float)
            yield rows.reshape(count, -1)[:, 2:5]


def height_field(centres, side):
    """Mean height of the balls over each cell of the floor, less that of the layer [m]; cells without
    balls count as mean."""
    cells = round(side / CELL)
    at = np.clip(((centres[:, :2] / side + 0.5) * cells).astype(int), 0, cells - 1) @ (cells, 1)
    number = np.bincount(at, minlength=cells ** 2)
    total = np.bincount(at, centres[:, 2], cells ** 2)
    mean = centres[:, 2].mean()
    return (total / np.maximum(number, 1) - mean * (number > 0)).reshape(cells, cells)


@functools.cache
def fields_in(folder, side):
    every = np.array([height_field(one, side) for one in positions(folder / "frames-1.xyz")])
    phases = [every[phase::FRAMES] for phase in range(FRAMES)]
    return max(phases, key=lambda fields: fields.var())


def fields(result):
    """Height fields one period of the drive apart, at that of four phases with the largest contrast, and
    the side of the box [m]."""
    from mahlwerk import _core
    side = _core.quantity_in(result.case["jar.width"].strip('"'), "m")
    return fields_in(result.folder, side), side


# Period


def correlations(series, cycles):
    """Of each field with that so many cycles later: 1 if the pattern repeats, -1 if crests become troughs."""
    return (series[cycles:] * series[:-cycles]).mean(axis=(1, 2)) / (series ** 2).mean()


def repeats_after(series):
    """Cycles of the drive after which the pattern repeats: the first of 1 to 4 whose correlation is within
    a tenth of the largest."""
    found = [correlations(series, cycles).mean() for cycles in (1, 2, 3, 4)]
    return 1 + next(i for i, one in enumerate(found) if one >= 0.9 * max(found))


def mean_field(series):
    """Mean of the fields that show the same phase of the pattern."""
    return series[::-repeats_after(series)].mean(axis=0)


# Spectrum


def spectrum(field):
    """Power of the field under a Hann window by wave vector, and the lengths of the vectors [1/cell]."""
    cells, fine = len(field), 128
    window = np.hanning(cells + 2)[1:-1]
    window = np.outer(window, window)
    field = field - (field * window).sum() / window.sum()
    power = np.abs(np.fft.fft2(field * window, (fine, fine))) ** 2
    waves = 2 * np.pi * np.fft.fftfreq(fine)
    return power, np.hypot(waves[:, None], waves[None, :])


def wavelength(field, side):
    """Wavelength [m] on the ring of the spectrum, and half the distance to the next wave number that fits
    between the walls. The ring is 25 % wide to either side of the strongest wave with at least one and a half
    lengths in the box."""
    power, number = spectrum(field)
    power[number < 1.5 * 2 * np.pi / len(field)] = 0
    peak = number.flat[power.argmax()]
    ring = np.where(abs(number / peak - 1) < 0.25, power, 0)
    found = 2 * np.pi / ((ring * number).sum() / ring.sum()) * side / len(field)
    return found, found ** 2 / (4 * side)


def peaks(field):
    """Peaks of the spectrum above half the highest, within 40 % of its wave number: 2 of stripes, 4 of squares,
    6 of hexagons."""
    power, number = spectrum(field)
    power[number < 1.5 * 2 * np.pi / len(field)] = 0
    around = [np.roll(power, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    on_ring = abs(number / number.flat[power.argmax()] - 1) < 0.4
    return int(((power == np.max(around, axis=0)) & on_ring & (power > 0.5 * power.max())).sum())


# The statements

paper = Paper(title="Patterns of a vertically vibrated layer",
              source="C. Bizon, M. D. Shattuck, J. B. Swift, W. D. McCormick and H. L. Swinney, Phys. Rev. Lett. 80 "
                     "(1998) 57, figure 1, panels b, c and g; pattern, period and wavelength from the repository "
                     "cbizon/granular_benchmark of an author",
              about="A layer 5.4 diameters deep is shaken at 3, 4 and 6 g. In the experiment and in the authors' "
                    "simulation of 60000 balls, each panel beside the other, it shows stripes, hexagons and stripes that "
                    "repeat after 2, 2 and 4 cycles. We shake 15000 balls in a box of a quarter of the area "
                    "for 48 to 64 cycles, with the authors' restitution and friction. The wavelength is that of the "
                    "spectrum of the mean height; nothing is fitted.",
              licence="three patterns, cited as facts", quick=False)

patterns = paper.campaign("patterns")


def period(result):
    return repeats_after(fields(result)[0]), 0


def alike(series, cycles):
    """Mean correlation of fields so many cycles apart, and two standard errors over whole periods."""
    period = repeats_after(series)
    each = correlations(series, cycles)
    whole = each[:len(each) // period * period].reshape(-1, period).mean(axis=1)
    return whole.mean(), 2 * whole.std(ddof=1) / len(whole) ** 0.5


def after_period(result):
    series, _ = fields(result)
    return alike(series, repeats_after(series))


def after_half(result):
    series, _ = fields(result)
    return alike(series, max(1, repeats_after(series) // 2))


def length(result):
    series, side = fields(result)
    found, half = wavelength(mean_field(series), side)
    return found / DIAMETER, half / DIAMETER


def peaks_of(result):
    return peaks(mean_field(fields(result)[0])), 0


def map_of(result):
    return mean_field(fields(result)[0]), CELL


paper.quantity(patterns, "pattern_period", period)
paper.quantity(patterns, "pattern_wavelength", length)
paper.quantity(patterns, "pattern_peaks", peaks_of)
paper.quantity(patterns, "correlation_after_a_period", after_period)
paper.quantity(patterns, "correlation_after_half_a_period", after_half)

SOURCE = "patterns of figure 1, from the repository of an author"
AGAINST = {"against": "mill.frequency"}
measured_period = paper.measured("period", source=SOURCE, status="quoted", error_is="none: a number of cycles",
                                 values=[("46 Hz", "2", "0"), ("40 Hz", "2", "0"), ("88 Hz", "4", "0")])
measured_length = paper.measured(
    "wavelength", source=SOURCE, status="quoted",
    error_is="half the distance to the next number of waves in the source's box of 100 diameters",
    values=[("46 Hz", "20", "2"), ("40 Hz", "25", "3"), ("88 Hz", "20", "2")])
measured_peaks = paper.measured("peaks", source=SOURCE, status="quoted", error_is="none: stripes, hexagons, stripes",
                                values=[("46 Hz", "2", "0"), ("40 Hz", "6", "0"), ("88 Hz", "2", "0")])

paper.figure("1b, c, g", "height of the layer at 3 g (46 Hz), 4 g (40 Hz) and 6 g (88 Hz)", patterns.maps(map_of),
             about="Light: high; the mean over all counted cycles at which the pattern has the same phase")

paper.check("1b, c, g", "the pattern repeats after 2 (3 g), 2 (4 g) and 4 (6 g) cycles of the drive",
            patterns.agrees_with(measured_period, "pattern_period", **AGAINST))
paper.check("1b, c, g", "wavelength over diameter",
            patterns.agrees_with(measured_length, "pattern_wavelength", **AGAINST))
paper.check("1b, c, g", "peaks on the ring of the spectrum: 2 of stripes, 6 of hexagons",
            patterns.agrees_with(measured_peaks, "pattern_peaks", **AGAINST),
            why="at 3 g the stripes run in two directions after 64 cycles; whether more cycles or a larger box align them is "
                "not known")
paper.check("1b, c, g", "a period later the height field is the same (correlation above 0.5)",
            patterns.above("0.5", "correlation_after_a_period", **AGAINST), own=True)
paper.check("1b, c, g", "half a period later it is another (correlation below 0.5)",
            patterns.below("0.5", "correlation_after_half_a_period", **AGAINST), own=True)
