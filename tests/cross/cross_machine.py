#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs builds for x86-64 and for AArch64 (by QEMU) side by side, and compares their results bit for bit.

cross_machine.py BUILD AARCH64_BUILD SYSROOT SCENES [GROUP]...

Each group is a list of cases; a case is a line, `same` or `DIFFERS`. The exit code is 1 where any differs.
  tables      canonical hits against the table of bits, by four sets of compiler flags
  tests       the test programs of core, accel, integrators and check
  engines     films of each scene by every engine of ours, both path tracers, NEON and scalar kernels
  options     pictures of each scene by adaptive sampling, denoising, layers, lenses, filters, integrators
  files       pictures on surfaces, and light from a picture
  crosscheck  single rays through all engines of ours: equal reports; and Embree's own triangles explained
  parts       films of parts from both merged on each, and checkpoints that go on on the other
  processors  the same film on several models of processors
"""
import sys
import tempfile
import time
from pathlib import Path

from cases import crosscheck, engines, files, options, processors, tables, tests
from machine import Bench, Failed
from parts import parts

GROUPS = {function.__name__: function
          for function in (tables, tests, engines, options, files, crosscheck, parts, processors)}


def cases_of(bench, group):
    """Its cases; where what they need cannot be made, that is the last."""
    try:
        yield from GROUPS[group](bench)
    except Failed as failed:
        yield "what the other cases need", str(failed)


def run_groups(bench, names):
    """Prints each case; how many there were, and how many of them differ."""
    count = wrong = 0
    for name in names:
        for title, difference in cases_of(bench, name):
            count += 1
            wrong += bool(difference)
            verdict = f"DIFFERS {name}: {title}: {difference}" if difference else f"same    {name}: {title}"
            print(verdict, flush=True)
    return count, wrong


def main(arguments):
    names = arguments[4:] or list(GROUPS)
    if len(arguments) < 4 or any(name not in GROUPS for name in names):
        print(__doc__, file=sys.stderr)
        return 2
    build, arm_build, sysroot, scenes = (str(Path(word).resolve()) for word in arguments[:4])
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench((build, arm_build), sysroot, scenes, folder)
        for machine in bench.both():
            print(f"{machine.name}:\n{machine.twinray('--version')}")
        count, wrong = run_groups(bench, names)
    print(f"\n{count} cases, {wrong} with other bits, {(time.monotonic() - start) / 60:.0f} minutes")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
