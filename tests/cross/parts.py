# SPDX-License-Identifier: Apache-2.0
"""Cases of cross_machine.py: films of which each machine has made a part."""
from comparison import case

SIZE = ("-r", "64", "48", "-q")


def merged(bench, whole, part, ranges):
    """Renders parts in turn on both, merges them on each; what differs from one render of all on x86-64."""
    bench.x86.twinray(*whole, "-o", "whole.film")
    names = [f"part{number}.film" for number in range(len(ranges))]
    for number, name in enumerate(names):
        rendering, other = bench.both()[number % 2], bench.both()[1 - number % 2]
        rendering.twinray(*part, *ranges[number], "-o", name)
        bench.copy(name, rendering, other)
    for machine in bench.both():
        machine.twinray("merge", *reversed(names), "-q", "-o", "merged.film")
        machine.twinray("merge", *names, "-q", "-o", "merged.exr")
        if machine.sums("merged.film") != bench.x86.sums("whole.film"):
            return f"the film that {machine.name} merged has other sums"
    if bench.x86.file("merged.exr").read_bytes() != bench.arm.file("merged.exr").read_bytes():
        return "the pictures that were merged have other bytes"
    return ""


def relay(bench, render, first):
    """24 samples a pixel: 8 on the first machine, 8 on the other, 8 on the first again."""
    bench.x86.twinray(*render, "-s", "24", "-o", "whole.film")
    second = bench.arm if first is bench.x86 else bench.x86
    first.twinray(*render, "-s", "8", "--checkpoint=a.ck", "-o", "a.film")
    for source, target, samples in ((first, second, "16"), (second, first, "24")):
        bench.copy("a.ck", source, target)
        target.twinray("resume", "a.ck", "-q", "-s", samples)
    return "" if first.sums("a.film") == bench.x86.sums("whole.film") else "the film has other sums"


def stopped(bench, render):
    """A render that is told to end on AArch64, at whatever sample, and goes on on x86-64."""
    bench.x86.twinray(*render, "-o", "whole.film")
    code = bench.arm.stop_after_checkpoint("b.ck", *render, "--checkpoint=b.ck", "--checkpoint-seconds=0.01",
                                           "-o", "a.film")
    if code != 75:
        return f"the render ended with {code}, not with 75"
    bench.copy("b.ck", bench.arm, bench.x86)
    bench.x86.twinray("resume", "b.ck", "-q")
    return "" if bench.x86.sums("a.film") == bench.x86.sums("whole.film") else "the film has other sums"


def parts(bench):
    render = ("render", bench.scene("spheres.dae"), *SIZE, "--layers=albedo,variance")
    samples = [(f"--sample-range={a}:{b}", "--of=24") for a, b in ((0, 5), (5, 12), (12, 20), (20, 24))]
    yield case("parts of samples from both, merged on each", merged, bench,
               (*render, "-s", "24"), render, samples)
    adaptive = ("render", bench.scene("still-life.pbrt"), *SIZE, "-s", "64", "-a", "8", "0.1")
    tiles = [(f"--tile-range={a}:{b}",) for a, b in ((0, 5), (5, 9), (9, 12))]
    yield case("parts of tiles from both, merged on each", merged, bench, adaptive, adaptive, tiles)
    for machine in bench.both():
        yield case(f"a checkpoint of {machine.name} goes on on the other, and back", relay, bench, render,
                   machine)
    yield case("a render that is told to end on AArch64 goes on on x86-64", stopped, bench,
               ("render", bench.scene("spheres.dae"), *SIZE, "-s", "512"))
