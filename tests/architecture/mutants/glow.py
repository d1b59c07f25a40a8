# SPDX-License-Identifier: Apache-2.0
"""Defects of light that media emit, of grids that keep what is not 0, and of media from files."""
from mutant import Mutant

EVEN = "an even medium glows by what a ray absorbs of it, however thin or long that is"
GRIDS = "light of media in grids is the integral along the ray"
SKY = "a body as bright as the sky cannot be told from it, whatever it absorbs and scatters"
SEEN = "light of media that is seen directly is emission, and what they let through is not"
BESIDE = "light of a medium lights what stands beside it"
WAVES = "waves of paths have the bits and the rays of paths one after the other"
BLACK = "a black body's glow is its spectrum over the greatest radiance, seen by the observer"
BRICKS = "a grid of several bricks has the numbers of all cells, and points between those of both sides"
EMPTY = "a grid keeps memory for what is not 0, and crosses the rest"
ENOUGH = "what lies along a ray is asked for up to where it is enough"
REACHED = "a grid is reached where so much lies before, and no further than where there is so much"
OPAQUE = "so much of a medium leaves nothing that it dims, and less leaves something"
EMITS = "a medium emits what it absorbs, and no more"
PBRT = "light of media: pbrt's color, factors from point to point, and temperatures"
WRITTEN = "written pbrt and exchange: light of media comes back as it was, or what is lost is named"
NVDB = "a nanovdb medium has the grids of its file, in the space of its statement"
FILE = "a NanoVDB file that cannot be is refused with what is wrong"
PACKED = "a NanoVDB file has the same grids however it is packed"
PLACED = "a NanoVDB grid has its values where its voxels are, and falls to 0 between them"
BITS = "a NanoVDB grid of fewer bits has its values but for their steps"
NODES = "values that are the same in a whole node are the grid's"
BELOW = "a NanoVDB grid without anything is empty, and negative numbers are counted"
NONE = "NanoVDB grids that are no densities are refused with what they are"
CLOUD = "a cloud is full at its bottom and nothing at its top, and noise in between"
CELLS = "a cloud's grid has as many cells as its waves need, up to 192, and its values in their middles"
SUMS = "a replayed path has what media emit, and its terms add up to its radiance"
REPLAYED = "a replay says what media on the way have emitted"
GROUPED = "what media emit is a light of its own, called media"
FAR = "light of media in grids far from where a ray begins is finite, though rounding is large there"
LIT = "a scene that media light has no default light"

