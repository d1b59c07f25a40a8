# SPDX-License-Identifier: Apache-2.0
"""The cases of cross_machine.py but those of parts; a group is a generator of (title, what differs)."""
import json

from comparison import case, difference_of_films, passes, same_file

SCENES = ("box.dae", "cornell-bunny.dae", "furnace.dae", "lights.dae", "spheres.dae", "films.pbrt",
          "glow.pbrt", "hair.pbrt", "haze.pbrt", "layers.pbrt", "lens.pbrt", "materials.pbrt", "motion.pbrt",
          "patterns.pbrt", "still-life.pbrt", "subsurface.pbrt")
SIZE = ("-r", "64", "48", "-q")
SMALL = ("-r", "32", "24", "-q")  # for many cases, each of which takes seconds to start
TABLES = ("baseline", "unoptimised", "optimised", "sve")
# Test programs, and the files of tests that are run, or with ~ those that are not: statistics of many samples
# and millions of rays take hours, and the same bits have the same statistics.
TESTS = {"core": ("~rough_dielectric", "~coated_conductor", "~coated_diffuse", "~ggx_albedo", "~principled",
                  "~thin_film", "~offset", "~lobes_edges", "~environment", "~rough_conductor", "~light_tree",
                  "~microfacet", "~cs184_microfacet"),
         "accel": ("~watertight", "~triangle"),
         "integrators": ("wave", "render", "tiles", "record", "tracer", "interaction"),
         "check": ("exact", "judge", "bounded", "oracle", "crosscheck", "placement", "shape_rays")}
ENGINES = (("--accel=bvh",), ("--accel=bvh", "--simd=scalar"), ("--accel=bvh", "--bvh-width=2"),
           ("--accel=embree",), ("--accel=embree", "--simd=scalar"),
           ("--integrator=path-reference", "--accel=bvh", "--simd=scalar"))
OPTIONS = (("-s", "64", "-a", "8", "0.1"),
           ("-s", "16", "--noise-target=0.3"),
           ("-s", "40", "--allocation=error"),
           ("-s", "8", "--sampler=independent", "--filter=mitchell", "--lens=0.05,5", "--aperture-blades=5"),
           ("-s", "8", "--seed=7", "-l", "4", "-m", "20", "--roulette=0.7", "--filter=gaussian"),
           ("-s", "4", "--projection=fisheye", "--regularize", "--clamp=10"),
           ("-s", "4", "--integrator=direct", "--direct=hemisphere"),
           ("-s", "4", "--integrator=ambient-occlusion"),
           ("-s", "4", "--integrator=normals"),
           ("-s", "4", "--integrator=furnace"),
           ("-s", "4", "--integrator=cost", "--accel=bvh"))
OURS = "bvh,bvh-2,embree,brute-force"
CROSSCHECKED = ("box.dae", "cornell-bunny.dae", "spheres.dae", "lights.dae")
PROCESSORS = ("cortex-a53", "cortex-a72", "neoverse-n1", "a64fx", "max,sve=off", "max,sve512=on")

# A plane and a sphere with picture.png upon them.
TEXTURED = """LookAt 0 -5 2  0 0 0  0 0 1
Camera "perspective" "float fov" 40
WorldBegin
LightSource "distant" "point3 from" [ 1 -2 3 ] "point3 to" [ 0 0 0 ]
Texture "picture" "spectrum" "imagemap" "string filename" "picture.png"
Material "coateddiffuse" "texture reflectance" "picture" "float roughness" 0.2
Shape "trianglemesh" "point3 P" [ -3 -2 0  3 -2 0  3 2 0  -3 2 0 ] "point2 uv" [ 0 0  5 0  5 3  0 3 ]
  "integer indices" [ 0 1 2  0 2 3 ]
Translate 0 0 1
Shape "sphere" "float radius" 0.8
"""


def tables(bench):
    for name in TABLES:
        yield passes(f"canonical table, {name}", bench.arm.run, f"tests/accel/canonical_table_{name}")


