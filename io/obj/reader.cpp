// SPDX-License-Identifier: Apache-2.0
#include "io/obj/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <span>
#include <streambuf>
#include <string_view>
#include <tuple>

#include "core/geometry.h"
#include "io/byte_order_mark.h"
#include "io/obj/colors.h"
#include "io/obj/material_text.h"
#include "io/obj/statements.h"
#include "io/obj/text.h"
#include "io/picture_path.h"
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
  /// `text` is the file's with its continued lines joined.
  Lines(const std::string& path, std::string_view file, std::string_view text)
      : path_(path), file_(file), text_(text), buffer_(text), stream(&buffer_) {}
  /// Where the line that was read last begins in the text.
  std::size_t begin() const { return std::size_t(line().data() - text_.data()); }
  Place place() const { return place(begin()); }
  Place place(std::size_t offset) const { return place_of(path_, file_, offset); }
  std::string_view line() const {
    std::size_t end = buffer_.position();
    while (end > 0 && is_line_end(text_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && !is_line_end(text_[begin - 1])) --begin;
    return text_.substr(begin, end - begin);
  }

 private:
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

  const std::string& path_;
  std::string_view file_, text_;
  TextBuffer buffer_;

 public:
  std::istream stream;
};

/// Material files, from the folder of the file that names them.
class MaterialFiles : public tinyobj::MaterialReader {
 public:
  MaterialFiles(const std::string& path, const ReadFile& read, const Lines& lines, WarningList& warnings)
      : path_(path), read_(read), lines_(lines), warnings_(warnings) {}

  /// What the library calls with the first name of a line, and with each of them until one can be read. All
  /// are read the first time.
  bool operator()(const std::string&, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* numbers, std::string*, std::string*) override {
    if (lines_.line().data() != line_) {
      line_ = lines_.line().data();
      for (const std::string& file : paths()) add(file, *materials, *numbers);
    }
    return !materials->empty();
  }
  /// The file of each material.
  std::vector<std::string> files;

 private:
  /// A file that cannot be read is a warning.
  void add(const std::string& file, std::vector<tinyobj::material_t>& materials,
           std::map<std::string, int>& numbers) {
    try {
      const std::string text = material_text(file, std::string(without_mark(read_(file))), warnings_);
      TextBuffer buffer(text);
      std::istream stream(&buffer);
      std::string warning, error;
      tinyobj::LoadMtl(&numbers, &materials, &stream, &warning, &error);
      files.resize(materials.size(), file);
    } catch (const PlacedError&) {
      throw;
    } catch (const Error& error) {
      warnings_.add([&] { return lines_.place(); }, fmt::format("its materials are grey: {}", error.what()));
    }
  }
  /// The library takes a name with spaces for several; most lines have one, as it stands.
  std::vector<std::string> paths() const {
    std::string_view line = lines_.line();
    take_word(line);
    const std::string whole = path_of_name(with_slashes(trimmed(std::string(line))), path_);
    std::error_code error;
    if (std::filesystem::is_regular_file(whole, error)) return {whole};
    std::vector<std::string> names;
    for (std::string_view name; !(name = take_word(line)).empty();)
      names.push_back(path_of_name(with_slashes(std::string(name)), path_));
    return names;
  }

  const std::string& path_;
  const ReadFile& read_;
  const Lines& lines_;
  WarningList& warnings_;
  const char* line_ = nullptr;  ///< The one that was read last.
};

/// Takes what the library reads, line by line.
class Reader {
 public:
  Reader(const std::string& path, std::string_view file, std::string_view text, const ReadFile& read,
         WarningList& warnings)
      : path_(path),
        text_(text),
        warnings_(warnings),
        lines_(path, file, text),
        material_files_(path, read, lines_, warnings) {}

  ObjModel read() {
    model_.name = std::filesystem::path(path_).stem().string();
    std::string warning, error;
    tinyobj::LoadObjWithCallback(lines_.stream, callbacks(), this, &material_files_, &warning, &error);
    if (model_.faces.empty())
      throw Error(path_ + (model_.small_faces == 0 ? ": the file has no faces (\"f\")"
                                                   : ": no face of the file has three corners"));
    check_indices();
    model_.notes = check_obj_statements(
        text_, [&](std::size_t at) { return lines_.place(at); }, warnings_);
    add_painted(text_.size());
    model_.colors = colors_.take(model_.positions.size(), model_.notes);
    model_.material_files = std::move(material_files_.files);
    return std::move(model_);
  }

 private:
  using Corner = std::array<int, 3>;  ///< Vertex, texture coordinates, normal.

  /// How many elements of a kind the faces need so far, and the first line that needs so many; and the first
  /// index that counts back to before the first element (0: there is none), and its line.
  struct Need {
    std::size_t count = 0, line = 0;
    int first_before = 0;
    std::size_t line_before = 0;
  };

  static Reader& self(void* reader) { return *static_cast<Reader*>(reader); }

