// SPDX-License-Identifier: Apache-2.0
#include "cli/options.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/console.h"
#include "cli/version.h"

namespace twinray {
namespace {

/// Help without the ranges and counts that CLI11 appends to an option's value.
class BriefFormatter final : public CLI::Formatter {
 public:
  BriefFormatter() { column_width(41); }

  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string type = option->get_type_size() == 0 ? "" : option->get_type_name();
    return type.empty() ? "" : " " + type;
  }

  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    std::string text = is_positional ? "" : group + ":\n";
    for (const CLI::Option* option : options) text += make_option(option, is_positional);
    return is_positional ? text + "\n" : text;
  }
};

void prepare(CLI::App& app) {
  app.formatter(std::make_shared<BriefFormatter>());
  app.option_defaults()->take_last()->always_capture_default(false);
  app.set_help_flag("-h,--help", "Print this help");
}

/// The words that no option took, as a message.
std::string extra_text(const CLI::App& app, const CLI::ExtrasError& error) {
  const Words extra = app.remaining(true);
  if (extra.empty()) return error.what();
  return extra.front().starts_with('-') ? fmt::format("there is no option {}", extra.front())
                                        : fmt::format("\"{}\" is one word too many", extra.front());
}

/// "--stats: 1 required FILE missing", as CLI11 says it, in our words.
std::string missing_text(const CLI::ArgumentMismatch& error) {
  const std::string text = error.what();
  if (const std::size_t end = text.find(" was given a disallowed flag override"); end != text.npos)
    return fmt::format("{}{} takes no value", end == 1 ? "-" : "--", text.substr(0, end));
  const std::size_t colon = text.find(": "), required = text.find(" required "), end = text.rfind(" missing");
  if (colon == text.npos || required == text.npos || end == text.npos) return text;
  return fmt::format("{}: {} is missing", text.substr(0, colon),
                     text.substr(required + 10, end - required - 10));
}

/// CLI11 takes "--stats=" for "--stats", and the word behind it for the value.
void check_values(const Words& words) {
  for (const std::string& word : words)
    if (word.starts_with("--") && word.size() > 3 && word.find('=') == word.size() - 1)
      throw UsageError(fmt::format("{} its value is missing", word));
}

void parse(CLI::App& app, const Words& words) {
  check_values(words);
  try {
    app.parse(Words(words.rbegin(), words.rend()));  // CLI11 takes the last word first
  } catch (const CLI::Success&) {
    throw;
  } catch (const CLI::ExtrasError& error) {
    throw UsageError(extra_text(app, error));
  } catch (const CLI::ArgumentMismatch& error) {
    throw UsageError(missing_text(error));
  } catch (const CLI::RequiredError& error) {
    const std::string text = error.what();  // "SCENE is required"
    throw UsageError(text.substr(0, text.find(' ')) + " is missing");
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

std::string long_name(const std::string& names) {
  const std::size_t begin = names.find("--");
  return begin == names.npos ? names : names.substr(begin, names.find(',', begin) - begin);
}

void OptionGroup::add_flag(const std::string& names, bool& target, const std::string& description) {
  app_.add_flag(names, target, description)->disable_flag_override()->group(name_);
}

void OptionGroup::add_words(const OptionText& text, std::size_t count,
                            std::function<void(const Words&)> take) {
  const std::function<void(const Words&)> take_all = [take = std::move(take), count,
                                                      name = long_name(text.names)](const Words& words) {
    if (words.size() != count)
      throw UsageError(fmt::format("{}: {} numbers are needed, not {}", name, count, words.size()));
    take(words);
  };
  app_.add_option_function(text.names, take_all, text.description)
      ->expected(int(count))
      ->allow_extra_args(false)
      ->type_name(text.value)
      ->group(name_);
}

void OptionGroup::add_word(const OptionText& text, std::string& target) {
  add_words(text, 1, [&target](const Words& words) { target = words.front(); });
}

void add_scene(CLI::App& app, std::string& scene) {
  app.add_option("SCENE", scene, "The scene: a COLLADA file (.dae), or generated:NAME")
      ->required()
      ->type_name("");
}

void add_scenes(CLI::App& app, Words& scenes, const std::string& description) {
  app.add_option("SCENE", scenes, description)->expected(0, -1)->take_all()->type_name("");
}

void add_folder(CLI::App& app, std::string& folder, const std::string& description) {
  app.add_option("FOLDER", folder, description)->required()->type_name("");
}

Words given_options(const CLI::App& app) {
  Words given;
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && !option->get_lnames().empty())
      given.push_back("--" + option->get_lnames().front());
  return given;
}

void read_alone(const Words& words, const std::function<std::function<void()>(CLI::App&)>& use) {
  CLI::App app("", "twinray");
  prepare(app);
  const std::function<void()> take = use(app);
  parse(app, words);
  take();
}

int run_subcommand(const std::vector<Subcommand>& subcommands, const Words& words) {
  CLI::App app("", "twinray");
  prepare(app);
  app.require_subcommand(1);
  Action chosen;
  for (const Subcommand& subcommand : subcommands) {
    CLI::App* options = app.add_subcommand(subcommand.name, subcommand.description);
    options->footer(subcommand.footer);
    Action action = subcommand.add(*options);
    options->set_version_flag("--version", version_text(), "Print versions, engines, instruction sets")
        ->group(subcommand.last_group);
    options->set_help_flag("-h,--help", "Print this help")->group(subcommand.last_group);
    if (subcommand.name == words.front()) chosen = std::move(action);
  }
  try {
    parse(app, words);
  } catch (const CLI::CallForHelp&) {
    console::write(app.help());
    return 0;
  } catch (const CLI::CallForVersion&) {
    console::write(version_text());
    return 0;
  }
  return chosen(Words(words.begin() + 1, words.end()));
}

}  // namespace twinray
