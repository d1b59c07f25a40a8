#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmark program for an instant and reads its reports: bench_test.py PROGRAM"""
import csv
import json
import math
import re
import statistics
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

PROGRAM = sys.argv.pop(1)
SETS = ("camera", "shadow-1", "bounce-1", "shadow-2", "bounce-2")
ALWAYS = {"bvh", "bvh-batch", "bvh-compact", "bvh-compact-batch", "bvh-fast", "bvh-high", "bvh-2",
          "brute-force"}
WITH_EMBREE = {"embree-direct", "embree-native-default", "embree-native", "embree-native-fast",
               "embree-native-fast-high", "embree"}
ROUNDS = 3
BOX = Path(__file__).resolve().parents[2] / "scenes" / "cornell-bunny.dae"
VOID = {"meta", "br", "line", "circle", "rect", "polyline"}


def bench(*arguments):
    return subprocess.run([PROGRAM, *arguments], text=True, capture_output=True, check=False)


class Balance(HTMLParser):
    """Sees whether every element is closed, and notes attributes that would load something."""

    def __init__(self):
        super().__init__()
        self.open, self.wrong, self.loads = [], [], []

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)
        self.loads += [f"{tag} {name}" for name, _ in attributes if name in ("src", "href", "xlink:href")]
        if tag in ("script", "link", "img", "iframe"):
            self.loads.append(tag)

    def handle_endtag(self, tag):
        if tag not in VOID and (not self.open or self.open.pop() != tag):
            self.wrong.append(tag)


