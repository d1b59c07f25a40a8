// SPDX-License-Identifier: Apache-2.0
#include "io/picture/image_file.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <map>
#include <string_view>

#include "core/error.h"
#include "io/picture/picture_header.h"
#include "io/picture/srgb.h"
#include "tests/support/catch.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/layered_exr.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

namespace fs = std::filesystem;

Image gradient() {
  Image image(5, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) image.at(x, y) = {0.1f * float(x), 3.7f * float(y), 1e-5f * float(x * y)};
  return image;
}

/// A window in an EXR's header: x and y of its first and of its last pixel.
std::array<int, 4> exr_window(const std::string& path, const std::string& name) {
  const std::string attribute = name + '\0' + "box2i" + '\0' + '\x10' + std::string(3, '\0');
  const std::string text = read_text(path);
  const std::size_t at = text.find(attribute);
  if (at == std::string::npos) return {};
  std::array<int, 4> window{};
  std::memcpy(window.data(), text.data() + at + attribute.size(), sizeof window);
  return window;
}

/// Whether a text holds a date and time such as "2023:11:14 22:13:20", of whatever digits.
bool has_time(const std::string& text) {
  constexpr std::string_view pattern = "0000:00:00 00:00:00";
  const auto fits = [](char found, char wanted) {
    return wanted == '0' ? found >= '0' && found <= '9' : found == wanted;
  };
  return std::search(text.begin(), text.end(), pattern.begin(), pattern.end(), fits) != text.end();
}

/// Memory of at most a page right behind a page that ends the process that reads it.
class BehindForbiddenPage {
 public:
  explicit BehindForbiddenPage(std::size_t size) {
    REQUIRE(size <= page);
    pages_ = static_cast<char*>(
        mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    REQUIRE(pages_ != MAP_FAILED);
    REQUIRE(mprotect(pages_, page, PROT_NONE) == 0);
  }
  ~BehindForbiddenPage() { munmap(pages_, 2 * page); }
  std::string_view copy_of(const std::string& text) const {
    std::memcpy(pages_ + page, text.data(), text.size());
    return {pages_ + page, text.size()};
  }

 private:
  static constexpr std::size_t page = 4096;
  char* pages_ = nullptr;
};

}  // namespace

TEST_CASE("an EXR keeps every bit") {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), gradient(), {{"twinray:seed", "7"}});
  CHECK(read_image(folder.file("a.exr")).pixels == gradient().pixels);
  CHECK(read_text(folder.file("a.exr")).find("twinray:seed") != std::string::npos);
}

TEST_CASE("a PNG keeps every byte, and carries the metadata") {
  const TemporaryFolder folder;
  ByteImage bytes{4, 1, {0, 1, 2, 127, 128, 129, 200, 201, 202, 253, 254, 255}};
  write_png(folder.file("a.png"), bytes, {{"twinray:scene", "the scene"}});
  CHECK(encode_srgb(read_image(folder.file("a.png"))).bytes == bytes.bytes);
  CHECK(read_text(folder.file("a.png")).find("the scene") != std::string::npos);
}

TEST_CASE("a PNG says that it is sRGB, and keeps text of any alphabet") {
  const TemporaryFolder folder;
  write_png(folder.file("a.png"), {1, 1, {1, 2, 3}}, {{"plain", "box"}, {"other", "Größe 箱"}});
  const std::string text = read_text(folder.file("a.png"));
  CHECK(text.find(std::string("sRGB") + '\0') != std::string::npos);
  CHECK(text.find(std::string("tEXtplain") + '\0' + "box") != std::string::npos);
  CHECK(text.find(std::string("iTXtother") + std::string(5, '\0') + "Größe 箱") != std::string::npos);
  CHECK_THROWS_WITH(write_png(folder.file("b.png"), {0, 0, {}}), "a PNG cannot be made: Invalid IHDR data");
}

TEST_CASE("the tone curve is sRGB's, clipped and rounded") {
  CHECK(encode_srgb(0.0f) == 0);
  CHECK(encode_srgb(-1.0f) == 0);
  CHECK(encode_srgb(NAN) == 0);
  CHECK(encode_srgb(0.0025f) == 8);  // 255 * 12.92 * 0.0025 = 8.24
  // 127.5 stands for ((0.5 + 0.055) / 1.055)^2.4 = 0.21404114, by IEC 61966-2-1.
  CHECK(encode_srgb(0.2140411f) == 127);
  CHECK(encode_srgb(0.2140412f) == 128);
  CHECK(encode_srgb(1.0f) == 255);
  CHECK(encode_srgb(50.0f) == 255);
}

