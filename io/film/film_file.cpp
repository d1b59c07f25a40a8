// SPDX-License-Identifier: Apache-2.0
#include "io/film/film_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "core/columns.h"
#include "core/error.h"
#include "core/parallel.h"
#include "io/destination.h"
#include "io/film/content_hash.h"
#include "io/film/zstd.h"
#include "io/input_file.h"
#include "io/output_file.h"

namespace twinray {
namespace {

constexpr std::string_view first_line = "twinray film 1\n";
constexpr std::uint64_t most_header_bytes = std::uint64_t(1) << 30;
/// Bands have about so many bytes: enough to pack well, few enough to be many.
constexpr std::uint64_t usual_band_bytes = std::uint64_t(1) << 22;

/// What stands before each band.
struct BandHead {
  std::uint64_t bytes = 0, packed_bytes = 0;
  std::uint64_t hash = 0;  ///< Of the bytes before they are packed.
};

/// Rows [y0, y1) of one of the films.
struct BandPlace {
  std::size_t film = 0;
  int y0 = 0, y1 = 0;
};

/// Whether a band may have so many bytes: no more memory is taken than it could need. What covers pixels may
/// be much, but is then much in the file.
bool is_sound(const BandHead& head, std::uint64_t pixels, const FilmContents& contents) {
  constexpr std::uint64_t most_growth = 4096, overhead = 1 << 16;
  if (head.packed_bytes > std::uint64_t(1) << 40) return false;
  return head.bytes <= 2 * Film::bytes(pixels, contents) + overhead + most_growth * head.packed_bytes;
}

/// In the order of the file.
std::vector<BandPlace> bands_of(const FilmHeader& header) {
  const PixelRect& window = header.window;
  std::uint64_t row_bytes = 0;
  for (const FilmContents& contents : header.films)
    row_bytes = std::max(row_bytes, Film::bytes(std::uint64_t(window.width()), contents));
  const int rows = int(std::clamp<std::uint64_t>(usual_band_bytes / std::max<std::uint64_t>(row_bytes, 1), 1,
                                                 std::uint64_t(window.height())));
  std::vector<BandPlace> bands;
  for (int y = window.y0; y < window.y1; y += rows)
    for (std::size_t film = 0; film < header.films.size(); ++film)
      bands.push_back({film, y, std::min(y + rows, window.y1)});
  return bands;
}

struct PackedBand {
  BandHead head;
  std::vector<std::byte> bytes;
};

PackedBand pack(const Film& film, const BandPlace& place) {
  ColumnWriter columns;
  film.save(place.y0, place.y1, columns);
  PackedBand packed{.head = {}, .bytes = pack_zstd(columns.bytes())};
  packed.head = {columns.bytes().size(), packed.bytes.size(), content_hash(columns.bytes())};
  return packed;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <typename T>
std::string_view text_of_value(const T& value) {
  return text_of(std::as_bytes(std::span(&value, 1)));
}

/// Packed at the same time, written in their order.
std::size_t bands_together(int threads) {
  return std::size_t(threads > 0 ? threads : available_threads()) * 2;
}

}  // namespace

std::string earlier_film_name(const std::string& path) {
  const auto resolved = [&] {
    try {
      const Destination place = destination_of(path);
      return place.kind == Destination::Kind::file ? place.path : path;
    } catch (const Error&) {  // Nothing can be there.
      return path;
    }
  };
  return resolved() + ".before";
}

bool begins_as_film(const std::string& path) {
  std::string line(first_line.size(), '\0');
  return std::ifstream(path, std::ios::binary).read(line.data(), std::streamsize(line.size())) &&
         line == first_line;
}

std::uint64_t write_film_file(const std::string& path, std::span<const Film* const> films,
                              const std::string& notes, int threads) {
  const Film& first = *films.front();
  FilmHeader header{first.frame_width(), first.frame_height(), first.window(), {}, notes};
  for (const Film* const film : films) header.films.push_back(film->contents());
  OutputFile file(path);
  file.take_mode_and_owner();
  std::uint64_t written = 0;
  const auto write = [&](std::string_view bytes) {
    file.write(bytes);
    written += bytes.size();
  };
  const std::string json = film_header_json(header);
  write(first_line);
  write(text_of_value(std::uint64_t(json.size())));
  write(text_of_value(content_hash(std::as_bytes(std::span(json)))));
  write(json);
  const std::vector<BandPlace> bands = bands_of(header);
  std::vector<std::uint64_t> hashes;
  const std::size_t together = bands_together(threads);
  for (std::size_t begin = 0; begin < bands.size(); begin += together) {
    std::vector<PackedBand> packed(std::min(together, bands.size() - begin));
    parallel_for(packed.size(), 1, threads, [&](std::size_t i, std::size_t) {
      packed[i] = pack(*films[bands[begin + i].film], bands[begin + i]);
    });
    for (const PackedBand& band : packed) {
      write(text_of_value(band.head));
      write(text_of(band.bytes));
      hashes.push_back(band.head.hash);
    }
  }
  write(text_of_value(std::uint64_t(bands.size())));
  write(text_of_value(content_hash(std::as_bytes(std::span(hashes)))));
  file.finish_beside(std::filesystem::path(earlier_film_name(path)).filename().string());
  return written;
}

/// As it lies in the file.
struct FilmFile::Band {
  BandPlace place;
  BandHead head;
  std::string packed;
};

FilmFile::FilmFile(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  check_regular_file(path, "film");
  std::error_code error;
  bytes_ = std::filesystem::file_size(path, error);
  if (error || !file_) throw Error(path + ": the file cannot be opened; may it be read?");
  if (bytes_ < first_line.size() || read_text(first_line.size()) != first_line)
    fail("this is no film file of this version of the program");
  const auto length = read_value<std::uint64_t>(), hash = read_value<std::uint64_t>();
  if (length > most_header_bytes) fail("its beginning is damaged");
  const std::string json = read_text(length);
  if (content_hash(std::as_bytes(std::span(json))) != hash) fail("its beginning is damaged");
  bands_ = file_.tellg();
  try {
    header_ = parse_film_header(json);
  } catch (const Error& wrong) {
    fail(wrong.what());
  }
  read_end();
}

void FilmFile::fail(const std::string& reason) const { throw Error(fmt::format("{}: {}", path_, reason)); }

template <typename T>
T FilmFile::read_value() {
  T value{};
  const std::string bytes = read_text(sizeof(T));
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

std::string FilmFile::read_text(std::uint64_t bytes) {
  const auto place = std::uint64_t(file_.tellg());
  if (bytes > bytes_ || place > bytes_ - bytes) fail("it ends early");
  std::string text(std::size_t(bytes), '\0');
  if (!file_.read(text.data(), std::streamsize(text.size()))) fail("it cannot be read to its end");
  return text;
}

void FilmFile::read_end() {
  const std::uint64_t begin = std::uint64_t(bands_);
  if (bytes_ < begin + sizeof(End)) fail("it ends early");
  file_.seekg(std::streamoff(bytes_ - sizeof(End)));
  end_.bands = read_value<std::uint64_t>();
  end_.content = read_value<std::uint64_t>();
  if (end_.bands != bands_of(header_).size()) fail("it ends early");
}

FilmFile::Band FilmFile::read_band(std::size_t film, int y0, int y1) {
  Band band{{film, y0, y1}, read_value<BandHead>(), {}};
  const std::uint64_t pixels = std::uint64_t(header_.window.width()) * std::uint64_t(y1 - y0);
  if (!is_sound(band.head, pixels, header_.films[film])) fail("a band of it is damaged");
  band.packed = read_text(band.head.packed_bytes);
  return band;
}

void FilmFile::add(const Band& band, std::span<Film* const> films) const {
  const auto& [film, y0, y1] = band.place;
  const std::vector<std::byte> bytes = unpack_zstd(std::as_bytes(std::span(band.packed)), band.head.bytes);
  if (content_hash(bytes) != band.head.hash) throw Error("a band of it is damaged");
  Film rows(header_.frame_width, header_.frame_height, {header_.window.x0, y0, header_.window.x1, y1},
            header_.films[film]);
  ColumnReader columns(bytes);
  rows.load(columns);
  if (!columns.is_at_end()) throw Error("a band of it is too long");
  if (!films.empty()) films[film]->merge(rows);
}

void FilmFile::merge_into(std::span<Film* const> films, int threads) {
  file_.seekg(bands_);
  const std::vector<BandPlace> places = bands_of(header_);
  const std::size_t together = bands_together(threads);
  std::vector<std::uint64_t> hashes;
  for (std::size_t begin = 0; begin < places.size(); begin += together) {
    std::vector<Band> bands;
    for (std::size_t i = begin; i < std::min(begin + together, places.size()); ++i) {
      bands.push_back(read_band(places[i].film, places[i].y0, places[i].y1));
      hashes.push_back(bands.back().head.hash);
    }
    try {
      parallel_for(bands.size(), 1, threads, [&](std::size_t i, std::size_t) { add(bands[i], films); });
    } catch (const Error& error) {
      fail(error.what());
    }
  }
  if (content_hash(std::as_bytes(std::span(hashes))) != end_.content) fail("its end is damaged");
}

}  // namespace twinray
