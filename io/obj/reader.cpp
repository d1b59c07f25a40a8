// SPDX-License-Identifier: Apache-2.0
#include "io/obj/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <span>
#include <streambuf>
#include <string_view>
#include <tuple>

#include "core/geometry.h"
#include "io/decimal.h"
#include "io/picture/srgb.h"
#include "io/polygon.h"
#include "io/uri.h"

namespace twinray {
namespace {

/// Reads characters where they lie.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string_view text) {
    char* const begin = const_cast<char*>(text.data());  // A get area is never written.
    setg(begin, begin, begin + text.size());
  }
  /// How many have been read.
  std::size_t position() const { return std::size_t(gptr() - eback()); }
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

/// A text that is being read line by line.
class Lines {
 public:
  Lines(const std::string& path, std::string_view text)
      : path_(path), text_(text), buffer_(text), stream(&buffer_) {}
  /// Of the line that was read last.
  Place place() const { return place_of(path_, text_, begin()); }
  std::string_view line() const {
    const std::string_view rest = text_.substr(begin());
    return rest.substr(0, rest.find_first_of("\r\n"));
  }

 private:
  std::size_t begin() const {
    const std::string_view read = text_.substr(0, buffer_.position());
    const std::size_t end = read.find_last_not_of("\r\n");
    const std::size_t before = end == read.npos ? read.npos : read.find_last_of("\r\n", end);
    return before == read.npos ? 0 : before + 1;
  }

  const std::string& path_;
  std::string_view text_;
  TextBuffer buffer_;

 public:
  std::istream stream;
};

/// The color of "v x y z r g b", linear: it is encoded as sRGB has it. Nothing where a line has no such
/// numbers.
std::optional<Rgb> vertex_color(std::string_view line) {
  std::array<float, 3> numbers{};
  std::size_t words = 0;
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != line.npos; ++words) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    if (words >= 4 && words <= 6) {
      const Decimal<float> number = read_decimal<float>(line.substr(at, end - at));
      if (number.fault != DecimalFault::none) return std::nullopt;
      numbers[words - 4] = number.value > 0 ? decode_srgb(std::min(number.value, 1.0f)) : 0;
    }
    at = end;
  }
  if (words != 7) return std::nullopt;
  return Rgb{numbers[0], numbers[1], numbers[2]};
}

/// Material files, from the folder of the file that names them.
class MaterialFiles : public tinyobj::MaterialReader {
 public:
  MaterialFiles(const std::string& path, const ReadFile& read, const Lines& lines, WarningList& warnings)
      : path_(path), read_(read), lines_(lines), warnings_(warnings) {}

  /// What the library calls. A file that cannot be read is a warning.
  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* numbers, std::string*, std::string*) override {
    const std::string file = path_of(name);
    try {
      const std::string text = read_(file);
      TextBuffer buffer(text);
      std::istream stream(&buffer);
      std::string warning, error;
      tinyobj::LoadMtl(numbers, materials, &stream, &warning, &error);
      last_ = file;
      return true;
    } catch (const Error& error) {
      warnings_.add([&] { return lines_.place(); }, fmt::format("its materials are grey: {}", error.what()));
      return false;
    }
  }
  const std::string& last() const { return last_; }

 private:
  /// The library takes a name with spaces for several; most files have one, as it stands.
  std::string path_of(const std::string& name) const {
    std::string_view line = lines_.line();
    line.remove_prefix(std::min(line.size(), line.find("mtllib") + 7));
    const std::string whole = path_of_name(trimmed(std::string(line)), path_);
    std::error_code error;
    return std::filesystem::is_regular_file(whole, error) ? whole : path_of_name(name, path_);
  }

  const std::string& path_;
  const ReadFile& read_;
  const Lines& lines_;
  WarningList& warnings_;
  std::string last_;
};

/// Takes what the library reads, line by line.
class Reader {
 public:
  Reader(const std::string& path, const std::string& text, const ReadFile& read, WarningList& warnings)
      : path_(path), warnings_(warnings), lines_(path, text), material_files_(path, read, lines_, warnings) {}

  ObjModel read() {
    model_.name = std::filesystem::path(path_).stem().string();
    std::string warning, error;
    tinyobj::LoadObjWithCallback(lines_.stream, callbacks(), this, &material_files_, &warning, &error);
    if (model_.faces.empty()) throw Error(path_ + ": the file has no faces (\"f\")");
    check_indices();
    model_.material_file = material_files_.last();
    return std::move(model_);
  }

 private:
  static Reader& self(void* reader) { return *static_cast<Reader*>(reader); }