TEST_CASE("a picture's name says its format, but for what is no regular file") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(
      check_image_name(folder.file("a.bmp")),
      fmt::format("{}: a picture's name must end in .png, .jpg, .jpeg, .exr, .tif, .tiff, .hdr or .pfm",
                  folder.file("a.bmp")));
  for (const std::string name : {"a.png", "a.EXR", "a.jpeg", "a.TIF", "a.hdr", "a.pfm", "-", "/dev/null"})
    CHECK_NOTHROW(check_image_name(name));
}

TEST_CASE("an old picture survives where the new one cannot be written to its end") {
  const TemporaryFolder folder;
  Image noise(64, 64);
  Random random(1);
  for (Rgb& pixel : noise.pixels) pixel = {random.unit(), 0, 1};
  for (const std::string name : {"a.png", "a.exr"}) {
    CAPTURE(name);
    write_text(folder.file(name), "the old picture");
    const FileSizeLimit limit(4096);
    CHECK_THROWS_WITH(write_image(folder.file(name), noise),
                      fmt::format("{}: cannot be written: File too large", folder.file(name)));
    CHECK(read_text(folder.file(name)) == "the old picture");
  }
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a part of a frame is an EXR's data window, and the frame its display window") {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), gradient(), {}, {.x = 7, .y = 9, .width = 100, .height = 50});
  CHECK(exr_window(folder.file("a.exr"), "dataWindow") == std::array{7, 9, 11, 11});
  CHECK(exr_window(folder.file("a.exr"), "displayWindow") == std::array{0, 0, 99, 49});
  CHECK(read_image(folder.file("a.exr")).pixels == gradient().pixels);
  write_exr(folder.file("b.exr"), gradient());
  CHECK(exr_window(folder.file("b.exr"), "dataWindow") == std::array{0, 0, 4, 2});
  CHECK(exr_window(folder.file("b.exr"), "displayWindow") == std::array{0, 0, 4, 2});
}

TEST_CASE("a PNG says of what frame it is a part, if its metadata do") {
  const TemporaryFolder folder;
  const ByteImage image = encode_srgb(gradient());
  write_png(folder.file("part.png"), image, {{frame_key, frame_value({-7, 9, 100, 50})}});
  const auto frame = read_frame(folder.file("part.png"));
  REQUIRE(frame);
  CHECK(std::array{frame->x, frame->y, frame->width, frame->height} == std::array{-7, 9, 100, 50});
  write_png(folder.file("whole.png"), image);
  CHECK(!read_frame(folder.file("whole.png")));
  for (const char* wrong : {"", "1 2 3", "1 2 3 4 5", "1 2 0 4", "1 2 3 four", "nan 2 3 4", "1e9 2 3 4"})
    CHECK(!frame_of_value(wrong));
}

TEST_CASE("an EXR holds channels of any names, in 16 bits and in 32") {
  const TemporaryFolder folder;
  const auto fill_row = [](int y, std::span<float> values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) + 100 * float(y);
  };
  const LayeredImage image{2, 3, {{"R"}, {"G"}, {"B"}, {"N.X", true}, {"Z"}}, fill_row};
  write_exr(folder.file("a.exr"), image);
  CHECK(read_image(folder.file("a.exr")).at(1, 2) == Rgb{205, 206, 207});
  const std::string text = read_text(folder.file("a.exr"));
  const auto holds = [&](const std::string& channel, char type) {
    return text.find(channel + std::string(1, '\0') + type + std::string(3, '\0')) != text.npos;
  };
  constexpr char half = 1, full = 2;
  CHECK(holds("N.X", half));
  for (const std::string name : {"R", "G", "B", "Z"}) CHECK(holds(name, full));
}

TEST_CASE("an EXR holds the matrices of its camera, a picture without one none") {
  const TemporaryFolder folder;
  ImageFrame frame{0, 0, 5, 3, CameraMatrices{}};
  frame.camera->world_to_camera[5] = 7;
  frame.camera->world_to_ndc.emplace()[0] = 3;
  write_exr(folder.file("a.exr"), gradient(), {}, frame);
  const std::string text = read_text(folder.file("a.exr"));
  const auto value = [&](const std::string& name, std::size_t number) {
    const std::string attribute = name + '\0' + "m44f" + '\0' + '\x40' + std::string(3, '\0');
    const std::size_t at = text.find(attribute);
    REQUIRE(at != text.npos);
    float found = 0;
    std::memcpy(&found, text.data() + at + attribute.size() + number * sizeof found, sizeof found);
    return found;
  };
  CHECK(value("worldToCamera", 5) == 7);
  CHECK(value("worldToNDC", 0) == 3);
  write_exr(folder.file("b.exr"), gradient());
  CHECK(read_text(folder.file("b.exr")).find("worldTo") == std::string::npos);
}

