// SPDX-License-Identifier: Apache-2.0
#include "io/collada/texture.h"

#include "core/alpha_test.h"
#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/zip_text.h"

namespace twinray {
namespace {

using test::write_text;

/// Red, green above blue, white; the numbers are 0 or 1, which sRGB leaves as they are.
const ByteImage four_colors{2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};

std::string pairs_source(const std::string& id, const std::string& numbers) {
  return "<source id=\"" + id + "\"><float_array id=\"" + id + "-array\" count=\"6\">" + numbers +
         "</float_array><technique_common><accessor source=\"#" + id +
         "-array\" count=\"3\" stride=\"2\"><param name=\"S\"/><param name=\"T\"/></accessor>"
         "</technique_common></source>";
}

/// A triangle with two sets of texture coordinates, 0 and 3.
const std::string mesh = collada_mesh(
    3, "0 0 0 1 0 0 0 1 0",
    pairs_source("first", "0 0 1 0 0 1") + pairs_source("second", "0.5 0.5 2.5 0.5 0.5 2.5") +
        "<triangles material=\"paint\" count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" "
        "offset=\"0\"/><input semantic=\"TEXCOORD\" source=\"#first\" offset=\"0\" set=\"0\"/>"
        "<input semantic=\"TEXCOORD\" source=\"#second\" offset=\"0\" set=\"3\"/><p>0 1 2</p></triangles>");

const std::string color_image =
    "<library_images><image id=\"colors\"><init_from>colors.png</init_from></image></library_images>";
const std::string colors = "<texture texture=\"colors\" texcoord=\"UV\"/>";

std::string sampler(const std::string& words) {
  return "<newparam sid=\"surface\"><surface type=\"2D\"><init_from>colors</init_from></surface></newparam>"
         "<newparam sid=\"sampler\"><sampler2D><source>surface</source>" +
         words + "</sampler2D></newparam>";
}

/// A document whose triangle's effect has these parameters and slots; `bind` stands in its
/// <instance_material>.
std::string document(const std::string& parameters, const std::string& slots, const std::string& bind = "") {
  return collada_text(
      color_image + mesh + "<library_effects><effect id=\"fx\"><profile_COMMON>" + parameters +
          "<technique><lambert>" + slots +
          "</lambert></technique></profile_COMMON></effect></library_effects><library_materials>"
          "<material id=\"m\"><instance_effect url=\"#fx\"/></material></library_materials>",
      "<node><instance_geometry url=\"#shape\"><bind_material><technique_common><instance_material "
      "symbol=\"paint\" target=\"#m\">" +
          bind + "</instance_material></technique_common></bind_material></instance_geometry></node>");
}

std::string diffuse(const std::string& texture) { return "<diffuse>" + texture + "</diffuse>"; }

/// A folder with the picture, and documents beside it.
struct PictureFolder {
  PictureFolder() { write_png(folder.file("colors.png"), four_colors); }

  LoadedScene load(const std::string& text, const LoadOptions& options = {}) const {
    return read_collada(*XmlDocument::parse(text, folder.file("scene.dae")), options);
  }

