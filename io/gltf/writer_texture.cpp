// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/writer_texture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/angle.h"
#include "core/elementary.h"
#include "io/picture/png.h"

namespace twinray {
namespace {

constexpr int gl_nearest = 9728, gl_linear = 9729, gl_trilinear = 9987;
constexpr int clamp_to_edge = 33071, repeat = 10497, mirrored_repeat = 33648;

std::uint8_t byte_of(float number) {
  return std::uint8_t(std::lround(255 * (number > 0 ? std::min(number, 1.0f) : 0)));
}

float powered(float number, float power) {
  return power == 1 || !(number > 0) ? number : float(pow_of(double(number), double(power)));
}

/// Of a picture's red, green or blue where its colour is this.
std::uint8_t color_byte(const Rgb& c, std::size_t channel, const GltfChannels& channels) {
  const float middle = channels.turns_green ? 1 - c.g : c.g;
  const float value = channel == 0 ? c.r : channel == 1 ? middle : c.b;
  if (channels.kind == GltfColorKind::color) return encode_srgb(value);
  return channels.kind == GltfColorKind::tangent && channel == 2 ? byte_of(1) : byte_of(value);
}

template <typename Picture>
std::string png_bytes(const Picture& picture) {
  std::vector<unsigned char> bytes;
  if constexpr (std::is_same_v<Picture, AlphaImage>)
    bytes = encode_png(picture);
  else
    bytes = encode_png(picture, {});
  return {bytes.begin(), bytes.end()};
}

Image divided(Image image, float by) {
  for (Rgb& pixel : image.pixels) pixel = pixel / by;
  return image;
}

ByteImage without_alpha(const AlphaImage& image) {
  ByteImage plain{image.width, image.height, {}};
  for (std::size_t i = 0; i < image.bytes.size(); ++i)
    if (i % 4 != alpha_channel) plain.bytes.push_back(image.bytes[i]);
  return plain;
}

/// Whether the transform is no turn of a scale: what glTF cannot say.
bool is_skewed(const UvTransform& uv) {
  constexpr double tolerance = 1e-5;
  const auto& [u, v] = uv.m;
  const double u0 = double(u[0]), u1 = double(u[1]), v0 = double(v[0]), v1 = double(v[1]);
  const double x = std::sqrt(u0 * u0 + v0 * v0), y = std::sqrt(u1 * u1 + v1 * v1);
  return std::fabs(u0 * u1 + v0 * v1) > tolerance * x * (x + y);
}

/// From the coordinates of a picture to those of its left and its upper half: the inverse of halved()
/// (io/picture/mirrored_picture.h).
UvTransform doubled(const UvTransform& uv, const GltfMirrored& mirrored) {
  UvTransform result = uv;
  if (mirrored.below) result.m[1][2] -= 0.5f;
  for (float& number : result.m[0]) number *= mirrored.to_right ? 2.0f : 1.0f;
  for (float& number : result.m[1]) number *= mirrored.below ? 2.0f : 1.0f;
  return result;
}

template <typename Picture>
std::size_t channels_of(const Picture& picture) {
  return picture.bytes.size() / (std::size_t(picture.width) * std::size_t(picture.height));
}

template <typename Picture>
bool is_own_mirror(const Picture& picture, const GltfMirrored& how) {
  if ((how.to_right && picture.width % 2 != 0) || (how.below && picture.height % 2 != 0)) return false;
  const std::size_t channels = channels_of(picture);
  const auto pixel = [&](int x, int y) {
    return picture.bytes.begin() + std::ptrdiff_t(channels) * (std::ptrdiff_t(y) * picture.width + x);
  };
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto at = pixel(x, y);
      const auto other =
          pixel(how.to_right ? picture.width - 1 - x : x, how.below ? picture.height - 1 - y : y);
      if (!std::equal(at, at + std::ptrdiff_t(channels), other)) return false;
    }
  return true;
}

template <typename Picture>
Picture half_of(const Picture& picture, const GltfMirrored& how) {
  Picture result{picture.width / (how.to_right ? 2 : 1), picture.height / (how.below ? 2 : 1), {}};
  const std::size_t channels = channels_of(picture);
  for (int y = 0; y < result.height; ++y) {
    const auto row = picture.bytes.begin() + std::ptrdiff_t(channels) * y * picture.width;
    result.bytes.insert(result.bytes.end(), row, row + std::ptrdiff_t(channels) * result.width);
  }
  return result;
}

/// How to halve a picture so that its place is one that glTF has; not at all where there is no way.
template <typename Picture>
GltfMirrored mirrored_of(const Picture& picture, const BakedTexture& frame) {
  if (!is_skewed(frame.uv)) return {};
  for (const GltfMirrored how : {GltfMirrored{true, false}, GltfMirrored{false, true}}) {
    const WrapMode wrap = how.to_right ? frame.wrap.u : frame.wrap.v;
    if (wrap == WrapMode::repeat && !is_skewed(doubled(frame.uv, how)) && is_own_mirror(picture, how))
      return how;
  }
  return {};
}

}  // namespace