TEST_CASE("a picture holds no time but that of its metadata") {
  const TemporaryFolder folder;
  REQUIRE(has_time("at 2023:11:14 22:13:20."));
  for (const std::string name : {"a.png", "a.exr", "a.tif"}) {
    CAPTURE(name);
    const std::string path = folder.file(name);
    write_image(path, gradient(), {{"Software", "ours"}});
    CHECK_FALSE(has_time(read_text(path)));
    CHECK(read_text(path).find("tIME") == std::string::npos);
    write_image(path, gradient(), {{"DateTime", "2023:11:14 22:13:20"}});
    const std::string text = read_text(path);
    // A PNG's time is a chunk: the year in two bytes, then a byte each.
    const std::string chunk = "tIME\x07\xe7\x0b\x0e\x16\x0d\x14";
    CHECK(text.find(name == "a.png" ? chunk : "2023:11:14 22:13:20") != std::string::npos);
  }
}

TEST_CASE("a file that is no picture, or another kind of one, is refused") {
  const TemporaryFolder folder;
  write_text(folder.file("a.exr"), "this is not an EXR");
  CHECK_THROWS_AS(read_image(folder.file("a.exr")), Error);
  CHECK_THROWS_WITH(read_image(folder.file("none.exr")),
                    fmt::format("{}: there is no such file", folder.file("none.exr")));
  CHECK_THROWS_WITH(read_image(folder.file("a.bmp")),
                    fmt::format("{}: not a picture that can be read; valid endings are .exr, .hdr, .png, "
                                ".jpg, .jpeg, .pfm, .tga, .webp",
                                folder.file("a.bmp")));
}

TEST_CASE("a picture is read as what its first bytes say, whatever its name is") {
  const TemporaryFolder folder;
  write_png(folder.file("a.png"), {1, 1, {255, 0, 0}});
  write_exr(folder.file("b.exr"), Image(1, 1, Rgb{0, 5, 0}));
  for (const char* name : {"a.jpg", "a", "a.tga"}) {
    fs::copy_file(folder.file("a.png"), folder.file(name));
    CHECK(read_image(folder.file(name)).at(0, 0) == Rgb{1, 0, 0});
  }
  fs::copy_file(folder.file("b.exr"), folder.file("b.png"));
  CHECK(read_image(folder.file("b.png")).at(0, 0) == Rgb{0, 5, 0});
  CHECK(read_layers(folder.file("b.png")).channels.size() == 3);
  for (const char* bytes : {"", "RIFF", "GIF89a"})
    CHECK_THROWS_WITH(
        decode_image(bytes, "image 0"),
        "image 0: its first bytes are of no picture that is read; valid are PNG, JPEG, WebP, OpenEXR");
}

TEST_CASE("colours of 8 bits are decoded as each number alone") {
  for (const int side : {3, 300}) {
    const TemporaryFolder folder;
    ByteImage image{side, side, std::vector<std::uint8_t>(std::size_t(3 * side * side))};
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = std::uint8_t(i * 7 + i / 256);
    write_png(folder.file("a.png"), image);
    const Image read = read_image(folder.file("a.png"));
    for (std::size_t i = 0; i < read.pixels.size(); ++i)
      REQUIRE(read.pixels[i].g == decode_srgb(float(image.bytes[3 * i + 1]) * (1.0f / 255)));
  }
}

TEST_CASE("an EXR cut short is refused") {
  const TemporaryFolder folder;
  Image image(64, 64);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = {float(i), float(i * i % 17), 0.5f};
  write_exr(folder.file("a.exr"), image);
  const std::string whole = read_text(folder.file("a.exr"));
  for (const double part : {0.1, 0.5, 0.9}) {
    write_text(folder.file("b.exr"), whole.substr(0, std::size_t(part * double(whole.size()))));
    CHECK_THROWS_AS(read_image(folder.file("b.exr")), Error);
  }
}

