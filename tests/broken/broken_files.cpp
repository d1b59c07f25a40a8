// SPDX-License-Identifier: Apache-2.0
// Each kind of damage is one function. What a place in the file may be replaced with stands beside it.
#include "tests/broken/broken_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr unsigned seed = 184;

using Files = std::vector<BrokenFile>;
using Swap = std::pair<std::string, std::string>;  ///< Old text, new text.

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// The whole file with the first `old` replaced; it must stand in it.
std::string with(const std::string& old, const std::string& anew) {
  std::string text = whole_file();
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::logic_error("the whole file does not hold " + old);
  return text.replace(at, old.size(), anew);
}

std::string nodes(const std::string& inner) { return with("<node id=\"eye-node\">", inner + "<node>"); }

/// Of one sample of the whole file's markup each: where a cut leaves something open.
void add_truncated(Files& files) {
  const std::string whole = whole_file();
  const std::array<Swap, 14> places{{{"a tag's name", "<library_cam"},
                                     {"an opening bracket", "<asset><"},
                                     {"an attribute's name", "<unit na"},
                                     {"an equals sign", "<unit name="},
                                     {"a value", "<unit name=\"me"},
                                     {"a comment", "<!-- a com"},
                                     {"a number", "<xfov>4"},
                                     {"a list of numbers", "0 0 0 1 0 0 1 "},
                                     {"a list of indices", "<p>0 0 1 0 "},
                                     {"a CDATA section", "<![CDATA["},
                                     {"a closing tag", "</library_li"},
                                     {"an empty element", "url=\"#world\"/"},
                                     {"the declaration", "<?xml ver"},
                                     {"the last tag", "</COLLADA"}}};
  for (const auto& [name, before] : places) {
    const std::size_t end = whole.find(before);
    if (end == std::string::npos) throw std::logic_error("the whole file does not hold " + before);
    files.push_back({"cut off within " + name, whole.substr(0, end + before.size())});
  }
  std::mt19937 random(seed);
  std::set<std::size_t> ends;
  while (ends.size() < 40) ends.insert(1 + random() % (whole.rfind("</COLLADA>") - 1));
  for (const std::size_t end : ends)
    files.push_back({fmt::format("cut off after {} bytes", end), whole.substr(0, end)});
}

void add_flipped(Files& files) {
  std::mt19937 random(seed + 1);
  for (int i = 0; i < 60; ++i) {
    std::string text = whole_file();
    for (int flips = 1 << (i % 4); flips > 0; --flips) {
      const std::size_t at = random() % text.size();
      text[at] = char(text[at] ^ (1 << (random() % 8)));
    }
    files.push_back({fmt::format("bits flipped, file {}", i), text, false});
  }
}

void add_nested(Files& files) {
  for (const std::size_t depth : {90, 200, 100000}) {
    const bool is_read = depth == 90;
    const auto nested = [&](const std::string& tag) {
      return repeated("<" + tag + ">", depth) + repeated("</" + tag + ">", depth);
    };
    files.push_back({fmt::format("{} nodes within each other", depth), nodes(nested("node")), !is_read,
                     is_read ? "" : "nested more than "});
    files.push_back({fmt::format("{} unknown elements within each other", depth), nodes(nested("a")), true,
                     is_read ? "<a>" : "nested more than "});
    files.push_back({fmt::format("{} extras within each other", depth), nodes(nested("extra")), true});
    files.push_back({fmt::format("{} elements that are not closed", depth), repeated("<node>", depth)});
  }
}

/// A chain of nodes each of which instances the next `times` times.
std::string instance_chain(int length, int times) {
  std::string library;
  for (int i = 0; i < length; ++i)
    library += fmt::format("<node id=\"n{}\">{}</node>\n", i,
                           repeated(fmt::format("<instance_node url=\"#n{}\"/>", i + 1), std::size_t(times)));
  library += fmt::format("<node id=\"n{}\"><instance_geometry url=\"#ball\"/></node>\n", length);
  return with("<instance_node url=\"#part\"/>", "<instance_node url=\"#n0\"/>")
      .replace(whole_file().find("<node id=\"part\">"), 0, library);
}

