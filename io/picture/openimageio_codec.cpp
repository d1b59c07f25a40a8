// SPDX-License-Identifier: Apache-2.0
// The door to OpenImageIO: a shared library of its own, which image_codec.cpp loads.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "io/picture/image_codec.h"
#include "io/picture/openimageio_view.h"

namespace twinray {
namespace {

void add_metadata(OIIO::ImageSpec& spec, const ImageMetadata& metadata) {
  spec.attribute("DateTime", "");  // Without any, OpenImageIO would take the time of now.
  for (const auto& [name, value] : metadata) spec.attribute(name, value);
}

/// A picture whose header is read. `check` sees it.
class OpenPicture {
 public:
  OpenPicture(PictureFormat format, const PictureBytes& picture, const HeaderCheck& check)
      : picture_(picture),
        memory_(picture.bytes.data(), picture.bytes.size()),
        input_(OIIO::ImageInput::create(format == PictureFormat::hdr ? "hdr" : "jpeg")) {
    if (!input_ || !input_->set_ioproxy(&memory_) || !input_->open(picture.path, spec_)) fail();
    check({spec_.width, spec_.height, spec_.nchannels});
  }
  const OIIO::ImageSpec& spec() const { return spec_; }
  /// The colours. Row by row: OpenImageIO takes 64 MB for any rows that it reads at once, however short.
  Image read() {
    if (spec_.nchannels != 3) fail_picture(picture_, "it has not three channels");
    Image image(spec_.width, spec_.height);
    for (int y = 0; y < spec_.height; ++y)
      if (!input_->read_scanline(y, 0, OIIO::TypeDesc::FLOAT, &image.at(0, y))) fail();
    return image;
  }

 private:
  [[noreturn]] void fail() const { fail_picture(picture_, input_ ? input_->geterror() : OIIO::geterror()); }

  const PictureBytes& picture_;
  OIIO::Filesystem::IOMemReader memory_;
  std::unique_ptr<OIIO::ImageInput> input_;
  OIIO::ImageSpec spec_;
};

/// The attributes that are texts.
ImageMetadata texts_of(const OIIO::ImageSpec& spec) {
  ImageMetadata texts;
  for (const OIIO::ParamValue& value : spec.extra_attribs)
    if (value.type() == OIIO::TypeDesc::STRING) texts.emplace_back(value.name().string(), value.get_string());
  return texts;
}

/// A format without names for its metadata has it as lines of one text.
void add_description(OIIO::ImageSpec& spec, const ImageMetadata& metadata) {
  std::string text;
  for (const auto& [name, value] : metadata)
    if (name != "Software" && name != "DateTime") text += fmt::format("{}: {}\n", name, value);
  add_metadata(spec, metadata);
  if (!text.empty())
    spec.attribute("ImageDescription", text);  // OpenImageIO ends the program over an empty one.
}

/// Radiance's format has eight bits for each channel, one exponent for the three of them, and nothing below
/// 0. OpenImageIO cuts off what is beyond these bits: this is what the format has nearest to a color, a
/// quarter of its step above, which that cut takes away again.
Rgb nearest_rgbe(const Rgb& color) {
  int exponent;
  std::frexp(max_component(color), &exponent);
  float step = std::ldexp(1.0f, std::max(exponent, -100) - 8);  // Below is what it takes for 0.
  if (std::round(max_component(color) / step) == 256) step *= 2;
  const auto nearest = [step](float x) { return (std::round(std::max(x, 0.0f) / step) + 0.25f) * step; };
  return {nearest(color.r), nearest(color.g), nearest(color.b)};
}

/// A picture of three channels, put together in memory.
std::vector<unsigned char> encoded(const char* format, const std::string& path, const OIIO::ImageSpec& spec,
                                   const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (!output || !output->set_ioproxy(&memory) || !output->open(path, spec) ||
      !output->write_image(spec.format, pixels) || !output->close())
    throw Error(
        fmt::format("{}: cannot be written: {}", path, output ? output->geterror() : OIIO::geterror()));
  return bytes;
}

class OpenImageIOCodec final : public ImageCodec {
 public:
  Image read_hdr(const PictureBytes& picture, const HeaderCheck& check) const override {
    return OpenPicture(PictureFormat::hdr, picture, check).read();
  }

  ImageMetadata read_metadata(PictureFormat format, const PictureBytes& picture,
                              const HeaderCheck& check) const override {
    return texts_of(OpenPicture(format, picture, check).spec());
  }

  std::vector<unsigned char> encode_floats(OutputFormat format, const std::string& path, const Image& image,
                                           const ImageMetadata& metadata) const override {
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT);
    add_description(spec, metadata);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "none");
    if (format == OutputFormat::tiff) return encoded("tiff", path, spec, image.pixels.data());
    std::vector<Rgb> pixels;
    for (const Rgb& pixel : image.pixels) pixels.push_back(nearest_rgbe(pixel));
    return encoded("hdr", path, spec, pixels.data());
  }

  std::vector<unsigned char> encode_jpeg(const std::string& path, const ByteImage& image,
                                         const ImageMetadata& metadata) const override {
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    add_description(spec, metadata);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("Compression", "jpeg:95");
    spec.attribute("jpeg:subsampling", "4:4:4");
    return encoded("jpeg", path, spec, image.bytes.data());
  }

  Image viewed(const Image& image, const std::string& display, const std::string& view) const override {
    return opencolorio_view(image, display, view);
  }
};

}  // namespace
}  // namespace twinray

extern "C" const twinray::ImageCodec* TWINRAY_CODEC_FUNCTION() {
  static const twinray::OpenImageIOCodec codec;
  return &codec;
}
