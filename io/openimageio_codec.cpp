// SPDX-License-Identifier: Apache-2.0
// The only door to OpenImageIO: a shared library of its own, which image_codec.cpp loads.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <memory>

#include "core/error.h"
#include "io/image_codec.h"

namespace twinray {
namespace {

/// OpenEXR would make as many threads as the machine has for every file, and fail where it gets none.
void use_no_threads() { OIIO::attribute("exr_threads", -1); }

OIIO::ImageSpec exr_spec(const Image& image, const ImageMetadata& metadata, const ImageFrame& frame) {
  static_assert(sizeof(Rgb) == 3 * sizeof(float));
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT);
  spec.x = frame.x;
  spec.y = frame.y;
  spec.full_width = frame.width > 0 ? frame.width : image.width;
  spec.full_height = frame.height > 0 ? frame.height : image.height;
  spec.attribute("DateTime", "");  // Without any, OpenImageIO would take the time of now.
  for (const auto& [name, value] : metadata) spec.attribute(name, value);
  return spec;
}

/// The first three channels of all pixels, or the first one as grey.
Image read_pixels(OIIO::ImageInput& input, const ImageCodec::Header& header, const std::string& path) {
  Image image(header.width, header.height);
  const int channels = header.channels >= 3 ? 3 : 1;
  const auto pixel_bytes = OIIO::stride_t(sizeof(Rgb));
  if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, image.pixels.data(), pixel_bytes))
    throw Error(fmt::format("{}: cannot be read: {}", path, input.geterror()));
  if (channels == 1)
    for (Rgb& pixel : image.pixels) pixel = {pixel.r, pixel.r, pixel.r};
  return image;
}

class OpenImageIOCodec final : public ImageCodec {
 public:
  Image read(const std::string& path, const char* format,
             const std::function<void(const Header&)>& check) const override {
    use_no_threads();
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    if (!input || !input->open(path, spec))
      throw Error(fmt::format("{}: cannot be read: {}", path, input ? input->geterror() : OIIO::geterror()));
    const Header header{spec.width, spec.height, spec.nchannels, spec.depth > 1 || spec.deep};
    check(header);
    return read_pixels(*input, header, path);
  }

  /// Put together in memory: a pipe cannot be written in any other order.
  std::vector<unsigned char> encode_exr(const std::string& path, const Image& image,
                                        const ImageMetadata& metadata,
                                        const ImageFrame& frame) const override {
    use_no_threads();
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
    if (!output || !output->set_ioproxy(&memory))
      throw Error(fmt::format("{}: OpenImageIO cannot write OpenEXR: {}", path, OIIO::geterror()));
    const OIIO::ImageSpec spec = exr_spec(image, metadata, frame);
    if (!output->open(path, spec) || !output->write_image(spec.format, image.pixels.data()) ||
        !output->close())
      throw Error(fmt::format("{}: cannot be written: {}", path, output->geterror()));
    return bytes;
  }
};

}  // namespace
}  // namespace twinray

extern "C" const twinray::ImageCodec* twinray_image_codec() {
  static const twinray::OpenImageIOCodec codec;
  return &codec;
}