void add_circles(Files& files) {
  const auto circle = [&](const std::string& name, const std::string& library, const std::string& first) {
    std::string text = with("<instance_node url=\"#part\"/>", "<instance_node url=\"#" + first + "\"/>");
    text.insert(text.find("<node id=\"part\">"), library);
    files.push_back({name, text, true, "nodes must form no circle"});
  };
  circle("a node that instances itself", "<node id=\"a\"><instance_node url=\"#a\"/></node>", "a");
  circle("two nodes that instance each other",
         "<node id=\"a\"><instance_node url=\"#b\"/></node><node id=\"b\"><instance_node url=\"#a\"/></node>",
         "a");
  circle("a node that instances what it stands in",
         "<node id=\"a\"><node><node><instance_node url=\"#a\"/></node></node></node>", "a");
  files.push_back({"a scene that instances its own node",
                   with("<instance_node url=\"#part\"/>", "<instance_node url=\"#part-node\"/>"), true,
                   "nodes must form no circle"});
  files.push_back({"2^40 instances", instance_chain(40, 2), true, "nodes"});
  files.push_back({"10^9 instances", instance_chain(9, 10), true, "nodes"});
  files.push_back({"instances nested 100000 deep", instance_chain(100000, 1), true, "nested more than "});
}

void add_entities(Files& files) {
  const auto doctype = [](const std::string& declarations) {
    return with("<COLLADA", "<!DOCTYPE COLLADA [" + declarations + "]>\n<COLLADA");
  };
  std::string laughs = "<!ENTITY l0 \"1 1 1 1 1 1 1 1 1 1\">";
  for (int i = 1; i < 12; ++i)
    laughs += fmt::format("<!ENTITY l{} \"{}\">", i, repeated(fmt::format("&l{};", i - 1), 10));
  const auto use = [](std::string text, const std::string& entity) {
    const std::string list = "0 0 0 1 0 0 1 1 0 0 1 0";
    return text.replace(text.find(list), list.size(), entity);
  };
  files.push_back({"entities that grow without end", use(doctype(laughs), "&l11;")});
  files.push_back(
      {"an entity of an outer file", use(doctype("<!ENTITY e SYSTEM \"file:///etc/passwd\">"), "&e;")});
  files.push_back(
      {"an entity that is not defined", use(whole_file(), "&none;"), true, "\"&none;\" is not a number"});
  files.push_back(
      {"a parameter entity", doctype("<!ENTITY % p SYSTEM \"http://127.0.0.1/x.dtd\"> %p;"), false});
  files.push_back({"a document type of another file",
                   with("<COLLADA", "<!DOCTYPE a SYSTEM \"a.dtd\">\n<COLLADA"), false});
  files.push_back({"a document type that does not end", with("<COLLADA", "<!DOCTYPE COLLADA [ <COLLADA")});
  for (const std::string reference :
       {"&#0;", "&#x110000;", "&#xD800;", "&#-1;", "&#99999999999999999999;", "&;", "&#x;"})
    files.push_back({"the character " + reference, use(whole_file(), reference)});
}

/// Words that are no numbers, or none that a scene may have.
const std::array<std::string, 14> wrong_numbers{"1,5",   "nan",  "-nan(0x1)", "inf",         "-inf",
                                                "1e400", "0x10", "1.5f",      "1e",          "--1",
                                                "1_0",   "one",  "1.2.3",     "\xef\xbc\x91"};

/// Where a number stands: the text around it, as the old text and what stands before and behind the new
/// number.
struct NumberPlace {
  std::string name, old, before, behind;
};