TEST_CASE("what an EXR's header promises is checked before the file is opened") {
  const TemporaryFolder folder;
  write_image(folder.file("a.exr"), Image(1, 1));
  const std::string whole = read_text(folder.file("a.exr")), changed = folder.file("b.exr");
  const std::size_t window =
      whole.find(std::string("dataWindow\0box2i\0\x10\0\0\0", 21)) + 21;  // four numbers
  const auto message = [&](const std::string& text) -> std::string {
    write_text(changed, text);
    try {
      read_image(changed);
    } catch (const Error& error) {
      return error.what();
    }
    return "read";
  };
  const auto with_last_pixel = [&](std::int32_t x, std::int32_t y) {
    std::string text = whole;
    std::memcpy(text.data() + window + 8, &x, sizeof x);
    std::memcpy(text.data() + window + 12, &y, sizeof y);
    return text;
  };
  CHECK(message(with_last_pixel(0, 0)) == "read");
  CHECK(message(with_last_pixel(16383, 16383)) ==
        fmt::format(
            "{}: says that it has 16384 x 16384 pixels, and is a file of {} bytes: it is cut off, or no "
            "picture",
            changed, whole.size()));
  CHECK(message(with_last_pixel(0, 0x7ffffffe)) ==
        fmt::format("{}: 1 x 2147483647 pixels; valid are up to 2^28", changed));
  CHECK(message(with_last_pixel(-1, 0)) == fmt::format("{}: 0 x 1 pixels; valid are up to 2^28", changed));
  std::string text = whole;
  text[window - 1] = '\x7f';  // the most significant byte of the attribute's size
  CHECK(message(text) == changed + ": cannot be read: its dataWindow is longer than the file");
  CHECK(message(whole.substr(0, 10)) == changed + ": cannot be read: its header is cut off");
  CHECK(message("") == changed + ": cannot be read: its header is cut off");
  CHECK(message("a picture") == changed + ": cannot be read: it does not begin as an OpenEXR picture does");
}

TEST_CASE("a value in an EXR's header has the size of its type, and what stands in it does not exceed it") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.exr");
  write_image(path, Image(1, 1));
  const std::string whole = read_text(path);
  const auto with = [&](const std::string& type, const std::string& value) {
    std::string attribute = "more" + std::string(1, '\0') + type + '\0';
    for (int byte = 0; byte < 4; ++byte) attribute += char(value.size() >> 8 * byte);
    return whole.substr(0, 8) + attribute + value + whole.substr(8);
  };
  const auto refused = [](const std::string& type, std::size_t size) {
    return fmt::format("a.exr: cannot be read: its more of the type {} cannot have {} bytes", type, size);
  };
  // The library would read 8 bytes, and take those behind them for the next attribute.
  CHECK_THROWS_WITH(decode_image(with("v2f", std::string(80, 'x')), "a.exr"), refused("v2f", 80));
  CHECK_THROWS_WITH(decode_image(with("tiledesc", "12345678"), "a.exr"), refused("tiledesc", 8));
  CHECK_THROWS_WITH(decode_image(with("floatvector", "12345"), "a.exr"), refused("floatvector", 5));
  // It would take 2 GB for a string of that length.
  CHECK_THROWS_WITH(decode_image(with("stringvector", "\xff\xff\xff\x7f"), "a.exr"),
                    refused("stringvector", 4));
  CHECK_THROWS_WITH(decode_image(with("preview", std::string(8, '\x7f')), "a.exr"), refused("preview", 8));
  CHECK_THROWS_WITH(decode_image(with("chlist", "R" + std::string(20, '\0')), "a.exr"),
                    refused("chlist", 21));
  for (const auto& [type, value] :
       std::map<std::string, std::string>{{"v2f", "12345678"},
                                          {"string", "any"},
                                          {"stringvector", std::string("\1\0\0\0a", 5)},
                                          {"new", "?"}})
    CHECK(check_picture_header(PictureFormat::exr, {with(type, value), path}).width == 1);
}

TEST_CASE("an EXR whose pixels would lie outside of its file is refused") {
  const TemporaryFolder folder;
  write_image(folder.file("a.exr"), Image(1, 1));
  std::string text = read_text(folder.file("a.exr"));
  const auto number_at = [&](std::size_t at) {
    std::uint64_t number = 0;
    std::memcpy(&number, text.data() + at, sizeof number);
    return number;
  };
  std::size_t table = 0;  // It holds the place of the first row, which follows.
  while (number_at(table) != table + 8) ++table;
  const BehindForbiddenPage forbidden(text.size());
  for (const std::uint64_t place : {std::uint64_t(1) << 62, ~std::uint64_t(3), std::uint64_t(text.size())}) {
    CAPTURE(place);
    std::memcpy(text.data() + table, &place, sizeof place);
    CHECK_THROWS_AS(decode_image(forbidden.copy_of(text), "a.exr"), Error);
  }
}

