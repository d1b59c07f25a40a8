// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "io/picture/environment_file.h"
#include "io/picture/exr_reader.h"
#include "io/picture/exr_tiled_file.h"
#include "io/picture/exr_writer.h"
#include "io/picture/image_file.h"
#include "io/picture/texture_file.h"
#include "tests/support/catch.h"
#include "tests/support/layered_exr.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

const std::string exr_name = "a.exr";

void accept(const PictureHeader&) {}

std::vector<std::string> names_of(const StoredLayers& layers) {
  std::vector<std::string> names;
  for (const PictureChannel& channel : layers.channels) names.push_back(channel.name);
  return names;
}

/// A file of 4 x 4 pixels whose colours are luminance and, at half the resolution, chroma (ImfRgbaYca.h says
/// how): of one hue, each row brighter than the one above.
std::string luminance_chroma_exr(const Rgb& first_row) {
  const float y = luminance(first_row);
  std::vector<float> luminances;
  for (int i = 0; i < 16; ++i) luminances.push_back(y * float(i / 4 + 1));
  return layered_exr(4, 4,
                     {{"BY", std::vector<float>(4, (first_row.b - y) / y)},
                      {"RY", std::vector<float>(4, (first_row.r - y) / y)},
                      {"Y", luminances}});
}

}  // namespace

TEST_CASE("channels of an EXR stand by their layers, colours before alpha and depth") {
  const std::vector<float> values{1};
  const std::string bytes = layered_exr(1, 1,
                                        {{"A", values},
                                         {"B", values},
                                         {"G", values},
                                         {"R", values},
                                         {"Z", values},
                                         {"albedo.B", values},
                                         {"albedo.G", values},
                                         {"albedo.R", values},
                                         {"id", values}});
  CHECK(names_of(decode_exr_layers({bytes, exr_name}, accept)) ==
        std::vector<std::string>{"R", "G", "B", "A", "Z", "id", "albedo.R", "albedo.G", "albedo.B"});
}

TEST_CASE("luminance with chroma of a lower resolution gives the colours that it stands for") {
  const Rgb color{0.5f, 0.25f, 0.75f};
  const std::string bytes = luminance_chroma_exr(color);
  const Image image = decode_exr({bytes, exr_name}, accept);
  REQUIRE((image.width == 4 && image.height == 4));
  for (int y = 0; y < 4; ++y) {  // The numbers on the way have 16 bits, of which 11 count.
    const Rgb expected = color * float(y + 1);
    CHECK(image.at(1, y).r == Approx(expected.r).epsilon(0.002));
    CHECK(image.at(1, y).g == Approx(expected.g).epsilon(0.002));
    CHECK(image.at(1, y).b == Approx(expected.b).epsilon(0.002));
  }
  CHECK_THROWS_WITH(decode_exr_layers({bytes, exr_name}, accept),
                    "a.exr: cannot be read: its channel BY does not have a number for each pixel");
}

TEST_CASE("an EXR of one channel is grey, and its alpha is 1 where it has none") {
  const std::string luminance = layered_exr(2, 1, {{"Y", {3, 4}}});
  CHECK(decode_exr({luminance, exr_name}, accept).pixels == std::vector<Rgb>{{3, 3, 3}, {4, 4, 4}});
  CHECK(decode_exr_alpha({luminance, exr_name}, accept).pixels == std::vector<Rgb>{white, white});
  const std::string with_alpha = layered_exr(2, 1, {{"A", {0.5f, 1}}, {"Y", {3, 4}}});
  CHECK(decode_exr({with_alpha, exr_name}, accept).pixels == std::vector<Rgb>{{3, 3, 3}, {4, 4, 4}});
  CHECK(decode_exr_alpha({with_alpha, exr_name}, accept).pixels[0] == Rgb{0.5f, 0.5f, 0.5f});
  const std::string with_depth = layered_exr(1, 1, {{"A", {1}}, {"Y", {3}}, {"Z", {9}}});
  CHECK(decode_exr({with_depth, exr_name}, accept).pixels == std::vector<Rgb>{{3, 3, 3}});
}

