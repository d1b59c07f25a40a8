// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/texture.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "io/affine_texture.h"
#include "io/gltf/document.h"
#include "io/gltf/uri.h"
#include "io/picture/mirrored_picture.h"
#include "io/picture/texture_store.h"
#include "io/uri.h"

namespace twinray {
namespace {

constexpr bool is_mirror(int wrap) { return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT; }

}  // namespace

bool GltfTextures::Wraps::is_mirrored() const { return is_mirror(s) || is_mirror(t); }

GltfTextures::Wraps GltfTextures::wraps(const GltfSlot& slot) const {
  const tinygltf::Texture& texture = document_.model().textures[std::size_t(slot.texture)];
  if (texture.sampler < 0) return {TINYGLTF_TEXTURE_WRAP_REPEAT, TINYGLTF_TEXTURE_WRAP_REPEAT};
  const tinygltf::Sampler& sampler = document_.model().samplers[std::size_t(texture.sampler)];
  return {sampler.wrapS, sampler.wrapT};
}

Wrap GltfTextures::wrap(const GltfSlot& slot) const {
  const auto mode = [](int word) {
    return word == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE ? WrapMode::clamp : WrapMode::repeat;
  };
  const auto [s, t] = wraps(slot);
  return {mode(s), mode(t)};
}

std::uint32_t GltfTextures::add(const std::string& name, const TextureModel& model) {
  textures_.push_back({name, model});
  return std::uint32_t(textures_.size() - 1);
}

std::uint32_t GltfTextures::constant(const Rgb& value) {
  const auto [entry, is_new] = constants_.try_emplace({value.r, value.g, value.b}, 0);
  if (is_new) entry->second = add("", ConstantTexture{value});
  return entry->second;
}

int GltfTextures::source_of(const GltfSlot& slot) const {
  const tinygltf::Texture& texture = document_.model().textures[std::size_t(slot.texture)];
  const GltfExtension webp(texture.extensions, "EXT_texture_webp", "");
  return webp.has("source") ? int(webp.number("source", 0)) : texture.source;
}

std::string GltfTextures::name_of(const GltfSlot& slot) const {
  const int source = source_of(slot);
  const CheckedGltf::Source& image = document_.images()[std::size_t(source)];
  if (!image.name.empty()) return image.name;
  return image.uri.empty() || is_data_uri(image.uri) ? fmt::format("image {}", source) : image.uri;
}

std::uint32_t GltfTextures::picture(const GltfSlot& slot, const PictureMeaning& meaning,
                                    CoordinateSet coordinates) {
  std::vector<float> transform(&slot.uv.m[0][0], &slot.uv.m[0][0] + 6);
  const PictureKey key{slot.texture, int(meaning.role), int(meaning.channels), coordinates,
                       std::move(transform)};
  if (const auto found = pictures_.find(key); found != pictures_.end()) return found->second;
  if (source_of(slot) < 0) {
    document_.context().warn(slot.pointer, "the texture has no picture that is read here; it is white");
    return pictures_[key] = constant({1, 1, 1});
  }
  ImageTexture texture = image_texture(slot, meaning);
  texture.coordinates = coordinates;
  return pictures_[key] = add(name_of(slot), texture);
}

ImageTexture GltfTextures::image_texture(const GltfSlot& slot, const PictureMeaning& meaning) {
  const auto& model = document_.model();
  const tinygltf::Texture& source = model.textures[std::size_t(slot.texture)];
  ImageTexture texture{.image = image(slot, meaning), .wrap = wrap(slot)};
  const auto [s, t] = wraps(slot);
  texture.uv = halved(slot.uv, is_mirror(s), is_mirror(t));
  if (source.sampler >= 0 &&
      model.samplers[std::size_t(source.sampler)].magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
    texture.filter = TextureFilter::nearest;
  return texture;
}

std::shared_ptr<const MipMap> GltfTextures::image(const GltfSlot& slot, const PictureMeaning& meaning) {
  const int source = source_of(slot);
  const auto [s, t] = wraps(slot);
  const bool to_right = is_mirror(s), below = is_mirror(t);
  auto& image = images_[{source, int(meaning.role), int(meaning.channels), to_right + 2 * below}];
  if (image) return image;
  LoadedTexture loaded = load(source, meaning);
  if (!loaded.warning.empty()) document_.context().warn(fmt::format("/images/{}", source), loaded.warning);
  image = loaded.image;
  if (!to_right && !below) return image;
  MipMap wide(mirrored(image->image(0), to_right, below));
  TextureStore* const store = document_.context().options.textures.get();
  return image = store ? store->keep(std::move(wide)) : std::make_shared<const MipMap>(std::move(wide));
}

LoadedTexture GltfTextures::load(int image, const PictureMeaning& meaning) {
  const CheckedGltf::Source& source = document_.images()[std::size_t(image)];
  const std::string pointer = fmt::format("/images/{}", image);
  if (source.uri.empty() || is_data_uri(source.uri)) return load_embedded(image, meaning);
  const GltfContext& context = document_.context();
  if (!context.read_pictures) return load_texture("", meaning, context.options);
  if (is_remote(source.uri)) return missing_texture(remote_fault(source.uri));
  return load_texture(gltf_path(source.uri, pointer, context), meaning, context.options);
}

LoadedTexture GltfTextures::load_embedded(int image, const PictureMeaning& meaning) {
  const CheckedGltf::Source& source = document_.images()[std::size_t(image)];
  const std::string pointer = fmt::format("/images/{}", image);
  if (source.uri.empty() && source.buffer_view < 0)
    document_.context().fail(pointer, "an image needs its \"uri\" or its \"bufferView\"");
  std::string data;
  std::string_view bytes;
  if (source.uri.empty())
    bytes = document_.buffer_view(std::size_t(source.buffer_view));
  else
    bytes = data = data_of_uri(source.uri, pointer + "/uri", document_.context());
  return decode_texture(bytes, fmt::format("image {}", image), meaning, document_.context().options);
}

std::uint32_t GltfTextures::scaled(std::uint32_t texture, const Rgb& factor) {
  if (factor == Rgb{1, 1, 1}) return texture;
  return add("", ScaleTexture{texture, constant(factor)});
}

std::uint32_t GltfTextures::product(std::uint32_t first, std::uint32_t second) {
  return second == no_texture ? first : add("", ScaleTexture{first, second});
}

std::uint32_t GltfTextures::normal_map(const GltfSlot& slot, bool is_mirrored) {
  return directions(slot, slot.scale, is_mirrored ? -slot.scale : slot.scale);
}

std::uint32_t GltfTextures::tangent_map(const GltfSlot& slot, bool is_mirrored) {
  return directions(slot, 1, is_mirrored ? -1 : 1);
}

std::uint32_t GltfTextures::directions(const GltfSlot& slot, float x, float y) {
  std::uint32_t map = picture(slot, {PictureRole::data, PictureChannels::color});
  if (auto* image = std::get_if<ImageTexture>(&textures_[map].model))
    if (image->filter == TextureFilter::stochastic) image->filter = TextureFilter::bilinear;
  return add_leaning(textures_, map, x, y);
}

std::uint32_t GltfTextures::at_least(std::uint32_t texture, float factor, float limit) {
  constexpr float steepness = 4096;
  const float at_0 = 1 - steepness * limit, at_1 = at_0 + steepness * factor;
  return add("", MixTexture{constant({at_0, at_0, at_0}), constant({at_1, at_1, at_1}), texture});
}

}  // namespace twinray
