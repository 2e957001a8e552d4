# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a screenshot shows: its pixels, how many colours, what changed from another."""

import struct
import zlib


def pixels(png):
    """Width and rows of (red, green, blue) of an 8-bit RGB or RGBA PNG (W3C PNG, section 9)."""
    at, body = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", png[at + 8:at + 18])
        elif kind == b"IDAT":
            body += png[at + 8:at + 8 + length]
        at += 12 + length
    assert depth == 8 and colour in (2, 6), "a PNG of another kind"
    step = 3 if colour == 2 else 4
    raw, before, rows = zlib.decompress(body), bytearray(width * step), []
    for y in range(height):
        start = y * (width * step + 1)
        row = bytearray(raw[start + 1:start + 1 + width * step])
        unfilter(raw[start], row, before, step)
        rows.append([tuple(row[x:x + 3]) for x in range(0, len(row), step)])
        before = row
    return width, rows


def unfilter(kind, row, before, step):
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        corner = before[i - step] if i >= step else 0
        up = before[i]
        if kind == 1:
            row[i] = row[i] + left & 255
        elif kind == 2:
            row[i] = row[i] + up & 255
        elif kind == 3:
            row[i] = row[i] + (left + up) // 2 & 255
        elif kind == 4:
            guess = left + up - corner
            row[i] = row[i] + min((left, up, corner), key=lambda v: abs(guess - v)) & 255


def colours(png):
    return len({colour for row in pixels(png)[1] for colour in row})


def changed(a, b):
    """Part of the pixels that differ between two pictures of one size. Up to two of 255 levels may
    be rounding: a turn there and back in single precision does not end quite where it began."""
    rows_a, rows_b = pixels(a)[1], pixels(b)[1]
    assert len(rows_a) == len(rows_b) and len(rows_a[0]) == len(rows_b[0])
    different = sum(max(abs(i - j) for i, j in zip(p, q)) > 2
                    for x, y in zip(rows_a, rows_b) for p, q in zip(x, y) if p != q)
    return different / (len(rows_a) * len(rows_a[0]))
