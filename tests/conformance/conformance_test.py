#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The conformance command judges a small suite of its own, by a program that stands in for twinray."""
import contextlib
import csv
import io
import random
import stat
import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

import conformance
import silhouette
import suite

# Copies the picture that the scene file names; or does what it says.
PROGRAM = """#!{python}
import os, shutil, sys, time
words = sys.argv[1:]
text = open(words[1]).read().replace(" <instance_camera", "").replace(' name="testCamera"', "")
what, _, name = text.partition(" ")
if ("--camera-name=testCamera" in words) != ("camera" in what):
    sys.exit(3)
if what == "error":
    sys.exit("warning: w\\ntwinray: " + words[1] + ":3:4: " + name)
if what == "crash":
    os.abort()
if what == "hang":
    time.sleep(60)
shutil.copy(os.path.join(os.path.dirname(words[1]), name), words[words.index("-o") + 1])
"""


def filtered(kind, line, above, step):
    """A line as PNG writes it, from the definition of the five filters."""
    result = bytearray([kind])
    for i, x in enumerate(line):
        a, b = line[i - step] if i >= step else 0, above[i]
        c = above[i - step] if i >= step else 0
        near = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        result.append((x - (0, a, b, (a + b) // 2, near)[kind]) & 255)
    return bytes(result)


def png(width, height, channels, values, kinds=(0,)):
    step, lines, above = width * channels, b"", bytes(width * channels)
    for y in range(height):
        line = values[y * step:(y + 1) * step]
        lines += filtered(kinds[y % len(kinds)], line, above, channels)
        above = line

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", width, height, 8, {2: 4, 3: 2, 4: 6}[channels], 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines)) +
            chunk(b"IEND", b""))


def square(side, size=8, channels=4):
    """A picture of a square of that side in its left top corner."""
    return png(size, size, channels, b"".join(
        bytes([200] * channels) if x < side and y < side else bytes(channels)
        for y in range(size) for x in range(size)))


class Silhouettes(unittest.TestCase):
    def test_every_filter_of_png_is_undone(self):
        source = random.Random(1)
        for channels in (2, 3, 4):
            for kinds in ((0,), (1,), (2,), (3,), (4,), (4, 3, 2, 1, 0)):
                values = bytes(source.choices(range(256), k=9 * 7 * channels))
                picture = silhouette.Picture(png(9, 7, channels, values, kinds))
                for channel in range(channels):
                    self.assertEqual(picture.channel(channel), values[channel::channels])

    def test_what_is_no_picture_is_refused(self):
        for data in (b"", b"GIF89a", b"\x89PNG\r\n\x1a\n", square(4)[:40]):
            with self.assertRaises((silhouette.PictureError, zlib.error)):
                silhouette.Picture(data)
        with self.assertRaises(silhouette.PictureError):
            silhouette.opaque(silhouette.Picture(square(4, channels=3)))

    def test_a_normal_along_an_axis_is_seen(self):
        picture = silhouette.Picture(png(4, 1, 3, bytes([0, 128, 128, 128, 0, 128, 128, 128, 0, 0, 0, 0])))
        self.assertEqual(silhouette.not_black(picture), bytes([1, 1, 1, 0]))

    def test_likeness_is_intersection_over_union(self):
        self.assertEqual(silhouette.likeness(bytes([1, 1, 1, 0]), bytes([0, 1, 1, 1])), 0.5)
        self.assertEqual(silhouette.likeness(bytes(4), bytes(4)), 1)
        self.assertEqual(silhouette.likeness(bytes(4), bytes([1, 0, 0, 0])), 0)

    def test_a_comparison_colors_what_only_one_shows(self):
        data = silhouette.comparison(2, bytes([1, 1, 0, 0]), bytes([1, 0, 1, 0]))
        red = silhouette.Picture(data).channel(0)
        self.assertEqual(list(red), [0xaa, 0xdd, 0x22, 0xff])


class Suite(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name) / "suite"
        self.program = Path(folder.name) / "program"
        self.output = Path(folder.name) / "out put"
        self.program.write_text(PROGRAM.format(python=sys.executable))
        self.program.chmod(self.program.stat().st_mode | stat.S_IXUSR)

    def add(self, name, text, blessed=None, rendered=None):
        folder = self.root / name
        (folder / "Blessed" / "png").mkdir(parents=True)
        (folder / (name + ".dae")).write_text(text + " <instance_camera")
        if blessed:
            (folder / "Blessed" / "png" / "a.png").write_bytes(blessed)
        if rendered:
            (folder / "ours.png").write_bytes(rendered)

    def run_suite(self, *options):
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            code = conformance.main([str(self.program), str(self.root), "--output", str(self.output),
                                     "--jobs", "2", *options])
        table = self.output / "table.csv"
        rows = {}
        if table.exists():
            with open(table, newline="") as file:
                rows = {Path(row["file"]).stem: row for row in csv.DictReader(file)}
        return code, out.getvalue(), rows

    def test_each_outcome_is_told_from_the_others(self):
        self.add("same", "show ours.png", square(6), square(6, channels=3))
        self.add("nearly", "show ours.png", square(20, 64), square(19, 64, 3))  # 361 of 400 pixels
        self.add("smaller", "show ours.png", square(6), square(5, channels=3))
        self.add("empty", "show ours.png", square(6), square(0, channels=3))
        self.add("both_empty", "show ours.png", square(0), square(0, channels=3))
        self.add("unknown", "show ours.png", None, square(6, channels=3))
        self.add("wrong", "error <p> is empty", square(6))
        code, out, rows = self.run_suite()
        self.assertEqual(code, 0)
        self.assertEqual({name: row["outcome"] for name, row in rows.items()}, {
            "same": "agrees", "nearly": "agrees", "smaller": "differs", "empty": "shows nothing",
            "both_empty": "agrees", "unknown": "no picture", "wrong": "refused"})
        self.assertEqual(rows["smaller"]["iou"], "0.694")
        self.assertEqual(rows["wrong"]["reason"], "3:4: <p> is empty")
        self.assertEqual(rows["wrong"]["warnings"], "1")
        self.assertIn("7 files: agrees 3, differs 1, no picture 1, shows nothing 1, refused 1. "
                      "Of 5 compared silhouettes 3 agree.", out)
        page = (self.output / "table.html").read_text()
        self.assertIn("smaller.dae", page)
        for picture in self.output.glob("*.png"):
            self.assertIn(picture.name, page)
        self.assertEqual(len(list(self.output.glob("*.png"))), 2)

    def test_a_crash_and_a_hang_are_named_and_end_with_1(self):
        self.add("crash", "crash", square(6))
        code, _, rows = self.run_suite()
        self.assertEqual(code, 1)
        self.assertEqual((rows["crash"]["outcome"], rows["crash"]["reason"]), ("crashed", "SIGABRT"))
        self.add("hang", "hang", square(6))
        code, _, rows = self.run_suite("--only", "hang", "--seconds", "1")
        self.assertEqual(code, 1)
        self.assertEqual((rows["hang"]["outcome"], rows["hang"]["reason"]),
                         ("hung", "not done after 1 seconds"))

    def test_only_some_files_are_taken(self):
        self.add("same", "show ours.png", square(6), square(6, channels=3))
        self.add("crash", "crash", square(6))
        self.assertEqual(set(self.run_suite("--only", "same")[2]), {"same"})
        code, out, _ = self.run_suite("--only", "other")
        self.assertEqual(code, 2)
        self.assertIn("no .dae or .zae file", out)

    def test_a_folder_that_is_none_is_a_wrong_command_line(self):
        with self.assertRaises(SystemExit) as end, contextlib.redirect_stderr(io.StringIO()) as errors:
            conformance.arguments([str(self.program), str(self.root / "no")])
        self.assertEqual(end.exception.code, 2)
        self.assertIn("no folder", errors.getvalue())

    def test_frames_of_an_animation_and_files_that_others_refer_to_have_no_picture(self):
        self.add("case", "show", square(6))
        (self.root / "case" / "library.dae").write_text("show <instance_camera")
        self.add("moves", "show")
        frames = self.root / "moves" / "Blessed" / "animations"
        frames.mkdir()
        for name in ("0.png", "1.png"):
            (frames / name).write_bytes(square(6))
        listed = self.root / "moves" / "Blessed" / "default.txt"
        listed.write_text("animations\\0.png\r\nanimations\\1.png\r\n")
        (self.root / "moves" / "Blessed" / "result.dae").write_text("show")
        cases = {case.file.name: case for case in suite.cases(self.root)}
        self.assertEqual(set(cases), {"case.dae", "library.dae", "moves.dae"})
        self.assertEqual(cases["case.dae"].picture, Path("case/Blessed/png/a.png"))
        self.assertIsNone(cases["library.dae"].picture)
        self.assertIsNone(cases["moves.dae"].picture)
        self.assertIn("animation", cases["moves.dae"].without)

    def test_the_camera_of_the_suite_is_asked_for_where_a_file_has_it(self):
        self.add("case", 'camera ours.png name="testCamera"', square(6), square(6, channels=3))
        self.assertEqual(self.run_suite()[2]["case"]["outcome"], "agrees")

    def test_surfaces_with_holes_are_met_by_some_of_many_samples(self):
        for name, text, samples in (("a.dae", "<transparent opaque='A_ONE'>", 16), ("b.dae", "<diffuse>", 1),
                                    ("c.zae", "PK", 16)):
            path = self.program.with_name(name)
            path.write_text(text)
            self.assertEqual(conformance.samples_of(path), samples)

    def test_without_a_camera_a_file_has_no_picture(self):
        self.add("case", "show", square(6))
        (self.root / "case" / "case.dae").write_text("show")
        case, = suite.cases(self.root)
        self.assertIsNone(case.picture)
        self.assertIn("no camera", case.without)

    def test_notes_belong_to_parts_of_a_path(self):
        path = Path(self.root.parent) / "notes.txt"
        path.write_text("# a comment: no note\na/b.dae: the suite's picture shows c: wrongly\n\n")
        self.assertEqual(conformance.read_notes(path), [("a/b.dae", "the suite's picture shows c: wrongly")])


if __name__ == "__main__":
    unittest.main()
