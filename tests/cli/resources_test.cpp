// SPDX-License-Identifier: Apache-2.0
#include "cli/resources.h"

#include <fmt/format.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "accel/engines.h"
#include "core/threads.h"
#include "io/generated/generated.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string quoted_box = "'" TWINRAY_SOURCE_DIR "/scenes/box.dae'";

}  // namespace

TEST_CASE("a render needs its film of 64 bytes a pixel, and the pictures made of it") {
  RenderOptions options{.width = 1000, .height = 500};
  const std::vector<MemoryNeed> whole = memory_needs(options);
  REQUIRE(whole.size() == 2);
  CHECK(whole[0].name == "the film of 1000 x 500 pixels");
  CHECK(whole[0].bytes == 64 * 1000 * 500);
  CHECK(whole[1].bytes == 32 * 1000 * 500);
  options.window = PixelRect{10, 20, 30, 60};
  CHECK(memory_needs(options)[0].name == "the film of 20 x 40 pixels");
  CHECK(memory_needs(options)[0].bytes == 64 * 20 * 40);
}

TEST_CASE("each light group is a part of the film, once the scene says how many there are") {
  const RenderOptions options{.width = 10, .height = 10, .light_paths = true, .light_groups = true};
  Scene scene;
  scene.light_groups = {"key", "fill"};
  CHECK(memory_needs(options)[0].bytes == (64 + 8 * 24) * 100);
  CHECK(memory_needs(options, scene)[0].bytes == (64 + 10 * 24) * 100);
}

TEST_CASE("a render needs the tree of its engine, and that of the engine which checks it") {
  RenderArguments arguments{.backend = Backend::bvh};
  Scene scene;
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{SphereSet{"many", std::vector<Sphere>(1000, Sphere{})}});
  CHECK(memory_needs(arguments, scene).size() == 3);
  arguments.check_with = named_engine("bvh-2");
  const std::vector<MemoryNeed> needs = memory_needs(arguments, scene);
  REQUIRE(needs.size() == 4);
  CHECK(needs[2].name == "the tree of bvh over 1000 primitives");
  CHECK(needs[3].bytes > needs[2].bytes);
}

TEST_CASE("statistics need the rays of their picture, in two copies") {
  const std::vector<MemoryNeed> needs =
      memory_needs(Recording{.width = 100, .height = 10, .samples = 3, .max_depth = 2});
  REQUIRE(needs.size() == 1);
  CHECK(needs[0].name == "the rays of 100 x 10 pixels");
  CHECK(needs[0].bytes == 3000 * 5 * (sizeof(RecordedRay) + sizeof(Ray)));
}

TEST_CASE("threads that can all be made are no warning, more than the machine has either") {
  CHECK(thread_warning(2).empty());
  const TemporaryFolder folder;
  for (const Backend backend : available_backends()) {
    const ProcessResult result =
        run_program(fmt::format("{} -r 24 18 -s 2 -q -t 9 --accel={} -o '{}'", quoted_box,
                                backend_name(backend), folder.file("a.png")));
    CAPTURE(backend_name(backend));
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
  }
}

#ifdef TWINRAY_FEW_THREADS  // Neither a preloaded library nor a limit of addresses goes with a sanitizer.

namespace {

/// Renders the box where no more than `threads` threads can be made beside the first.
ProcessResult render_with_few(int threads, const std::string& options) {
  return run_shell(fmt::format("TWINRAY_TEST_THREADS={} LD_PRELOAD='" TWINRAY_FEW_THREADS
                               "' timeout 60 '" TWINRAY_PROGRAM "' {} -r 24 18 -s 2 -q {}",
                               threads, quoted_box, options));
}

}  // namespace

