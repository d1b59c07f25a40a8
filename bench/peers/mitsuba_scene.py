# SPDX-License-Identifier: Apache-2.0
"""A scene in exchange form as a dictionary of Mitsuba 3, with plain values: a transform is four rows.

mitsuba_render.py gives it to Mitsuba. Our depth m is Mitsuba's max_depth m + 1, for it counts the light's
vertex, too.
"""
import exr
from exchange import (Unsupported, columns_as_rows, cross, half_size, has_inverse_square_law, has_normals,
                      light_of, read_ply, rectangle, refuse_holes, refuse_picture, scaled, textures_of, unit)

NO_ROULETTE = 1 << 20  # Mitsuba's roulette begins at a depth that no path has
DEFAULT_ROULETTE = 5
COLORS = ("reflectance", "transmittance", "eta", "k")
SMOOTH = 1e-3  # alpha below which a surface is a smooth one, as here and in pbrt


def rgb(values):
    return {"type": "rgb", "value": list(values)}


def uv_transform(rows, scale=1):
    """A map of texture coordinates, and behind it a factor."""
    (a, b, c), (d, e, f) = rows
    return [[scale * a, scale * b, 0, scale * c], [scale * d, scale * e, 0, scale * f], [0, 0, 1, 0],
            [0, 0, 0, 1]]


def texture(ours, scene):
    kind = ours["type"]
    if kind == "constant":
        return rgb(ours["value"])
    if kind == "image" and ours["wrap"] in ("repeat", "clamp"):  # Mitsuba's v runs downwards in a picture
        (a, b, c), (d, e, f) = ours["uv"]
        return {"type": "bitmap", "filename": ours["file"], "raw": True, "wrap_mode": ours["wrap"],
                "filter_type": "nearest" if ours["filter"] == "nearest" else "bilinear",
                "to_uv": uv_transform([[a, b, c], [-d, -e, 1 - f]])}
    if kind == "checkerboard":  # Mitsuba's squares have the side 1/2
        return {"type": "checkerboard", "to_uv": uv_transform(ours["uv"], 0.5),
                "color0": texture(scene["textures"][ours["first"]], scene),
                "color1": texture(scene["textures"][ours["second"]], scene)}
    raise Unsupported(f"the texture \"{ours['name']}\" of the type {kind} is not converted for Mitsuba")


def with_textures(ours, scene):
    """The material, its colours as Mitsuba has them: texture() of those that textures give."""
    given = textures_of(ours, scene, "Mitsuba")
    for name, entry in given.items():
        if name not in COLORS:
            raise Unsupported(f"the texture of {name} of \"{ours['name']}\" is not converted for Mitsuba")
    colors = {name: texture(given[name], scene) if name in given else rgb(ours[name])
              for name in COLORS if name in ours}
    return {**ours, **colors}


def camera(scene, samples, sampler, seed):
    ours = scene["camera"]
    width, height = scene["resolution"]
    orthographic = ours["type"] == "orthographic"
    half_width = half_size(ours, (width, height), "Mitsuba")[0]
    size = half_width if orthographic else 1
    sensor = {"to_world": columns_as_rows(scaled(ours["right"], -size),  # Mitsuba's x axis points to the left
                                          scaled(ours["up"], size), ours["forward"], ours["position"]),
              "near_clip": max(ours["clip_near"], 1e-3), "far_clip": ours.get("clip_far", 1e4),
              "sampler": {"type": sampler, "sample_count": samples, "seed": seed},
              "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "rgb",
                       "component_format": "float32", "rfilter": {"type": "box"}}}
    if orthographic:
        return {"type": "orthographic", **sensor}
    sensor["tan_half_width"] = half_width
    if ours["lens_radius"] > 0:
        return {"type": "thinlens", "aperture_radius": ours["lens_radius"],
                "focus_distance": ours["focal_distance"], **sensor}
    return {"type": "perspective", **sensor}


def facets(alpha):
    return {"distribution": "ggx", "alpha_u": alpha[0], "alpha_v": alpha[1]}


def dielectric(ours):
    values = {"int_ior": ours["ior"], "ext_ior": 1.0, "specular_reflectance": ours["reflectance"],
              "specular_transmittance": ours["transmittance"]}
    if ours["type"] == "thin_dielectric":
        return {"type": "thindielectric", **values}
    alpha = ours.get("alpha", [0, 0])  # CS184's glass has none
    if max(alpha) < SMOOTH:
        return {"type": "dielectric", **values}
    return {"type": "roughdielectric", **values, **facets(alpha)}


def conductor(ours):
    values = {"eta": ours["eta"], "k": ours["k"], "specular_reflectance": ours["reflectance"]}
    if max(ours["alpha"]) < SMOOTH:
        return {"type": "conductor", **values}
    return {"type": "roughconductor", **values, **facets(ours["alpha"])}


def coated_diffuse(ours):
    values = {"int_ior": ours["ior"], "ext_ior": 1.0, "diffuse_reflectance": ours["reflectance"],
              "nonlinear": True}
    alpha = ours["alpha"]
    if max(alpha) < SMOOTH:
        return {"type": "plastic", **values}
    if alpha[0] != alpha[1]:
        raise Unsupported(f"Mitsuba's coats are isotropic: \"{ours['name']}\"")
    return {"type": "roughplastic", "distribution": "ggx", "alpha": alpha[0], **values}


