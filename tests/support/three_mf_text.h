// SPDX-License-Identifier: Apache-2.0
// 3MF packages, for tests.
#pragma once
#include <string>
#include <vector>

#include "tests/support/zip_text.h"

namespace twinray::test {

inline const std::string three_mf_spaces =
    "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
    "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
    "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";

/// A model's document. `inside` is all that <model> holds.
inline std::string three_mf_model(const std::string& inside, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<model " + three_mf_spaces + " " + attributes + ">" + inside + "</model>";
}

/// An object that is a tetrahedron; `attributes` and those of its first triangle may say what these wear.
inline std::string tetrahedron(int id, const std::string& attributes = "", const std::string& first = "") {
  return "<object id=\"" + std::to_string(id) + "\" " + attributes +
         "><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"5\" y=\"0\" z=\"0\"/>"
         "<vertex x=\"0\" y=\"6\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"7\"/></vertices><triangles>"
         "<triangle v1=\"0\" v2=\"2\" v3=\"1\" " +
         first +
         "/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/>"
         "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh></object>";
}

/// The archive's bytes: what says where the model is, the model, and other parts.
inline std::string three_mf_package(const std::string& model, std::vector<ZipEntry> others = {}) {
  others.push_back(
      {"_rels/.rels",
       "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
       "<Relationship Target=\"/Metadata/a.png\" Id=\"a\" Type=\"http://x.y/thumbnail\"/>"
       "<Relationship Target=\"/3D/model.model\" Id=\"b\" "
       "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"});
  others.push_back({"3D/Model.model", model});
  return zip_text(others);
}

}  // namespace twinray::test
