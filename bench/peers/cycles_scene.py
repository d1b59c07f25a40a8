# SPDX-License-Identifier: Apache-2.0
"""A scene in exchange form in Blender's words, with plain values, of which cycles_render.py makes objects.

A rectangle that emits becomes an area lamp, which no camera ray sees. Such a lamp blocks no rays, so a black
rectangle stands just behind it. Our depth m is Cycles' m - 1 bounces behind the first surface.
"""
import math

from exchange import (Unsupported, columns_as_rows, cross, dot, half_size, has_inverse_square_law, light_of,
                      read_ply, rectangle, refuse_holes, refuse_picture, scaled, subtract, unit)

BEHIND = 1e-4  # the distance of the black rectangle, of the lamp's half width
RINGS = 128    # of a sphere's mesh, each of twice as many faces


def camera(ours, resolution):
    half_width = half_size(ours, resolution, "Cycles")[0]
    if ours["lens_radius"] > 0:
        raise Unsupported("a camera with a lens is not converted for Cycles")
    result = {"matrix": columns_as_rows(ours["right"], ours["up"], scaled(ours["forward"], -1),
                                        ours["position"]),
              "clip_start": max(ours["clip_near"], 1e-4), "clip_end": ours.get("clip_far", 1e5)}
    if ours["type"] == "orthographic":
        return {**result, "type": "ORTHO", "ortho_scale": 2 * half_width}
    return {**result, "type": "PERSP", "angle_x": 2 * math.atan(half_width)}


def shader(node, color, **inputs):
    return {"node": node, "inputs": {"Color": [*color, 1], **inputs}}


def material(ours):
    kind = ours["type"]
    if kind == "lambert":
        return shader("ShaderNodeBsdfDiffuse", ours["reflectance"], Roughness=0)
    if kind == "mirror":
        return shader("ShaderNodeBsdfAnisotropic", ours["reflectance"], Roughness=0)
    if kind == "glass" and ours["reflectance"] == ours["transmittance"]:
        return shader("ShaderNodeBsdfGlass", ours["reflectance"], Roughness=0, IOR=ours["ior"])
    raise Unsupported(f"the material \"{ours['name']}\" of the type {kind} is not converted for Cycles")


def emission(light):
    return shader("ShaderNodeEmission", light["radiance"], Strength=1)


def area_lamp(found, radiance, flip):
    """The lamp, which emits along its -z axis. Its power is left to area_lamp_power()."""
    u = scaled(found.u, -1) if flip else found.u
    normal = unit(cross(u, found.v))
    half_width, half_height = (math.sqrt(dot(side, side)) for side in (u, found.v))
    area = 4 * half_width * half_height
    return {"matrix": columns_as_rows(scaled(unit(u), -1), unit(found.v), scaled(normal, -1), found.center),
            "size": 2 * half_width, "size_y": 2 * half_height,
            "area": area, "peak": max(radiance), "color": [x / max(radiance) for x in radiance],
            "behind": [-BEHIND * half_width * x for x in normal]}


def area_lamp_power(lamp, version):
    """Blender's power of a lamp of this radiance; measured: 3.4 and 5.0 differ."""
    return (4 if version < (4, 0) else math.pi) * lamp["area"] * lamp["peak"]


def point_lamp(light):
    """A point of Blender's power P has the radiant intensity P / (4 pi); measured: 5.0."""
    if not has_inverse_square_law(light):
        raise Unsupported(f"Cycles has only the inverse square law, unlike the light \"{light['name']}\"")
    peak = max(light["intensity"])
    return {"position": light["position"], "energy": 4 * math.pi * peak,
            "color": [x / peak for x in light["intensity"]]}


def faces_along_normals(mesh):
    """The mesh's triangles, turned round where they face away from their normals: Cycles shows such black."""
    faces = [tuple(mesh.triangles[i:i + 3]) for i in range(0, len(mesh.triangles), 3)]
    if not mesh.normals:
        return faces

    def is_turned(face):
        a, b, c = map(mesh.position, face)
        front = cross(subtract(b, a), subtract(c, a))
        return sum(dot(front, mesh.normals[3 * vertex:3 * vertex + 3]) for vertex in face) < 0
    return [face[::-1] if is_turned(face) else face for face in faces]


