// SPDX-License-Identifier: Apache-2.0
// The reader of film files on any bytes. The first byte says what the others are: a header's JSON, the
// columns of a film, or a file, whose hash of the header is set right, since no mutation would find it.
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "core/columns.h"
#include "core/error.h"
#include "io/film/content_hash.h"
#include "io/film/film_file.h"
#include "tests/fuzz/require.h"

namespace twinray::fuzz {
namespace {

void read_header(const std::string& json) {
  const FilmHeader header = parse_film_header(json);
  require(parse_film_header(film_header_json(header)) == header);
}

void read_columns(const std::string& bytes) {
  for (const FilmContents& contents :
       {FilmContents{}, FilmContents{.layers = {Layer::normal, Layer::depth}, .parts = {2}}}) {
    Film film(3, 2, {0, 0, 3, 2}, contents);
    ColumnReader columns(std::as_bytes(std::span(bytes)));
    try {
      film.load(columns);
    } catch (const Error&) {
    }
  }
}

/// Of a header that is there as a whole.
void set_hash_right(std::string& file) {
  constexpr std::size_t line = 15, begin = line + 16;
  std::uint64_t length = 0;
  if (file.size() < begin) return;
  std::memcpy(&length, file.data() + line, sizeof length);
  if (length > file.size() - begin) return;
  const std::uint64_t hash = content_hash(std::as_bytes(std::span(file).subspan(begin, length)));
  std::memcpy(file.data() + line + 8, &hash, sizeof hash);
}

/// A file in memory, by a name.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes) : descriptor_(memfd_create("film", MFD_CLOEXEC)) {
    require(write(descriptor_, bytes.data(), bytes.size()) == ssize_t(bytes.size()));
  }
  ~MemoryFile() { close(descriptor_); }
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void read_file(std::string bytes) {
  set_hash_right(bytes);
  const MemoryFile memory(bytes);
  try {
    FilmFile file(memory.path());
    const FilmHeader& header = file.header();
    constexpr std::int64_t most_pixels = 4096;
    if (std::int64_t(header.window.width()) * header.window.height() <= most_pixels) file.check(1);
  } catch (const Error& error) {
    require(std::string_view(error.what()).starts_with(memory.path()));
  }
}

}  // namespace
}  // namespace twinray::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  constexpr std::array readers{twinray::fuzz::read_header, twinray::fuzz::read_columns};
  if (data[0] % 3 == 2) {
    twinray::fuzz::read_file(rest);
    return 0;
  }
  try {
    readers.at(data[0] % 3)(rest);
  } catch (const twinray::Error&) {
  }
  return 0;
}
