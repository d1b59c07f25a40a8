// SPDX-License-Identifier: Apache-2.0
#include "core/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/elementary.h"

namespace twinray {
namespace {

/// The numbers 0 to 255 in Perlin's order: a hash of three numbers by three lookups.
constexpr std::uint8_t permutation[256] = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,
    69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,
    94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136,
    171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122,
    60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161,
    1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196, 135, 130, 116, 188, 159, 86,
    164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126,
    255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213,
    119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,   129, 22,  39,  253,
    19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,  242, 193,
    238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,
    222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180,
};

int permuted(int i) { return permutation[i & 255]; }

/// The product of a vector with the direction of a whole point: one of the twelve from the middle of a cube
/// to those of its edges, of which a hash of sixteen numbers has four twice.
float along_gradient(int x, int y, int z, const Vec3& d) {
  constexpr std::uint8_t edges[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 10, 11};
  const int edge = edges[permuted(permuted(permuted(x) + y) + z) & 15];
  const float u = edge < 8 ? d.x : d.y, v = edge < 4 ? d.y : d.z;
  return ((edge & 1) ? -u : u) + ((edge & 2) ? -v : v);
}

/// From 0 to 1, with first and second derivatives that are 0 at both.
float smooth(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

float smooth_step(float x, float from, float to) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

float lerp(float a, float b, float t) { return a * (1 - t) + b * t; }

/// How many octaves are to be seen: those with waves of at least twice the width, the last one in part.
struct SeenOctaves {
  int whole;
  float part;  ///< Of the one behind them; in [0, 1].

  SeenOctaves(float width, int most) {
    const float seen = !(width < 1)                                ? 0
                       : width < std::numeric_limits<float>::min() ? float(most)
                                                                   : -1 - short_log2_of(width);
    const float count = std::clamp(seen, 0.0f, float(most));
    whole = int(count);
    part = smooth_step(count - float(whole), 0.3f, 0.7f);
  }
};

/// An octave's noise, and the step to the next one.
struct Octave {
  Vec3 p;
  float roughness;
  float finer = 1, strength = 1;

  float value() const { return noise(p * finer); }
  void next() { finer *= 1.99f, strength *= roughness; }
};

}  // namespace

float noise(const Vec3& p) {
  constexpr float most = 0x1p30f;
  if (!(max_abs(p) < most) || !is_finite(p)) return 0;
  const Vec3 corner{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3 d = p - corner;
  const int x = int(corner.x), y = int(corner.y), z = int(corner.z);
  const auto at = [&](int i, int j, int k) {
    return along_gradient(x + i, y + j, z + k, {d.x - float(i), d.y - float(j), d.z - float(k)});
  };
  const float s = smooth(d.x), t = smooth(d.y);
  const auto plane = [&](int k) {
    return lerp(lerp(at(0, 0, k), at(1, 0, k), s), lerp(at(0, 1, k), at(1, 1, k), s), t);
  };
  return lerp(plane(0), plane(1), smooth(d.z));
}

float fbm(const Vec3& p, float width, const Octaves& octaves) {
  const SeenOctaves seen(width, octaves.most);
  Octave octave{p, octaves.roughness};
  float sum = 0;
  for (int i = 0; i < seen.whole; ++i, octave.next()) sum += octave.strength * octave.value();
  return seen.part > 0 ? sum + octave.strength * seen.part * octave.value() : sum;
}

float turbulence(const Vec3& p, float width, const Octaves& octaves) {
  constexpr float mean = 0.2f;
  const SeenOctaves seen(width, octaves.most);
  Octave octave{p, octaves.roughness};
  float sum = 0;
  for (int i = 0; i < seen.whole; ++i, octave.next()) sum += octave.strength * std::fabs(octave.value());
  sum += octave.strength * lerp(mean, std::fabs(octave.value()), seen.part);
  for (int i = seen.whole; i < octaves.most; ++i, octave.next()) sum += octave.strength * mean;
  return sum;
}

bool is_in_dot(Vec2 st) {
  constexpr float radius = 0.35f, most_shift = 0.5f - radius;
  const float s = std::floor(st.x + 0.5f), t = std::floor(st.y + 0.5f);
  const auto number = [&](float along_s, float along_t) { return noise({s + along_s, t + along_t, 0.5f}); };
  if (!(number(0.5f, 0.5f) > 0)) return false;
  const float ds = st.x - (s + most_shift * number(1.5f, 2.8f));
  const float dt = st.y - (t + most_shift * number(4.5f, 9.8f));
  return ds * ds + dt * dt < radius * radius;
}

Rgb marble_color(float phase) {
  constexpr Rgb light{0.58f, 0.58f, 0.6f};
  constexpr Rgb colors[] = {
      light, light, light, {0.5f, 0.5f, 0.5f}, {0.6f, 0.59f, 0.58f}, light, light, {0.2f, 0.2f, 0.33f},
      light};
  constexpr int pieces = 6;  // Each a cubic Bézier curve of four colours in a row.
  if (!std::isfinite(phase)) return light * 1.5f;
  const double turns = double(phase) * turns_per_radian;
  const float along = (0.5f + 0.5f * sincos_turns(float(turns - std::floor(turns))).sin) * pieces;
  const int first = std::clamp(int(along), 0, pieces - 1);
  const float t = along - float(first);
  const auto mix = [t](const Rgb& a, const Rgb& b) { return a * (1 - t) + b * t; };
  const Rgb* const c = colors + first;
  const Rgb middle = mix(c[1], c[2]);
  const Rgb left = mix(mix(c[0], c[1]), middle), right = mix(middle, mix(c[2], c[3]));
  return mix(left, right) * 1.5f;
}

}  // namespace twinray
