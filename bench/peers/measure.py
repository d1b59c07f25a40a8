# SPDX-License-Identifier: Apache-2.0
"""Runs a renderer as a process, pinned to its processors, and says what it took."""
import os
import re
import statistics
import subprocess
import tempfile
import time
from dataclasses import dataclass


class Failed(Exception):
    """A process that ended with an error; the last lines of what it said."""


@dataclass(frozen=True)
class Cost:
    cpu_seconds: float  # of the process and its children, in user and system mode
    seconds: float      # by the clock on the wall
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
    with tempfile.TemporaryFile() as said:
        start = time.monotonic()
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.STDOUT,
                                   preexec_fn=pinned(processors))
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.monotonic() - start
        said.seek(0)
        text = said.read().decode(errors="replace").strip()
    if process.returncode != 0:
        raise Failed(reason(text) or f"it ended with {process.returncode}")
    return Cost(usage.ru_utime + usage.ru_stime, seconds, usage.ru_maxrss / 1024, text)


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
