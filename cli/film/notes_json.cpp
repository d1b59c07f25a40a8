// SPDX-License-Identifier: Apache-2.0
// The notes of a film as JSON, and back.
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/film/film_notes.h"
#include "core/error.h"

namespace twinray {
namespace {

using nlohmann::json;

template <typename Range>
json range_json(const std::optional<Range>& range) {
  return range ? json{range->begin, range->end} : json();
}

template <typename Range>
std::optional<Range> parse_range(const json& range) {
  if (range.is_null()) return std::nullopt;
  return Range{range.at(0), range.at(1)};
}

json identity_json(const RenderIdentity& identity) {
  const auto& [x0, y0, x1, y1] = identity.window;
  return {{"program", identity.program},
          {"files", identity.files},
          {"options", identity.options},
          {"size", {identity.width, identity.height}},
          {"window", {x0, y0, x1, y1}}};
}

RenderIdentity parse_identity(const json& from) {
  RenderIdentity identity;
  identity.program = from.at("program");
  identity.files = from.at("files").get<std::map<std::string, std::string>>();
  identity.options = from.at("options").get<std::map<std::string, Words>>();
  identity.width = from.at("size").at(0);
  identity.height = from.at("size").at(1);
  const json& window = from.at("window");
  identity.window = {window.at(0), window.at(1), window.at(2), window.at(3)};
  return identity;
}

constexpr std::uint64_t QueryCounts::*counts[] = {&QueryCounts::nodes, &QueryCounts::boxes,
                                                  &QueryCounts::leaves, &QueryCounts::primitives};

json rays_json(const RayCounts& rays) {
  json all{rays.camera, rays.shadow, rays.bounce};
  for (const auto count : counts) all.push_back(rays.queries.*count);
  return all;
}

RayCounts parse_rays(const json& from) {
  RayCounts rays{from.at(0), from.at(1), from.at(2), {}};
  for (std::size_t i = 0; i < std::size(counts); ++i) rays.queries.*counts[i] = from.at(3 + i);
  return rays;
}

json progress_json(const FilmProgress& progress) {
  return {{"rays", rays_json(progress.rays)},
          {"samples", progress.samples},
          {"next_estimate", progress.next_estimate},
          {"error", progress.error ? json(*progress.error) : json()},
          {"seconds", progress.seconds}};
}

FilmProgress parse_progress(const json& from) {
  FilmProgress progress{
      parse_rays(from.at("rays")), from.at("samples"), from.at("next_estimate"), {}, from.at("seconds")};
  if (!from.at("error").is_null()) progress.error = from.at("error").get<double>();
  return progress;
}

json camera_json(const std::optional<CameraMatrices>& camera) {
  if (!camera) return {};
  return {{"world_to_camera", camera->world_to_camera},
          {"world_to_ndc", camera->world_to_ndc ? json(*camera->world_to_ndc) : json()}};
}

std::optional<CameraMatrices> parse_camera(const json& from) {
  using Matrix = std::array<float, 16>;
  if (from.is_null()) return std::nullopt;
  CameraMatrices camera{from.at("world_to_camera").get<Matrix>(), {}};
  if (!from.at("world_to_ndc").is_null()) camera.world_to_ndc = from.at("world_to_ndc").get<Matrix>();
  return camera;
}

json picture_json(const PictureNotes& picture) {
  return {{"metadata", picture.metadata},     {"camera", camera_json(picture.frame.camera)},
          {"objects", picture.names.objects}, {"materials", picture.names.materials},
          {"assets", picture.names.assets},   {"light_groups", picture.names.light_groups}};
}

PictureNotes parse_picture(const json& from, const RenderIdentity& identity) {
  return {from.at("metadata").get<ImageMetadata>(),
          {identity.window.x0, identity.window.y0, identity.width, identity.height,
           parse_camera(from.at("camera"))},
          {from.at("objects"), from.at("materials"), from.at("assets"), from.at("light_groups")}};
}

FilmNotes parse(const json& from) {
  FilmNotes notes;
  notes.identity = parse_identity(from.at("identity"));
  notes.samples = from.at("samples");
  notes.range = parse_range<SampleRange>(from.at("sample_range"));
  notes.tiles = parse_range<TileRange>(from.at("tile_range"));
  notes.progress = parse_progress(from.at("progress"));
  notes.is_complete = from.at("is_complete");
  notes.words = from.at("words").get<Words>();
  notes.folder = from.at("folder");
  notes.picture = parse_picture(from.at("picture"), notes.identity);
  return notes;
}

}  // namespace

std::string film_notes_json(const FilmNotes& notes) {
  return json{{"identity", identity_json(notes.identity)},
              {"samples", notes.samples},
              {"sample_range", range_json(notes.range)},
              {"tile_range", range_json(notes.tiles)},
              {"progress", progress_json(notes.progress)},
              {"is_complete", notes.is_complete},
              {"words", notes.words},
              {"folder", notes.folder},
              {"picture", picture_json(notes.picture)}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

FilmNotes parse_film_notes(const std::string& text) {
  try {
    return parse(json::parse(text));
  } catch (const json::exception& error) {
    throw Error(fmt::format("what it says of its render cannot be read: {}", error.what()));
  }
}

}  // namespace twinray
