#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tables of docs/denoising.md: what denoisers take away, and how true the estimated error is.

    denoising.py PROGRAM FOLDER SCENE...

needs the packages numpy, OpenEXR and flip-evaluator of PyPI, and Open Image Denoise where the program finds
it. Pictures of all scenes are kept in FOLDER and not made again. Prints tables in Markdown.
"""
import json
import subprocess
import sys
from pathlib import Path

import flip_evaluator
import numpy
import OpenEXR

PICTURE = ("-r", "120", "90", "--filter=box")
COUNTS = (16, 64, 256)
HARM = 4096
REFERENCE = 2048


class Renderer:
    def __init__(self, program, folder, scene):
        self.program, self.folder, self.scene = program, Path(folder), scene
        path = Path(scene)
        self.name = path.stem if path.stem != "scene-v4" else path.parent.name

    def picture(self, label, *options):
        """The channels of a picture, and its statistics."""
        path = self.folder / f"{self.name}-{label}.exr"
        statistics = path.with_suffix(".json")
        if not statistics.exists():
            subprocess.run([self.program, "render", self.scene, "-q", *PICTURE, "-o", path,
                            "--stats", statistics, *options], check=True, stderr=subprocess.DEVNULL)
        channels = OpenEXR.File(str(path), separate_channels=True).channels()
        pixels = {name: channel.pixels for name, channel in channels.items()}
        return pixels, json.loads(statistics.read_text())


def color(channels, prefix=""):
    return numpy.stack([channels[prefix + name] for name in "RGB"], axis=-1).astype(numpy.float64)


def relative(picture, reference):
    return float(numpy.mean((picture - reference) ** 2 / (reference ** 2 + 0.01)))


def flip(picture, reference):
    images = [numpy.maximum(image, 0).astype(numpy.float32) for image in (reference, picture)]
    return float(flip_evaluator.evaluate(*images, "HDR", applyMagma=False)[1])


def measure(renderer):
    a, b = (color(renderer.picture(f"reference-{seed}", "-s", str(REFERENCE), "--seed", str(seed))[0])
            for seed in (1001, 1002))
    reference = (a + b) / 2
    own_noise = float(numpy.mean((a - b) ** 2 / 4 / (reference ** 2 + 0.01)))
    for count in (*COUNTS, HARM):
        options = ("-s", str(count), "--noise-target=1e-6")
        estimate = renderer.picture(f"noisy-{count}", *options)[1]["render"]["estimated_error"]
        own, statistics = renderer.picture(f"own-{count}", *options, "--denoise=own")
        noisy, ours = color(own, "noisy."), color(own)
        row = {"noisy": relative(noisy, reference) - own_noise, "own": relative(ours, reference) - own_noise,
               "noisy flip": flip(noisy, reference), "own flip": flip(ours, reference),
               "own seconds": statistics["denoising"]["seconds"],
               "estimate": estimate}
        if count != HARM:
            other, statistics = renderer.picture(f"oidn-{count}", *options, "--denoise=oidn")
            theirs = color(other)
            row |= {"oidn": relative(theirs, reference) - own_noise, "oidn flip": flip(theirs, reference),
                    "oidn seconds": statistics["denoising"]["seconds"]}
        yield count, row


def number(value, form):
    return format(value, form) if value is not None else ""


def main():
    program, folder, *scenes = sys.argv[1:]
    print("| scene | samples | noisy | own | OIDN | FLIP noisy | own | OIDN | estimated error | true |")
    print("|---|---|---|---|---|---|---|---|---|---|", flush=True)
    for scene in scenes:
        renderer = Renderer(program, folder, scene)
        for count, row in measure(renderer):
            true = max(row["noisy"], 0) ** 0.5
            cells = [renderer.name, str(count)]
            cells += [number(row.get(key), ".2g") for key in ("noisy", "own", "oidn")]
            cells += [number(row.get(key + " flip"), ".3f") for key in ("noisy", "own", "oidn")]
            cells += [number(row["estimate"], ".3g"), number(true, ".3g")]
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
