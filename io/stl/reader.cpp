// SPDX-License-Identifier: Apache-2.0
#include "io/stl/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>

#include "core/geometry.h"
#include "io/byte_order_mark.h"
#include "io/lower_case.h"
#include "io/stl/ascii.h"

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little, "a file's numbers are copied as they are");

/// A binary file: a title, the count of triangles, and of each its normal, its vertices and two bytes more.
constexpr std::size_t title_bytes = 80, head_bytes = title_bytes + 4, triangle_bytes = 50, normal_bytes = 12;

/// How many triangles the head of a binary file says that there are.
std::size_t count_of(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + title_bytes, sizeof count);
  return count;
}

/// Binary files may begin with the word of a text, but not go on like one: there are zeros in their count.
bool looks_like_text(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 512);
  const std::size_t begin = head.find_first_not_of(" \t\r\n");
  return begin != head.npos && lower_case(std::string(head.substr(begin, 5))) == "solid" &&
         head.find('\0') == head.npos;
}

void read_binary(std::string_view bytes, const std::string& path, ObjModel& model) {
  const auto fail = [&](const std::string& reason) {
    throw Error(fmt::format(
        "{}: the file is neither ASCII STL, which begins with \"solid\", nor binary STL: {}", path, reason));
  };
  if (bytes.size() < head_bytes) fail(fmt::format("it has less than {} bytes", head_bytes));
  const std::size_t count = count_of(bytes), whole = (bytes.size() - head_bytes) / triangle_bytes;
  if (count > whole) fail(fmt::format("its head says {} triangles, and it has bytes for {}", count, whole));
  ObjFaces& faces = model.faces.emplace_back();
  faces.sizes.assign(count, 3);
  std::size_t marked = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const char* const at = bytes.data() + head_bytes + triangle_bytes * i;
    std::array<Vec3, 3> corners;
    static_assert(sizeof corners == 36);
    std::memcpy(&corners, at + normal_bytes, sizeof corners);
    std::uint16_t mark = 0;
    std::memcpy(&mark, at + normal_bytes + sizeof corners, sizeof mark);
    marked += mark != 0;
    for (const Vec3& corner : corners) {
      if (!is_finite(corner) || max_abs(corner) > max_coordinate)
        throw Error(fmt::format("{}: a coordinate of triangle {} lies beyond +-{:g}, or is no number", path,
                                i + 1, max_coordinate));
      faces.corners.push_back({std::uint32_t(model.positions.size())});
      model.positions.push_back(corner);
    }
  }
  if (marked > 0)
    model.notes.push_back(
        fmt::format("attributes of triangles (colors, in some programs), left out: {}", marked));
  const std::size_t rest = bytes.size() - head_bytes - triangle_bytes * count;
  if (rest > 0) model.notes.push_back(fmt::format("bytes behind the last triangle, left out: {}", rest));
}

}  // namespace

ObjModel read_stl(std::string_view bytes, const std::string& path, WarningList& warnings) {
  if (bytes.empty()) throw Error(path + ": the file is empty");
  ObjModel model;
  model.name = std::filesystem::path(path).stem().string();
  const std::string_view text = without_mark(bytes);
  if (looks_like_text(text))
    read_ascii_stl(text, path, warnings, model);
  else
    read_binary(bytes, path, model);
  std::erase_if(model.faces, [](const ObjFaces& faces) { return faces.sizes.empty(); });
  if (model.faces.empty()) throw Error(path + ": the file has no triangles");
  return model;
}

}  // namespace twinray
