# SPDX-License-Identifier: Apache-2.0
"""What the scripts that render by a peer are told; renderers.py tells them."""
import argparse
import sys

from exchange import Unsupported, read_scene


def parser():
    made = argparse.ArgumentParser()
    made.add_argument("scene")
    made.add_argument("output")
    made.add_argument("--samples", type=int, default=64)
    made.add_argument("--depth", type=int, default=5)
    made.add_argument("--seed", type=int, default=0)
    made.add_argument("--threads", type=int, default=1)
    made.add_argument("--size", type=int, nargs=2)
    made.add_argument("--roulette", action="store_true")
    return made


def scene_of(arguments):
    """The scene, of the size that is asked for."""
    scene = read_scene(arguments.scene)
    if arguments.size:
        scene["resolution"] = arguments.size
    return scene


def run(main):
    """Calls main(); what the renderer has no equal of ends the script with a message."""
    try:
        main()
    except Unsupported as error:
        sys.exit(str(error))
