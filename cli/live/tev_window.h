// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/live/picture_viewer.h"
#include "cli/scene_names.h"
#include "io/network/tev_viewer.h"

namespace twinray {

/// --tev: the viewer tev, which gets what an EXR of the film would hold, by the same names.
class TevWindow final : public PictureViewer {
 public:
  TevWindow(const NetworkAddress& address, const std::string& picture_name);
  void begin(const RenderOptions& options, const Scene& scene, const std::vector<LiveLayer>& more) override;
  bool is_ready() const override { return viewer_.is_idle(); }
  void show(const Film& film) override;
  void show_last(const RenderResult& result) override { show(result.film); }
  std::string finish() override;

 private:
  NetworkAddress address_;
  std::string name_;
  SceneNames names_;  ///< Of what the film keeps besides its colours.
  TevViewer viewer_;
};

}  // namespace twinray
