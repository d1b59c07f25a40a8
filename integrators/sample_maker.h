// SPDX-License-Identifier: Apache-2.0
// Private: from pixels to the records of their samples, in a scene that stands still.
#pragma once
#include <span>

#include "core/camera.h"
#include "core/record.h"
#include "core/visible_pixels.h"
#include "integrators/camera_interiors.h"
#include "integrators/integrator.h"
#include "integrators/render_options.h"
#include "integrators/traced_scene.h"
#include "integrators/tracer.h"
#include "integrators/wave/camera_stage.h"

namespace twinray {

class SampleMaker {
 public:
  /// All must outlive it. Throws Error for a filter out of range.
  SampleMaker(const TracedScene& of, const RenderOptions& options);

  const Accelerator& accelerator() const { return of_.accelerator; }
  /// Whether a camera ray of the pixel may see something; else it is black for certain.
  bool may_see(int x, int y) const { return contains(visible_pixels_, x, y); }
  /// Fills the records, records.color()[i] and so on with what sample i brings, times its weight; there is
  /// room for as many camera samples. From any thread.
  void make(std::span<const PixelSample> samples, std::span<CameraSample> camera_samples, Tracer& tracer,
            const RecordSpans& records) const;

 private:
  void sample_lights(std::span<const CameraSample> camera_samples, Tracer& tracer,
                     const RecordSpans& records) const;

  TracedScene of_;
  SamplerKind sampler_;
  Camera camera_;  ///< Of the full frame.
  CameraStage camera_stage_;
  CameraInteriors camera_interiors_;
  PixelRect visible_pixels_;
};

}  // namespace twinray