def spreads(json_value):
    """Every set of rounds in a report."""
    if isinstance(json_value, dict):
        if "rounds" in json_value:
            yield json_value
            return
        json_value = list(json_value.values())
    for value in json_value if isinstance(json_value, list) else []:
        yield from spreads(value)


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        names = {kind: str(Path(cls.folder.name, "statistics." + kind)) for kind in ("json", "csv", "html")}
        cls.done = bench("--quick", "--scenes=", "--only", "^box$", "^room$", "forest-", "--sizes=1e4,12000",
                         f"--repetitions={ROUNDS}", *(f"--{kind}={name}" for kind, name in names.items()))
        cls.text = {kind: Path(name).read_text(encoding="utf-8") for kind, name in names.items()}
        cls.json = json.loads(cls.text["json"])

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_answer_is_right(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_reading_is_timed_for_scenes_that_have_a_file(self):
        box, = self.json["reading"]
        self.assertEqual(box["scene"], "box")
        self.assertAlmostEqual(box["megabytes"], BOX.stat().st_size / 1e6)
        self.assertEqual(len(box["seconds"]["rounds"]), ROUNDS)
        self.assertGreater(box["seconds"]["median"], 0)
        self.assertIn("box: a file of ", self.done.stdout)
        self.assertIn("Reading scene files", self.text["html"])

    def test_every_engine_is_timed_on_every_scene_and_ray_set(self):
        self.assertEqual([scene["name"] for scene in self.json["scenes"]],
                         ["box", "room", "forest-10000", "forest-12000"])
        wanted = ALWAYS | (WITH_EMBREE if "Embree" in self.json["machine"]["libraries"] else set())
        for scene in self.json["scenes"]:
            self.assertEqual({engine["name"] for engine in scene["engines"]}, wanted)
            for engine in scene["engines"]:
                self.assertEqual(tuple(engine["rays"]), SETS)
                for statistics in engine["rays"].values():
                    self.assertEqual(len(statistics["nanoseconds"]["rounds"]), ROUNDS)
                    self.assertGreater(statistics["nanoseconds"]["q1"], 0)
                    self.assertGreater(statistics["speed"]["q1"], 0)

    def test_embrees_packets_and_streams_are_timed_where_they_are_asked_for(self):
        if "Embree" not in self.json["machine"]["libraries"]:
            return
        version = int(re.search(r"Embree (\d+)", self.json["machine"]["libraries"])[1])
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "packets.json")
            spheres = BOX.with_name("spheres.dae")
            done = bench("--quick", "--scenes=", "--only", "^box$", "spheres", "--engines", "packet|stream",
                         "--repetitions=1", "--no-renders", f"--json={file}", str(spheres))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            scenes = {scene["name"]: scene["engines"] for scene in json.loads(file.read_text())["scenes"]}
        kinds = ["packets"] + (["stream", "packet-stream"] if version < 4 else [])
        names = [f"embree-{kind}{suffix}" for kind in kinds for suffix in ("", "-coherent")]
        self.assertEqual([engine["name"] for engine in scenes["box"]], ["embree-direct", *names])
        self.assertEqual([engine["name"] for engine in scenes["spheres"]], ["embree-direct"])

    def test_what_an_engine_does_not_count_is_absent(self):
        for scene in self.json["scenes"]:
            for engine in scene["engines"]:
                for statistics in engine["rays"].values():
                    counts = "nodes_per_ray", "primitives_per_ray"
                    known = tuple(statistics[name] is not None for name in counts)
                    self.assertTrue(all(statistics[name] is None or statistics[name] > 0 for name in counts))
                    if engine["name"].startswith("bvh"):
                        self.assertEqual(known, (True, True))
                    if re.match("embree-(direct|native|fast)", engine["name"]):
                        self.assertEqual(known, (False, False))
        rows = list(csv.DictReader(self.text["csv"].splitlines()))
        self.assertNotIn("0", {row[name] for row in rows for name in ("nodes_per_ray", "primitives_per_ray")})

    def assert_all_close(self, found, expected):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertTrue(math.isclose(a, b, rel_tol=1e-9), (found, expected))

    def test_quartiles_are_those_of_the_rounds(self):
        counted = 0
        for spread in spreads({name: value for name, value in self.json.items() if name != "rounds"}):
            rounds = spread["rounds"] if len(spread["rounds"]) > 1 else 2 * spread["rounds"]
            self.assert_all_close([spread["q1"], spread["median"], spread["q3"]],
                                  statistics.quantiles(rounds, n=4, method="inclusive"))
            counted += 1
        self.assertGreater(counted, 100)

    def test_speed_is_the_baselines_time_over_an_engines_round_by_round(self):
        for scene in self.json["scenes"]:
            baseline = scene["engines"][0]["rays"]
            for engine in scene["engines"]:
                for name, figures in engine["rays"].items():
                    times = figures["nanoseconds"]["rounds"]
                    self.assert_all_close(figures["speed"]["rounds"],
                                          [base / time for base, time
                                           in zip(baseline[name]["nanoseconds"]["rounds"], times)])
        for picture in self.json["pictures"]:
            baseline = picture["engines"][0]["seconds"]["rounds"]
            for engine in picture["engines"]:
                times = engine["seconds"]["rounds"]
                self.assert_all_close(engine["speed"]["rounds"],
                                      [base / time for base, time in zip(baseline, times)])

    def test_an_engines_speed_is_the_geometric_mean_of_its_ray_sets(self):
        for scene in self.json["scenes"]:
            for engine in scene["engines"]:
                for kind in ("speed", "nanoseconds"):
                    rounds = zip(*(figures[kind]["rounds"] for figures in engine["rays"].values()))
                    self.assert_all_close(engine[kind]["rounds"],
                                          [statistics.geometric_mean(values) for values in rounds])

    def test_brute_force_tests_every_primitive_for_a_closest_hit_and_a_tree_fewer(self):
        for scene in self.json["scenes"]:
            engines = {engine["name"]: engine["rays"] for engine in scene["engines"]}
            if "brute-force" not in engines:
                continue
            for name in ("camera", "bounce-1", "bounce-2"):
                everything = engines["brute-force"][name]["primitives_per_ray"]
                self.assertEqual(everything, scene["primitives"])
                self.assertLess(engines["bvh"][name]["primitives_per_ray"], everything)
                self.assertGreater(engines["bvh"][name]["nodes_per_ray"], 0)

    def test_the_baseline_has_the_speed_one(self):
        for scene in self.json["scenes"]:
            self.assertEqual(scene["engines"][0]["speed"]["rounds"], [1] * ROUNDS)

    def test_the_machine_is_recorded(self):
        for name in ("processor", "threads", "governor", "load", "compiler", "flags", "libraries"):
            self.assertTrue(self.json["machine"][name], name)

    def test_pictures_are_rendered_and_their_error_falls(self):
        self.assertEqual([picture["scene"] for picture in self.json["pictures"]], ["box", "room"])
        for picture in self.json["pictures"]:
            for engine in picture["engines"]:
                self.assertGreater(min(engine["seconds"]["q1"], engine["replay_seconds"]["q1"]), 0)
        for error in self.json["errors"]:
            self.assertEqual([point["samples"] for point in error["points"]], [1, 2, 4, 8, 16])
            first, last = error["points"][0], error["points"][-1]
            self.assertGreater(first["relative_error"], 2 * last["relative_error"])

    def test_threads_are_compared_with_processes(self):
        self.assertEqual({scaling["scene"] for scaling in self.json["scaling"]}, {"box", "room"})
        for scaling in self.json["scaling"]:
            self.assertEqual(scaling["points"][0]["threads"], 1)
            self.assertEqual(str(scaling["points"][-1]["threads"]), self.json["machine"]["threads"])
            for point in scaling["points"]:
                self.assertGreater(point["processes_samples_per_second"]["q1"], 0)

    def test_the_table_has_a_line_for_each_scene_engine_and_ray_set(self):
        rows = list(csv.DictReader(self.text["csv"].splitlines()))
        engines = sum(len(scene["engines"]) for scene in self.json["scenes"])
        self.assertEqual(len(rows), engines * (len(SETS) + 1))
        engines = {(scene["name"], engine["name"]): engine
                   for scene in self.json["scenes"] for engine in scene["engines"]}
        for row in rows:
            engine = engines[row["scene"], row["engine"]]
            figures = engine if row["ray_set"] == "all" else engine["rays"][row["ray_set"]]
            for column, part in (("median", "median"), ("q1", "q1"), ("q3", "q3")):
                for kind in ("nanoseconds", "speed"):
                    self.assertTrue(math.isclose(float(row[f"{kind}_{column}"]), figures[kind][part],
                                                 rel_tol=1e-5), row)
            self.assertEqual(int(row["bytes"]), engine["build"]["bytes"])

    def test_the_page_needs_nothing_but_itself(self):
        page = self.text["html"]
        balance = Balance()
        balance.feed(page)
        self.assertEqual((balance.open, balance.wrong, balance.loads), ([], [], []))
        self.assertNotRegex(page, r"https?:|//\w|url\(|@import")
        self.assertNotRegex(page, r"\b(?:nan|inf)\b")

    def test_the_page_shows_every_scene_and_engine(self):
        for scene in self.json["scenes"]:
            self.assertIn(scene["name"], self.text["html"])
            for engine in scene["engines"]:
                self.assertIn(engine["name"], self.text["html"])
        self.assertGreaterEqual(self.text["html"].count("<svg"), 8)
        self.assertIsNone(re.search(r"\{\}|\{:", self.text["html"].split("</style>")[1]))


