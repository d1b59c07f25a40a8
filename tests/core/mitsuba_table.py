#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints tests/core/mitsuba_table.h: values and densities of Mitsuba's BSDFs (pip install mitsuba==3.9.1)."""
import math

import mitsuba as mi

mi.set_variant("scalar_rgb")

VIEWERS = [(10, 20), (50, 20), (75, 200)]
REFLECTED = [(10, 200), (35, 60), (50, 200), (70, 215), (75, 20)]
REFRACTED = [(175, 200), (150, 200), (120, 190)]


def rgb(*value):
    return {"type": "rgb", "value": list(value)}


def direction(angles):
    theta, phi = map(math.radians, angles)
    return mi.Vector3f(math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))


def row(parameters, bsdf, viewer, light):
    """Mitsuba's value holds the cosine; ours does not."""
    at = mi.SurfaceInteraction3f()
    at.wi, at.t, at.n, at.sh_frame = direction(viewer), 1, [0, 0, 1], mi.Frame3f([0, 0, 1])
    wi = direction(light)
    value = [x / abs(wi.z) for x in bsdf.eval(mi.BSDFContext(), at, wi)]
    density = bsdf.pdf(mi.BSDFContext(), at, wi)
    numbers = [*parameters, *viewer, *light]
    return (f"    {{{', '.join(f'{x:g}' for x in numbers)}, {{{', '.join(f'{x:.6g}' for x in value)}}}, "
            f"{density:.6g}}},")


def table(name, comment, rows, kind="Reference"):
    print(f"\n/// {comment}\ninline constexpr {kind} {name}[] = {{")
    print("\n".join(rows) + "\n};")


def conductors():
    for x, y in ((0.1, 0.1), (0.3, 0.3), (0.15, 0.4)):
        bsdf = mi.load_dict({"type": "roughconductor", "distribution": "ggx", "sample_visible": True,
                             "alpha_u": x, "alpha_v": y, "eta": rgb(0.2, 0.92, 1.1),
                             "k": rgb(3.9, 2.45, 2.14)})
        yield from (row((x, y, 1), bsdf, o, i) for o in VIEWERS for i in REFLECTED)


def dielectrics():
    for alpha in (0.15, 0.5):
        for inside, outside in ((1.5, 1.0), (1.0, 1.5)):
            bsdf = mi.load_dict({"type": "roughdielectric", "distribution": "ggx", "sample_visible": True,
                                 "alpha": alpha, "int_ior": inside, "ext_ior": outside})
            yield from (row((alpha, alpha, inside / outside), bsdf, o, i)
                        for o in VIEWERS[:2] for i in REFLECTED + REFRACTED)


def plastics():
    for ior in (1.3, 1.5, 2.0):
        bsdf = mi.load_dict({"type": "plastic", "int_ior": ior, "ext_ior": 1.0, "nonlinear": True,
                             "diffuse_reflectance": rgb(0.2, 0.5, 0.8)})
        yield from (row((0, 0, ior), bsdf, o, i) for o in VIEWERS for i in REFLECTED[:3])


def rough_plastics():
    for alpha in (0.1, 0.3):
        bsdf = mi.load_dict({"type": "roughplastic", "distribution": "ggx", "alpha": alpha, "int_ior": 1.5,
                             "ext_ior": 1.0, "nonlinear": True, "diffuse_reflectance": rgb(0.2, 0.5, 0.8)})
        yield from (row((alpha, alpha, 1.5), bsdf, o, i) for o in VIEWERS for i in REFLECTED)


def smooth():
    """Where light goes that is sampled last, and how likely it is that it is reflected."""
    kinds = (("thindielectric", 1.5, 1.0), ("dielectric", 1.5, 1.0), ("dielectric", 1.0, 1.5))
    for kind, inside, outside in kinds:
        bsdf = mi.load_dict({"type": kind, "int_ior": inside, "ext_ior": outside})
        for theta in (10, 50, 75):
            at = mi.SurfaceInteraction3f()
            at.wi, at.t, at.n, at.sh_frame = direction((theta, 0)), 1, [0, 0, 1], mi.Frame3f([0, 0, 1])
            first, _ = bsdf.sample(mi.BSDFContext(), at, 0.0, [0.5, 0.5])
            last, weight = bsdf.sample(mi.BSDFContext(), at, 0.999, [0.5, 0.5])
            thin = str(kind == "thindielectric").lower()
            yield (f"    {{{thin}, {inside / outside:.7g}, {theta}, {first.pdf:.6g}, "
                   f"{{{last.wo.x:.6g}, 0, {last.wo.z:.6g}}}, {weight[0]:.6g}}},")


print(f"""// SPDX-License-Identifier: Apache-2.0
// By tests/core/mitsuba_table.py: BSDFs of Mitsuba {mi.__version__}, variant scalar_rgb, without the cosine.
// clang-format off
#pragma once
#include "core/rgb.h"
#include "core/vec.h"

namespace twinray::test {{

/// Angles in degrees: of the viewer to the normal, its azimuth, and those of the light.
struct Reference {{
  float alpha_x, alpha_y, eta, theta_o, phi_o, theta_i, phi_i;
  Rgb value;
  float pdf;
}};

/// A viewer at an angle with azimuth 0: the probability of reflection, and the last draw's direction and its
/// light's factor.
struct SmoothReference {{
  bool is_thin;
  float eta, theta_o, reflection;
  Vec3 wi;
  float factor;
}};""")
table("conductors", "roughconductor, ggx, sample_visible; eta 0.2 0.92 1.1, k 3.9 2.45 2.14.", conductors())
table("dielectrics", "roughdielectric, ggx, sample_visible; eta = int_ior / ext_ior.", dielectrics())
table("plastics", "plastic, nonlinear; diffuse_reflectance 0.2 0.5 0.8; without its mirror.", plastics())
table("rough_plastics", "roughplastic, ggx, nonlinear; diffuse_reflectance 0.2 0.5 0.8.", rough_plastics())
table("smooth", "thindielectric and dielectric.", smooth(), "SmoothReference")
print("\n}  // namespace twinray::test")