  static tinyobj::callback_t callbacks() {
    tinyobj::callback_t calls;
    // What the library takes for numbers may be none.
    calls.vertex_cb = [](void* reader, float, float, float, float) { self(reader).add_vertex(); };
    calls.normal_cb = [](void* reader, float, float, float) { self(reader).add_normal(); };
    calls.texcoord_cb = [](void* reader, float, float, float) { self(reader).add_uv(); };
    calls.index_cb = [](void* reader, tinyobj::index_t*, int) { self(reader).add_face(); };
    calls.usemtl_cb = [](void* reader, const char* name, int) { self(reader).use_material(name); };
    calls.mtllib_cb = [](void* reader, const tinyobj::material_t* materials, int count) {
      self(reader).take_materials({materials, std::size_t(count)});
    };
    calls.group_cb = [](void* reader, const char** names, int count) {
      self(reader).end_group(self(reader).lines_.begin());
      self(reader).group_ = fmt::format("{}", fmt::join(names, names + count, " "));
    };
    calls.object_cb = [](void* reader, const char* name) {
      self(reader).object_ = name;
      self(reader).group_.clear();
    };
    return calls;
  }

  void warn(const std::string& message) {
    warnings_.add([&] { return lines_.place(); }, message);
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
      warn(fmt::format("there is no material \"{}\"; it is grey", trimmed(name)));
  }

  void add_vertex() {
    const std::string_view line = lines_.line();
    add_painted(lines_.begin());
    const ObjNumbers numbers = read_numbers(line);
    if (numbers.count < 3 && !numbers.end.empty())
      fail(fmt::format("a coordinate that is no number: \"{}\"", numbers.end));
    if (numbers.count < 3) fail(fmt::format("a vertex of {} coordinates; valid are 3", numbers.count));
    const Vec3 position{numbers.values[0], numbers.values[1], numbers.values[2]};
    if (!(max_abs(position) <= max_coordinate))
      fail(fmt::format("a coordinate lies beyond +-{:g}", max_coordinate));
    model_.positions.push_back(position);
    const bool has_color = colors_.add_vertex(model_.positions.size() - 1, numbers);
    if (!has_color && numbers.count > 3 && numbers.values[3] != 1) model_.has_weights = true;
  }

  /// Takes the lines of ZBrush's colors, which are comments, up to a place in the text.
  void add_painted(std::size_t end) {
    for (; painted_ < end; painted_ = text_.find(painted_mark, painted_ + 1)) {
      const bool is_line = painted_ == 0 || text_[painted_ - 1] == '\n' || text_[painted_ - 1] == '\r';
      if (is_line)
        colors_.add_painted(text_.substr(painted_, text_.find_first_of("\r\n", painted_) - painted_));
    }
  }

  void add_normal() {
    const ObjNumbers numbers = read_numbers(lines_.line());
    const bool is_normal = numbers.count >= 3;
    if (!is_normal) warn("a normal that is not three numbers: those of its triangles stand for it");
    model_.normals.push_back(is_normal ? Vec3{numbers.values[0], numbers.values[1], numbers.values[2]}
                                       : Vec3{});
  }

  void add_uv() {
    const ObjNumbers numbers = read_numbers(lines_.line());
    if (numbers.count == 0 || (numbers.count == 1 && !numbers.end.empty()))
      warn("texture coordinates that are no numbers: 0 stands for each");
    model_.uvs.push_back({numbers.values[0], numbers.values[1]});
  }

  /// "3", "3/1", "3//2" or "3/1/2": of the vertex, its texture coordinates and its normal; 0 stands for one
  /// that is left out, as in "3/", "3//" or "3/1/".
  Corner corner_of(std::string_view word) const {
    Corner corner{};
    const char *at = word.data(), *const end = at + word.size();
    for (std::size_t part = 0; part < corner.size(); ++part) {
      const bool is_left_out = part > 0 && (at == end || *at == '/');
      if (!is_left_out) {
        const auto [stop, error] = std::from_chars(at, end, corner[part]);
        if (error != std::errc{} || corner[part] == 0) break;
        at = stop;
      }
      if (at == end) return corner;
      if (*at++ != '/') break;
    }
    fail(
        fmt::format("\"{}\" is no corner of a face; valid are V, V/T, V//N and V/T/N, whole numbers from 1 "
                    "or, from the last one back, -1",
                    word));
  }

  void add_face() {
    corners_.clear();
    std::string_view line = lines_.line();
    take_word(line);
    for (std::string_view word; !(word = take_word(line)).empty();) corners_.push_back(corner_of(word));
    if (corners_.size() < 3) {
      ++model_.small_faces;
      return;
    }
    if (corners_.size() > max_polygon_corners)
      fail(fmt::format("a face of {} corners; {} are the most", corners_.size(), max_polygon_corners));
    const auto all = [&](std::size_t part) {
      return std::all_of(corners_.begin(), corners_.end(),
                         [&](const Corner& corner) { return corner[part] != 0; });
    };
    const std::size_t begin = lines_.begin();
    end_group(begin);
    ObjFaces& faces = faces_of(all(2), all(1));
    for (const auto& [vertex, uv, normal] : corners_) {
      if (vertex < 0 && std::size_t(-std::int64_t(vertex)) > model_.positions.size())
        fail(fmt::format("there is no element {} among the {} vertices so far", vertex,
                         model_.positions.size()));
      ObjCorner read{element(vertex, model_.positions.size(), begin, positions_)};
      if (faces.has_normals) read.normal = element(normal, model_.normals.size(), begin, normals_);
      if (faces.has_uvs) read.uv = element(uv, model_.uvs.size(), begin, uvs_);
      faces.corners.push_back(read);
    }
    faces.sizes.push_back(std::uint32_t(corners_.size()));
  }

