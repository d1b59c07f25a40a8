// SPDX-License-Identifier: Apache-2.0
#include "cli/engine_check.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/replay/command.h"

namespace twinray {

EngineCheck::EngineCheck(const RenderArguments& arguments, const Scene& scene, const Accelerator& accelerator)
    : arguments_(arguments),
      other_(build_accelerator(arguments.check_with->backend, scene.geometry, arguments.check_with->build)),
      names_{backend_name(arguments.backend), arguments.check_with->name},
      account_(scene.geometry, {.name = names_[0], .accelerator = &accelerator},
               {.name = names_[1],
                .accelerator = other_.get(),
                .is_canonical = arguments.plant_difference || arguments.check_with->is_canonical()},
               arguments.render) {}

RenderOptions EngineCheck::observed(RenderOptions options) {
  options.observe = [this](const PixelSample& sample, std::span<const RecordedRay> rays) {
    account_.observe(sample, rays);
  };
  return options;
}

LiveLayer EngineCheck::layer() const {
  return {"differences", {"R", "G", "B"}, [this](const Film& film, int x, int y) {
            return account_.shown(x, y, film.pixel(x, y).mean());
          }};
}

/// "camera ray of pixel 3 4, sample 5"
std::string EngineCheck::label(const Finding& finding) const {
  const PixelSample sample = account_.sample_of(finding);
  return fmt::format("{} ray of pixel {} {}, sample {}", ray_class_name(finding.ray_class), sample.x,
                     sample.y, sample.index);
}

std::string EngineCheck::replay() const {
  const LoadOptions& load = arguments_.load;
  const bool is_read_alike = !load.time && load.interpretation == Interpretation::standard;
  return (is_read_alike ? "" : "# crosscheck reads the scene at rest, and by no rules of CS184: ") +
         replay_command(arguments_.scene, load);
}

std::string EngineCheck::json(const SceneCrosscheck& found) const {
  return crosscheck_json(found, arguments_.scene, replay(), Ceilings::remark);
}

int EngineCheck::report(const SceneCrosscheck& found, const std::string& differences) const {
  const bool is_good = is_passed(found.report, Ceilings::remark);
  const bool is_told = !arguments_.quiet || arguments_.load.interpretation == Interpretation::cs184;
  if (is_told && !differences.empty()) console::print("Differences    {}\n\n", differences);
  if (is_told || !is_good)
    console::write(crosscheck_text(found, replay(), Ceilings::remark,
                                   [&](const Finding& finding) { return label(finding); }));
  return is_good ? 0 : 1;
}

}  // namespace twinray
