# SPDX-License-Identifier: Apache-2.0
"""Defects of lens systems: their surfaces, their pupils, their light, and their files."""
from mutant import Mutant

POINTS = "cardinal points are those of the lensmaker's equation for thick lenses"
SHARP = "what lies in the plane in focus is sharp and what lies elsewhere is not"
AXIS = "on the axis the film gets the light of the cone that the stop leaves"
CORNERS = "light falls off towards the corners by cos to the fourth where nothing is in its way"
BOUNDS = "bounds of the pupil cut nothing off, and what lies beyond the film has none"
MOVED = "a pupil that moves with the film's point is followed, beyond the film, too"
SMALL = "a pupil is found however small its stop is"
REFUSED = "a lens that cannot be is refused with what is wrong with it"
NEAREST = "a distance at which a lens makes nothing sharp is refused with the least one"
SKY = "a white sky in the middle of the frame is as bright as the cone of light is wide"
LAYERS = "layers do not count the light that a lens leaves"
UPRIGHT = "what a lens shows is not mirrored, and sharp where its focus is"
DEPTHS = "depths behind a lens are those from the film, and what is clipped is so for all samples"
LIGHT = "a lens dims what is light and nothing else"
FILE = "a realistic camera has the lens of its file in scene units, focused"
SCALED = "a camera that is scaled has a lens that is, too, and sees the same"
STOP = "a stop is as wide as the camera says, and no wider than the file has it"
PLACES = "what a realistic camera cannot be is refused with its place"
TRIP = "a lens system comes back from our JSON with all bits and from pbrt's format nearly so"
CHANGED = "a lens or a projection replaces a lens system, and a shift moves its film"

