#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders scenes by twinray and by the renderers that are installed, in turn, and writes one page.

peers.py PROGRAM [SCENE]... [option]...   docs/peers.md says what is measured, and how

Of each scene every renderer makes, in every round: a picture of some 16 x 12 pixels, one sample (its start),
one of --samples without roulette, and one by its own default roulette, of as many samples (a power of two) as
it makes in --seconds. Exit code 1 where a renderer fails, or pictures do not agree.
"""
import argparse
import math
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import compare
import exr
import measure
import page
import panorama
import renderers

OWN_SCENE = Path(__file__).resolve().parents[2] / "scenes" / "cornell-bunny.dae"
START_WIDTH = 16  # pixels, of at least so many
LIGHT = 2.0  # radiance from which a pixel is said to see a light


@dataclass
class Series:
    """The same picture in all rounds, each with another seed."""
    samples: int
    costs: list = field(default_factory=list)
    pictures: list = field(default_factory=list)
    errors: list = field(default_factory=list)


@dataclass
class Entry:
    """What is known of one renderer and one scene."""
    renderer: renderers.Renderer
    starts: list = field(default_factory=list)
    equal: Series = None    # equal samples, no roulette
    usual: Series = None    # default roulette, as many samples as the seconds allow
    failure: str = ""
    agreement: compare.Agreement = None

    def start(self):
        return measure.quartiles([cost.cpu_seconds for cost in self.starts])[1]


@dataclass
class SceneResult:
    name: str
    picture: renderers.Picture
    entries: list
    kept: float = 1  # the share of pixels that see no light


def read_arguments(words):
    parser = argparse.ArgumentParser(prog="./run peers", description=__doc__.split("\n", 1)[0])
    parser.add_argument("program", help=argparse.SUPPRESS)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=f"scene files (scenes/{OWN_SCENE.name})")
    parser.add_argument("--peers", metavar="DIR", default=os.environ.get("TWINRAY_PEERS", ""),
                        help="the virtual environment that has them (TWINRAY_PEERS)")
    parser.add_argument("--seconds", type=float, default=8,
                        help="CPU seconds of a picture by default settings (8)")
    parser.add_argument("--samples", type=int, default=64, help="of the pictures at equal samples (64)")
    parser.add_argument("--rounds", type=int, default=3, help="of all pictures (3)")
    parser.add_argument("-m", "--depth", type=int, default=5, help="bounces of light (5)")
    parser.add_argument("-r", "--resolution", type=int, nargs=2, metavar=("W", "H"), default=(480, 360))
    parser.add_argument("--view", choices=("whole", "file"), default="whole",
                        help="all of the scene, or as the file's camera sees it (whole)")
    parser.add_argument("-t", "--threads", type=int, default=1, help="of each renderer (1)")
    parser.add_argument("--rmse", type=float, default=0.005, help="the error whose seconds are told (0.005)")
    parser.add_argument("--only", metavar="TEXT", default="", help="only peers whose name holds this text")
    parser.add_argument("-o", "--output", metavar="DIR", default="peers",
                        help="of page, table and pictures (peers)")
    arguments = parser.parse_intermixed_args(words)
    for name in ("seconds", "samples", "rounds", "depth", "threads", "rmse"):
        if not getattr(arguments, name) > 0:
            parser.error(f"--{name}: {getattr(arguments, name)} is not above 0")
    arguments.scenes = arguments.scenes or [str(OWN_SCENE)]
    return arguments


def start_size(width, height):
    """The smallest picture of this shape, but not below START_WIDTH."""
    common = math.gcd(width, height)
    times = min(common, math.ceil(START_WIDTH * common / width))
    return width // common * times, height // common * times


def say(text):
    print(text, file=sys.stderr, flush=True)


class Bench:
    """One scene's measurements."""

    def __init__(self, arguments, picture, found):
        self.arguments, self.picture = arguments, picture
        self.processors = measure.processors(arguments.threads)
        self.entries = [Entry(renderer) for renderer in found]
        self.seed = 0

    def render(self, renderer, samples, roulette, size=()):
        """(cost, picture) of one process."""
        self.seed += 1
        with tempfile.TemporaryDirectory() as folder:
            output = str(Path(folder) / "picture.exr")
            request = renderers.Request(output, samples, self.seed, roulette, size)
            cost = measure.run(renderer.call(self.picture, request), self.processors)
            return cost, exr.read(output).pixels

    def round(self):
        for entry in self.entries:
            if not entry.failure:
                self.one_round(entry)

    def one_round(self, entry):
        try:
            size = start_size(*self.arguments.resolution)
            entry.starts.append(self.render(entry.renderer, 1, True, size)[0])
            entry.equal = entry.equal or Series(self.arguments.samples)
            self.add(entry, entry.equal, False)
            entry.usual = entry.usual or Series(self.affordable(entry))
            self.add(entry, entry.usual, True)
        except (measure.Failed, OSError, ValueError) as error:
            entry.failure = str(error)
            say(f"{entry.renderer.name}: left out: {error}")

    def add(self, entry, series, roulette):
        cost, picture = self.render(entry.renderer, series.samples, roulette)
        series.costs.append(cost)
        series.pictures.append(picture)
        say(f"{entry.renderer.name}, {series.samples} samples: {cost.cpu_seconds:.2f} CPU seconds")

    def affordable(self, entry):
        """The power of two of samples that fits into the seconds, by the first picture's time; or one."""
        cost = max(entry.equal.costs[0].cpu_seconds - entry.start(), 1e-3)
        return 2 ** max(0, int(math.log2(max(1, self.arguments.seconds * entry.equal.samples / cost))))


