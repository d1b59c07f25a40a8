// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "accel/accelerator.h"
#include "integrators/path_reference.h"

namespace twinray::test {

/// The records of samples that are spread over the camera's frame, by the path tracer that traces one path
/// after the other.
inline Records traced_records(const Scene& scene, const PathOptions& path, const FilmContents& contents,
                              std::uint32_t count) {
  std::vector<CameraSample> samples;
  for (std::uint32_t i = 0; i < count; ++i)
    samples.push_back(
        {camera_ray(scene.camera, {float(i % 17) / 17, float(i) / float(count)}, {}), {7, i, 1, 2}, {}});
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  Tracer tracer(*engine, false);
  Records records(contents, count);
  PathReference(scene, path).sample(samples, SamplerKind::independent, tracer, records.spans(count));
  return records;
}

}  // namespace twinray::test
