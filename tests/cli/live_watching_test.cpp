// SPDX-License-Identifier: Apache-2.0
// When those who look at a growing picture are shown what.
#include "cli/live/live_picture.h"

#include "integrators/path.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

/// What a viewer was shown, in order.
struct Shown {
  std::vector<std::string> events;
  std::vector<std::string> more;
};

/// One that needs the film once `wants` says so.
class Viewer final : public PictureViewer {
 public:
  Viewer(Shown& shown, bool& needs_film) : shown_(shown), needs_film_(needs_film) {}
  void begin(const RenderOptions&, const Scene&, const std::vector<LiveLayer>& more) override {
    for (const LiveLayer& layer : more) shown_.more.push_back(layer.name);
  }
  bool is_ready() const override { return false; }
  void show(const Film&) override {
    shown_.events.push_back("film");
    needs_film_ = false;
  }
  bool needs_film() const override { return needs_film_; }
  void show_tile(const Film&, const PixelRect&) override { shown_.events.push_back("tile"); }
  void show_last(const RenderResult&) override {}
  std::string finish() override { return ""; }

 private:
  Shown& shown_;
  bool& needs_film_;
};

/// Of two tiles and one sample, on one thread.
RenderOptions two_tiles() {
  RenderOptions options;
  options.width = 32;
  options.height = 16;
  options.samples = 1;
  options.threads = 1;
  return options;
}

void render_box(const Scene& scene, const RenderOptions& options) {
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  render(scene, *accelerator, PathIntegrator(scene, {.max_depth = 1}), options);
}

LivePicture picture_with(Shown& shown, bool& needs_film) {
  std::vector<std::unique_ptr<PictureViewer>> viewers;
  viewers.push_back(std::make_unique<Viewer>(shown, needs_film));
  return LivePicture(std::move(viewers));
}

}  // namespace

TEST_CASE("a viewer that needs the film gets it between two tiles, and a render rests for others as before") {
  const Scene scene = load_scene(TWINRAY_SOURCE_DIR "/scenes/box.dae").scene;
  Shown shown;
  bool needs_film = false;
  LivePicture live = picture_with(shown, needs_film);
  RenderOptions options = two_tiles();
  int asked = 0, rests = 0;
  bool is_due = false;
  options.is_pause_due = [&] {
    if (++asked == 1) needs_film = true;  // while the first tile is rendered
    return is_due;
  };
  options.paused = [&](const RenderState&) {
    ++rests;
    is_due = false;
  };
  render_box(scene, live.watching(options, scene, {{"more", {"X"}, {}}}));
  CHECK(shown.events == std::vector<std::string>{"tile", "film", "tile"});
  CHECK(shown.more == std::vector<std::string>{"more"});
  CHECK(rests == 1);
  is_due = true;
  render_box(scene, live.watching(options, scene));
  CHECK(rests == 2);
}

TEST_CASE("where nobody may look a render is what it was") {
  const Scene scene = load_scene(TWINRAY_SOURCE_DIR "/scenes/box.dae").scene;
  LivePicture live({});
  const RenderOptions options = live.watching(two_tiles(), scene);
  CHECK_FALSE(options.tile_done);
  CHECK_FALSE(options.pass_done);
  CHECK_FALSE(options.is_pause_due);
}

}  // namespace twinray::test
