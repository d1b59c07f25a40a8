// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/package.h"

#include <fmt/format.h>

#include "io/lower_case.h"

namespace twinray {
namespace {

const std::string relations = "_rels/.rels";

/// The target of the relation to the model.
std::string start_of(const XmlDocument& document) {
  constexpr std::string_view kind = "/3dmodel";
  for (const XmlElement& relation : document.root().children("Relationship"))
    if (relation.attribute("Type").value_or("").ends_with(kind)) return relation.required_attribute("Target");
  document.root().fail("no <Relationship> is of the type .../3dmodel, which says where the model is");
}

}  // namespace

std::string_view local_name(std::string_view name) { return name.substr(name.find(':') + 1); }

std::optional<std::string> local_attribute(const XmlElement& element, std::string_view name) {
  for (const std::string& own : element.attribute_names())
    if (local_name(own) == name) return element.attribute(own.c_str());
  return std::nullopt;
}

ThreeMfPackage::ThreeMfPackage(const std::string& path) : archive_(path) {
  for (const std::string& entry : archive_.names()) entries_.emplace(lower_case(entry), entry);
  if (entry_of(relations).empty())
    throw Error(fmt::format("{}: the package has no {}, which says where its model is", path, relations));
}

std::string ThreeMfPackage::entry_of(const std::string& part) const {
  const auto found = entries_.find(lower_case(part.substr(part.starts_with('/') ? 1 : 0)));
  return found == entries_.end() ? "" : found->second;
}

const XmlDocument& ThreeMfPackage::read(const std::string& entry) {
  std::unique_ptr<XmlDocument>& document = documents_[entry];
  if (!document) document = XmlDocument::parse(archive_.read(entry), archive_.path() + "/" + entry);
  return *document;
}

const XmlDocument& ThreeMfPackage::model() {
  const XmlDocument& start = read(entry_of(relations));
  return part(start_of(start), start.root().place());
}

const XmlDocument& ThreeMfPackage::part(const std::string& name, const Place& named) {
  const std::string entry = entry_of(name);
  if (entry.empty()) throw error_at(named, fmt::format("the package has no part \"{}\"", name));
  return read(entry);
}

}  // namespace twinray
