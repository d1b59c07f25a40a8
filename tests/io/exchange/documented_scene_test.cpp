// SPDX-License-Identifier: Apache-2.0
// The scene that docs/exchange.md shows, taken out of its text.
#include "io/exchange/reader.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

TEST_CASE("the scene that the documentation shows is read, and what it leaves out is as usual") {
  const TemporaryFolder folder;
  const std::string page = read_text(TWINRAY_SOURCE_DIR "/docs/exchange.md"), mark = "```json\n";
  const std::size_t begin = page.find(mark) + mark.size();
  write_text(folder.file("a.json"), page.substr(begin, page.find("```", begin) - begin));
  const LoadedScene loaded = load_exchange(folder.file("a.json"));
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.geometry->sphere_count() == 1);
  const Camera& camera = loaded.scene.camera;
  CHECK((camera.lens_radius == 0 && camera.focal_distance == 1 && camera.clip_near == 0));
  CHECK_FALSE(camera.clips_by_distance);
  const Attenuation& attenuation = std::get<PointLight>(loaded.scene.lights.at(0).source).attenuation;
  CHECK((attenuation.constant == 0 && attenuation.linear == 0 && attenuation.quadratic == 1));
}

}  // namespace twinray::test
