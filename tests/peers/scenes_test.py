#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How bench/peers turns scenes in exchange form into the peers': scenes_test.py PROGRAM"""
import math
import random
import subprocess
import sys
import unittest
from array import array

from scene_folder import DOWN, GREY, ROOT, Folder, ply
import cycles_scene
import exchange
import exr
import mitsuba_scene

PROGRAM = sys.argv.pop(1)


class Exchange(Folder):
    def test_a_mesh_is_read_with_all_its_numbers(self):
        rng = random.Random(1)
        rows = [list(array("f", [rng.uniform(-9, 9) for _ in range(6)])) for _ in range(9)]
        faces = [tuple(rng.randrange(9) for _ in range(3)) for _ in range(20)]
        path = self.folder / "a.ply"
        path.write_bytes(ply([row[:3] for row in rows], faces, [row[3:] for row in rows]))
        mesh = exchange.read_ply(path)
        self.assertEqual(list(mesh.positions), [x for row in rows for x in row[:3]])
        self.assertEqual(list(mesh.normals), [x for row in rows for x in row[3:]])
        self.assertEqual(list(mesh.triangles), [i for face in faces for i in face])
        self.assertTrue(exchange.has_normals(path))

    def test_two_triangles_are_a_rectangle_whatever_their_order(self):
        for faces in ([0, 1, 2, 0, 2, 3], [2, 0, 1, 3, 0, 2], [3, 0, 1, 1, 2, 3]):
            mesh = exchange.Mesh(array("f", [x for corner in DOWN for x in corner]), array("I", faces))
            found = exchange.rectangle(mesh)
            self.assertEqual(found.center, (0, 3, 0))
            self.assertEqual(exchange.cross(found.u, found.v), (0, -2, 0))

    def test_what_is_no_rectangle_is_none(self):
        skew, hardly = ([(0, 0, 0), (1, 0, 0), (1 + x, 1, 0), (x, 1, 0)] for x in (0.5, 0.001))
        for corners, faces in ((skew, [0, 1, 2, 0, 2, 3]), (hardly, [0, 1, 2, 0, 2, 3]),
                               (DOWN, [0, 1, 2, 0, 1, 2]), (DOWN, [0, 1, 2])):
            mesh = exchange.Mesh(array("f", [x for corner in corners for x in corner]), array("I", faces))
            self.assertIsNone(exchange.rectangle(mesh))

    def test_oblong_pixels_are_those_whose_sides_differ(self):
        sizes = {"half_width": 8, "half_height": 4, "tan_half_width": 3, "tan_half_height": 2}
        for kind, good, bad in (("orthographic", (40, 20), (30, 20)), ("perspective", (30, 20), (40, 20))):
            camera = {"type": kind, **sizes}
            self.assertEqual(exchange.half_size(camera, good, "X")[0], 8 if kind == "orthographic" else 3)
            with self.assertRaisesRegex(exchange.Unsupported, "oblong pixels is not converted for X"):
                exchange.half_size(camera, bad, "X")

    def test_cameras_that_peers_have_not_are_refused(self):
        camera = {"type": "perspective", "tan_half_width": 3, "tan_half_height": 2}
        for change, text in (({"type": "fisheye"}, "a fisheye camera is not converted for X"),
                             ({"frame_center": [1, 0]}, "a camera with a shifted lens is not converted"),
                             ({"lens_system": {}}, "a camera with a lens system is not converted for X"),
                             ({"aperture": {"blades": 5, "turns": 0}}, "with aperture blades is not")):
            with self.assertRaisesRegex(exchange.Unsupported, text):
                exchange.half_size({**camera, **change}, (30, 20), "X")

    def test_another_version_is_refused(self):
        path = self.folder / "a.json"
        path.write_text('{"format": "twinray scene", "version": 5}')
        with self.assertRaisesRegex(exchange.Unsupported,
                                    "no scene in twinray's exchange form, version 1 to 4"):
            exchange.read_scene(path)

    def test_our_scenes_are_converted_for_both_peers(self):
        for name in ("box", "cornell-bunny"):
            path = self.folder / f"{name}.json"
            source = str(ROOT / "scenes" / f"{name}.dae")
            subprocess.run([PROGRAM, "convert", "-q", source, str(path)], check=True)
            scene = exchange.read_scene(path)
            for_mitsuba = mitsuba_scene.mitsuba_scene(scene, 4, 5)
            emitting = [entry["type"] for entry in for_mitsuba.values() if "emitter" in entry]
            self.assertEqual(emitting, ["rectangle"])
            for_cycles = cycles_scene.cycles_scene(scene, 4, 5)
            self.assertEqual(len(for_cycles["shapes"]), len(scene["shapes"]))
            self.assertEqual(sum(shape["lamp"] is not None for shape in for_cycles["shapes"]), 1)

    def test_instances_are_converted_for_mitsuba_and_refused_for_cycles(self):
        path = self.folder / "pawns.json"
        source = str(ROOT / "scenes" / "pawns.pbrt")
        subprocess.run([PROGRAM, "convert", "-q", "--instances=keep", source, str(path)], check=True)
        scene = exchange.read_scene(path)
        for light in scene["lights"]:  # Mitsuba would read its picture.
            light.update(type="directional", direction=[0, -1, 0], irradiance=[1, 1, 1])
        for_mitsuba = mitsuba_scene.mitsuba_scene(scene, 4, 5)
        entries = [entry for entry in for_mitsuba.values() if isinstance(entry, dict)]
        instances = [entry for entry in entries if entry["type"] == "instance"]
        self.assertEqual(len(instances), 33)
        group = for_mitsuba[instances[0]["group"]["id"]]
        self.assertEqual(group["type"], "shapegroup")
        self.assertEqual({entry["type"] for entry in group.values() if entry != "shapegroup"},
                         {"ply", "sphere"})
        self.assertEqual([row[3] for row in instances[1]["to_world"]],
                         [row[3] for row in scene["instances"][1]["to_world"]] + [1])
        with self.assertRaisesRegex(exchange.Unsupported, "--instances=copy"):
            cycles_scene.cycles_scene(scene, 4, 5)


