#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How bench/peers calls pbrt-v4, which here is twinray under its name: pbrt_test.py PROGRAM"""
import contextlib
import io
import os
import subprocess
import sys
import unittest
from unittest import mock

from scene_folder import ROOT, Folder
import exr
import pbrt_render
import peers
import renderers
import task

PROGRAM = sys.argv.pop(1)
BOX = ROOT / "scenes" / "box.dae"
STAND_IN = f"""#!/bin/sh
test $# = 5 && test "$1 $2 $3" = "--nthreads 1 --outfile" || exit 3
echo "pbrt version 4 (built today)"
exec {PROGRAM} render "$5" -q -t 1 -o "$4"
"""


class Calls(Folder):
    def setUp(self):
        super().setUp()
        self.box = self.folder / "box.pbrt"
        subprocess.run([PROGRAM, "convert", "-q", BOX, "-r", "40", "30", self.box], check=True)

    def stand_in(self, text=STAND_IN):
        """A folder of peers that holds nothing but a program of pbrt's name."""
        program = self.folder / "bin" / "pbrt"
        program.parent.mkdir()
        program.write_text(text)
        program.chmod(0o755)
        return program

    def script(self, program, *words):
        command = [sys.executable, str(ROOT / "bench" / "peers" / "pbrt_render.py"), str(self.box),
                   str(self.folder / "a.exr"), "--program", str(program), *words]
        return subprocess.run(command, text=True, capture_output=True, check=False)

    def test_what_is_asked_for_takes_the_place_of_the_files_own(self):
        text = self.box.read_text()
        for size, width, height in (([], 40, 30), (["--size", "16", "12"], 16, 12)):
            words = ["a", "b", "--samples", "8", "--depth", "3", "--seed", "5", *size]
            made = pbrt_render.pbrt_scene(text, task.parser().parse_args(words))
            options, world = made.split("\nWorldBegin")
            self.assertEqual(world, text.split("\nWorldBegin")[1])
            for statement in ("Film", "PixelFilter", "Sampler", "Integrator", "Camera"):
                self.assertEqual(options.count(f"\n{statement} "), 1, statement)
            self.assertIn(f"\"integer xresolution\" {width} \"integer yresolution\" {height} ", options)
            self.assertIn("Sampler \"zsobol\" \"integer pixelsamples\" 8 \"integer seed\" 5\n", options)
            self.assertIn("Integrator \"path\" \"integer maxdepth\" 3", options)

    def test_the_film_of_a_lens_keeps_its_size(self):
        text = self.box.read_text().replace('Film "rgb" ', 'Film "rgb" "float diagonal" [ 21.5 ] ')
        made = pbrt_render.pbrt_scene(text, task.parser().parse_args(["a", "b"]))
        film = next(line for line in made.split("\n") if line.startswith("Film "))
        self.assertIn('"float diagonal" [ 21.5 ]', film)

    def test_its_picture_has_the_size_and_its_version_is_said(self):
        done = self.script(self.stand_in(), "--samples", "2", "--size", "16", "12")
        self.assertEqual((done.returncode, done.stdout), (0, "pbrt version 4\n"), done.stderr)
        self.assertEqual(exr.size(self.folder / "a.exr"), (16, 12))

    def test_what_it_says_when_it_fails_is_the_reason(self):
        done = self.script(self.stand_in("#!/bin/sh\necho 'Error: no such lamp' >&2\nexit 1\n"))
        self.assertEqual((done.returncode, done.stderr), (1, "Error: no such lamp\n"))

    def test_it_is_found_in_the_folder_of_peers_and_agrees(self):
        self.stand_in()
        said = io.StringIO()
        with mock.patch.dict(os.environ, {"PATH": "/usr/bin:/bin"}), contextlib.redirect_stderr(said):
            names = [one.name for one in renderers.installed(PROGRAM, str(self.folder))]
            code = peers.main([PROGRAM, str(BOX), "--peers", str(self.folder), "--only", "pbrt",
                               "-r", "40", "30", "--samples", "256", "--seconds", "0.1", "--rounds", "1",
                               "-o", str(self.folder / "out")])
        self.assertIn("pbrt-v4", names)
        table = (self.folder / "out" / "table.md").read_text()
        self.assertEqual(table.count("| pbrt-v4 |"), 3, said.getvalue())
        mean = float(table.split("| pbrt-v4 |")[-1].split("|")[0])
        self.assertAlmostEqual(mean, 1, delta=0.01)
        self.assertEqual(code, 1 if "DIFFERS" in table else 0)


if __name__ == "__main__":
    unittest.main()
