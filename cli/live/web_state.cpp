// SPDX-License-Identifier: Apache-2.0
#include "cli/live/web_state.h"

#include <nlohmann/json.hpp>

#include "cli/progress.h"

namespace twinray {
namespace {

using Json = nlohmann::ordered_json;

const char* phase_name(WebState::Phase phase) {
  if (phase == WebState::Phase::loading) return "loading";
  return phase == WebState::Phase::rendering ? "rendering" : "ended";
}

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json layers_json(const WebState& state) {
  Json layers = Json::array();
  for (std::size_t i = 0; i < state.layers.size(); ++i)
    layers.push_back({{"name", state.layers[i].name},
                      {"channels", state.layers[i].channels},
                      {"version", state.versions[i]}});
  return layers;
}

/// Samples of a pixel: how many there are, and how many there will be where nothing else ends the render.
Json samples_json(const WebState& state, const ProgressShares& shares) {
  const double pixels = double(state.width) * state.height;
  Json samples{{"done", pixels > 0 ? double(state.progress.samples_done) / pixels : 0}};
  const bool is_total_known = pixels > 0 && shares.of_samples == shares.most();
  samples["total"] = is_total_known ? Json(double(state.progress.samples_total) / pixels) : Json(nullptr);
  return samples;
}

/// One that is complete may have ended before the time that it had.
double share_of(const WebState& state, const ProgressShares& shares) {
  if (state.phase == WebState::Phase::loading) return 0;
  return state.is_complete ? 1 : shares.most();
}

}  // namespace

std::string state_json(const WebState& state) {
  const ProgressShares shares = progress_shares(state.progress, state.seconds);
  const Json json{{"picture", state.picture},
                  {"partial", state.partial},
                  {"phase", phase_name(state.phase)},
                  {"complete", state.is_complete},
                  {"stopping", state.is_stopping},
                  {"can_stop", !state.partial.empty()},
                  {"width", state.width},
                  {"height", state.height},
                  {"layers", layers_json(state)},
                  {"samples", samples_json(state, shares)},
                  {"share", share_of(state, shares)},
                  {"seconds", state.seconds},
                  {"seconds_left", optional(seconds_left(state.progress, state.seconds))},
                  {"rays", state.progress.rays},
                  {"rays_per_second", rays_per_second(state.progress, state.seconds)},
                  {"error", optional(state.progress.error)},
                  {"noise_target", optional(state.progress.noise_target)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace twinray
