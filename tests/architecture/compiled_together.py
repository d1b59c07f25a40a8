#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that files are compiled together where cmake/Settings.cmake says so: compiled_together.py ROOT BUILD

Nothing else would show it: files that are compiled one by one make the same program, in twice the time.
"""
import json
import sys
from pathlib import Path

# How many files are compiled at a time, on average and at least: some of them stand alone, most of all where
# what they do is timed.
LIBRARIES = {"accel": 2, "check": 8, "cli": 8, "core": 8, "integrators": 3, "io": 8}


def main(arguments):
    root, build = map(Path, arguments)
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    status = 0
    for library, at_a_time in LIBRARIES.items():
        files = sum(1 for _ in (root / library).rglob("*.cpp"))
        objects = f"/twinray_{library}.dir/"
        compiled = sum(objects in command["command"] for command in commands)
        print(f"{library}: {files} files, compiled in {compiled} parts")
        if not 0 < compiled <= files / at_a_time:
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
