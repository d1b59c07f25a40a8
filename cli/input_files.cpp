// SPDX-License-Identifier: Apache-2.0
#include "cli/input_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "io/film/content_hash.h"
#include "io/generated/generated.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

/// Names of files in place of their hashes: where each of them is.
InputFiles places_of(const RenderArguments& arguments) {
  InputFiles places;
  const fs::path folder = fs::path(arguments.scene).lexically_normal().parent_path();
  for (const std::string& file : *arguments.load.files) {
    const fs::path path = fs::path(file).lexically_normal(), name = path.lexically_relative(folder);
    places.try_emplace(name.empty() ? path.string() : name.string(), file);
  }
  if (!arguments.environment.empty()) places["the environment"] = arguments.environment;
  if (!arguments.camera_file.empty()) places["the camera's file"] = arguments.camera_file;
  return places;
}

/// A pipe has been read, and would be waited for.
std::string hash_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return "none";
  try {
    return file_hash(path);
  } catch (const Error&) {
    return "none";  // Whoever reads it says so, and goes on in a way of its own.
  }
}

constexpr std::string_view between = "  ";

/// A name may have line breaks; its line has none.
std::string in_a_line(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '\n' ? "\\n" : c == '\\' ? "\\\\" : std::string(1, c);
  return text;
}

std::string from_a_line(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    const char c = text[is_escape ? ++i : i];
    name += is_escape && c == 'n' ? '\n' : c;
  }
  return name;
}

}  // namespace

InputFiles input_files(const RenderArguments& arguments) {
  InputFiles files = places_of(arguments);
  std::vector<std::string*> values;
  for (auto& [name, place] : files) values.push_back(&place);
  parallel_for(values.size(), 1, arguments.render.threads,
               [&](std::size_t i, std::size_t) { *values[i] = hash_of(*values[i]); });
  if (generated::is_generated(arguments.scene)) files[arguments.scene] = "";
  return files;
}

std::string input_text(const InputFiles& files) {
  std::string text;
  for (const auto& [name, hash] : files) text += fmt::format("{}{}{}\n", hash, between, in_a_line(name));
  return text;
}

InputFiles parse_input_text(const std::string& text) {
  InputFiles files;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t place = line.find(between); place != line.npos)
      files[from_a_line(std::string_view(line).substr(place + between.size()))] = line.substr(0, place);
  return files;
}

std::string file_difference(const InputFiles& files, const InputFiles& others, const char* other) {
  for (const auto& [name, hash] : files) {
    const auto found = others.find(name);
    if (found == others.end()) return fmt::format("its scene reads {}, which is not read {}", name, other);
    if (found->second != hash) return fmt::format("{} is another file {}", name, other);
  }
  for (const auto& [name, hash] : others)
    if (!files.contains(name))
      return fmt::format("its scene does not read {}, which is read {}", name, other);
  return "";
}

}  // namespace twinray
