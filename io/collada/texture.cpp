// SPDX-License-Identifier: Apache-2.0
#include "io/collada/texture.h"

#include <fmt/format.h>

#include "io/picture/mirrored_picture.h"
#include "io/picture/texture_store.h"
#include "io/picture_path.h"
#include "io/uri.h"

namespace twinray {
namespace {

/// A word of a sampler; `fallback` where it has none.
std::string word_of(const std::optional<XmlElement>& sampler, const char* name, const char* fallback) {
  const auto element = sampler ? sampler->child(name) : std::nullopt;
  const std::string word = element ? element->text() : "";
  return word.empty() ? fallback : word;
}

WrapMode wrap_of(const std::string& word) {
  if (word == "CLAMP") return WrapMode::clamp;
  return word == "BORDER" || word == "NONE" ? WrapMode::black : WrapMode::repeat;
}

}  // namespace

void ColladaTextures::place(const XmlElement& texture, Sampling& sampling) {
  for (const XmlElement& extra : texture.children("extra"))
    for (const XmlElement& technique : extra.children("technique")) {
      if (technique.attribute("profile") != "MAYA") continue;
      const auto number_of = [&](const char* name, float usual) {
        const auto element = technique.child(name);
        return element ? float(number_in(*element, -1e6, 1e6)) : usual;
      };
      sampling.uv = {{{number_of("repeatU", 1), 0, number_of("offsetU", 0)},
                      {0, number_of("repeatV", 1), number_of("offsetV", 0)}}};
      sampling.mirrors_u |= number_of("mirrorU", 0) != 0;
      sampling.mirrors_v |= number_of("mirrorV", 0) != 0;
      for (const char* angle : {"rotateFrame", "rotateUV"})
        if (number_of(angle, 0) != 0)
          document_.warn(*technique.child(angle), fmt::format("the picture is not turned by <{}>", angle));
    }
}

ColladaTextures::Sampling ColladaTextures::sampling_of(const ColladaTextureUse& use) {
  Sampling sampling;
  const std::string s = word_of(use.sampler, "wrap_s", "WRAP"), t = word_of(use.sampler, "wrap_t", "WRAP");
  sampling.wrap = {wrap_of(s), wrap_of(t)};
  sampling.mirrors_u = s == "MIRROR";
  sampling.mirrors_v = t == "MIRROR";
  if (word_of(use.sampler, "magfilter", "") == "NEAREST") sampling.filter = TextureFilter::nearest;
  try {
    Sampling placed = sampling;
    place(use.element, placed);
    sampling = placed;
  } catch (const Error&) {
    document_.warn(use.element, "where this picture lies makes no sense; it lies as it is");
  }
  return sampling;
}

std::uint32_t ColladaTextures::picture(const ColladaTextureUse& use, const PictureMeaning& meaning) {
  const std::string path = found_picture(path_of_uri(with_slashes(use.name), use.from_file), use.from_file);
  const auto [entry, is_new] =
      pictures_.try_emplace({use.element, use.sampler, path, int(meaning.role), int(meaning.channels)}, 0);
  if (!is_new) return entry->second;
  const Sampling sampling = sampling_of(use);
  ImageTexture texture{
      .image = image(path, use, meaning, sampling), .wrap = sampling.wrap, .filter = sampling.filter};
  texture.uv = halved(sampling.uv, sampling.mirrors_u, sampling.mirrors_v);
  textures.push_back({use.name, std::move(texture)});
  return entry->second = std::uint32_t(textures.size() - 1);
}

std::shared_ptr<const MipMap> ColladaTextures::image(const std::string& path, const ColladaTextureUse& use,
                                                     const PictureMeaning& meaning,
                                                     const Sampling& sampling) {
  const auto [u, v] = std::pair(sampling.mirrors_u, sampling.mirrors_v);
  auto& image = images_[{path, int(meaning.role), int(meaning.channels), u + 2 * v}];
  if (image) return image;
  LoadedTexture loaded = read_(path, meaning, document_.options());
  image = loaded.image;
  if (!loaded.warning.empty()) document_.warn(use.element, loaded.warning);
  if (loaded.is_stand_in) {
    faulty_.insert(image);
    return image;
  }
  if (!u && !v) return image;
  MipMap wide(mirrored(image->image(0), u, v));
  TextureStore* const store = document_.options().textures.get();
  return image = store ? store->keep(std::move(wide)) : std::make_shared<const MipMap>(std::move(wide));
}

std::uint32_t ColladaTextures::constant(float value) { return add(ConstantTexture{{value, value, value}}); }

std::uint32_t ColladaTextures::add(const TextureModel& model) {
  textures.push_back({"", model});
  return std::uint32_t(textures.size() - 1);
}

bool ColladaTextures::is_one(std::uint32_t texture) const {
  const auto* picture = std::get_if<ImageTexture>(&textures[texture].model);
  return picture && picture->image->level(picture->image->levels() - 1).at(0, 0) == Rgb{1, 1, 1};
}

bool ColladaTextures::is_faulty(std::uint32_t texture) const {
  const auto* picture = std::get_if<ImageTexture>(&textures[texture].model);
  return picture && faulty_.count(picture->image) > 0;
}

}  // namespace twinray
