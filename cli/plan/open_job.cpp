// SPDX-License-Identifier: Apache-2.0
// A job template of Open Job Description, as AWS Deadline Cloud and `openjd run` take it.
#include <nlohmann/json.hpp>

#include "cli/plan/farm_plan.h"

namespace twinray {
namespace {

using nlohmann::json;

/// A step whose tasks call a program with a number each.
json step_of(const char* name, const std::string& program, std::uint32_t tasks) {
  return {
      {"name", name},
      {"parameterSpace",
       {{"taskParameterDefinitions",
         {{{"name", "Number"}, {"type", "INT"}, {"range", "0-" + std::to_string(tasks - 1)}}}}}},
      {"script", {{"actions", {{"onRun", {{"command", program}, {"args", {"{{Task.Param.Number}}"}}}}}}}}};
}

}  // namespace

std::string open_job_template(const FarmPlan& plan) {
  json merge = step_of("Merge", plan.folder + "/merge-parts", plan.frame_count());
  merge["dependencies"] = json::array({{{"dependsOn", "Render"}}});
  return json{{"specificationVersion", "jobtemplate-2023-09"},
              {"name", plan.name},
              {"steps", {step_of("Render", plan.folder + "/render-part", plan.task_count()), merge}}}
             .dump(2) +
         "\n";
}

}  // namespace twinray