def material(entry, scene):
    ours = with_textures(entry, scene)
    kind = ours["type"]
    if kind == "lambert":
        return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": ours["reflectance"]}}
    if kind == "mirror":
        return {"type": "twosided", "bsdf": {"type": "conductor", "material": "none",
                                             "specular_reflectance": ours["reflectance"]}}
    if kind in ("glass", "dielectric", "thin_dielectric"):
        return dielectric(ours)
    if kind == "microfacet":
        return {"type": "twosided", "bsdf": {"type": "roughconductor", "distribution": ours["distribution"],
                                             "alpha": ours["alpha"], "eta": ours["eta"],
                                             "k": ours["k"]}}
    if kind == "conductor":
        return {"type": "twosided", "bsdf": conductor(ours)}
    if kind == "coated_diffuse":
        return {"type": "twosided", "bsdf": coated_diffuse(ours)}
    raise Unsupported(f"Mitsuba has no material like \"{ours['name']}\", which is of the type {kind}")


def mesh(shape, light):
    """A mesh; where it emits and is a rectangle, Mitsuba's rectangle."""
    if light is None:  # without normals of the file Mitsuba would make smooth ones
        return {"type": "ply", "filename": shape["file"], "face_normals": not has_normals(shape["file"])}
    if light["side"] == "both":
        raise Unsupported(f"Mitsuba's light \"{light['name']}\" would emit on one side only")
    found = rectangle(read_ply(shape["file"]))
    flip = light["side"] == "back"
    if found is None:
        return {"type": "ply", "filename": shape["file"], "face_normals": True, "flip_normals": flip}
    u = scaled(found.u, -1) if flip else found.u
    return {"type": "rectangle",
            "to_world": columns_as_rows(u, found.v, unit(cross(u, found.v)), found.center)}


def spheres(shape):
    for x, y, z, radius in shape["spheres"]:
        yield {"type": "sphere", "center": [x, y, z], "radius": radius}


def emitter(light):
    """A light that is no shape."""
    kind = light["type"]
    if kind == "point" and has_inverse_square_law(light):
        return {"type": "point", "position": light["position"], "intensity": rgb(light["intensity"])}
    if kind == "directional":
        return {"type": "directional", "direction": light["direction"],
                "irradiance": rgb(light["irradiance"])}
    if kind == "environment":
        return environment(light)
    raise Unsupported(f"Mitsuba has no light like \"{light['name']}\", which is of the type {kind}")


def environment(light):
    """Mitsuba's map looks along -z where ours looks along +x. Of a single pixel it makes no map."""
    axes, scale = light["rotation"], light["scale"]
    if light["file"].endswith(".exr") and exr.size(light["file"]) == (1, 1):
        return {"type": "constant",
                "radiance": rgb(x * factor for x, factor in zip(exr.read(light["file"]).pixels, scale))}
    if light["layout"] != "latitude-longitude" or len(set(scale)) > 1:
        raise Unsupported("Mitsuba has no equal-area environment and no coloured scale: "
                          f"\"{light['name']}\"")
    return {"type": "envmap", "filename": light["file"], "scale": scale[0],
            "to_world": columns_as_rows(axes["z"], axes["y"], axes["x"], [0, 0, 0])}


def shapes(scene):
    """Each of them, behind the number of the prototype that it belongs to, or None."""
    for shape in scene["shapes"]:
        light = light_of(scene, shape)
        refuse_holes(shape, "Mitsuba")
        refuse_picture(light, "Mitsuba")
        for entry in [mesh(shape, light)] if shape["type"] == "mesh" else spheres(shape):
            entry["bsdf"] = material(scene["materials"][shape["material"]], scene)
            if light is not None:
                entry["emitter"] = {"type": "area", "radiance": rgb(light["radiance"])}
            yield shape.get("prototype"), entry


def instance(ours):
    return {"type": "instance", "to_world": [*ours["to_world"], [0, 0, 0, 1]],
            "group": {"type": "ref", "id": f"prototype_{ours['prototype']}"}}


def mitsuba_scene(scene, samples, depth, sampler="independent", seed=0, roulette=False):
    """The dictionary of mitsuba.load_dict, but for transforms and the camera's field of view."""
    result = {"type": "scene",
              "integrator": {"type": "path", "max_depth": depth + 1,
                             "rr_depth": DEFAULT_ROULETTE if roulette else NO_ROULETTE},
              "sensor": camera(scene, samples, sampler, seed)}
    for number, (prototype, entry) in enumerate(shapes(scene)):
        place = result
        if prototype is not None:
            place = result.setdefault(f"prototype_{prototype}", {"type": "shapegroup"})
        place[f"shape_{number}"] = entry
    for number, ours in enumerate(scene.get("instances", [])):
        result[f"instance_{number}"] = instance(ours)
    free = [light for light in scene["lights"] if light["type"] not in ("mesh", "sphere")]
    for number, light in enumerate(free):
        result[f"light_{number}"] = emitter(light)
    return result
