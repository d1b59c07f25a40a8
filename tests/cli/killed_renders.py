#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kills renders, lets them go on, and compares the films with that of an undisturbed one.

killed_renders.py PROGRAM SCENE FAILING_DISK [KILLS [SECONDS]]

KILLS (200): that many processes get SIGKILL at seeded instants of their first SECONDS (0.06); each is
resumed, by another number of threads or another engine, and perhaps killed again, until it is done. Then the
disk fails, or tears what is written, at each of the first events of a checkpoint
(tests/support/failing_disk.cpp). Every film must have the sums of the undisturbed one, and no checkpoint may
have fewer samples than the one before. "none" for FAILING_DISK leaves that part out. A build with sanitizers
is slower: it needs more SECONDS.
"""
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

ENGINES = ("bvh", "brute-force")
EVENTS = 14


def header(film):
    """What a film file says of itself."""
    data = film.read_bytes()
    begin = data.index(b"\n") + 1
    length = int.from_bytes(data[begin:begin + 8], "little")
    return json.loads(data[begin + 16:begin + 16 + length])


class Renders:
    """One render after the other in a folder of their own."""

    def __init__(self, program, scene, folder):
        self.program, self.folder = program, Path(folder)
        self.options = [scene, "-r", "64", "48", "-s", "48", "-q", "--layers=ids,normal", "-o", "a.film"]
        self.checkpoint = self.folder / "a.ck"
        self.expected = self.undisturbed()

    def start(self, words, environment=None):
        variables = {**os.environ, **(environment or {})}
        return subprocess.Popen([self.program, *words], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, env=variables)

    def begin(self, environment=None):
        return self.start([*self.options, "--checkpoint=a.ck", "--checkpoint-seconds=0.01"], environment)

    def go_on(self, number):
        if not self.checkpoint.exists():
            return self.begin()
        return self.start(["resume", "a.ck", "-q", "-t", str(1 + number % 3),
                           f"--accel={ENGINES[number // 3 % 2]}"])

    def sums(self):
        """The hash of all sums, with which a film file ends."""
        return (self.folder / "a.film").read_bytes()[-8:]

    def undisturbed(self):
        process = self.start(self.options)
        text, _ = process.communicate()
        if process.returncode != 0:
            sys.exit(f"the undisturbed render failed: {text}")
        return self.sums()

    def clear(self):
        for file in self.folder.glob("*a.*"):
            file.unlink()

    def samples(self):
        """Of the checkpoint; 0 where there is none yet."""
        if not self.checkpoint.exists():
            return 0
        return header(self.checkpoint)["notes"]["progress"]["samples"]

    def finish(self):
        """Goes on to the end; what is wrong, or nothing."""
        process = self.go_on(0)
        text, _ = process.communicate()
        if process.returncode != 0:
            return f"it ended with {process.returncode}: {text}"
        return "" if self.sums() == self.expected else "the film has other sums"


def kill_at_random(renders, kills, seconds):
    """What went wrong, or nothing."""
    instants = random.Random(16)
    killed = films = 0
    while killed < kills:
        renders.clear()
        samples = 0
        while killed < kills:
            process = renders.go_on(killed)
            try:
                text, _ = process.communicate(timeout=instants.uniform(0, seconds))
                if process.returncode != 0:
                    return f"it ended with {process.returncode}: {text}"
                break
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                killed += 1
            if renders.samples() < samples:
                return f"a checkpoint of {renders.samples()} samples follows one of {samples}"
            samples = renders.samples()
        if fault := renders.finish():
            return f"after {killed} kills: {fault}"
        films += 1
    print(f"{killed} processes were killed, {films} films have the same sums")
    return ""


def fail_at_events(renders, disk):
    """What went wrong, or nothing."""
    happened = 0
    for does in ("fail", "tear", "kill"):
        for event in range(1, EVENTS + 1):
            renders.clear()
            process = renders.begin({"LD_PRELOAD": disk, "DISK_FILE": "a.ck", "DISK_EVENT": str(event),
                                     "DISK_DOES": does})
            text, _ = process.communicate()
            happened += process.returncode == -9 or "no checkpoint" in text
            if does == "fail" and process.returncode != 0:
                return f"event {event}: it ended with {process.returncode}: {text}"
            if fault := renders.finish():
                return f"{does} at event {event}: {fault}"
    print(f"{happened} of {3 * EVENTS} failures of the disk, and the same sums after each")
    return "" if happened > 2 * EVENTS else "too few of the failures happened"


def main(arguments):
    if not 3 <= len(arguments) <= 5:
        print(__doc__, file=sys.stderr)
        return 2
    program, scene, disk = arguments[:3]
    with tempfile.TemporaryDirectory() as folder:
        renders = Renders(program, scene, folder)
        kills, seconds = (*arguments[3:], *("200", "0.06")[len(arguments) - 3:])
        fault = kill_at_random(renders, int(kills), float(seconds))
        if not fault and disk != "none":
            fault = fail_at_events(renders, disk)
    if fault:
        print(fault)
    return 1 if fault else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