const std::array<NumberPlace, 12> number_places{
    {{"a float array", ">0 0 0 1 0 0", ">0 0 0 ", " 0 0"},
     {"a normal", ">0 0 1<", ">0 0 ", "<"},
     {"a matrix", "<matrix>1 0 0 0", "<matrix>1 0 ", " 0"},
     {"a rotation", "<rotate>0 1 0 10", "<rotate>0 1 0 ", ""},
     {"a scale", "<scale>1 1 1", "<scale>1 1 ", ""},
     {"a translation", "<translate>0.5 0.5 3", "<translate>0.5 0.5 ", ""},
     {"a field of view", "<xfov>40<", "<xfov>", "<"},
     {"a near clip distance", "<znear>0.1<", "<znear>", "<"},
     {"a color", "<color>0.8 0.1 0.1 1<", "<color>0.8 ", " 0.1 1<"},
     {"a light", "<color>2 2 2<", "<color>2 2 ", "<"},
     {"a falloff angle", "<falloff_angle>60<", "<falloff_angle>", "<"},
     {"a radius", "<radius>0.25<", "<radius>", "<"}}};

void add_numbers(Files& files) {
  for (const NumberPlace& place : number_places)
    for (const std::string& number : wrong_numbers)
      files.push_back({fmt::format("{} in {}", number, place.name),
                       with(place.old, place.before + number + place.behind), true,
                       number == "1,5" || number == "0x10" ? "\"" + number + "\"" : ""});
}

void add_indices(Files& files) {
  const std::array<std::string, 9> indices{"-1",  "4",   "4294967295", "4294967296", "99999999999999999999",
                                           "1e0", "1.0", "+1",         "0x1"};
  for (const std::string& index : indices) {
    const bool is_whole = index == "4" || index == "4294967295";
    const std::string said = is_whole ? fmt::format("the index {} is out of range", index)
                                      : fmt::format("\"{}\" is not a whole number", index);
    files.push_back(
        {"index " + index + " of triangles", with("<p>0 0 1 0", "<p>0 0 " + index + " 0"), true, said});
    files.push_back(
        {"index " + index + " of a polylist", with("<p>0 1 2 <", "<p>0 " + index + " 2 <"), true, said});
    files.push_back({"offset " + index, with("offset=\"1\"", "offset=\"" + index + "\"")});
    files.push_back({"vertex count " + index, with("<vcount>4<", "<vcount>" + index + " 4<")});
  }
  files.push_back(
      {"index 1 of one normal", with("<p>0 0 1 0", "<p>0 0 1 1"), true, "the index 1 is out of range"});
  files.push_back({"indices that are no multiple", with("2 0 3 0</p>", "2 0 3</p>"), true, "multiple of"});
}

void add_counts(Files& files) {
  for (const std::string count :
       {"4294967295", "1000000000", "18446744073709551616", "-1", "", "many", "0"}) {
    const auto counted = [&](const std::string& where, const std::string& old, const std::string& attribute) {
      files.push_back({fmt::format("{} \"{}\" of {}", attribute, count, where),
                       with(old, old.substr(0, old.rfind('=') + 1) + "\"" + count + "\"")});
    };
    counted("a float array", "id=\"positions-array\" count=\"12\"", "count");
    counted("an accessor", "source=\"#positions-array\" count=\"4\"", "count");
    counted("an accessor's step", "source=\"#positions-array\" count=\"4\" stride=\"3\"", "stride");
    counted("triangles", "<triangles material=\"paint\" count=\"2\"", "count");
    counted("a polylist", "<polylist material=\"paint\" count=\"1\"", "count");
  }
  files.push_back({"a polygon of 2^32 - 1 corners", with("<vcount>4<", "<vcount>4294967295<")});
  files.push_back({"a polygon of 2 corners", with("<vcount>4<", "<vcount>2 2<")});
  files.push_back({"an accessor that begins behind the array",
                   with("count=\"4\" stride=\"3\"", "count=\"4\" stride=\"3\" offset=\"4294967295\"")});
}

