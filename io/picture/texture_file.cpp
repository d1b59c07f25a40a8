// SPDX-License-Identifier: Apache-2.0
#include "io/picture/texture_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "io/picture/known_pictures.h"
#include "io/picture/texture_store.h"
#include "io/picture/tiled_texture.h"

namespace twinray {
namespace {

/// What is shown in place of a file that cannot be used, and how a warning names it.
struct StandIn {
  Rgb color;
  const char* words;
};
constexpr StandIn magenta{{1, 0, 1}, "it is shown magenta"};
constexpr StandIn flat{{0.5f, 0.5f, 1}, "the surface stays flat"};

Image picture_of(const StandIn& stand_in) {
  Image image(1, 1);
  image.pixels[0] = stand_in.color;
  return image;
}

/// How many pixels were not finite, and now are black.
std::size_t blacken(Image& image) {
  std::size_t count = 0;
  for (Rgb& pixel : image.pixels) {
    if (is_finite(pixel)) continue;
    pixel = {};
    ++count;
  }
  return count;
}

struct ReadPicture {
  Image image;
  std::string warning;
};

ReadOptions options_of(const PictureMeaning& meaning) {
  return {meaning.role, meaning.channels, most_texture_pixels};
}

ReadPicture read(const PictureUse& picture) {
  Image image = read_image(picture.path, options_of(picture.meaning));
  const std::size_t blackened = blacken(image);
  std::string warning = unread_parts(picture.path);
  if (blackened > 0)
    warning += fmt::format("{}{}: {} of {} x {} pixels are not finite; they are black",
                           warning.empty() ? "" : "; ", picture.path, blackened, image.width, image.height);
  return {std::move(image), std::move(warning)};
}

/// Whether a file is there, and not older than the picture that it was made of, where that is there.
bool is_fresh(const std::string& tiled, const std::string& picture) {
  namespace fs = std::filesystem;
  std::error_code error, no_picture;
  const auto made = fs::last_write_time(tiled, error);
  if (error) return false;
  const auto drawn = fs::last_write_time(picture, no_picture);
  return no_picture || made >= drawn;
}

/// The file that says what a picture shows: itself or, where it is not there, the tiles that were made of it.
std::string source_of(const PictureUse& picture) {
  std::error_code error;
  const bool is_there = picture.path.empty() || std::filesystem::exists(picture.path, error);
  return is_there ? picture.path : tiled_name(picture.path, picture.meaning);
}

/// Opens a file of tiles for a texture. Throws Error where it was made for another use of the picture.
TiledTexture open_for(const std::string& path, const PictureMeaning& meaning) {
  TiledTexture texture = open_tiled(path);
  const bool is_other = is_tiled_name(path) && texture.meaning.channels != meaning.channels;
  if (is_other && meaning.channels != PictureChannels::color)
    throw Error(
        fmt::format("{}: it holds {}, and a number is wanted; --convert-textures writes those", path,
                    texture.meaning.channels == PictureChannels::color ? "colours" : "another number"));
  return texture;
}

std::shared_ptr<const MipMap> kept(TiledTexture texture, TextureStore* store) {
  return store ? store->keep(std::move(texture)) : std::make_shared<const MipMap>(read_whole(texture));
}

std::shared_ptr<const MipMap> kept(Image image, TextureStore* store) {
  MipMap map(std::move(image));
  return store ? store->keep(std::move(map)) : std::make_shared<const MipMap>(std::move(map));
}

/// The tiles that were made of a picture; null where there are none. What is wrong with them goes into the
/// warning.
std::shared_ptr<const MipMap> load_converted(const PictureUse& picture, TextureStore* store,
                                             std::string& warning) {
  const std::string tiled = tiled_name(picture.path, picture.meaning);
  if (picture.path.empty() || !is_fresh(tiled, picture.path)) return nullptr;
  try {
    return kept(open_for(tiled, picture.meaning), store);
  } catch (const Error& error) {
    warning = fmt::format("{}; {} is read in its place", error.what(), picture.path);
    return nullptr;
  }
}

LoadedTexture stood_in(const StandIn& stand_in, const std::string& fault) {
  return {kept(picture_of(stand_in), nullptr), fmt::format("{}; {}", fault, stand_in.words), true};
}

LoadedTexture load_unknown(const PictureUse& picture, const StandIn& stand_in, TextureStore* store) {
  std::string warning;
  Image image;
  try {
    if (is_tiled_name(picture.path)) return {kept(open_for(picture.path, picture.meaning), store), ""};
    if (auto converted = load_converted(picture, store, warning)) return {std::move(converted), ""};
    ReadPicture source = read(picture);
    image = std::move(source.image);
    if (warning.empty()) warning = std::move(source.warning);
  } catch (const Error& error) {
    return stood_in(stand_in, error.what());
  }
  return {kept(std::move(image), store), std::move(warning)};
}

/// What `read()` gives, unless the picture is known.
template <typename Read>
LoadedTexture known_or(const LoadOptions& options, const PictureUse& picture, bool is_normal_map,
                       const Read& read) {
  return options.known ? options.known->of(picture, is_normal_map, read) : read();
}

LoadedTexture load(const PictureUse& picture, const StandIn& stand_in, const LoadOptions& options) {
  if (options.pictures) {
    options.pictures->push_back(picture);
    return {kept(picture_of(stand_in), nullptr), ""};
  }
  options.add_file(source_of(picture));
  return known_or(options, picture, &stand_in == &flat,
                  [&] { return load_unknown(picture, stand_in, options.textures.get()); });
}

/// Whether a file of tiles can be used as it is.
bool is_good(const std::string& tiled, const PictureMeaning& meaning) {
  try {
    return open_tiled(tiled).meaning == meaning;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

LoadedTexture load_texture(const std::string& path, const PictureMeaning& meaning,
                           const LoadOptions& options) {
  return load({path, meaning}, magenta, options);
}

LoadedTexture load_normal_map(const std::string& path, const LoadOptions& options) {
  return load({path, {PictureRole::data, PictureChannels::color}}, flat, options);
}

LoadedTexture decode_texture(std::string_view bytes, const std::string& name, const PictureMeaning& meaning,
                             const LoadOptions& options) {
  if (options.pictures) return {kept(picture_of(magenta), nullptr), ""};
  return known_or(options, {name, meaning}, false, [&]() -> LoadedTexture {
    try {
      return {kept(decode_image(bytes, name, options_of(meaning)), options.textures.get()),
              unread_parts(bytes, name)};
    } catch (const Error& error) {
      return missing_texture(error.what());
    }
  });
}

LoadedTexture missing_texture(const std::string& fault) { return stood_in(magenta, fault); }

ConvertedTexture convert_texture(const PictureUse& picture) {
  ConvertedTexture made{tiled_name(picture.path, picture.meaning)};
  if (is_tiled_name(picture.path)) made.path = picture.path;
  made.is_new = !is_fresh(made.path, picture.path) || !is_good(made.path, picture.meaning);
  if (!made.is_new || is_tiled_name(picture.path)) {
    const TileLayout layout = open_tiled(made.path).layout;
    return {made.path, false, layout.level(0).width, layout.level(0).height, layout.levels(), ""};
  }
  ReadPicture source = read(picture);
  const MipMap map(std::move(source.image));
  write_tiled(made.path, map, picture.meaning);
  return {made.path, true, map.level(0).width, map.level(0).height, map.levels(), std::move(source.warning)};
}

}  // namespace twinray