  static tinyobj::callback_t callbacks() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* reader, float x, float y, float z, float w) {
      self(reader).add_position({x, y, z});
      self(reader).add_values(w);
    };
    calls.normal_cb = [](void* reader, float x, float y, float z) {
      self(reader).model_.normals.push_back({x, y, z});
    };
    calls.texcoord_cb = [](void* reader, float u, float v, float) {
      self(reader).model_.uvs.push_back({u, v});
    };
    calls.index_cb = [](void* reader, tinyobj::index_t* corners, int count) {
      self(reader).add_face({corners, std::size_t(count)});
    };
    calls.usemtl_cb = [](void* reader, const char* name, int) { self(reader).use_material(name); };
    calls.mtllib_cb = [](void* reader, const tinyobj::material_t* materials, int count) {
      self(reader).take_materials({materials, std::size_t(count)});
    };
    calls.group_cb = [](void* reader, const char** names, int count) {
      self(reader).group_ = fmt::format("{}", fmt::join(names, names + count, " "));
    };
    calls.object_cb = [](void* reader, const char* name) {
      self(reader).object_ = name;
      self(reader).group_.clear();
    };
    return calls;
  }

  [[noreturn]] void fail(const std::string& message) const { throw error_at(lines_.place(), message); }

  void take_materials(std::span<const tinyobj::material_t> materials) {
    model_.materials.assign(materials.begin(), materials.end());
    for (std::size_t i = 0; i < materials.size(); ++i) material_numbers_[trimmed(materials[i].name)] = int(i);
  }

  void use_material(const std::string& name) {
    const auto found = material_numbers_.find(trimmed(name));
    material_ = found == material_numbers_.end() ? -1 : found->second;
    if (material_ < 0 && !trimmed(name).empty())
      warnings_.add([&] { return lines_.place(); },
                    fmt::format("there is no material \"{}\"; it is grey", trimmed(name)));
  }

  void add_position(const Vec3& position) {
    if (!is_finite(position) || max_abs(position) > max_coordinate)
      fail(fmt::format("a coordinate lies beyond +-{:g}", max_coordinate));
    model_.positions.push_back(position);
  }

  /// What stands behind the coordinates: a weight or, which the library does not read, a color of three.
  void add_values(float weight) {
    const std::optional<Rgb> color = vertex_color(lines_.line());
    if (!color && weight != 1) model_.has_weights = true;
    if (!color && model_.colors.empty()) return;
    model_.colors.resize(model_.positions.size(), {1, 1, 1});
    if (color) model_.colors.back() = *color;
  }

  void add_face(std::span<const tinyobj::index_t> corners) {
    if (corners.size() < 3) {
      ++model_.small_faces;
      return;
    }
    if (corners.size() > max_polygon_corners)
      fail(fmt::format("a face of {} corners; {} are the most", corners.size(), max_polygon_corners));
    const auto all = [&](int tinyobj::index_t::*index) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const auto& corner) { return corner.*index != 0; });
    };
    ObjFaces& faces = faces_of(all(&tinyobj::index_t::normal_index), all(&tinyobj::index_t::texcoord_index));
    for (const tinyobj::index_t& corner : corners) {
      ObjCorner read{element(corner.vertex_index, model_.positions.size(), "vertices")};
      if (faces.has_normals) read.normal = element(corner.normal_index, model_.normals.size(), "normals");
      if (faces.has_uvs) read.uv = element(corner.texcoord_index, model_.uvs.size(), "texture coordinates");
      faces.corners.push_back(read);
    }
    faces.sizes.push_back(std::uint32_t(corners.size()));
  }

  ObjFaces& faces_of(bool has_normals, bool has_uvs) {
    const auto [entry, is_new] =
        numbers_.try_emplace({object_, group_, material_, has_normals, has_uvs}, model_.faces.size());
    if (is_new) model_.faces.push_back({object_, group_, material_, has_normals, has_uvs, {}, {}});
    return model_.faces[entry->second];
  }

  /// Indices count from 1; from -1 downwards, from the last element back.
  std::uint32_t element(int index, std::size_t count, const char* what) const {
    if (index > 0) return std::uint32_t(index) - 1;
    if (index == 0 || std::size_t(-std::int64_t(index)) > count)
      fail(fmt::format("there is no element {} among the {} {} so far", index, count, what));
    return std::uint32_t(std::int64_t(count) + index);
  }

  /// Elements may stand behind the faces that use them.
  void check_indices() const {
    const auto check = [&](std::uint32_t index, std::size_t count, const char* what) {
      if (index != no_element && index >= count)
        throw Error(fmt::format("{}: a face has element {} of the {} {}", path_, std::uint64_t(index) + 1,
                                count, what));
    };
    for (const ObjFaces& faces : model_.faces)
      for (const ObjCorner& corner : faces.corners) {
        check(corner.position, model_.positions.size(), "vertices");
        check(corner.normal, model_.normals.size(), "normals");
        check(corner.uv, model_.uvs.size(), "texture coordinates");
      }
  }

  const std::string& path_;
  WarningList& warnings_;
  Lines lines_;
  MaterialFiles material_files_;
  ObjModel model_;
  std::string object_, group_;
  std::map<std::string, int> material_numbers_;  ///< By names without spaces around.
  int material_ = -1;
  std::map<std::tuple<std::string, std::string, int, bool, bool>, std::size_t> numbers_;
};

}  // namespace

ObjModel read_obj(const std::string& path, const ReadFile& read, WarningList& warnings) {
  const std::string text = read(path);
  if (text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe"))
    throw Error(path + ": the file is UTF-16; OBJ files are ASCII or UTF-8");
  return Reader(path, text, read, warnings).read();
}

}  // namespace twinray
