// SPDX-License-Identifier: Apache-2.0
#include "io/collada/archive.h"

#include <fmt/format.h>

#include "io/collada/collada.h"
#include "io/uri.h"
#include "io/zip_archive.h"

namespace twinray {
namespace {

const std::string manifest = "manifest.xml";

std::unique_ptr<XmlDocument> read_entry(const ZipArchive& archive, const std::string& name) {
  return XmlDocument::parse(archive.read(name), archive.path() + "/" + name);
}

bool is_document(const std::string& name) {
  constexpr std::string_view extension = ".dae";
  return name.size() > extension.size() &&
         name.compare(name.size() - extension.size(), extension.size(), extension) == 0;
}

std::string only_document(const ZipArchive& archive, WarningList& warnings) {
  std::string found;
  std::size_t count = 0;
  for (const std::string& name : archive.names())
    if (is_document(name)) found = name, ++count;
  if (count != 1)
    throw Error(fmt::format("{}: the archive has no {}, which says where to start, and {} documents (.dae)",
                            archive.path(), manifest, count));
  Place place;
  place.file = archive.path();
  warnings.add([&] { return place; },
               fmt::format("the archive has no {}; its only document, {}, is read", manifest, found));
  return found;
}

/// The entry that the manifest names; a fragment names an element of it, and the whole scene is read.
std::string root_document(const ZipArchive& archive, WarningList& warnings) {
  if (!archive.has(manifest)) return only_document(archive, warnings);
  const auto document = read_entry(archive, manifest);
  const XmlElement root = document->root();
  const std::string uri = root.text();
  if (!root.is("dae_root") || uri.empty())
    root.fail("a manifest holds the document to start with, as <dae_root>./scene.dae</dae_root>");
  return path_of_uri(uri.substr(0, uri.find('#')), manifest);
}

}  // namespace

LoadedScene read_zae(const std::string& path, const LoadOptions& options) {
  const ZipArchive archive(path);
  WarningList warnings(options.strict);
  const auto document = read_entry(archive, root_document(archive, warnings));
  const std::string inside = normal_path(path) + "/";
  options.add_file(path);
  LoadOptions within = options;
  within.files = nullptr;  // They are the archive's.
  const auto entry_of = [&](const std::string& wanted) {
    if (wanted.rfind(inside, 0) != 0)
      throw Error(fmt::format("{}: this lies outside of the archive {}", wanted, path));
    return wanted.substr(inside.size());
  };
  LoadedScene loaded = read_collada(
      *document, within,
      {.document = [&](const std::string& wanted) { return read_entry(archive, entry_of(wanted)); },
       .picture = [&](const std::string& wanted, const PictureMeaning& meaning,
                      const LoadOptions& how) -> LoadedTexture {
         try {
           return decode_texture(archive.read(entry_of(wanted)), wanted, meaning, how);
         } catch (const Error& error) {
           return missing_texture(error.what());
         }
       }});
  loaded.warnings.insert(loaded.warnings.begin(), warnings.items().begin(), warnings.items().end());
  return loaded;
}

}  // namespace twinray
