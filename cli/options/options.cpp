// SPDX-License-Identifier: Apache-2.0
#include "cli/options/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <string_view>

#include "cli/console.h"
#include "cli/version.h"
#include "io/diagnostic.h"

namespace twinray {
namespace {

/// Whether a value is written "[=FILE]": it may be left out.
bool is_optional_value(const std::string& type) { return type.starts_with("[="); }

/// Help without the ranges and counts that CLI11 appends to an option's value, and without empty lines
/// between groups: that of a render fills a screen.
class BriefFormatter final : public CLI::Formatter {
 public:
  BriefFormatter() { column_width(41); }

  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string type = option->get_type_name();
    if (is_optional_value(type)) return type;
    return option->get_type_size() == 0 || type.empty() ? "" : " " + type;
  }

  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    const std::string name = CLI::Formatter::make_option_name(option, is_positional);
    return name.substr(0, name.find('{'));  // CLI11 appends what stands for a value that is left out.
  }

  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    std::string text = is_positional ? "" : group + ":\n";
    for (const CLI::Option* option : options) text += make_option(option, is_positional);
    if (!is_positional) text.pop_back();  // CLI11 puts a line's end behind such a group.
    return text;
  }
};

void prepare(CLI::App& app) {
  app.formatter(std::make_shared<BriefFormatter>());
  app.option_defaults()->take_last()->always_capture_default(false);
  app.set_help_flag("-h,--help", "Print this help");
}

/// The subcommand that the first word names; else the app itself.
const CLI::App& app_of(const CLI::App& app, const Words& words) {
  for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!words.empty() && subcommand->get_name() == words.front()) return *subcommand;
  return app;
}

/// "; did you mean --samples?": the app's option whose name is most like this word; "" where none is.
std::string nearest_option(const CLI::App& app, const std::string& word) {
  Words names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  const std::string asked = word.substr(0, word.find('=')).erase(0, word.find_first_not_of('-'));
  const std::string nearest = nearest_name(asked, std::vector<std::string_view>(names.begin(), names.end()));
  return nearest.empty() ? "" : fmt::format("; did you mean --{}?", nearest);
}

/// The words that no option took, as a message; without such words, the error's.
std::string extra_text(const CLI::App& app, const Words& words, const CLI::Error& error) {
  const Words extra = app.remaining(true);
  if (extra.empty()) return error.what();
  const std::string& word = extra.front();
  if (!word.starts_with('-')) return fmt::format("\"{}\" is one word too many", word);
  return fmt::format("there is no option {}{}", word, nearest_option(app_of(app, words), word));
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

bool takes_value(const CLI::Option* option) { return option && option->get_items_expected_max() > 0; }

/// The option that a word such as "--stats" or "-o" is by itself; null for any other.
const CLI::Option* option_named(const CLI::App& app, const std::string& word) {
  return word.starts_with('-') ? app.get_option_no_throw(word) : nullptr;
}

/// CLI11 takes "--stats=" for "--stats", and the word behind it for the value, were it an option.
void check_values(const CLI::App& app, const Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.starts_with("--") && word.size() > 3 && word.find('=') == word.size() - 1)
      throw UsageError(fmt::format("{}: its value is missing", word.substr(0, word.size() - 1)));
    if (i + 1 < words.size() && takes_value(option_named(app, word)) && option_named(app, words[i + 1]))
      throw UsageError(fmt::format("{}: its value is missing; {} is an option", word, words[i + 1]));
  }
}

void parse(CLI::App& app, const Words& words) {
  check_values(app_of(app, words), words);
  try {
    app.parse(Words(words.rbegin(), words.rend()));  // CLI11 takes the last word first
  } catch (const CLI::Success&) {
    throw;
  } catch (const CLI::ExtrasError& error) {
    throw UsageError(extra_text(app, words, error));
  } catch (const CLI::ArgumentMismatch& error) {
    throw UsageError(missing_text(error));
  } catch (const CLI::RequiredError& error) {
    // Of a command that leaves words to others, the first of these may be why.
    if (!app.remaining(true).empty()) throw UsageError(extra_text(app, words, error));
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

namespace {

bool is_number(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

/// "SCENE": a file that the command needs, and for which CLI11 took the last number of an option before it;
/// empty where there is none. A file may have such a name.
std::string file_taken_from_numbers(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional() || !option->get_required() || option->count() != 1) continue;
    const std::string& word = option->results().front();
    std::error_code error;
    if (is_number(word) && !std::filesystem::exists(word, error)) return option->get_name(true);
  }
  return "";
}

/// Throws UsageError.
void check_count(const CLI::App& app, const std::string& name, std::size_t given, std::size_t needed) {
  if (given == needed) return;
  const std::string missing = given + 1 == needed ? file_taken_from_numbers(app) : "";
  if (!missing.empty()) throw UsageError(missing + " is missing");
  throw UsageError(fmt::format("{}: {} numbers are needed, not {}", name, needed, given));
}

}  // namespace

void OptionGroup::add_words(const OptionText& text, std::size_t count,
                            std::function<void(const Words&)> take) {
  const std::function<void(const Words&)> take_all = [take = std::move(take), count, &app = app_,
                                                      name = long_name(text.names)](const Words& words) {
    check_count(app, name, words.size(), count);
    if (std::find(words.begin(), words.end(), "") != words.end())
      throw UsageError(fmt::format("{}: its value is empty", name));
    take(words);
  };
  app_.add_option_function(text.names, take_all, text.description)
      ->expected(int(count))
      ->allow_extra_args(false)
      ->type_name(text.value)
      ->default_str(text.by_default)
      ->group(name_);
}

void OptionGroup::add_word(const OptionText& text, std::string& target) {
  add_words({text.names, text.value, text.description, target}, 1,
            [&target](const Words& words) { target = words.front(); });
}

void OptionGroup::add_optional_word(const OptionText& text, const std::string& without, std::string& target) {
  app_.add_flag(fmt::format("{}{{{}}}", text.names, without), target, text.description)
      ->type_name(text.value)
      ->group(name_);
}

void OptionGroup::add_repeated(const OptionText& text, Words& target) {
  app_.add_option(text.names, target, text.description)
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false)
      ->type_name(text.value)
      ->group(name_);
}

