// SPDX-License-Identifier: Apache-2.0
#include "cli/layered_picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/picture/cryptomatte.h"
#include "io/utf8.h"

namespace twinray {
namespace {

/// Appends the first `count` channels.
float* append(const Rgb& value, std::size_t count, float* to) {
  const float channels[] = {value.r, value.g, value.b};
  for (std::size_t i = 0; i < count; ++i) *to++ = channels[i];
  return to;
}

/// Names, one a line, in UTF-8 as other programs expect text of OpenEXR.
std::string lines_of(const std::vector<std::string>& names) {
  std::vector<std::string> lines;
  for (const std::string& name : names) {
    std::string& line = lines.emplace_back(as_utf8(name));
    for (char& c : line)
      if (c == '\n' || c == '\r') c = ' ';
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

bool is_matte(Layer layer) { return layer_info(layer).gathering == Gathering::coverage; }

/// What a layer of mattes is called, and the names of what it tells apart.
struct MatteKind {
  const char* name;
  const std::vector<std::string>& things;
};
MatteKind matte_kind(Layer layer, const SceneNames& names) {
  if (layer == Layer::object_matte) return {"CryptoObject", names.objects};
  if (layer == Layer::material_matte) return {"CryptoMaterial", names.materials};
  return {"CryptoAsset", names.assets};
}

/// The values of a picture's rows.
class Rows {
 public:
  Rows(const Film& film, const SceneNames& names, const DenoisedPicture* denoised)
      : film_(film), denoised_(denoised) {
    for (const Layer layer : film.layers()) {
      std::vector<std::uint32_t>& ids = matte_ids_.emplace_back();
      if (!is_matte(layer)) continue;
      for (const std::string& thing : matte_kind(layer, names).things) ids.push_back(cryptomatte_id(thing));
    }
  }

  void fill(int y, std::span<float> values) const {
    float* next = values.data();
    for (int x = film_.window().x0; x < film_.window().x1; ++x) {
      const Rgb mean = film_.pixel(x, y).mean();
      next = append(denoised_ ? denoised_at(denoised_->image, x, y) : mean, 3, next);
      for (std::size_t layer = 0; layer < film_.layers().size(); ++layer)
        next = append_layer(layer, x, y, next);
      next = append_parts(Division::paths, x, y, next);
      if (!denoises_groups()) next = append_parts(Division::groups, x, y, next);
      if (!denoised_) continue;
      for (const Image& group : denoised_->light_groups) next = append(denoised_at(group, x, y), 3, next);
      next = append(mean, 3, next);
      if (denoises_groups()) next = append_parts(Division::groups, x, y, next);
    }
  }

 private:
  bool denoises_groups() const { return denoised_ && !denoised_->light_groups.empty(); }

  Rgb denoised_at(const Image& image, int x, int y) const {
    return image.at(x - film_.window().x0, y - film_.window().y0);
  }

  float* append_layer(std::size_t layer, int x, int y, float* to) const {
    const std::size_t channels = channel_count(film_.layers()[layer]);
    if (!is_matte(film_.layers()[layer])) return append(film_.value(layer, x, y), channels, to);
    write_ranks(coverages(layer, x, y), {to, channels});
    return to + channels;
  }

  /// Things of one name are one thing.
  std::span<MatteCoverage> coverages(std::size_t layer, int x, int y) const {
    static thread_local std::vector<MatteCoverage> all;
    all.clear();
    for (const auto& [thing, count] : film_.coverage(layer, x, y)) {
      const std::uint32_t id = matte_ids_[layer][thing - 1];
      const float part = float(double(count) / film_.pixel(x, y).count);
      const auto same =
          std::find_if(all.begin(), all.end(), [id](const MatteCoverage& one) { return one.id == id; });
      if (same == all.end())
        all.push_back({id, part});
      else
        same->coverage += part;
    }
    return all;
  }

  float* append_parts(Division division, int x, int y, float* to) const {
    std::vector<Rgb> parts(film_.contents().parts[std::size_t(division)]);
    if (parts.empty()) return to;
    film_.read_parts(division, x, y, parts);
    for (const Rgb& part : parts) to = append(part, 3, to);
    return to;
  }

  const Film& film_;
  const DenoisedPicture* denoised_;                    ///< Null: there is none.
  std::vector<std::vector<std::uint32_t>> matte_ids_;  ///< For each layer that is of mattes, by thing.
};

void add_color(std::vector<PictureChannel>& channels, const std::string& layer) {
  for (const char channel : {'R', 'G', 'B'}) channels.push_back({fmt::format("{}.{}", layer, channel)});
}

}  // namespace

LayeredImage layered_picture(const Film& film, const SceneNames& names, const DenoisedPicture* denoised) {
  const PixelRect& window = film.window();
  LayeredImage image{window.width(), window.height(), {{"R"}, {"G"}, {"B"}}, {}};
  for (const Layer layer : film.layers())
    for (const std::string& channel : layer_info(layer).channels)
      image.channels.push_back({channel, layer_info(layer).is_half});
  const auto& [paths, groups] = film.contents().parts;
  for (std::size_t path = 0; path < paths; ++path)
    add_color(image.channels, light_path_name(LightPath(path)));
  for (std::size_t group = 0; group < groups; ++group)
    add_color(image.channels, light_group_layer(names.light_groups[group]));
  if (denoised) {
    add_color(image.channels, "noisy");
    for (std::size_t group = 0; group < denoised->light_groups.size(); ++group)
      add_color(image.channels, "noisy_" + light_group_layer(names.light_groups[group]));
  }
  image.fill_row = [rows = Rows(film, names, denoised), first = window.y0](int y, std::span<float> values) {
    rows.fill(first + y, values);
  };
  return image;
}

ImageMetadata layer_metadata(const FilmContents& contents, const SceneNames& names) {
  ImageMetadata metadata;
  for (const Layer layer : contents.layers) {
    if (layer == Layer::ids) {
      metadata.emplace_back("twinray:object_id", lines_of(names.objects));
      metadata.emplace_back("twinray:material_id", lines_of(names.materials));
    }
    if (!is_matte(layer)) continue;
    const auto& [kind, things] = matte_kind(layer, names);
    for (auto& entry : cryptomatte_metadata(kind, things)) metadata.push_back(std::move(entry));
  }
  return metadata;
}

}  // namespace twinray
