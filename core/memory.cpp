// SPDX-License-Identifier: Apache-2.0
#include "core/memory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "core/error.h"

namespace twinray {
namespace {

using Bytes = std::optional<std::uint64_t>;

/// The number that a file holds; none where there is no such file, or a word ("max").
Bytes number_in(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  return file >> value ? Bytes(value) : std::nullopt;
}

/// The first number after `name` in a file of lines that begin with names; none where there is none.
Bytes number_after(const std::string& path, const std::string& name) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(name)) continue;
    std::istringstream rest(line.substr(name.size()));
    std::uint64_t value = 0;
    return rest >> value ? Bytes(value) : std::nullopt;
  }
  return std::nullopt;
}

std::uint64_t difference(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : 0; }

void tighten(MemoryLimit& limit, const Bytes& bytes, const char* name) {
  if (bytes && *bytes < limit.bytes) limit = {*bytes, name};
}

Bytes left_of_machine(const std::string& root) {
  const std::string meminfo = root + "proc/meminfo";
  const Bytes available = number_after(meminfo, "MemAvailable:");
  if (!available) return std::nullopt;
  return (*available + number_after(meminfo, "SwapFree:").value_or(0)) * 1024;
}

Bytes left_of_address_space(const std::string& root) {
  const Bytes most = number_after(root + "proc/self/limits", "Max address space");
  const Bytes pages = number_in(root + "proc/self/statm");
  if (!most || !pages) return std::nullopt;
  return difference(*most, *pages * std::uint64_t(sysconf(_SC_PAGESIZE)));
}

Bytes left_of_data(const std::string& root) {
  const Bytes most = number_after(root + "proc/self/limits", "Max data size");
  const Bytes used = number_after(root + "proc/self/status", "VmData:");
  if (!most || !used) return std::nullopt;
  return difference(*most, *used * 1024);
}

/// The files in which a version of control groups keeps its numbers, and what its statistics call files in
/// memory.
struct GroupFiles {
  const char *mount, *most, *used, *inactive_files, *active_files;
};
constexpr GroupFiles version_1{"sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
                               "total_inactive_file ", "total_active_file "};
constexpr GroupFiles version_2{"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file ",
                               "active_file "};

Bytes left_of_group(const std::string& folder, const GroupFiles& files) {
  const Bytes most = number_in(folder + "/" + files.most), used = number_in(folder + "/" + files.used);
  if (!most || !used) return std::nullopt;
  const std::string stat = folder + "/memory.stat";
  const std::uint64_t in_files = number_after(stat, files.inactive_files).value_or(0) +
                                 number_after(stat, files.active_files).value_or(0);
  return difference(*most, difference(*used, in_files));
}

/// Of the group and all above it. In a container the path is often that of the host: then only the last
/// step, the mount itself, is there, and it is the container's group.
void tighten_by_groups(MemoryLimit& limit, const std::string& root, std::string path,
                       const GroupFiles& files) {
  for (;;) {
    tighten(limit, left_of_group(root + files.mount + path, files), "its control group");
    if (path.empty()) return;
    path.resize(path.find_last_of('/') == std::string::npos ? 0 : path.find_last_of('/'));
  }
}

}  // namespace

MemoryLimit available_memory(const std::string& root) {
  MemoryLimit limit;
  tighten(limit, left_of_machine(root), "the machine");
  tighten(limit, left_of_address_space(root), "its address space (ulimit -v)");
  tighten(limit, left_of_data(root), "its limit of memory (--memory, ulimit -d)");
  std::ifstream groups(root + "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // "5:cpu,memory:/path", version 2: "0::/path"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = fmt::format(",{},", line.substr(first + 1, second - first - 1));
    const std::string path = line.substr(second + 1);
    if (controllers == ",,") tighten_by_groups(limit, root, path, version_2);
    if (controllers.find(",memory,") != std::string::npos) tighten_by_groups(limit, root, path, version_1);
  }
  return limit;
}

void check_memory(std::span<const MemoryNeed> needs, const MemoryLimit& limit) {
  std::uint64_t sum = 0;
  std::vector<std::string> names, advice;
  for (const MemoryNeed& need : needs) {
    sum = need.bytes > UINT64_MAX - sum ? UINT64_MAX : sum + need.bytes;
    names.push_back(fmt::format("{} for {}", bytes_text(need.bytes), need.name));
    if (!need.instead.empty()) advice.push_back(fmt::format("; {}: {}", need.name, need.instead));
  }
  if (sum <= limit.bytes) return;
  throw Error(fmt::format("{} of memory are needed ({}); {} leaves the program {}{}", bytes_text(sum),
                          fmt::join(names, ", "), limit.name, bytes_text(limit.bytes),
                          fmt::join(advice, "")));
}

std::string bytes_text(std::uint64_t bytes) {
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  constexpr std::array units{"kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  double value = double(bytes) / 1000;
  for (; value >= 999.95 && unit + 1 < units.size(); ++unit) value /= 1000;
  return fmt::format("{:.1f} {}", value, units[unit]);
}

}  // namespace twinray
