# SPDX-License-Identifier: Apache-2.0
"""Defects of instances: their boxes, their rays, their trees, their points."""
from mutant import Mutant

ACCEL, CORE, IO = "test_accel", "test_core", "test_io"
KINDS = "engines agree on instances of each kind"
ALL_KINDS = "engines agree on instances of all kinds at once, with and without shapes beside them"
COPIES = "instances are hit where copies of their shapes are"
NESTED = "engines agree on instances that lie in each other, where the lowest instance wins"
HOLES = "engines agree on instances with holes, whose chances differ by instance"
FAR = "rays from far away miss no instance"
ENDS = "a hit in an instance ends the search behind it, there and in other instances"
FAULT = "a tree over instances has no fault, and counts what a query does in them"
AGAIN = "a ray that leaves an instance does not find its triangle again"
LENGTHS = "directions of any length and invalid rays, in a scene with instances"
POINT = "a point of an instance is that of a copy: normals, tangents, texture coordinates and footprint"
BALL = "a sphere of an instance is an ellipsoid whose normals point outward, mirrored or not"

MUTANTS = [
    Mutant("an instance's box is not widened", "core/instance.cpp",
           "constexpr double instance_margin = 0x1p-18;", "constexpr double instance_margin = 0;",
           ACCEL, FAR),
    Mutant("rays from far away see boxes as others do", "accel/canonical/instance_ray.h",
           "  if (max_abs(checked.origin) > placed.reach()) widen_slabs(checked, placed.far_margin());\n", "",
           ACCEL, "rays from beyond a scene with instances see its boxes widened by their distance"),
    Mutant("an instance's far end is not clipped", "accel/canonical/instance_ray.h",
           "own.t_max = interval.far < t_max ? interval.far : t_max;", "own.t_max = t_max;",
           ACCEL, "an instance's ray is clipped to its box"),
    Mutant("an instance's ray begins before its box", "accel/canonical/instance_ray.h",
           "own.t_min = interval.near > world.t_min ? interval.near : world.t_min;",
           "own.t_min = world.t_min;",
           ACCEL, "an instance's ray is clipped to its box"),
    Mutant("the translation is left out of an instance's ray", "accel/canonical/instance_ray.h",
           " + m[row][3]);", ");",
           ACCEL, COPIES),
    Mutant("directions are not scaled where there are instances", "accel/canonical/instance_ray.h",
           "if (exponent < one - range || exponent > one + range) return {given, 1};", "return {given, 1};",
           ACCEL, "in a scene with instances a ray's direction is scaled"),
    Mutant("t is not scaled back where there are instances", "accel/canonical/instance_ray.h",
           "if (power != 1) checked.t_scale = 1 / power;", "",
           ACCEL, LENGTHS),
    Mutant("the binary tree forgets the best hit within an instance", "accel/bvh/traversal.h",
           "      own_t_max = std::min(own_t_max, t_max);\n", "",
           ACCEL, ENDS),
    Mutant("a tie of instances goes to the later one, in batches", "accel/wide/instanced-inl.h",
           "if (const Hit hit = nearest_.hit(rays_[space_]); precedes(hit, best_)) best_ = hit;",
           "if (const Hit hit = nearest_.hit(rays_[space_]); hit.t <= best_.t) best_ = hit;",
           ACCEL, NESTED),
    Mutant("a tie of instances goes to the later one, ray by ray", "accel/wide/kernel.cpp",
           "if (const Hit hit = nearest.hit(own); precedes(hit, best)) best = hit;",
           "if (const Hit hit = nearest.hit(own); hit.t <= best.t) best = hit;",
           ACCEL, NESTED),
    Mutant("shapes in the scene lose to instances, ray by ray", "accel/wide/kernel.cpp",
           "if (const Hit direct = best.hit(ray); precedes(direct, hit)) hit = direct;",
           "if (const Hit direct = best.hit(ray); hit.is_miss()) hit = direct;",
           ACCEL, ALL_KINDS),
    Mutant("t_max is that of the instance when a batch's ray leaves it", "accel/wide/instanced-inl.h",
           "t_max_ = std::min(rays_[0].t_max, best_.t);", "t_max_ = std::min(t_max_, best_.t);",
           ACCEL, ALL_KINDS),
    Mutant("an instance's number is lost in a batch", "accel/wide/instanced-inl.h",
           "InstanceRayLoader::enter(placed, next_.index(), rays_[0], t_max_,",
           "InstanceRayLoader::enter(placed, 0, rays_[0], t_max_,",
           ACCEL, KINDS),
    Mutant("trees that are put together keep their numbers of blocks", "accel/wide/build.cpp",
           "WideRef::block(blocks + ref.index())", "WideRef::block(ref.index())",
           ACCEL, FAULT),
    Mutant("Embree's hit of an instance does not shorten its ray", "accel/embree/embree.cpp",
           "  if (!precedes(hit, query.best_of_instances)) return;\n", "",
           ACCEL, NESTED),
    Mutant("the chance of a cut-out knows no instance", "core/alpha_test.cpp",
           "if (hit.instance != no_instance) hash", "if (false) hash",
           ACCEL, HOLES),
    Mutant("an instance's offset is that of its prototype", "core/surface.cpp",
           "  point.offset = stretch * point.offset + 0.5f * ten_roundings * max_abs(point.position);\n", "",
           ACCEL, AGAIN),
    Mutant("normals turn where a transform mirrors", "core/transform.cpp",
           "(determinant() < 0 ? -1 : 1) / std::sqrt(squared)", "1 / std::sqrt(squared)",
           CORE, BALL),
    Mutant("a footprint knows nothing of the instance's size", "core/ray_cone.cpp",
           "return own / float(std::sqrt(area));", "return own;",
           CORE, POINT),
    Mutant("tangents stay in the prototype's space", "core/tangents.cpp",
           "usable({to_world->vector(own->du), to_world->vector(own->dv)})", "own",
           CORE, POINT),
    Mutant("an inverse is not refined", "core/transform.cpp",
           "step < 2; ++step", "step < 0; ++step",
           CORE, "an inverse undoes its transform, of needles and plates, too"),
    Mutant("a flat transform is an instance's", "core/instance.cpp",
           "matrix.squash > max_instance_squash)", "false)",
           CORE, "transforms that instances cannot have are refused, and the instance is named"),
    Mutant("what emits in an object is stored once", "io/pbrt_builder.cpp",
           "if (!alone || emits(part)) place", "if (!alone) place",
           IO, "an object that is shown often is stored once, but for what emits"),
    Mutant("instances of one object share another's prototype", "io/pbrt_builder.cpp",
           "prototype.first += std::uint32_t(direct);", "prototype.first += 0;",
           IO, "an object that is shown often is stored once, but for what emits"),
]
