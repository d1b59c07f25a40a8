#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders generated scenes that are too large for the ordinary tests: large_scenes.py PROGRAM

Each must be rendered, every pixel of it lit. A line says how long that took and how much memory.
"""
import os
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

HEAD = """<COLLADA version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_cameras><camera id="eye"><optics><technique_common><perspective><xfov>40</xfov>
<aspect_ratio>1.3333</aspect_ratio></perspective></technique_common></optics></camera></library_cameras>
<library_geometries>"""
MIDDLE = """</library_geometries><library_visual_scenes><visual_scene id="world">
<node><translate>0.5 0.5 1</translate><instance_camera url="#eye"/></node>"""
TAIL = """</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#world"/></scene></COLLADA>"""


def geometry(name, positions, indices):
    """The text of a mesh: positions are (x, y, z), indices are of three corners each."""
    count = len(positions)
    yield (f'<geometry id="{name}"><mesh><source id="{name}-p">'
           f'<float_array id="{name}-a" count="{3 * count}">')
    for begin in range(0, count, 10000):
        yield " ".join(f"{x:g} {y:g} {z:g}" for x, y, z in positions[begin:begin + 10000]) + "\n"
    yield (f'</float_array><technique_common><accessor source="#{name}-a" count="{count}" stride="3">'
           '<param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common></source>'
           f'<vertices id="{name}-v"><input semantic="POSITION" source="#{name}-p"/></vertices>'
           f'<triangles count="{len(indices)}"><input semantic="VERTEX" source="#{name}-v" offset="0"/><p>')
    for begin in range(0, len(indices), 10000):
        yield " ".join(f"{a} {b} {c}" for a, b, c in indices[begin:begin + 10000]) + "\n"
    yield "</p></triangles></mesh></geometry>\n"


def tiny_meshes(side):
    """side x side meshes of one triangle, each a node and a geometry of its own, that cover a square."""
    step = 1.4 / side
    yield HEAD
    for i in range(side * side):
        yield from geometry(f"g{i}", [(0, 0, 0), (2 * step, 0, 0), (0, 2 * step, 0)], [(0, 1, 2)])
    yield MIDDLE
    for i in range(side * side):
        x, y = i % side * step - 0.2, i // side * step - 0.2
        yield f'<node><translate>{x:g} {y:g} 0</translate><instance_geometry url="#g{i}"/></node>\n'
    yield TAIL


def instances(side):
    """The same with one geometry."""
    step = 1.4 / side
    yield HEAD
    yield from geometry("g", [(0, 0, 0), (2 * step, 0, 0), (0, 2 * step, 0)], [(0, 1, 2)])
    yield MIDDLE
    for i in range(side * side):
        x, y = i % side * step - 0.2, i // side * step - 0.2
        yield f'<node><translate>{x:g} {y:g} 0</translate><instance_geometry url="#g"/></node>\n'
    yield TAIL


def one_mesh(side):
    """A wavy sheet of 2 side^2 triangles."""
    def height(i, j):
        return 0.01 * ((7 * i + 13 * j) % 17) / 17
    points = [(1.4 * i / side - 0.2, 1.4 * j / side - 0.2, height(i, j))
              for j in range(side + 1) for i in range(side + 1)]
    corners = [(j * (side + 1) + i, j * (side + 1) + i + 1, (j + 1) * (side + 1) + i) for j in range(side)
               for i in range(side)]
    yield HEAD
    yield from geometry("sheet", points,
                        corners + [(b, c + 1, c) for a, b, c in corners])
    yield MIDDLE
    yield '<node><instance_geometry url="#sheet"/></node>'
    yield TAIL


SCENES = {
    "a million nodes of one mesh": lambda: instances(1000),
    "a million meshes of one triangle": lambda: tiny_meshes(1000),
    "one mesh of ten million triangles": lambda: one_mesh(2237),
}


def unfiltered(kind, line, above):
    """A line of a PNG of 3 bytes a pixel, by the kinds of filter of its specification."""
    out = bytearray(line)
    for i in range(len(out)):
        left, up, corner = (out[i - 3] if i > 2 else 0), above[i], (above[i - 3] if i > 2 else 0)
        nearest = min((abs(up - corner), 0, left), (abs(left - corner), 1, up),
                      (abs(left + up - 2 * corner), 2, corner))[2]
        out[i] = (out[i] + (0, left, up, (left + up) // 2, nearest)[kind]) % 256
    return out


def black_pixels(png):
    """How many pixels of an 8-bit RGB picture are black."""
    width, height = struct.unpack(">II", png[16:24])
    packed, at = b"", 8
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        packed += png[at + 8:at + 8 + size] if kind == b"IDAT" else b""
        at += 12 + size
    raw, black, above = zlib.decompress(packed), 0, bytes(3 * width)
    for y in range(height):
        begin = y * (3 * width + 1)
        above = unfiltered(raw[begin], raw[begin + 1:begin + 1 + 3 * width], above)
        black += sum(above[x:x + 3] == bytes(3) for x in range(0, 3 * width, 3))
    return black


def render(program, name, text):
    """Writes the scene, renders it, and says what that took; whether all is well."""
    with tempfile.TemporaryDirectory() as folder:
        scene, picture = Path(folder) / "scene.dae", Path(folder) / "picture.png"
        with scene.open("w") as file:
            file.writelines(text)
        megabytes = scene.stat().st_size / 1e6
        start = time.monotonic()
        command = [program, str(scene), "-q", "-s", "1", "-r", "160", "120",
                   "--integrator=normals", "-o", str(picture)]
        process = subprocess.Popen(command)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        black = black_pixels(picture.read_bytes()) if process.returncode == 0 else 0
        print(f"{name}: {megabytes:.0f} MB, {time.monotonic() - start:.1f} s, "
              f"{usage.ru_maxrss / 1e6:.2f} GB of memory, exit code {process.returncode}, "
              f"{black} black pixels", flush=True)
        return process.returncode == 0 and black == 0


def main(arguments):
    if len(arguments) != 1:
        print("usage: large_scenes.py PROGRAM", file=sys.stderr)
        return 2
    failed = 0
    for name, text in SCENES.items():
        failed += not render(arguments[0], name, text())
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
