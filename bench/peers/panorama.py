# SPDX-License-Identifier: Apache-2.0
"""Environments over a square, as pbrt-v4 has them, drawn anew as latitude-longitude maps for the peers."""
import json
import math
from array import array
from pathlib import Path

import exr


def direction_of(column, row):
    """Of a place in a latitude-longitude map, both in [0, 1]: as docs/exchange.md has it."""
    around, down = 2 * math.pi * (column - 0.5), math.pi * row
    return (math.sin(down) * math.cos(around), math.cos(down), -math.sin(down) * math.sin(around))


def place_in_square(x, y, z):
    """Of a unit direction (Clarberg 2008): the square is around +z, and all of its corners are -z."""
    r = math.sqrt(max(0.0, 1 - abs(z)))
    quarter = math.atan2(abs(y), abs(x)) * 2 / math.pi
    u, v = r - quarter * r, quarter * r
    if z < 0:
        u, v = 1 - v, 1 - u
    return 0.5 + 0.5 * math.copysign(u, x), 0.5 + 0.5 * math.copysign(v, y)


def folded(column, row, size):
    """The pixel beside an edge is one of that edge, for each is folded in its middle."""
    if not 0 <= column < size:
        column, row = min(max(column, 0), size - 1), size - 1 - row
    if not 0 <= row < size:
        column, row = size - 1 - column, min(max(row, 0), size - 1)
    return column, row


def interpolated(picture, column, row):
    """Bilinear, at a place in [0, 1] of a square."""
    x, y = column * picture.width - 0.5, row * picture.height - 0.5
    left, top = math.floor(x), math.floor(y)
    across, down = x - left, y - top
    sums = [0.0, 0.0, 0.0]
    for i, j, weight in ((0, 0, (1 - across) * (1 - down)), (1, 0, across * (1 - down)),
                         (0, 1, (1 - across) * down), (1, 1, across * down)):
        pixel_column, pixel_row = folded(left + i, top + j, picture.width)
        first = 3 * (pixel_row * picture.width + pixel_column)
        for k in range(3):
            sums[k] += weight * picture.pixels[first + k]
    return sums


def latitude_longitude(square, scale):
    """A map of twice as many columns and as many rows as the square has, times a colour."""
    width, height = 2 * square.width, square.height
    pixels = array("f")
    for row in range(height):
        for column in range(width):
            place = place_in_square(*direction_of((column + 0.5) / width, (row + 0.5) / height))
            pixels.extend(x * factor for x, factor in zip(interpolated(square, *place), scale))
    return exr.Picture(width, height, pixels)


def draw_squares_anew(path):
    """Changes a scene in exchange form, and writes the pictures beside it."""
    scene = json.loads(Path(path).read_text(encoding="utf-8"))
    for light in scene["lights"]:
        if light["type"] != "environment" or light["layout"] != "equal-area":
            continue
        file = Path(path).parent / light["file"]
        made = latitude_longitude(exr.read(file), light["scale"])
        light.update(layout="latitude-longitude", scale=[1, 1, 1], file=file.stem + "-panorama.exr")
        exr.write(file.with_name(light["file"]), made)
    Path(path).write_text(json.dumps(scene), encoding="utf-8")
