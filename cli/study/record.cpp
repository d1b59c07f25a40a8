// SPDX-License-Identifier: Apache-2.0
#include "cli/study/record.h"

#include <nlohmann/json.hpp>

namespace twinray::study {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

}  // namespace

double rays_per_second(const Record& record) {
  return record.render_seconds > 0 ? double(record.rays) / record.render_seconds : 0;
}

std::string record_text(const Record& record) {
  const ordered_json json{{"command", record.command},
                          {"program", record.program},
                          {"scene_hash", record.scene_hash},
                          {"files_hash", record.files_hash},
                          {"engine", record.engine},
                          {"build_seconds", record.build_seconds},
                          {"render_seconds", record.render_seconds},
                          {"rays", record.rays},
                          {"camera_rays", record.camera_rays},
                          {"tests_per_ray", record.tests_per_ray}};
  return json.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::optional<Record> parse_record(const std::string& text) {
  try {
    const json all = json::parse(text);
    return Record{.command = all.at("command"),
                  .program = all.at("program"),
                  .scene_hash = all.at("scene_hash"),
                  .files_hash = all.at("files_hash"),
                  .engine = all.at("engine"),
                  .build_seconds = all.at("build_seconds"),
                  .render_seconds = all.at("render_seconds"),
                  .rays = all.at("rays"),
                  .camera_rays = all.at("camera_rays"),
                  .tests_per_ray = all.at("tests_per_ray")};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::uint64_t hash_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes) hash = (hash ^ std::uint8_t(byte)) * 0x100000001b3;
  return hash;
}

}  // namespace twinray::study
