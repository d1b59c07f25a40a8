#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Environments over a square, drawn anew for peers."""
import json
import math
import unittest
from array import array

from scene_folder import Folder
import exr
import panorama


def direction_in_square(column, row):
    """The direction of a place in the square, by areas: those of rings around +z, and of an eighth of one."""
    x, y = 2 * column - 1, 2 * row - 1
    above = 1 - abs(x) - abs(y)
    ring = 1 - abs(above)  # A square ring of this half-diagonal has the area of the circle on the sphere.
    z = math.copysign(1 - ring * ring, above)
    part = 0 if ring == 0 else ((abs(y) - abs(x)) / ring + 1) / 2
    angle, horizontal = part * math.pi / 2, math.sqrt(max(0, 1 - z * z))
    return (math.copysign(horizontal * math.cos(angle), x), math.copysign(horizontal * math.sin(angle), y), z)


def sky(x, y, z):
    """Something smooth that differs everywhere."""
    return 2 + x + 0.5 * y * y, 1 + 0.7 * z, 1.5 - 0.3 * x * y


def square(size):
    places = ((column + 0.5, row + 0.5) for row in range(size) for column in range(size))
    return exr.Picture(size, size, array("f", (value for x, y in places
                                               for value in sky(*direction_in_square(x / size, y / size)))))


class Panoramas(Folder):
    def test_directions_have_their_places(self):
        self.assertEqual(panorama.place_in_square(0, 0, 1), (0.5, 0.5))
        for direction in ((1, 0, 0), (0, 1, 0), (0.6, -0.64, 0.48), (-0.48, 0.6, -0.64), (-0.8, -0.6, 0)):
            back = direction_in_square(*panorama.place_in_square(*direction))
            for a, b in zip(direction, back):
                self.assertAlmostEqual(a, b)

    def test_each_edge_is_folded_in_its_middle(self):
        for t in (0.1, 0.3, 0.5):
            for a, b in (((0, t), (0, 1 - t)), ((1, t), (1, 1 - t)), ((t, 0), (1 - t, 0)),
                         ((t, 1), (1 - t, 1))):
                for x, y in zip(direction_in_square(*a), direction_in_square(*b)):
                    self.assertAlmostEqual(x, y)
        for beside, pixel in (((-1, 2), (0, 5)), ((8, 2), (7, 5)), ((2, -1), (5, 0)), ((2, 8), (5, 7)),
                              ((-1, -1), (7, 7)), ((3, 4), (3, 4))):
            self.assertEqual(panorama.folded(*beside, 8), pixel)

    def test_a_sky_stays_what_it_is_in_all_directions(self):
        made = panorama.latitude_longitude(square(64), (1, 2, 1))
        self.assertEqual((made.width, made.height), (128, 64))
        for row in range(64):
            for column in range(128):
                seen = sky(*panorama.direction_of((column + 0.5) / 128, (row + 0.5) / 64))
                pixel = made.pixels[3 * (128 * row + column):][:3]
                for value, expected, factor in zip(pixel, seen, (1, 2, 1)):
                    self.assertLess(abs(value / factor - expected), 0.02)

    def test_the_scene_names_the_new_picture(self):
        exr.write(self.folder / "sky.exr", square(4))
        light = {"name": "sky", "type": "environment", "layout": "equal-area", "scale": [1, 2, 3],
                 "file": "sky.exr"}
        path = self.folder / "scene.json"
        path.write_text(json.dumps({"lights": [{"type": "point"}, light]}))
        panorama.draw_squares_anew(path)
        point, changed = json.loads(path.read_text())["lights"]
        self.assertEqual(point, {"type": "point"})
        self.assertEqual((changed["layout"], changed["scale"]), ("latitude-longitude", [1, 1, 1]))
        self.assertEqual(exr.size(self.folder / changed["file"]), (8, 4))


if __name__ == "__main__":
    unittest.main()
