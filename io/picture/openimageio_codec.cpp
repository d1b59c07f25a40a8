// SPDX-License-Identifier: Apache-2.0
// The door to OpenImageIO: a shared library of its own, which image_codec.cpp loads.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <string_view>

#include "core/error.h"
#include "io/picture/image_codec.h"
#include "io/picture/openimageio_view.h"

namespace twinray {
namespace {

/// OpenEXR would make as many threads as the machine has for every file, and fail where it gets none.
void use_no_threads() { OIIO::attribute("exr_threads", -1); }

void add_metadata(OIIO::ImageSpec& spec, const ImageMetadata& metadata) {
  spec.attribute("DateTime", "");  // Without any, OpenImageIO would take the time of now.
  for (const auto& [name, value] : metadata) spec.attribute(name, value);
}

void set_channels(OIIO::ImageSpec& spec, const std::vector<PictureChannel>& channels) {
  spec.channelnames.clear();
  for (const PictureChannel& channel : channels) {
    const int index = int(spec.channelnames.size());
    if (channel.name == "A") spec.alpha_channel = index;
    if (channel.name == "Z") spec.z_channel = index;
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(channel.is_half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  }
}

/// Of sRGB and Rec. 709: red, green, blue, and the white D65.
constexpr float srgb_chromaticities[] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};

OIIO::ImageSpec exr_spec(const LayeredImage& image, const ImageMetadata& metadata, const ImageFrame& frame) {
  OIIO::ImageSpec spec(image.width, image.height, int(image.channels.size()), OIIO::TypeDesc::FLOAT);
  set_channels(spec, image.channels);
  spec.x = frame.x;
  spec.y = frame.y;
  spec.full_width = frame.width > 0 ? frame.width : image.width;
  spec.full_height = frame.height > 0 ? frame.height : image.height;
  add_metadata(spec, metadata);
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), srgb_chromaticities);
  spec.attribute("compression", image.compression == ExrCompression::dwab ? "dwab" : "zip");
  if (frame.camera) {
    const OIIO::TypeDesc matrix(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::MATRIX44);
    spec.attribute("worldToCamera", matrix, frame.camera->world_to_camera.data());
    if (frame.camera->world_to_ndc) spec.attribute("worldToNDC", matrix, frame.camera->world_to_ndc->data());
  }
  return spec;
}

/// Row by row; false where the output fails.
bool write_rows(OIIO::ImageOutput& output, const LayeredImage& image) {
  std::vector<float> row(std::size_t(image.width) * image.channels.size());
  for (int y = 0; y < image.height; ++y) {
    image.fill_row(y, row);
    if (!output.write_scanline(output.spec().y + y, 0, OIIO::TypeDesc::FLOAT, row.data())) return false;
  }
  return true;
}

/// OpenImageIO's name of the reader.
const char* reader_for(PictureFormat format) {
  switch (format) {
    case PictureFormat::exr:
      return "openexr";
    case PictureFormat::hdr:
      return "hdr";
    case PictureFormat::png:
      return "png";
    default:
      return "jpeg";
  }
}

/// Reads so many channels from one on of all pixels, row by row: OpenImageIO takes 64 MB for any rows that it
/// reads at once, however short. Rows of tiles it reads one after the other by itself.
bool read_channels(OIIO::ImageInput& input, int first, int channels, Image& image) {
  const OIIO::ImageSpec& spec = input.spec();
  const auto pixel_bytes = OIIO::stride_t(sizeof(Rgb));
  if (spec.tile_width > 0)
    return input.read_image(0, 0, first, first + channels, OIIO::TypeDesc::FLOAT, image.pixels.data(),
                            pixel_bytes);
  std::vector<float> row(std::size_t(spec.width) * std::size_t(spec.nchannels));
  for (int y = 0; y < spec.height; ++y) {
    if (!input.read_scanline(spec.y + y, 0, OIIO::TypeDesc::FLOAT, row.data())) return false;
    for (int x = 0; x < spec.width; ++x)
      std::copy_n(&row[std::size_t(x) * std::size_t(spec.nchannels) + std::size_t(first)], channels,
                  &image.at(x, y).r);
  }
  return true;
}