def tests(bench):
    for name, chosen in TESTS.items():
        wanted = ",".join(f"[#{file}_test]" for file in chosen if file[0] != "~")
        left_out = "".join(f"~[#{file[1:]}_test]" for file in chosen if file[0] == "~")
        yield passes(f"test_{name} {' '.join(chosen)}", bench.arm.run, f"tests/{name}/test_{name}", "-#",
                     *filter(None, (wanted + left_out,)))


def engines(bench):
    for scene in SCENES:
        render = ("render", bench.scene(scene), *SIZE, "-s", "8")
        bench.x86.twinray(*render, "--accel=bvh", "-o", "a.film")

        def compare(words, render=render):
            bench.arm.twinray(*render, *words, "-o", "a.film")
            return difference_of_films(*bench.both(), "a.film")
        for words in ENGINES:
            yield case(f"{scene} {' '.join(words)}", compare, words)
    for scene in ("box.dae", "spheres.dae"):
        yield same_file(f"{scene} --accel=brute-force", bench,
                        ("render", bench.scene(scene), *SIZE, "-s", "8", "--accel=brute-force"), "a.pfm")
        yield passes(f"{scene}: all engines, split methods, integrators and samplers on AArch64",
                     bench.arm.twinray, "agreement", bench.scene(scene), "-q", "-r", "24", "18",
                     "--view=file")


def options(bench):
    for scene in SCENES:
        for words in OPTIONS:
            yield same_file(f"{scene} {' '.join(words)}", bench,
                            ("render", bench.scene(scene), *SMALL, *words), "a.pfm")
        for words in (("--denoise=own", "--layers=all"), ("--layers=cryptomatte,light-groups",)):
            yield same_file(f"{scene} {' '.join(words)}, the whole .exr", bench,
                            ("render", bench.scene(scene), *SMALL, "-s", "8", *words), "a.exr")
    for words in ((), ("--tone=agx", "--exposure=0.5", "--white-balance=4000")):
        yield same_file(f"spheres.dae {' '.join(words)}, the whole .png", bench,
                        ("render", bench.scene("spheres.dae"), *SMALL, "-s", "8", *words), "a.png")


def files(bench):
    bench.x86.twinray("render", bench.scene("still-life.pbrt"), *SIZE, "-s", "16", "-o", "picture.png")
    bench.x86.twinray("render", bench.scene("lights.dae"), *SIZE, "-s", "16",
                      "--projection=latitude-longitude", "-o", "around.exr")
    bench.x86.file("textured.pbrt").write_text(TEXTURED)
    for name in ("picture.png", "around.exr", "textured.pbrt"):
        bench.copy(name, bench.x86, bench.arm)
    for words in ((), ("--texture-filter=file",), ("--texture-memory=1",),
                  ("--integrator=path-reference",)):
        yield same_file(f"a picture on surfaces {' '.join(words)}", bench,
                        ("render", "textured.pbrt", *SIZE, "-s", "8", *words), "a.pfm")
    yield same_file("light from a picture", bench,
                    ("render", bench.scene("materials.pbrt"), *SIZE, "-s", "8", "-e", "around.exr"), "a.pfm")


def crosscheck(bench):
    def report(machine, scene):
        words = ("crosscheck", bench.scene(scene), f"--engines={OURS}", "--rays=64000", "--json", "-q")
        return {**json.loads(machine.twinray(*words)), "seconds": 0}

    def compare(scene):
        left, right = (report(machine, scene) for machine in bench.both())
        return "" if left == right else "the reports differ"
    for scene in CROSSCHECKED:
        yield case(f"{scene}: {OURS}", compare, scene)
        yield passes(f"{scene}: all differences of bvh and embree-native on AArch64 are explained",
                     bench.arm.twinray, "crosscheck", bench.scene(scene), "--engines=bvh,embree-native",
                     "--rays=64000", "-q")


def processors(bench):
    render = ("render", bench.scene("materials.pbrt"), *SIZE, "-s", "8", "-o", "a.film")
    bench.x86.twinray(*render)

    def compare(model):
        bench.arm.twinray(*render, environment={"QEMU_CPU": model})
        return difference_of_films(*bench.both(), "a.film")
    for model in PROCESSORS:
        yield case(f"materials.pbrt on {model}", compare, model)
