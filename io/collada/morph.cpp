// SPDX-License-Identifier: Apache-2.0
#include "io/collada/morph.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/collada/source.h"

namespace twinray {
namespace {

XmlElement find_target(const std::string& id, const XmlElement& source, const ColladaDocument& document) {
  for (const char* kind : {"geometry", "controller"})
    if (const auto found = document.find(source, id, kind)) return *found;
  source.fail(fmt::format("no <geometry> or <controller> has the id \"{}\", of a target", id));
}

bool is_relative(const XmlElement& morph) {
  const std::string method = morph.attribute("method").value_or("NORMALIZED");
  if (method != "NORMALIZED" && method != "RELATIVE")
    throw error_at(
        morph.attribute_place("method"),
        fmt::format("\"{}\" is not a method of <morph>; valid are NORMALIZED and RELATIVE", method));
  return method == "RELATIVE";
}

void scale(std::vector<Vec3>& vectors, float weight) {
  for (Vec3& v : vectors) v = v * weight;
}

void add_scaled(std::vector<Vec3>& sum, const std::vector<Vec3>& vectors, float weight) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = sum[i] + vectors[i] * weight;
}

void add_normals(Mesh& mesh, const Mesh* target, float weight) {
  if (target && target->normal_indices == mesh.normal_indices &&
      target->normals.size() == mesh.normals.size())
    return add_scaled(mesh.normals, target->normals, weight);
  mesh.normals.clear();
  mesh.normal_indices.clear();
}

}  // namespace

MorphTargets read_morph_targets(const XmlElement& morph, ColladaDocument& document) {
  const XmlElement element = morph.required_child("targets");
  const auto source_of = [&](const char* semantic) {
    return document.resolve(required_input(element, semantic), "source", "source");
  };
  const XmlElement names_source = source_of("MORPH_TARGET");
  const SourceNames names = read_names(names_source);
  const SourceValues weights = read_source(source_of("MORPH_WEIGHT"), 1, document);
  if (weights.count() != names.names.size() || weights.has_nan)
    element.fail(fmt::format("there are {} targets, and {} weights", names.names.size(), weights.count()));
  MorphTargets result;
  const bool relative = is_relative(morph);
  for (std::size_t i = 0; i < names.names.size(); ++i) {
    const float weight = weights.values[i];
    result.targets.push_back({find_target(names.names[i], names_source, document), weight});
    if (!relative) result.base_weight -= weight;
  }
  return result;
}

void scale(ControlledShape& shape, float weight) {
  scale(shape.vertices, weight);
  for (ColladaPart& part : shape.geometry.parts) scale(part.mesh.normals, weight);
}

void add_scaled(ControlledShape& shape, const ControlledShape& target, float weight) {
  add_scaled(shape.vertices, target.vertices, weight);
  const auto& parts = target.geometry.parts;
  for (std::size_t i = 0; i < shape.geometry.parts.size(); ++i)
    add_normals(shape.geometry.parts[i].mesh, i < parts.size() ? &parts[i].mesh : nullptr, weight);
}

}  // namespace twinray