MUTANTS = [
    Mutant("surfaces refract as if all were in air", "core/lens_system.cpp",
           "return i > 0 ? surfaces[i - 1].index() : 1;", "return 1;", "test_core",
           "the double Gauss lens has the focal length that it is known for"),
    Mutant("the way back through a lens takes the wrong thickness", "core/lens_system.cpp",
           "is_to_film ? i : i - 1", "i", "test_core", POINTS),
    Mutant("the front principal plane is told from the front", "core/lens_system.cpp",
           "back.height / back.slope - 1 / back.slope - length", "back.height / back.slope - 1 / back.slope",
           "test_core", POINTS),
    Mutant("a lens is focused as if its principal planes were one", "core/lens_system.cpp",
           "const double way = distance - between,", "const double way = distance,", "test_core", SHARP),
    Mutant("a lens is focused at the near conjugate", "core/lens_system.cpp",
           "2 * f / (1 + std::sqrt", "2 * f / (1 - std::sqrt", "test_core", SHARP),
    Mutant("a distance below four focal lengths is accepted", "core/lens_system.cpp",
           "if (!(way >= 4 * f))", "if (!(way >= f))", "test_core", NEAREST),
    Mutant("a ray meets the far side of a sphere", "core/lens_system.cpp",
           "-c / (b + std::sqrt(left))", "-c / (b - std::sqrt(left))", "test_core", SHARP),
    Mutant("flat surfaces are met where the sphere's cancels", "core/lens_system.cpp",
           "-c / (b + std::sqrt(left))", "(std::sqrt(left) - b) / curvature", "test_core",
           "a nearly flat surface is as good as a flat one, and glass that is flat refracts"),
    Mutant("rays leave a surface as they came", "core/lens_system.cpp",
           "surface.index() / front))", "1))", "test_core", SHARP),
    Mutant("the indices of a surface are swapped", "core/lens_system.cpp",
           "surface.index() / front))", "front / surface.index()))", "test_core", SHARP),
    Mutant("rims stop nothing", "core/lens_system.cpp",
           "  if (!(widest(line, 1) <= 1)) return {};", "  if (!(widest(line, 1e9) <= 1e9)) return {};",
           "test_core", AXIS),
    Mutant("the pupil's bounds are those of one film point", "core/lens_system.cpp",
           "    pupil_.back().extend(here);\n", "", "test_core", SMALL),
    Mutant("the pupil's bounds are half as high", "core/lens_system.cpp",
           "height = 2 * bounds.y1;", "height = bounds.y1;", "test_core", BOUNDS),
    Mutant("edges of a pupil are told roughly", "core/lens_system.cpp",
           "constexpr int halvings = 16;", "constexpr int halvings = 2;", "test_core", SMALL),
    Mutant("a pupil is looked for once", "core/lens_system.cpp",
           "most_looks = 8;", "most_looks = 1;", "test_core", SMALL),
    Mutant("pupils are bounded at the last surface's vertex", "core/lens_system.cpp",
           "radius > 0) {", "radius > 1e300) {", "test_core",
           "a last surface that bulges towards the scene may have its rim near the film"),
    Mutant("the pupil is not turned with the film's point", "core/lens_system.cpp",
           "from_axis > 0 ? fx / from_axis : 1", "1", "test_core", CORNERS),
    Mutant("a film point beyond the film has the bounds of its edge", "core/lens_system.cpp",
           "is_known ? pupil_[", "true ? pupil_[", "test_core", MOVED),
    Mutant("light does not fall off by the angle", "core/lens_system.cpp",
           "cosine * cosine * cosine * cosine * (width", "(width", "test_core", CORNERS),
    Mutant("the pupil's width does not count", "core/lens_system.cpp",
           "(width / plane_) *", "", "test_core", AXIS),
    Mutant("what is behind the last surface may be water", "core/lens_system.cpp",
           "last.index() != 1)", "last.index() > 5)", "test_core", REFUSED),
    Mutant("depths behind a lens count from its front", "core/camera.cpp",
           "in_world(sight.origin - sight.direction * (sight.origin.z / forward))", "in_world(sight.origin)",
           "test_integrators", DEPTHS),
    Mutant("the picture stays upside down", "core/camera.cpp",
           "{-seen.x * distance, -seen.y * distance}", "{seen.x * distance, seen.y * distance}",
           "test_integrators", UPRIGHT),
    Mutant("a sample that a lens stops has no ray", "core/camera.cpp",
           "return {camera_ray(camera, frame, {}), 0};", "return {{.t_max = -1}, 0};", "test_integrators",
           LAYERS),
    Mutant("what a lens leaves of light is forgotten", "integrators/sample_maker.cpp",
           "records.dim(i, camera_samples[i].light);", "records.dim(i, 1);", "test_integrators", SKY),
    Mutant("a lens dims layers, too", "integrators/sample_maker.cpp",
           "records.dim(i, camera_samples[i].light);", "records.weigh(i, camera_samples[i].light);",
           "test_integrators", LAYERS),
    Mutant("samples that a lens stops are skipped where layers are asked for", "integrators/sample_maker.cpp",
           "if (is_dimmed && !records.has_layers())", "if (is_dimmed)", "test_integrators", DEPTHS),
    Mutant("a lens dims normals", "integrators/normals.h",
           "bool is_of_light() const override { return false; }",
           "bool is_of_light() const override { return true; }", "test_integrators", LIGHT),
    Mutant("apertures of lens files are taken for radii", "io/pbrt/lens_file.cpp",
           "numbers[i + 3] / 2}", "numbers[i + 3]}", "test_io", FILE),
    Mutant("a stop may be wider than its file has it", "io/pbrt/lens_file.cpp",
           "std::min(surface.aperture_radius, diameter / 2)", "diameter / 2", "test_io", STOP),
    Mutant("a scaled camera keeps its focus distance", "io/pbrt/lens_file.cpp",
           "return LensSystem(std::move(surfaces), film_radius * scale);",
           "surfaces.back().thickness /= scale;\n"
           "  return LensSystem(std::move(surfaces), film_radius * scale);",
           "test_io", SCALED),
    Mutant("the rest of a lens file is left out", "io/pbrt/lens_file.cpp",
           "numbers.empty() || numbers.size() % columns != 0", "numbers.empty()", "test_io", PLACES),
    Mutant("the film's diagonal is its width", "io/pbrt/camera.cpp",
           "half_diagonal * millimeter / std::sqrt(1 + aspect * aspect)",
           "half_diagonal * millimeter / aspect", "test_io", FILE),
    Mutant("written lenses are focused at ten meters", "io/pbrt/writer_camera.cpp",
           "float(focus)", "10.0f", "test_io", TRIP),
    Mutant("written films have no diagonal", "io/pbrt/writer_camera.cpp",
           "  if (camera.lenses) text += pbrt_real(\"diagonal\"",
           "  if (false) text += pbrt_real(\"diagonal\"", "test_io", TRIP),
    Mutant("large lenses are written in their own units", "io/pbrt/writer_camera.cpp",
           "return diagonal >= least && diagonal <= most ? 1 : diagonal / usual;", "return 1;", "test_io",
           "a lens of other than usual sizes is written for a camera that is scaled"),
    Mutant("flat glass is a stop", "core/lens_system.h",
           "surfaces[i].curvature_radius == 0 && surfaces[i].index() == ior_before(surfaces, i)",
           "surfaces[i].curvature_radius == 0", "test_io",
           "a lens without a stop and flat glass are told, and so is a transform that stretches"),
    Mutant("a thin lens stands beside a lens system", "cli/camera_changes.cpp",
           "    made.lenses = nullptr;\n", "", "test_cli", CHANGED),
]
