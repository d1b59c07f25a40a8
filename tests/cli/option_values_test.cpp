// SPDX-License-Identifier: Apache-2.0
// Every option that the help lists, with values that it cannot take. The lists come from the help itself, so
// that a new option is tested on the day it is added.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "cli/program.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

struct Option {
  std::string name;   ///< With its dashes.
  std::string value;  ///< As the help has it: "N", "W H", "path|direct|normals"; empty for a flag.
};

/// The working folder, for a while.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::string& path) : before_(fs::current_path()) { fs::current_path(path); }
  ~WorkingFolder() { fs::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path before_;
};

/// The other commands, from the last line of the help: "Others: a b c".
Words read_commands() {
  Words names{"render", "--cs184"};
  const std::string help = test::run_program("--help").out, mark = "Others: ";
  const std::size_t begin = help.rfind(mark) + mark.size();
  std::istringstream list(help.substr(begin));
  for (std::string word; list >> word;) names.push_back(word);
  return names;
}

const Words& commands() {
  static const Words names = read_commands();
  return names;
}

/// The options of CS184's program, from lines of its help such as "  -a  <INT> <FLOAT>  Words".
std::vector<Option> cs184_options() {
  std::vector<Option> options;
  std::istringstream help(test::run_program("--cs184 --help").out);
  for (std::string line; std::getline(help, line);) {
    std::istringstream words(line);
    std::string name, word;
    if (!(words >> name) || name.size() != 2 || name[0] != '-') continue;
    Option option{name, ""};
    while (words >> word && word.starts_with('<')) option.value += (option.value.empty() ? "" : " ") + word;
    options.push_back(option);
  }
  return options;
}

/// The options of any other command, from lines of its help such as "  -s,--samples N   Words".
std::vector<Option> read_options(const std::string& command) {
  std::vector<Option> options;
  std::istringstream help(test::run_program(command + " --help").out);
  for (std::string line; std::getline(help, line);) {
    if (!line.starts_with("  -")) continue;
    const std::string use = line.substr(2, line.find("  ", 2) - 2);  // "-s,--samples N"
    if (use.find("[=") != use.npos) continue;                        // its value may be left out
    const std::size_t name = use.find("--"), end = use.find_first_of(", ", name), space = use.find(' ');
    options.push_back({use.substr(name, end - name), space == use.npos ? "" : use.substr(space + 1)});
  }
  return options;
}

/// Each help is asked for once.
const std::vector<Option>& options_of(const std::string& command) {
  static std::map<std::string, std::vector<Option>> known;
  const auto [place, is_new] = known.try_emplace(command);
  if (is_new) place->second = command == "--cs184" ? cs184_options() : read_options(command);
  return place->second;
}

bool is_numbers(const Option& option) {
  static const Words kinds{"N", "W H", "X Y W H", "X Y INDEX", "N T", "C", "P", "throughput|P"};
  return option.value.starts_with("<INT>") || option.value == "<FLOAT>" ||
         std::find(kinds.begin(), kinds.end(), option.value) != kinds.end();
}
bool is_letter(const Option& option) { return option.name.size() == 2; }
bool is_choice(const Option& option) { return option.value.find('|') != std::string::npos; }

std::size_t word_count(const Option& option) {
  return std::size_t(std::count(option.value.begin(), option.value.end(), ' ')) + 1;
}

/// A value of the option, in as many words as it needs, each of them this one.
Words given(const Option& option, const std::string& word) {
  Words words{option.name};
  words.insert(words.end(), word_count(option), word);
  return words;
}

/// A word that the option takes.
std::string valid_word(const Option& option) {
  if (option.value == "throughput|P" || option.value == "P") return "1";
  return is_choice(option) ? option.value.substr(0, option.value.find('|')) : "2";
}

