# SPDX-License-Identifier: Apache-2.0
"""Renders a scene in pbrt-v4's format, as `twinray convert` writes it, by pbrt-v4. Prints its version.

pbrt-v4 always plays Russian roulette: --roulette changes nothing.
"""
import re
import subprocess
import sys
from pathlib import Path

import task

STATEMENTS = ("Film", "Integrator", "PixelFilter", "Sampler")


def pbrt_scene(text, arguments):
    """The text with the film, filter, sampler and integrator that are asked for in place of its own."""
    options, world = text.split("\nWorldBegin", 1)
    lines = options.split("\n")
    film = next(line for line in lines if line.startswith("Film "))
    width, height = arguments.size or [int(re.search(rf'"integer {side}resolution" \[ (\d+) \]', film)[1])
                                       for side in "xy"]
    lines = [line for line in lines if not line.startswith(STATEMENTS)]
    size = f'"integer xresolution" {width} "integer yresolution" {height}'
    diagonal = re.search(r'"float diagonal" \[ \S+ \]', film)  # A lens's.
    lines += [f'Film "rgb" {size} "bool savefp16" false ' + (diagonal[0] if diagonal else ""),
              'PixelFilter "box"',
              f'Sampler "zsobol" "integer pixelsamples" {arguments.samples} "integer seed" {arguments.seed}',
              f'Integrator "path" "integer maxdepth" {arguments.depth}']
    return "\n".join(lines) + "\nWorldBegin" + world


def call(program, arguments):
    """What pbrt says; its reason and the end of this program where it fails."""
    done = subprocess.run([program, *arguments], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False)
    if done.returncode != 0:
        sys.exit(done.stdout.strip() or f"{program} ended with {done.returncode}")
    return done.stdout


def main():
    parser = task.parser()
    parser.add_argument("--program", default="pbrt")
    arguments = parser.parse_args()
    scene = Path(arguments.scene)
    made = scene.with_name("made.pbrt")  # in the same folder, where its meshes are
    made.write_text(pbrt_scene(scene.read_text(encoding="utf-8"), arguments), encoding="utf-8")
    said = call(arguments.program,
                ["--nthreads", str(arguments.threads), "--outfile", arguments.output, str(made)])
    version = re.search(r"pbrt version \S+", said)
    print(version[0] if version else "pbrt")


if __name__ == "__main__":
    main()
