// SPDX-License-Identifier: Apache-2.0
// A COLLADA file as a whole: its root, its ids, its assets, where its warnings go, and the further files that
// its references lead to.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/rgb.h"
#include "io/collada/space.h"
#include "io/diagnostic.h"
#include "io/load_options.h"
#include "io/xml/reader.h"

namespace twinray {

/// Reads a document that a reference names, by its path. Throws Error.
using DocumentOpener = std::function<std::unique_ptr<XmlDocument>(const std::string& path)>;

class ColladaDocument {
 public:
  /// Throws Error where the root is not <COLLADA version="1.4..."> or 1.5.
  ColladaDocument(const XmlDocument& document, const LoadOptions& options,
                  DocumentOpener open = XmlDocument::load);

  const XmlElement& root() const { return root_; }
  const LoadOptions& options() const { return options_; }

  /// The element that an attribute such as url="#id" or url="file.dae#id" refers to. Throws Error where it is
  /// not of this form, the file cannot be read, no element has the id, or the element is neither a <kind> nor
  /// an <or_kind>.
  XmlElement resolve(const XmlElement& from, const char* attribute, std::string_view kind,
                     std::string_view or_kind = "");
  /// The same, for what can be left out: what resolve() throws is a warning, and nothing is returned.
  std::optional<XmlElement> resolve_or_warn(const XmlElement& from, const char* attribute,
                                            std::string_view kind);
  /// Whether the element holds neither elements nor text: with a warning that it is left out.
  bool is_empty(const XmlElement& element);
  /// The <kind> with this id in the file of `from`.
  std::optional<XmlElement> find(const XmlElement& from, std::string_view id, std::string_view kind) const;

  void warn(const XmlElement& at, const std::string& message) {
    warnings_.add([&] { return at.place(); }, message);
  }
  void warn(const std::function<Place()>& where, const std::string& message) {
    warnings_.add(where, message);
  }
  const std::vector<Diagnostic>& warnings() const { return warnings_.items(); }

  /// Warns of names that COLLADA does not have, in the file of this root. Done for further files.
  void check_names_of(const XmlElement& root);

  /// Of the coordinates within an element: its own <asset>'s, or that of the nearest element around it.
  const ColladaSpace& space_of(const XmlElement& element) const;
  /// Of an element that another one of the space `outside` holds or instances: as Khronos's conformance suite
  /// has it, an element without an <asset> of its own, and outside of all but the root's, is in the space
  /// that it is placed in; one of another file is in that file's.
  const ColladaSpace& space_of(const XmlElement& element, const XmlElement& from,
                               const ColladaSpace& outside) const;

  static constexpr std::size_t max_files = 100;

 private:
  struct File {
    std::unique_ptr<XmlDocument> owned;  ///< Null for the first one.
    std::multimap<std::string, XmlElement, std::less<>> ids;
    std::map<XmlElement, ColladaSpace> spaces;  ///< By the elements that hold an <asset>; the root always.
  };

  void check_root(const XmlElement& root);
  void check_version(const XmlElement& root);
  void read_file(const XmlDocument& document, File& file);
  void index(const XmlElement& element, File& file);
  File& file_of(const XmlElement& element);
  const File& file_of(const XmlElement& element) const;
  XmlElement space_owner(const XmlElement& element) const;
  const XmlDocument& open(const XmlElement& from, const char* attribute, const std::string& path);
  XmlElement find_in(const XmlDocument& document, const XmlElement& from, const char* attribute,
                     std::string_view kind, std::string_view or_kind);
  static std::string suggest(const File& file, std::string_view wanted, std::string_view kind);

  XmlElement root_;
  LoadOptions options_;
  DocumentOpener open_;
  WarningList warnings_;
  std::map<const XmlDocument*, File> files_;
  std::map<std::string, const XmlDocument*> by_path_;
};

/// The name that messages and the summary use: the attribute "name", else "id", else "unnamed".
std::string display_name(const XmlElement& element);

/// The <input> of this semantic. Throws Error where there is none.
XmlElement required_input(const XmlElement& element, std::string_view semantic);

/// A number within [least, most]. Throws Error that states the range.
double number_in(const XmlElement& element, double least, double most);

/// Three numbers, or four of which the last (alpha) is not used, each within [0, most]. Throws Error that
/// states the range.
Rgb read_color(const XmlElement& element, float most);

/// The <technique> of an <extra> of this element whose profile is CGL or CMU462.
std::optional<XmlElement> cgl_technique(const XmlElement& element);

}  // namespace twinray