def sphere_mesh(center, radius):
    """A sphere's vertices and faces (of three or four vertices), from pole to pole."""
    columns = 2 * RINGS
    rings = [[(math.sin(math.pi * i / RINGS) * math.cos(2 * math.pi * j / columns),
               math.sin(math.pi * i / RINGS) * math.sin(2 * math.pi * j / columns),
               math.cos(math.pi * i / RINGS)) for j in range(columns)] for i in range(1, RINGS)]
    units = [(0, 0, 1), *(point for ring in rings for point in ring), (0, 0, -1)]
    last = len(units) - 1
    faces = []
    for j in range(columns):
        k = (j + 1) % columns
        faces.append((0, 1 + j, 1 + k))
        for i in range(RINGS - 2):
            a, b = 1 + i * columns, 1 + (i + 1) * columns
            faces.append((a + j, b + j, b + k, a + k))
        faces.append((last, last - columns + k, last - columns + j))
    return [tuple(c + radius * x for c, x in zip(center, point)) for point in units], faces


def lamp_of(shape, light):
    """The area lamp that stands for an emitting mesh; None where it is no one-sided rectangle."""
    if light is None or light["type"] != "mesh" or light["side"] == "both":
        return None
    found = rectangle(read_ply(shape["file"]))
    return found and area_lamp(found, light["radiance"], light["side"] == "back")


def one_shape(shape, ours, light):
    refuse_holes(shape, "Cycles")
    refuse_picture(light, "Cycles")
    if "textures" in ours or "normal_map" in ours or "bump_map" in ours:
        raise Unsupported(f"the textures of \"{ours['name']}\" are not converted for Cycles")
    lamp = lamp_of(shape, light)
    if light is not None and lamp is None and light.get("side", "both") != "both":
        raise Unsupported(f"the light \"{light['name']}\", one side of a mesh, is not converted for Cycles")
    if light is not None and max(ours.get("reflectance", [1])) > 0:
        raise Unsupported(f"the light \"{light['name']}\" reflects, which is not converted for Cycles")
    surface = material(ours) if light is None or lamp else emission(light)
    entry = {"name": shape["name"], "material": surface, "lamp": lamp}
    if shape["type"] == "mesh":
        return {**entry, "file": shape["file"]}
    return {**entry, "spheres": shape["spheres"]}


def cycles_scene(scene, samples, depth, seed=0, roulette=False):
    if scene.get("instances"):
        raise Unsupported("instances are not converted for Cycles; --instances=copy converts copies")
    shapes, points = [], []
    for shape in scene["shapes"]:
        shapes.append(one_shape(shape, scene["materials"][shape["material"]], light_of(scene, shape)))
    for light in scene["lights"]:
        if light["type"] == "point":
            points.append(point_lamp(light))
        elif light["type"] not in ("mesh", "sphere"):
            raise Unsupported(f"the light \"{light['name']}\" ({light['type']}) is not converted for Cycles")
    bounces = max(depth - 1, 0)
    settings = {"samples": samples, "seed": seed, "max_bounces": bounces, "diffuse_bounces": bounces,
                "glossy_bounces": bounces, "transmission_bounces": bounces,
                "transparent_max_bounces": bounces, "sample_clamp_direct": 0, "sample_clamp_indirect": 0,
                "blur_glossy": 0, "use_adaptive_sampling": False, "use_denoising": False,
                "pixel_filter_type": "BOX", "use_fast_gi": False}
    if not roulette:
        settings.update(min_light_bounces=1024, min_transparent_bounces=1024, light_sampling_threshold=0)
    return {"resolution": scene["resolution"], "camera": camera(scene["camera"], scene["resolution"]),
            "shapes": shapes, "points": points, "settings": settings}
