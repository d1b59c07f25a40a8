// SPDX-License-Identifier: Apache-2.0
#include "io/picture/exr_attributes.h"

#include <ImfChannelList.h>
#include <ImfMatrixAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string_view>
#include <tuple>

#include "io/lower_case.h"

namespace twinray {
namespace {

/// OpenEXR's name of the time that a picture was made at.
constexpr const char* time_name = "capDate";
constexpr const char* matrix_names[] = {"worldToCamera", "worldToNDC"};

/// Where a channel stands in its layer.
std::size_t rank(std::string_view name) {
  constexpr std::string_view first[] = {"R", "G", "B", "X", "Y", "A", "Z"};
  const std::string_view usual = usual_channel(name);
  const auto place = std::size_t(std::find(std::begin(first), std::end(first), usual) - std::begin(first));
  return usual == name ? place : std::size(first) + place;
}

bool is_shown_before(const PictureChannel& a, const PictureChannel& b) {
  const auto [layer_a, name_a] = layer_and_name(a.name);
  const auto [layer_b, name_b] = layer_and_name(b.name);
  return std::tuple(layer_a, rank(name_a), name_a) < std::tuple(layer_b, rank(name_b), name_b);
}

using StoredMatrix = std::array<float, 16>;
static_assert(sizeof(StoredMatrix) == sizeof(Imath::M44f));

std::optional<StoredMatrix> matrix_of(const Imf::Header& header, const char* name) {
  const auto* attribute = header.findTypedAttribute<Imf::M44fAttribute>(name);
  if (!attribute) return std::nullopt;
  StoredMatrix matrix;
  std::memcpy(matrix.data(), attribute->value().x, sizeof(matrix));
  return matrix;
}

void add_matrix(Imf::Header& header, const char* name, const StoredMatrix& matrix) {
  Imath::M44f value;
  std::memcpy(value.x, matrix.data(), sizeof(matrix));
  header.insert(name, Imf::M44fAttribute(value));
}

}  // namespace

std::pair<std::string_view, std::string_view> layer_and_name(std::string_view channel) {
  const std::size_t dot = channel.rfind('.');
  if (dot == channel.npos) return {"", channel};
  return {channel.substr(0, dot), channel.substr(dot + 1)};
}

std::string_view usual_channel(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"r", "R"}, {"g", "G"}, {"b", "B"}, {"red", "R"}, {"green", "G"}, {"blue", "B"}, {"alpha", "A"}};
  const std::string small = lower_case(std::string(name));
  for (const auto& [word, usual] : words)
    if (small == word) return usual;
  return name;
}

std::vector<PictureChannel> channels_of(const Imf::Header& header) {
  std::vector<PictureChannel> channels;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    channels.push_back({it.name(), it.channel().type == Imf::HALF});
  std::sort(channels.begin(), channels.end(), is_shown_before);
  return channels;
}

ImageMetadata texts_of(const Imf::Header& header) {
  ImageMetadata texts;
  for (auto it = header.begin(); it != header.end(); ++it) {
    const std::string name = it.name();
    if (name == "type") continue;  // Of the file's parts.
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
      texts.emplace_back(name == time_name ? "DateTime" : name, text->value());
  }
  return texts;
}

ImageFrame frame_of(const Imf::Header& header) {
  const Imath::Box2i &picture = header.dataWindow(), &whole = header.displayWindow();
  ImageFrame frame{picture.min.x - whole.min.x, picture.min.y - whole.min.y, whole.max.x - whole.min.x + 1,
                   whole.max.y - whole.min.y + 1};
  if (const auto to_camera = matrix_of(header, matrix_names[0]))
    frame.camera = CameraMatrices{*to_camera, matrix_of(header, matrix_names[1])};
  return frame;
}

std::optional<Primaries> primaries_of(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return std::nullopt;
  const auto at = [](const Imath::V2f& point) { return Chromaticity{double(point.x), double(point.y)}; };
  const Imf::Chromaticities& all = Imf::chromaticities(header);
  return Primaries{at(all.red), at(all.green), at(all.blue), at(all.white)};
}

Imf::Header header_of(int width, int height, const ImageMetadata& metadata, const ImageFrame& frame) {
  const Imath::Box2i picture({frame.x, frame.y}, {frame.x + width - 1, frame.y + height - 1});
  const Imath::Box2i whole(
      {0, 0}, {(frame.width > 0 ? frame.width : width) - 1, (frame.height > 0 ? frame.height : height) - 1});
  Imf::Header header(whole, picture);
  for (const auto& [name, value] : metadata) {
    const std::string stored = name == "DateTime" ? time_name : name;
    if (header.find(stored) == header.end()) header.insert(stored, Imf::StringAttribute(value));
  }
  Imf::addChromaticities(header, {});  // Those of sRGB and Rec. 709, and the white D65.
  if (frame.camera) {
    add_matrix(header, matrix_names[0], frame.camera->world_to_camera);
    if (frame.camera->world_to_ndc) add_matrix(header, matrix_names[1], *frame.camera->world_to_ndc);
  }
  return header;
}

}  // namespace twinray
