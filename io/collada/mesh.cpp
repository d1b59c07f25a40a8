// SPDX-License-Identifier: Apache-2.0
// The primitive elements of a <mesh>. Their <p> lists hold, for each corner, one index for each offset that
// the inputs name; several inputs may share an offset.
#include "io/collada/mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/collada/source.h"
#include "io/polygon.h"
#include "io/used_elements.h"

namespace twinray {
namespace {

/// A semantic that is used, where its index stands among those of a corner, and what it points into.
struct Input {
  XmlElement source;
  std::size_t offset = 0;
  std::shared_ptr<const SourceValues> values;
};

/// Texture coordinates, and the corners that were read so far.
struct UvInput {
  Input input;
  ColladaUvs uvs;
};

struct Inputs {
  std::size_t stride = 1;  ///< Indices of a corner.
  std::optional<Input> position, normal;
  std::vector<UvInput> uvs;
};

constexpr std::size_t width_of(std::string_view semantic) { return semantic == "TEXCOORD" ? 2 : 3; }

/// The elements of a source as vectors, by their index.
auto vectors(const SourceValues& source) {
  return [&source](std::size_t i) { return source.vec3(i); };
}

auto pairs(const SourceValues& source) {
  return [&source](std::size_t i) { return Vec2{source.values[2 * i], source.values[2 * i + 1]}; };
}

std::string what_is_wrong(std::uint32_t index, const Input& input) {
  if (index < input.values->count())
    return fmt::format("the index {} leads to a number of <source id=\"{}\"> that is not finite", index,
                       input.source.attribute("id").value_or(""));
  return fmt::format("the index {} is out of range: <source id=\"{}\"> has {} elements, numbered from 0",
                     index, input.source.attribute("id").value_or(""), input.values->count());
}

/// The corners that <triangles> count; 0 for other elements.
std::size_t triangle_corners(const XmlElement& element) {
  return element.is("triangles") ? std::size_t(3) * element.index_attribute("count", 0) : 0;
}

class PartReader {
 public:
  PartReader(const XmlElement& element, const std::string& name, ColladaDocument& document,
             ColladaSources& sources)
      : document_(document), sources_(sources), part_{element, element.attribute("material").value_or("")} {
    part_.mesh.name = name;
  }

  ColladaPart read() {
    read_inputs();
    if (part_.element.is("polylist"))
      read_polylist();
    else
      for (const XmlElement& child : part_.element.children()) {
        if (child.is("p")) read_p(child);
        if (child.is("ph")) read_ph(child);
      }
    check_count();
    copy_values();
    return std::move(part_);
  }

 private:
  void read_inputs();
  XmlElement find_vertices(const XmlElement& input);
  void add_vertices(const XmlElement& vertices, std::size_t offset);
  void add_input(const XmlElement& input, const std::string& semantic, std::size_t offset);
  void copy_values();

  std::size_t offset_of(const XmlElement& input, std::size_t inputs);
  void read_polylist();
  void read_p(const XmlElement& p);
  void read_ph(const XmlElement& ph);
  std::vector<std::uint32_t> read_indices(const XmlElement& p, std::size_t corners = 0);
  void fit_stride(std::size_t indices, std::size_t corners);
  void check_indices(const XmlElement& p, const std::vector<std::uint32_t>& indices);
  std::optional<std::size_t> find_wrong(const XmlElement& p, const std::vector<std::uint32_t>& indices,
                                        const Input& input);
  void check_count() const;

  void add_polygon(std::span<const std::uint32_t> indices, std::span<const std::size_t> hole_starts = {});
  void add_reduced(std::span<const std::uint32_t> indices);
  void add_triangle(const std::uint32_t* a, const std::uint32_t* b, const std::uint32_t* c);
  void reserve_triangles(std::size_t more);

