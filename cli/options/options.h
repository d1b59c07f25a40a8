// SPDX-License-Identifier: Apache-2.0
// How options are read, by all subcommands: in our words, with the default that stands in the code. CLI11
// splits the command line; options.cpp is its only door.
#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"

namespace CLI {
class App;
}  // namespace CLI

namespace twinray {

using Words = std::vector<std::string>;

/// "-s,--samples" -> "--samples".
std::string long_name(const std::string& names);

/// Numbers from `least` to `most`.
template <typename T>
struct Range {
  T least, most;
};

inline constexpr Range<int> frame_sides{1, 65536};  ///< Pixels.
inline constexpr Range<std::uint64_t> seeds{0, std::numeric_limits<std::uint64_t>::max()};

/// The number that the word is as a whole. Throws UsageError, in the option's name, for any other word.
template <typename T>
T parse_number(const std::string& option, const std::string& word, const Range<T>& range) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !(value >= range.least) ||
      !(value <= range.most))
    throw UsageError(fmt::format("{}: \"{}\" is not a {} from {} to {}", option, word,
                                 std::integral<T> ? "whole number" : "number", range.least, range.most));
  return value;
}

/// The two numbers of a range such as "16:32". Throws UsageError as above; `example` is a valid range.
template <typename T>
std::pair<T, T> parse_range(const std::string& option, const std::string& word, const Range<T>& range,
                            const char* example) {
  const std::size_t colon = word.find(':');
  if (colon == word.npos)
    throw UsageError(fmt::format("{}: \"{}\" is no range, as {} is", option, word, example));
  const T first = parse_number(option, word.substr(0, colon), range);
  return {first, parse_number(option, word.substr(colon + 1), range)};
}

/// Words with what they stand for.
template <typename T>
using Choices = std::vector<std::pair<std::string, T>>;

template <typename T>
std::string words_of(const Choices<T>& choices, const char* separator) {
  Words words;
  for (const auto& [word, value] : choices) words.push_back(word);
  return fmt::format("{}", fmt::join(words, separator));
}

/// How an option is called and explained: its names, what stands for its value in the help, what it does.
struct OptionText {
  std::string names, value, description;
  std::string by_default = {};  ///< The word that changes nothing; empty: none, or several words.
};

/// Groups of the help that options of several files are in.
namespace option_groups {
inline constexpr const char *picture = "Picture and samples", *light = "Light", *run = "Run";
}  // namespace option_groups

/// Options of a command that stand together in its help. All targets must outlive the reading. Of equal
/// options the last counts.
class OptionGroup {
 public:
  OptionGroup(CLI::App& app, const char* name) : app_(app), name_(name) {}

  /// An option without a value.
  void add_flag(const std::string& names, bool& target, const std::string& description);
  /// An option of `count` words, which are given to `take`.
  void add_words(const OptionText& text, std::size_t count, std::function<void(const Words&)> take);
  /// An option of one word.
  void add_word(const OptionText& text, std::string& target);

  /// An option of one word that stands behind a "=" or is left out: `without` then counts for it.
  void add_optional_word(const OptionText& text, const std::string& without, std::string& target);

  /// An option of one word that may be given again: all its words, in their order.
  void add_repeated(const OptionText& text, Words& target);

  /// An option of one number; its help ends with the target's value: the default.
  template <typename T>
  void add_number(const OptionText& text, T& target, const Range<T>& range) {
    const std::string option = long_name(text.names);
    const std::string by_default = fmt::format("{}", target);
    add_words({text.names, text.value, fmt::format("{} ({})", text.description, by_default), by_default}, 1,
              [&target, option, range](const Words& words) {
                target = parse_number(option, words.front(), range);
              });
  }

  /// An option of one number that need not be given.
  template <typename T>
  void add_number(const OptionText& text, std::optional<T>& target, const Range<T>& range) {
    const std::string option = long_name(text.names);
    add_words(text, 1, [&target, option, range](const Words& words) {
      target = parse_number(option, words.front(), range);
    });
  }

  /// An option of `count` numbers.
  template <typename T>
  void add_numbers(const OptionText& text, std::size_t count, std::vector<T>& target, const Range<T>& range) {
    const std::string option = long_name(text.names);
    add_words(text, count, [&target, option, range](const Words& words) {
      target.clear();
      for (const std::string& word : words) target.push_back(parse_number(option, word, range));
    });
  }

