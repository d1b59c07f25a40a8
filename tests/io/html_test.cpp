// SPDX-License-Identifier: Apache-2.0
// What all pages of the program are made of.
#include "tests/support/html.h"
#include "core/error.h"
#include "io/html/page.h"
#include "io/html/picture_address.h"
#include "io/html/plot.h"
#include "io/html/slider.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::html {

TEST_CASE("bytes in base 64 are those of RFC 4648") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string("\xff\x00\xfe", 3)) == "/wD+");
}

TEST_CASE("words cannot become elements of a page") {
  const std::string text =
      page("a < b & \"c\"", facts({{"<i>", "&"}}) + table({"x"}, row({escaped("<td>")})));
  CHECK(test::html_fault(text) == "");
  CHECK(test::html_load(text) == "");
  CHECK(text.find("<title>a &lt; b &amp; &quot;c&quot;</title>") != std::string::npos);
  CHECK(text.find("<td>&lt;i&gt;</td><td>&amp;</td>") != std::string::npos);
  CHECK(text.find("<td>&lt;td&gt;</td>") != std::string::npos);
}

TEST_CASE("a text is broken between its words, but not between an option and its values") {
  CHECK(whole_words("a < b") ==
        "<span class=\"words\"><span>a</span> <span>&lt;</span> <span>b</span></span>");
  CHECK(whole_words("render -r 96 72 -H --accel=bvh -s 1") ==
        "<span class=\"words\"><span>render</span> <span>-r 96 72</span> <span>-H</span> "
        "<span>--accel=bvh</span> <span>-s 1</span></span>");
}

TEST_CASE("a long word goes on in the next line behind its slashes and underscores") {
  CHECK(whole_words("sky/CB_a.dae") == "<span class=\"words\"><span>sky/<wbr>CB_<wbr>a.dae</span></span>");
}

TEST_CASE("a picture's address holds its bytes, by the kind that its name says") {
  const test::TemporaryFolder folder;
  test::write_text(folder.file("a.PNG"), "foo");
  test::write_text(folder.file("a.jpeg"), "foo");
  CHECK(picture_address(folder.file("a.PNG")) == "data:image/png;base64,Zm9v");
  CHECK(picture_address(folder.file("a.jpeg")) == "data:image/jpeg;base64,Zm9v");
  CHECK_THROWS_AS(picture_address(folder.file("a.exr")), Error);
  CHECK_THROWS_AS(picture_address(folder.file("b.png")), Error);
}

TEST_CASE("a picture's address may hold its pixels, as a PNG") {
  const test::TemporaryFolder folder;
  const ByteImage image{2, 1, {0, 0, 0, 255, 128, 1}};
  write_png(folder.file("a.png"), image);
  CHECK(picture_address(image) == picture_address(folder.file("a.png")));
}

TEST_CASE("a slider holds both pictures, the left one above") {
  const std::string text =
      slider({"a < b", "data:image/png;base64,AA==", 40}, {"right", "data:image/png;base64,BB==", 1000});
  CHECK(test::html_fault(text) == "");
  CHECK(test::html_load(text) == "");
  CHECK(text.find("<span>a &lt; b</span><span>right</span>") != text.npos);
  CHECK(text.find("<img class=\"\" alt=\"right\" src=\"data:image/png;base64,BB==\"><img class=\"fine left\" "
                  "alt=\"a &lt; b\" src=\"data:image/png;base64,AA==\">") != text.npos);
}

TEST_CASE("a plot's axes have ticks at powers of ten, and its marks lie in order along them") {
  const Curves curves{.x_label = "x",
                      .y_label = "y",
                      .series = {{"s", color_of(0), {{1, 0.001, 0, 0, "a"}, {1000, 0.01, 0, 0, "b"}}}}};
  const std::string svg = draw(curves);
  CHECK(test::html_fault(svg) == "");
  for (const char* tick : {">1<", ">10<", ">100<", ">1000<", ">0.001<", ">0.01<"})
    CHECK(test::count(svg, tick) == 1);
  const auto x_of = [&](const char* title) {
    const std::size_t begin = svg.rfind("cx=\"", svg.find(title));
    return std::stod(svg.substr(begin + 4));
  };
  CHECK(x_of("<title>a<") < x_of("<title>b<"));
}

TEST_CASE("a page whose elements are not closed, or that loads something, is found") {
  CHECK(test::html_fault("<p><b>x</p></b>") == "</p> closes what is not open");
  CHECK(test::html_fault("<p>") == "<p> is not closed");
  CHECK(test::html_load("<img src=\"a.png\">") == " src=\"a.png\">");
  CHECK(test::html_load("<a href=\"#part1\"></a><img src=\"data:image/png;base64,AA\">") == "");
}

}  // namespace twinray::html
