# SPDX-License-Identifier: Apache-2.0
"""Renders a scene in exchange form by Cycles; run by the Python that has Blender's module bpy, or by
`blender --background --python cycles_render.py --`. Prints its version."""
import os
import sys

import bpy
from mathutils import Matrix, Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import task  # noqa: E402
from cycles_scene import area_lamp_power, cycles_scene, faces_along_normals, sphere_mesh  # noqa: E402
from exchange import read_ply  # noqa: E402


def add_object(name, data, matrix=None):
    thing = bpy.data.objects.new(name, data)
    if matrix is not None:
        thing.matrix_world = Matrix(matrix)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def make_material(name, description):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    node = tree.nodes.new(description["node"])
    for key, value in description["inputs"].items():
        node.inputs[key].default_value = value
    tree.links.new(node.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return made


def make_mesh(name, vertices, faces, normals=()):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.polygons.foreach_set("use_smooth", [bool(normals)] * len(faces))
    if normals:
        mesh.normals_split_custom_set_from_vertices(normals)
    return mesh


def triples(values):
    return [tuple(values[i:i + 3]) for i in range(0, len(values), 3)]


def shape_meshes(shape):
    """A Blender mesh for each of the shape's parts."""
    if "file" in shape:
        mesh = read_ply(shape["file"])
        yield make_mesh(shape["name"], triples(mesh.positions), faces_along_normals(mesh),
                        triples(mesh.normals))
        return
    for x, y, z, radius in shape["spheres"]:
        vertices, faces = sphere_mesh((x, y, z), radius)
        normals = [tuple((p - c) / radius for p, c in zip(point, (x, y, z))) for point in vertices]
        yield make_mesh(shape["name"], vertices, faces, normals)


def add_lamp(name, lamp):
    data = bpy.data.lights.new(name, "AREA")
    data.shape, data.size, data.size_y = "RECTANGLE", lamp["size"], lamp["size_y"]
    data.energy, data.color = area_lamp_power(lamp, bpy.app.version), lamp["color"]
    add_object(name, data, lamp["matrix"])


def add_shape(shape):
    material = make_material(shape["name"], shape["material"])
    for mesh in shape_meshes(shape):
        mesh.materials.append(material)
        thing = add_object(shape["name"], mesh)
        if shape["lamp"]:
            thing.location = Vector(shape["lamp"]["behind"])
    if shape["lamp"]:
        add_lamp(shape["name"], shape["lamp"])


def add_point(point):
    data = bpy.data.lights.new("point", "POINT")
    data.energy, data.color, data.shadow_soft_size = point["energy"], point["color"], 0
    add_object("point", data).location = point["position"]


def add_camera(ours):
    data = bpy.data.cameras.new("camera")
    data.type, data.sensor_fit = ours["type"], "HORIZONTAL"
    data.clip_start, data.clip_end = ours["clip_start"], ours["clip_end"]
    if ours["type"] == "ORTHO":
        data.ortho_scale = ours["ortho_scale"]
    else:
        data.angle_x = ours["angle_x"]
    bpy.context.scene.camera = add_object("camera", data, ours["matrix"])


def set_up(description, threads, output):
    """The empty scene's settings."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    for name, value in description["settings"].items():
        setattr(scene.cycles, name, value)
    scene.world = bpy.data.worlds.new("black")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)
    render = scene.render
    render.resolution_x, render.resolution_y = description["resolution"]
    render.resolution_percentage = 100
    render.threads_mode, render.threads = "FIXED", threads
    render.use_compositing = render.use_sequencer = False
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth, render.image_settings.exr_codec = "32", "ZIP"
    render.image_settings.color_mode = "RGB"
    render.filepath = os.path.abspath(output)


def read_arguments():
    words = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else sys.argv[1:]
    return task.parser().parse_args(words)


def main():
    arguments = read_arguments()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = task.scene_of(arguments)
    description = cycles_scene(scene, arguments.samples, arguments.depth, arguments.seed, arguments.roulette)
    set_up(description, arguments.threads, arguments.output)
    add_camera(description["camera"])
    for shape in description["shapes"]:
        add_shape(shape)
    for point in description["points"]:
        add_point(point)
    bpy.ops.render.render(write_still=True)
    print(f"Cycles of Blender {bpy.app.version_string}")


if __name__ == "__main__":
    task.run(main)
