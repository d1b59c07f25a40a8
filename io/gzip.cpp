// SPDX-License-Identifier: Apache-2.0
#include "io/gzip.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/error.h"
#include "io/input_file.h"

namespace twinray {
namespace {

struct EndInflate {
  void operator()(z_stream* stream) const { inflateEnd(stream); }
};

/// Takes a gzip header and its checksum; a bit in zlib's number of window bits.
constexpr int gzip_window_bits = 15 + 16;

void check_growth(const std::string& name, std::uint64_t unpacked, std::uint64_t packed) {
  if (unpacked > max_input_bytes)
    throw Error(fmt::format("{}: unpacked, the file has more than {} bytes, the most that are read", name,
                            max_input_bytes));
  if (unpacked > gzip_small_bytes && unpacked / gzip_most_growth > packed)
    throw Error(fmt::format("{}: {} bytes of gzip grow beyond {} bytes, more than a hundredfold", name,
                            packed, gzip_small_bytes));
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.substr(0, 2) == "\x1f\x8b"; }

std::string unpack_gzip(std::string_view bytes, const std::string& name) {
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window_bits) != Z_OK)
    throw Error(name + ": there is no memory to unpack it");
  const std::unique_ptr<z_stream, EndInflate> end(&stream);
  // zlib reads through a pointer that is not const, and writes nothing there.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max()));
  std::string text;
  char block[1 << 16];
  while (true) {
    stream.next_out = reinterpret_cast<Bytef*>(block);
    stream.avail_out = sizeof block;
    const int code = inflate(&stream, Z_NO_FLUSH);
    text.append(block, sizeof block - stream.avail_out);
    check_growth(name, text.size(), bytes.size());
    if (code == Z_STREAM_END) {
      const std::string_view rest = bytes.substr(bytes.size() - stream.avail_in);
      if (!is_gzip(rest)) return text;  // what follows the last member is padding
      inflateReset(&stream);
    } else if (code == Z_BUF_ERROR) {
      throw Error(name + ": the gzip file is cut off");
    } else if (code != Z_OK) {
      throw Error(fmt::format("{}: the gzip file is damaged: {}", name, stream.msg ? stream.msg : "unknown"));
    }
  }
}

void unpack_zlib(std::string_view packed, std::span<char> room, const std::string& name) {
  uLongf size = room.size();
  const int code = uncompress(reinterpret_cast<Bytef*>(room.data()), &size,
                              reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (code != Z_OK || size != room.size()) throw Error(name + ": what zlib has packed is damaged");
}

std::string read_unpacked(const std::string& path) {
  std::string bytes = read_input_file(path, "file");
  return is_gzip(bytes) ? unpack_gzip(bytes, path) : bytes;
}

}  // namespace twinray