  ColladaDocument& document_;
  ColladaSources& sources_;
  ColladaPart part_;
  Inputs inputs_;
  std::size_t polygons_ = 0;
};

std::size_t PartReader::offset_of(const XmlElement& input, std::size_t inputs) {
  constexpr std::size_t most_offsets = 64;
  if (inputs == 1 && !input.attribute("offset")) {
    document_.warn(input,
                   "this <input> has no offset, which it needs; as the only one it is taken to have 0");
    return 0;
  }
  const std::size_t offset = input.required_index_attribute("offset");
  if (offset >= most_offsets)
    throw error_at(input.attribute_place("offset"),
                   fmt::format("offset {} is out of range; it must be below {}", offset, most_offsets));
  return offset;
}

void PartReader::read_inputs() {
  std::optional<XmlElement> vertices;
  std::size_t vertex_offset = 0;
  const auto inputs = part_.element.children("input");
  for (const XmlElement& input : inputs) {
    const std::string semantic = input.required_attribute("semantic");
    const std::size_t offset = offset_of(input, inputs.size());
    inputs_.stride = std::max(inputs_.stride, offset + 1);
    if (semantic == "VERTEX") {
      vertices = find_vertices(input);
      vertex_offset = offset;
    } else {
      add_input(input, semantic, offset);
    }
  }
  if (!vertices)
    part_.element.fail(
        fmt::format("<{}> has no <input semantic=\"VERTEX\">, which it needs", part_.element.name()));
  add_vertices(*vertices, vertex_offset);
}

/// Those that the input names; where there are none, with a warning, the mesh's only ones.
XmlElement PartReader::find_vertices(const XmlElement& input) {
  const auto own = part_.element.parent()->children("vertices");
  const std::string url = input.required_attribute("source");
  try {
    return document_.resolve(input, "source", "vertices");
  } catch (const PlacedError&) {
    if (own.size() != 1 || url[0] != '#') throw;
  }
  document_.warn([&] { return input.attribute_place("source"); },
                 fmt::format("no <vertices> is \"{}\"; this <input> is taken to mean the only ones of its "
                             "<{}>",
                             url, part_.element.parent()->name()));
  return own[0];
}

void PartReader::add_vertices(const XmlElement& vertices, std::size_t offset) {
  for (const XmlElement& input : vertices.children("input"))
    add_input(input, input.required_attribute("semantic"), offset);
  if (!inputs_.position) vertices.fail("<vertices> has no <input semantic=\"POSITION\">, which it needs");
}

void PartReader::add_input(const XmlElement& input, const std::string& semantic, std::size_t offset) {
  static constexpr std::string_view known[] = {"POSITION", "NORMAL", "TEXCOORD", "VERTEX"};
  static constexpr std::string_view unused[] = {"TANGENT", "BINORMAL", "TEXTANGENT", "TEXBINORMAL", "UV"};
  const auto read = [&] {
    const XmlElement source = document_.resolve(input, "source", "source");
    return Input{source, offset, sources_.get(source, width_of(semantic))};
  };
  if (semantic == "TEXCOORD") {
    inputs_.uvs.push_back({read(), {.set = input.index_attribute("set", 0)}});
    return;
  }
  std::optional<Input>* slot = semantic == "POSITION" ? &inputs_.position
                               : semantic == "NORMAL" ? &inputs_.normal
                                                      : nullptr;
  if (slot && !*slot) *slot = read();
  if (semantic == "COLOR")
    return document_.warn(input, "vertex colors are not rendered; the surface has its material's color");
  if (slot || std::find(std::begin(unused), std::end(unused), semantic) != std::end(unused)) return;
  const std::string nearest = nearest_name(semantic, known);
  document_.warn([&] { return input.attribute_place("semantic"); },
                 fmt::format("the semantic \"{}\" is not known, and is left out{}", semantic,
                             nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

/// Normals and texture coordinates that proved wrong on the way have left their indices behind.
void PartReader::copy_values() {
  Mesh& mesh = part_.mesh;
  const SourceValues& positions = *inputs_.position->values;
  if (part_.reduced.empty())
    part_.vertices = take_used(positions.count(), vectors(positions), mesh.triangles, mesh.positions);
  else
    for (std::size_t i = 0; i < positions.count(); ++i) mesh.positions.push_back(vectors(positions)(i));
  if (inputs_.normal)
    take_used(inputs_.normal->values->count(), vectors(*inputs_.normal->values), mesh.normal_indices,
              mesh.normals);
  else
    mesh.normal_indices.clear();
  for (UvInput& each : inputs_.uvs) {
    const SourceValues& values = *each.input.values;
    take_used(values.count(), pairs(values), each.uvs.indices, each.uvs.uvs);
    part_.more_uvs.push_back(std::move(each.uvs));
  }
  if (part_.more_uvs.empty()) return;
  ColladaUvs& first = part_.more_uvs.front();
  part_.uv_set = first.set;
  mesh.uvs = std::move(first.uvs);
  mesh.uv_indices = std::move(first.indices);
  part_.more_uvs.erase(part_.more_uvs.begin());
}

/// Surfaces do without normals and texture coordinates, but not without positions.
void PartReader::check_indices(const XmlElement& p, const std::vector<std::uint32_t>& indices) {
  if (const auto at = find_wrong(p, indices, *inputs_.position))
    throw error_at(p.number_place(*at), what_is_wrong(indices[*at], *inputs_.position));
  const auto is_wrong = [&](const Input& input, const char* what) {
    const auto at = find_wrong(p, indices, input);
    if (at)
      document_.warn([&] { return p.number_place(*at); },
                     fmt::format("{}; the {} of this <{}> are left out", what_is_wrong(indices[*at], input),
                                 what, part_.element.name()));
    return at.has_value();
  };
  if (inputs_.normal && is_wrong(*inputs_.normal, "normals")) inputs_.normal.reset();
  std::erase_if(inputs_.uvs, [&](const UvInput& uv) { return is_wrong(uv.input, "texture coordinates"); });
}

/// Where the first index beyond an input's data stands. One within it that its accessor does not count is
/// used, with a warning.
std::optional<std::size_t> PartReader::find_wrong(const XmlElement& p,
                                                  const std::vector<std::uint32_t>& indices,
                                                  const Input& input) {
  const SourceValues& values = *input.values;
  for (std::size_t i = input.offset; i < indices.size(); i += inputs_.stride) {
    if (indices[i] >= values.count() || !values.is_finite(indices[i])) return i;
    if (indices[i] < values.stated) continue;
    document_.warn(
        [&] { return p.number_place(i); },
        fmt::format("an index beyond the {} elements that <source id=\"{}\"> counts; its array has {}, "
                    "and these are used",
                    values.stated, input.source.attribute("id").value_or(""), values.count()));
  }
  return std::nullopt;
}

/// Where a list has too few indices for its inputs, and just as many for those of the first offsets, the
/// inputs beyond are left out: they have no data.
void PartReader::fit_stride(std::size_t indices, std::size_t corners) {
  if (corners == 0 || indices % corners != 0) return;
  if (part_.element.is("triangles") && indices % (3 * inputs_.stride) == 0)
    return;  // only the count is wrong
  const std::size_t stride = indices / corners;
  if (stride == 0 || stride >= inputs_.stride || inputs_.position->offset >= stride) return;
  document_.warn(
      part_.element,
      fmt::format("inputs have offsets up to {}, and <p> has {} for each corner; those beyond are left out",
                  inputs_.stride - 1, stride));
  inputs_.stride = stride;
  if (inputs_.normal && inputs_.normal->offset >= stride) inputs_.normal.reset();
  std::erase_if(inputs_.uvs, [&](const UvInput& uv) { return uv.input.offset >= stride; });
}

/// `corners` is how many there should be; 0 where nothing says so.
std::vector<std::uint32_t> PartReader::read_indices(const XmlElement& p, std::size_t corners) {
  std::vector<std::uint32_t> indices = p.indices();
  fit_stride(indices.size(), corners);
  if (indices.size() % inputs_.stride != 0)
    p.fail(fmt::format("<p> has {} indices; with {} for each corner, their number must be a multiple of {}",
                       indices.size(), inputs_.stride, inputs_.stride));
  check_indices(p, indices);
  return indices;
}

void PartReader::read_polylist() {
  const auto vcount = part_.element.child("vcount");
  const auto p = part_.element.child("p");
  if (!vcount && !p && part_.element.index_attribute("count", 0) == 0) return;
  const auto counts = part_.element.required_child("vcount").indices();
  std::size_t corners = 0;
  for (const std::uint32_t count : counts) corners += count;
  const auto indices = read_indices(part_.element.required_child("p"), corners);
  const std::size_t all = indices.size() / inputs_.stride;
  reserve_triangles(all - std::min(all, 2 * counts.size()));
  std::size_t begin = 0;
  for (const std::uint32_t count : counts) {
    const std::size_t length = count * inputs_.stride;
    if (length > indices.size() - begin) break;
    add_polygon(std::span(indices).subspan(begin, length));
    begin += length;
  }
  if (corners * inputs_.stride != indices.size())
    p->fail(fmt::format("<vcount> asks for {} corners of {} indices, and <p> has {} indices", corners,
                        inputs_.stride, indices.size()));
}

void PartReader::read_p(const XmlElement& p) {
  const auto indices = read_indices(p, triangle_corners(part_.element));
  const std::size_t stride = inputs_.stride, corners = indices.size() / stride;
  const auto at = [&](std::size_t corner) { return indices.data() + corner * stride; };
  if (part_.element.is("polygons")) return add_polygon(indices);
  if (part_.element.is("triangles")) {
    if (corners % 3 != 0)
      p.fail(fmt::format("<p> has {} corners; that of <triangles> needs a multiple of 3", corners));
    reserve_triangles(corners / 3);
    for (std::size_t i = 0; i + 2 < corners; i += 3) add_triangle(at(i), at(i + 1), at(i + 2));
    polygons_ += corners / 3;
    return;
  }
  const bool is_fan = part_.element.is("trifans");
  for (std::size_t i = 2; i < corners; ++i) {
    if (is_fan)
      add_triangle(at(0), at(i - 1), at(i));
    else
      add_triangle(at(i - 2), at(i % 2 == 0 ? i - 1 : i), at(i % 2 == 0 ? i : i - 1));
  }
  ++polygons_;
}

/// A polygon with holes: <p> is its outline, each <h> a hole, all of them lists of corners.
void PartReader::read_ph(const XmlElement& ph) {
  std::vector<std::uint32_t> indices = read_indices(ph.required_child("p"));
  std::vector<std::size_t> hole_starts;
  for (const XmlElement& h : ph.children("h")) {
    const auto hole = read_indices(h);
    if (hole.size() < 3 * inputs_.stride) {
      document_.warn(h, "a hole has fewer than 3 corners, and is left out");
      continue;
    }
    hole_starts.push_back(indices.size() / inputs_.stride);
    indices.insert(indices.end(), hole.begin(), hole.end());
  }
  add_polygon(indices, hole_starts);
}

void PartReader::check_count() const {
  const std::string name = part_.element.name();
  if (!part_.element.attribute("count"))
    return document_.warn(part_.element,
                          fmt::format("this <{}> has no count, which it needs; all of it is read", name));
  const std::size_t count = part_.element.required_index_attribute("count");
  if (count != polygons_)
    document_.warn([&] { return part_.element.attribute_place("count"); },
                   fmt::format("count says {}, and <{}> has {}; all of it is read", count, name, polygons_));
}

void PartReader::add_polygon(std::span<const std::uint32_t> indices,
                             std::span<const std::size_t> hole_starts) {
  ++polygons_;
  const std::size_t corners = indices.size() / inputs_.stride,
                    outline = hole_starts.empty() ? corners : hole_starts[0];
  const auto at = [&](std::size_t corner) { return indices.data() + corner * inputs_.stride; };
  if (corners == 3) return add_triangle(at(0), at(1), at(2));
  if (outline < 3)
    return document_.warn(part_.element, "a polygon has fewer than 3 corners, and is left out");
  if (corners > max_polygon_corners)
    part_.element.fail(fmt::format("polygon {} has {} corners; the most that is read is {}", polygons_ - 1,
                                   corners, max_polygon_corners));
  if (document_.options().interpretation == Interpretation::cs184 && part_.element.is("polylist"))
    return add_reduced(indices);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < corners; ++i)
    points.push_back(vectors(*inputs_.position->values)(at(i)[inputs_.position->offset]));
  for (const auto& [a, b, c] : triangulate(points, hole_starts)) add_triangle(at(a), at(b), at(c));
}

void PartReader::add_reduced(std::span<const std::uint32_t> indices) {
  ReducedPolygon polygon{part_.mesh.triangles.size(), {}};
  for (std::size_t i = inputs_.position->offset; i < indices.size(); i += inputs_.stride)
    polygon.corners.push_back(indices[i]);
  part_.reduced.push_back(std::move(polygon));
  const std::uint32_t* first = indices.data();
  add_triangle(first + indices.size() - inputs_.stride, first, first + inputs_.stride);
  document_.warn(
      part_.element,
      "of a polygon of more than 3 corners CS184's program keeps the triangle of its last, first and "
      "second corner; so do we here");
}

void PartReader::add_triangle(const std::uint32_t* a, const std::uint32_t* b, const std::uint32_t* c) {
  const auto add = [&](const Input& input, std::vector<Triangle>& to) {
    to.push_back({a[input.offset], b[input.offset], c[input.offset]});
  };
  add(*inputs_.position, part_.mesh.triangles);
  if (inputs_.normal) add(*inputs_.normal, part_.mesh.normal_indices);
  for (UvInput& uv : inputs_.uvs) add(uv.input, uv.uvs.indices);
}

void PartReader::reserve_triangles(std::size_t more) {
  const auto reserve = [&](std::vector<Triangle>& triangles) { triangles.reserve(triangles.size() + more); };
  reserve(part_.mesh.triangles);
  if (inputs_.normal) reserve(part_.mesh.normal_indices);
  for (UvInput& uv : inputs_.uvs) reserve(uv.uvs.indices);
}

}  // namespace

ColladaPart read_part(const XmlElement& element, const std::string& name, ColladaDocument& document,
                      ColladaSources& sources) {
  return PartReader(element, name, document, sources).read();
}

}  // namespace twinray