  /// A line of "g" alone, which the library reads over, before that which begins here ends the group.
  void end_group(std::size_t begin) {
    for (; group_end_ < begin; group_end_ = bare_group(group_end_)) group_.clear();
  }
  /// Where the next such line begins.
  std::size_t bare_group(std::size_t from) const {
    for (std::size_t at = text_.find("\ng", from); at != text_.npos; at = text_.find("\ng", at + 1)) {
      const std::size_t rest = text_.find_first_not_of(" \t", at + 2);
      if (rest == text_.npos || text_[rest] == '\n' || text_[rest] == '\r') return at + 1;
    }
    return text_.npos;
  }

  ObjFaces& faces_of(bool has_normals, bool has_uvs) {
    const auto [entry, is_new] =
        numbers_.try_emplace({object_, group_, material_, has_normals, has_uvs}, model_.faces.size());
    if (is_new) model_.faces.push_back({object_, group_, material_, has_normals, has_uvs, {}, {}});
    return model_.faces[entry->second];
  }

  /// Indices count from 1; from -1 downwards, from the last of `count` elements back. Others may have
  /// elements that follow: what there is not is found at the end.
  static std::uint32_t element(int index, std::size_t count, std::size_t line, Need& need) {
    const std::int64_t place = index < 0 ? std::int64_t(count) + index : std::int64_t(index) - 1;
    if (place < 0) {
      if (need.first_before == 0) need.first_before = index, need.line_before = line;
      return no_element;
    }
    if (std::size_t(place) >= need.count) need.count = std::size_t(place) + 1, need.line = line;
    return std::uint32_t(place);
  }

  void check_indices() {
    if (positions_.count > model_.positions.size())
      throw error_at(lines_.place(positions_.line),
                     no_such(std::int64_t(positions_.count), model_.positions.size(), "vertices"));
    replace_missing(&ObjCorner::normal, &ObjFaces::has_normals, normals_, model_.normals,
                    "normals: those of the triangles stand for them");
    replace_missing(&ObjCorner::uv, &ObjFaces::has_uvs, uvs_, model_.uvs,
                    "texture coordinates: 0 stands for them");
  }
  static std::string no_such(std::int64_t index, std::size_t count, const char* what) {
    return fmt::format("there is no element {} among the {} {}", index, count, what);
  }
  /// Gives corners whose element there is not one of zeros, with a warning for the first such index that
  /// counts back, and for the largest one.
  template <typename Element>
  void replace_missing(std::uint32_t ObjCorner::*part, bool ObjFaces::*is_asked, const Need& need,
                       std::vector<Element>& elements, const char* what) {
    const std::size_t count = elements.size();
    if (need.first_before == 0 && need.count <= count) return;
    const auto warn_of = [&](std::int64_t index, std::size_t line) {
      warnings_.add([&] { return lines_.place(line); }, no_such(index, count, what));
    };
    if (need.first_before != 0) warn_of(need.first_before, need.line_before);
    if (need.count > count) warn_of(std::int64_t(need.count), need.line);
    elements.push_back({});
    for (ObjFaces& faces : model_.faces)
      if (faces.*is_asked)
        for (ObjCorner& corner : faces.corners) corner.*part = std::min(corner.*part, std::uint32_t(count));
  }

  static constexpr std::string_view painted_mark = "#MRGB ";

  const std::string& path_;
  std::string_view text_;
  WarningList& warnings_;
  Lines lines_;
  MaterialFiles material_files_;
  ObjModel model_;
  ObjColors colors_;
  std::size_t painted_ = text_.find(painted_mark);  ///< Where ZBrush's next colors are.
  std::vector<Corner> corners_;                     ///< Of the last face.
  Need positions_, normals_, uvs_;
  std::string object_, group_;
  std::size_t group_end_ = bare_group(0);
  std::map<std::string, int> material_numbers_;  ///< By names without spaces around.
  int material_ = -1;
  std::map<std::tuple<std::string, std::string, int, bool, bool>, std::size_t> numbers_;
};

}  // namespace

ObjModel read_obj(const std::string& path, const ReadFile& read, WarningList& warnings) {
  const std::string text(without_mark(read(path)));
  if (text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe"))
    throw Error(path + ": the file is UTF-16; OBJ files are ASCII or UTF-8");
  if (!has_continued_lines(text)) return Reader(path, text, text, read, warnings).read();
  return Reader(path, text, joined_lines(text), read, warnings).read();
}

}  // namespace twinray