Image all_opaque(const ImageCodec::Header& header) {
  Image image(header.width, header.height);
  std::fill(image.pixels.begin(), image.pixels.end(), Rgb{1, 1, 1});
  return image;
}

/// The first three channels of all pixels, or one as grey.
Image read_pixels(OIIO::ImageInput& input, const ImageCodec::Header& header, PictureLayer layer,
                  const std::string& path) {
  const int alpha = input.spec().alpha_channel;
  if (layer == PictureLayer::alpha && alpha < 0) return all_opaque(header);
  Image image(header.width, header.height);
  const int first = layer == PictureLayer::alpha ? alpha : 0;
  const int channels = layer == PictureLayer::color && header.channels >= 3 ? 3 : 1;
  if (!read_channels(input, first, channels, image))
    throw Error(fmt::format("{}: cannot be read: {}", path, input.geterror()));
  if (channels == 1)
    for (Rgb& pixel : image.pixels) pixel = {pixel.r, pixel.r, pixel.r};
  return image;
}

/// A file in memory. OpenImageIO 2.4's own reads beside the bytes where a place in the file is none.
class MemoryFile final : public OIIO::Filesystem::IOMemReader {
 public:
  explicit MemoryFile(std::string_view bytes) : IOMemReader(bytes.data(), bytes.size()), bytes_(bytes) {}

  std::size_t read(void* buffer, std::size_t size) override {
    const std::size_t count = pread(buffer, size, m_pos);
    m_pos += std::int64_t(count);
    return count;
  }
  std::size_t pread(void* buffer, std::size_t size, std::int64_t offset) override {
    if (offset < 0 || std::size_t(offset) >= bytes_.size()) return 0;
    return bytes_.copy(static_cast<char*>(buffer), size, std::size_t(offset));
  }

 private:
  std::string_view bytes_;
};

/// A picture whose header is read.
class OpenPicture {
 public:
  OpenPicture(PictureFormat format, const PictureBytes& picture)
      : memory_(picture.bytes), input_(OIIO::ImageInput::create(reader_for(format))) {
    use_no_threads();
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);  // Else colours come multiplied by their alpha.
    if (!input_ || !input_->set_ioproxy(&memory_) || !input_->open(picture.path, spec_, as_stored))
      throw Error(fmt::format("{}: cannot be read: {}", picture.path,
                              input_ ? input_->geterror() : OIIO::geterror()));
  }
  OIIO::ImageInput& input() { return *input_; }
  ImageCodec::Header header() const {
    return {spec_.width, spec_.height, spec_.nchannels, spec_.depth > 1 || spec_.deep};
  }

 private:
  MemoryFile memory_;
  std::unique_ptr<OIIO::ImageInput> input_;
  OIIO::ImageSpec spec_;
};

/// A file on disk, of which only what is asked for is read.
class DiskFile final : public OIIO::Filesystem::IOProxy {
 public:
  explicit DiskFile(const std::string& path)
      : IOProxy(path, Read), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};
    if (descriptor_ < 0 || fstat(descriptor_, &status) != 0)
      throw Error(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    size_ = std::size_t(status.st_size);
  }
  ~DiskFile() override { ::close(descriptor_); }
  const char* proxytype() const override { return "file"; }
  std::size_t size() const override { return size_; }
  std::size_t read(void* buffer, std::size_t size) override {
    const std::size_t count = pread(buffer, size, m_pos);
    m_pos += std::int64_t(count);
    return count;
  }
  std::size_t pread(void* buffer, std::size_t size, std::int64_t offset) override {
    std::size_t done = 0;
    while (offset >= 0 && done < size) {
      const ssize_t count =
          ::pread(descriptor_, static_cast<char*>(buffer) + done, size - done, offset + std::int64_t(done));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      done += std::size_t(count);
    }
    return done;
  }

 private:
  int descriptor_;
  std::size_t size_ = 0;
};