  test::TemporaryFolder folder;
};

const ImageTexture& picture_of(const LoadedScene& loaded) {
  const Material& material = loaded.scene.materials[loaded.scene.bindings[0].material];
  REQUIRE(material.textures.size() == 1);
  CHECK(material.textures[0].input == MaterialInput::reflectance);
  return std::get<ImageTexture>(loaded.scene.textures[material.textures[0].texture].model);
}

/// What the surface's color is where its texture coordinates are these.
Rgb color_at(const LoadedScene& loaded, Vec2 uv) {
  const Material& material = loaded.scene.materials[loaded.scene.bindings[0].material];
  return evaluate(loaded.scene.textures, material.textures.at(0).texture, {.uv = uv, .is_smooth = true});
}

}  // namespace

TEST_CASE("a diffuse texture is a picture over the first texture coordinates, its lower left at 0 0") {
  const PictureFolder folder;
  const LoadedScene loaded = folder.load(document("", diffuse(colors)));
  CHECK(messages(loaded).empty());
  CHECK(color_at(loaded, {0.25f, 0.25f}) == Rgb{0, 0, 1});
  CHECK(color_at(loaded, {0.25f, 0.75f}) == Rgb{1, 0, 0});
  CHECK(color_at(loaded, {1.75f, 0.75f}) == Rgb{0, 1, 0});
  CHECK(mesh_of(loaded).uvs == std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(loaded.scene.lights.empty());
}

TEST_CASE("bind_vertex_input says which set of texture coordinates a texture means") {
  const PictureFolder folder;
  const auto uvs = [&](const std::string& bind) {
    return mesh_of(folder.load(document("", diffuse(colors), bind))).uvs;
  };
  const std::vector<Vec2> first{{0, 0}, {1, 0}, {0, 1}}, second{{0.5f, 0.5f}, {2.5f, 0.5f}, {0.5f, 2.5f}};
  const auto bind = [](const std::string& semantic, const std::string& set) {
    return "<bind_vertex_input semantic=\"" + semantic + "\" input_semantic=\"TEXCOORD\" input_set=\"" + set +
           "\"/>";
  };
  CHECK(uvs("") == first);
  CHECK(uvs(bind("UV", "0")) == first);
  CHECK(uvs(bind("UV", "3")) == second);
  CHECK(uvs(bind("OTHER", "3")) == first);
  CHECK(uvs(bind("OTHER", "0") + bind("UV", "3")) == second);
  CHECK(uvs(bind("UV", "7")) == first);  // There is none.
}

TEST_CASE("where bind_vertex_input names no set, or one that is not there, the set that is used is told") {
  const PictureFolder folder;
  const auto warnings = [&](const std::string& attributes) {
    std::vector<std::string> messages;
    const std::string bind = "<bind_vertex_input semantic=\"UV\" " + attributes + "/>";
    const LoadedScene loaded = folder.load(document("", diffuse(colors), bind));
    CHECK(mesh_of(loaded).uvs == std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}});
    for (const Diagnostic& warning : loaded.warnings) messages.push_back(warning.message);
    return messages;
  };
  using Messages = std::vector<std::string>;
  const std::string usual = "input_semantic=\"TEXCOORD\" ";
  CHECK(warnings(usual + "input_set=\"0\"").empty());
  CHECK(warnings(usual) == Messages{"the input_set is missing, and <triangles> has 2 sets of texture "
                                    "coordinates; set 0 is used"});
  CHECK(warnings(usual + "input_set=\"7\"") ==
        Messages{"<triangles> has no texture coordinates of the set 7; set 0 is used"});
}

TEST_CASE("a sampler says how a picture goes on beside itself, and a Maya technique where it lies") {
  const PictureFolder folder;
  const auto load = [&](const std::string& words, const std::string& extra = "") {
    return folder.load(document(
        sampler(words), diffuse("<texture texture=\"sampler\" texcoord=\"UV\">" + extra + "</texture>")));
  };
  const std::string clamp = "<wrap_s>CLAMP</wrap_s><wrap_t>CLAMP</wrap_t>";
  CHECK(picture_of(load("")).wrap == WrapMode::repeat);
  CHECK(picture_of(load(clamp)).wrap == WrapMode::clamp);
  CHECK(picture_of(load("<wrap_s>BORDER</wrap_s><wrap_t>NONE</wrap_t>")).wrap == WrapMode::black);
  CHECK(picture_of(load("<wrap_s>BORDER</wrap_s><wrap_t>CLAMP</wrap_t>")).wrap ==
        Wrap{WrapMode::black, WrapMode::clamp});
  CHECK(picture_of(load("<wrap_t>CLAMP</wrap_t>")).wrap == Wrap{WrapMode::repeat, WrapMode::clamp});
  CHECK(picture_of(load("<magfilter>NEAREST</magfilter>")).filter == TextureFilter::nearest);
  const LoadedScene mirrored = load("<wrap_s>MIRROR</wrap_s>");
  CHECK(color_at(mirrored, {0.25f, 0.75f}) == Rgb{1, 0, 0});
  CHECK(color_at(mirrored, {1.25f, 0.75f}) == Rgb{0, 1, 0});
  CHECK(color_at(mirrored, {1.75f, 0.75f}) == Rgb{1, 0, 0});
  const auto maya = [](const std::string& numbers) {
    return "<extra><technique profile=\"MAYA\">" + numbers + "</technique></extra>";
  };
  const LoadedScene placed = load("", maya("<repeatU>2</repeatU><offsetV>0.5</offsetV>"));
  CHECK(picture_of(placed).uv({1, 1}) == Vec2{2, 1.5f});
  const LoadedScene maya_mirrored = load("", maya("<mirrorU>1</mirrorU><mirrorV>0</mirrorV>"));
  CHECK(color_at(maya_mirrored, {1.25f, 0.75f}) == Rgb{0, 1, 0});
  CHECK(color_at(maya_mirrored, {0.25f, 1.75f}) == color_at(maya_mirrored, {0.25f, 0.75f}));
  CHECK(messages(load("", maya("<rotateFrame>0</rotateFrame><rotateUV>90</rotateUV>"))) ==
        std::vector<std::string>{"the picture is not turned by <rotateUV>"});
  const LoadedScene senseless = load("", maya("<repeatU>3</repeatU><mirrorU>x</mirrorU>"));
  CHECK(picture_of(senseless).uv == UvTransform{});
  CHECK(messages(load("", maya("<repeatU>two</repeatU>"))) ==
        std::vector<std::string>{"where this picture lies makes no sense; it lies as it is"});
}

