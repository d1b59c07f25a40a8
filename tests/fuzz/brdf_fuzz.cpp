// SPDX-License-Identifier: Apache-2.0
// The reader of measured materials on any bytes: a material whose light is finite and not negative, or an
// Error that names the file.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "io/measured/brdf_file.h"
#include "tests/fuzz/require.h"

namespace {

bool is_usable(const twinray::Rgb& c, float pdf) {
  return is_finite(c) && c.r >= 0 && c.g >= 0 && c.b >= 0 && pdf >= 0 && std::isfinite(pdf);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using twinray::Vec3;
  try {
    const twinray::MeasuredBrdf brdf =
        twinray::read_brdf_file({reinterpret_cast<const char*>(data), size}, "input.bsdf");
    for (const Vec3& wo : {Vec3{0, 0, 1}, Vec3{0.6f, 0, 0.8f}, Vec3{-0.6f, 0.7999f, 0.014f}}) {
      for (const Vec3& wi : {Vec3{0, 0, 1}, Vec3{0, -0.6f, 0.8f}, Vec3{-0.9998f, 0, 0.02f}}) {
        const auto [value, pdf] = brdf.evaluate(wo, wi);
        twinray::fuzz::require(is_usable(value, pdf));
      }
      for (const twinray::Vec2 u : {twinray::Vec2{0, 0}, twinray::Vec2{0.3f, 0.999f}}) {
        const twinray::BsdfSample sample = brdf.sample(wo, u);
        twinray::fuzz::require(is_usable(sample.value, sample.pdf));
      }
    }
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with("input.bsdf: "));
  }
  return 0;
}
