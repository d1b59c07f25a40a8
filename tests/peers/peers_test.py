#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What bench/peers does without a peer: peers_test.py PROGRAM"""
import contextlib
import io
import json
import struct
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

from scene_folder import ROOT, Folder
import peers
import renderers
import task

PROGRAM = sys.argv.pop(1)


class Scripts(Folder):
    def test_the_scripts_of_the_peers_understand_what_they_are_told(self):
        self.scene()
        picture = renderers.Picture("a.dae", str(self.folder / "scene.json"), "whole", 40, 20, 7, 3)
        for request in (renderers.Request("a.exr", 16, 9, True),
                        renderers.Request("a.exr", 1, 2, False, (16, 12))):
            told = task.parser().parse_args(renderers.common_words(picture, request))
            self.assertEqual((told.scene, told.output), (picture.exchange, "a.exr"))
            self.assertEqual((told.samples, told.seed, told.roulette),
                             (request.samples, request.seed, request.roulette))
            self.assertEqual((told.depth, told.threads), (7, 3))
            self.assertEqual(task.scene_of(told)["resolution"], list(request.size or (40, 20)))

    def test_the_picture_of_a_start_is_small_and_of_the_same_shape(self):
        for whole, small in (((480, 360), (16, 12)), ((200, 250), (16, 20)), ((7, 3), (7, 3))):
            self.assertEqual(peers.start_size(*whole), small)

    def test_our_own_words_name_the_view(self):
        picture = renderers.Picture("a.dae", "scene.json", "file", 40, 20, 7, 3)
        request = renderers.Request("a.exr", 1, 1, True)
        self.assertIn("--view=file", renderers.twinray("twinray")(picture, request))


class Runs(Folder):
    """All of a run, the peer being twinray by another sampler."""

    def run_peers(self, *options, peer=("--sampler=independent",)):
        found = [renderers.Renderer("twinray", "twinray", renderers.twinray(PROGRAM)),
                 renderers.Renderer("other <1>", "other", renderers.twinray(PROGRAM, peer))]
        said = io.StringIO()
        with mock.patch("renderers.installed", return_value=found), contextlib.redirect_stderr(said):
            code = peers.main([PROGRAM, str(ROOT / "scenes" / "box.dae"), "-r", "64", "48", "--samples", "64",
                               "--seconds", "0.2", "--rounds", "1", "-o", str(self.folder / "out"), *options])
        return code, said.getvalue()

    def test_a_run_writes_its_page_and_its_table(self):
        code, said = self.run_peers("--rounds", "2")
        table = (self.folder / "out" / "table.md").read_text()
        self.assertEqual(table.count("| other <1> |"), 3)
        self.assertEqual(table.count("| agrees |") + table.count("| DIFFERS |"), 2)
        self.assertEqual(code, 1 if "DIFFERS" in table else 0)
        page = (self.folder / "out" / "index.html").read_text()
        self.assertEqual(page.count("<table>"), 3)
        self.assertEqual(page.count("<img "), 2)
        self.assertIn("other &lt;1&gt;", page)
        self.assertIn("box: round 2 of 2", said)
        picture = (self.folder / "out" / "box.png").read_bytes()
        self.assertEqual(struct.unpack(">2I", picture[16:24]), (64, 24))

    def test_peers_get_a_scene_whose_skies_they_have(self):
        told = []

        def note(path):
            told.append(json.loads(Path(path).read_text(encoding="utf-8"))["format"])

        with mock.patch("panorama.draw_squares_anew", side_effect=note):
            self.run_peers("--samples", "4")
        self.assertEqual(told, ["twinray scene"])

    def test_a_picture_that_differs_ends_with_1(self):
        code, _ = self.run_peers("--only", "other", peer=("-m", "2"))
        self.assertEqual(code, 1)
        self.assertIn("| DIFFERS |", (self.folder / "out" / "table.md").read_text())

    def test_a_peer_that_fails_is_left_out_and_named(self):
        code, said = self.run_peers(peer=("--no-such-option",))
        self.assertEqual(code, 1)
        self.assertIn("other <1>: left out: twinray: there is no option --no-such-option", said)
        table = (self.folder / "out" / "table.md").read_text()
        self.assertIn("other <1> was left out: twinray: there is no option", table)

    def script(self, *words, **options):
        command = [sys.executable, str(ROOT / "bench" / "peers" / "peers.py"), PROGRAM, *words]
        return subprocess.run(command, text=True, capture_output=True, check=False, **options)

    def test_without_peers_a_message_says_how_to_have_them(self):
        done = self.script("--peers", str(self.folder), env={"PATH": ""})
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"No peer was found in {self.folder}.", done.stderr)
        self.assertIn("python3 -m venv DIR && DIR/bin/pip install mitsuba bpy", done.stderr)

    def test_a_folder_that_cannot_be_made_ends_before_the_work(self):
        code, said = self.run_peers("-o", str(self.folder / "none" / "out"))
        self.assertEqual(code, 1)
        self.assertEqual(said, f"--output: {self.folder}/none/out: this folder cannot be made: "
                               "No such file or directory\n")

    def test_scenes_stand_anywhere_on_the_command_line(self):
        found = peers.read_arguments(["program", "-m", "3", "a.dae", "-r", "4", "3", "b.dae"])
        self.assertEqual((found.scenes, found.depth, found.resolution), (["a.dae", "b.dae"], 3, [4, 3]))

    def test_wrong_options_end_with_2(self):
        for words, text in ((["--seconds", "0"], "--seconds: 0.0 is not above 0"), (["--none"], "--none")):
            done = self.script(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(text, done.stderr)


if __name__ == "__main__":
    unittest.main()
