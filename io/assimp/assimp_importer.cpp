// SPDX-License-Identifier: Apache-2.0
// The one door to Assimp, in a library of its own (io/assimp/import_function.h).
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <strings.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "core/geometry.h"
#include "io/assimp/import_function.h"
#include "io/polygon.h"

namespace twinray {
namespace {

constexpr std::size_t most_corners = std::size_t(1) << 29;
constexpr int deepest_node = 100;

void set(tinyobj::real_t (&to)[3], const aiColor3D& color) {
  to[0] = color.r;
  to[1] = color.g;
  to[2] = color.b;
}

/// A picture beside the file; those within it are counted.
std::string picture_of(const aiMaterial& material, aiTextureType type, std::size_t& embedded) {
  aiString name;
  if (material.GetTexture(type, 0, &name) != aiReturn_SUCCESS || name.length == 0) return "";
  if (name.C_Str()[0] != '*') return name.C_Str();
  ++embedded;
  return "";
}

/// The same, by the first of two kinds that has one.
std::string picture_of(const aiMaterial& material, aiTextureType first, aiTextureType second,
                       std::size_t& embedded) {
  const bool has_first = material.GetTextureCount(first) > 0;
  return picture_of(material, has_first ? first : second, embedded);
}

/// Pictures that are left out, as a note calls them.
struct LeftOut {
  aiTextureType type;
  const char* name;
};
constexpr LeftOut left_out[] = {{aiTextureType_SPECULAR, "pictures of specular colors"},
                                {aiTextureType_SHININESS, "pictures of gloss"},
                                {aiTextureType_HEIGHT, "bump maps"},
                                {aiTextureType_DISPLACEMENT, "displacement maps"},
                                {aiTextureType_REFLECTION, "pictures of reflections"},
                                {aiTextureType_SHEEN, "pictures of sheen"},
                                {aiTextureType_CLEARCOAT, "pictures of coats"},
                                {aiTextureType_TRANSMISSION, "pictures of transmission"}};

/// As MTL says it, whose values most formats share.
tinyobj::material_t material_of(const aiMaterial& from, std::size_t& embedded) {
  tinyobj::material_t to{};
  aiString name;
  if (from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) to.name = name.C_Str();
  to.diffuse_texname = picture_of(from, aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR, embedded);
  aiColor3D color;
  const float usual = to.diffuse_texname.empty() ? 0.5f : 1;
  set(to.diffuse,
      from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS ? color : aiColor3D(usual, usual, usual));
  if (from.Get(AI_MATKEY_BASE_COLOR, color) == aiReturn_SUCCESS) set(to.diffuse, color);
  if (from.Get(AI_MATKEY_COLOR_SPECULAR, color) == aiReturn_SUCCESS) set(to.specular, color);
  if (from.Get(AI_MATKEY_COLOR_EMISSIVE, color) == aiReturn_SUCCESS) set(to.emission, color);
  to.dissolve = 1;
  to.ior = 1;
  from.Get(AI_MATKEY_OPACITY, to.dissolve);
  from.Get(AI_MATKEY_SHININESS, to.shininess);
  from.Get(AI_MATKEY_METALLIC_FACTOR, to.metallic);
  from.Get(AI_MATKEY_ROUGHNESS_FACTOR, to.roughness);
  to.illum = to.shininess > 0 ? 2 : 1;
  for (tinyobj::texture_option_t* const how : {&to.diffuse_texopt, &to.alpha_texopt, &to.emissive_texopt,
                                               &to.normal_texopt, &to.metallic_texopt, &to.roughness_texopt})
    how->scale[0] = how->scale[1] = how->contrast = how->bump_multiplier = 1;
  to.alpha_texname = picture_of(from, aiTextureType_OPACITY, embedded);
  to.emissive_texname = picture_of(from, aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR, embedded);
  to.normal_texname = picture_of(from, aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA, embedded);
  to.metallic_texname = picture_of(from, aiTextureType_METALNESS, embedded);
  to.roughness_texname = picture_of(from, aiTextureType_DIFFUSE_ROUGHNESS, embedded);
  return to;
}

/// Copies the meshes of the nodes into the world.
class Walk {
 public:
  Walk(const aiScene& scene, ObjModel& model) : scene_(scene), model_(model) {}

  void add(const aiNode& node, const aiMatrix4x4& above, int depth) {
    if (depth > deepest_node)
      throw Error(fmt::format("nodes stand in each other more than {} deep", deepest_node));
    const aiMatrix4x4 to_world = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      if (node.mMeshes[i] < scene_.mNumMeshes) add(*scene_.mMeshes[node.mMeshes[i]], node, to_world);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], to_world, depth + 1);
  }

  /// Meshes whose vertices have colours.
  std::size_t painted() const { return painted_; }

