# SPDX-License-Identifier: Apache-2.0
"""Reads a scene in exchange form, as `twinray convert` writes it (docs/exchange.md)."""
import json
import struct
from array import array
from dataclasses import dataclass, field
from pathlib import Path


class Unsupported(Exception):
    """Something that a renderer has no equal of, in words for the user."""


@dataclass
class Mesh:
    """Numbers in a row: three a position or a normal, two a texture coordinate, three indices a triangle."""
    positions: array
    triangles: array
    normals: array = field(default_factory=lambda: array("f"))
    uvs: array = field(default_factory=lambda: array("f"))

    def position(self, vertex):
        return tuple(self.positions[3 * vertex:3 * vertex + 3])


@dataclass
class Rectangle:
    """Its corners are center +- u +- v; it faces along u x v."""
    center: tuple
    u: tuple
    v: tuple


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(a, factor):
    return tuple(x * factor for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scaled(a, 1 / dot(a, a) ** 0.5)


def columns_as_rows(x, y, z, origin):
    """The transform whose columns are given, as rows."""
    return [[x[k], y[k], z[k], origin[k]] for k in range(3)] + [[0, 0, 0, 1]]


def read_scene(path):
    """The scene as its JSON file has it, each "file" as a whole path."""
    scene = json.loads(Path(path).read_text(encoding="utf-8"))
    if scene.get("format") != "twinray scene" or scene.get("version") not in (1, 2, 3, 4):
        raise Unsupported(f"{path}: this is no scene in twinray's exchange form, version 1 to 4")
    for entry in scene["shapes"] + scene["lights"] + scene.setdefault("textures", []):
        if "file" in entry:
            entry["file"] = str(Path(path).resolve().parent / entry["file"])
    return scene


def textures_of(material, scene, peer):
    """What textures give the material, by the name of its number or colour: entries of the scene's list."""
    for relief in ("normal_map", "bump_map"):
        if relief in material:
            raise Unsupported(f"the {relief} of \"{material['name']}\" is not converted for {peer}")
    for use in material.get("textures", []):
        if use["meaning"] != "value":
            raise Unsupported(f"the {use['input']} of \"{material['name']}\" is not converted for {peer}: "
                              f"it is the {use['meaning']} of a texture")
    return {use["input"]: scene["textures"][use["texture"]] for use in material.get("textures", [])}


def refuse_holes(shape, peer):
    if "alpha" in shape:
        raise Unsupported(f"the holes of \"{shape['name']}\" are not converted for {peer}")


def refuse_picture(light, peer):
    """A mesh that emits differently from point to point."""
    if light is not None and "file" in light:
        raise Unsupported(f"the picture of the light \"{light['name']}\" is not converted for {peer}")


def light_of(scene, shape):
    """The light that a shape is; None where it is none."""
    return scene["lights"][shape["light"]] if "light" in shape else None


def has_inverse_square_law(light):
    law = light["attenuation"]
    return (law["constant"], law["linear"], law["quadratic"]) == (0, 0, 1)


def half_size(camera, resolution, peer):
    """Half of what a camera sees across and down, at the distance 1 if it is a perspective one."""
    if camera["type"] not in ("perspective", "orthographic"):
        raise Unsupported(f"a {camera['type']} camera is not converted for {peer}")
    for key, what in (("frame_center", "a shifted lens"), ("aperture", "aperture blades"),
                      ("lens_system", "a lens system")):
        if key in camera:
            raise Unsupported(f"a camera with {what} is not converted for {peer}")
    kind = "half_" if camera["type"] == "orthographic" else "tan_half_"
    half = (camera[kind + "width"], camera[kind + "height"])
    aspect = resolution[0] / resolution[1]
    if abs(half[0] / half[1] - aspect) > 1e-4 * aspect:
        raise Unsupported(f"a camera with oblong pixels is not converted for {peer}")
    return half


def read_ply(path):
    """A mesh of the exchange form."""
    data = Path(path).read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode("ascii")
    counts = {words[1]: int(words[2]) for words in map(str.split, header.splitlines())
              if words[0] == "element"}
    names = [line.split()[2] for line in header.splitlines() if line.startswith("property float")]
    numbers = array("f", data[end:end + 4 * len(names) * counts["vertex"]])
    triangles = array("I")
    for face in struct.iter_unpack("<BIII", data[end + 4 * len(numbers):]):
        triangles.extend(face[1:])
    return Mesh(columns(numbers, names, "xyz"), triangles, columns(numbers, names, ("nx", "ny", "nz")),
                columns(numbers, names, "uv"))


def has_normals(path):
    with open(path, "rb") as file:
        return any(line == b"property float nx\n" for line in iter(file.readline, b"end_header\n"))


def columns(numbers, names, wanted):
    """Those of the named columns, in a row; empty where there is none of them."""
    if wanted[0] not in names:
        return array("f")
    result = array("f", bytes(4 * len(wanted) * (len(numbers) // len(names))))
    for k, name in enumerate(wanted):
        result[k::len(wanted)] = numbers[names.index(name)::len(names)]
    return result


def rectangle(mesh):
    """The rectangle that a mesh of two triangles is; None where it is something else."""
    if len(mesh.triangles) != 6:
        return None
    corners = [mesh.position(vertex) for vertex in mesh.triangles]
    for turn in range(3):
        a, b, c = (corners[(turn + k) % 3] for k in range(3))
        size = max(map(abs, subtract(c, b)))
        if abs(dot(subtract(b, a), subtract(c, a))) > 1e-5 * size * size:
            continue
        d = tuple(x + y - z for x, y, z in zip(b, c, a))
        if all(any(max(map(abs, subtract(p, q))) < 1e-5 * size for q in corners[3:]) for p in (b, c, d)):
            center = scaled(tuple(x + y for x, y in zip(b, c)), 0.5)
            return Rectangle(center, scaled(subtract(b, a), 0.5), scaled(subtract(c, a), 0.5))
    return None