/// What the program says to these words; "usage: " before what it says of a wrong command line. The scene is
/// not there, so that no command does more than read its words.
std::string answer(const std::string& command, const Words& words) {
  std::vector<const char*> arguments{"twinray", command.c_str(), "no-such-scene.dae"};
  if (command == "convert") arguments.push_back("out.json");
  if (command == "compare") arguments.push_back("no-such-reference.exr");
  for (const std::string& word : words) arguments.push_back(word.c_str());
  try {
    twinray::run_program(read_invocation(arguments));
  } catch (const UsageError& error) {
    return std::string("usage: ") + error.what();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

bool is_refused(const std::string& said, const Option& option) {
  return said.starts_with("usage: ") && said.find(option.name) != std::string::npos;
}

/// Whether another command before this one has the option, too.
bool is_known(const std::string& command, const Option& option) {
  for (const std::string& other : commands()) {
    if (other == command) return false;
    for (const Option& known : options_of(other))
      if (known.name == option.name && known.value == option.value) return true;
  }
  return false;
}

/// The words to try: all of them with the first command that has the option, and one with each of the others,
/// which share how it is read.
Words tried(Words words, const std::string& command, const Option& option) {
  if (is_known(command, option)) words.resize(1);
  return words;
}

/// Calls check(command, option) for all options of all commands that take a value, or for all flags.
template <typename Check>
void for_each_option(bool with_value, const Check& check) {
  for (const std::string& command : commands())
    for (const Option& option : options_of(command)) {
      if (option.value.empty() == with_value || option.name == "--help" || option.name == "--version" ||
          option.name == "-h")
        continue;
      INFO(command << " " << option.name << " " << option.value);
      check(command, option);
    }
}

}  // namespace

TEST_CASE("the help of each command lists its options with their values") {
  CHECK(commands().size() >= 4);
  std::size_t numbers = 0, choices = 0, flags = 0;
  for (const Option& option : options_of("render")) {
    numbers += is_numbers(option);
    choices += is_choice(option);
    flags += option.value.empty();
  }
  CHECK(numbers >= 12);
  CHECK(choices >= 10);
  CHECK(flags >= 5);
}

TEST_CASE("an option whose value is missing is named") {
  for_each_option(true, [](const std::string& command, const Option& option) {
    CHECK(is_refused(answer(command, {option.name}), option));
    if (is_known(command, option)) return;
    const char* const flag = command == "--cs184" ? "-H" : command == "info" ? "--json" : "-q";
    CHECK(is_refused(answer(command, {option.name, flag}), option));
    CHECK(is_refused(answer(command, {option.name, option.name}), option));
  });
}

TEST_CASE("an option whose value is empty is named") {
  for_each_option(true, [](const std::string& command, const Option& option) {
    CHECK(is_refused(answer(command, given(option, "")), option));
    if (!is_letter(option) && !is_known(command, option))
      CHECK(is_refused(answer(command, {option.name + "="}), option));
  });
}

TEST_CASE("a number that is none, or out of range, is refused with the option's name") {
  for_each_option(true, [](const std::string& command, const Option& option) {
    if (!is_numbers(option)) return;
    const Words words{"abc",
                      "1,5",
                      "nan",
                      "inf",
                      "1e999",
                      "0x10",
                      "2x",
                      "--",
                      "99999999999999999999",
                      "-99999999999999999999",
                      "-1"};
    for (const std::string& word : tried(words, command, option)) {
      CAPTURE(word);
      CHECK(is_refused(answer(command, given(option, word)), option));
    }
  });
}

TEST_CASE("a choice that there is not is refused with the option's name") {
  for_each_option(true, [](const std::string& command, const Option& option) {
    if (!is_choice(option)) return;
    for (const std::string& word :
         tried({"abc", "-1", "99999999999999999999", "PATH", "a|b"}, command, option)) {
      CAPTURE(word);
      CHECK(is_refused(answer(command, given(option, word)), option));
    }
  });
}

TEST_CASE("a file's name that is any word ends in a message") {
  const TemporaryFolder folder;  // Metrics tell of renders that fail, too.
  const WorkingFolder here(folder.file(""));
  for_each_option(true, [](const std::string& command, const Option& option) {
    if (is_numbers(option) || is_choice(option)) return;
    const Words words{"abc", "-1", std::string(5000, 'x'), "\xff\xfe", "/"};
    for (const std::string& word : tried(words, command, option)) {
      CAPTURE(word);
      CHECK(answer(command, given(option, word)) != "accepted");
    }
  });
}

TEST_CASE("an option may be given twice") {
  for_each_option(true, [](const std::string& command, const Option& option) {
    if ((!is_numbers(option) && !is_choice(option)) || is_known(command, option)) return;
    Words words = given(option, valid_word(option));
    const Words again = words;
    words.insert(words.end(), again.begin(), again.end());
    CHECK(answer(command, words) == answer(command, again));
  });
  for_each_option(false, [](const std::string& command, const Option& option) {
    CHECK(answer(command, {option.name, option.name}) == answer(command, {option.name}));
  });
}

TEST_CASE("a flag that is given a value is named") {
  for_each_option(false, [](const std::string& command, const Option& option) {
    if (is_letter(option)) return;
    for (const std::string& value : tried({"=1", "=yes", "=-1", "="}, command, option))
      CHECK(is_refused(answer(command, {option.name + value}), option));
  });
}

TEST_CASE("an unknown option is an error that names the one it may stand for") {
  for (const std::string& command : commands())
    for (const Option& option : options_of(command)) {
      if (option.name.size() < 6 || command == "resume") continue;  // Which first looks for its file.
      std::string slip = option.name;
      std::swap(slip[3], slip[4]);
      if (slip[3] == slip[4]) continue;
      CAPTURE(command, slip);
      const std::string said = answer(command, {slip + "=1"});
      CHECK(said.find(fmt::format("there is no option {}=1; did you mean {}?", slip, option.name)) !=
            std::string::npos);
    }
  CHECK(answer("render", {"--no-such-thing-as-this"}).find("did you mean") == std::string::npos);
  const auto said = [](const char* command) { return answer(command, {}); };
  CHECK(
      said("rendr").starts_with("usage: there is no command rendr, and no such file; did you mean render?"));
  CHECK(said("hepl").starts_with("usage: there is no command hepl, and no such file; did you mean help?"));
  CHECK(said("cros-check").find("did you mean") == std::string::npos);  // It may be the name of a scene.
  CHECK(said("scene").find("did you mean") == std::string::npos);
  CHECK(answer("render", {"-z"}).find("usage: there is no option -z\n") == 0);
}

TEST_CASE("a scene that was forgotten behind the numbers of an option is missing, and no number is") {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& words) {
    const ProcessResult result = run_shell(
        fmt::format("cd {}; {} render {}", quoted(folder.path().string()), quoted(TWINRAY_PROGRAM), words));
    CHECK(result.exit_code == 2);
    return result.err;
  };
  CHECK(error("-r 40 30").starts_with("twinray: SCENE is missing\n"));
  CHECK(error("-s 4 --crop 1 2 3 4").starts_with("twinray: SCENE is missing\n"));
  CHECK(error("-r 40 box.dae").starts_with("twinray: --resolution: 2 numbers are needed, not 1\n"));
  CHECK(error("--crop 1 2 3").starts_with("twinray: --crop: 4 numbers are needed, not 2\n"));
  write_text(folder.file("30"), "");
  CHECK(error("-r 40 30").starts_with("twinray: --resolution: 2 numbers are needed, not 1\n"));
}

}  // namespace twinray::test
