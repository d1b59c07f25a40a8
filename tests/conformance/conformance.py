#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders every file of the Khronos conformance suite and compares silhouettes with the suite's pictures.

conformance.py PROGRAM FOLDER [--output DIR] [--only TEXT] [--jobs N] [--seconds N]

PROGRAM is twinray, FOLDER the suite (KhronosGroup/COLLADA-CTS) or a part of it. Each file is rendered by a
process of its own, from the camera that the file gives, at the size of the suite's picture. In DIR (default:
conformance) it leaves table.csv, a line for each file, table.html, which shows the silhouettes that differ,
and the pictures of these. Exit code 1: a file made the program crash or hang.

  agrees         intersection over union of the silhouettes is at least 0.9
  differs        it is less
  no picture     rendered, and the suite has none to compare with, or the frames of an animation
  shows nothing  rendered, without a pixel of a surface, though the suite's picture has some or is missing
  refused        the program ended with an error message
  crashed, hung  it did not end, or not by itself
"""
import argparse
import csv
import functools
import html
import os
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass
from multiprocessing.pool import Pool
from pathlib import Path

import silhouette
import suite

AGREES = 0.9
STATES = ("agrees", "differs", "no picture", "shows nothing", "refused", "crashed", "hung")


@dataclass
class Outcome:
    file: str
    state: str
    iou: float | None = None
    reason: str = ""        # of a refusal, or why nothing was compared
    warnings: int = 0
    note: str = ""          # from notes.txt
    comparison: str = ""    # the picture of both silhouettes


@functools.lru_cache(maxsize=64)
def blessed(path):
    """(width, height, silhouette) of a picture of the suite."""
    picture = silhouette.Picture(Path(path).read_bytes())
    return picture.width, picture.height, silhouette.opaque(picture)


def first_line(text, file):
    """The first line of an error, without the file's name."""
    line = next((line for line in text.splitlines() if line.startswith("twinray:")), text)
    return line.removeprefix("twinray: ").replace(str(file), "").lstrip(":").strip()


def samples_of(file):
    """A sample meets a surface with holes with the probability that it is there: some of many do. Of an
    archive it is not known whether it has some."""
    may_have_holes = Path(file).suffix == ".zae" or b"<transparent" in Path(file).read_bytes()
    return 16 if may_have_holes else 1


def rendered(program, file, size, output, seconds):
    """(exit code or None, standard error) of a render of normals: every surface shows, whatever its light."""
    command = [program, "render", str(file), "-r", str(size[0]), str(size[1]),
               "-s", str(samples_of(file)), "-t", "1", "-q",
               "--integrator=normals", "--clip=file", "-o", output]
    if suite.has_camera(file, suite.CAMERA):
        command.append("--camera-name=" + suite.CAMERA)
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, done.stderr.decode(errors="replace")


def judged(case, root, options):
    """The outcome of one case, and the picture of both silhouettes where they differ."""
    outcome = Outcome(str(case.file), "no picture", reason=case.without)
    size, theirs = (256, 256), None
    if case.picture:
        try:
            width, height, theirs = blessed(root / case.picture)
            size = width, height
        except silhouette.PictureError as error:
            outcome.reason = f"the suite's picture cannot be compared: {error}"
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "normals.png")
        code, errors = rendered(options.program, root / case.file, size, output, options.seconds)
        outcome.warnings = errors.count("warning: ")
        if code is None:
            outcome.state, outcome.reason = "hung", f"not done after {options.seconds} seconds"
        elif code == 1:
            outcome.state, outcome.reason = "refused", first_line(errors, root / case.file)
        elif code != 0:
            name = signal.Signals(-code).name if code < 0 else f"exit code {code}"
            outcome.state, outcome.reason = "crashed", name
        if code != 0:
            return outcome, b""
        ours = silhouette.not_black(silhouette.Picture(Path(output).read_bytes()))
    return compared(outcome, size[0], theirs, ours)


def compared(outcome, width, theirs, ours):
    if theirs is not None:
        outcome.iou = silhouette.likeness(theirs, ours)
        outcome.state = "agrees" if outcome.iou >= AGREES else "differs"
    if outcome.state != "agrees" and silhouette.pixels(ours) == 0:
        outcome.state = "shows nothing"
    if theirs is None or outcome.state == "agrees":
        return outcome, b""
    return outcome, silhouette.comparison(width, theirs, ours)


def read_notes(path):
    """(part of a file's path, note) from lines of the form "PART: NOTE"."""
    notes = []
    for line in path.read_text().splitlines():
        part, separator, note = line.partition(": ")
        if separator and not line.startswith("#"):
            notes.append((part, note))
    return notes


