// SPDX-License-Identifier: Apache-2.0
// What a grid says is believed nowhere: all reads are checked against its end (0 is read beyond), and no more
// nodes are visited than have room in it.
#include "io/nanovdb/grid.h"

#define PNANOVDB_C
#define PNANOVDB_BUF_BOUNDS_CHECK
#include <nanovdb/PNanoVDB.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/memory.h"

namespace twinray {
namespace {

using Index = std::array<std::int64_t, 3>;

/// The coordinates within a node of its child or value number n; so many bits of n are those of one axis.
Index place_of(std::uint32_t n, int bits) {
  const std::uint32_t mask = (1u << bits) - 1;
  return {std::int64_t(n >> 2 * bits & mask), std::int64_t(n >> bits & mask), std::int64_t(n & mask)};
}

Index sum(const Index& a, const Index& b, std::int64_t factor = 1) {
  return {a[0] + b[0] * factor, a[1] + b[1] * factor, a[2] + b[2] * factor};
}

/// What there is of values: cubes with the same value everywhere, or leaves.
struct Part {
  Index origin{};
  std::int64_t width = 0;
  float value = 0;               ///< Of a cube.
  pnanovdb_address_t leaf = {};  ///< Of a leaf,
  bool is_leaf = false;          ///< if it is one.
};

/// What `make` makes; where it throws Error, the message begins with the place.
template <typename Make>
auto made_in(const std::string& place, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", place, error.what()));
  }
}

class GridReader {
 public:
  GridReader(std::vector<std::uint64_t>& bytes, const std::string& place)
      : bytes_(bytes.size() * 8),
        place_(place),
        buffer_(pnanovdb_make_buf(reinterpret_cast<std::uint32_t*>(bytes.data()), bytes.size() * 2)) {
    const std::uint32_t type = pnanovdb_grid_get_grid_type(buffer_, grid_);
    constexpr std::uint32_t known[] = {PNANOVDB_GRID_TYPE_FLOAT, PNANOVDB_GRID_TYPE_FP4,
                                       PNANOVDB_GRID_TYPE_FP8, PNANOVDB_GRID_TYPE_FP16,
                                       PNANOVDB_GRID_TYPE_FPN};
    if (std::ranges::find(known, type) == std::end(known))
      fail(fmt::format("its values are of the type {}; valid are Float, Fp4, Fp8, Fp16 and FpN",
                       type_name(type)));
    type_ = type;
    const std::uint32_t kind = pnanovdb_grid_get_grid_class(buffer_, grid_);
    if (kind != PNANOVDB_GRID_CLASS_UNKNOWN && kind != PNANOVDB_GRID_CLASS_FOG_VOLUME)
      fail("it is a level set, or of another class than a fog volume");
    find_parts();
  }

