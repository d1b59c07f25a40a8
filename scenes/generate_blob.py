#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes cornell-bunny.dae: the box of box.dae around a creature of about 10,000 triangles.

The creature is a smooth union of round shapes, given by a function that is negative inside. Its surface is found
by surface nets (Gibson, "Constrained Elastic Surface Nets", 1998): each cell of a grid that the surface crosses
holds one vertex, and each grid edge that it crosses becomes a quad. The vertices are then moved onto the surface
along the function's gradient, which is also their normal. Only + - * / and square roots: the file is the same
everywhere.

Usage: scenes/generate_blob.py   (in any folder; writes beside itself)
"""
import math
import os

STEP = 0.0203  # of the grid: decides the number of triangles
LOWER, UPPER = (-0.36, -0.02, -0.46), (0.36, 0.94, 0.46)
BLEND = 0.07  # width of the smooth joints


def ellipsoid(p, centre, radii):
    """An estimate of the distance to an ellipsoid, exact on its surface."""
    x, y, z = ((p[i] - centre[i]) / radii[i] for i in range(3))
    scaled = math.sqrt(x * x + y * y + z * z)
    slope = math.sqrt((x / radii[0]) ** 2 + (y / radii[1]) ** 2 + (z / radii[2]) ** 2)
    return scaled * (scaled - 1) / slope if slope > 0 else -min(radii)


def capsule(p, a, b, radius_a, radius_b):
    """A rod from a to b whose thickness changes along it."""
    axis = [b[i] - a[i] for i in range(3)]
    along = sum((p[i] - a[i]) * axis[i] for i in range(3)) / sum(c * c for c in axis)
    along = min(max(along, 0.0), 1.0)
    d = [p[i] - a[i] - along * axis[i] for i in range(3)]
    return math.sqrt(sum(c * c for c in d)) - (radius_a + along * (radius_b - radius_a))


def join(a, b):
    """The smaller of two distances, with a rounded crease."""
    h = max(BLEND - abs(a - b), 0.0) / BLEND
    return min(a, b) - h * h * BLEND / 4


def field(p):
    """Negative inside of the creature, which sits on y = 0 and looks along +z."""
    q = (abs(p[0]), p[1], p[2])  # it is symmetric
    d = ellipsoid(q, (0, 0.24, -0.10), (0.22, 0.23, 0.27))  # body
    d = join(d, ellipsoid(q, (0, 0.28, 0.10), (0.15, 0.17, 0.14)))  # chest
    d = join(d, ellipsoid(q, (0, 0.50, 0.17), (0.135, 0.13, 0.15)))  # head
    d = join(d, ellipsoid(q, (0, 0.46, 0.28), (0.075, 0.06, 0.06)))  # snout
    d = join(d, capsule(q, (0.055, 0.58, 0.13), (0.11, 0.84, 0.00), 0.035, 0.050))  # ears
    d = join(d, ellipsoid(q, (0.16, 0.13, -0.12), (0.10, 0.13, 0.17)))  # thighs
    d = join(d, ellipsoid(q, (0.165, 0.05, 0.05), (0.06, 0.05, 0.13)))  # hind feet
    d = join(d, capsule(q, (0.07, 0.22, 0.17), (0.065, 0.04, 0.24), 0.05, 0.04))  # forelegs
    return join(d, ellipsoid(q, (0, 0.17, -0.37), (0.075, 0.075, 0.075)))  # tail


def gradient(p):
    h = 1e-4
    result = []
    for axis in range(3):
        more, less = list(p), list(p)
        more[axis] += h
        less[axis] -= h
        result.append((field(more) - field(less)) / (2 * h))
    return result


def onto_surface(p):
    """Three of Newton's steps along the gradient; returns the point and its unit normal."""
    for _ in range(3):
        g = gradient(p)
        step = field(p) / sum(c * c for c in g)
        p = [p[i] - step * g[i] for i in range(3)]
    g = gradient(p)
    length = math.sqrt(sum(c * c for c in g))
    return p, [c / length for c in g]


