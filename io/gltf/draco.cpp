// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/draco.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>
#include <tiny_gltf.h>

#include "io/gltf/document.h"

namespace twinray {
namespace {

std::unique_ptr<draco::Mesh> decode_mesh(std::string_view bytes, const std::string& pointer,
                                         const GltfContext& context) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
    context.fail(pointer, fmt::format("the compressed mesh is damaged: {}", decoded.status().error_msg()));
  return std::move(decoded).value();
}

std::vector<std::uint32_t> corners_of(const draco::Mesh& mesh) {
  std::vector<std::uint32_t> corners;
  corners.reserve(std::size_t(mesh.num_faces()) * 3);
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
    for (int corner = 0; corner < 3; ++corner)
      corners.push_back(mesh.face(face)[std::size_t(corner)].value());
  return corners;
}

/// The values of an attribute, as an accessor that has no data of its own describes them.
class Values {
 public:
  Values(GltfDocument& document, int accessor) : document_(document), accessor_(accessor) {}

  GltfNumbers of(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                 const std::string& pointer) const {
    const tinygltf::Accessor& accessor = document_.model().accessors[std::size_t(accessor_)];
    const std::size_t components =
        std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)));
    GltfNumbers numbers{mesh.num_points(), components, {}};
    numbers.values.resize(numbers.count * components);
    for (std::uint32_t i = 0; i < numbers.count; ++i) {
      const auto at = attribute.mapped_index(draco::PointIndex(i));
      if (!convert(attribute, at, &numbers.values[i * components], components))
        document_.context().fail(pointer, "the compressed mesh does not hold this attribute's values");
    }
    return numbers;
  }

 private:
  bool convert(const draco::PointAttribute& attribute, draco::AttributeValueIndex at, float* out,
               std::size_t components) const {
    if (at.value() >= attribute.size()) return false;
    if (attribute.data_type() == draco::DT_FLOAT32)
      return attribute.ConvertValue<float>(at, std::int8_t(components), out);
    std::int32_t whole[16] = {};
    if (!attribute.ConvertValue<std::int32_t>(at, std::int8_t(components), whole)) return false;
    for (std::size_t c = 0; c < components; ++c)
      out[c] = accessor_number(std::uint32_t(whole[c]), document_, accessor_);
    return true;
  }

  GltfDocument& document_;
  int accessor_;
};

}  // namespace

DracoMesh decode_draco(GltfDocument& document, const tinygltf::Primitive& primitive,
                       const std::string& primitive_pointer) {
  const std::string pointer = fmt::format("{}/extensions/{}", primitive_pointer, draco_extension);
  const GltfContext& context = document.context();
  const tinygltf::Value& extension = primitive.extensions.find(draco_extension)->second;
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP)
    context.fail(pointer, "a compressed primitive must be of triangles (mode 4) or a strip of them (5)");
  const auto view = std::size_t(extension.Get("bufferView").GetNumberAsInt());
  const auto mesh = decode_mesh(document.buffer_view(view), pointer, context);
  DracoMesh decoded{corners_of(*mesh), {}};
  const tinygltf::Value& attributes = extension.Get("attributes");
  for (const std::string& name : attributes.Keys()) {
    const std::string place = fmt::format("{}/attributes/{}", pointer, name);
    const tinygltf::Value& id = attributes.Get(name);
    const auto accessor = primitive.attributes.find(name);
    if (accessor == primitive.attributes.end())
      context.fail(place, "the primitive itself has no attribute of this name");
    const draco::PointAttribute* attribute =
        id.IsInt() && id.GetNumberAsInt() >= 0
            ? mesh->GetAttributeByUniqueId(std::uint32_t(id.GetNumberAsInt()))
            : nullptr;
    if (!attribute) context.fail(place, "the compressed mesh has no attribute of this number");
    decoded.attributes[name] = Values(document, accessor->second).of(*mesh, *attribute, place);
  }
  return decoded;
}

}  // namespace twinray
