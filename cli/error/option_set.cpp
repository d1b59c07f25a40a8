// SPDX-License-Identifier: Apache-2.0
#include "cli/error/option_set.h"

#include <memory>

#include "core/error.h"

namespace twinray::error {
namespace {

constexpr const char* spaces = " \t\n";

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(spaces);
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}

/// What differs between the sets. The picture's frame does not: else nothing could be compared.
std::function<void()> add_options(CLI::App& app, RenderRequest& request, const Words& given, OptionSet& set) {
  add_light_options(app, request);
  add_texture_options(app, request);
  add_sampler_options(app, request);
  add_engine_options(app, request);
  return [&app, &request, &given, &set] {
    Words all = given;
    for (std::string& name : given_options(app)) {
      if (name == "--seed")
        throw UsageError("the pictures of all settings have the same seeds: --seed of error");
      all.push_back(std::move(name));
    }
    set.arguments = resolved_render(request, all);
  };
}

}  // namespace

Words split_words(const std::string& text) {
  Words words;
  bool is_within = false;
  char quote = 0;
  for (const char c : text) {
    if (quote == 0 && std::string_view(spaces).find(c) != std::string_view::npos) {
      is_within = false;
      continue;
    }
    if (!is_within) words.emplace_back();
    is_within = true;
    if (c == quote)
      quote = 0;
    else if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else
      words.back() += c;
  }
  if (quote != 0) throw UsageError(fmt::format("--settings: {} is not closed in: {}", quote, text));
  return words;
}

OptionSet parse_option_set(const std::string& text) {
  OptionSet set;
  const std::size_t colon = trimmed(text).starts_with('-') ? text.npos : text.find(':');
  set.name = trimmed(text.substr(0, colon));
  if (set.name.empty())
    throw UsageError(fmt::format("--settings: \"{}\" has no name; valid is \"NAME: OPTIONS\"", text));
  const bool is_name_alone = colon == text.npos && !set.name.starts_with('-');
  if (is_name_alone)
    throw UsageError(
        fmt::format("--settings: \"{}\" has no colon; valid is \"NAME: OPTIONS\", or \"NAME:\"", text));
  set.options = split_words(trimmed(colon == text.npos ? text : text.substr(colon + 1)));
  return set;
}

void read_options(const RenderRequest& common, const Words& given, OptionSet& set) {
  RenderRequest request = common;
  try {
    read_alone(set.options, [&](CLI::App& app) { return add_options(app, request, given, set); });
  } catch (const UsageError& error) {
    throw UsageError(fmt::format(
        "--settings \"{}\": {}\nvalid there are render's options of light, sampling and engine; those of the "
        "picture and --samples are common to all settings",
        set.name, error.what()));
  }
}

}  // namespace twinray::error
