// SPDX-License-Identifier: Apache-2.0
#include "io/picture/jpeg_reader.h"

#include <cstddef>
#include <cstdio>  // Before jpeglib.h, which does without it.
#include <vector>

#include <jerror.h>
#include <jpeglib.h>

namespace twinray {
namespace {

/// Exceptions pass through libjpeg, as through libpng.
[[noreturn]] void fail_reading(j_common_ptr jpeg) {
  char reason[JMSG_LENGTH_MAX];
  jpeg->err->format_message(jpeg, reason);
  fail_picture(*static_cast<const PictureBytes*>(jpeg->client_data), reason);
}

/// libjpeg goes on with grey where data are missing: a fault here. All else that it warns of does no harm.
void take_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  for (const int fault : {JWRN_HIT_MARKER, JWRN_HUFF_BAD_CODE, JWRN_JPEG_EOF, JWRN_MUST_RESYNC})
    if (jpeg->err->msg_code == fault) fail_reading(jpeg);
}

/// libjpeg's state of one file that is being read.
class JpegFile {
 public:
  /// `check` sees the header.
  JpegFile(const PictureBytes& picture, const HeaderCheck& check) {
    jpeg_.err = jpeg_std_error(&errors_);
    jpeg_.client_data = const_cast<PictureBytes*>(&picture);
    errors_.error_exit = fail_reading;
    errors_.emit_message = take_message;
    jpeg_create_decompress(&jpeg_);
    try {
      begin(picture, check);
    } catch (...) {
      jpeg_destroy_decompress(&jpeg_);
      throw;
    }
  }
  ~JpegFile() { jpeg_destroy_decompress(&jpeg_); }
  JpegFile(const JpegFile&) = delete;
  JpegFile& operator=(const JpegFile&) = delete;

  Image read() {
    jpeg_start_decompress(&jpeg_);
    Image image(int(jpeg_.output_width), int(jpeg_.output_height));
    std::vector<JSAMPLE> row(std::size_t(jpeg_.output_width) * std::size_t(jpeg_.output_components));
    for (int y = 0; y < image.height; ++y) {
      JSAMPROW const rows[]{row.data()};
      jpeg_read_scanlines(&jpeg_, const_cast<JSAMPARRAY>(rows), 1);
      const JSAMPLE* at = row.data();
      for (int x = 0; x < image.width; ++x, at += jpeg_.output_components) image.at(x, y) = pixel(at);
    }
    jpeg_finish_decompress(&jpeg_);
    return image;
  }

 private:
  void begin(const PictureBytes& picture, const HeaderCheck& check) {
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(picture.bytes.data()),
                 static_cast<unsigned long>(picture.bytes.size()));
    jpeg_read_header(&jpeg_, TRUE);
    check({int(jpeg_.image_width), int(jpeg_.image_height), jpeg_.num_components});
    const bool is_for_printers = jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
    jpeg_.out_color_space = is_for_printers                           ? JCS_CMYK
                            : jpeg_.jpeg_color_space == JCS_GRAYSCALE ? JCS_GRAYSCALE
                                                                      : JCS_RGB;
  }

  Rgb pixel(const JSAMPLE* at) const {
    const auto unit = [](int byte) { return float(byte) * (1.0f / 255); };  // As OpenImageIO scales it.
    switch (jpeg_.out_color_space) {
      case JCS_GRAYSCALE:
        return {unit(at[0]), unit(at[0]), unit(at[0])};
      case JCS_CMYK: {  // Stored as what is left of white.
        const auto printed = [&](int c) { return unit((at[c] * at[3] + 127) / 255); };
        return {printed(0), printed(1), printed(2)};
      }
      default:
        return {unit(at[0]), unit(at[1]), unit(at[2])};
    }
  }

  jpeg_error_mgr errors_{};
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

Image decode_jpeg(const PictureBytes& picture, const HeaderCheck& check) {
  return JpegFile(picture, check).read();
}

}  // namespace twinray
