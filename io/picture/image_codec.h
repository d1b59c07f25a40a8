// SPDX-License-Identifier: Apache-2.0
// What OpenImageIO does here, behind an interface, so that the program starts without it. It brings
// along some 260 shared libraries, which take longer to load than a small picture to render.
#pragma once
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/image.h"
#include "io/picture/image_metadata.h"
#include "io/picture/output_format.h"
#include "io/picture/picture_header.h"

namespace twinray {

/// Reads and writes what the formats' own libraries do not. Any number of threads may use it.
class ImageCodec {
 public:
  virtual ~ImageCodec() = default;

  /// The colours of a Radiance picture (HDR). `check` sees the header.
  virtual Image read_hdr(const PictureBytes& picture, const HeaderCheck& check) const = 0;
  /// The texts beside the pixels of a JPEG or HDR picture.
  virtual ImageMetadata read_metadata(PictureFormat format, const PictureBytes& picture,
                                      const HeaderCheck& check) const = 0;
  /// The bytes of a TIFF file of 32-bit floats, or of a Radiance file (HDR).
  virtual std::vector<unsigned char> encode_floats(OutputFormat format, const std::string& path,
                                                   const Image& image,
                                                   const ImageMetadata& metadata) const = 0;
  /// The bytes of a JPEG file of quality 95 whose colours have the picture's resolution.
  virtual std::vector<unsigned char> encode_jpeg(const std::string& path, const ByteImage& image,
                                                 const ImageMetadata& metadata) const = 0;
  /// What the OpenColorIO configuration that $OCIO names makes of linear colours for a display, encoded.
  /// Without a name of a display its first one. Throws Error where there is no such configuration or view.
  virtual Image viewed(const Image& image, const std::string& display, const std::string& view) const = 0;
};

/// Whether it reads, or writes, a picture of this name.
bool codec_reads(const std::string& path);
bool codec_writes(const std::string& path);

/// The codec. Loads it where that has not been done; throws Error where it cannot be loaded.
const ImageCodec& image_codec();

/// Held while the codec is being loaded. Whoever begins a process holds it, too: a child that is begun in the
/// midst of loading could never load, or say, anything.
std::mutex& library_loading();

/// Begins in the background to load it, so that it is there when a picture needs it. Never fails. The thread,
/// if one can be made, must end before the process's exit does away with what it loads.
[[nodiscard]] std::jthread load_image_codec_early();

/// The function that the loaded library gives its codec by. Its name has a digest of these headers.
using ImageCodecFunction = const ImageCodec* (*)();

}  // namespace twinray
