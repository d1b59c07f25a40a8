// SPDX-License-Identifier: Apache-2.0
#include "io/collada/document.h"

#include <fmt/format.h>

#include "io/collada/schema.h"
#include "io/uri.h"

namespace twinray {
namespace {

/// A release of COLLADA, by the start of its version and its namespace.
struct Release {
  std::string_view version, name_space;
};
constexpr Release releases[] = {{"1.4", "http://www.collada.org/2005/11/COLLADASchema"},
                                {"1.5", "http://www.collada.org/2008/03/COLLADASchema"}};

const Release* release_of(std::string_view version) {
  for (const Release& release : releases)
    if (version == release.version || version.rfind(fmt::format("{}.", release.version), 0) == 0)
      return &release;
  return nullptr;
}

}  // namespace

ColladaDocument::ColladaDocument(const XmlDocument& document, const LoadOptions& options, DocumentOpener open)
    : root_(document.root()), options_(options), open_(std::move(open)), warnings_(options.strict) {
  by_path_[normal_path(document.file())] = &document;
  read_file(document, files_[&document]);
}

void ColladaDocument::check_root(const XmlElement& root) {
  if (!root.is("COLLADA"))
    root.fail(fmt::format("not COLLADA: the root element is <{}>; it must be <COLLADA version=\"1.4.1\">",
                          root.name()));
  check_version(root);
  if (const std::string encoding = root.document().foreign_encoding(); !encoding.empty())
    warn(root, fmt::format("the encoding {} is read as if it were UTF-8; names may look wrong", encoding));
}

void ColladaDocument::check_version(const XmlElement& root) {
  const auto version = root.attribute("version");
  const Release* release = version ? release_of(*version) : nullptr;
  if (version && !release)
    throw error_at(
        root.attribute_place("version"),
        fmt::format("COLLADA version \"{}\" is not read; valid are 1.4.0, 1.4.1 and 1.5.0", *version));
  if (!version) warn(root, "<COLLADA> has no version; it is read as 1.4.1");
  const std::string& found = root.document().root_namespace();
  if (version && !found.empty() && found != release->name_space)
    warn(root, fmt::format(
                   "the namespace \"{}\" is not that of COLLADA {}, \"{}\"; the names are read all the same",
                   found, release->version, release->name_space));
}

void ColladaDocument::read_file(const XmlDocument& document, File& file) {
  options_.add_file(document.file());
  const XmlElement root = document.root();
  check_root(root);
  file.spaces[root] = {};
  index(root, file);
}

void ColladaDocument::check_names_of(const XmlElement& root) { check_names(root, warnings_); }

void ColladaDocument::index(const XmlElement& element, File& file) {
  if (const auto id = element.attribute("id"); id && !id->empty()) {
    if (file.ids.count(*id) > 0)
      warn([&] { return element.attribute_place("id"); },
           fmt::format(
               "the id \"{}\" is used before; references mean the first element that has it and is of the "
               "kind that is needed",
               *id));
    file.ids.emplace(*id, element);
  }
  // CS184's program knows the file's own <asset> alone.
  const bool counts =
      options_.interpretation == Interpretation::standard || element == element.document().root();
  for (const XmlElement& child : element.children()) {
    if (counts && child.is("asset")) file.spaces[element] = read_space(child, space_of(element), warnings_);
    index(child, file);
  }
}

ColladaDocument::File& ColladaDocument::file_of(const XmlElement& element) {
  return files_.at(&element.document());
}

const ColladaDocument::File& ColladaDocument::file_of(const XmlElement& element) const {
  return files_.at(&element.document());
}

/// The nearest element at or around this one that has an <asset>, else the root.
XmlElement ColladaDocument::space_owner(const XmlElement& element) const {
  const auto& spaces = file_of(element).spaces;
  std::optional<XmlElement> owner = spaces.size() > 1 ? element : element.document().root();
  while (spaces.count(*owner) == 0) owner = owner->parent();
  return *owner;
}

const ColladaSpace& ColladaDocument::space_of(const XmlElement& element) const {
  return file_of(element).spaces.at(space_owner(element));
}

const ColladaSpace& ColladaDocument::space_of(const XmlElement& element, const XmlElement& from,
                                              const ColladaSpace& outside) const {
  const XmlElement owner = space_owner(element);
  const bool is_root_here = owner == from.document().root();
  return is_root_here ? outside : file_of(element).spaces.at(owner);
}

std::optional<XmlElement> ColladaDocument::find(const XmlElement& from, std::string_view id,
                                                std::string_view kind) const {
  const auto [begin, end] = file_of(from).ids.equal_range(id);
  for (auto found = begin; found != end; ++found)
    if (found->second.is(kind)) return found->second;
  return std::nullopt;
}

XmlElement ColladaDocument::resolve(const XmlElement& from, const char* attribute, std::string_view kind,
                                    std::string_view or_kind) {
  const std::string url = from.required_attribute(attribute);
  const std::size_t hash = url.find('#');
  if (hash == 0) return find_in(from.document(), from, attribute, kind, or_kind);
  if (hash != std::string::npos)
    return find_in(open(from, attribute, url.substr(0, hash)), from, attribute, kind, or_kind);
  if (const auto found = find(from, url, kind)) {
    warn([&] { return from.attribute_place(attribute); },
         fmt::format("\"{}\" is taken to mean \"#{}\"; a reference has the form \"#id\"", url, url));
    return *found;
  }
  throw error_at(
      from.attribute_place(attribute),
      fmt::format("\"{}\" is not a reference, which has the form \"#id\" or \"file.dae#id\"", url));
}

std::optional<XmlElement> ColladaDocument::resolve_or_warn(const XmlElement& from, const char* attribute,
                                                           std::string_view kind) {
  try {
    return resolve(from, attribute, kind);
  } catch (const PlacedError& error) {
    warn([&] { return error.place(); },
         fmt::format("{}; this <{}> is left out", error.message(), from.name()));
    return std::nullopt;
  }
}

bool ColladaDocument::is_empty(const XmlElement& element) {
  if (!element.children().empty() || !element.text().empty()) return false;
  warn(element, fmt::format("<{}> is empty, and is left out", element.name()));
  return true;
}

XmlElement ColladaDocument::find_in(const XmlDocument& document, const XmlElement& from,
                                    const char* attribute, std::string_view kind, std::string_view or_kind) {
  const std::string url = from.required_attribute(attribute);
  const std::string id = decoded_uri(url.substr(url.find('#') + 1));
  if (const auto found = find(document.root(), id, kind)) return *found;
  if (const auto found = find(document.root(), id, or_kind)) return *found;
  const File& file = files_.at(&document);
  const auto other = file.ids.find(id);
  if (other != file.ids.end())
    throw error_at(from.attribute_place(attribute),
                   fmt::format("\"{}\" is a <{}>; a <{}> is needed", url, other->second.name(), kind));
  throw error_at(from.attribute_place(attribute),
                 fmt::format("no <{}> has the id \"{}\"{}", kind, id, suggest(file, id, kind)));
}

const XmlDocument& ColladaDocument::open(const XmlElement& from, const char* attribute,
                                         const std::string& reference) {
  const auto fail = [&](const std::string& message) {
    throw error_at(from.attribute_place(attribute), message);
  };
  if (is_remote(reference))
    fail(fmt::format("\"{}\" is not a file of this machine; references lead to files", reference));
  const std::string path = path_of_uri(reference, from.document().file());
  if (const auto known = by_path_.find(path); known != by_path_.end()) return *known->second;
  if (files_.size() >= max_files) fail(fmt::format("references lead to more than {} files", max_files));
  std::unique_ptr<XmlDocument> document;
  try {
    document = open_(path);
  } catch (const Error& error) {
    fail(fmt::format("the file that this reference names cannot be read\n{}", error.what()));
  }
  const XmlDocument& opened = *document;
  File& file = files_[&opened];
  file.owned = std::move(document);
  by_path_[path] = &opened;
  read_file(opened, file);
  check_names_of(opened.root());
  return opened;
}

std::string ColladaDocument::suggest(const File& file, std::string_view wanted, std::string_view kind) {
  std::vector<std::string_view> known;
  for (const auto& [id, element] : file.ids)
    if (element.is(kind)) known.push_back(id);
  const std::string nearest = nearest_name(wanted, known);
  if (!nearest.empty()) return fmt::format("; did you mean \"#{}\"?", nearest);
  constexpr std::size_t most_listed = 8;
  if (known.empty()) return "; the file has none";
  return known.size() > most_listed ? "" : fmt::format("; there is {}", list_names(known));
}

std::string display_name(const XmlElement& element) {
  for (const char* attribute : {"name", "id"})
    if (const auto value = element.attribute(attribute); value && !value->empty()) return *value;
  return "unnamed";
}

XmlElement required_input(const XmlElement& element, std::string_view semantic) {
  for (const XmlElement& input : element.children("input"))
    if (input.attribute("semantic").value_or("") == semantic) return input;
  element.fail(fmt::format("<{}> has no <input semantic=\"{}\">, which it needs", element.name(), semantic));
}

double number_in(const XmlElement& element, double least, double most) {
  const double value = element.number();
  if (value < least || value > most)
    throw error_at(element.number_place(0), fmt::format("<{}> is {}; it must lie in [{:g}, {:g}]",
                                                        element.name(), value, least, most));
  return value;
}

Rgb read_color(const XmlElement& element, float most) {
  const auto values = element.floats();
  if (values.size() != 3 && values.size() != 4)
    element.fail(fmt::format("<{}> has {} numbers; a color has 3 (red, green, blue), or 4 with alpha",
                             element.name(), values.size()));
  for (std::size_t i = 0; i < 3; ++i)
    if (values[i] < 0 || values[i] > most)
      throw error_at(element.number_place(i),
                     fmt::format("a component of <{}> is {}; it must lie in [0, {:g}]", element.name(),
                                 values[i], most));
  return {values[0], values[1], values[2]};
}

std::optional<XmlElement> cgl_technique(const XmlElement& element) {
  for (const XmlElement& extra : element.children("extra"))
    for (const XmlElement& technique : extra.children("technique"))
      if (is_cgl_profile(technique.attribute("profile").value_or(""))) return technique;
  return std::nullopt;
}

}  // namespace twinray