TEST_CASE("an EXR's colours are its own, else those of a layer, in large letters or small") {
  const auto first_of = [](const Channels& channels) {
    return decode_exr({layered_exr(1, 1, channels), exr_name}, accept).pixels[0];
  };
  const Channels layer{{"A", {9}}, {"diffuse.B", {3}}, {"diffuse.G", {2}}, {"diffuse.R", {1}}};
  CHECK(first_of(layer) == Rgb{1, 2, 3});
  Channels both = layer;
  both.insert({{"R", {4}}, {"G", {5}}, {"B", {6}}});
  CHECK(first_of(both) == Rgb{4, 5, 6});
  CHECK(first_of({{"a", {9}}, {"b", {3}}, {"g", {2}}, {"r", {1}}}) == Rgb{1, 2, 3});
  CHECK(first_of({{"Red", {1}}, {"Green", {2}}, {"Blue", {3}}, {"Alpha", {9}}}) == Rgb{1, 2, 3});
  CHECK(first_of({{"rgba.red", {1}}, {"rgba.green", {2}}, {"rgba.blue", {3}}, {"rgba.alpha", {9}}}) ==
        Rgb{1, 2, 3});
  for (const std::string itself : {"View.Combined", "rgba", "x.beauty"}) {
    Channels several{{"AO.R", {7}}, {"AO.G", {7}}, {"AO.B", {7}}};
    several.insert({{itself + ".R", {1}}, {itself + ".G", {2}}, {itself + ".B", {3}}});
    CHECK(first_of(several) == Rgb{1, 2, 3});
  }
  CHECK(first_of({{"N.X", {1}}, {"N.Y", {2}}, {"N.Z", {3}}}) == Rgb{1, 2, 3});  // Any three numbers.
  CHECK(first_of({{"A", {9}}, {"depth.Z", {3}}, {"id", {2}}}) == Rgb{2, 2, 2});
}

TEST_CASE("the alpha of an EXR is that of the layer whose colours it shows") {
  const auto alpha_of = [](const Channels& channels) {
    return decode_exr_alpha({layered_exr(1, 1, channels), exr_name}, accept).pixels[0].r;
  };
  const Channels layer{{"a.R", {1}}, {"a.G", {2}}, {"a.B", {3}}, {"a.A", {0.25f}}, {"b.A", {0.5f}}};
  CHECK(alpha_of(layer) == 0.25f);
  Channels both = layer;
  both.insert({{"R", {4}}, {"G", {5}}, {"B", {6}}});
  CHECK(alpha_of(both) == 1);
  both.insert({"A", {0.75f}});
  CHECK(alpha_of(both) == 0.75f);
}

TEST_CASE("texts of an EXR are read as they were written, and no others") {
  const ImageMetadata written{
      {"DateTime", "2023:11:14 22:13:20"}, {"Software", "ours"}, {"twinray:seed", "7"}};
  const LayeredImage image{2, 1, {{"R"}}, [](int, std::span<float> values) {
                             for (float& value : values) value = 1;
                           }};
  const std::vector<unsigned char> file = encode_exr(image, written, {});
  const std::string bytes(file.begin(), file.end());
  ImageMetadata read = decode_exr_metadata({bytes, exr_name}, accept);
  std::sort(read.begin(), read.end());
  CHECK(read == written);
}

TEST_CASE("an EXR whose frame begins anywhere is read with its place in it") {
  ExrHeader stated;
  stated.frame_x = -3, stated.frame_y = 7;
  stated.x = -1, stated.y = 12;
  const std::string bytes = layered_exr(2, 1, {{"Y", {3, 4}}}, stated);
  const StoredLayers layers = decode_exr_layers({bytes, exr_name}, accept);
  CHECK(layers.values == std::vector<float>{3, 4});
  CHECK((layers.frame.x == 2 && layers.frame.y == 5));
  CHECK((layers.frame.width == 2 && layers.frame.height == 1));
}

