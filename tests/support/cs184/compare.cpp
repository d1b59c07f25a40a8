// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cs184/compare.h"

#include <cstdlib>

#include "accel/accelerator.h"
#include "integrators/normals.h"
#include "integrators/render.h"
#include "io/collada/collada.h"
#include "io/cs184/camera.h"
#include "io/cs184/picture.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test::cs184 {
namespace {

ByteImage our_picture(const std::string& collada, int width, int height) {
  Scene scene = read_collada(*XmlDocument::parse(collada, "scene.dae"),
                             {.interpretation = Interpretation::cs184, .surfaces_only = true})
                    .scene;
  scene.camera = cs184_frame(scene.camera, width, height);
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const NormalsIntegrator normals(scene, NormalsIntegrator::Mixture::as_it_is);
  return encode_cs184(mean_image(
      render(scene, *accelerator, normals, {.width = width, .height = height, .samples = 1}).film));
}

}  // namespace

Difference difference_of_text(const std::string& collada, int width, int height) {
  const ByteImage ours = our_picture(collada, width, height);
  const Picture reference = normals_picture(collada, width, height);
  std::size_t beyond = 0, outline = 0, covered = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    int most = 0, sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      most = std::max(most, std::abs(int(ours.bytes[3 * i + c]) - int(reference.pixels[i][c])));
      sum += ours.bytes[3 * i + c];
    }
    beyond += most > 1;
    covered += reference.is_hit[i];
    outline += (sum > 0) != reference.is_hit[i];
  }
  const double count = double(reference.pixels.size());
  return {double(beyond) / count, double(outline) / count, double(covered) / count};
}

Difference difference_of_file(const std::string& path, int width, int height) {
  return difference_of_text(read_text(path), width, height);
}

}  // namespace twinray::test::cs184
