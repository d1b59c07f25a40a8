// SPDX-License-Identifier: Apache-2.0
#include "io/collada_controller.h"

#include <algorithm>

#include "io/collada_transform.h"

namespace twinray {
namespace {

XmlElement skin_or_morph(const XmlElement& controller) {
  for (const char* name : {"skin", "morph"})
    if (const auto found = controller.child(name)) return *found;
  controller.fail("<controller> has neither a <skin> nor a <morph>, of which it needs one");
}

Transform read_bind_shape(const XmlElement& skin, ColladaDocument& document) {
  const auto matrix = skin.child("bind_shape_matrix");
  return matrix ? read_matrix(*matrix, document) : Transform{};
}

}  // namespace

ControlledGeometry controlled_geometry(const XmlElement& controller, ColladaDocument& document) {
  ControlledGeometry result{controller, {}};
  std::vector<XmlElement> chain;
  while (result.geometry.is("controller")) {
    if (std::find(chain.begin(), chain.end(), result.geometry) != chain.end())
      result.geometry.fail("this controller is its own source; controllers must form no circle");
    chain.push_back(result.geometry);
    const XmlElement source = skin_or_morph(result.geometry);
    if (source.is("skin")) {
      document.warn(source, "<skin> is rendered in its bind pose; joints do not move it");
      result.bind_shape = result.bind_shape * read_bind_shape(source, document);
    } else {
      document.warn(source, "<morph> is rendered as its base mesh; targets do not change it");
    }
    result.geometry = document.resolve(source, "source", "geometry", "controller");
  }
  return result;
}

}  // namespace twinray