TEST_CASE("a bump map of another program is told") {
  const PictureFolder folder;
  const auto said = [&](const std::string& bump) {
    return messages(folder.load(
        document("", diffuse(colors) + "</lambert><extra><technique profile=\"FCOLLADA\"><bump>" + bump +
                         "</bump></technique></extra></technique></profile_COMMON></effect>"
                         "<effect id=\"other\"><profile_COMMON><technique><lambert>")));
  };
  CHECK(said(colors) == std::vector<std::string>{"bump maps are not rendered; the surface stays smooth"});
  CHECK(said("").empty());
}

TEST_CASE("a picture is found by its URI or, where exporters wrote another system's path, beside the file") {
  const PictureFolder folder;
  const auto color_by = [&](const std::string& name) {
    std::string text = document("", diffuse(colors));
    text.replace(text.find("colors.png"), 10, name);
    return color_at(folder.load(text), {0.25f, 0.25f});
  };
  const Rgb blue{0, 0, 1}, magenta{1, 0, 1};
  CHECK(color_by("./col%6Frs.png") == blue);
  CHECK(color_by("file:///C:/pictures/colors.png") == blue);
  CHECK(color_by("..\\pictures\\colors.png") == blue);
  CHECK(color_by("none.png") == magenta);
}

TEST_CASE("a picture that cannot be read is told with its texture's place") {
  const PictureFolder folder;
  write_text(folder.folder.file("colors.png"), "no picture");
  const LoadedScene loaded = folder.load(document("", diffuse(colors)));
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.ends_with("; it is shown magenta"));
  CHECK(loaded.warnings[0].place.line > 0);
  LoadOptions strict;
  strict.strict = true;
  CHECK_THROWS_AS(folder.load(document("", diffuse(colors)), strict), Error);
}

TEST_CASE("an emission texture is the picture of a light") {
  const PictureFolder folder;
  const LoadedScene loaded =
      folder.load(document("", "<emission>" + colors + "</emission>" + diffuse("<color>1 1 1 1</color>")));
  REQUIRE(loaded.scene.lights.size() == 1);
  const auto& light = std::get<MeshLight>(loaded.scene.lights[0].source);
  CHECK(light.radiance == Rgb{1, 1, 1});
  REQUIRE(light.picture);
  CHECK(light.picture->at(0, 0) == Rgb{1, 0, 0});
  // Twice in each direction: it ends along u, and repeats along v.
  const std::string twice =
      "<texture texture=\"sampler\" texcoord=\"UV\"><extra><technique profile=\"MAYA\">"
      "<repeatU>2</repeatU><repeatV>2</repeatV></technique></extra></texture>";
  const LoadedScene placed =
      folder.load(document(sampler("<wrap_s>CLAMP</wrap_s>"), "<emission>" + twice + "</emission>"));
  const auto lamp = std::get<MeshLight>(placed.scene.lights.at(0).source);
  REQUIRE(lamp.picture);
  CHECK(lamp.uv({1, 1}) == Vec2{2, 2});
  CHECK(lamp.wrap == Wrap{WrapMode::clamp, WrapMode::repeat});
  CHECK(lamp.filter == TextureFilter::bilinear);
  const LoadedScene squares =
      folder.load(document(sampler("<magfilter>NEAREST</magfilter>"), "<emission>" + twice + "</emission>"));
  CHECK(std::get<MeshLight>(squares.scene.lights.at(0).source).filter == TextureFilter::nearest);
  // Coordinates beyond the picture are where it goes on.
  const std::string far = "<bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" input_set=\"3\"/>";
  const LoadedScene beside = folder.load(document("", "<emission>" + colors + "</emission>", far));
  CHECK(std::get<MeshLight>(beside.scene.lights.at(0).source).picture);
  CHECK(beside.warnings.empty());
  write_text(folder.folder.file("colors.png"), "no picture");
  CHECK(folder.load(document("", "<emission>" + colors + "</emission>")).scene.lights.empty());
}