template <typename Picture>
GltfJson GltfTextureWriter::placed_info(const std::string& name, const Picture& picture,
                                        const BakedTexture& frame) {
  const GltfMirrored mirrored = mirrored_of(picture, frame);
  BakedTexture placed = frame;
  placed.uv = doubled(frame.uv, mirrored);
  return info_of(file_.add_image(name, png_bytes(half_of(picture, mirrored))), placed, mirrored);
}

GltfJson GltfTextureWriter::info(const GltfChannels& channels) {
  const auto [entry, is_new] = made_.try_emplace(channels);
  if (is_new) entry->second = make(channels);
  return entry->second;
}

GltfJson GltfTextureWriter::make(const GltfChannels& channels) {
  std::vector<std::uint32_t> indices;
  std::string name;
  const auto add_index = [&](std::uint32_t texture) {
    if (texture == no_texture) return std::size_t(0);
    indices.push_back(texture);
    if (name.empty()) name = scene_.textures[texture].name;
    return indices.size();  // One behind its place.
  };
  const std::size_t color = add_index(channels.color);
  std::array<std::size_t, 4> numbers{};
  for (std::size_t k = 0; k < 4; ++k) numbers[k] = add_index(channels.number[k]);
  const BakedTextures baked = bake_together(scene_.textures, indices);
  if (!baked.frame.is_exact)
    file_.output.losses.add(
        "a picture stands for textures that lie differently over one surface, or by the points of the scene",
        "{} pictures stand for textures that lie differently over one surface, or by the points of the "
        "scene");
  if (color > 0) check_range(baked.pictures[color - 1]);
  const Image& size = baked.pictures.at(0);
  AlphaImage image{size.width, size.height, std::vector<std::uint8_t>(4 * size.pixels.size(), 255)};
  for (std::size_t pixel = 0; pixel < size.pixels.size(); ++pixel)
    for (std::size_t k = 0; k < 4; ++k) {
      std::uint8_t& byte = image.bytes[4 * pixel + k];
      if (numbers[k] > 0) {
        const float value = baked.pictures[numbers[k] - 1].pixels[pixel].r;
        byte = byte_of(k == alpha_channel ? value : powered(value, channels.power));
      } else if (color > 0 && k != alpha_channel) {
        byte = color_byte(baked.pictures[color - 1].pixels[pixel], k, channels);
      } else if (channels.kind == GltfColorKind::tangent && k == 1) {
        byte = byte_of(0.5f);
      }
    }
  const bool has_alpha = numbers[alpha_channel] > 0;
  return has_alpha ? placed_info(name, image, baked.frame)
                   : placed_info(name, without_alpha(image), baked.frame);
}

