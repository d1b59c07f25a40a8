// SPDX-License-Identifier: Apache-2.0
// What all subcommands share in reading their options.
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace twinray {

/// Help without the ranges and counts that CLI11 appends to an option's value: the descriptions say what is
/// needed.
class BriefFormatter final : public CLI::Formatter {
 public:
  BriefFormatter() { column_width(41); }
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string type = option->get_type_size() == 0 ? "" : option->get_type_name();
    return type.empty() ? "" : " " + type.substr(0, type.find(':'));
  }
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    std::string text = is_positional ? "" : group + ":\n";
    for (const CLI::Option* option : options) text += make_option(option, is_positional);
    return is_positional ? text + "\n" : text;
  }
};

/// An option of exactly `count` numbers. Given twice, the last one counts.
template <typename T>
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<T>& target, int count) {
  const std::function<void(const std::vector<T>&)> take = [&target, name,
                                                           count](const std::vector<T>& values) {
    if (values.size() != std::size_t(count))
      throw CLI::ValidationError(
          fmt::format("{}: {} numbers are needed, not {}", name, count, values.size()));
    target = values;
  };
  return app.add_option_function(name, take)->expected(count)->allow_extra_args(false);
}

}  // namespace twinray
