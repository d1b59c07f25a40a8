// SPDX-License-Identifier: Apache-2.0
#include "io/xml/reader.h"

#include <filesystem>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray {
namespace {

std::unique_ptr<XmlDocument> parse(const std::string& text) { return XmlDocument::parse(text, "a.xml"); }

std::string parse_error(const std::string& text) {
  try {
    parse(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

template <typename Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("elements and attributes know their line and column") {
  const auto xml = parse(
      "<?xml version=\"1.0\"?>\n<!-- <a> -->\n<root><a x='>' y=\"2\"/>\n  <a  y = "
      "'3'/><![CDATA[<a>]]></root>");
  const auto as = xml->root().children("a");
  REQUIRE(as.size() == 2);
  CHECK(as[0].place().line == 3);
  CHECK(as[0].place().column == 7);
  CHECK(as[0].attribute_place("y").column == 16);
  CHECK(as[1].place().line == 4);
  CHECK(as[1].place().column == 3);
  CHECK(as[1].attribute_place("y").column == 7);
  CHECK(as[1].attribute("y") == "3");
  CHECK(!as[1].attribute("x"));
}

TEST_CASE("long lists of numbers keep places, and faults behind them their lines") {
  std::string numbers;
  for (int i = 0; i < 5000; ++i) numbers += std::to_string(i) + (i % 10 == 9 ? "\n" : " ");
  const auto xml = parse("<root><a>" + numbers + "</a><b>" + numbers + "x</b></root>");
  const auto a = xml->root().required_child("a"), b = xml->root().required_child("b");
  CHECK(a.indices().size() == 5000);
  CHECK(a.indices().back() == 4999);
  CHECK(a.number_place(4999).line == 500);
  CHECK(b.place().line == 501);
  CHECK(error_of([&] { b.indices(); }).find("a.xml:1001:1: \"x\" is not a whole number") == 0);
  CHECK(parse_error("<root><a>" + numbers + "</a>\n<b></a></root>").find("a.xml:502:1: ") == 0);
  CHECK(parse_error("<root><a>" + numbers).find("a.xml:500:50: not XML: the file is cut off") == 0);
}

TEST_CASE("numbers run on past comments and within CDATA, and keep their places") {
  const auto xml = parse("<p>1 2<!-- 9 9 -->\n3 <![CDATA[4 x]]> 5</p>");
  CHECK(error_of([&] { xml->root().floats(); }) ==
        "a.xml:2:14: \"x\" is not a number; valid are decimal numbers such as -1.5 or 2e-3\n"
        "  3 <![CDATA[4 x]]> 5</p>\n"
        "               ^");
  CHECK(parse("<p>1 2<!-- 9 9 -->\n3 <![CDATA[4 ]]> 5</p>")->root().floats() ==
        std::vector<float>{1, 2, 3, 4, 5});
}

TEST_CASE("references in texts are decoded, and those to white space part numbers") {
  CHECK(parse("<p> a&amp;b&#50; &lt;&#xe9;&#13;</p>")->root().text() == "a&b2 <\xc3\xa9");
  CHECK(parse("<p>a<!-- no --><![CDATA[&amp;]]><q>not this</q> nor this</p>")->root().text() == "a &amp;");
  const auto xml = parse("<p>1 2&#13;\n3&#xD;&#9;4&#x20;x</p>");
  CHECK(error_of([&] { xml->root().floats(); }).find("a.xml:2:18: \"x\" is not a number") == 0);
  CHECK(parse("<p>1&#10;2&#13;\n3&#xd;</p>")->root().indices() == std::vector<std::uint32_t>{1, 2, 3});
  // A reference to anything else is no part of a number.
  CHECK(error_of([&] { parse("<p>1 2&#50;</p>")->root().floats(); }).find("a.xml:1:6: \"2&#50;\" is") == 0);
}

TEST_CASE("an empty element has no numbers and no text") {
  CHECK(parse("<p/>")->root().floats().empty());
  CHECK(parse("<p></p>")->root().text().empty());
  CHECK(parse("<p> a b\n</p>")->root().text() == "a b");
}

TEST_CASE("what is needed and missing is named") {
  const auto xml = parse("<p count='' n='x'>1 2</p>");
  const XmlElement root = xml->root();
  CHECK(error_of([&] { root.required_child("q"); }) ==
        "a.xml:1:1: <p> has no <q>, which it needs\n  <p count='' n='x'>1 2</p>\n  ^");
  CHECK(error_of([&] {
          root.required_attribute("count");
        }).find("a.xml:1:4: the attribute \"count\" is empty") == 0);
  CHECK(error_of([&] {
          root.required_index_attribute("n");
        }).find("a.xml:1:13: \"x\" is not a whole number from 0 to 4294967295") == 0);
  CHECK(error_of([&] { root.doubles(3); }).find("a.xml:1:1: <p> needs 3 numbers, and has 2") == 0);
  CHECK(root.index_attribute("set", 7) == 7);
}

TEST_CASE("elements nested more than 98 deep are refused with that number, and 98 are read") {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<a>";
    for (int i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  CHECK(parse_error(nested(98)).empty());
  for (const int depth : {99, 2000})
    CHECK(parse_error(nested(depth))
              .find("a.xml:1:1: elements are nested more than 98 deep, the most that is read\n") == 0);
}

TEST_CASE("a file too large is refused by its size, before it is read") {
  const test::TemporaryFolder folder;
  test::write_text(folder.file("a.dae"), "<COLLADA/>");
  std::filesystem::resize_file(folder.file("a.dae"), std::uintmax_t(1) << 33);  // sparse: no disk is filled
  CHECK(error_of([&] { XmlDocument::load(folder.file("a.dae")); }) ==
        folder.file("a.dae") + ": the file has 8589934592 bytes; at most 1073741824 are read");
}

TEST_CASE("bytes that are no text are refused") {
  CHECK(parse_error(std::string("<a>\0</a>", 8)) == "a.xml: not XML in UTF-8: byte 3 is zero");
  CHECK(parse_error("<!-- nothing -->") == "a.xml: not XML: there is no element in it");
}

TEST_CASE("a byte order mark is no part of the document") {
  const auto xml = parse("\xef\xbb\xbf<a>1</a>");
  CHECK(xml->root().number() == 1);
  CHECK(xml->root().place().column == 1);
}

TEST_CASE("other formats are refused by their names") {
  const auto error = [](const std::string& start) { return parse_error(start + std::string(8, '\0')); };
  const std::string valid = "; valid is XML in UTF-8";
  CHECK(error("\xff\xfe<") == "a.xml: the file is text in UTF-16" + valid);
  CHECK(error("\xfe\xff") == "a.xml: the file is text in UTF-16" + valid);
  CHECK(error("<") == "a.xml: the file is text in UTF-16" + valid);
  CHECK(error(std::string("\0<", 2)) == "a.xml: the file is text in UTF-16" + valid);
  CHECK(error(std::string("\xff\xfe\0\0<", 5)) == "a.xml: the file is text in UTF-32" + valid);
  CHECK(error("\x1f\x8b\x08") == "a.xml: the file is compressed (gzip)" + valid);
  CHECK(error("PK\x03\x04") == "a.xml: the file is a zip archive" + valid);
}

TEST_CASE("an encoding that is not UTF-8 is told where it matters") {
  const auto encoding = [](const std::string& name, const std::string& letters) {
    return parse("<?xml version='1.0' encoding='" + name + "'?><a>" + letters + "</a>")->foreign_encoding();
  };
  CHECK(encoding("ISO-8859-1", "caf\xe9") == "ISO-8859-1");
  CHECK(encoding("ISO-8859-1", "cafe").empty());
  CHECK(encoding("utf-8", "caf\xc3\xa9").empty());
  CHECK(parse("<a>caf\xc3\xa9</a>")->foreign_encoding().empty());
}

TEST_CASE("names in the root's namespace come without their prefix, others with it") {
  const auto xml = parse(
      "<c:root xmlns:c='one' xmlns:x='two'><c:a>1</c:a><x:a>2</x:a>"
      "<b xmlns:d='one'><d:a>3</d:a></b></c:root>");
  const XmlElement root = xml->root();
  CHECK(root.is("root"));
  CHECK(xml->root_namespace() == "one");
  CHECK(root.required_child("a").number() == 1);
  CHECK(root.required_child("x:a").number() == 2);
  CHECK(root.required_child("b").required_child("a").number() == 3);
  CHECK(root.required_child("a").place().column == 37);
}

TEST_CASE("an element knows the one that holds it") {
  const auto xml = parse("<a><b/></a>");
  CHECK(xml->root().required_child("b").parent() == xml->root());
  CHECK(!xml->root().parent());
}

}  // namespace twinray
