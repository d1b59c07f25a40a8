# SPDX-License-Identifier: Apache-2.0
"""Defects in what convert writes of lights, cameras and pictures that other formats do not have so."""
from mutant import Mutant

LIGHTS = "written pbrt: a projection keeps its frame's sides, lost goniometric colors are named"
PANORAMAS = "written pbrt: a part of a panorama is named, and very narrow and wide views come back"
SPHERES = "written pbrt: spheres have pbrt's directions of facets, and those without a radius are left out"
TURNED = "written pbrt: a surface with an inside whose back emits is named"
CLIPPED = "written gltf: a camera with one clip distance gets another that lies on its other side"
VERTICES = "written gltf: what vertices have stays theirs through exchange form, other pictures do not"
EMITTED = "a picture that a mesh emits lies as its keys say, each of which may be left out"

MUTANTS = [
    Mutant("an interface may emit", "core/scene.cpp",
           "std::holds_alternative<Interface>(scene.materials[binding.material].model))", "false)", "test_io",
           "what is wrong in an exchange form is said with its entry and what would be valid"),
    Mutant("a projection has the sides of its picture", "io/pbrt/writer_light.cpp",
           "if (std::fabs(ratio * height / width - 1) < tolerance) return light.picture;",
           "return light.picture;", "test_io", LIGHTS),
    Mutant("a projection's picture is drawn anew upside down", "io/pbrt/writer_light.cpp",
           "(y + 0.5) / image.height}", "1 - (y + 0.5) / image.height}", "test_io", LIGHTS),
    Mutant("a small picture of a projection stays coarse", "io/pbrt/writer_light.cpp",
           "std::max(1.0, least / std::max(width, height))", "1.0", "test_io", LIGHTS),
    Mutant("goniometric colors are lost without a word", "io/pbrt/writer_light.cpp",
           "if (!std::all_of(light.map->pixels.begin(), light.map->pixels.end(), is_grey))", "if (false)",
           "test_io", LIGHTS),
    Mutant("parts of panoramas are written as all of them without a word", "io/pbrt/writer_camera.cpp",
           "if (is_sphere && is_partial(camera))", "if (false)", "test_io", PANORAMAS),
    Mutant("whole panoramas count as parts", "io/pbrt/writer_camera.cpp",
           "if (is_sphere && is_partial(camera))", "if (is_sphere)", "test_io",
           "written pbrt: each camera that pbrt has sees the same"),
    Mutant("a narrow view is written by its angle", "io/pbrt/writer_camera.cpp",
           "degrees >= 0.01 && degrees <= 179", "degrees <= 179", "test_io", PANORAMAS),
    Mutant("a wide view is written by its angle", "io/pbrt/writer_camera.cpp",
           "degrees >= 0.01 && degrees <= 179", "degrees >= 0.01", "test_io", PANORAMAS),
    Mutant("spheres without a radius are written for pbrt", "io/pbrt/writer.cpp",
           "if (!(sphere.radius > 0)) return;", "", "test_io", SPHERES),
    Mutant("facets of spheres lie otherwise in pbrt without a word", "io/pbrt/writer.cpp",
           "if (is_anisotropic(scene_.materials[binding.material]))", "if (false)", "test_io", SPHERES),
    Mutant("facets of spheres lie otherwise in glTF without a word", "io/gltf/writer.cpp",
           "if (is_anisotropic(scene_.materials[binding.material]))", "if (false)", "test_io", SPHERES),
    Mutant("an emitter is turned inside out without a word", "io/turned_emitter.cpp",
           "if (light.side != EmissionSide::back || !has_inside", "if (has_inside", "test_io", TURNED),
    Mutant("matte surfaces have an inside", "io/turned_emitter.cpp",
           "light.side != EmissionSide::back || !has_inside",
           "light.side != EmissionSide::back || has_inside", "test_io",
           "written pbrt: emitters come back with their side, radiance and picture"),
    Mutant("glTF's znear goes by the scene alone", "io/gltf/writer_view.cpp",
           "near_part * std::min(reach, camera.clip_far)", "near_part * reach", "test_io", CLIPPED),
    Mutant("glTF's zfar goes by the scene alone", "io/gltf/writer_view.cpp",
           "far_part * std::max(reach, camera.clip_near)", "far_part * reach", "test_io", CLIPPED),
    Mutant("glTF's frames are as narrow as they are", "io/gltf/writer_view.cpp",
           "limit_frame(camera, file.output.losses);", "", "test_io",
           "written gltf: frames that readers refuse are others, and are named"),
    Mutant("glTF's frames are as long as they are", "io/gltf/writer_view.cpp",
           "height * std::clamp(ratio, 1 / longest, longest)", "height * ratio", "test_io",
           "written gltf: frames that readers refuse are others, and are named"),
    Mutant("glTF emits what readers refuse", "io/gltf/writer_material.cpp",
           "most > most_radiance)", "false)", "test_io",
           "written gltf: what emits more than readers take emits as much as they do, in its color"),
    Mutant("the exchange form forgets which pictures are of vertices", "io/exchange/writer.cpp",
           "if (std::get<ImageTexture>(texture.model).of_vertices)", "if (false)", "test_io", VERTICES),
    Mutant("all pictures of an exchange form are of vertices", "io/exchange/texture.cpp",
           """entry.has("of_vertices") && entry.flag("of_vertices")""", "true", "test_io", VERTICES),
    Mutant("a lamp's filter is read beside its uv alone", "io/exchange/members.h",
           """  visit.later("filter", light.filter);
  visit.later("uv", light.uv);""",
           """  visit.later("uv", light.uv);""", "test_io", EMITTED),
    Mutant("a lamp's wrap is read beside its uv alone", "io/exchange/members.h",
           """visit.later("wrap", light.wrap);
  visit.later""", "visit.later", "test_io", EMITTED),
]
