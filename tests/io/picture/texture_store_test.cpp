// SPDX-License-Identifier: Apache-2.0
#include "io/picture/texture_store.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "core/error.h"
#include "io/picture/texture_file.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

Image random_image(int width, int height, int seed) {
  Image image(width, height);
  Random random{std::uint64_t(seed)};
  for (Rgb& pixel : image.pixels) pixel = {random.unit(), random.unit(), 10 * random.unit()};
  return image;
}

}  // namespace

TEST_CASE("a store keeps the texels of all levels of its pictures, whatever its bound") {
  for (const std::uint64_t bytes : {std::uint64_t(0), std::uint64_t(200'000), std::uint64_t(1) << 30}) {
    CAPTURE(bytes);
    TextureStore store(bytes);
    std::vector<MipMap> expected;
    std::vector<std::shared_ptr<const MipMap>> kept;
    for (const auto& [width, height] : {std::pair{300, 130}, std::pair{65, 1}, std::pair{129, 257}}) {
      expected.emplace_back(random_image(width, height, width));
      kept.push_back(store.keep(MipMap(random_image(width, height, width))));
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
      CHECK(kept[i]->levels() == expected[i].levels());
      for (int level = 0; level < kept[i]->levels(); ++level)
        CHECK(kept[i]->image(level).pixels == expected[i].image(level).pixels);
    }
    const TextureStatistics statistics = store.statistics();
    CHECK(statistics.pictures == 3);
    CHECK(statistics.tiles.tiles_failed == 0);
    CHECK(statistics.tiles.peak_bytes <= std::max<std::uint64_t>(bytes, texels_a_tile * sizeof(Rgb)));
  }
}

TEST_CASE("a picture no larger than a tile stays in memory") {
  TextureStore store(0);
  CHECK(store.keep(MipMap(Image(64, 64)))->is_in_memory());
  CHECK_FALSE(store.keep(MipMap(Image(65, 64)))->is_in_memory());
  CHECK(store.statistics().pictures == 1);
  CHECK(store.statistics().picture_bytes == 12 * (65 * 64 + 32 * 32 + 16 * 16 + 64 + 16 + 4 + 1));
}

TEST_CASE("a picture in a store is known to lie from 0 to 1, or beyond, as one in memory") {
  TextureStore store(0);
  for (const Rgb& pixel : {Rgb{0, 0.5f, 1}, Rgb{0, 0, 1.01f}, Rgb{0, -0.01f, 0}}) {
    const bool is_within = pixel == Rgb{0, 0.5f, 1};
    CHECK(MipMap(Image(100, 100, pixel)).is_within_unit() == is_within);
    CHECK(store.keep(MipMap(Image(100, 100, pixel)))->is_within_unit() == is_within);
  }
}

TEST_CASE("a texture in a store has the bits of one in memory, and its warning") {
  const TemporaryFolder folder;
  ByteImage bytes{200, 90, {}};
  Random random(5);
  for (int i = 0; i < 3 * 200 * 90; ++i) bytes.bytes.push_back(std::uint8_t(256 * random.unit()));
  write_png(folder.file("a.png"), bytes);
  const LoadOptions bounded{.textures = std::make_shared<TextureStore>(50'000)};
  const LoadedTexture kept = load_texture(folder.file("a.png"), {}, bounded);
  const LoadedTexture whole = load_texture(folder.file("a.png"), {});
  CHECK_FALSE(kept.image->is_in_memory());
  for (int level = 0; level < whole.image->levels(); ++level)
    CHECK(kept.image->image(level).pixels == whole.image->image(level).pixels);
  CHECK(load_texture(folder.file("none.png"), {}, bounded).warning ==
        fmt::format("{}: there is no such file; it is shown magenta", folder.file("none.png")));
}

TEST_CASE("a store says where it could not write, and leaves nothing behind where it could") {
  const TemporaryFolder folder;
  const char* before = std::getenv("TMPDIR");
  const std::string old = before ? before : "";
  setenv("TMPDIR", folder.path().c_str(), 1);
  {
    TextureStore store(0);
    store.keep(MipMap(Image(200, 200)));
    CHECK(std::filesystem::is_empty(folder.path()));
  }
  setenv("TMPDIR", folder.file("none").c_str(), 1);
  TextureStore store(0);
  CHECK_THROWS_WITH(store.keep(MipMap(Image(200, 200))),
                    Catch::Matchers::StartsWith(folder.file("none") + ": a temporary file there cannot be"));
  before ? setenv("TMPDIR", old.c_str(), 1) : unsetenv("TMPDIR");
}

}  // namespace twinray::test