  NvdbGrid read(const Transform& to_world) const {
    const std::uint64_t brick_bytes = 9 * 9 * 9 * sizeof(float);
    std::uint64_t bricks = 0;
    Index low, high;
    low.fill(std::numeric_limits<std::int64_t>::max());
    high.fill(std::numeric_limits<std::int64_t>::min());
    for (const Part& part : parts_) {
      const std::uint64_t edge = std::uint64_t(part.width) / 8;
      bricks += edge * edge * edge;
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], part.origin[k]);
        high[k] = std::max(high[k], part.origin[k] + part.width);
      }
    }
    if (parts_.empty()) low.fill(0), high.fill(0);
    // A brick's neighbours have the points between them, too. Around it all the numbers fall to 0.
    check_memory(
        std::vector<MemoryNeed>{{fmt::format("the densities of {}", place_), 2 * bricks * brick_bytes, ""}});
    DensityGrid::Size size{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] -= 1, high[k] += 1;
      size[k] = int(std::min<std::int64_t>(high[k] - low[k], std::numeric_limits<int>::max()));
    }
    NvdbGrid made;
    const auto grid =
        made_in(place_, [&] { return std::make_shared<DensityGrid>(size, unit_of(low, size, to_world)); });
    for (const Part& part : parts_) fill(part, low, *grid, made.negative);
    made.densities = grid;
    return made;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}: {}", place_, what)); }
  static std::string type_name(std::uint32_t type) {
    constexpr const char* names[] = {"Unknown", "Float", "Double", "Int16",  "Int32",   "Int64", "Vec3f",
                                     "Vec3d",   "Mask",  "Half",   "UInt32", "Boolean", "RGBA8"};
    return type < std::size(names) ? names[type] : fmt::format("number {}", type);
  }

  /// Counts a node of this many bytes; a grid in which nodes overlap is damaged.
  void visit(std::uint64_t size) {
    visited_ += size;
    if (visited_ > bytes_) fail("its nodes are more than its bytes: the grid is damaged");
  }
  void add_tile(const Index& origin, std::int64_t width, pnanovdb_address_t value) {
    const float number = pnanovdb_read_float(buffer_, value);
    if (number != 0) parts_.push_back({origin, width, number, {}, false});
  }

  void find_parts() {
    const pnanovdb_root_handle_t root =
        pnanovdb_tree_get_root(buffer_, pnanovdb_grid_get_tree(buffer_, grid_));
    const std::uint32_t tiles = pnanovdb_root_get_tile_count(buffer_, root);
    const auto& sizes = pnanovdb_grid_type_constants[type_];
    for (std::uint32_t i = 0; i < tiles; ++i) {
      visit(sizes.root_tile_size);
      const pnanovdb_root_tile_handle_t tile = pnanovdb_root_get_tile(type_, root, i);
      const std::uint64_t key = pnanovdb_root_tile_get_key(buffer_, tile);
      constexpr std::uint64_t mask = (1 << 21) - 1;
      const auto coordinate = [&](int shift) {
        return std::int64_t(std::int32_t(std::uint32_t(key >> shift & mask) << 12));
      };
      const Index origin{coordinate(42), coordinate(21), coordinate(0)};
      if (pnanovdb_int64_is_zero(pnanovdb_root_tile_get_child(buffer_, tile)))
        add_tile(origin, 4096, pnanovdb_root_tile_get_value_address(type_, buffer_, tile));
      else
        find_in_upper(origin, pnanovdb_root_get_child(type_, buffer_, root, tile));
    }
  }
  void find_in_upper(const Index& origin, pnanovdb_upper_handle_t upper) {
    visit(pnanovdb_grid_type_constants[type_].upper_size);
    for (std::uint32_t n = 0; n < 1u << 15; ++n) {
      const Index at = sum(origin, place_of(n, 5), 128);
      if (pnanovdb_upper_get_child_mask(buffer_, upper, n))
        find_in_lower(at, pnanovdb_upper_get_child(type_, buffer_, upper, n));
      else
        add_tile(at, 128, pnanovdb_upper_get_table_address(type_, buffer_, upper, n));
    }
  }
  void find_in_lower(const Index& origin, pnanovdb_lower_handle_t lower) {
    visit(pnanovdb_grid_type_constants[type_].lower_size);
    for (std::uint32_t n = 0; n < 1u << 12; ++n) {
      const Index at = sum(origin, place_of(n, 4), 8);
      if (!pnanovdb_lower_get_child_mask(buffer_, lower, n)) {
        add_tile(at, 8, pnanovdb_lower_get_table_address(type_, buffer_, lower, n));
        continue;
      }
      visit(type_ == PNANOVDB_GRID_TYPE_FPN ? 96 : pnanovdb_grid_type_constants[type_].leaf_size);
      parts_.push_back({at, 8, 0, pnanovdb_lower_get_child(type_, buffer_, lower, n).address, true});
    }
  }

  float leaf_value(pnanovdb_address_t leaf, std::uint32_t n) const {
    const pnanovdb_leaf_handle_t handle{leaf};
    const Index place = place_of(n, 3);
    const pnanovdb_coord_t at{int(place[0]), int(place[1]), int(place[2])};
    if (type_ == PNANOVDB_GRID_TYPE_FLOAT)
      return pnanovdb_read_float(buffer_, pnanovdb_leaf_get_table_address(type_, buffer_, handle, n));
    const pnanovdb_address_t table = pnanovdb_leaf_get_table_address(type_, buffer_, handle, 0);
    if (type_ == PNANOVDB_GRID_TYPE_FP4) return pnanovdb_leaf_fp4_read_float(buffer_, table, &at);
    if (type_ == PNANOVDB_GRID_TYPE_FP8) return pnanovdb_leaf_fp8_read_float(buffer_, table, &at);
    if (type_ == PNANOVDB_GRID_TYPE_FP16) return pnanovdb_leaf_fp16_read_float(buffer_, table, &at);
    constexpr std::uint32_t most_log_bits = 4;
    if (pnanovdb_leaf_get_bbox_dif_and_flags(buffer_, handle) >> 29 > most_log_bits)
      fail("a leaf of it has values of more than 16 bits: the grid is damaged");
    return pnanovdb_leaf_fpn_read_float(buffer_, table, &at);
  }

  void fill(const Part& part, const Index& low, DensityGrid& grid, std::size_t& negative) const {
    for (std::int64_t x = 0; x < part.width; ++x)
      for (std::int64_t y = 0; y < part.width; ++y)
        for (std::int64_t z = 0; z < part.width; ++z) {
          float value = part.is_leaf ? leaf_value(part.leaf, std::uint32_t(x << 6 | y << 3 | z)) : part.value;
          if (value < 0) value = 0, ++negative;
          const Index at = sum(sum(part.origin, {x, y, z}), low, -1);
          made_in(place_, [&] { grid.set(int(at[0]), int(at[1]), int(at[2]), value); });
        }
  }

  /// Takes the scene's space to the one of the box: values stand at the middles of its cells.
  Transform unit_of(const Index& low, const DensityGrid::Size& size, const Transform& to_world) const {
    const pnanovdb_map_handle_t map = pnanovdb_grid_get_map(buffer_, grid_);
    Transform from_index;
    for (std::uint32_t row = 0; row < 3; ++row) {
      for (std::uint32_t column = 0; column < 3; ++column)
        from_index.m[row][column] = pnanovdb_map_get_matd(buffer_, map, 3 * row + column);
      from_index.m[row][3] = pnanovdb_map_get_vecd(buffer_, map, row);
    }
    const auto side = [&](std::size_t k) { return double(low[k]) - 0.5; };
    const Transform box = to_world * from_index * Transform::translation(side(0), side(1), side(2)) *
                          Transform::scaling(size[0], size[1], size[2]);
    if (!(std::fabs(box.determinant()) > 0) || !std::isfinite(box.determinant()))
      throw Error("it lies in a box that is flat or too large");
    return box.inverse();
  }

  std::uint64_t bytes_, visited_ = 0;
  std::string place_;
  pnanovdb_buf_t buffer_;
  pnanovdb_grid_handle_t grid_{};
  std::uint32_t type_ = 0;
  std::vector<Part> parts_;
};

}  // namespace

NvdbGrid read_nvdb_grid(const NvdbFile& file, std::string_view name, const Transform& to_world) {
  std::vector<std::uint64_t> bytes = file.grid(name);
  return GridReader(bytes, fmt::format("{}: the grid \"{}\"", file.name(), name)).read(to_world);
}

}  // namespace twinray
