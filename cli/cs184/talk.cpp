// SPDX-License-Identifier: Apache-2.0
#include "cli/cs184/talk.h"

#include <utility>

#include "cli/console.h"

namespace twinray {
namespace {

/// What was built; the course's program knows nothing but a binary BVH.
std::string engine_title(const RenderArguments& arguments) {
  const std::string name = engine_name(arguments);
  return name == "bvh-2" ? "BVH" : name;
}

double per_ray(const RayCounts& rays) { return double(rays.queries.primitives) / double(rays.total()); }

double million_rays_per_second(const RenderResult& result) {
  return result.seconds > 0 ? 1e-6 * double(result.rays.total()) / result.seconds : 0;
}

}  // namespace

Cs184Talk::~Cs184Talk() {
  if (open_line_) open_line_("\n");
}

void Cs184Talk::begin(std::string_view text, void (*write)(std::string_view) noexcept) {
  write(text);
  open_line_ = write;
  step_start_ = Clock::now();
}

void Cs184Talk::end_timed() {
  const std::chrono::duration<double> seconds = Clock::now() - step_start_;
  console::print("Done! ({:.4f} sec)\n", seconds.count());
  open_line_ = nullptr;
}

void Cs184Talk::loading() {
  if (!arguments_.environment.empty())
    console::print("[PathTracer] Loading environment map {}\n", arguments_.environment);
  console::print_error("[PathTracer] Input scene file: {}\n", arguments_.scene);
}

void Cs184Talk::ready() {
  if (!arguments_.environment.empty())
    console::write("[PathTracer] Initializing environment light...done.\n");
  console::print_error("[PathTracer] Rendering using {} threads\n", arguments_.render.threads);
  if (!arguments_.camera_file.empty())
    console::print("[Camera] Loaded settings from {}\n", arguments_.camera_file);
  begin("[PathTracer] Collecting primitives... ", console::write);
}

void Cs184Talk::building(const RenderArguments& arguments, const Geometry& geometry) {
  end_timed();
  engine_ = engine_title(arguments);
  counts_ = arguments.render.counting;
  begin(fmt::format("[PathTracer] Building {} from {} primitives... ", engine_, geometry.primitive_count()),
        console::write);
}

void Cs184Talk::built(const AccelStats&) { end_timed(); }

void Cs184Talk::rendering() { begin("[PathTracer] Rendering... ", console::write); }

void Cs184Talk::progress(const RenderProgress& progress) {
  const int percent = int(100 * progress.samples_done / progress.samples_total);
  if (percent == percent_ || percent == 100) return;
  percent_ = percent;
  console::print("\r[PathTracer] Rendering... {}%", percent);
}

void Cs184Talk::rendered(const RenderResult& result) {
  open_line_ = nullptr;
  console::print("\r[PathTracer] Rendering... 100%! ({:.4f}s)\n", result.seconds);
  console::print("[PathTracer] {} traced {} rays.\n", engine_, result.rays.total());
  console::print("[PathTracer] Average speed {:.4f} million rays per second.\n",
                 million_rays_per_second(result));
  if (counts_)
    console::print("[PathTracer] Averaged {:.6f} intersection tests per ray.\n", per_ray(result.rays));
  else
    console::write("[PathTracer] No intersection tests were counted.\n");
}

void Cs184Talk::stopped() { std::exchange(open_line_, nullptr)("\n"); }

void Cs184Talk::saving() {
  begin(fmt::format("[PathTracer] Saving to file: {}... ", arguments_.output), console::write_error);
}

void Cs184Talk::saved() {
  console::write_error("Done!\n");
  open_line_ = nullptr;
}

void Cs184Talk::finished(const RenderArguments& arguments, const AccelStats&, const RenderResult&) {
  console::print("[PathTracer] {} completed.\n", arguments.render.window ? "Cell job" : "Job");
}

}  // namespace twinray