def write_csv(path, outcomes):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["file", "outcome", "iou", "warnings", "reason", "note"])
        for o in outcomes:
            iou = "" if o.iou is None else f"{o.iou:.3f}"
            writer.writerow([o.file, o.state, iou, o.warnings, o.reason, o.note])


STYLE = """body{font:15px/1.4 sans-serif;margin:2em auto;max-width:70em;padding:0 1em}
table{border-collapse:collapse;width:100%}td,th{border-bottom:1px solid #ccc;padding:.3em;text-align:left;
vertical-align:top;overflow-wrap:anywhere}img{width:128px;image-rendering:auto;border:1px solid #ccc}"""


def row(outcome):
    iou = "" if outcome.iou is None else f"{outcome.iou:.3f}"
    picture = f'<img src="{html.escape(outcome.comparison)}" alt="">' if outcome.comparison else ""
    cells = [html.escape(outcome.file), outcome.state, iou,
             html.escape(" ".join(filter(None, [outcome.reason, outcome.note]))), picture]
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def write_html(path, outcomes, summary):
    """What does not agree first, since that is what is looked for."""
    order = sorted(outcomes, key=lambda o: (-STATES.index(o.state), o.file))
    path.write_text("<!doctype html><html lang=en><meta charset=utf-8><title>COLLADA conformance</title>"
                    f"<style>{STYLE}</style><h1>COLLADA conformance</h1><p>{html.escape(summary)}</p>"
                    "<p>Grey: both silhouettes. Red: the suite's alone. Green: ours alone.</p><table>"
                    "<tr><th>file<th>outcome<th>IoU<th>why<th>silhouettes</tr>\n" +
                    "\n".join(map(row, order)) + "</table></html>\n")


def summary_of(outcomes):
    counts = Counter(o.state for o in outcomes)
    compared_files = sum(o.iou is not None for o in outcomes)
    parts = [f"{state} {counts[state]}" for state in STATES if counts[state]]
    return (f"{len(outcomes)} files: {', '.join(parts)}. Of {compared_files} compared silhouettes "
            f"{counts['agrees']} agree.")


def arguments(words):
    parser = argparse.ArgumentParser(prog="./run conformance",
                                     description="Renders the files of the Khronos conformance suite and "
                                     "compares silhouettes with the suite's pictures.")
    parser.add_argument("program", help=argparse.SUPPRESS)
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="the suite, or a part of it")
    parser.add_argument("--output", type=Path, metavar="DIR", default=Path("conformance"),
                        help="where table.csv and table.html go (conformance)")
    parser.add_argument("--only", default="", metavar="TEXT", help="only files whose path contains the text")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N",
                        help="files at the same time (all processors)")
    parser.add_argument("--seconds", type=int, default=60, metavar="N",
                        help="of a file, before it is hung (60)")
    options = parser.parse_args(words)
    if not options.folder.is_dir():
        parser.error(f"{options.folder} is no folder; the suite is KhronosGroup/COLLADA-CTS at GitHub")
    if options.jobs < 1 or options.seconds < 1:
        parser.error("--jobs and --seconds are at least 1")
    return options


class Judge:
    """judged() with its arguments bound, for other processes."""

    def __init__(self, root, options):
        self.root, self.options = root, options

    def __call__(self, case):
        return judged(case, self.root, self.options)


def main(words):
    options = arguments(words)
    root = options.folder.resolve()
    chosen = [case for case in suite.cases(root) if options.only in str(case.file)]
    if not chosen:
        print(f"conformance: no .dae or .zae file in {options.folder} to render", file=sys.stderr)
        return 2
    options.output.mkdir(parents=True, exist_ok=True)
    notes = read_notes(Path(__file__).parent / "notes.txt")
    outcomes = []
    with Pool(options.jobs) as pool:
        for number, (outcome, picture) in enumerate(pool.imap(Judge(root, options), chosen, chunksize=4)):
            if outcome.state not in ("agrees", "no picture"):
                outcome.note = next((note for part, note in notes if part in outcome.file), "")
            if picture:
                outcome.comparison = f"{number:04}.png"
                (options.output / outcome.comparison).write_bytes(picture)
            outcomes.append(outcome)
            if sys.stderr.isatty():
                print(f"\r{number + 1} of {len(chosen)}", end="", file=sys.stderr)
    summary = summary_of(outcomes)
    write_csv(options.output / "table.csv", outcomes)
    write_html(options.output / "table.html", outcomes, summary)
    print(f"{summary}\nSee {options.output / 'table.html'} and {options.output / 'table.csv'}.")
    return 1 if any(o.state in ("crashed", "hung") for o in outcomes) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