void add_empty(Files& files) {
  for (const Swap& swap : std::vector<Swap>{{"0 0 0 1 0 0 1 1 0 0 1 0", ""},
                                            {"<vcount>4</vcount>", "<vcount/>"},
                                            {"<xfov>40</xfov>", "<xfov/>"},
                                            {"<radius>0.25</radius>", "<radius/>"},
                                            {"1 0 0 0 0 1 0 2 0 0 1 2 0 0 0 1", ""},
                                            {"<color>2 2 2</color>", "<color></color>"},
                                            {"<scale>1 1 1</scale>", "<scale> </scale>"},
                                            {"url=\"#world\"", "url=\"\""},
                                            {"source=\"#corners\"", "source=\"\""},
                                            {"up_axis>Y_UP", "up_axis>"},
                                            {"meter=\"1\"", "meter=\"\""},
                                            {"version=\"1.4.1\"", "version=\"\""}})
    files.push_back({"nothing in place of " + swap.first, with(swap.first, swap.second)});
  files.push_back({"an empty file", "", true, "the file is empty"});
  files.push_back({"an opening bracket alone", "<", true, "cut off"});
  files.push_back({"white space", " \n\t\r\n ", true, "the file is empty"});
  files.push_back({"a byte order mark alone", "\xef\xbb\xbf"});
  files.push_back({"a comment alone", "<!-- nothing -->", true, "no element"});
  files.push_back({"a root alone", "<COLLADA version=\"1.4.1\"/>", true, "<visual_scene>"});
  files.push_back({"another root", "<svg/>", true, "not COLLADA"});
}

