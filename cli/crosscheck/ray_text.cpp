// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck/ray_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/error.h"

namespace twinray {
namespace {

constexpr int number_count = 8;

/// The number that `text` is as a whole; false if it is none.
bool parse_float(std::string_view text, float& value) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  auto format = std::chars_format::general;
  if (text.starts_with("0x")) {
    text.remove_prefix(2);
    format = std::chars_format::hex;
  }
  if (text.empty() || text.front() == '-') return false;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, format);
  if (is_negative) value = -value;
  return error == std::errc() && end == text.data() + text.size();
}

/// Whether the components lie within +-most.
bool is_within(const Vec3& v, float most) {
  return std::fabs(v.x) <= most && std::fabs(v.y) <= most && std::fabs(v.z) <= most;
}

/// An invalid ray (core/ray.h) would be a miss on every engine, and say nothing.
void check_domain(const Ray& ray) {
  if (!is_within(ray.origin, 0x1p60f))
    throw UsageError("--ray: the origin must be finite, with components up to 2^60");
  if (!is_within(ray.direction, std::numeric_limits<float>::max()) || ray.direction == Vec3{0, 0, 0})
    throw UsageError("--ray: the direction must be finite and not zero");
  if (!(ray.t_min >= 0 && ray.t_min <= ray.t_max))
    throw UsageError("--ray: the interval must have 0 <= t_min <= t_max");
}

}  // namespace

std::string ray_text(const Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  return fmt::format("{:a},{:a},{:a},{:a},{:a},{:a},{:a},{:a}", o.x, o.y, o.z, d.x, d.y, d.z, ray.t_min,
                     ray.t_max);
}

Ray parse_ray(const std::string& text) {
  float numbers[number_count] = {};
  std::string_view rest = text;
  for (int i = 0; i < number_count; ++i) {
    const std::size_t comma = rest.find(',');
    const bool is_last = i == number_count - 1;
    if ((comma == rest.npos) != is_last || !parse_float(rest.substr(0, comma), numbers[i]))
      throw UsageError(fmt::format("--ray: \"{}\" is not of the form OX,OY,OZ,DX,DY,DZ,T_MIN,T_MAX", text));
    rest.remove_prefix(is_last ? rest.size() : comma + 1);
  }
  const Ray ray{.origin = {numbers[0], numbers[1], numbers[2]},
                .direction = {numbers[3], numbers[4], numbers[5]},
                .t_min = numbers[6],
                .t_max = numbers[7]};
  check_domain(ray);
  return ray;
}

std::string primitive_text(std::uint32_t mesh, std::uint32_t primitive, std::uint32_t instance) {
  const std::string text = fmt::format("{}:{}", mesh, primitive);
  return instance == no_instance ? text : fmt::format("{} of instance {}", text, instance);
}

}  // namespace twinray
