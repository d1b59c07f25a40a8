// SPDX-License-Identifier: Apache-2.0
#include "io/picture/exr_reader.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>
#include <ImfRgbaFile.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "io/picture/exr_attributes.h"
#include "io/picture/exr_failures.h"
#include "io/picture/exr_streams.h"

namespace twinray {
namespace {

/// A picture whose header is read.
class OpenExr {
 public:
  /// `check` sees the header.
  OpenExr(const PictureBytes& picture, const HeaderCheck& check)
      : picture_(picture), memory_(picture), file_(memory_, no_threads), channels_(channels_of(header())) {
    check({width(), height(), int(channels_.size())});
  }

  const Imf::Header& header() const { return file_.header(); }
  const std::vector<PictureChannel>& channels() const { return channels_; }
  int width() const { return header().dataWindow().max.x - header().dataWindow().min.x + 1; }
  int height() const { return header().dataWindow().max.y - header().dataWindow().min.y + 1; }

  bool has(const std::string& channel) const { return header().channels().findChannel(channel) != nullptr; }
  /// Luminance, and the chroma of fewer pixels.
  bool is_luminance_chroma() const { return has("Y") && has("RY") && has("BY"); }

  /// Reads these channels of all pixels, row by row, with so many numbers a pixel.
  void read(std::span<const PictureChannel> channels, float* numbers, std::size_t numbers_a_pixel) {
    const std::size_t pixel_bytes = numbers_a_pixel * sizeof(float);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const Imf::Channel& stored = header().channels()[channels[i].name];
      if (stored.xSampling != 1 || stored.ySampling != 1)
        fail_picture(picture_, "its channel " + channels[i].name + " does not have a number for each pixel");
      buffer.insert(channels[i].name, Imf::Slice::Make(Imf::FLOAT, numbers + i, header().dataWindow(),
                                                       pixel_bytes, pixel_bytes * std::size_t(width())));
    }
    file_.setFrameBuffer(buffer);
    file_.readPixels(header().dataWindow().min.y, header().dataWindow().max.y);
  }

 private:
  const PictureBytes& picture_;
  MemoryInput memory_;
  Imf::InputFile file_;
  std::vector<PictureChannel> channels_;
};

Image grey_image(OpenExr& file, std::span<const PictureChannel> channel) {
  Image image(file.width(), file.height());
  file.read(channel, &image.pixels[0].r, 3);
  for (Rgb& pixel : image.pixels) pixel = {pixel.r, pixel.r, pixel.r};
  return image;
}

Image image_of_luminance_chroma(const PictureBytes& picture, int width, int height) {
  MemoryInput memory(picture);
  Imf::RgbaInputFile file(memory, no_threads);
  const Imath::Box2i window = file.dataWindow();
  Image image(width, height);
  std::vector<Imf::Rgba> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    file.setFrameBuffer(row.data() - window.min.x, 1, 0);
    file.readPixels(window.min.y + y);
    for (int x = 0; x < width; ++x) {
      const Imf::Rgba& pixel = row[std::size_t(x)];
      image.at(x, y) = {pixel.r, pixel.g, pixel.b};
    }
  }
  return image;
}

std::string_view layer_of(const PictureChannel& channel) { return layer_and_name(channel.name).first; }

bool is_usual(const PictureChannel& channel, std::string_view usual) {
  return usual_channel(layer_and_name(channel.name).second) == usual;
}

/// Whether red, green and blue of one layer stand there.
bool is_color(std::span<const PictureChannel> channels, std::size_t i) {
  return is_usual(channels[i], "R") && is_usual(channels[i + 1], "G") && is_usual(channels[i + 2], "B") &&
         layer_of(channels[i]) == layer_of(channels[i + 2]);
}

/// Whether programs call so the layer that is the picture itself, among others.
bool is_picture_itself(std::string_view layer) {
  const std::string_view word = layer_and_name(layer).second;
  return word.empty() || word == "Combined" || word == "rgba" || word == "beauty";
}

/// Where red, green and blue stand: the file's own, else those of the layer that is the picture itself, else
/// those of the first layer that has them, else any three numbers. The size of the list: the file is grey, of
/// few channels or with a luminance.
std::size_t first_color(std::span<const PictureChannel> channels) {
  const std::size_t none = channels.size();
  if (none < 3 || channels[0].name == "Y") return none;
  std::size_t first = none;
  for (std::size_t i = 0; i + 2 < none; ++i) {
    if (!is_color(channels, i)) continue;
    if (is_picture_itself(layer_of(channels[i]))) return i;
    first = std::min(first, i);
  }
  if (first < none) return first;
  return channels[0].name == "A" ? none : 0;
}

/// Of a file without colours: the channel that is shown as grey, not its alpha if there is another one.
std::size_t first_number(std::span<const PictureChannel> channels) {
  return channels.size() > 1 && channels[0].name == "A" ? 1 : 0;
}

}  // namespace

Image decode_exr(const PictureBytes& picture, const HeaderCheck& check) {
  return read_or_fail(picture.path, [&] {
    OpenExr file(picture, check);
    if (file.is_luminance_chroma()) return image_of_luminance_chroma(picture, file.width(), file.height());
    const std::span channels(file.channels());
    const std::size_t first = first_color(channels);
    if (first == channels.size()) return grey_image(file, channels.subspan(first_number(channels), 1));
    Image image(file.width(), file.height());
    file.read(channels.subspan(first, 3), &image.pixels[0].r, 3);
    return image;
  });
}

std::optional<Primaries> decode_exr_primaries(const PictureBytes& picture, const HeaderCheck& check) {
  return read_or_fail(picture.path, [&] { return primaries_of(OpenExr(picture, check).header()); });
}

Image decode_exr_alpha(const PictureBytes& picture, const HeaderCheck& check) {
  return read_or_fail(picture.path, [&] {
    OpenExr file(picture, check);
    const std::span channels(file.channels());
    const std::size_t color = first_color(channels);
    const PictureChannel& shown = channels[color < channels.size() ? color : first_number(channels)];
    for (const PictureChannel& channel : channels)
      if (layer_of(channel) == layer_of(shown) && is_usual(channel, "A"))
        return grey_image(file, {&channel, 1});
    return Image(file.width(), file.height(), white);
  });
}

StoredLayers decode_exr_layers(const PictureBytes& picture, const HeaderCheck& check) {
  return read_or_fail(picture.path, [&] {
    OpenExr file(picture, check);
    const std::size_t count = file.channels().size();
    StoredLayers stored{file.width(), file.height(),           file.channels(),
                        {},           texts_of(file.header()), frame_of(file.header())};
    stored.values.resize(std::size_t(stored.width) * std::size_t(stored.height) * count);
    file.read(stored.channels, stored.values.data(), count);
    return stored;
  });
}

std::vector<float> decode_exr_channel(const PictureBytes& picture, const std::string& name,
                                      const HeaderCheck& check) {
  return read_or_fail(picture.path, [&] {
    OpenExr file(picture, check);
    const PictureChannel channel{name};
    if (!file.has(name)) return std::vector<float>();
    std::vector<float> values(std::size_t(file.width()) * std::size_t(file.height()));
    file.read({&channel, 1}, values.data(), 1);
    return values;
  });
}

ImageFrame decode_exr_frame(const PictureBytes& picture, const HeaderCheck& check) {
  return read_or_fail(picture.path, [&] { return frame_of(OpenExr(picture, check).header()); });
}

ImageMetadata decode_exr_metadata(const PictureBytes& picture, const HeaderCheck& check) {
  return read_or_fail(picture.path, [&] { return texts_of(OpenExr(picture, check).header()); });
}

}  // namespace twinray