  /// An option of two numbers.
  template <typename T>
  void add_pair(const OptionText& text, T& first, T& second, const Range<T>& range) {
    const std::string option = long_name(text.names);
    add_words(text, 2, [&first, &second, option, range](const Words& words) {
      first = parse_number(option, words[0], range);
      second = parse_number(option, words[1], range);
    });
  }

  /// An option whose value is one of a few words; its help ends with the target's word, the default, where
  /// one stands for it. In place of the words `value` may stand for them.
  template <typename T>
  void add_choice(const std::string& names, T& target, const Choices<T>& choices, std::string description,
                  const char* value = "") {
    std::string by_default;
    for (const auto& [word, meaning] : choices)
      if (meaning == target) by_default = word;
    if (!by_default.empty()) description += fmt::format(" ({})", by_default);
    const std::string option = long_name(names);
    const std::string shown = *value ? value : words_of(choices, "|");
    add_words({names, shown, description, by_default}, 1, [&target, option, choices](const Words& words) {
      for (const auto& [word, meaning] : choices)
        if (word == words.front()) {
          target = meaning;
          return;
        }
      throw UsageError(fmt::format("{}: there is no \"{}\"; valid are {}", option, words.front(),
                                   words_of(choices, ", ")));
    });
  }

 private:
  CLI::App& app_;
  const char* name_;
};

/// Adds the scene that a command needs, or the scenes that it takes.
void add_scene(CLI::App& app, std::string& scene);
void add_scenes(CLI::App& app, Words& scenes, const std::string& description);

/// Adds a file that a command needs, called NAME in its help.
void add_file(CLI::App& app, const std::string& name, std::string& file, const std::string& description);

/// Adds the folder that a command needs.
void add_folder(CLI::App& app, std::string& folder, const std::string& description);

/// Adds files, one at least, called NAME in the help.
void add_files(CLI::App& app, const std::string& name, Words& files, const std::string& description);

/// Words that the command does not know are no errors: it looks at them itself.
void leave_other_words(CLI::App& app);

/// The long names of the options that were given.
Words given_options(const CLI::App& app);
/// Their words, by these names; those that count, where one was given again.
std::map<std::string, Words> given_words(const CLI::App& app);
/// The long names of those whose word is their default.
Words given_defaults(const CLI::App& app);

/// The names of the option that says where a picture goes.
inline const std::vector<std::string> output_options{"--output", "-o", "-f"};

/// The words but for these options, of one word each, in any of their forms: "--of=8", "--of 8", "-o a",
/// "-oa".
Words without_options(const Words& words, const std::vector<std::string>& names);
/// The word of the last of these options, in any of their forms; empty where there is none.
std::string word_of_option(const Words& words, const std::vector<std::string>& names);

/// Adds a command's options, and returns how their arguments are had once they are read.
template <typename Arguments>
using AddOptions = std::function<Arguments()> (*)(CLI::App&);

/// Lets `use` add options to an app of its own, reads the words, and calls what `use` returned.
void read_alone(const Words& words, const std::function<std::function<void()>(CLI::App&)>& use);

/// The arguments of these words. Throws UsageError.
template <typename Arguments>
Arguments parse_alone(AddOptions<Arguments> add_options, const Words& words) {
  Arguments arguments;
  read_alone(words, [&](CLI::App& app) -> std::function<void()> {
    return [&arguments, read = add_options(app)] { arguments = read(); };
  });
  return arguments;
}

/// What a subcommand does once its words are read, which it is given; returns the exit code.
using Action = std::function<int(const Words&)>;

struct Subcommand {
  const char* name;
  Action (*add)(CLI::App&);  ///< Adds its options.
  const char* description;
  const char* last_group = "Options";  ///< Of its help; has --help and --version, too.
  const char* footer = "";             ///< The help's last line.
  /// Not null: what is read in place of the words; the action is given them as they are.
  Words (*read_as)(const Words&) = nullptr;
};

/// Reads the words, the first of which is the name of one of the subcommands, and runs it; or prints its help
/// or the version, if that is asked for. Returns the exit code. Throws UsageError with the reason.
int run_subcommand(const std::vector<Subcommand>& subcommands, const Words& words);

}  // namespace twinray
