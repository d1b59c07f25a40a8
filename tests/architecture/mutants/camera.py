# SPDX-License-Identifier: Apache-2.0
"""Defects in cameras, pixel filters."""
from mutant import Mutant

MOMENTS = "samples of a filter have its moments, also where it is negative"
SIGN = "a picture is its light under the filter, whatever its sign"
LATITUDE = "a latitude-longitude picture has the way ahead in its middle, and the poles at its edges"
SHIFTED = "a shifted frame shows what lies beside the axis of view, without a turn"

MUTANTS = [
    Mutant("a filter is not symmetric", "core/filter_sampler.cpp",
           "return u < 0.5f ? 0.5f - distance : 0.5f + distance;", "return 0.5f + distance;",
           "test_core", MOMENTS),
    Mutant("negative lobes brighten", "core/filter_sampler.cpp",
           "weight *= is_inner ? total : -total;", "weight *= total;",
           "test_core", "the weights of a filter have the mean 1, and its sign"),
    Mutant("a filter's two axes have one radius", "core/filter_sampler.cpp",
           "y_(filter, double(filter.radius.y))", "y_(filter, double(filter.radius.x))",
           "test_integrators", "samples lie around their pixel as its filter has it"),
    Mutant("weights of samples are forgotten", "integrators/render.cpp",
           "records.color()[i] * weight", "records.color()[i]", "test_integrators", SIGN),
    Mutant("pixels beside the scene stop, though their filter reaches it", "integrators/render.cpp",
           "{radius.x + 0.5f, radius.y + 0.5f}", "{1, 1}", "test_integrators",
           "a pixel beside the scene goes on where its filter reaches the scene"),
    Mutant("what lies beside a fisheye's circle has light", "integrators/wave/camera_stage.cpp",
           "ray.t_max < ray.t_min ? 0 : place.weight", "place.weight", "test_integrators",
           "nothing comes from beside a fisheye's circle, and all layers know that"),
    Mutant("waves see through round lenses alone", "integrators/wave/camera_stage.cpp",
           "lens_point(camera_, {draws.lens_x[i], draws.lens_y[i]})",
           "square_to_disc({draws.lens_x[i], draws.lens_y[i]})", "test_integrators",
           "camera rays made together have the bits of each alone"),
    Mutant("the corners of a lens get too many samples", "core/warp.cpp",
           "outward = std::sqrt(u.y)", "outward = u.y",
           "test_core", "points of a polygon are uniform by area within its corners"),
    Mutant("a lens's blades are not turned", "core/warp.cpp",
           "turns + float(i) / float(corners)", "float(i) / float(corners)", "test_core",
           "the corners of a polygon lie on the unit circle, the first one as far around as is said"),
    Mutant("a frame is shifted down, not up", "core/camera.cpp",
           "camera.tan_half_height + camera.frame_center.y", "camera.tan_half_height - camera.frame_center.y",
           "test_core", SHIFTED),
    Mutant("a latitude-longitude picture is mirrored", "core/camera.cpp",
           "{latitude.cos * longitude.sin, latitude.sin, latitude.cos * longitude.cos}",
           "{0 - latitude.cos * longitude.sin, latitude.sin, latitude.cos * longitude.cos}",
           "test_core", LATITUDE),
    Mutant("a fisheye is not equidistant", "core/camera.cpp",
           "sincos_radians(angle)", "sincos_radians(0.9f * angle)",
           "test_core", "an equidistant fisheye's angle to the axis grows as the distance from the middle"),
    Mutant("an equal-area square goes on straight over its edge", "core/direction_map.cpp",
           "x = x < 0 ? -x : 2 - x, y = 1 - y;", "x = x < 0 ? -x : 2 - x;",
           "test_core", "an equal-area picture gives each pixel the same solid angle, "
           "and goes on over its edges"),
    Mutant("a shifted frame is culled as if it were not", "core/visible_pixels.cpp",
           "/ scale - camera.frame_center.x", "/ scale", "test_core",
           "samples beside their pixel see more, and shifted frames other things"),
    Mutant("a matrix forgets the shift of the frame", "io/camera_matrices.cpp",
           "0.5 - x * camera.frame_center.x", "0.5",
           "test_io", "a picture's matrices say where a point of the world lies in its frame"),
    Mutant("negative parts leave the rest to the smallest", "core/exact_parts.cpp",
           "return (a < 0 ? -a : a) < (b < 0 ? -b : b);", "return a < b;",
           "test_core", "negative parts add up as others do"),
    Mutant("pbrt's panorama is not mirrored", "io/pbrt_camera.cpp",
           "placed.right = -axes.forward;", "placed.right = axes.forward;", "test_io",
           "a spherical camera gives pbrt's picture: its first column looks to the right, then ahead"),
]
