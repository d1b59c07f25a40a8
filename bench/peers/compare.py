# SPDX-License-Identifier: Apache-2.0
"""What the pictures of several renderers have in common, and how much noise each has.

Pixels that see a light are left out: renderers differ at its edges, and in whether it is seen at all.
"""
from array import array
from dataclasses import dataclass

TILES = (16, 12)       # across and down
TILE_TOLERANCE = 0.02  # of a tile's mean, or of DARK of the picture's mean where the tile is darker than that
DARK = 0.25
MEAN_TOLERANCE = 0.003


@dataclass
class Agreement:
    mean_ratio: float   # of the picture to that which it is compared with
    tile_difference: float  # the largest of all tiles, as TILE_TOLERANCE

    def is_good(self):
        return abs(self.mean_ratio - 1) < MEAN_TOLERANCE and self.tile_difference < TILE_TOLERANCE


def mean_picture(pictures):
    """The mean of equally large pictures' numbers."""
    return array("f", (sum(values) / len(values) for values in zip(*pictures)))


def mean_without(mean, count, picture):
    """The mean of the others, where the picture is one of `count` that have this mean."""
    return array("f", ((m * count - x) / (count - 1) for m, x in zip(mean, picture)))


def without_lights(pictures, width, height, limit):
    """For each pixel, whether no picture has a number of at least `limit` there or beside it."""
    seen = {i // 3 for picture in pictures for i, value in enumerate(picture) if value >= limit}
    near = {(x + dx, y + dy) for y, x in (divmod(pixel, width) for pixel in seen)
            for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
    return [(i % width, i // width) not in near for i in range(width * height)]


def tile_means(picture, mask, width, height):
    """The mean of each tile's three channels; of a tile without pixels nothing."""
    across, down = TILES
    sums, counts = [0.0] * (across * down), [0] * (across * down)
    for pixel, kept in enumerate(mask):
        if kept:
            tile = pixel // width * down // height * across + pixel % width * across // width
            sums[tile] += picture[3 * pixel] + picture[3 * pixel + 1] + picture[3 * pixel + 2]
            counts[tile] += 3
    return [total / count if count else 0 for total, count in zip(sums, counts)], counts


def agreement(picture, other, mask, width, height):
    ours, counts = tile_means(picture, mask, width, height)
    theirs, _ = tile_means(other, mask, width, height)
    whole = sum(counts)
    mean = sum(value * count for value, count in zip(theirs, counts)) / whole
    mean_of_picture = sum(value * count for value, count in zip(ours, counts)) / whole
    worst = max(abs(a - b) / max(b, DARK * mean) for a, b in zip(ours, theirs))
    return Agreement(mean_of_picture / mean, worst)


def error(picture, reference, other_reference, mask):
    """The mean squared error. Two references whose noise is independent add nothing to it: in the mean
    (x - a) (x - b) only the picture's own noise is left, and the bias that both references show."""
    total, count = 0.0, 0
    for pixel, kept in enumerate(mask):
        if kept:
            for i in range(3 * pixel, 3 * pixel + 3):
                total += (picture[i] - reference[i]) * (picture[i] - other_reference[i])
            count += 3
    return total / count
