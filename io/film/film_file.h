// SPDX-License-Identifier: Apache-2.0
// Film files: the exact sums of films, as they are kept between the processes of a render and merged from
// many machines.
//
// A file begins with a line that names the format, and a header. Bands of rows follow, from the top down, of
// each film in turn: columns of numbers (core/columns.h), packed, each with its length and a hash. The end
// has a hash of these. So a file of which anything is missing or changed is known as such, and equal films
// give equal ends.
#pragma once
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "io/film/film_header.h"

namespace twinray {

/// Writes films of one frame and window, on up to `threads` threads (0: as many as the process may use). A
/// file that is replaced stays as earlier_film_name() says. `notes` is a JSON object. Returns the bytes that
/// were written. Throws Error; the old file then survives.
std::uint64_t write_film_file(const std::string& path, std::span<const Film* const> films,
                              const std::string& notes, int threads = 0);

/// "a/b.film" -> "a/b.film.before": the file that was replaced last. Beside the film itself where the path is
/// a link to it.
std::string earlier_film_name(const std::string& path);

/// Whether there is a file that begins as films do; the rest of it may be damaged.
bool begins_as_film(const std::string& path);

/// A film file that is open. Each function throws Error, which begins with the path, where the file is not as
/// it was written.
class FilmFile {
 public:
  explicit FilmFile(const std::string& path);

  const std::string& path() const { return path_; }
  const FilmHeader& header() const { return header_; }
  /// Equal where all films are.
  std::uint64_t content() const { return end_.content; }
  /// Adds its samples to films of the same frame and contents, whose window has the file's within, on up to
  /// `threads` threads; memory is taken for some bands alone. Where it throws, the films are of no use.
  void merge_into(std::span<Film* const> films, int threads = 0);
  /// Reads everything.
  void check(int threads = 0) { merge_into({}, threads); }

 private:
  struct End {
    std::uint64_t bands = 0, content = 0;
  };
  struct Band;
  [[noreturn]] void fail(const std::string& reason) const;
  template <typename T>
  T read_value();
  std::string read_text(std::uint64_t bytes);
  void read_end();
  Band read_band(std::size_t film, int y0, int y1);
  void add(const Band& band, std::span<Film* const> films) const;

  std::string path_;
  std::ifstream file_;
  std::uint64_t bytes_ = 0;  ///< Of the file.
  FilmHeader header_;
  std::streamoff bands_ = 0;  ///< Where the first one begins.
  End end_;
};

}  // namespace twinray
