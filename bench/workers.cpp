// SPDX-License-Identifier: Apache-2.0
#include "bench/workers.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "core/error.h"

namespace twinray::bench {
namespace {

/// A pipe, closed in programs that are started.
struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Error("no pipe to a worker can be made");
    read_end = ends[0];
    write_end = ends[1];
  }
};

pid_t start(std::vector<std::string> words, int input, int output) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t process = -1;
  const int error = posix_spawn(&process, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(input);
  close(output);
  if (error != 0) throw Error(fmt::format("a worker cannot be started: {}", words[0]));
  return process;
}

}  // namespace

struct WorkerCrew::Worker {
  pid_t process = -1;
  std::FILE* orders = nullptr;
  std::FILE* answers = nullptr;

  explicit Worker(const std::vector<std::string>& words) {
    const Pipe to, from;
    process = start(words, to.read_end, from.write_end);
    orders = fdopen(to.write_end, "w");
    answers = fdopen(from.read_end, "r");
  }
  ~Worker() {
    if (orders) std::fclose(orders);  // The end of its input ends the worker.
    if (answers) std::fclose(answers);
    if (process > 0) waitpid(process, nullptr, 0);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void order() {
    std::fputs("go\n", orders);
    std::fflush(orders);
  }
  std::string answer() {
    char line[256];
    if (!std::fgets(line, sizeof line, answers)) throw Error("a worker ended before its work was done");
    return line;
  }
};

void answer_lines(const std::function<double()>& work) {
  const auto say = [](const std::string& words) {
    fmt::print("{}\n", words);
    std::fflush(stdout);
  };
  say("ready");
  for (char line[256]; std::fgets(line, sizeof line, stdin);) say(fmt::format("{:.9g}", work()));
}

WorkerCrew::WorkerCrew(const std::vector<std::string>& command, const std::string& first,
                       const std::string& second, int count) {
  std::signal(SIGPIPE, SIG_IGN);  // A worker that is gone shows when its answer is missing.
  std::vector<std::string> words = command;
  words.push_back(first);
  words.push_back(second);
  for (int i = 0; i < count; ++i) workers_.push_back(std::make_unique<Worker>(words));
  for (const auto& worker : workers_)
    if (worker->answer() != "ready\n") throw Error("a worker does not understand");
}

WorkerCrew::~WorkerCrew() = default;

std::vector<double> WorkerCrew::work(int count) {
  for (int i = 0; i < count; ++i) workers_[std::size_t(i)]->order();
  std::vector<double> answers;
  for (int i = 0; i < count; ++i)
    answers.push_back(std::strtod(workers_[std::size_t(i)]->answer().c_str(), nullptr));
  return answers;
}

}  // namespace twinray::bench
