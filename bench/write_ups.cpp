// SPDX-License-Identifier: Apache-2.0
#include "bench/write_ups.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "bench/pattern.h"
#include "core/error.h"

namespace twinray::bench {
namespace {

namespace fs = std::filesystem;

struct Line {
  const char* options;
  const char* scene;
  const char* reported;  ///< Rendering time in write-ups; the number names the write-up.
  bool is_long = false;
};

/// Of five write-ups, 1 of 2019 and 3 of 2023. Times of a BVH are those of pictures of normals, whose command
/// lines 4 alone gives. Machines and threads are not named; 2 rendered light on the course's own computers.
constexpr std::array lines{
    Line{"-r 480 360 --integrator=normals", "cow", "0.22 s (1), 0.63 s (2), 0.14 s (3), 0.34 s (5)"},
    Line{"-r 480 360 --integrator=normals --accel=brute-force", "cow",
         "94 s (1), 356 s (2), 302 s (3), 74 s (5)", true},
    Line{"-r 480 360 --integrator=normals", "bunny", "0.58 s (2)"},
    Line{"-r 480 360 --integrator=normals", "CBbunny", "0.48 s (4)"},
    Line{"-r 480 360 --integrator=normals", "maxplanck", "0.18 s (3)"},
    Line{"-r 480 360 --integrator=normals", "CBdragon", "0.08 s (3)"},
    Line{"-r 480 360 --integrator=normals", "CBlucy", "0.09 s (3)"},
    Line{"-r 480 360 -s 16 -l 8 -H", "CBbunny", "23.5 s (2)"},
    Line{"-r 480 360 -s 64 -l 32 -H", "CBbunny", "374 s (2)", true},
    Line{"-r 480 360 -s 64 -l 32", "CBbunny", "297 s (2)", true},
    Line{"-r 480 360 -s 1 -l 64", "CBbunny", "0.21 s (2)"},
    Line{"-r 480 360 -s 16 -l 8 -m 6", "CBbunny", ""},
    Line{"-r 480 360 -s 16 -l 8 -m 6 -H", "CBbunny", ""},
    Line{"-r 480 360 -s 16 -l 8 -m 6 -H --accel=auto", "CBbunny", ""},
    Line{"-r 480 360 -s 16 -l 8", "CBspheres_lambertian", ""},
    Line{"-r 480 360 -s 64 -l 4 -m 5", "CBspheres_lambertian", "", true},
    Line{"-r 480 360 -s 2048 -l 1 -m 5 -a 64 0.05", "CBspheres_lambertian", "", true},
};

/// What one run printed, and took.
struct Run {
  double build_seconds = 0, render_seconds = 0, cpu_seconds = 0;
  double rays = 0;
  double tests_per_ray = 0;  ///< 0 where they were not counted.
};

/// The number behind the last of these texts.
double number_behind(const std::string& output, const std::string& text) {
  const std::size_t at = output.rfind(text);
  if (at == output.npos) throw Error(fmt::format("pathtracer did not print \"{}\"", text));
  return std::strtod(output.c_str() + at + text.size(), nullptr);
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Starts the program with its standard output in `output`, and what else it says lost.
pid_t start(std::vector<std::string> words, int output) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = -1;
  const int error = posix_spawn(&process, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw Error(fmt::format("{} cannot be started", words[0]));
  return process;
}

std::string read_to_end(int input) {
  std::string text;
  char buffer[4096];
  for (ssize_t count; (count = read(input, buffer, sizeof buffer)) > 0;)
    text.append(buffer, std::size_t(count));
  return text;
}

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

Run run(const std::vector<std::string>& words) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error("no pipe can be made");
  const pid_t process = start(words, ends[1]);
  close(ends[1]);
  const std::string output = read_to_end(ends[0]);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(process, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(fmt::format("this failed: {}", fmt::join(words, " ")));
  const bool is_counted = output.find("Averaged ") != output.npos;
  const std::string building = output.substr(output.find("Building"));
  return {.build_seconds = number_behind(building.substr(0, building.find(" sec)")), "Done! ("),
          .render_seconds = number_behind(output, "100%! ("),
          .cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime),
          .rays = number_behind(output, " traced "),
          .tests_per_ray = is_counted ? number_behind(output, "Averaged ") : 0};
}

std::string file_of(const std::string& folder, const std::string& scene) {
  if (!fs::is_directory(folder)) throw Error("--scenes names the folder of CS184's scenes");
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == scene + ".dae") return entry.path().string();
  return "";
}

double median(const std::vector<Run>& runs, double Run::*member) {
  std::vector<double> values;
  for (const Run& one : runs) values.push_back(one.*member);
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::string row(const Line& line, const std::vector<Run>& runs) {
  const auto of = [&](double Run::*member) { return median(runs, member); };
  const double render = of(&Run::render_seconds);
  const double rays = of(&Run::rays), tests = of(&Run::tests_per_ray);
  return fmt::format("| `{}` | {} | {:.4f} | {:.2f} | {:.2f} | {:.0f} | {:.3g} | {} | {} |\n", line.options,
                     line.scene, of(&Run::build_seconds), render, of(&Run::cpu_seconds), rays,
                     1e-6 * rays / render, tests > 0 ? fmt::format("{:.2f}", tests) : "–", line.reported);
}

bool is_chosen(const Line& line, const WriteUpOptions& options) {
  if (line.is_long && options.is_quick) return false;
  const std::string text = fmt::format("{} {}", line.options, line.scene);
  return options.only.empty() ||
         std::any_of(options.only.begin(), options.only.end(),
                     [&](const std::string& pattern) { return Pattern(pattern).matches(text); });
}

}  // namespace

std::string write_up_table(const WriteUpOptions& options, void (*report)(const std::string&)) {
  std::string table =
      "| options | scene | build s | render s | CPU s | rays | M rays/s | tests per ray | in write-ups |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  for (const Line& line : lines) {
    if (!is_chosen(line, options)) continue;
    const std::string file = file_of(options.folder, line.scene);
    if (file.empty()) {
      table += fmt::format("| `{}` | {} | the folder has no such scene |\n", line.options, line.scene);
      continue;
    }
    std::vector<std::string> words{TWINRAY_PATHTRACER, "-f", "/dev/null"};
    for (std::string& word : words_of(line.options)) words.push_back(std::move(word));
    words.push_back(file);
    std::vector<Run> runs;
    for (int round = 0; round < options.rounds; ++round) {
      report(fmt::format("{} {}, round {}", line.options, line.scene, round + 1));
      runs.push_back(run(words));
    }
    table += row(line, runs);
  }
  return table;
}

}  // namespace twinray::bench