class CommandLine(unittest.TestCase):
    def expect(self, arguments, message, code=2):
        done = bench(*arguments)
        self.assertEqual(done.returncode, code)
        self.assertIn(message, done.stderr)

    def test_what_cannot_be_understood_is_said(self):
        self.expect(["--only", "nosuchscene"], "no scene has such a name")
        self.expect(["--quick", "nosuchfile.dae"], "nosuchfile.dae: there is no such file", code=1)
        self.expect(["--only", "("], "is not a regular expression")
        self.expect(["--sizes=1e4;5"], "numbers of triangles such as 1e4,1e5,1000000 are wanted")
        self.expect(["--sizes=1e4,1.5"], "numbers of triangles such as 1e4,1e5,1000000 are wanted")
        self.expect(["--sizes=1e9"], "1e4,1e5,1000000 are wanted, up to 268435456")
        self.expect(["--sizes=20000,9999"], "forest can have 10000 triangles and more, but not 9999")
        self.expect(["--sizes=9999", "--only=^forest-9999$"], "no scene has such a name")
        self.expect(["--quick", "--full"], "exclude each other")
        self.expect(["--engines=typo"], "--engines=typo: no engine has such a name; there are ")
        self.expect(["--samples=4"], "--samples goes with --picture")
        self.expect(["--write-ups", "--csv=a.csv"], "--csv does not go with --write-ups")
        self.expect(["--scenes=/nowhere"], "/nowhere is not a folder of scenes", code=1)

    def test_a_picture_of_a_scene_is_rendered(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "ball.png")
            done = bench("--only", "^ball-1000$", "--sizes=1000", "--samples=1", f"--picture={file}")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(file.read_bytes()[:4], b"\x89PNG")

    def test_command_lines_of_write_ups_are_run_and_scenes_that_are_missing_are_named(self):
        own = Path(__file__).resolve().parents[2] / "scenes" / "furnace.dae"
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "cow.dae").write_bytes(own.read_bytes())
            done = bench("--write-ups", "--scenes", folder, "--repetitions=1", "--only", "normals cow$",
                         "normals bunny$")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in done.stdout.splitlines()[2:]]
        self.assertEqual(rows[0][:2], ["`-r 480 360 --integrator=normals`", "cow"])
        self.assertEqual(int(rows[0][5]), 480 * 360)
        self.assertGreater(float(rows[0][4]), 0)
        self.assertEqual(rows[0][8], "0.22 s (1), 0.63 s (2), 0.14 s (3), 0.34 s (5)")
        self.assertEqual(rows[1][1:], ["bunny", "the folder has no such scene"])


if __name__ == "__main__":
    unittest.main()
