// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/fuzz.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/warp.h"

namespace twinray {
namespace {

constexpr float least_roughness = 0.25f;
constexpr int table_rows = 12, table_columns = 16;

/// Reflectance by 1200^2 directions: row i has roughness 0.25 + 0.75 i / (table_rows - 1), column j has
/// sqrt(cosine) = j / (table_columns - 1); tests/core/fuzz_test.cpp integrates it again.
// clang-format off
constexpr float table[table_rows][table_columns] = {
{0.9363f, 0.9058f, 0.8457f, 0.7739f, 0.6972f, 0.6193f, 0.5423f, 0.4676f,
  0.3961f, 0.3285f, 0.2654f, 0.2073f, 0.1545f, 0.1073f, 0.0661f, 0.0313f},
 {0.861f, 0.835f, 0.7835f, 0.7221f, 0.6564f, 0.5895f, 0.523f, 0.458f,
  0.3952f, 0.3351f, 0.2781f, 0.2243f, 0.1741f, 0.1277f, 0.0853f, 0.0471f},
 {0.8087f, 0.7855f, 0.7397f, 0.6851f, 0.6268f, 0.5672f, 0.5079f, 0.4497f,
  0.3932f, 0.3386f, 0.2862f, 0.2362f, 0.1886f, 0.1437f, 0.1014f, 0.0619f},
 {0.7699f, 0.7487f, 0.707f, 0.6573f, 0.6042f, 0.55f, 0.4959f, 0.4427f,
  0.3908f, 0.3405f, 0.2918f, 0.2449f, 0.1998f, 0.1565f, 0.115f, 0.0752f},
 {0.74f, 0.7204f, 0.6817f, 0.6356f, 0.5864f, 0.5361f, 0.486f, 0.4367f,
  0.3885f, 0.3415f, 0.2959f, 0.2516f, 0.2087f, 0.167f, 0.1265f, 0.0871f},
 {0.7162f, 0.6977f, 0.6613f, 0.6181f, 0.5719f, 0.5248f, 0.4778f, 0.4315f,
  0.3862f, 0.342f, 0.2989f, 0.2569f, 0.2159f, 0.1758f, 0.1364f, 0.0977f},
 {0.6968f, 0.6792f, 0.6447f, 0.6037f, 0.5599f, 0.5154f, 0.4709f, 0.4271f,
  0.3842f, 0.3422f, 0.3012f, 0.2612f, 0.2219f, 0.1832f, 0.1451f, 0.1071f},
 {0.6806f, 0.6637f, 0.6307f, 0.5916f, 0.5498f, 0.5073f, 0.465f, 0.4232f,
  0.3823f, 0.3422f, 0.3031f, 0.2647f, 0.2269f, 0.1896f, 0.1526f, 0.1155f},
 {0.6669f, 0.6507f, 0.6189f, 0.5813f, 0.5412f, 0.5004f, 0.4598f, 0.4198f,
  0.3806f, 0.3422f, 0.3046f, 0.2676f, 0.2312f, 0.1952f, 0.1592f, 0.123f},
 {0.6552f, 0.6394f, 0.6087f, 0.5724f, 0.5337f, 0.4944f, 0.4553f, 0.4168f,
  0.379f, 0.342f, 0.3058f, 0.2701f, 0.235f, 0.2f, 0.1651f, 0.1298f},
 {0.645f, 0.6297f, 0.5999f, 0.5647f, 0.5272f, 0.4892f, 0.4513f, 0.4141f,
  0.3776f, 0.3418f, 0.3068f, 0.2723f, 0.2382f, 0.2043f, 0.1703f, 0.1359f},
 {0.636f, 0.6212f, 0.5922f, 0.5579f, 0.5215f, 0.4845f, 0.4478f, 0.4117f,
  0.3763f, 0.3416f, 0.3076f, 0.2742f, 0.2411f, 0.2082f, 0.175f, 0.1414f}};
constexpr float averages[table_rows] = {0.1708f, 0.185f, 0.1962f, 0.2052f, 0.2126f, 0.2188f,
    0.224f, 0.2286f, 0.2326f, 0.236f, 0.2391f, 0.2419f};
// clang-format on

}  // namespace

Fuzz::Fuzz(float roughness) {
  const float bounded = std::clamp(roughness, least_roughness, 1.0f);
  exponent_ = 1 / bounded;
  row_ = (bounded - least_roughness) / (1 - least_roughness) * float(table_rows - 1);
  const int first = std::min(int(row_), table_rows - 2);
  average_ = averages[first] + (averages[first + 1] - averages[first]) * (row_ - float(first));
}

float Fuzz::evaluate(const Vec3& wo, const Vec3& wi) const {
  const float cosine = normalize(wo + wi).z;
  const float squared_sine = std::max(0.0f, 1 - cosine * cosine);
  if (squared_sine < 1e-30f) return 0;
  const float density = (2 + exponent_) * exp_of(0.5f * exponent_ * log_of(squared_sine)) / (2 * pi);
  return density / (4 * (wo.z + wi.z - wo.z * wi.z));
}

float Fuzz::reflectance(float cosine) const {
  const float column = std::sqrt(std::clamp(cosine, 0.0f, 1.0f)) * float(table_columns - 1);
  const int i = std::min(int(row_), table_rows - 2), j = std::min(int(column), table_columns - 2);
  const float y = row_ - float(i), x = column - float(j);
  const float low = table[i][j] + (table[i][j + 1] - table[i][j]) * x;
  const float high = table[i + 1][j] + (table[i + 1][j + 1] - table[i + 1][j]) * x;
  return low + (high - low) * y;
}

}  // namespace twinray