TEST_CASE("texts that would say how an EXR is stored are neither read nor written") {
  ExrHeader stated;
  stated.texts = {{"type", "scanlineimage"}, {"note", "seen"}};
  const std::string bytes = layered_exr(1, 1, {{"Y", {3}}}, stated);
  CHECK(decode_exr_metadata({bytes, exr_name}, accept) == ImageMetadata{{"note", "seen"}});
  const LayeredImage image{1, 1, {{"Y"}}, [](int, std::span<float> values) { values[0] = 3; }};
  const std::vector<unsigned char> file =
      encode_exr(image, {{"compression", "none"}, {"dataWindow", "all"}, {"note", "seen"}}, {});
  const std::string written(file.begin(), file.end());
  CHECK(decode_exr_metadata({written, exr_name}, accept) == ImageMetadata{{"note", "seen"}});
  CHECK(decode_exr({written, exr_name}, accept).pixels == std::vector<Rgb>{{3, 3, 3}});
}

TEST_CASE("tiles of other channels than three of 32-bit floats are refused") {
  const TemporaryFolder folder;
  const std::vector<unsigned char> file = encode_tiled_exr(MipMap(Image(4, 4, white)), 64, {});
  std::string bytes(file.begin(), file.end());
  write_text(folder.file("a.tx"), bytes);
  CHECK(TiledExr(folder.file("a.tx")).size().levels == 3);
  // A channel's name, and the number of its type: 2 for floats, 1 for halves.
  const std::size_t red = bytes.find(std::string("R\0\2\0\0\0", 6));
  REQUIRE(red != bytes.npos);
  bytes[red + 2] = 1;
  write_text(folder.file("a.tx"), bytes);
  CHECK_THROWS_WITH(TiledExr(folder.file("a.tx")),
                    folder.file("a.tx") + ": not a picture of three channels of 32-bit floats in tiles");
}

TEST_CASE("an EXR is refused before memory is taken for its pixels") {
  const std::string bytes = layered_exr(2, 1, {{"Y", {3, 4}}});
  const HeaderCheck refuse = [](const PictureHeader&) { throw Error("too large"); };
  CHECK_THROWS_WITH(decode_exr({bytes, exr_name}, refuse), "too large");
  CHECK_THROWS_WITH(decode_exr_channel({bytes, exr_name}, "Y", refuse), "too large");
}

TEST_CASE("of an OpenEXR picture of several parts the first one is read, and the others are told") {
  const TemporaryFolder folder;
  const std::string path = folder.file("parts.exr"),
                    told = path + ": it has 3 parts; the first one, \"left\", is read";
  write_text(path, exr_of_parts({{"left", 0.25f}, {"right", 4}, {"depth", 8}}));
  CHECK(read_image(path).pixels == std::vector<Rgb>{{0.25f, 0.25f, 0.25f}});
  CHECK(unread_parts(path) == told);
  CHECK(load_environment(path).warning == told);
  const LoadedTexture texture = load_texture(path, {PictureRole::data, PictureChannels::color}, {});
  CHECK(texture.warning == told);
  CHECK(!texture.is_stand_in);
  CHECK(texture.image->level(0).at(0, 0) == Rgb{0.25f, 0.25f, 0.25f});
  CHECK(decode_texture(read_text(path), "a", {PictureRole::data, PictureChannels::color}, {}).warning ==
        "a: it has 3 parts; the first one, \"left\", is read");
  write_text(path, exr_of_parts({{"only", 0.25f}}));
  CHECK(unread_parts(path).empty());
  write_exr(path, Image(1, 1));
  CHECK(unread_parts(path).empty());
}

}  // namespace twinray::test
