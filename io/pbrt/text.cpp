// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/text.h"

#include <fmt/format.h>

namespace twinray {

std::string pbrt_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text)
    if (c == '\n')
      quoted += "\\n";
    else
      (c == '"' || c == '\\' ? quoted += '\\' : quoted) += c;
  return quoted + "\"";
}

std::string pbrt_real(std::string_view name, float value) {
  return fmt::format(" \"float {}\" [ {} ]", name, value);
}
std::string pbrt_integer(std::string_view name, int value) {
  return fmt::format(" \"integer {}\" [ {} ]", name, value);
}
std::string pbrt_flag(std::string_view name, bool value) {
  return fmt::format(" \"bool {}\" [ {} ]", name, value);
}
std::string pbrt_rgb(std::string_view name, const Rgb& value) {
  return fmt::format(" \"rgb {}\" [ {} {} {} ]", name, value.r, value.g, value.b);
}
std::string pbrt_point(std::string_view name, const Vec3& value) {
  return fmt::format(" \"point3 {}\" [ {} {} {} ]", name, value.x, value.y, value.z);
}
std::string pbrt_vector(std::string_view name, const Vec3& value) {
  return fmt::format(" \"vector3 {}\" [ {} {} {} ]", name, value.x, value.y, value.z);
}
std::string pbrt_word(std::string_view name, std::string_view value) {
  return fmt::format(" \"string {}\" [ {} ]", name, pbrt_string(value));
}
std::string pbrt_texture(std::string_view name, std::string_view texture) {
  return fmt::format(" \"texture {}\" [ {} ]", name, pbrt_string(texture));
}

std::string pbrt_transform(const Transform& transform) {
  std::string text = "Transform [";
  for (int column = 0; column < 4; ++column) {
    for (const auto& row : transform.m) text += fmt::format(" {}", row[column]);
    text += column < 3 ? " 0" : " 1";
  }
  return text + " ]\n";
}

std::string pbrt_comment(std::string_view text) {
  std::string line = "# ";
  for (const char c : text) line += c == '\n' || c == '\r' ? ' ' : c;
  return line + "\n";
}

}  // namespace twinray
