#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What bench/peers says that a process took."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench" / "peers"))
import measure  # noqa: E402


class Measuring(unittest.TestCase):
    def test_a_process_is_pinned_and_its_seconds_are_counted(self):
        code = "import os, time\nwhile time.process_time() < 0.3: pass\nprint(len(os.sched_getaffinity(0)))"
        cost = measure.run([sys.executable, "-c", code], measure.processors(1))
        self.assertEqual(cost.said, "1")
        self.assertGreaterEqual(cost.cpu_seconds, 0.3)
        self.assertGreater(cost.megabytes, 1)

    def test_a_failure_says_why(self):
        with self.assertRaisesRegex(measure.Failed, "an Error of mine"):
            code = "print('first'); import sys; print('an Error of mine'); sys.exit('x')"
            measure.run([sys.executable, "-c", code], measure.processors(1))

    def test_memory_is_that_of_the_process_alone(self):
        held = bytearray(b"x") * 300_000_000  # by the program that measures
        code = "held = bytearray(b'x') * 80_000_000"
        own, most_beside = 80e6 / 2 ** 20, 40
        found = measure.run([sys.executable, "-c", code], measure.processors(1)).megabytes
        self.assertGreater(found, own)
        self.assertLess(found, own + most_beside)
        self.assertEqual(len(held), 300_000_000)

    def test_a_program_that_is_not_there_is_a_failure(self):
        said = "^/none: it cannot be started: No such file or directory$"
        with self.assertRaisesRegex(measure.Failed, said):
            measure.run(["/none"], measure.processors(1))

    def test_a_process_that_is_killed_is_a_failure(self):
        with self.assertRaisesRegex(measure.Failed, "it ended with -9"):
            measure.run(["sh", "-c", "kill -9 $$"], measure.processors(1))

    def test_more_threads_than_processors_are_refused(self):
        with self.assertRaisesRegex(measure.Failed, "--threads: 100000 threads"):
            measure.processors(100000)


if __name__ == "__main__":
    unittest.main()
