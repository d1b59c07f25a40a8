# SPDX-License-Identifier: Apache-2.0
"""Scenes in exchange form for the tests of bench/peers."""
import json
import struct
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench" / "peers"))
import exchange  # noqa: E402

CAMERA = {"type": "perspective", "position": [0, 1, 5], "right": [1, 0, 0], "up": [0, 1, 0],
          "forward": [0, 0, -1], "tan_half_width": 0.5, "tan_half_height": 0.25, "lens_radius": 0,
          "focal_distance": 1, "clip_near": 0, "clip_along": "forward"}
BLACK = {"name": "black", "type": "lambert", "reflectance": [0, 0, 0]}
GREY = {"name": "grey", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}
DOWN = [(-1, 3, -2), (1, 3, -2), (1, 3, 2), (-1, 3, 2)]  # seen counter-clockwise from below


def ply(vertices, faces, normals=()):
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
    for name in "x y z nx ny nz".split()[:6 if normals else 3]:
        header += f"property float {name}\n"
    header += f"element face {len(faces)}\nproperty list uchar uint vertex_indices\nend_header\n"
    rows = [(*v, *n) for v, n in zip(vertices, normals)] if normals else vertices
    return (header.encode() + b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows) +
            b"".join(struct.pack("<B3I", 3, *face) for face in faces))


class Folder(unittest.TestCase):
    """A test with a folder for its files."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def scene(self, shapes=(), lights=(), materials=(GREY, BLACK), **camera):
        """Written to a file and read again."""
        path = self.folder / "scene.json"
        path.write_text(json.dumps({"format": "twinray scene", "version": 1, "resolution": [40, 20],
                                    "camera": {**CAMERA, **camera}, "materials": materials, "lights": lights,
                                    "shapes": shapes}))
        return exchange.read_scene(path)

    def lamp(self, **light):
        """A scene of one rectangle that shines down."""
        (self.folder / "lamp.ply").write_bytes(ply(DOWN, [(0, 1, 2), (0, 2, 3)]))
        shape = {"name": "lamp", "type": "mesh", "file": "lamp.ply", "material": 1, "light": 0}
        return self.scene([shape], [{"name": "lamp", "type": "mesh", "shape": 0, "radiance": [10, 5, 0],
                                     "side": "front", **light}])