/// The attributes that are texts.
ImageMetadata texts_of(const OIIO::ImageSpec& spec) {
  ImageMetadata texts;
  for (const OIIO::ParamValue& value : spec.extra_attribs)
    if (value.type() == OIIO::TypeDesc::STRING) texts.emplace_back(value.name().string(), value.get_string());
  return texts;
}

std::vector<PictureChannel> channels_of(const OIIO::ImageSpec& spec) {
  std::vector<PictureChannel> channels;
  for (int i = 0; i < spec.nchannels; ++i)
    channels.push_back({spec.channelnames[std::size_t(i)], spec.channelformat(i) == OIIO::TypeDesc::HALF});
  return channels;
}

ImageFrame frame_of(const OIIO::ImageSpec& spec) {
  ImageFrame frame{spec.x - spec.full_x, spec.y - spec.full_y, spec.full_width, spec.full_height};
  CameraMatrices camera;
  const OIIO::TypeDesc matrix(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::MATRIX44);
  if (!spec.getattribute("worldToCamera", matrix, camera.world_to_camera.data())) return frame;
  std::array<float, 16> to_ndc;
  if (spec.getattribute("worldToNDC", matrix, to_ndc.data())) camera.world_to_ndc = to_ndc;
  frame.camera = camera;
  return frame;
}

class TiledExr final : public TiledPictureFile {
 public:
  explicit TiledExr(const std::string& path)
      : path_(path), file_(path), input_(OIIO::ImageInput::create("openexr")) {
    OIIO::ImageSpec spec;
    if (!input_ || !input_->set_ioproxy(&file_) || !input_->open(path, spec))
      throw Error(
          fmt::format("{}: cannot be read: {}", path, input_ ? input_->geterror() : OIIO::geterror()));
    if (spec.tile_width < 1 || spec.nchannels != 3 || spec.format != OIIO::TypeDesc::FLOAT || spec.deep)
      throw Error(path + ": not a picture of three channels of 32-bit floats in tiles");
    size_ = {spec.width, spec.height, 0, spec.tile_width, spec.tile_height};
    while (input_->seek_subimage(0, size_.levels)) ++size_.levels;
    metadata_ = texts_of(spec);
  }

  const Size& size() const override { return size_; }
  const ImageMetadata& metadata() const override { return metadata_; }
  void read(const Tile& tile, std::span<Rgb> texels) const override {
    const std::lock_guard lock(mutex_);
    if (!input_->seek_subimage(0, tile.level))
      throw Error(fmt::format("{}: it has no level {}", path_, tile.level));
    const OIIO::ImageSpec spec = input_->spec_dimensions(0, tile.level);
    if (!input_->read_tile(spec.x + tile.column * size_.tile_width, spec.y + tile.row * size_.tile_height, 0,
                           &texels[0].r))
      throw Error(fmt::format("{}: cannot be read: {}", path_, input_->geterror()));
  }

 private:
  std::string path_;
  mutable DiskFile file_;
  std::unique_ptr<OIIO::ImageInput> input_;  ///< Before its file it ends.
  mutable std::mutex mutex_;                 ///< Of it: a level is chosen, then read.
  Size size_;
  ImageMetadata metadata_;
};

