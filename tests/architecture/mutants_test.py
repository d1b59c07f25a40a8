#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""mutants.py notices a mutant that no longer fits, and tells a killed one from a survivor."""
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

import mutants
from mutant import Mutant, stale

SOURCE = "int sum(int a, int b) { return a + b; }\nint twice(int a) { return a + a; }\n"
TEST = 'TEST_CASE("one and one "\n    "are two") {}\n'
MUTANT = Mutant("a sum is a difference", "core/sum.cpp", "a + b", "a - b", "test_core", "one and one are two")


class Mutants(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name, text in {"core/sum.cpp": SOURCE, "tests/core/sum_test.cpp": TEST}.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, encoding="utf-8")

    def expect_stale(self, list_, *expected):
        found = list(stale(self.root, list_))
        self.assertEqual(len(found), len(expected), found)
        for line, part in zip(found, expected):
            self.assertIn(part, line)

    def test_a_mutant_that_fits_is_not_stale(self):
        self.expect_stale([MUTANT])
        self.expect_stale([replace(MUTANT, test="one and*")])

    def test_what_no_longer_fits_is_stale(self):
        self.expect_stale([replace(MUTANT, old="a * b")], "holds its old text 0 times")
        self.expect_stale([replace(MUTANT, old="return a")], "holds its old text 2 times")
        self.expect_stale([replace(MUTANT, file="core/gone.cpp")], "core/gone.cpp")
        self.expect_stale([replace(MUTANT, test="one and one")], 'there is no test "one and one"')
        self.expect_stale([replace(MUTANT, new="a + b")], "changes nothing")
        self.expect_stale([MUTANT, MUTANT], "two mutants have this name")

    def verdict(self, builds, passes):
        """Of a build and a test that succeed or not; the test sees the planted text."""
        def run(command, _seconds=None):
            planted = (self.root / MUTANT.file).read_text(encoding="utf-8")
            self.assertEqual(planted, SOURCE.replace("a + b", "a - b"))
            return (builds if command[0] == "cmake" else passes), ""
        with mock.patch.object(mutants, "COPY", self.root), mock.patch.object(mutants, "run", run):
            result, _ = mutants.verdict(MUTANT, 0)
        self.assertEqual((self.root / MUTANT.file).read_text(encoding="utf-8"), SOURCE)
        return result

    def test_a_failing_test_kills_and_the_text_is_restored(self):
        self.assertEqual(self.verdict(True, False), "killed")
        self.assertEqual(self.verdict(True, True), "SURVIVED")
        self.assertEqual(self.verdict(False, True), "did not build")

    def test_a_name_is_one_test_for_catch_and_for_ctest(self):
        self.assertEqual(mutants.test_command(replace(MUTANT, test="a, [b]"))[1], r"a\, \[b\]")
        self.assertEqual(mutants.test_command(replace(MUTANT, target="twinray_bench"))[-1],
                         r"^one\ and\ one\ are\ two$")


if __name__ == "__main__":
    unittest.main()
