// SPDX-License-Identifier: Apache-2.0
// Which paths of a wave go on: those that have hit something, may be scattered again or may find light, and
// survive roulette. What is known of them moves up to the front of the columns.
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::drop_ended() {
  const bool has_limits = context_.options.limits.are_any();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < paths_.size; ++i) {
    wave_.kept[kept] = std::uint32_t(i);
    kept += !wave_.hits[i].is_miss() && !(has_limits && has_ended(i));
  }
  if (kept == paths_.size) return;
  for (std::size_t k = 0; k < kept; ++k) wave_.hits[k] = wave_.hits[wave_.kept[k]];
  if (context_.has_flights)
    for (std::size_t k = 0; k < kept; ++k) wave_.rays[k] = wave_.rays[wave_.kept[k]];
  compact(kept);
}

void PathWave::count_bounces() {
  for (std::size_t i = 0; i < paths_.size; ++i) paths_.bounces[i] += one_bounce(ScatterKind(wave_.kind[i]));
}

std::size_t PathWave::keep_light_seekers(std::size_t kept, bool is_last) {
  std::size_t seeking = 0;
  for (std::size_t k = 0; k < kept; ++k) {
    const std::uint32_t i = wave_.kept[k];
    wave_.kept[seeking] = i;
    const bool goes_on = !is_last && !has_ended(i);
    seeking += goes_on || twinray::may_find_light(context_.transport, departure_from(i));
  }
  return seeking;
}

std::size_t PathWave::play_roulette(std::size_t kept) {
  const Roulette& roulette = context_.options.roulette;
  draw(Purpose::roulette, {}, wave_.ux, wave_.uy);
  draw_roulette_of_walks();
  std::size_t surviving = 0;
  for (std::size_t k = 0; k < kept; ++k) {
    const std::size_t i = wave_.kept[k];
    const Rgb throughput = paths_.throughput.at<Rgb>(i);
    const float probability = roulette.probability(throughput * paths_.eta_squared[i]);
    if (!(probability >= 1)) {
      if (!(wave_.ux[i] < probability)) continue;
      paths_.throughput.set(i, throughput / probability);
    }
    wave_.kept[surviving++] = std::uint32_t(i);
  }
  return surviving;
}

void PathWave::compact(std::size_t kept) {
  if (kept != paths_.size) {
    const auto move_words = [&](Words& column) { stages_.move_up_words(wave_.kept, kept, column); };
    const auto move_floats = [&](Floats& column) { stages_.move_up_floats(wave_.kept, kept, column); };
    for (Words* const column :
         {&paths_.sample, &paths_.pixel.low, &paths_.pixel.high, &paths_.index, &paths_.materials})
      move_words(*column);
    if (context_.has_interiors)
      for (Words* const column : {&paths_.interiors.low, &paths_.interiors.high}) move_words(*column);
    if (context_.options.limits.are_any()) move_words(paths_.bounces);
    move_floats(paths_.eta_squared);
    if (has_textures()) {
      move_floats(paths_.cone_width);
      move_floats(paths_.cone_spread);
    }
    for (Columns3* const columns : {&paths_.throughput, &paths_.direction})
      for (Floats* const column : {&columns->x, &columns->y, &columns->z}) move_floats(*column);
  }
  paths_.size = kept;
}

}  // namespace twinray
