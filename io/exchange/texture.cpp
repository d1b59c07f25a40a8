// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/texture.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "io/picture/texture_file.h"

namespace twinray {
namespace {

/// The pictures of the file of this path.
class Pictures {
 public:
  Pictures(const std::string& path, const LoadOptions& options, WarningList& warnings)
      : path_(path), options_(options), warnings_(warnings) {}

  /// The one that an entry names.
  std::shared_ptr<const MipMap> of(const Entry& entry) {
    const std::string picture = entry.file_beside(path_);
    const auto role = entry.has("role") ? entry.named("role", words<PictureRole>()) : PictureRole::color;
    const bool has_levels = !entry.has("mip_map") || entry.flag("mip_map");
    auto& known = known_[{picture, role, has_levels}];
    if (!known) known = read(entry, picture, role, has_levels);
    return known;
  }

 private:
  std::shared_ptr<const MipMap> read(const Entry& entry, const std::string& picture, PictureRole role,
                                     bool has_levels) {
    LoadedTexture loaded = load_texture(picture, {.role = role}, options_);
    if (!loaded.warning.empty()) warnings_.add([&] { return Place{.file = entry.place()}; }, loaded.warning);
    if (has_levels) return std::move(loaded.image);
    return std::make_shared<const MipMap>(std::vector{loaded.image->image(0)});
  }

  const std::string& path_;
  const LoadOptions& options_;
  WarningList& warnings_;
  std::map<std::tuple<std::string, PictureRole, bool>, std::shared_ptr<const MipMap>> known_;
};

}  // namespace

std::vector<Texture> read_textures(const Entry& file, const std::string& path, const LoadOptions& options,
                                   WarningList& warnings) {
  std::vector<Texture> textures;
  if (!file.has("textures")) return textures;
  Pictures pictures(path, options, warnings);
  file.for_each("textures", [&](const Entry& entry) {
    Texture texture{entry.word("name"),
                    described_by<TextureModel>(
                        entry, {ConstantTexture{}, ImageTexture{}, ScaleTexture{}, MixTexture{},
                                CheckerboardTexture{}, CubesTexture{}, DotsTexture{}, BilinearTexture{},
                                DirectionMixTexture{}, NoiseTexture{}, PlacedTexture{}})};
    if (const auto* noise = std::get_if<NoiseTexture>(&texture.model); noise && noise->octaves.most > 64)
      entry.fail("octaves", fmt::format("is {}; at most 64 are valid", noise->octaves.most));
    if (auto* image = std::get_if<ImageTexture>(&texture.model)) {
      image->image = pictures.of(entry);
      image->of_vertices = entry.has("of_vertices") && entry.flag("of_vertices");
    }
    textures.push_back(std::move(texture));
  });
  return textures;
}

}  // namespace twinray
