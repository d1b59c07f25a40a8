// SPDX-License-Identifier: Apache-2.0
// The scripts that all job engines call.
#include <fmt/format.h>

#include <cctype>

#include "cli/plan/farm_plan.h"
#include "cli/shell_text.h"

namespace twinray {
namespace {

constexpr const char* first_lines = "#!/usr/bin/env bash\n# {}\nset -eu\n";

/// Where a place for a number begins, its length; npos where there is none.
struct NumberPlace {
  std::size_t begin = std::string::npos, size = 0;
};

NumberPlace number_place(const std::string& word, std::size_t from = 0) {
  for (std::size_t begin = word.find('%', from); begin != word.npos; begin = word.find('%', begin + 1)) {
    std::size_t end = begin + 1;
    while (end < word.size() && std::isdigit(static_cast<unsigned char>(word[end]))) ++end;
    const bool is_short = end - begin <= 3;  // No number has more than 99 digits.
    if (is_short && end < word.size() && word[end] == 'd') return {begin, end + 1 - begin};
  }
  return {};
}

/// A word for bash; the frame's number stands in its places.
std::string frame_word(const std::string& word) {
  if (!has_frame_number(word)) return shell_text({word});
  std::string text;
  std::size_t done = 0;
  const auto add_rest = [&](std::size_t end) {
    if (end > done) text += shell_text({word.substr(done, end - done)});
  };
  for (NumberPlace place = number_place(word); place.begin != word.npos; place = number_place(word, done)) {
    add_rest(place.begin);
    text += fmt::format("\"$(printf '{}' \"$frame\")\"", word.substr(place.begin, place.size));
    done = place.begin + place.size;
  }
  add_rest(word.size());
  return text;
}

std::string frame_words(const FarmPlan& plan) {
  std::string text;
  for (const std::string& word : plan.words)
    text += ' ' + (plan.frames ? frame_word(word) : shell_text({word}));
  return text;
}

std::string part_text(const FarmPlan& plan) {
  return fmt::format("{} {} in {} parts", plan.units, plan.is_by_tiles ? "tiles" : "samples", plan.parts);
}

/// What the names of all parts of a frame begin with; its number is in $frame.
std::string name_text(const FarmPlan& plan) {
  const std::string parts = shell_text({plan.folder + "/parts/"});
  return plan.frames ? parts + "$(printf '%04d-' \"$frame\")" : parts;
}

/// Goes to the folder of the call; from then on $TWINRAY is the program.
std::string begin_text(const FarmPlan& plan) {
  return fmt::format("cd {}\n[[ -n ${{TWINRAY-}} ]] || TWINRAY={}\n", shell_text({plan.called_in}),
                     shell_text({plan.program}));
}

}  // namespace

bool has_frame_number(const std::string& word) { return number_place(word).begin != word.npos; }

std::string with_frame_number(const std::string& word, int frame) {
  std::string text;
  std::size_t done = 0;
  for (NumberPlace place = number_place(word); place.begin != word.npos; place = number_place(word, done)) {
    const std::string digits = word.substr(place.begin + 1, place.size - 2);
    const int width = digits.empty() ? 0 : std::stoi(digits);
    text += word.substr(done, place.begin - done);
    text +=
        digits.starts_with('0') ? fmt::format("{:0{}}", frame, width) : fmt::format("{:{}}", frame, width);
    done = place.begin + place.size;
  }
  return text + word.substr(done);
}

// Where a signal ends bash's wait just as the child ends, the child's code is lost.
std::string wait_for_part(const std::string& indent) {
  return indent +
         "while [[ $(jobs -pr) ]]; do sleep 0.2 || true; done # Wait loses the code if a signal ends it.\n" +
         indent + "status=0\n" + indent + "wait \"$part\" || status=$?\n";
}

std::string render_script(const FarmPlan& plan) {
  std::string text = fmt::format(
      fmt::runtime(first_lines),
      fmt::format("Renders part $1, from 0 to {}, or parts as 3-7: {}{}. Goes on where it was stopped.",
                  plan.task_count() - 1, plan.frames ? fmt::format("{} frames of ", plan.frame_count()) : "",
                  part_text(plan)));
  text += fmt::format(fmt::runtime(R"(fail() {{
  printf '%s: "%s" is neither a part from 0 to {0} nor a range of such as 3-7\n' "$0" "$*" >&2
  exit 2
}}
(($# == 1)) && [[ $1 =~ ^([0-9]{{1,9}})(-([0-9]{{1,9}}))?$ ]] || fail "$@"
first=$((10#${{BASH_REMATCH[1]}})) last=$((10#${{BASH_REMATCH[3]:-${{BASH_REMATCH[1]}}}}))
((first <= last && last <= {0})) || fail "$@"
)"),
                      plan.task_count() - 1);
  text +=
      R"(if [[ $1 == *-* ]]; then
  part= stopped=0
  trap 'stopped=75; kill -TERM "$part" 2>/dev/null || true' TERM INT
  for ((number = first; number <= last; ++number)); do
    "$0" "$number" &
    part=$!
)" + wait_for_part("    ") +
      R"(    ((status == 0)) || exit "$status"
    ((stopped == 0)) || exit "$stopped"
  done
  exit
fi
)";
  text += begin_text(plan);
  text += plan.frames ? fmt::format("frame=$(({0} + first / {1})) part=$((first % {1}))\n",
                                    plan.frames->first, plan.parts)
                      : "part=$first\n";
  text +=
      fmt::format("begin=$(({0} * part / {1})) end=$(({0} * (part + 1) / {1}))\n", plan.units, plan.parts);
  text += fmt::format("name={}$(printf '%05d' \"$part\")\n", name_text(plan));
  text += "[[ ! -f $name.film ]] || exit 0\n";
  text += fmt::format("exec \"$TWINRAY\" render{} \\\n", frame_words(plan));
  text +=
      fmt::format("  --{}=\"$begin:$end\" --of={} ${{TWINRAY_THREADS:+--threads=\"$TWINRAY_THREADS\"}} \\\n",
                  plan.is_by_tiles ? "tile-range" : "sample-range", plan.samples);
  return text + "  --checkpoint=\"$name.checkpoint\" --resume --quiet --output=\"$name.film\"\n";
}

std::string merge_script(const FarmPlan& plan) {
  std::string text = fmt::format(
      fmt::runtime(first_lines),
      plan.frames
          ? fmt::format("Merges the parts of frame $1, from 0 to {}; without a number, of all frames.",
                        plan.frame_count() - 1)
          : "Merges all parts.");
  text += begin_text(plan);
  // What SIGUSR1 has left of a part is no part.
  const std::string name = fmt::format("name={}\n", name_text(plan));
  const std::string merge =
      fmt::format("\"$TWINRAY\" merge @<(printf '%s\\n' \"$name\"*[0-9].film) --quiet --output={}",
                  plan.frames ? frame_word(plan.output) : shell_text({plan.output}));
  const std::string clean =  // With what parts that were killed had begun to write.
      "printf '%s\\0' \"$name\"*.checkpoint{,.before} \"${name%/*}/.${name##*/}\"*.part | xargs -0 rm -f\n";
  if (!plan.frames) return text + name + merge + "\n" + clean;
  text += fmt::format(fmt::runtime(R"((($# > 0)) || set -- $(seq 0 {0})
for number; do
  [[ $number =~ ^[0-9]{{1,9}}$ ]] && ((10#$number <= {0})) && continue
  printf '%s: "%s" is no number of a frame from 0 to {0}\n' "$0" "$number" >&2
  exit 2
done
status=0
for number; do
frame=$(({1} + 10#$number))
)"),
                      plan.frame_count() - 1, plan.frames->first);
  return text + name + "if " + merge + "; then\n" + clean +
         "else\nstatus=$?\n((status < 128)) || break\nfi\ndone\nexit \"$status\"\n";
}

std::string command_list(const FarmPlan& plan) {
  std::string text;
  for (std::uint32_t task = 0; task < plan.task_count(); ++task)
    text += fmt::format("{} {}\n", shell_text({plan.folder + "/render-part"}), task);
  return text;
}

}  // namespace twinray