OIIO::ImageSpec tiled_spec(const MipMap& map, int level, int tile_side, const ImageMetadata& metadata) {
  const MipLevel size = map.level(level);
  static_assert(sizeof(Rgb) == 3 * sizeof(float));
  OIIO::ImageSpec spec(size.width, size.height, 3, OIIO::TypeDesc::FLOAT);
  add_metadata(spec, metadata);
  spec.tile_width = spec.tile_height = tile_side;
  spec.tile_depth = 1;
  spec.attribute("compression", "zip");
  spec.attribute("textureformat", "Plain Texture");  // Else there would be one level.
  spec.attribute("openexr:roundingmode", 0);         // ROUND_DOWN
  return spec;
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
  Image read(PictureFormat format, const PictureBytes& picture, PictureLayer layer,
             const std::function<void(const Header&)>& check) const override {
    OpenPicture open(format, picture);
    check(open.header());
    return read_pixels(open.input(), open.header(), layer, picture.path);
  }

  std::vector<float> read_channel(const PictureBytes& picture, const std::string& name,
                                  const std::function<void(const Header&)>& check) const override {
    OpenPicture open(PictureFormat::exr, picture);
    check(open.header());
    const std::vector<std::string>& names = open.input().spec().channelnames;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    Image image(open.header().width, open.header().height);
    if (!read_channels(open.input(), int(found - names.begin()), 1, image))
      throw Error(fmt::format("{}: cannot be read: {}", picture.path, open.input().geterror()));
    std::vector<float> values;
    for (const Rgb& pixel : image.pixels) values.push_back(pixel.r);
    return values;
  }

  StoredLayers read_layers(const PictureBytes& picture,
                           const std::function<void(const Header&)>& check) const override {
    OpenPicture open(PictureFormat::exr, picture);
    check(open.header());
    const OIIO::ImageSpec& spec = open.input().spec();
    StoredLayers stored{spec.width, spec.height, channels_of(spec), {}, texts_of(spec), frame_of(spec)};
    stored.values.resize(spec.image_pixels() * std::size_t(spec.nchannels));
    if (!open.input().read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, stored.values.data()))
      throw Error(fmt::format("{}: cannot be read: {}", picture.path, open.input().geterror()));
    return stored;
  }

  ImageMetadata read_metadata(PictureFormat format, const PictureBytes& picture,
                              const std::function<void(const Header&)>& check) const override {
    OpenPicture open(format, picture);
    check(open.header());
    return texts_of(open.input().spec());
  }

  /// Put together in memory: a pipe cannot be written in any other order.
  std::vector<unsigned char> encode_exr(const std::string& path, const LayeredImage& image,
                                        const ImageMetadata& metadata,
                                        const ImageFrame& frame) const override {
    use_no_threads();
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
    if (!output || !output->set_ioproxy(&memory))
      throw Error(fmt::format("{}: OpenImageIO cannot write OpenEXR: {}", path, OIIO::geterror()));
    const OIIO::ImageSpec spec = exr_spec(image, metadata, frame);
    if (!output->open(path, spec) || !write_rows(*output, image) || !output->close())
      throw Error(fmt::format("{}: cannot be written: {}", path, output->geterror()));
    return bytes;
  }

  std::vector<unsigned char> encode_floats(OutputFormat format, const std::string& path, const Image& image,
                                           const ImageMetadata& metadata) const override {
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT);
    add_description(spec, metadata);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "none");
    return encoded(format == OutputFormat::tiff ? "tiff" : "hdr", path, spec, image.pixels.data());
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

  std::unique_ptr<const TiledPictureFile> open_tiled(const std::string& path) const override {
    use_no_threads();
    return std::make_unique<const TiledExr>(path);
  }

  std::vector<unsigned char> encode_tiled(const std::string& path, const MipMap& map, int tile_side,
                                          const ImageMetadata& metadata) const override {
    use_no_threads();
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
    const auto check = [&](bool is_done) {
      if (!is_done)
        throw Error(
            fmt::format("{}: cannot be written: {}", path, output ? output->geterror() : OIIO::geterror()));
    };
    check(output && output->set_ioproxy(&memory));
    for (int level = 0; level < map.levels(); ++level) {
      const OIIO::ImageSpec spec = tiled_spec(map, level, tile_side, metadata);
      check(output->open(path, spec,
                         level == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel));
      check(output->write_image(OIIO::TypeDesc::FLOAT, map.image(level).pixels.data()));
    }
    check(output->close());
    return bytes;
  }
};

}  // namespace
}  // namespace twinray

extern "C" const twinray::ImageCodec* twinray_image_codec() {
  static const twinray::OpenImageIOCodec codec;
  return &codec;
}
