// SPDX-License-Identifier: Apache-2.0
// Compiled with several sets of compiler flags, together with the sources of the canonical tests: each
// program checks the table with the code that these flags make. With "write" as its argument it prints the
// rows of canonical_table.inc instead.
#ifdef __ARM_FEATURE_SVE
#include <sys/auxv.h>
#endif

#include <cstdio>
#include <cstring>

#include "tests/accel/canonical_table.h"
#include "tests/support/hostile.h"
#include "tests/support/trace.h"

namespace twinray::test {
namespace {

/// The CPU features that this program was compiled for and this machine lacks, or "".
std::string missing_features() {
  std::string missing;
#ifdef __x86_64__
  __builtin_cpu_init();
#endif
#ifdef __SSE4_2__
  if (!__builtin_cpu_supports("sse4.2")) missing += " sse4.2";
#endif
#ifdef __AVX2__
  if (!__builtin_cpu_supports("avx2")) missing += " avx2";
#endif
#ifdef __FMA__
  if (!__builtin_cpu_supports("fma")) missing += " fma";
#endif
#ifdef __AVX512F__
  if (!__builtin_cpu_supports("avx512f")) missing += " avx512f";
#endif
#ifdef __AVX512DQ__
  if (!__builtin_cpu_supports("avx512dq")) missing += " avx512dq";
#endif
#ifdef __AVX512VL__
  if (!__builtin_cpu_supports("avx512vl")) missing += " avx512vl";
#endif
#ifdef __ARM_FEATURE_SVE
  if (!(getauxval(AT_HWCAP) & HWCAP_SVE)) missing += " sve";
#endif
  return missing;
}

SlabInterval slab_of(const CanonicalRow& row) {
  CheckedRay ray;
  if (!load_ray(ray_of(row), ray)) return {1, 0};
  const float* s = row.shape;
  return intersect_slab(ray, padded({{s[0], s[1], s[2]}, {s[3], s[4], s[5]}}));
}

std::vector<std::string> all_mismatches() {
  std::vector<std::string> wrong = canonical_mismatches(trace_all);
  for (std::size_t i = 0; i < std::size(canonical_rows); ++i) {
    if (canonical_rows[i].kind != 'b') continue;
    const SlabInterval interval = slab_of(canonical_rows[i]);
    if (!has_bits(canonical_rows[i], interval.near, interval.far, 0))
      wrong.push_back("row " + std::to_string(i) + " (b)");
  }
  return wrong;
}

void print_number(float x) {
  if (std::isinf(x))
    std::printf("%sINFINITY, ", x < 0 ? "-" : "");
  else
    std::printf("%af, ", double(x));
}

void print_row(const CanonicalRow& row) {
  std::printf("{'%c', {", row.kind);
  for (const float x : row.shape) print_number(x);
  std::printf("}, {");
  for (const float x : row.ray) print_number(x);
  std::printf("}, ");
  for (const float x : {row.t, row.u, row.v}) print_number(x);
  std::printf("},\n");
}

void fill_shape(CanonicalRow& row, const Corners& v) {
  const Aabb box = triangle_bounds(v[0], v[1], v[2]);
  for (int k = 0; k < 3; ++k) {
    if (row.kind == 'b') {
      row.shape[k] = box.lower[k];
      row.shape[3 + k] = box.upper[k];
    } else {
      for (int corner = 0; corner < 3; ++corner) row.shape[3 * corner + k] = v[std::size_t(corner)][k];
    }
  }
  if (row.kind == 's') {
    row.shape[3] = length(v[1] - v[0]);
    for (int k = 4; k < 9; ++k) row.shape[k] = 0;
  }
}

void write_table(int rows) {
  Random random(81);
  for (int i = 0; i < rows; ++i) {
    const HostilePair pair = hostile_pair(random);
    CanonicalRow row{"ttsb" [i % 4], {}, {}, 0, 0, 0};
    fill_shape(row, pair.corners);
    for (int k = 0; k < 3; ++k) {
      row.ray[k] = pair.ray.origin[k];
      row.ray[3 + k] = pair.ray.direction[k];
    }
    row.ray[7] = pair.ray.t_max;
    if (row.kind == 'b') {
      const SlabInterval interval = slab_of(row);
      row.t = interval.near;
      row.u = interval.far;
    } else {
      const Hit hit = trace_all(geometry_of(row), ray_of(row));
      row.t = hit.t;
      row.u = hit.u;
      row.v = hit.v;
    }
    print_row(row);
  }
}

int check_table() {
  const std::string missing = missing_features();
  if (!missing.empty()) {
    std::printf("did not run: this CPU lacks%s\n", missing.c_str());
    return 0;
  }
  const std::vector<std::string> wrong = all_mismatches();
  for (const std::string& line : wrong) std::printf("%s\n", line.c_str());
  std::printf("%zu rows, %zu with other bits\n", std::size(canonical_rows), wrong.size());
  return wrong.empty() ? 0 : 1;
}

}  // namespace
}  // namespace twinray::test

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "write") == 0) {
    twinray::test::write_table(400);
    return 0;
  }
  return twinray::test::check_table();
}
