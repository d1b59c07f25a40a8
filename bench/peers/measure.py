# SPDX-License-Identifier: Apache-2.0
"""Runs a renderer as a process, pinned to its processors, and says what it took."""
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

STARTED = Path(__file__).resolve().with_name("started.py")


class Failed(Exception):
    """A process that ended with an error; the last lines of what it said."""


@dataclass(frozen=True)
class Cost:
    cpu_seconds: float  # of the process and its children, in user and system mode
    megabytes: float    # the largest resident size
    said: str


def reason(text):
    """The line that says what was wrong: the first that speaks of an error or is twinray's, else the last."""
    lines = text.splitlines()
    return next((line for line in lines if re.match("twinray:|.*error", line, re.IGNORECASE)),
                lines[-1] if lines else "")[:500]


def pinned(processors):
    return lambda: os.sched_setaffinity(0, processors)


def run(command, processors):
    with tempfile.NamedTemporaryFile("r", encoding="utf-8") as report:
        done = subprocess.run([sys.executable, "-IS", str(STARTED), report.name, *command],
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              preexec_fn=pinned(processors), check=False)
        text = done.stdout.decode(errors="replace").strip()
        if done.returncode != 0:
            raise Failed(reason(text))
        code, cpu_seconds, kilobytes = json.load(report)
    if code != 0:
        raise Failed(reason(text) or f"it ended with {code}")
    return Cost(cpu_seconds, kilobytes / 1024, text)


def processors(threads):
    """The last of those that this process may use: the first ones have most of a machine's other work."""
    usable = sorted(os.sched_getaffinity(0))
    if threads > len(usable):
        raise Failed(f"--threads: {threads} threads, but there are only {len(usable)} processors")
    return set(usable[-threads:])


def quartiles(values):
    """(lower quartile, median, upper quartile)."""
    if len(values) < 2:
        return (values[0],) * 3
    return tuple(statistics.quantiles(values, n=4, method="inclusive"))
