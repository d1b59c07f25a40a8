// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/model_bytes.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "core/error.h"
#include "io/polygon.h"

namespace twinray {
namespace {

/// Calls visit() with each part of what is sent, in an order that both sides keep.
template <typename Material, typename Visit>
void for_each_part_of_material(Material& m, const Visit& visit) {
  visit(m.name);
  for (auto* color : {&m.diffuse, &m.specular, &m.emission}) visit(*color);
  for (auto* number : {&m.shininess, &m.ior, &m.dissolve, &m.roughness, &m.metallic}) visit(*number);
  visit(m.illum);
  for (auto* name : {&m.diffuse_texname, &m.alpha_texname, &m.emissive_texname, &m.normal_texname,
                     &m.metallic_texname, &m.roughness_texname})
    visit(*name);
  for (auto* how : {&m.diffuse_texopt, &m.alpha_texopt, &m.emissive_texopt, &m.normal_texopt,
                    &m.metallic_texopt, &m.roughness_texopt}) {
    visit(how->scale);
    visit(how->contrast);
    visit(how->bump_multiplier);
  }
}

template <typename Faces, typename Visit>
void for_each_part_of_faces(Faces& f, const Visit& visit) {
  visit(f.object);
  visit(f.group);
  visit(f.material);
  visit(f.has_normals);
  visit(f.has_uvs);
  visit(f.corners);
  visit(f.sizes);
}

template <typename Model, typename Visit>
void for_each_part(Model& m, const Visit& visit) {
  visit(m.name);
  visit(m.positions);
  visit(m.normals);
  visit(m.uvs);
  visit(m.faces);
  visit(m.materials);
  visit(m.material_files);
  visit(m.small_faces);
  visit(m.notes);
}

/// Puts parts one behind the other: lists with their lengths before them.
class Writer {
 public:
  template <typename Part>
  void operator()(const Part& part) {
    if constexpr (std::is_same_v<Part, tinyobj::material_t>)
      for_each_part_of_material(part, [this](const auto& p) { (*this)(p); });
    else if constexpr (std::is_same_v<Part, ObjFaces>)
      for_each_part_of_faces(part, [this](const auto& p) { (*this)(p); });
    else if constexpr (std::is_trivially_copyable_v<Part>)
      put(&part, sizeof part);
    else
      put_list(part);
  }
  std::string bytes;

 private:
  void put(const void* from, std::size_t size) { bytes.append(static_cast<const char*>(from), size); }
  template <typename List>
  void put_list(const List& list) {
    (*this)(std::uint64_t(list.size()));
    if constexpr (std::is_trivially_copyable_v<typename List::value_type>)
      put(list.data(), list.size() * sizeof(typename List::value_type));
    else
      for (const auto& item : list) (*this)(item);
  }
};

/// Takes them in the same order.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <typename Part>
  void operator()(Part& part) {
    if constexpr (std::is_same_v<Part, tinyobj::material_t>)
      for_each_part_of_material(part, [this](auto& p) { (*this)(p); });
    else if constexpr (std::is_same_v<Part, ObjFaces>)
      for_each_part_of_faces(part, [this](auto& p) { (*this)(p); });
    else if constexpr (std::is_trivially_copyable_v<Part>)
      take(&part, sizeof part);
    else
      take_list(part);
  }
  bool is_at_end() const { return left_.empty(); }

 private:
  void take(void* to, std::size_t size) {
    if (size > left_.size()) throw Error("the model ends early");
    std::copy_n(left_.data(), size, static_cast<char*>(to));  // Of nothing, `to` may be null.
    left_.remove_prefix(size);
  }
  template <typename List>
  void take_list(List& list) {
    using Item = typename List::value_type;
    std::uint64_t count = 0;
    (*this)(count);
    constexpr std::size_t least = std::is_trivially_copyable_v<Item> ? sizeof(Item) : 8;  // A length.
    if (count > left_.size() / least) throw Error("the model ends early");
    list.resize(std::size_t(count));
    if constexpr (std::is_trivially_copyable_v<Item>)
      take(list.data(), list.size() * sizeof(Item));
    else
      for (Item& item : list) (*this)(item);
  }

  std::string_view left_;
};

bool is_sound(const ObjFaces& faces, const ObjModel& model) {
  std::uint64_t corners = 0;
  for (const std::uint32_t size : faces.sizes) {
    if (size < 3 || size > max_polygon_corners) return false;
    corners += size;
  }
  if (corners != faces.corners.size() || faces.material >= int(model.materials.size())) return false;
  for (const ObjCorner& corner : faces.corners)
    if (corner.position >= model.positions.size() ||
        (faces.has_normals && corner.normal >= model.normals.size()) ||
        (faces.has_uvs && corner.uv >= model.uvs.size()))
      return false;
  return true;
}

}  // namespace

std::string model_bytes(const ObjModel& model) {
  Writer write;
  for_each_part(model, [&](const auto& part) { write(part); });
  return std::move(write.bytes);
}

ObjModel model_of_bytes(std::string_view bytes) {
  ObjModel model;
  Reader read(bytes);
  for_each_part(model, [&](auto& part) { read(part); });
  if (!read.is_at_end()) throw Error("the model is too long");
  if (model.material_files.size() != model.materials.size())
    throw Error("materials of the model are damaged");
  for (const ObjFaces& faces : model.faces)
    if (!is_sound(faces, model)) throw Error("faces of the model are damaged");
  return model;
}

}  // namespace twinray
