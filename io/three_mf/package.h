// SPDX-License-Identifier: Apache-2.0
// Private: the XML documents of a 3MF package (3MF Consortium, "3D Manufacturing Format, Core Specification",
// 1.3): a zip archive whose _rels/.rels names the document to start with.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "io/diagnostic.h"
#include "io/xml/reader.h"
#include "io/zip_archive.h"

namespace twinray {

/// The part of a name behind its prefix, if it has one: prefixes of namespaces are any file's own choice.
std::string_view local_name(std::string_view name);
/// The attribute of an element whose local name this is.
std::optional<std::string> local_attribute(const XmlElement& element, std::string_view name);

class ThreeMfPackage {
 public:
  /// Opens a file. Throws Error where it is no zip archive, or does not say where to start.
  explicit ThreeMfPackage(const std::string& path);

  /// The document that the package starts with.
  const XmlDocument& model();
  /// A document, by its name: "/3D/Objects/gear.model". Throws Error at the place that names it where there
  /// is none, and where it is no XML.
  const XmlDocument& part(const std::string& name, const Place& named);

 private:
  /// The archive's own name of a part; case does not matter. "" where there is none.
  std::string entry_of(const std::string& part) const;
  const XmlDocument& read(const std::string& entry);

  ZipArchive archive_;
  std::map<std::string, std::string> entries_;  ///< By their names in lower case.
  std::map<std::string, std::unique_ptr<XmlDocument>> documents_;
};

}  // namespace twinray