void add_transforms(Files& files) {
  const auto matrix = [&](const std::string& name, const std::string& numbers, const std::string& said) {
    files.push_back({"a matrix " + name,
                     with("<rotate>0 1 0 10</rotate>", "<matrix>" + numbers + "</matrix>"), true, said});
  };
  matrix("of NaN", repeated("nan ", 16), "\"nan\"");
  matrix("of zeros", repeated("0 ", 12) + "0 0 0 1", "");
  matrix("that flattens", "0 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "");
  matrix("that projects", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1", "<matrix>");
  matrix("of 1e300", repeated("1e300 ", 12) + "0 0 0 1", "");
  matrix("of 1e-300", repeated("1e-300 ", 12) + "0 0 0 1", "");
  matrix("of 5 numbers", "1 2 3 4 5", "16 numbers");
  matrix("of 17 numbers", repeated("1 ", 17), "16 numbers");
  const auto transform = [&](const std::string& text, const std::string& said) {
    files.push_back({"the transform " + text, with("<rotate>0 1 0 10</rotate>", text), true, said});
  };
  transform("<scale>0 0 0</scale>", "");
  transform("<rotate>0 0 0 90</rotate>", "0 0 0");
  transform("<lookat>0 0 0 0 0 0 0 1 0</lookat>", "<lookat>");
  transform("<lookat>0 0 1 0 0 0 0 0 1</lookat>", "<lookat>");
  transform("<skew>90 1 0 0 0 1 0</skew>", "<skew>");
  transform("<skew>45 1 0 0 1 0 0</skew>", "<skew>");
  transform("<translate>1e30 0 0</translate>", "");
  transform("<scale>1e20 1 1</scale>", "");
}

void add_cameras(Files& files) {
  for (const std::string degrees : {"0", "-40", "180", "360", "1e30", "179.99999999999"})
    files.push_back(
        {"a field of view of " + degrees, with("<xfov>40<", "<xfov>" + degrees + "<"), true, "<xfov>"});
  files.push_back(
      {"an aspect ratio of 0", with("<aspect_ratio>1.5", "<aspect_ratio>0"), true, "<aspect_ratio>"});
  files.push_back(
      {"an aspect ratio below 0", with("<aspect_ratio>1.5", "<aspect_ratio>-1"), true, "<aspect_ratio>"});
  files.push_back(
      {"a near clip distance beyond the far one", with("<znear>0.1", "<znear>1000"), true, "<znear>"});
  files.push_back({"a camera that does not project",
                   with("<technique_common><perspective>", "<technique_common><fisheye/><perspective>"), true,
                   "<fisheye>"});
  files.push_back(
      {"a camera in a node of scale 0", with("<translate>0.5 0.5 3</translate>", "<scale>0 0 0</scale>")});
  files.push_back({"a light below 0", with("<color>2 2 2", "<color>-2 2 2"), true, "<color>"});
  files.push_back({"a color above 1", with("0.8 0.1 0.1 1", "8 0.1 0.1 1"), true, "<color>"});
  files.push_back({"a radius below 0", with("<radius>0.25", "<radius>-0.25"), true, "<radius>"});
}

/// Without the first element of this name, tags included.
std::string without(const std::string& element) {
  std::string text = whole_file();
  const std::string end = "</" + element + ">";
  const std::size_t begin = text.find("<" + element);
  return text.erase(begin, text.find(end, begin) + end.size() - begin);
}

void add_missing(Files& files) {
  for (const std::string element : {"library_effects", "library_materials", "library_geometries",
                                    "library_nodes", "library_visual_scenes", "scene", "vertices",
                                    "technique_common", "xfov", "vcount", "mesh", "color", "source"})
    files.push_back(
        {"no " + element, without(element), true, element == "scene" ? "<instance_visual_scene>" : ""});
  for (const std::string element : {"library_cameras", "library_lights"})
    files.push_back({"no " + element, without(element)});
  for (const std::string id : {"eye", "bulb", "square", "ball", "part", "red", "red-effect", "corners",
                               "positions", "positions-array", "world"})
    files.push_back({"no id " + id, with("id=\"" + id + "\"", "")});
  for (const std::string id : {"square", "positions", "eye"})
    files.push_back({"two elements of the id " + id,
                     with("<library_lights>", "<library_lights><extra id=\"" + id + "\"/>"), true, id});
  for (const std::string url : {"#none", "none", "other.dae#world", "#", "file:///etc/passwd#a", "#red"})
    files.push_back({"a geometry at " + url, with("url=\"#square\"", "url=\"" + url + "\"")});
}

void add_encodings(Files& files) {
  std::string wide = "\xff\xfe", swapped = "\xfe\xff";
  for (const char c : whole_file()) {
    wide += {c, '\0'};
    swapped += {'\0', c};
  }
  files.push_back({"UTF-16", wide, true, "UTF-16"});
  files.push_back({"UTF-16 of swapped bytes", swapped, true, "UTF-16"});
  files.push_back({"a compressed file", std::string("\x1f\x8b\x08\x00\x00\x00\x00\x00", 8) + whole_file()});
  files.push_back({"a zero byte", with("<asset>", std::string("<asset>\0", 8)), true, "zero"});
  files.push_back({"bytes that are no UTF-8", with("a comment", "\xff\xc0\x80\xed\xa0\x80"), false});
  files.push_back({"an id that is no UTF-8", with("url=\"#square\"", "url=\"#\xff\xc0\x80\"")});
  std::mt19937 random(seed + 2);
  for (int i = 0; i < 8; ++i) {
    std::string bytes;
    for (int n = 0; n < 300; ++n) bytes += char(1 + random() % 255);
    files.push_back({fmt::format("random bytes {}", i), bytes});
  }
}

void add_long(Files& files) {
  const std::string million(1000000, '1');
  files.push_back({"a number of a million digits", with("<xfov>40<", "<xfov>" + million + "<"), true, "..."});
  files.push_back({"an id of a million letters", with("url=\"#square\"", "url=\"#" + million + "\"")});
  files.push_back({"a tag of a million letters", nodes("<a" + million + "/>")});
  files.push_back({"10000 attributes", nodes("<node " + repeated("a=\"\" ", 10000) + "/>")});
  files.push_back({"10000 different warnings", nodes([] {
                     std::string all;
                     for (int i = 0; i < 10000; ++i) all += fmt::format("<unknown{}/>", i);
                     return all;
                   }()),
                   true, "<unknown0>"});
}

}  // namespace

std::string whole_file() {
  static const std::string text = read_text(TWINRAY_SOURCE_DIR "/tests/broken/whole.dae");
  return text;
}

std::vector<BrokenFile> broken_files() {
  Files files;
  for (const auto add :
       {add_truncated, add_flipped, add_nested, add_circles, add_entities, add_numbers, add_indices,
        add_counts, add_empty, add_transforms, add_cameras, add_missing, add_encodings, add_long})
    add(files);
  return files;
}

}  // namespace twinray::test
