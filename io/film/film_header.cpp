// SPDX-License-Identifier: Apache-2.0
#include "io/film/film_header.h"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace twinray {
namespace {

using nlohmann::json;

/// More than a film has of parts of its light: a light group each.
constexpr std::int64_t most_parts = 1 << 20;
/// Farther than any pixel of a frame, or beside it.
constexpr std::int64_t most_coordinate = 1 << 30;
/// That of all samples, and their halves.
constexpr std::size_t most_films = 3;

json contents_json(const FilmContents& contents) {
  json layers = json::array();
  for (const Layer layer : contents.layers) layers.push_back(layer_info(layer).name);
  return {{"layers", layers}, {"parts", contents.parts}};
}

Layer layer_named(const std::string& name) {
  for (const Layer layer : all_layers())
    if (layer_info(layer).name == name) return layer;
  throw Error(fmt::format("there is no layer \"{}\"", name));
}

/// A whole number from `least` to `most`. What the library makes of others is undefined, or another number.
std::int64_t whole_number(const json& value, std::int64_t least, std::int64_t most) {
  const bool is_large = value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t(most);
  const bool is_whole = value.is_number_integer() && !is_large;
  if (is_whole && value.get<std::int64_t>() >= least && value.get<std::int64_t>() <= most)
    return value.get<std::int64_t>();
  throw Error(fmt::format("{} stands where a whole number from {} to {} should", value.dump(), least, most));
}
int coordinate(const json& value) { return int(whole_number(value, -most_coordinate, most_coordinate)); }

FilmContents parse_contents(const json& contents) {
  FilmContents parsed;
  for (const json& name : contents.at("layers")) parsed.layers.push_back(layer_named(name));
  for (std::size_t i = 0; i < parsed.parts.size(); ++i)
    parsed.parts[i] = std::size_t(whole_number(contents.at("parts").at(i), 0, most_parts));
  return parsed;
}

/// Throws Error for a frame and a window of which there can be no film; takes no memory for one.
void check_frame(const FilmHeader& header) {
  const auto& [x0, y0, x1, y1] = header.window;
  if (x0 >= x1 || y0 >= y1) throw Error("its window is empty");
  Film(header.frame_width, header.frame_height, {x0, y0, x0 + 1, y0 + 1});
  Film(header.frame_width, header.frame_height, {x1 - 1, y1 - 1, x1, y1});
  if (header.films.empty() || header.films.size() > most_films)
    throw Error(fmt::format("{} films; valid are 1 to {}", header.films.size(), most_films));
}

FilmHeader parse(const json& root) {
  FilmHeader header;
  header.frame_width = coordinate(root.at("frame").at(0));
  header.frame_height = coordinate(root.at("frame").at(1));
  const json& window = root.at("window");
  header.window = {coordinate(window.at(0)), coordinate(window.at(1)), coordinate(window.at(2)),
                   coordinate(window.at(3))};
  for (const json& film : root.at("films")) header.films.push_back(parse_contents(film));
  header.notes = root.at("notes").dump();
  check_frame(header);
  return header;
}

}  // namespace

std::vector<Film> FilmHeader::make_films() const {
  std::vector<Film> made;
  for (const FilmContents& contents : films) made.emplace_back(frame_width, frame_height, window, contents);
  return made;
}

std::string film_header_json(const FilmHeader& header) {
  json films = json::array();
  for (const FilmContents& contents : header.films) films.push_back(contents_json(contents));
  const auto& [x0, y0, x1, y1] = header.window;
  return json{{"frame", {header.frame_width, header.frame_height}},
              {"window", {x0, y0, x1, y1}},
              {"films", films},
              {"notes", json::parse(header.notes)}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

FilmHeader parse_film_header(const std::string& text) {
  try {
    return parse(json::parse(text));
  } catch (const json::exception& error) {
    throw Error(fmt::format("its beginning cannot be read: {}", error.what()));
  }
}

}  // namespace twinray
