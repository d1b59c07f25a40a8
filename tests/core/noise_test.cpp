// SPDX-License-Identifier: Apache-2.0
// Numbers of pbrt-v4 are those of its noise.cpp and textures.cpp of commit 5f7a606, compiled by themselves.
#include "core/noise.h"

#include <cmath>
#include <limits>
#include <string>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

Vec3 random_point(Random& random, float size) {
  return {size * (random.unit() - 0.5f), size * (random.unit() - 0.5f), size * (random.unit() - 0.5f)};
}

}  // namespace

TEST_CASE("noise is pbrt-v4's") {
  constexpr struct {
    Vec3 p;
    float value;
  } expected[] = {{{0.172623158f, -1.9338088f, -1.91838932f}, -0.211013153f},
                  {{-1.55015349f, 1.64011788f, 0.539616108f}, 0.100083038f},
                  {{0.384400368f, 0.193395376f, -0.0164425373f}, 0.0443102717f},
                  {{0.975204706f, -1.84058285f, 1.13380146f}, -0.238722414f},
                  {{0.798427582f, -1.7053299f, 1.86323738f}, 0.341803938f},
                  {{1.83808494f, -0.414066076f, -0.15882349f}, 0.373794138f},
                  {{1.97471333f, 1.81105661f, -0.37549901f}, -0.0707652122f},
                  {{-0.000301599503f, -0.308417797f, 0.654802084f}, 0.417482972f},
                  {{52.5956154f, -23.0092945f, -63.8144913f}, -0.0633708239f},
                  {{105.805779f, -123.36924f, -103.408905f}, -0.29792279f},
                  {{-11.1998672f, -147.878815f, -56.5312195f}, -0.157465801f},
                  {{138.683029f, 21.8952827f, -62.4966125f}, -0.265818775f},
                  {{-59.3256531f, 83.9265518f, -145.360382f}, 0.570109248f},
                  {{14.0483017f, 136.496384f, -53.6594162f}, -0.278109908f},
                  {{37.0248718f, 47.0894318f, 50.1786232f}, -0.263029844f},
                  {{80.2267838f, 128.719254f, -101.625183f}, -0.202358544f}};
  for (const auto& [p, value] : expected) CHECK(noise(p) == Approx(value).margin(2e-6));
}

TEST_CASE("noise is smooth, at most 1, 0 at whole points, and repeats after 256") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_point(random, 20);
    const float value = noise(p);
    if (!(std::fabs(value) <= 1)) FAIL("noise of " << value);
    const Vec3 step = random_point(random, 1e-3f);
    if (!(std::fabs(noise(p + step) - value) < 6 * length(step))) FAIL("noise leaps");
  }
  CHECK(noise({3, -7, 200}) == 0);
  CHECK(noise({0.25f + 256, 0.5f - 512, 0.75f}) == noise({0.25f, 0.5f, 0.75f}));
}

TEST_CASE("noise beyond what has whole numbers, and of what is no number, is 0") {
  for (const float far : {0x1p30f, -0x1p30f, 1e38f, inf, nan}) {
    CHECK(noise({far, 0.5f, 0.5f}) == 0);
    CHECK(noise({0.5f, far, 0.5f}) == 0);
    CHECK(noise({0.5f, 0.5f, far}) == 0);
    CHECK(std::isfinite(fbm({0.5f, 0.5f, far}, 0, {64, 0.5f})));
    const Rgb color = marble_color(far);
    CHECK((color.r > 0 && color.r < 1));
  }
}

