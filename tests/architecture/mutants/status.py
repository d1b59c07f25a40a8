# SPDX-License-Identifier: Apache-2.0
"""How far a render is, told to machines, and when it is to end."""
from mutant import Mutant

ANEW = "a render that is resumed has the speed of all its processes, and its time anew"
TIMES = "times are of the machine's zone, or of UTC, or the next such time of day"
UNTIL = "a time to end by is one that a render has at most, beside its seconds"
STEPS = "progress in JSON is a line for each step, and all numbers are those of the render"

MUTANTS = [
    Mutant("a resumed render is as fast as if it had made all samples", "cli/progress.cpp",
           "progress.seconds_before + elapsed_seconds;", "elapsed_seconds;", "test_cli", ANEW),
    Mutant("the time of earlier processes does not tell what is left", "cli/progress.cpp",
           "(progress.seconds_before + elapsed_seconds) * (1 - done)", "elapsed_seconds * (1 - done)",
           "test_cli", ANEW),
    Mutant("summer time is not heeded", "cli/clock_time.cpp",
           "fields.tm_isdst = -1;", "fields.tm_isdst = 0;", "test_cli", TIMES),
    Mutant("a time of day that is now is today's", "cli/clock_time.cpp",
           "first > now ?", "first >= now ?", "test_cli", TIMES),
    Mutant("UTC is the machine's zone", "cli/clock_time.cpp",
           "timegm(&fields)", "mktime(&fields)", "test_cli", TIMES),
    Mutant("what loading took is time to render", "cli/options/sampling.cpp",
           "std::clamp(left.count(), time_limits.least, seconds)", "std::min(seconds, 1800.5)", "test_cli",
           UNTIL),
    Mutant("a render that is done does not say so", "cli/status/render_status.cpp",
           "status.step == Step::saving || status.step == Step::done", "false", "test_cli",
           "a line for machines says that a render is done which ended before its time"),
    Mutant("progress lines come with each tile", "cli/status/json_lines.cpp", "std::chrono::seconds(1)",
           "std::chrono::seconds(0)", "test_cli", STEPS),
    Mutant("a render that fails says nothing", "cli/status/status_talk.cpp",
           "if (has_ended_) return;",
           "return;", "test_cli", "a render that fails says so to machines"),
    Mutant("the last checkpoint of an interrupted render is not told", "cli/status/status_talk.cpp",
           "if (has_ended_) enter(status_.step);", "", "test_cli",
           "an interrupted render tells machines of its last checkpoint"),
    Mutant("the last checkpoint is none", "cli/render_keeping.cpp",
           "  if (is_saved) talk_.checkpointed();", "", "test_cli",
           "a metrics file has the numbers of the render at its end*"),
    Mutant("metrics are written at each step alone", "cli/status/metrics_file.h",
           "return Clock::now() >= next_;", "return false;", "test_cli",
           "a metrics file follows a render while it goes on"),
    Mutant("signs of names break a metrics file", "cli/status/metrics_file.cpp",
           "if (c == '\\\\' || c == '\"')", "if (c == '\\\\')", "test_cli",
           "names in metrics keep their signs, and lose bytes that are no letters"),
]