namespace {

/// A word that a command needs, without an option before it.
void add_needed(CLI::App& app, const std::string& name, std::string& target, const std::string& description) {
  app.add_option(name, target, description)
      ->required()
      ->check([](const std::string& word) { return word.empty() ? "its value is empty" : std::string(); }, "")
      ->type_name("");
}

}  // namespace

void add_scene(CLI::App& app, std::string& scene) {
  add_needed(app, "SCENE", scene, "The scene: .dae, .pbrt, .gltf, .obj, ..., or generated:NAME");
}

void add_file(CLI::App& app, const std::string& name, std::string& file, const std::string& description) {
  add_needed(app, name, file, description);
}

void add_scenes(CLI::App& app, Words& scenes, const std::string& description) {
  app.add_option("SCENE", scenes, description)->expected(0, -1)->take_all()->type_name("");
}

void add_folder(CLI::App& app, std::string& folder, const std::string& description) {
  app.add_option("FOLDER", folder, description)->required()->type_name("");
}

void add_files(CLI::App& app, const std::string& name, Words& files, const std::string& description) {
  app.add_option(name, files, description)->required()->expected(1, -1)->take_all()->type_name("");
}

void leave_other_words(CLI::App& app) { app.allow_extras(); }

Words given_options(const CLI::App& app) {
  Words given;
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && !option->get_lnames().empty())
      given.push_back("--" + option->get_lnames().front());
  return given;
}

std::map<std::string, Words> given_words(const CLI::App& app) {
  std::map<std::string, Words> given;
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && !option->get_lnames().empty())
      given.emplace("--" + option->get_lnames().front(), option->reduced_results());
  return given;
}

Words given_defaults(const CLI::App& app) {
  Words names;
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && !option->get_lnames().empty() &&
        option->reduced_results() == Words{option->get_default_str()})
      names.push_back("--" + option->get_lnames().front());
  return names;
}

namespace {

/// A word of a command line, or an option with its word.
struct Item {
  std::string option;  ///< Empty: it is none of those that are looked for.
  std::string word;
};

/// The words, with these options taken apart.
std::vector<Item> items_of(const Words& words, const std::vector<std::string>& names) {
  const auto is_named = [&](const std::string& word) {
    return std::find(names.begin(), names.end(), word) != names.end();
  };
  std::vector<Item> items;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const bool is_short = word.size() > 2 && word[0] == '-' && word[1] != '-';
    const std::string option = is_short ? word.substr(0, 2) : word.substr(0, word.find('='));
    if (!is_named(option))
      items.push_back({"", word});
    else if (option != word)
      items.push_back({option, word.substr(option.size() + (is_short ? 0 : 1))});
    else if (++i < words.size())
      items.push_back({option, words[i]});
  }
  return items;
}

}  // namespace

Words without_options(const Words& words, const std::vector<std::string>& names) {
  Words left;
  for (Item& item : items_of(words, names))
    if (item.option.empty()) left.push_back(std::move(item.word));
  return left;
}

std::string word_of_option(const Words& words, const std::vector<std::string>& names) {
  std::string last;
  for (Item& item : items_of(words, names))
    if (!item.option.empty()) last = std::move(item.word);
  return last;
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
  Words read = words;
  for (const Subcommand& subcommand : subcommands) {
    CLI::App* options = app.add_subcommand(subcommand.name, subcommand.description);
    options->footer(subcommand.footer);
    Action action = subcommand.add(*options);
    options->set_version_flag("--version", version_text(), "Print versions, engines, instruction sets")
        ->group(subcommand.last_group);
    options->set_help_flag("-h,--help", "Print this help")->group(subcommand.last_group);
    if (subcommand.name != words.front()) continue;
    chosen = std::move(action);
    if (subcommand.read_as) read = subcommand.read_as(words);
  }
  try {
    parse(app, read);
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