TEST_CASE("a texture of the transparency cuts holes, in each opaque mode") {
  const test::TemporaryFolder folder;
  // Alpha 0 and 1; grey 1 and 0.
  Image image(2, 1);
  image.at(0, 0) = {1, 1, 1};
  write_png(folder.file("colors.png"), {2, 1, {255, 255, 255, 0, 0, 0}});
  const auto alpha = [&](const std::string& mode, const std::string& amount, Vec2 uv) {
    const LoadedScene loaded =
        read_collada(*XmlDocument::parse(document("", "<transparent opaque=\"" + mode + "\">" + colors +
                                                          "</transparent><transparency><float>" + amount +
                                                          "</float></transparency>"),
                                         folder.file("scene.dae")),
                     {});
    CHECK(messages(loaded).empty());
    const std::uint32_t texture = loaded.scene.bindings[0].alpha;
    REQUIRE(texture != no_texture);
    CHECK_FALSE(loaded.scene.geometry->is_opaque(0));
    return evaluate(loaded.scene.textures, texture, {.uv = uv, .is_smooth = true}).r;
  };
  const Vec2 bright{0.25f, 0.5f}, dark{0.75f, 0.5f};
  CHECK(alpha("RGB_ONE", "1", bright) == 1);
  CHECK(alpha("RGB_ONE", "1", dark) == 0);
  CHECK(alpha("RGB_ONE", "0.5", bright) == 0.5f);
  CHECK(alpha("RGB_ZERO", "1", bright) == 0);
  CHECK(alpha("RGB_ZERO", "1", dark) == 1);
  CHECK(alpha("RGB_ZERO", "0.5", bright) == 0.5f);
}

TEST_CASE("the brightness of a transparency is that of its colours, its alpha that alone") {
  const auto channels_of = [](const std::string& mode) {
    LoadOptions options;
    options.pictures = std::make_shared<std::vector<PictureUse>>();
    read_collada(
        *XmlDocument::parse(document("", "<transparent opaque=\"" + mode + "\">" + colors + "</transparent>"),
                            "a.dae"),
        options);
    return options.pictures->at(0).meaning.channels;
  };
  for (const char* mode : {"RGB_ONE", "RGB_ZERO"}) CHECK(channels_of(mode) == PictureChannels::brightness);
  for (const char* mode : {"A_ONE", "A_ZERO"}) CHECK(channels_of(mode) == PictureChannels::alpha);
}

TEST_CASE("holes of a picture that cannot be read are none") {
  const PictureFolder folder;
  write_text(folder.folder.file("colors.png"), "no picture");
  for (const std::string mode : {"A_ONE", "A_ZERO", "RGB_ONE", "RGB_ZERO"}) {
    const LoadedScene loaded =
        folder.load(document("", "<transparent opaque=\"" + mode + "\">" + colors + "</transparent>"));
    CHECK(loaded.scene.geometry->is_opaque(0));
    CHECK(messages(loaded).size() == 1);
  }
}