TEST_CASE("octaves are added up as pbrt-v4 does, as far as the width lets them be seen") {
  constexpr struct {
    Vec3 p;
    float width;
    Octaves octaves;
    float sum, of_sizes;
  } expected[] = {
      {{-1.0093621f, 1.35407853f, -0.257597923f}, 1e-6f, {3, 0.656325817f}, 0.0185781382f, 0.519706607f},
      {{-0.343570232f, 1.56853259f, 0.456317425f}, 1e-6f, {4, 0.402982891f}, 0.202538401f, 0.31648615f},
      {{0.126057744f, 1.03118348f, -0.258293867f},
       0.0144888898f,
       {5, 0.495802015f},
       0.142093614f,
       0.28724736f},
      {{-2.14287114f, 1.45350802f, 2.55385637f},
       0.0359901227f,
       {6, 0.475082427f},
       0.393184066f,
       0.591758788f},
      {{1.77966571f, 1.75882244f, -0.850638986f}, 0.425521642f, {7, 0.359489679f}, 0, 0.512008786f},
      {{1.34085023f, 2.24729681f, -0.57560885f},
       0.0742829666f,
       {8, 0.423859417f},
       0.129892826f,
       0.326755792f},
      {{1.880005f, 2.22001362f, -0.648336053f}, 0.164652929f, {9, 0.71619153f}, -0.286004871f, 0.77715224f},
      {{2.37312698f, 0.169659734f, 1.15348864f},
       0.046739243f,
       {10, 0.76014334f},
       -0.117544994f,
       0.906946778f}};
  for (const auto& [p, width, octaves, sum, of_sizes] : expected) {
    CAPTURE(width);
    CHECK(fbm(p, width, octaves) == Approx(sum).margin(4e-6));
    CHECK(turbulence(p, width, octaves) == Approx(of_sizes).margin(4e-6));
  }
}

TEST_CASE("without a width all octaves are seen, beyond the unit none") {
  constexpr Vec3 p{0.3f, 0.6f, -0.2f};
  CHECK(fbm(p, 0, {1, 0.5f}) == noise(p));
  CHECK(fbm(p, 1e-30f, {2, 0.5f}) == fbm(p, 0, {2, 0.5f}));
  CHECK(fbm(p, 0, {0, 0.5f}) == 0);
  for (const float wide : {1.0f, 1e20f, inf, nan}) {
    CHECK(fbm(p, wide, {8, 0.5f}) == 0);
    CHECK(turbulence(p, wide, {3, 0.5f}) == Approx(0.2 * (1 + 1 + 0.5 + 0.25)));  // As pbrt: one twice.
  }
}

TEST_CASE("marble has pbrt-v4's colours along its phase, which repeat after a turn") {
  constexpr struct {
    float phase;
    Rgb color;
  } expected[] = {{-7.30000019f, {0.859160185f, 0.859160185f, 0.88645041f}},
                  {-1, {0.857091665f, 0.857091665f, 0.883864582f}},
                  {0, {0.75f, 0.75f, 0.75f}},
                  {0.400000006f, {0.884546936f, 0.875915945f, 0.88080883f}},
                  {1.10000002f, {0.616749883f, 0.616749883f, 0.720059216f}},
                  {1.60000002f, {0.867817879f, 0.867817879f, 0.898449659f}},
                  {2.5f, {0.583404541f, 0.583276093f, 0.695927024f}},
                  {40, {0.797580838f, 0.797580838f, 0.848544359f}}};
  for (const auto& [phase, color] : expected)
    for (const float turns : {0.0f, 6.28318531f}) {
      CAPTURE(phase, turns);
      const Rgb found = marble_color(phase + turns);
      CHECK(found.r == Approx(color.r).margin(2e-5));
      CHECK(found.g == Approx(color.g).margin(2e-5));
      CHECK(found.b == Approx(color.b).margin(2e-5));
    }
}

TEST_CASE("dots lie where pbrt-v4's do, and cover the part of the plane that is said") {
  constexpr const char* rows[] = {
      "........####..###..####.###..###..####.#", "...................................#....",
      "##............###.......................", "##............###.......................",
      "........................................", ".......................................#",
      "........................................", ".........###.......###..###.............",
      ".........###.......###..##..............", "........................................",
      "##..###............###.####.............", "....................#..................."};
  for (int t = 0; t < 12; ++t) {
    std::string row;
    for (int s = 0; s < 40; ++s) row += is_in_dot({-3 + float(s) * 0.2f, 2 - float(t) * 0.4f}) ? '#' : '.';
    CHECK(row == rows[t]);
  }
  int inside = 0;
  constexpr int side = 1000;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      inside += is_in_dot({float(i) * 0.0937f - 40, float(j) * 0.1013f - 60}) ? 1 : 0;
  // Of 10,000 squares the error is 0.002.
  CHECK(double(inside) / (side * side) == Approx(part_in_dots).margin(0.006));
}

}  // namespace twinray::test
