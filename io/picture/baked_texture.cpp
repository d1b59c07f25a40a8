// SPDX-License-Identifier: Apache-2.0
#include "io/picture/baked_texture.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "core/scene_textures.h"
#include "core/texture_parts.h"

namespace twinray {
namespace {

/// Of a picture over the unit square, along an edge: the most where none of its parts has more.
constexpr int least_texels = 64, most_texels = 2048;

/// How one part of a texture lies over the surface.
struct Part {
  UvTransform uv;
  int period = 1;  ///< In the transformed coordinates: so often a board or picture repeats.
  int width = 1, height = 1;
  Wrap wrap;
  TextureFilter filter = TextureFilter::nearest;
  bool is_exact = true;  ///< So drawn, it shows all that there is.
  int detail = 1;        ///< Its edges lie at whole texels; where they need not, so many more show them.
};

/// The texels, along x or y of the unit square, that show a part which lies in it as it does on a surface.
int texels_of(const Part& part, int axis) {
  const double columns = std::fabs(double(part.uv.m[0][axis])) * part.width,
               rows = std::fabs(double(part.uv.m[1][axis])) * part.height;
  const int most = std::max(most_texels, axis == 0 ? part.width : part.height);
  return int(std::min(std::ceil((columns + rows) * part.detail / part.period), double(most)));
}

bool lie_alike(const Part& a, const Part& b) { return a.wrap == b.wrap && a.uv == b.uv; }

/// Whose coordinates are those of the baked picture.
UvTransform scaled(const UvTransform& uv, float factor) {
  UvTransform result = uv;
  for (auto& row : result.m)
    for (float& number : row) number *= factor;
  return result;
}

/// All pictures and boards of a texture.
class Parts {
 public:
  explicit Parts(std::span<const Texture> textures) : textures_(textures) {}

  void add(std::uint32_t index) {
    const TextureModel& model = textures_[index].model;
    std::visit([&](const auto& texture) { add_own(texture); }, model);
    for_each_part(model, [&](std::uint32_t part) { add(part); });
  }

  std::vector<Part> list;

 private:
  void add_own(const auto& /*texture*/) {}
  void add_own(const ImageTexture& texture) {
    const MipLevel level = texture.image->level(0);
    list.push_back({texture.uv, 1, level.width, level.height, texture.wrap, texture.filter});
  }
  void add_own(const CheckerboardTexture& texture) {
    list.push_back({texture.uv, 2, 2, 2, WrapMode::repeat, TextureFilter::nearest, true, 16});
  }
  /// Eight dots to each side, of those that never repeat; and what lies between the corners, not beyond.
  void add_own(const DotsTexture& texture) {
    list.push_back({texture.uv, 8, 256, 256, WrapMode::repeat, TextureFilter::nearest, false});
  }
  void add_own(const BilinearTexture& texture) {
    list.push_back({texture.uv, 1, 256, 256, WrapMode::clamp, TextureFilter::bilinear, false});
  }
  std::span<const Texture> textures_;
};

bool has_size(const MipMap& image, const Part& part) {
  return image.level(0).width == part.width && image.level(0).height == part.height;
}

bool is_nearest(const Part& part) { return part.filter == TextureFilter::nearest; }

/// How all parts lie together, and how large a picture of them is.
struct PictureFrame {
  Part part;
  bool is_exact = true, lies_alike = true;
};

PictureFrame frame_of(const std::vector<Part>& parts) {
  PictureFrame frame;
  if (parts.empty()) return frame;
  frame.part = parts[0];
  for (const Part& part : parts) {
    frame.lies_alike = frame.lies_alike && lie_alike(part, parts[0]);
    frame.part.period = std::max(frame.part.period, part.period);
  }
  const int period = frame.part.period;
  for (const Part& part : parts) {
    frame.part.width = std::max(frame.part.width, part.width * period / part.period);
    frame.part.height = std::max(frame.part.height, part.height * period / part.period);
    if (!is_nearest(part)) frame.part.filter = part.filter;
  }
  const bool is_mixed = !is_nearest(frame.part) && std::any_of(parts.begin(), parts.end(), is_nearest);
  const bool are_exact =
      std::all_of(parts.begin(), parts.end(), [](const Part& part) { return part.is_exact; });
  frame.is_exact = frame.lies_alike && !is_mixed && are_exact;
  if (frame.lies_alike) return frame;
  frame.part.uv = {}, frame.part.period = 1, frame.part.wrap = WrapMode::repeat;
  frame.part.width = frame.part.height = least_texels;
  for (const Part& part : parts) {
    frame.part.width = std::max(frame.part.width, texels_of(part, 0));
    frame.part.height = std::max(frame.part.height, texels_of(part, 1));
  }
  return frame;
}

/// The textures with those that lie like the frame over the unit square, which is one period of theirs.
std::vector<Texture> in_frame(std::span<const Texture> textures, const PictureFrame& frame) {
  std::vector<Texture> list(textures.begin(), textures.end());
  if (!frame.lies_alike) return list;
  const UvTransform uv = scaled({}, float(frame.part.period));
  const auto place = [&](auto& texture) {
    if constexpr (requires { texture.uv; }) texture.uv = uv;
  };
  for (Texture& texture : list) std::visit(place, texture.model);
  return list;
}

/// The textures, where those that go by the point in the scene are their means.
std::vector<Texture> by_surface(std::span<const Texture> textures, const std::vector<bool>& by_position) {
  std::vector<Texture> list(textures.begin(), textures.end());
  std::vector<Rgb> means;
  for (std::size_t i = 0; i < list.size(); ++i) {
    means.push_back(mean_value(textures[i].model, means));
    if (by_position[i]) list[i].model = ConstantTexture{means[i]};
  }
  return list;
}

Image drawn(std::span<const Texture> textures, std::uint32_t index, int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec2 uv{(float(x) + 0.5f) / float(width), 1 - (float(y) + 0.5f) / float(height)};
      image.at(x, y) = evaluate(textures, index, {.uv = uv, .is_smooth = true});
    }
  return image;
}

}  // namespace

BakedTextures bake_together(std::span<const Texture> all, std::span<const std::uint32_t> indices) {
  const std::vector<bool> by_position = go_by_position(all);
  const bool are_by_surface =
      std::none_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return by_position[i]; });
  const std::vector<Texture> on_surface =
      are_by_surface ? std::vector<Texture>() : by_surface(all, by_position);
  const std::span<const Texture> textures = are_by_surface ? all : on_surface;
  Parts parts(textures);
  for (const std::uint32_t index : indices) parts.add(index);
  const PictureFrame frame = frame_of(parts.list);
  const Part& part = frame.part;
  const std::vector<Texture> placed = in_frame(textures, frame);
  BakedTextures baked;
  baked.frame = {
      {}, scaled(part.uv, 1 / float(part.period)), part.wrap, part.filter, frame.is_exact && are_by_surface};
  for (const std::uint32_t index : indices) {
    const auto* image = std::get_if<ImageTexture>(&textures[index].model);
    const bool is_itself = image && frame.lies_alike && part.period == 1 && has_size(*image->image, part);
    baked.pictures.push_back(is_itself ? image->image->image(0)
                                       : drawn(placed, index, part.width, part.height));
  }
  return baked;
}

BakedTexture bake(std::span<const Texture> textures, std::uint32_t index) {
  BakedTextures together = bake_together(textures, std::span(&index, 1));
  BakedTexture baked = std::move(together.frame);
  baked.picture = std::move(together.pictures[0]);
  return baked;
}

}  // namespace twinray