 private:
  void add(const aiMesh& mesh, const aiNode& node, const aiMatrix4x4& to_world) {
    ObjFaces faces{node.mName.C_Str(), mesh.mName.C_Str(), int(mesh.mMaterialIndex)};
    if (mesh.mMaterialIndex >= scene_.mNumMaterials) faces.material = -1;
    faces.has_normals = mesh.HasNormals();
    faces.has_uvs = mesh.HasTextureCoords(0);
    const std::uint32_t first = std::uint32_t(model_.positions.size());
    const std::uint32_t first_normal = std::uint32_t(model_.normals.size());
    const std::uint32_t first_uv = std::uint32_t(model_.uvs.size());
    add_vertices(mesh, to_world);
    painted_ += mesh.HasVertexColors(0);
    const bool mirrors = to_world.Determinant() < 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (!is_polygon(face)) continue;
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        const std::uint32_t index = face.mIndices[mirrors ? face.mNumIndices - 1 - k : k];
        if (index >= mesh.mNumVertices)
          throw Error(fmt::format("a face has vertex {} of the {} of \"{}\"", index, mesh.mNumVertices,
                                  mesh.mName.C_Str()));
        faces.corners.push_back({first + index, faces.has_normals ? first_normal + index : no_element,
                                 faces.has_uvs ? first_uv + index : no_element});
      }
      faces.sizes.push_back(face.mNumIndices);
    }
    if (!faces.sizes.empty()) model_.faces.push_back(std::move(faces));
  }

  bool is_polygon(const aiFace& face) {
    if (face.mNumIndices > max_polygon_corners)
      throw Error(
          fmt::format("a face of {} corners; {} are the most", face.mNumIndices, max_polygon_corners));
    if (face.mNumIndices < 3) ++model_.small_faces;
    if ((corners_ += face.mNumIndices) > most_corners)
      throw Error(fmt::format("the scene has more than {} corners of faces", most_corners));
    return face.mNumIndices >= 3;
  }

  void add_vertices(const aiMesh& mesh, const aiMatrix4x4& to_world) {
    const aiMatrix3x3 to_world_normal = aiMatrix3x3(aiMatrix4x4(to_world).Inverse().Transpose());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D p = to_world * mesh.mVertices[i];
      const Vec3 position{p.x, p.y, p.z};
      if (!is_finite(position) || max_abs(position) > max_coordinate)
        throw Error(
            fmt::format("a coordinate of \"{}\" lies beyond +-{:g}", mesh.mName.C_Str(), max_coordinate));
      model_.positions.push_back(position);
      if (mesh.HasNormals()) {
        const aiVector3D n = to_world_normal * mesh.mNormals[i];
        model_.normals.push_back({n.x, n.y, n.z});
      }
      if (mesh.HasTextureCoords(0))
        model_.uvs.push_back({mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y});
    }
  }

  const aiScene& scene_;
  ObjModel& model_;
  std::size_t corners_ = 0, painted_ = 0;
};

void add_note(ObjModel& model, std::size_t count, const char* what) {
  if (count > 0) model.notes.push_back(fmt::format("{} of the file, left out: {}", what, count));
}

/// Assimp calls a file in memory by a name of its own.
std::string said(std::string text) {
  constexpr std::string_view own = "$$$___magic___$$$.";
  if (const std::size_t at = text.find(own); at != text.npos) text.replace(at, own.size(), "*");
  return text;
}

/// Assimp keeps what it caught as a text.
[[noreturn]] void fail(const std::string& reason) {
  if (reason == "std::bad_alloc") throw std::bad_alloc();
  throw Error(said(reason));
}

ObjModel import_model(const ImportedFile& file) {
  const std::filesystem::path path(file.path);
  if (file.bytes.empty()) throw Error("the file is empty");
  Assimp::Importer importer;
  // Pictures that are projected, or placed, get texture coordinates that say so.
  constexpr unsigned made = aiProcess_GenUVCoords | aiProcess_TransformUVCoords;
  const aiScene* const scene = importer.ReadFileFromMemory(file.bytes.data(), file.bytes.size(), made,
                                                           path.extension().string().c_str());
  if (!scene || !scene->mRootNode) fail(importer.GetErrorString());
  ObjModel model;
  model.name = path.stem().string();
  std::size_t embedded = 0;
  for (unsigned i = 0; i < scene->mNumMaterials; ++i)
    model.materials.push_back(material_of(*scene->mMaterials[i], embedded));
  if (strcasecmp(path.extension().c_str(), ".fbx") == 0)  // There a picture takes the color's place.
    for (tinyobj::material_t& material : model.materials)
      if (!material.diffuse_texname.empty()) set(material.diffuse, aiColor3D(1, 1, 1));
  model.material_files.assign(model.materials.size(), file.path);
  Walk walk(*scene, model);
  walk.add(*scene->mRootNode, aiMatrix4x4(), 0);
  if (model.faces.empty()) throw Error("the file has no faces");
  add_note(model, scene->mNumCameras, "cameras");
  add_note(model, scene->mNumLights, "lights");
  add_note(model, scene->mNumAnimations, "animations");
  add_note(model, embedded, "pictures within it");
  for (const LeftOut& kind : left_out)
    add_note(model,
             std::size_t(std::count_if(
                 scene->mMaterials, scene->mMaterials + scene->mNumMaterials,
                 [&](const aiMaterial* material) { return material->GetTextureCount(kind.type) > 0; })),
             kind.name);
  add_note(model, walk.painted(), "meshes' colors of vertices");
  const auto count = [&](const auto& has) {
    return std::size_t(std::count_if(scene->mMeshes, scene->mMeshes + scene->mNumMeshes, has));
  };
  add_note(model, count([](const aiMesh* mesh) { return mesh->HasBones(); }), "meshes' skins");
  add_note(model, count([](const aiMesh* mesh) { return mesh->mNumAnimMeshes > 0; }),
           "meshes' morph targets");
  return model;
}

}  // namespace
}  // namespace twinray

extern "C" void TWINRAY_IMPORT_FUNCTION(const twinray::ImportedFile& file, twinray::ObjModel& model) {
  model = twinray::import_model(file);
}
