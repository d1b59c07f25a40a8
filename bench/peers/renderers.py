# SPDX-License-Identifier: Apache-2.0
"""The renderers that are compared: how each is found and called."""
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
MITSUBAS = (("llvm_ad_rgb", "multijitter"), ("llvm_ad_rgb", "independent"), ("scalar_rgb", "independent"))
HOW_TO_INSTALL = """No peer was found in {folder}.
A folder for them, outside of the repository, is made by:
  python3 -m venv DIR && DIR/bin/pip install mitsuba bpy
and given by --peers=DIR or the environment variable TWINRAY_PEERS. Mitsuba's llvm variants need an LLVM
library; DRJIT_LIBLLVM_PATH=FILE names one, where none is found or the one that is found is too old.
pbrt-v4's program is looked for in DIR/bin, too, and where all programs are."""


@dataclass(frozen=True)
class Picture:
    """What is rendered."""
    scene: str       # the scene file
    exchange: str    # the same in exchange form; beside it, for pbrt, in pbrt-v4's format
    view: str        # of twinray's --view
    width: int
    height: int
    depth: int
    threads: int


@dataclass(frozen=True)
class Request:
    """How it is rendered."""
    output: str
    samples: int
    seed: int
    roulette: bool   # as the renderer does it by default; else none
    size: tuple = ()  # in place of the picture's; of the same shape


@dataclass(frozen=True)
class Renderer:
    name: str
    family: str      # renderers of one family have their errors in common, if they have any
    call: object     # (Picture, Request) -> the words of a command


def twinray(program, options=()):
    def call(picture, request):
        width, height = request.size or (picture.width, picture.height)
        return [program, "render", picture.scene, f"--view={picture.view}", "-r", str(width), str(height),
                "-s", str(request.samples), "-m", str(picture.depth), "-t", str(picture.threads),
                "--seed", str(request.seed), "--filter=box", "-q", "-o", request.output,
                *([] if request.roulette else ["--roulette=1"]), *options]
    return call


def pbrt_form(exchange):
    """Where the scene is in pbrt-v4's format."""
    return str(Path(exchange).with_suffix(".pbrt"))


def common_words(picture, request, scene=""):
    return [scene or picture.exchange, request.output, "--samples", str(request.samples),
            "--depth", str(picture.depth), "--seed", str(request.seed), "--threads", str(picture.threads),
            *(["--roulette"] if request.roulette else []),
            *(["--size", *map(str, request.size)] if request.size else [])]


def mitsuba(python, variant, sampler):
    def call(picture, request):
        return [python, str(HERE / "mitsuba_render.py"), *common_words(picture, request),
                "--variant", variant, "--sampler", sampler]
    return call


def cycles(start):
    return lambda picture, request: [*start, *common_words(picture, request)]


def pbrt(program):
    def call(picture, request):
        return [sys.executable, str(HERE / "pbrt_render.py"),
                *common_words(picture, request, pbrt_form(picture.exchange)), "--program", program]
    return call


def has_module(python, name):
    code = f"import importlib.util, sys; sys.exit(importlib.util.find_spec('{name}') is None)"
    return os.access(python, os.X_OK) and subprocess.run([python, "-c", code], check=False).returncode == 0


def installed(program, folder):
    """All renderers that are there, ours first."""
    python = str(Path(folder) / "bin" / "python")
    found = [Renderer("twinray", "twinray", twinray(program))]
    if has_module(python, "mitsuba"):
        found += [Renderer(f"Mitsuba {variant.split('_')[0]}, {sampler}", "Mitsuba",
                           mitsuba(python, variant, sampler)) for variant, sampler in MITSUBAS]
    script = str(HERE / "cycles_render.py")
    blender = ["blender", "--background", "--factory-startup", "--python-exit-code", "1",
               "--python", script, "--"]
    if has_module(python, "bpy"):
        found.append(Renderer("Cycles", "Cycles", cycles([python, script])))
    elif shutil.which("blender"):
        found.append(Renderer("Cycles", "Cycles", cycles(blender)))
    places = os.pathsep.join([str(Path(folder) / "bin"), os.environ.get("PATH", os.defpath)])
    if program := shutil.which("pbrt", path=places):
        found.append(Renderer("pbrt-v4", "pbrt", pbrt(program)))
    return found
