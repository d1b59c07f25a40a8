#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The EXR pictures that bench/peers writes and reads: exr_test.py PROGRAM"""
import random
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from array import array
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench" / "peers"))
import exr  # noqa: E402

PROGRAM = sys.argv.pop(1)


def packed_lines(rows):
    """Lines of bytes as OpenEXR's ZIP keeps them."""
    data = b"".join(rows)
    halves = data[0::2] + data[1::2]
    steps = bytes([halves[0]]) + bytes((b - a + 128) & 255 for a, b in zip(halves, halves[1:]))
    return zlib.compress(steps)


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def picture(self, width=5, height=19):
        rng = random.Random(2)
        return exr.Picture(width, height, array("f", (rng.uniform(0, 9) for _ in range(3 * width * height))))

    def test_a_picture_is_written_and_read(self):
        picture = self.picture()
        exr.write(self.folder / "a.exr", picture)
        self.assertEqual(exr.read(self.folder / "a.exr"), picture)

    def test_compressed_lines_are_read(self):
        picture = exr.Picture(40, 19, array("f", [x % 7 for x in range(3 * 40 * 19)]))
        exr.write(self.folder / "a.exr", picture)
        data = (self.folder / "a.exr").read_bytes()
        header_end = len(data) - 19 * (8 + 12 * 40) - 8 * 19
        kind = b"compression\0compression\0\1\0\0\0"
        header = data[:header_end].replace(kind + b"\0", kind + b"\3")
        lines = [data[-(19 - y) * 488:][8:488] for y in range(19)]
        blocks = [(0, packed_lines(lines[:16])), (16, packed_lines(lines[16:]))]
        offsets = struct.pack("<2Q", header_end + 16, header_end + 24 + len(blocks[0][1]))
        body = b"".join(struct.pack("<iI", y, len(block)) + block for y, block in blocks)
        (self.folder / "b.exr").write_bytes(header + offsets + body)
        self.assertEqual(exr.read(self.folder / "b.exr"), picture)

    def test_twinrays_pictures_are_read(self):
        path = self.folder / "a.exr"
        box = str(ROOT / "scenes" / "box.dae")
        subprocess.run([PROGRAM, box, "-q", "-r", "40", "30", "-s", "1", "-o", str(path)], check=True)
        picture = exr.read(path)
        self.assertEqual((picture.width, picture.height, len(picture.pixels)), (40, 30, 3600))
        red, blue = (sum(picture.pixels[3 * (40 * 15 + x) + c] for x in xs)
                     for c, xs in ((0, range(4)), (2, range(36, 40))))
        self.assertGreater(red, 0.01)
        self.assertGreater(blue, 0.01)

    def test_other_files_are_refused(self):
        (self.folder / "a.exr").write_bytes(b"no picture")
        with self.assertRaisesRegex(ValueError, "no OpenEXR file"):
            exr.read(self.folder / "a.exr")


if __name__ == "__main__":
    unittest.main()