def surface_net():
    """Vertices and quads of the surface, the quads wound counter-clockwise from outside."""
    size = [int((UPPER[i] - LOWER[i]) / STEP) + 2 for i in range(3)]

    def position(i, j, k):
        return (LOWER[0] + i * STEP, LOWER[1] + j * STEP, LOWER[2] + k * STEP)

    values = {(i, j, k): field(position(i, j, k))
              for i in range(size[0]) for j in range(size[1]) for k in range(size[2])}
    offsets = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    edges = [(a, b) for a in offsets for b in offsets if sum(b) == sum(a) + 1 and all(x <= y for x, y in zip(a, b))]

    vertices, index = [], {}
    for i in range(size[0] - 1):
        for j in range(size[1] - 1):
            for k in range(size[2] - 1):
                crossings = []
                for a, b in edges:
                    va = values[i + a[0], j + a[1], k + a[2]]
                    vb = values[i + b[0], j + b[1], k + b[2]]
                    if (va < 0) != (vb < 0):
                        t = va / (va - vb)
                        crossings.append([a[c] + t * (b[c] - a[c]) for c in range(3)])
                if crossings:
                    mean = [sum(c[axis] for c in crossings) / len(crossings) for axis in range(3)]
                    index[i, j, k] = len(vertices)
                    vertices.append(position(i + mean[0], j + mean[1], k + mean[2]))

    quads = []
    for (i, j, k), value in values.items():
        for axis in range(3):
            u, v = [1 if c == (axis + 1) % 3 else 0 for c in range(3)], [1 if c == (axis + 2) % 3 else 0 for c in range(3)]
            end = tuple(n + (1 if c == axis else 0) for c, n in enumerate((i, j, k)))
            if end not in values or (value < 0) == (values[end] < 0):
                continue
            around = [(i - a * u[0] - b * v[0], j - a * u[1] - b * v[1], k - a * u[2] - b * v[2])
                      for a, b in ((1, 1), (0, 1), (0, 0), (1, 0))]
            quad = [index[cell] for cell in around]
            quads.append(quad if value < 0 else quad[::-1])
    return vertices, quads


def triangles_of(quads, vertices):
    """Each quad is cut along its shorter diagonal."""
    def squared(a, b):
        return sum((vertices[a][i] - vertices[b][i]) ** 2 for i in range(3))

    for a, b, c, d in quads:
        yield from ((a, b, c), (a, c, d)) if squared(a, c) <= squared(b, d) else ((a, b, d), (b, c, d))


def numbers(rows, form):
    """Rows of numbers as text, eight rows a line."""
    words = ["  ".join(" ".join(form(x) for x in row) for row in rows[i:i + 8]) for i in range(0, len(rows), 8)]
    return "\n            ".join(words)


def source(name, rows):
    return f"""        <source id="creature-{name}">
          <float_array id="creature-{name}-array" count="{3 * len(rows)}">
            {numbers(rows, lambda x: f"{x:.5f}")}
          </float_array>
          <technique_common>
            <accessor source="#creature-{name}-array" count="{len(rows)}" stride="3">
              <param name="X" type="float"/>
              <param name="Y" type="float"/>
              <param name="Z" type="float"/>
            </accessor>
          </technique_common>
        </source>
"""


def mesh():
    vertices, quads = surface_net()
    placed = [onto_surface(v) for v in vertices]
    positions, normals = [p for p, _ in placed], [n for _, n in placed]
    triangles = list(triangles_of(quads, positions))
    return f"""    <geometry id="creature">
      <mesh>
{source("positions", positions)}{source("normals", normals)}        <vertices id="creature-vertices">
          <input semantic="POSITION" source="#creature-positions"/>
          <input semantic="NORMAL" source="#creature-normals"/>
        </vertices>
        <triangles count="{len(triangles)}" material="fur">
          <input semantic="VERTEX" source="#creature-vertices" offset="0"/>
          <p>
            {numbers(triangles, str)}
          </p>
        </triangles>
      </mesh>
    </geometry>
"""


COMMENT = """  A Cornell box with a creature of the size of CS184's bunny: the box and the lamp of box.dae, and a closed mesh of
  about 10,000 triangles with smooth normals. Written by generate_blob.py: change that, not this file."""

EFFECT = """    <effect id="fur-effect">
      <profile_COMMON>
        <technique sid="common">
          <lambert>
            <diffuse>
              <color>0.5 0.5 0.5 1</color>
            </diffuse>
          </lambert>
        </technique>
      </profile_COMMON>
    </effect>
"""

MATERIAL = """    <material id="fur" name="fur">
      <instance_effect url="#fur-effect"/>
    </material>
"""

NODE = """      <node id="creature-node" name="creature">
        <translate>0 0.0052 0</translate>
        <rotate>0 1 0 -35</rotate>
        <instance_geometry url="#creature">
          <bind_material>
            <technique_common>
              <instance_material symbol="fur" target="#fur"/>
            </technique_common>
          </bind_material>
        </instance_geometry>
      </node>
"""


def with_creature(box):
    """The text of box.dae with the creature in it."""
    start = box.index("<!--", box.index("-->")) + len("<!--")
    box = box[:start] + "\n" + COMMENT + "\n" + box[box.index("-->", start):]
    for end, text in (("  </library_effects>", EFFECT), ("  </library_materials>", MATERIAL),
                      ("  </library_geometries>", mesh()), ("    </visual_scene>", NODE)):
        at = box.index(end)
        box = box[:at] + text + box[at:]
    return box


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(folder, "box.dae"), encoding="utf-8") as file:
        box = file.read()
    with open(os.path.join(folder, "cornell-bunny.dae"), "w", encoding="utf-8") as file:
        file.write(with_creature(box))


if __name__ == "__main__":
    main()