GltfJson GltfTextureWriter::emission_info(const MeshLight& light, float brightest) {
  BakedTexture frame;
  frame.uv = light.uv, frame.wrap = light.wrap, frame.filter = light.filter;
  const auto encoded = [&] {
    const Image picture = divided(*light.picture, brightest);
    check_range(picture);
    return encode_srgb(picture);
  };
  if (is_skewed(light.uv)) return placed_info("", encoded(), frame);
  const auto [entry, is_new] = pictures_.try_emplace(light.picture);
  if (is_new) entry->second = file_.add_image("", png_bytes(encoded()));
  return info_of(entry->second, frame);
}

void GltfTextureWriter::check_range(const Image& picture) {
  constexpr float margin = 1e-3f;
  if (std::any_of(picture.pixels.begin(), picture.pixels.end(),
                  [](const Rgb& pixel) { return max_component(pixel) > 1 + margin; }))
    file_.output.losses.add("a picture has colors above 1, which end at 1",
                            "{} pictures have colors above 1, which end at 1");
  if (std::any_of(picture.pixels.begin(), picture.pixels.end(),
                  [](const Rgb& p) { return p != at_least_zero(p); }))
    file_.output.losses.add(
        "a picture has colors below 0, which are 0, as colors of vertices in unlit surfaces",
        "{} pictures have colors below 0, which are 0, as colors of vertices in unlit surfaces");
}

GltfJson GltfTextureWriter::info_of(std::size_t image, const BakedTexture& frame,
                                    const GltfMirrored& mirrored) {
  GltfJson info{{"index", file_.add("textures", {{"sampler", sampler(frame, mirrored)}, {"source", image}})}};
  if (frame.uv == UvTransform{}) return info;
  file_.use("KHR_texture_transform");
  info["extensions"]["KHR_texture_transform"] = transform(frame.uv);
  return info;
}

std::size_t GltfTextureWriter::sampler(const BakedTexture& frame, const GltfMirrored& mirrored) {
  if (frame.wrap.u == WrapMode::black || frame.wrap.v == WrapMode::black)
    file_.output.losses.add("a picture that is black beside itself goes on as at its edge",
                            "{} pictures that are black beside themselves go on as at their edges");
  const bool is_nearest = frame.filter == TextureFilter::nearest;
  const auto word = [](WrapMode wrap, bool is_mirrored) {
    if (is_mirrored) return mirrored_repeat;
    return wrap == WrapMode::repeat ? repeat : clamp_to_edge;
  };
  const int s = word(frame.wrap.u, mirrored.to_right), t = word(frame.wrap.v, mirrored.below);
  const auto [entry, is_new] = samplers_.try_emplace({int(is_nearest), s, t});
  if (is_new)
    entry->second = file_.add("samplers", {{"magFilter", is_nearest ? gl_nearest : gl_linear},
                                           {"minFilter", is_nearest ? gl_nearest : gl_trilinear},
                                           {"wrapS", s},
                                           {"wrapT", t}});
  return entry->second;
}

/// The inverse of what io/gltf/slot.cpp reads: offset + R S (u, v), whose v runs downwards.
GltfJson GltfTextureWriter::transform(const UvTransform& uv) {
  const auto& [u, v] = uv.m;
  const double turns = atan2_turns(double(v[0]), double(u[0])), angle = 2 * pi_double * turns;
  const double s = sin_radians(angle), c = cos_radians(angle);
  const double sx = c * double(u[0]) + s * double(v[0]), sy = c * double(v[1]) - s * double(u[1]);
  if (is_skewed(uv))
    file_.output.losses.add("a texture that is skewed is not skewed there",
                            "{} textures that are skewed are not skewed there");
  return {{"offset", {double(u[2]) - s * sy, 1 - c * sy - double(v[2])}},
          {"rotation", angle},
          {"scale", {sx, sy}}};
}

}  // namespace twinray
