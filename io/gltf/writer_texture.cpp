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
constexpr int clamp_to_edge = 33071, repeat = 10497;

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

}  // namespace

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
    file_.output.losses.add("a picture stands for textures that lie differently over one surface",
                            "{} pictures stand for textures that lie differently over one surface");
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
  const std::string png = has_alpha ? png_bytes(image) : png_bytes(without_alpha(image));
  return info_of(file_.add_image(name, png), baked.frame);
}

GltfJson GltfTextureWriter::emission_info(const MeshLight& light, float brightest) {
  const auto [entry, is_new] = pictures_.try_emplace(light.picture);
  if (is_new) {
    const Image picture = divided(*light.picture, brightest);
    check_range(picture);
    entry->second = file_.add_image("", png_bytes(encode_srgb(picture)));
  }
  BakedTexture frame;
  frame.uv = light.uv, frame.wrap = light.wrap, frame.filter = light.filter;
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

GltfJson GltfTextureWriter::info_of(std::size_t image, const BakedTexture& frame) {
  GltfJson info{{"index", file_.add("textures", {{"sampler", sampler(frame)}, {"source", image}})}};
  if (frame.uv == UvTransform{}) return info;
  file_.use("KHR_texture_transform");
  info["extensions"]["KHR_texture_transform"] = transform(frame.uv);
  return info;
}

std::size_t GltfTextureWriter::sampler(const BakedTexture& frame) {
  if (frame.wrap.u == WrapMode::black || frame.wrap.v == WrapMode::black)
    file_.output.losses.add("a picture that is black beside itself goes on as at its edge",
                            "{} pictures that are black beside themselves go on as at their edges");
  const bool is_nearest = frame.filter == TextureFilter::nearest;
  const auto word = [](WrapMode wrap) { return wrap == WrapMode::repeat ? repeat : clamp_to_edge; };
  const int s = word(frame.wrap.u), t = word(frame.wrap.v);
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
  constexpr double tolerance = 1e-5;
  if (std::fabs(c * double(u[1]) + s * double(v[1])) > tolerance * (std::fabs(sx) + std::fabs(sy)))
    file_.output.losses.add("a texture that is skewed is not skewed there",
                            "{} textures that are skewed are not skewed there");
  return {{"offset", {double(u[2]) - s * sy, 1 - c * sy - double(v[2])}},
          {"rotation", angle},
          {"scale", {sx, sy}}};
}

}  // namespace twinray
