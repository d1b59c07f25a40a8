// SPDX-License-Identifier: Apache-2.0
#include "cli/sandbox/sandbox.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <utility>

#include "cli/console.h"
#include "core/error.h"
#include "io/assimp/scene_importer.h"
#include "io/picture/image_codec.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// Libraries that are loaded late, and what is known of the machine's processors and memory.
std::vector<std::string> places_of_the_system() {
  std::vector<std::string> places{"/usr",
                                  "/lib",
                                  "/lib64",
                                  "/etc/ld.so.cache",
                                  "/etc/localtime",
                                  "/proc/meminfo",
                                  "/proc/cpuinfo",
                                  "/proc/self/cgroup",
                                  "/proc/self/limits",
                                  "/proc/self/statm",
                                  "/proc/self/status",
                                  "/sys/fs/cgroup",
                                  "/sys/devices/system"};
  for (const char* name : {"LD_LIBRARY_PATH", "VIRTUAL_ENV"})
    for (const std::string& place : places_in(variable(name))) places.push_back(place);
  for (const char* name : {"OCIO", "TWINRAY_OIDN"})
    if (const std::string file = variable(name); !file.empty()) places.push_back(folder_of(file));
  return places;
}

/// Our own libraries and what they need may lie anywhere: they are loaded while all is open.
void load_libraries() {
  const auto attempt = [](void (*load)()) {
    try {
      load();
    } catch (const Error&) {  // Said where a picture, or a scene, needs it.
    }
  };
  attempt([] { static_cast<void>(image_codec()); });
  attempt(load_scene_importer);
}

/// A thread that there is already would stay outside.
void check_is_alone() {
  std::error_code error;
  const auto threads = std::distance(fs::directory_iterator("/proc/self/task", error), {});
  if (error || threads != 1)
    throw Error(
        fmt::format("--sandbox: the process has {} threads already, which it cannot close in", threads));
}

/// Each once, in order.
std::string list_text(std::vector<std::string> places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places.empty() ? "nothing" : fmt::format("{}", fmt::join(places, ", "));
}

void say_what_stays_open(const char* what, const SandboxNeeds& needs) {
  const std::string text = fmt::format("--sandbox: this kernel cannot {}", what);
  if (needs.strict) throw Error(text);
  console::warn(text);
}

}  // namespace

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

std::vector<std::string> places_in(const std::string& list) {
  std::vector<std::string> places;
  std::istringstream stream(list);
  for (std::string place; std::getline(stream, place, ':');)
    if (!place.empty()) places.push_back(place);
  return places;
}

void check_places(const std::vector<std::string>& places) {
  for (const std::string& place : places)
    if (!fs::exists(place)) throw Error(fmt::format("--sandbox: there is no file or folder {}", place));
}

std::string enter_sandbox(const SandboxNeeds& needs) {
  OpenPlaces places = needs.places;
  for (std::string& place : places_of_the_system()) places.read.push_back(std::move(place));
  load_libraries();
  check_is_alone();
  if (!close_files(places)) say_what_stays_open("close files (it has no Landlock)", needs);
  if (!close_system_calls(needs.network)) say_what_stays_open("filter calls (it has no seccomp)", needs);
  return fmt::format("reads {}; writes {}", list_text(needs.places.read), list_text(needs.places.write));
}

}  // namespace twinray
