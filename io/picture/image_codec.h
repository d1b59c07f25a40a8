// SPDX-License-Identifier: Apache-2.0
// What OpenImageIO does here, behind an interface, so that the program starts without it. It brings
// along some 260 shared libraries, which take longer to load than a small picture to render.
#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "core/mip_map.h"
#include "io/picture/image_metadata.h"
#include "io/picture/layered_image.h"
#include "io/picture/output_format.h"
#include "io/picture/picture_header.h"

namespace twinray {

/// What of a picture is read.
enum class PictureLayer { color, alpha };

/// A picture in tiles, with smaller levels, whose file is open. Any number of threads may read.
class TiledPictureFile {
 public:
  struct Size {
    int width = 0, height = 0, levels = 0;
    int tile_width = 0, tile_height = 0;
  };
  struct Tile {
    int level = 0, column = 0, row = 0;
  };
  virtual ~TiledPictureFile() = default;
  virtual const Size& size() const = 0;
  virtual const ImageMetadata& metadata() const = 0;
  /// All texels of a tile, row by row; what lies beside the level may be anything. Throws Error where the
  /// file does not have them.
  virtual void read(const Tile& tile, std::span<Rgb> texels) const = 0;
};

/// Reads and writes what PNG's own library does not. Any number of threads may use it.
class ImageCodec {
 public:
  struct Header {
    int width = 0, height = 0, channels = 0;
    bool is_deep = false;  ///< Several samples in depth, or several layers of them.
  };
  virtual ~ImageCodec() = default;

  /// The first three channels as they are stored, 8 and 16 bits as [0, 1]; the first one as grey where there
  /// are fewer; or the alpha channel as grey, 1 where there is none. `check` sees the header before memory is
  /// taken for pixels; it throws Error to refuse the file.
  virtual Image read(PictureFormat format, const PictureBytes& picture, PictureLayer layer,
                     const std::function<void(const Header&)>& check) const = 0;
  /// All channels of an OpenEXR picture. `check` as above.
  virtual StoredLayers read_layers(const PictureBytes& picture,
                                   const std::function<void(const Header&)>& check) const = 0;
  /// The texts beside the pixels of any picture. `check` as above.
  virtual ImageMetadata read_metadata(PictureFormat format, const PictureBytes& picture,
                                      const std::function<void(const Header&)>& check) const = 0;
  /// The channel of that name of an OpenEXR picture, row by row; empty where it has none. `check` as above.
  virtual std::vector<float> read_channel(const PictureBytes& picture, const std::string& name,
                                          const std::function<void(const Header&)>& check) const = 0;
  /// The bytes of an OpenEXR file; write_exr says of what. `path` stands in messages alone.
  virtual std::vector<unsigned char> encode_exr(const std::string& path, const LayeredImage& image,
                                                const ImageMetadata& metadata,
                                                const ImageFrame& frame) const = 0;
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
  /// Opens an OpenEXR file of one part in tiles, with channels R, G, B of 32-bit floats alone. Its header was
  /// checked before. Throws Error.
  virtual std::unique_ptr<const TiledPictureFile> open_tiled(const std::string& path) const = 0;
  /// The bytes of such a file, with all levels.
  virtual std::vector<unsigned char> encode_tiled(const std::string& path, const MipMap& map, int tile_side,
                                                  const ImageMetadata& metadata) const = 0;
};

/// The codec. Loads it where that has not been done; throws Error where it cannot be loaded.
const ImageCodec& image_codec();

/// Held while the codec is being loaded. Whoever begins a process holds it, too: a child that is begun in the
/// midst of loading could never load, or say, anything.
std::mutex& library_loading();

/// Begins in the background to load it, so that it is there when a picture needs it. Never fails. The thread,
/// if one can be made, must end before the process's exit does away with what it loads.
[[nodiscard]] std::jthread load_image_codec_early();

/// The name of the function that the loaded library gives its codec by, and its type.
inline constexpr const char* image_codec_symbol = "twinray_image_codec";
using ImageCodecFunction = const ImageCodec* (*)();

}  // namespace twinray
