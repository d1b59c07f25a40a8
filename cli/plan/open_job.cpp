// SPDX-License-Identifier: Apache-2.0
// A job template of Open Job Description, as AWS Deadline Cloud and `openjd run` take it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/plan/farm_plan.h"

namespace twinray {
namespace {

using nlohmann::json;

/// The scheduler has about so many tasks at most: more numbers are taken together.
constexpr std::uint32_t most_job_tasks = 1000;
constexpr const char* chunk_size = "PartsPerTask";

/// Numbers from 0 on, one for each call.
json numbers(std::uint32_t count) {
  return {{"name", "Number"}, {"type", "INT"}, {"range", "0-" + std::to_string(count - 1)}};
}

/// The same, of which a call has several that follow on each other: "3-7".
json chunked(json numbers) {
  numbers["type"] = "CHUNK[INT]";
  numbers["chunks"] = {{"defaultTaskCount", fmt::format("{{{{Param.{}}}}}", chunk_size)},
                       {"rangeConstraint", "CONTIGUOUS"}};
  return numbers;
}

/// A step whose tasks call a program with their numbers.
json step_of(const char* name, const std::string& program, const json& numbers) {
  return {
      {"name", name},
      {"parameterSpace", {{"taskParameterDefinitions", json::array({numbers})}}},
      {"script", {{"actions", {{"onRun", {{"command", program}, {"args", {"{{Task.Param.Number}}"}}}}}}}}};
}

/// How many parts a task renders.
json chunk_size_of(const FarmPlan& plan) {
  return {{"name", chunk_size},
          {"type", "INT"},
          {"minValue", 1},
          {"default", (plan.task_count() + most_job_tasks - 1) / most_job_tasks}};
}

}  // namespace

std::string open_job_template(const FarmPlan& plan) {
  json merge = step_of("Merge", plan.folder + "/merge-parts", numbers(plan.frame_count()));
  merge["dependencies"] = json::array({{{"dependsOn", "Render"}}});
  return json{{"specificationVersion", "jobtemplate-2023-09"},
              {"extensions", {"TASK_CHUNKING"}},
              {"name", plan.name},
              {"parameterDefinitions", json::array({chunk_size_of(plan)})},
              {"steps",
               {step_of("Render", plan.folder + "/render-part", chunked(numbers(plan.task_count()))), merge}}}
             .dump(2) +
         "\n";
}

}  // namespace twinray
