# SPDX-License-Identifier: Apache-2.0
"""Renders a scene in exchange form by Mitsuba 3; run by the Python that has it. Prints its version."""
import math
from array import array

import drjit
import mitsuba

import exr
import task
from mitsuba_scene import mitsuba_scene


def loadable(value):
    """The dictionary with Mitsuba's own transforms, and a field of view in degrees."""
    if not isinstance(value, dict):
        return value
    result = {key: loadable(entry) for key, entry in value.items()}
    for place in ("to_world", "to_uv"):
        if place in result:
            result[place] = mitsuba.ScalarTransform4f(result[place])
    if "tan_half_width" in result:
        result["fov"] = 2 * math.degrees(math.atan(result.pop("tan_half_width")))
        result["fov_axis"] = "x"
    return result


def read_arguments():
    parser = task.parser()
    parser.add_argument("--variant", default="llvm_ad_rgb")
    parser.add_argument("--sampler", default="independent")
    return parser.parse_args()


def main():
    arguments = read_arguments()
    mitsuba.set_variant(arguments.variant)
    drjit.set_thread_count(arguments.threads + 1)  # with one thread Mitsuba 3.9 never ends reading a picture
    scene = task.scene_of(arguments)
    description = mitsuba_scene(scene, arguments.samples, arguments.depth, arguments.sampler,
                                arguments.seed, arguments.roulette)
    loaded = mitsuba.load_dict(loadable(description))
    drjit.set_thread_count(arguments.threads)
    picture = mitsuba.render(loaded, seed=arguments.seed)
    width, height = scene["resolution"]
    exr.write(arguments.output, exr.Picture(width, height, array("f", picture.array)))
    print(f"Mitsuba {mitsuba.__version__}, {arguments.variant}")


if __name__ == "__main__":
    task.run(main)