TEST_CASE("what any picture's header promises is checked before a library opens it") {
  // Nothing but headers: whatever opens such a file fails with words of its own, after it took gigabytes for
  // a JPEG that becomes finer by and by (0xc2).
  const std::string png("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\xff\0\0\0\x80\0", 24);
  const std::string jpeg("\xff\xd8\xff\xe0\0\3.\xff\xc2\0\x11\x08\x80\0\xff\0", 16);
  const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32768 +X 65280\n";
  const auto message = [](const std::string& bytes, const std::string& name) -> std::string {
    try {
      decode_image(bytes, name);
    } catch (const Error& error) {
      return error.what();
    }
    return "read";
  };
  for (const auto& [name, bytes] : std::map<std::string, std::string>{
           {"a.png", png}, {"a.jpg", jpeg}, {"a.JPEG", jpeg}, {"a.hdr", hdr}}) {
    CAPTURE(name);
    CHECK(message(bytes, name) == name + ": 65280 x 32768 pixels; valid are up to 2^28");
    CHECK(message(bytes.substr(0, bytes.size() - 1), name) ==
          name + ": cannot be read: its header is cut off");
    CHECK(message("", name).starts_with(name + ": cannot be read: it does not begin as a "));
  }
  std::string narrow = jpeg;
  narrow[14] = '\1';
  CHECK(
      message(narrow, "a.jpg") ==
      "a.jpg: says that it has 256 x 32768 pixels, and is a file of 16 bytes: it is cut off, or no picture");
  CHECK(message("#?RGBE\n\n-Y 1,5 +X 3\n", "a.hdr") ==
        "a.hdr: cannot be read: its header states no size such as -Y 480 +X 640");
}

TEST_CASE("a number of a picture is its brightness whatever its alpha is") {
  const TemporaryFolder folder;
  write_text(folder.file("a.exr"),
             layered_exr(1, 1, {{"A", {0.75f}}, {"B", {0.5f}}, {"G", {0.25f}}, {"R", {0}}}));
  const auto number = [&](PictureChannels channels) {
    return read_image(folder.file("a.exr"), {.role = PictureRole::data, .channels = channels}).pixels[0].r;
  };
  CHECK(number(PictureChannels::brightness) == 0.25f);
  CHECK(number(PictureChannels::number) == 0.75f);
}

TEST_CASE("the readers find the sizes that are found before") {
  for (const std::string name :
       {"flat.hdr", "runs.hdr", "grey.jpg", "rgb.jpg", "palette.png", "grey16.png", "zip.exr", "tiled.exr"}) {
    CAPTURE(name);
    // A seed of the fuzzer: the first byte is not of the picture.
    const std::string bytes = read_text(TWINRAY_SOURCE_DIR "/tests/fuzz/seeds/image/" + name).substr(1);
    const PictureSize size = check_picture_header(picture_format(name), {bytes, name});
    const Image image = decode_image(bytes, name);
    CHECK(size.width == image.width);
    CHECK(size.height == image.height);
  }
}

TEST_CASE("a large picture of one color is read, small as its file is") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.exr", "a.png"}) {
    write_image(folder.file(name), Image(3000, 3000));
    CHECK(read_image(folder.file(name)).width == 3000);
  }
}

TEST_CASE("a channel of an EXR is read by its name, and colours are R, G and B wherever they stand") {
  const test::TemporaryFolder folder;
  const test::Channels channels{
      {"B", {3, 3}}, {"G", {2, 2}}, {"R", {1, 1}}, {"samples", {4, 5}}, {"variance.Y", {0.5f, 7}}};
  test::write_text(folder.file("a.exr"), test::layered_exr(2, 1, channels));
  CHECK(read_image(folder.file("a.exr")).pixels == std::vector<Rgb>{{1, 2, 3}, {1, 2, 3}});
  CHECK(read_channel(folder.file("a.exr"), "variance.Y") == std::vector<float>{0.5f, 7});
  CHECK(read_channel(folder.file("a.exr"), "samples") == std::vector<float>{4, 5});
  CHECK(read_channel(folder.file("a.exr"), "Z").empty());
  write_png(folder.file("a.png"), {1, 1, {0, 0, 0}});
  CHECK(read_channel(folder.file("a.png"), "R").empty());
  CHECK_THROWS_AS(read_channel(folder.file("none.exr"), "R"), Error);
}

}  // namespace twinray::test