TEST_CASE("materials that instance one effect may set its picture") {
  const PictureFolder folder;
  write_png(folder.folder.file("white.png"), {1, 1, {255, 255, 255}});
  std::string text = document(sampler(""), diffuse("<texture texture=\"sampler\" texcoord=\"UV\"/>"));
  const auto replace = [&](const std::string& old, const std::string& anew) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    text.replace(at, old.size(), anew);
  };
  replace("</library_images>",
          "<image id=\"white\"><init_from>white.png</init_from></image></library_images>");
  replace("</library_materials>",
          "<material id=\"n\"><instance_effect url=\"#fx\"><setparam ref=\"surface\"><surface "
          "type=\"2D\"><init_from>white</init_from></surface></setparam></instance_effect></material>"
          "</library_materials>");
  const std::size_t begin = text.find("<node>"), end = text.find("</node>") + 7;
  std::string second = text.substr(begin, end - begin);
  second.replace(second.find("#m"), 2, "#n");
  text.insert(end, second);
  const LoadedScene loaded = folder.load(text);
  REQUIRE(loaded.scene.textures.size() == 2);
  const auto color = [&](std::uint32_t texture) {
    return evaluate(loaded.scene.textures, texture, {.uv = {0.25f, 0.25f}, .is_smooth = true});
  };
  CHECK(color(0) == Rgb{0, 0, 1});
  CHECK(color(1) == Rgb{1, 1, 1});
}

TEST_CASE("a picture without holes leaves its surface opaque") {
  const PictureFolder folder;  // Its picture has no alpha.
  const LoadedScene loaded = folder.load(
      document("", diffuse(colors) + "<transparent opaque=\"A_ONE\">" + colors + "</transparent>"));
  CHECK(loaded.scene.geometry->is_opaque(0));
  CHECK(loaded.scene.bindings[0].alpha == no_texture);
  CHECK(messages(loaded).empty());
}

TEST_CASE("what textures have no coordinates, or other ones, is told") {
  const PictureFolder folder;
  std::string text = document("", diffuse(colors));
  for (const char* set : {"0", "3"}) {
    const std::string input = std::string(" set=\"") + set + "\"/>";
    const std::size_t end = text.find(input) + input.size(), begin = text.rfind("<input", end - 1);
    text.erase(begin, end - begin);
  }
  const LoadedScene bare = folder.load(text);
  CHECK(messages(bare) ==
        std::vector<std::string>{"<triangles> has no texture coordinates, which its texture needs; "
                                 "it has the color of the picture's lower left corner"});
  CHECK(mesh_of(bare).uvs == std::vector<Vec2>{{0, 0}});
  const std::string other = "<texture texture=\"colors\" texcoord=\"OTHER\"/>";
  CHECK(messages(folder.load(document("", diffuse(colors) + "<emission>" + other + "</emission>"))) ==
        std::vector<std::string>{"the textures of a surface have one set of texture coordinates here: "
                                 "\"OTHER\", and not \"UV\""});
}

TEST_CASE("by CS184's rules a textured surface is grey") {
  const PictureFolder folder;
  LoadOptions options;
  options.interpretation = Interpretation::cs184;
  const LoadedScene loaded = folder.load(document("", diffuse(colors)), options);
  CHECK(loaded.scene.textures.empty());
  CHECK(messages(loaded)[0] == "the texture \"colors.png\" is not rendered; the surface is grey (0.5)");
}

TEST_CASE("pictures of an archive are its own") {
  const test::TemporaryFolder folder;
  write_png(folder.file("colors.png"), four_colors);
  const std::string png = test::read_text(folder.file("colors.png"));
  const auto load = [&](const std::string& name) {
    std::string text = document("", diffuse(colors));
    text.replace(text.find("colors.png"), 10, name);
    write_text(folder.file("a.zae"), test::zip_text({{"manifest.xml", "<dae_root>a/scene.dae</dae_root>"},
                                                     {"a/scene.dae", text},
                                                     {"pictures/colors.png", png}}));
    return load_scene(folder.file("a.zae"));
  };
  const LoadedScene inside = load("../pictures/colors.png");
  CHECK(color_at(inside, {0.25f, 0.25f}) == Rgb{0, 0, 1});
  CHECK(messages(inside).empty());
  for (const std::string& name : {folder.file("colors.png"), std::string("/c.png")}) {
    const LoadedScene outside = load(name);
    CHECK(color_at(outside, {0.25f, 0.25f}) == Rgb{1, 0, 1});
    REQUIRE(outside.warnings.size() == 1);
    CHECK_THAT(outside.warnings[0].message, Catch::Contains("this lies outside of the archive"));
  }
}

}  // namespace twinray
