// SPDX-License-Identifier: Apache-2.0
// A COLLADA file as a whole: its root, its ids, its asset, and where its warnings go.
#pragma once
#include <map>
#include <string>
#include <string_view>

#include "core/rgb.h"
#include "core/transform.h"
#include "io/diagnostic.h"
#include "io/load_options.h"
#include "io/xml_reader.h"

namespace twinray {

class ColladaDocument {
 public:
  /// Throws Error where the root is not <COLLADA version="1.4...">.
  ColladaDocument(const XmlDocument& document, const LoadOptions& options);

  const XmlElement& root() const { return root_; }
  const LoadOptions& options() const { return options_; }

  /// The element that an attribute such as url="#id" refers to. Throws Error where it is not of the form #id,
  /// no element has the id, or the element is not a <kind>.
  XmlElement resolve(const XmlElement& from, const char* attribute, std::string_view kind) const;

  void warn(const XmlElement& at, const std::string& message) {
    warnings_.add([&] { return at.place(); }, message);
  }
  void warn(const std::function<Place()>& where, const std::string& message) {
    warnings_.add(where, message);
  }
  const std::vector<Diagnostic>& warnings() const { return warnings_.items(); }

  /// X, Y or Z; where the file does not say, Y.
  char up_axis() const { return up_axis_; }
  /// The turn that brings the file's up axis to Y, as CS184's program has it: Z_UP (x, y, z) -> (-x, z, y),
  /// X_UP (x, y, z) -> (y, x, -z).
  Transform to_y_up() const;
  std::string unit_name() const { return unit_name_; }
  double unit_meters() const { return unit_meters_; }

 private:
  void index_ids(const XmlElement& element);
  void read_asset();
  std::string suggest(std::string_view wanted, std::string_view kind) const;

  XmlElement root_;
  LoadOptions options_;
  WarningList warnings_;
  std::map<std::string, XmlElement, std::less<>> ids_;
  char up_axis_ = 'Y';
  std::string unit_name_ = "meter";
  double unit_meters_ = 1;
};

/// The name that messages and the summary use: the attribute "name", else "id", else "unnamed".
std::string display_name(const XmlElement& element);

/// A number within [least, most]. Throws Error that states the range.
double number_in(const XmlElement& element, double least, double most);

/// Three numbers, or four of which the last (alpha) is not used, each within [0, most]. Throws Error that
/// states the range.
Rgb read_color(const XmlElement& element, float most);

/// The <technique> of an <extra> of this element whose profile is CGL or CMU462.
std::optional<XmlElement> cgl_technique(const XmlElement& element);

/// Whether this is the profile of CS184's extensions.
bool is_cgl_profile(std::string_view profile);

}  // namespace twinray