class Mitsuba(Folder):
    def convert(self, scene, **options):
        return mitsuba_scene.mitsuba_scene(scene, 64, 5, **options)

    def test_the_camera_and_the_settings(self):
        made = self.convert(self.scene(), sampler="multijitter", seed=7)
        self.assertEqual(made["integrator"], {"type": "path", "max_depth": 6, "rr_depth": 1 << 20})
        sensor = made["sensor"]
        self.assertEqual(sensor["to_world"], [[-1, 0, 0, 0], [0, 1, 0, 1], [0, 0, -1, 5], [0, 0, 0, 1]])
        self.assertEqual((sensor["type"], sensor["tan_half_width"]), ("perspective", 0.5))
        self.assertEqual(sensor["sampler"], {"type": "multijitter", "sample_count": 64, "seed": 7})
        self.assertEqual((sensor["film"]["width"], sensor["film"]["height"]), (40, 20))
        self.assertEqual(sensor["film"]["rfilter"], {"type": "box"})
        self.assertEqual(self.convert(self.scene(), roulette=True)["integrator"]["rr_depth"], 5)

    def test_an_emitting_rectangle_faces_as_ours(self):
        for side, y in (("front", -1), ("back", 1)):
            shape = self.convert(self.lamp(side=side))["shape_0"]
            self.assertEqual(shape["type"], "rectangle")
            self.assertEqual([row[2] for row in shape["to_world"]], [0, y, 0, 0])
            self.assertEqual([row[3] for row in shape["to_world"]], [0, 3, 0, 1])
            self.assertEqual(shape["emitter"]["radiance"]["value"], [10, 5, 0])

    def test_cameras_with_a_lens_and_without_perspective(self):
        lens = self.convert(self.scene(lens_radius=0.1, focal_distance=3))["sensor"]
        self.assertEqual(lens["type"], "thinlens")
        self.assertEqual((lens["aperture_radius"], lens["focus_distance"]), (0.1, 3))
        flat = self.convert(self.scene(type="orthographic", half_width=4, half_height=2))["sensor"]
        self.assertEqual(flat["type"], "orthographic")
        self.assertEqual(flat["to_world"], [[-4, 0, 0, 0], [0, 4, 0, 1], [0, 0, -1, 5], [0, 0, 0, 1]])

    def test_an_emitting_mesh_faces_as_ours(self):
        for side, flip in (("front", False), ("back", True)):
            scene = self.lamp(side=side)
            (self.folder / "lamp.ply").write_bytes(ply(DOWN[:3], [(0, 1, 2)]))
            shape = self.convert(scene)["shape_0"]
            self.assertEqual((shape["type"], shape["flip_normals"]), ("ply", flip))

    def test_a_mesh_without_normals_is_flat(self):
        for normals in ((), [(0, 0, 1)] * 3):
            (self.folder / "a.ply").write_bytes(ply(DOWN[:3], [(0, 1, 2)], normals))
            shape = {"name": "a", "type": "mesh", "file": "a.ply", "material": 0}
            made = self.convert(self.scene([shape]))["shape_0"]
            self.assertEqual(made["face_normals"], not normals)
            self.assertEqual(made["bsdf"]["bsdf"]["reflectance"]["value"], [0.5, 0.5, 0.5])

    def test_spheres_and_their_materials(self):
        glass = {"name": "g", "type": "glass", "reflectance": [1, 1, 1], "transmittance": [0.5, 1, 1],
                 "roughness": 0, "ior": 1.25}
        shape = {"name": "a", "type": "spheres", "spheres": [[1, 2, 3, 4], [5, 6, 7, 8]], "material": 0}
        made = self.convert(self.scene([shape], materials=[glass]))
        self.assertEqual((made["shape_1"]["center"], made["shape_1"]["radius"]), ([5, 6, 7], 8))
        self.assertEqual(made["shape_0"]["bsdf"]["int_ior"], 1.25)
        self.assertEqual(made["shape_0"]["bsdf"]["specular_transmittance"]["value"], [0.5, 1, 1])

    def bsdf(self, **material):
        shape = {"name": "a", "type": "spheres", "spheres": [[1, 2, 3, 4]], "material": 0}
        made = self.convert(self.scene([shape], materials=[{"name": "m", **material}]))["shape_0"]["bsdf"]
        return made.get("bsdf", made)

    def test_rough_materials_have_their_facets(self):
        white = {"reflectance": [1, 1, 1], "transmittance": [1, 1, 1]}
        for kind, smooth, rough, values in (
                ("dielectric", "dielectric", "roughdielectric", {"ior": 1.25, **white}),
                ("thin_dielectric", "thindielectric", "thindielectric", {"ior": 1.25, **white}),
                ("conductor", "conductor", "roughconductor",
                 {"eta": [1, 2, 3], "k": [4, 5, 6], "reflectance": [1, 0.5, 0.25]}),
                ("coated_diffuse", "plastic", "roughplastic", {"ior": 1.25, "reflectance": [1, 0.5, 0.25]})):
            self.assertEqual(self.bsdf(type=kind, alpha=[0, 0], **values)["type"], smooth)
            made = self.bsdf(type=kind, alpha=[0.25, 0.25], **values)
            self.assertEqual(made["type"], rough)
            if rough != "thindielectric":
                self.assertEqual(made.get("alpha", made.get("alpha_u")), 0.25)
        metal = self.bsdf(type="conductor", eta=[1, 2, 3], k=[4, 5, 6], reflectance=[1, 0.5, 0.25],
                          alpha=[0.25, 0.5])
        self.assertEqual((metal["alpha_u"], metal["alpha_v"]), (0.25, 0.5))
        self.assertEqual((metal["eta"]["value"], metal["k"]["value"]), ([1, 2, 3], [4, 5, 6]))
        self.assertEqual(metal["specular_reflectance"]["value"], [1, 0.5, 0.25])
        with self.assertRaisesRegex(exchange.Unsupported, "coats are isotropic: \"m\""):
            self.bsdf(type="coated_diffuse", ior=1.5, reflectance=[1, 1, 1], alpha=[0.25, 0.5])
        with self.assertRaisesRegex(exchange.Unsupported, "no material like \"m\", which is of the type mix"):
            self.bsdf(type="mix", first=0, second=0, amount=0.5)

    def textured(self, textures, uses=(), **more):
        shape = {"name": "a", "type": "spheres", "spheres": [[1, 2, 3, 4]], "material": 0}
        uses = [{"input": "reflectance", "texture": 0, "meaning": "value", **use} for use in uses]
        scene = self.scene([shape], materials=[{**GREY, "textures": uses, **more}])
        return {**scene, "textures": [{"name": "t", **entry} for entry in textures]}

    def test_textures_of_colours_become_mitsubas(self):
        def made(*textures):
            return self.convert(self.textured(textures, [{}]))["shape_0"]["bsdf"]["bsdf"]["reflectance"]

        red = {"type": "constant", "value": [1, 0, 0]}
        self.assertEqual(made(red), {"type": "rgb", "value": [1, 0, 0]})
        board = made({"type": "checkerboard", "first": 1, "second": 1, "uv": [[8, 0, 1], [0, 4, 0]]}, red)
        self.assertEqual((board["color1"]["value"], board["to_uv"][0]), ([1, 0, 0], [4, 0, 0, 0.5]))
        bitmap = made({"type": "image", "wrap": "clamp", "filter": "stochastic", "file": "a.exr",
                       "uv": [[2, 0, 1], [0, 3, 0.5]]})
        self.assertEqual((bitmap["filename"], bitmap["wrap_mode"]), ("a.exr", "clamp"))
        self.assertEqual(bitmap["to_uv"][:2], [[2, 0, 0, 1], [0, -3, 0, 0.5]])

    def test_textures_that_mitsuba_has_not_are_named(self):
        scale, white = {"type": "scale"}, {"type": "constant", "value": [1, 1, 1]}
        holes, lamp = self.textured([white]), self.lamp(file="a.exr")
        holes["shapes"][0]["alpha"] = 0
        for scene, text in ((self.textured([scale], [{}]), "texture \"t\" of the type scale"),
                            (self.textured([white], [{"input": "alpha"}]), "texture of alpha of \"grey"),
                            (self.textured([white], [{"meaning": "metal_reflectance"}]), "metal_reflectance"),
                            (self.textured([white], bump_map=0), "the bump_map of \"grey"),
                            (holes, "holes of \"a\""), (lamp, "picture of the light \"lamp\"")):
            with self.assertRaisesRegex(exchange.Unsupported, text):
                self.convert(scene)

    def environment(self, width, height, pixels, **more):
        exr.write(self.folder / "sky.exr", exr.Picture(width, height, array("f", pixels)))
        axes = {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1]}
        light = {"name": "sky", "type": "environment", "layout": "latitude-longitude", "rotation": axes,
                 "scale": [2, 2, 2], "file": "sky.exr", **more}
        return self.convert(self.scene(lights=[light]))["light_0"]

    def test_skies_are_maps_or_of_one_colour(self):
        sky = self.environment(4, 3, range(36))
        self.assertEqual((sky["type"], sky["scale"]), ("envmap", 2))
        self.assertEqual(sky["to_world"], [[0, 0, 1, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
        even = self.environment(1, 1, [1, 2, 3], scale=[1, 2, 4], layout="equal-area")
        self.assertEqual(even, {"type": "constant", "radiance": {"type": "rgb", "value": [1, 4, 12]}})
        for more in {"layout": "equal-area"}, {"scale": [1, 2, 4]}:
            with self.assertRaisesRegex(exchange.Unsupported, "no equal-area environment .* \"sky\""):
                self.environment(4, 4, range(48), **more)

    def test_what_mitsuba_has_not_is_named(self):
        law = {"constant": 0, "linear": 0, "quadratic": 1}
        point = {"name": "p", "type": "point", "position": [0, 0, 0], "intensity": [1, 1, 1],
                 "attenuation": law}
        self.assertEqual(self.convert(self.scene(lights=[point]))["light_0"]["type"], "point")
        flat = {**point, "attenuation": {**law, "constant": 1}}
        for scene, text in ((self.scene(lights=[flat]), "no light like \"p\", which is of the type point"),
                            (self.scene(lights=[{"name": "s", "type": "spot"}]), "no light like \"s\""),
                            (self.lamp(side="both"), "light \"lamp\" would emit on one side only"),
                            (self.scene(tan_half_width=0.6), "oblong pixels")):
            with self.assertRaisesRegex(exchange.Unsupported, text):
                self.convert(scene)


class Cycles(Folder):
    def convert(self, scene, **options):
        return cycles_scene.cycles_scene(scene, 64, 5, **options)

    def test_the_camera_and_the_settings(self):
        made = self.convert(self.scene(), seed=7)
        self.assertEqual(made["camera"]["matrix"], [[1, 0, 0, 0], [0, 1, 0, 1], [0, 0, 1, 5], [0, 0, 0, 1]])
        self.assertAlmostEqual(made["camera"]["angle_x"], 2 * math.atan(0.5))
        settings = made["settings"]
        self.assertEqual({settings[key] for key in settings if key.endswith("_bounces")}, {4, 1024})
        self.assertEqual((settings["samples"], settings["seed"], settings["max_bounces"]), (64, 7, 4))
        self.assertFalse(settings["use_adaptive_sampling"] or settings["use_denoising"])
        self.assertEqual(settings["min_light_bounces"], 1024)
        self.assertNotIn("min_light_bounces", self.convert(self.scene(), roulette=True)["settings"])

    def test_an_emitting_rectangle_is_a_lamp_before_a_black_one(self):
        for side, y in (("front", -1), ("back", 1)):
            shape, = self.convert(self.lamp(side=side))["shapes"]
            lamp = shape["lamp"]
            self.assertEqual([row[2] for row in lamp["matrix"]][:3], [0, -y, 0])  # it shines along -z
            x, y_axis, z, center = (tuple(row[k] for row in lamp["matrix"][:3]) for k in range(4))
            self.assertEqual(exchange.cross(x, y_axis), z)
            corners = {tuple(c + i * lamp["size"] / 2 * a + j * lamp["size_y"] / 2 * b
                             for a, b, c in zip(x, y_axis, center)) for i in (-1, 1) for j in (-1, 1)}
            self.assertEqual(corners, set(DOWN))
            self.assertEqual(lamp["color"], [1, 0.5, 0])
            self.assertGreater(-y * lamp["behind"][1], 0)
            self.assertEqual(shape["material"]["inputs"]["Color"], [0, 0, 0, 1])
            self.assertEqual(cycles_scene.area_lamp_power(lamp, (3, 4, 1)), 4 * 8 * 10)
            self.assertAlmostEqual(cycles_scene.area_lamp_power(lamp, (5, 0, 1)), math.pi * 8 * 10)

    def test_an_orthographic_camera_sees_its_whole_width(self):
        made = self.convert(self.scene(type="orthographic", half_width=4, half_height=2))["camera"]
        self.assertEqual((made["type"], made["ortho_scale"]), ("ORTHO", 8))

    def test_both_sides_of_a_mesh_emit_by_its_material(self):
        shape, = self.convert(self.lamp(side="both"))["shapes"]
        self.assertIsNone(shape["lamp"])
        self.assertEqual(shape["material"]["node"], "ShaderNodeEmission")

    def test_a_sphere_is_closed_and_faces_outward(self):
        vertices, faces = cycles_scene.sphere_mesh((1, 2, 3), 2)
        for vertex in vertices:
            self.assertAlmostEqual(math.dist(vertex, (1, 2, 3)), 2)
        edges = [(face[i - 1], face[i]) for face in faces for i in range(len(face))]
        self.assertEqual(len(set(edges)), len(edges))
        self.assertEqual({(b, a) for a, b in edges}, set(edges))
        for face in faces:
            a, b, c = (vertices[i] for i in face[:3])
            front = exchange.cross(exchange.subtract(b, a), exchange.subtract(c, a))
            self.assertGreater(exchange.dot(front, exchange.subtract(a, (1, 2, 3))), 0)

    def test_triangles_turn_to_their_normals(self):
        (self.folder / "a.ply").write_bytes(ply(DOWN, [(0, 1, 2), (2, 3, 0)], [(0, 1, 0)] * 4))
        mesh = exchange.read_ply(self.folder / "a.ply")
        self.assertEqual(cycles_scene.faces_along_normals(mesh), [(2, 1, 0), (0, 3, 2)])
        mesh.normals = array("f", [0, -1, 0] * 4)
        self.assertEqual(cycles_scene.faces_along_normals(mesh), [(0, 1, 2), (2, 3, 0)])

    def test_a_point_light_has_its_intensity_over_the_whole_sphere(self):
        law = {"constant": 0, "linear": 0, "quadratic": 1}
        light = {"name": "p", "type": "point", "position": [1, 2, 3], "intensity": [2, 4, 1],
                 "attenuation": law}
        point, = self.convert(self.scene(lights=[light]))["points"]
        self.assertEqual((point["position"], point["color"]), ([1, 2, 3], [0.5, 1, 0.25]))
        self.assertAlmostEqual(point["energy"], 4 * math.pi * 4)
        with self.assertRaisesRegex(exchange.Unsupported, "only the inverse square law, unlike the light"):
            self.convert(self.scene(lights=[{**light, "attenuation": {**law, "linear": 1}}]))

    def test_what_is_not_converted_is_named(self):
        for scene, text in ((self.scene(lens_radius=0.1), "lens"),
                            (self.scene(tan_half_width=0.6), "oblong pixels"),
                            (self.scene(lights=[{"name": "s", "type": "ambient"}]), "\"s\" \\(ambient\\)")):
            with self.assertRaisesRegex(exchange.Unsupported, text):
                self.convert(scene)


if __name__ == "__main__":
    unittest.main()