namespace {

/// The most memory that a process of its own takes to make a forest, and a tree over it if one is asked for.
std::uint64_t peak_bytes(const std::optional<Engine>& engine) {
  const pid_t child = fork();
  if (child == 0) {
    const Scene scene = generated::make_forest(400'000);
    if (engine) build_accelerator(engine->backend, scene.geometry, engine->build);
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  REQUIRE(status == 0);
  return 1024 * std::uint64_t(usage.ru_maxrss);
}

}  // namespace

TEST_CASE("what a tree is said to need is what building it takes, and at most twice as much") {
  const std::uint64_t scene = peak_bytes(std::nullopt);
  const std::size_t primitives = generated::make_forest(400'000).geometry->primitive_count();
  for (const std::string name : {"bvh", "bvh-compact", "bvh-2", "embree"}) {
    const std::optional<Engine> engine = find_engine(name);
    if (!engine) continue;  // This build lacks it.
    const std::vector<MemoryNeed> needs = memory_needs(engine->backend, engine->build, primitives);
    REQUIRE(needs.size() == 1);
    CAPTURE(name);
    CHECK(needs[0].name ==
          fmt::format("the tree of {} over {} primitives", backend_name(engine->backend), primitives));
    const double taken = double(peak_bytes(engine) - scene);
    CHECK(taken <= double(needs[0].bytes));
    CHECK(taken >= double(needs[0].bytes) / 2);
  }
  CHECK(memory_needs(Backend::brute_force, {}, 1000).empty());
}

TEST_CASE("what a compact tree needs instead is told of the ordinary one, where it is less") {
  const auto instead = [](const char* name, std::size_t primitives) {
    const Engine engine = named_engine(name);
    return memory_needs(engine.backend, engine.build, primitives)[0].instead;
  };
  CHECK(instead("bvh", 5'000'000) == "525.0 MB with --memory-mode=compact");
  CHECK(instead("bvh", 1000) == "");
  CHECK(instead("bvh-compact", 5'000'000) == "");
  CHECK(instead("bvh-2", 5'000'000) == "");
}

TEST_CASE("a tree larger than the memory is an error that says so") {
  // Room for the scene of 130 MB, and not for a tree of 500 MB beside it.
  const ProcessResult result =
      run_shell("ulimit -v 700000; timeout 60 '" TWINRAY_PROGRAM
                "' generated:forest:2000000 --accel=bvh --bvh-width=2 -r 8 6 -s 1 -q "
                "-o /dev/null");
  CHECK(result.exit_code == 1);
  CHECK(result.err.find("for the tree of bvh over ") != std::string::npos);
}

TEST_CASE("where the ordinary tree is too large, the message names the compact one, and that renders") {
  const auto render = [](const char* options) {
    return run_shell(fmt::format("ulimit -v 600000; timeout 60 '" TWINRAY_PROGRAM
                                 "' generated:forest:2000000 --accel=bvh -r 8 6 -s 1 -q -t 1 -o /dev/null {}",
                                 options));
  };
  const ProcessResult ordinary = render("");
  CHECK(ordinary.exit_code == 1);
  CHECK(ordinary.err.find(" with --memory-mode=compact") != std::string::npos);
  const ProcessResult compact = render("--memory-mode=compact");
  CAPTURE(compact.err);
  CHECK(compact.exit_code == 0);
}

TEST_CASE("a picture larger than the memory is an error before rendering that says how much of what") {
  const TemporaryFolder folder;
  const ProcessResult result = run_shell(fmt::format("ulimit -v 3000000; timeout 60 '" TWINRAY_PROGRAM
                                                     "' {} -r 8192 8192 -s 1 -o '{}'",
                                                     quoted_box, folder.file("a.png")));
  CHECK(result.exit_code == 1);
  CHECK(result.out.empty());
  const std::string needs =
      "twinray: 6.4 GB of memory are needed (4.3 GB for the film of 8192 x 8192 pixels, 2.1 GB for the "
      "pictures made of it); its address space (ulimit -v) leaves the program ";
  CHECK(result.err.substr(0, needs.size()) == needs);
  CHECK(folder.file_count() == 0);
}

TEST_CASE("with any limit of addresses a picture is made, or an error says why not and the old one stays") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.exr");
  for (const std::string& scene : {quoted_box, std::string("generated:ball:200000")})
    for (int megabytes = 64; megabytes <= 4096; megabytes += megabytes / 4) {
      CAPTURE(scene, megabytes);
      write_text(path, "old");
      const ProcessResult result =
          run_shell(fmt::format("ulimit -v {}; timeout 60 '" TWINRAY_PROGRAM "' {} -r 24 18 -s 1 -q -o '{}'",
                                1024 * megabytes, scene, path));
      // The system cannot load the program's libraries, or one of them ends the program as it is loaded.
      if (result.exit_code == 127 || result.err.starts_with("terminate called")) continue;
      CAPTURE(result.err);
      CHECK((result.exit_code == 0 || result.exit_code == 1));
      CHECK((result.exit_code == 0 || result.err.find("twinray: ") != std::string::npos));
      CHECK((result.exit_code == 0 || read_text(path) == "old"));
      CHECK(folder.file_count() == 1);
    }
}

TEST_CASE("where no thread can be made it renders on its first one, on every engine") {
  const TemporaryFolder folder;
  const std::string expected = folder.file("expected.exr"), found = folder.file("found.exr");
  REQUIRE(run_program(fmt::format("{} -r 24 18 -s 2 -q -o '{}'", quoted_box, expected)).exit_code == 0);
  for (const Backend backend : available_backends()) {
    const auto render = [&](const std::string& threads) {
      return render_with_few(0, fmt::format("{} --accel={} -o '{}'", threads, backend_name(backend), found));
    };
    CAPTURE(backend_name(backend));
    const ProcessResult one = render("-t 1"), eight = render("-t 8"), all = render("");
    CHECK(one.exit_code == 0);
    CHECK(one.err == "");
    CHECK(eight.exit_code == 0);
    CHECK(
        eight.err ==
        "warning: the system lets the program have 1 of 8 threads (see ulimit -u, and the container's limit "
        "of processes): it runs on that one\n");
    CHECK(all.exit_code == 0);
    if (backend == Backend::embree_native) continue;  // Its bits are its own.
    const bool is_same = read_image(found).pixels == read_image(expected).pixels;
    CHECK(is_same);
  }
}

TEST_CASE("statistics of more rays than the memory holds are an error, and fewer threads a warning") {
  const ProcessResult large =
      run_shell("ulimit -v 3000000; timeout 60 '" TWINRAY_PROGRAM "' stats " + quoted_box + " -r 8192 8192");
  CHECK(large.exit_code == 1);
  CHECK(large.err.find("for the rays of 8192 x 8192 pixels") != std::string::npos);
  const ProcessResult few = run_shell("TWINRAY_TEST_THREADS=3 LD_PRELOAD='" TWINRAY_FEW_THREADS
                                      "' timeout 60 '" TWINRAY_PROGRAM "' stats " +
                                      quoted_box + " -r 8 6 -t 8");
  CHECK(few.exit_code == 0);
  CHECK(few.err.find("4 of 8 threads") != std::string::npos);
}

TEST_CASE("where some threads can be made it renders on those") {
  const TemporaryFolder folder;
  const ProcessResult some = render_with_few(3, fmt::format("-t 8 -o '{}'", folder.file("a.png")));
  CHECK(some.exit_code == 0);
  CHECK(
      some.err ==
      "warning: the system lets the program have 4 of 8 threads (see ulimit -u, and the container's limit of "
      "processes): it runs on those\n");
  const ProcessResult enough = render_with_few(3, fmt::format("-t 4 -o '{}'", folder.file("a.png")));
  CHECK(enough.exit_code == 0);
  CHECK(enough.err == "");
}

#endif

}  // namespace twinray::test