MUTANTS = [
    Mutant("what is thin glows by a difference that rounding eats", "integrators/medium_glow.cpp",
           "if (!(x < thin)) return", "if (x > 0) return", "test_integrators", EVEN),
    Mutant("a medium does not dim its own light", "integrators/medium_glow.cpp",
           "return (1 - exp_of(-x)) / extinction;", "return amount;", "test_integrators", EVEN),
    Mutant("points of a way are chosen evenly", "integrators/medium_glow.cpp",
           "return std::min(-log_of(1 - u * (1 - exp_of(-x))) / extinction, amount);", "return u * amount;",
           "test_integrators", GRIDS),
    Mutant("an uneven glow is taken from where the ray begins", "integrators/medium_glow.cpp",
           "on.origin + on.direction * on.t_min", "on.origin + on.direction * ray.t_min",
           "test_integrators",
           GRIDS),
    Mutant("a glow's points begin anew", "integrators/medium_glow.cpp", "    before = at;\n", "",
           "test_integrators", GRIDS),
    Mutant("temperatures have no offset", "integrators/medium_glow.cpp",
           "(number - double(glow.temperature_offset))", "number", "test_integrators", GRIDS),
    Mutant("temperatures glow without factors", "integrators/medium_glow.cpp",
           "return factor * blackbody_glow", "return blackbody_glow", "test_integrators", GRIDS),
    Mutant("light of media is not weighted by how likely the way is", "integrators/way.h",
           "glow += weight() * medium_glow", "glow += medium_glow", "test_integrators", SKY),
    Mutant("a ray in a medium that glows ends where the path does", "integrators/way.h",
           "medium->density == no_density && !glows(*medium)", "medium->density == no_density",
           "test_integrators", SKY),
    Mutant("the last ray does not look for light of media", "integrators/direct_light.cpp",
           "departure.seeking == Seeking::alone || transport.has_glow",
           "departure.seeking == Seeking::alone", "test_integrators", BESIDE),
    Mutant("a wave's media glow one scattering too late", "integrators/wave/path_wave.cpp",
           "fly(depth_ + 1);", "fly(depth_);", "test_integrators", WAVES),
    Mutant("a wave's glow is dimmed by what lies before it twice", "integrators/wave/media.cpp",
           "paths_.throughput.at<Rgb>(i) * way.glow, depth",
           "paths_.throughput.at<Rgb>(i) * way.weight() * way.glow, depth", "test_integrators", WAVES),
    Mutant("light of media is no part of a wave's picture", "integrators/wave/found_light.cpp",
           "    add_seen_light(false, light, paths_of(sample));\n",
           "    add_seen_light(true, light, paths_of(sample));\n",
           "test_integrators", SEEN),
    Mutant("a replay forgets what media emit", "integrators/path_log.cpp",
           "    if (vertex.glow) sum += vertex.glow->term;\n", "", "test_integrators", SUMS),
    Mutant("a replay does not tell what media emit", "cli/replay/text.cpp",
           "if (vertex.glow) text +=", "if (false) text +=", "test_cli", REPLAYED),
    Mutant("media are in no group of lights", "cli/light_groups.cpp",
           "has_glow(scene.materials) ? group_of({media_light, AmbientLight{}}) : no_light", "no_light",
           "test_cli", GROUPED),
    Mutant("no rule of light groups names media", "cli/light_groups.cpp",
           "matches(pattern, media_light)))", "matches(pattern, \"-\")))", "test_cli", GROUPED),
    Mutant("a wave's media are in no group", "integrators/wave/found_light.cpp",
           "    groups_of(i).add_glow(radiance);\n", "", "test_integrators", BESIDE),
    Mutant("what is reached nowhere is at the end of the ray", "integrators/medium_glow.cpp",
           "if (std::isfinite(distance)) on", "on", "test_integrators", FAR),
    Mutant("a scene that media light is dark", "cli/default_light.cpp",
           "return has_glow(scene.materials) ||\n         std", "return std", "test_cli_engines", LIT),
    Mutant("what black bodies emit is relative to something else", "core/blackbody.cpp",
           "const double greatest = planck(peak / kelvin, kelvin);",
           "const double greatest = planck(560, kelvin);", "test_core", BLACK),
    Mutant("temperatures go by their steps", "core/blackbody.cpp",
           "return a * (1 - part) + b * part;", "return part < 2 ? a : b;", "test_core", BLACK),
    Mutant("a brick has no points of the next one", "core/density_grid.cpp",
           "first[k] = (point[k] - 1) / cells;", "first[k] = point[k] / cells;", "test_core", BRICKS),
    Mutant("bricks are as long as their points", "core/density_grid.cpp",
           "bricks_[k] = size[k] / cells + 1;", "bricks_[k] = (size[k] + 2) / points + 1;", "test_core",
           BRICKS),
    Mutant("zeros have bricks", "core/density_grid.cpp",
           "  if (value == 0 && this->value(x, y, z) == 0) return;\n", "", "test_core", EMPTY),
    Mutant("what is enough is not", "core/density_grid.cpp",
           "return sum * scale <= most;", "return most > 0;", "test_core", ENOUGH),
    Mutant("what is passed is not told", "core/density_grid.cpp",
           "found < never ? amount : passed * scale", "amount", "test_core", REACHED),
    Mutant("something of the densest channel is opaque", "core/interiors.cpp",
           "most = std::max(most, opaque / e);", "most = opaque / std::max(e, most);", "test_core", OPAQUE),
    Mutant("media emit what they do not absorb", "core/material.h",
           "return absorption * glow.radiance;", "return glow.radiance;", "test_core", EMITS),
    Mutant("a uniformgrid's light has no factor of its own", "io/pbrt/medium.cpp",
           "if (filling.emits() && glow.factor == no_density)", "if (false)", "test_io_nanovdb", PBRT),
    Mutant("the strength of an even medium's light is left out", "io/pbrt/medium.cpp",
           "parameters.real(\"Lescale\", 1, {0, 1e30}) * read_radiance(parameters, context_)",
           "read_radiance(parameters, context_)", "test_io_nanovdb", PBRT),
    Mutant("written pbrt: grids of another place are those of the density", "io/pbrt/writer_media.cpp",
           "grid.size() == density.size() && grid.to_unit() == density.to_unit()",
           "grid.size() == density.size()", "test_io_nanovdb", WRITTEN),
    Mutant("written pbrt: pbrt's own factor is lost", "io/pbrt/writer_media.cpp",
           "is_pbrts_own_factor(*scene_.densities[factor], density)) return", "false) return",
           "test_io_nanovdb", WRITTEN),
    Mutant("exchange: the grid of temperatures is not read", "io/exchange/reader.cpp",
           "if (entry.has(\"temperature\")) glow", "if (false) glow", "test_io_nanovdb", WRITTEN),
    Mutant("a nanovdb medium has no strength", "io/pbrt/medium.cpp",
           "filling.glow.radiance = {strength, strength, strength};", "filling.glow.radiance = {1, 1, 1};",
           "test_io_nanovdb", NVDB),
    Mutant("a nanovdb medium lies in the world's space", "io/pbrt/medium.cpp",
           "return read_nvdb_grid(file, name, to_world);", "return read_nvdb_grid(file, name, {});",
           "test_io_nanovdb", NVDB),
    Mutant("files of any version are read", "io/nanovdb/file.cpp", "version != known_version)",
           "version > 99)",
           "test_io_nanovdb", FILE),
    Mutant("what Blosc says of its size is believed", "io/nanovdb/blosc.cpp",
           "&& size == room.size() &&", "&& size > 0 &&", "test_io_nanovdb", FILE),
    Mutant("what zlib leaves empty is taken", "io/gzip.cpp", "|| size != room.size()) throw",
           "|| size == 0) throw",
           "test_io_nanovdb", FILE),
    Mutant("segments behind the first are left out", "io/nanovdb/file.cpp", "while (!file.is_at_end());",
           "while (false);", "test_io_nanovdb", PACKED),
    Mutant("voxels are cells", "io/nanovdb/grid.cpp", "return double(low[k]) - 0.5; }",
           "return double(low[k]); }",
           "test_io_nanovdb", PLACED),
    Mutant("root nodes lie at positive coordinates", "io/nanovdb/grid.cpp",
           "std::int64_t(std::int32_t(std::uint32_t(key >> shift & mask) << 12))",
           "std::int64_t(key >> shift & mask) << 12", "test_io_nanovdb", PLACED),
    Mutant("values of 8 bits are of 4", "io/nanovdb/grid.cpp",
           "return pnanovdb_leaf_fp8_read_float(", "return pnanovdb_leaf_fp4_read_float(",
           "test_io_nanovdb",
           BITS),
    Mutant("nodes of one value are empty", "io/nanovdb/grid.cpp", "if (number != 0) parts_",
           "if (false) parts_",
           "test_io_nanovdb", NODES),
    Mutant("negative numbers are not counted", "io/nanovdb/grid.cpp", "value = 0, ++negative;",
           "value = 0;",
           "test_io_nanovdb", BELOW),
    Mutant("level sets are densities", "io/nanovdb/grid.cpp",
           "kind != PNANOVDB_GRID_CLASS_UNKNOWN && kind != PNANOVDB_GRID_CLASS_FOG_VOLUME", "kind > 99",
           "test_io_nanovdb", NONE),
    Mutant("clouds end below", "io/pbrt/cloud.cpp", "std::max(0.0f, 0.5f - p.y)",
           "std::max(0.0f, 0.5f + 0 * p.y)",
           "test_io", CLOUD),
    Mutant("clouds have one octave less", "io/pbrt/cloud.cpp", "constexpr int octaves = 5;",
           "constexpr int octaves = 4;", "test_io", CLOUD),
    Mutant("a cloud's numbers stand at the corners of its cells", "io/pbrt/cloud.cpp",
           "(float(cell) + 0.5f)",
           "float(cell)", "test_io", CELLS),
]
