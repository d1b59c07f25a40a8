// SPDX-License-Identifier: Apache-2.0
#include "integrators/path.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/light_set.h"
#include "integrators/layer_records.h"
#include "integrators/path_reference.h"
#include "integrators/wave/path_wave.h"

namespace twinray {
namespace {

/// The arrays of the calling thread's waves: made once, since they are larger than what they serve is long.
Wave& arrays_of_this_thread() {
  static thread_local const std::unique_ptr<Wave> wave = [] {
    auto made = std::make_unique<Wave>();
    for (std::vector<Ray>* const rays : {&made->rays, &made->connections.rays}) rays->resize(wave_size);
    for (std::vector<Hit>* const hits : {&made->hits, &made->connections.hits}) hits->resize(wave_size);
    return made;
  }();
  return *wave;
}

}  // namespace

/// What waves of this scene and these options share.
class PathIntegrator::Waves {
 public:
  Waves(const Scene& scene, const PathOptions& options, const std::string& simd)
      : reference(scene, options),
        stages(wave_stages_of(simd)),
        options_(options),
        shapes_(shape_table(scene)),
        patches_(patch_tables(scene, reference.transport().lights)),
        lamps_(lamp_table(scene, reference.transport().lights)),
        has_interiors_(std::any_of(scene.materials.begin(), scene.materials.end(), has_interior)),
        has_flights_(has_flights(scene.materials)),
        has_uneven_glow_(has_uneven_glow(scene.materials)),
        has_bodies_(std::any_of(scene.materials.begin(), scene.materials.end(), has_subsurface)),
        has_environment_(has_environment(scene)),
        exceeds_cache_(exceeds_cache(*scene.geometry)),
        has_second_uvs_(has_second_uvs(scene)),
        has_placed_textures_(has_placed_textures(scene)) {}

  WaveContext context() const {
    return {.stages = *stages,
            .options = options_,
            .transport = reference.transport(),
            .passages = reference.passages(),
            .bsdfs = reference.bsdfs(),
            .shapes = shapes_,
            .patches = patches_,
            .lamps = lamps_,
            .has_interiors = has_interiors_,
            .has_flights = has_flights_,
            .has_uneven_glow = has_uneven_glow_,
            .has_bodies = has_bodies_,
            .has_environment = has_environment_,
            .prefetches = exceeds_cache_,
            .has_second_uvs = has_second_uvs_,
            .has_placed_textures = has_placed_textures_};
  }

  const PathReference reference;
  const std::optional<WaveStages> stages;

 private:
  const PathOptions options_;
  const std::vector<ShapeEntry> shapes_;
  const std::vector<PatchTable> patches_;
  const std::vector<Lamp> lamps_;
  const bool has_interiors_, has_flights_, has_uneven_glow_, has_bodies_, has_environment_, exceeds_cache_,
      has_second_uvs_, has_placed_textures_;
};

PathIntegrator::PathIntegrator(const Scene& scene, const PathOptions& options, const std::string& simd)
    : waves_(std::make_unique<const Waves>(scene, options, simd)) {}
PathIntegrator::~PathIntegrator() = default;

void PathIntegrator::sample(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
                            const RecordSpans& records) const {
  if (!waves_->stages) return waves_->reference.sample(samples, kind, tracer, records);
  const WaveContext context = waves_->context();
  for (std::size_t first = 0; first < samples.size(); first += wave_size) {
    const std::size_t size = std::min(wave_size, samples.size() - first);
    PathWave(context, kind, tracer, arrays_of_this_thread(), samples.subspan(first, size),
             records.part(first, size))
        .trace();
  }
}

}  // namespace twinray