def pictures_of(entries, family):
    return [picture for entry in entries if entry.renderer.family == family
            for series in (entry.equal, entry.usual) for picture in series.pictures]


class References:
    """Two means of independent noise, each of all that a family rendered: of two peers if there are two."""

    def __init__(self, entries):
        families = list(dict.fromkeys(entry.renderer.family for entry in reversed(entries)))
        self.pictures = [pictures_of(entries, family) for family in families[:2]]
        self.means = [compare.mean_picture(pictures) for pictures in self.pictures]

    def without(self, picture):
        """Both, from the mean in which a picture is that picture taken out."""
        for pictures, mean in zip(self.pictures, self.means):
            is_in = any(picture is one for one in pictures)
            yield compare.mean_without(mean, len(pictures), picture) if is_in else mean


def judge(result):
    """Fills in errors and agreement, where a peer is left to compare with."""
    entries = [entry for entry in result.entries if not entry.failure]
    if len(entries) == 1:
        return
    width, height = result.picture.width, result.picture.height
    mask = compare.without_lights([entry.equal.pictures[0] for entry in entries], width, height, LIGHT)
    result.kept = sum(mask) / len(mask)
    references = References(entries)
    for entry in entries:
        for series in (entry.equal, entry.usual):
            series.errors = [compare.error(picture, *references.without(picture), mask)
                             for picture in series.pictures]
    ours = compare.mean_picture(pictures_of(entries, "twinray"))
    for entry in entries:
        both = compare.mean_picture(entry.equal.pictures + entry.usual.pictures)
        entry.agreement = compare.agreement(both, ours, mask, width, height)


def convert(program, scene, output, arguments):
    width, height = map(str, arguments.resolution)
    words = [program, "convert", "-q", f"--view={arguments.view}", "-r", width, height, scene, output]
    if subprocess.run(words, check=False).returncode != 0:
        sys.exit(1)


def measured(arguments, scene, found):
    with tempfile.TemporaryDirectory() as folder:
        exchange = str(Path(folder) / "scene.json")
        convert(arguments.program, scene, exchange, arguments)
        panorama.draw_squares_anew(exchange)
        if any(one.family == "pbrt" for one in found):
            convert(arguments.program, scene, renderers.pbrt_form(exchange), arguments)
        picture = renderers.Picture(scene, exchange, arguments.view, *arguments.resolution,
                                    arguments.depth, arguments.threads)
        bench = Bench(arguments, picture, found)
        for number in range(arguments.rounds):
            say(f"{Path(scene).stem}: round {number + 1} of {arguments.rounds}")
            bench.round()
    if bench.entries[0].failure:
        sys.exit(1)
    result = SceneResult(Path(scene).stem, picture, bench.entries)
    judge(result)
    return result


def is_good(result):
    return all(entry.agreement and entry.agreement.is_good() for entry in result.entries)


def main(words):
    arguments = read_arguments(words)
    found = renderers.installed(arguments.program, arguments.peers)
    if len(found) == 1:
        say(renderers.HOW_TO_INSTALL.format(folder=arguments.peers or "any place: --peers names none"))
        return 1
    found = [one for one in found if one.family == "twinray" or arguments.only in one.name]
    if len(found) == 1:
        say(f"--only: no peer's name holds \"{arguments.only}\"")
        return 2
    output = Path(arguments.output)
    try:
        output.mkdir(exist_ok=True)
    except OSError as error:
        say(f"--output: {output}: this folder cannot be made: {error.strerror}")
        return 1
    results = [measured(arguments, scene, found) for scene in arguments.scenes]
    (output / "index.html").write_text(page.html_page(results, arguments), encoding="utf-8")
    (output / "table.md").write_text(page.markdown(results, arguments), encoding="utf-8")
    for result in results:
        if picture := page.strip(result):
            (output / f"{result.name}.png").write_bytes(picture)
    say(f"{output}/index.html, {output}/table.md")
    return 0 if all(map(is_good, results)) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
