// SPDX-License-Identifier: Apache-2.0
#include "io/film/film_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/film.h"
#include "tests/support/film_bytes.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr PixelRect window{-1, 0, 300, 200};

FilmContents with_layers() { return {{Layer::albedo, Layer::position, Layer::object_matte}, {0, 2}}; }

Film random_film(std::uint64_t seed, FilmContents contents = with_layers()) {
  Film film(299, 210, window, std::move(contents));
  Random random(seed);
  const auto color = [&]() -> Rgb { return {random.unit(), random.unit(), random.unit()}; };
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; x += 1 + int(random.below(3))) {
      FilmSample sample{color(), {}, {}, {color(), color()}};
      for (const Layer layer : film.layers())
        sample.layers.push_back(layer == Layer::object_matte ? record_id(1 + std::uint32_t(random.below(3)))
                                                             : color());
      add_sample(film, x, y, 0, sample);
    }
  return film;
}

std::string written(const TemporaryFolder& folder, const Film& film, int threads = 1) {
  const std::string path = folder.file("a.film");
  const Film* const films[] = {&film};
  write_film_file(path, films, R"({"seed": 3})", threads);
  return path;
}

std::string error_of(const std::string& path) {
  try {
    FilmFile(path).check();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("films come back from their file as they were, on any number of threads") {
  const TemporaryFolder folder;
  const Film first = random_film(1), second = random_film(2, {}), third = random_film(3, {});
  const Film* const films[] = {&first, &second, &third};
  std::string bytes;
  for (const int threads : {1, 3}) {
    const std::string path = folder.file("three.film");
    const std::uint64_t size = write_film_file(path, films, R"({"name": "a \u00e9"})", threads);
    CHECK(size == std::filesystem::file_size(path));
    if (bytes.empty()) bytes = read_text(path);
    CHECK(read_text(path) == bytes);
    FilmFile file(path);
    CHECK(file.header().frame_width == 299);
    CHECK(file.header().frame_height == 210);
    CHECK(file.header().window == window);
    CHECK(file.header().films == std::vector<FilmContents>{with_layers(), {}, {}});
    CHECK(file.header().notes == "{\"name\":\"a \xc3\xa9\"}");
    std::vector<Film> read = file.header().make_films();
    Film* const into[] = {&read[0], &read[1], &read[2]};
    file.merge_into(into, threads);
    CHECK(bytes_of(read[0]) == bytes_of(first));
    CHECK(bytes_of(read[1]) == bytes_of(second));
    CHECK(bytes_of(read[2]) == bytes_of(third));
  }
}

TEST_CASE("a film is added to what is there, and has a content of its own") {
  const TemporaryFolder folder;
  const Film first = random_film(1), second = random_film(2);
  Film sum = first;
  FilmFile file(written(folder, second));
  Film* const into[] = {&sum};
  file.merge_into(into);
  Film expected = first;
  expected.merge(second);
  CHECK(bytes_of(sum) == bytes_of(expected));
  const std::uint64_t content = file.content();
  CHECK(FilmFile(written(folder, second)).content() == content);
  CHECK(FilmFile(written(folder, first)).content() != content);
}

TEST_CASE("the film that is replaced stays under another name") {
  const TemporaryFolder folder;
  const Film first = random_film(1), second = random_film(2);
  const std::string path = written(folder, first), before = read_text(path);
  CHECK(folder.file_count() == 1);
  written(folder, second);
  CHECK(read_text(earlier_film_name(path)) == before);
  CHECK(read_text(path) != before);
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a film file that is cut off anywhere is known as such") {
  const TemporaryFolder folder;
  const std::string path = written(folder, random_film(1, {})), whole = read_text(path);
  CHECK(error_of(path) == "");
  std::vector<std::size_t> sizes;
  for (std::size_t size = 0; size < 600; size += 7) sizes.push_back(size);
  for (std::size_t size = 600; size < whole.size(); size += whole.size() / 50) sizes.push_back(size);
  for (std::size_t left = 1; left < 40; ++left) sizes.push_back(whole.size() - left);
  for (const std::size_t size : sizes) {
    CAPTURE(size);
    write_text(path, whole.substr(0, size));
    CHECK(error_of(path).starts_with(path + ": "));
  }
}

TEST_CASE("a film file of which any bit is changed is known as such") {
  const TemporaryFolder folder;
  const std::string path = written(folder, random_film(1, {})), whole = read_text(path);
  Random random(9);
  for (int i = 0; i < 400; ++i) {
    const std::size_t place = i < 100 ? std::size_t(i) * 4 : random.below(std::uint32_t(whole.size()));
    CAPTURE(place);
    std::string changed = whole;
    changed[place] = char(changed[place] ^ (1 << random.below(8)));
    write_text(path, changed);
    CHECK(error_of(path).starts_with(path + ": "));
  }
}

TEST_CASE("what is no film file is an error that says so") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.film");
  CHECK(error_of(path) == path + ": there is no such file");
  write_text(path, "P6 1 1 255 a picture of one pixel");
  CHECK(error_of(path) == path + ": this is no film file of this version of the program");
  const std::string directory = folder.path().string();
  CHECK(error_of(directory) == directory + ": this is a directory; a film is needed");
  CHECK(error_of(std::string("/dev/null")) == "/dev/null: this is no regular file; a film is needed");
}

TEST_CASE("a header that no film can have is an error before memory is taken") {
  for (const auto& [json, reason] : {
           std::pair{R"({"frame": [0, 4], "window": [0, 0, 4, 4], "films": [{"layers": [], "parts": [0, 0]}],
                        "notes": {}})",
                     "a frame of 0 x 4 pixels: each side must lie in 1 to 65536"},
           {R"({"frame": [4, 4], "window": [3, 0, 3, 4], "films": [], "notes": {}})", "its window is empty"},
           {R"({"frame": [4, 4], "window": [0, 0, 4, 4], "films": [], "notes": {}})",
            "0 films; valid are 1 to 3"},
           {R"({"frame": [4, 4], "window": [0, 0, 4, 4], "films": [{"layers": ["x"], "parts": [0, 0]}],
               "notes": {}})",
            "there is no layer \"x\""},
           {R"({"frame": [4, 4], "window": [0, 0, 4, 4], "films": [{"layers": [], "parts": [0, 9999999]}],
               "notes": {}})",
            "9999999 stands where a whole number from 0 to 1048576 should"},
       })
    CHECK_THROWS_WITH(parse_film_header(json), reason);
  for (const char* number :
       {"2.5", "1e300", "25555555555555555555", "-2e9", "-1073741825", "true", "\"4\"", "null"})
    CHECK_THROWS_WITH(
        parse_film_header(fmt::format(
            R"({{"frame": [4, 4], "window": [0, 0, 4, {}], "films": [], "notes": {{}}}})", number)),
        Catch::EndsWith("stands where a whole number from -1073741824 to 1073741824 should"));
  CHECK_THROWS_AS(parse_film_header("[1, 2"), Error);
  CHECK_THROWS_AS(parse_film_header(R"({"frame": [4, 4]})"), Error);
}

}  // namespace twinray::test
