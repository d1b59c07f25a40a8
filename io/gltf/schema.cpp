// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "io/gltf/attributes.h"
#include "io/gltf/context.h"
#include "io/gltf/exclusions.h"
#include "io/gltf/rules.h"
#include "io/gltf/text.h"

namespace twinray {
namespace {

using Json = nlohmann::json;

Json parse(const std::string& text, const GltfContext& context) {
  check_depth(text, context);
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw error_at(place_of(context.file, text, error.byte > 0 ? error.byte - 1 : 0),
                   "the text is not JSON here, or ends too early");
  } catch (const Json::exception&) {
    throw error_at(place_of(context.file, text, too_large_number(text)),
                   "the JSON text holds a number that is too large");
  }
}

/// "a, b or c" of words between spaces.
std::string alternatives(std::string_view words) {
  std::vector<std::string_view> list;
  while (!words.empty()) {
    const std::size_t space = std::min(words.find(' '), words.size());
    list.push_back(words.substr(0, space));
    words.remove_prefix(std::min(space + 1, words.size()));
  }
  return list_names(list);
}

bool has_word(std::string_view words, std::string_view word) {
  return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos &&
         word.find(' ') == std::string_view::npos && !word.empty();
}

/// A part of a JSON pointer: '~' and '/' have codes.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

/// The rules of an extension, some of which mean something else on objects of one kind.
std::string rules_of(std::string_view kind, const std::string& extension) {
  if (kind == "node" && extension == "KHR_lights_punctual") return extension + " of a node";
  if (kind == "buffer" && extension == "EXT_meshopt_compression") return extension + " of a buffer";
  return extension;
}

class Checker {
 public:
  Checker(Json& root, GltfContext& context) : root_(root), context_(context) {}

  void check() {
    if (!root_.is_object()) context_.fail("/", "a glTF file is one JSON object");
    check_version();
    check_object(root_, "", "");
    check_least_version();
    check_extensions();
  }

 private:
  /// Before the shape, which is another one in glTF 1.0: objects in place of lists, numbers for versions.
  void check_version() const {
    const Json::json_pointer place("/asset/version");
    if (!root_.contains(place)) return check_is_list("nodes"), check_is_list("meshes");
    const Json& version = root_[place];
    const std::string text = version.is_string()   ? version.get<std::string>()
                             : version.is_number() ? fmt::format("{:.1f}", version.get<double>())
                                                   : "2.0";  // What else it is, its rule says.
    if (text.substr(0, 2) != "2.")
      context_.fail("/asset/version", fmt::format("the version of glTF is \"{}\"; valid is 2.0", text));
  }

  /// Of a file that does not say its version.
  void check_is_list(const char* name) const {
    if (root_.contains(name) && root_[name].is_object())
      context_.fail(fmt::format("/{}", name),
                    "this is an object, as in glTF 1.0; valid is an array, as in glTF 2.0");
  }

  void check_least_version() const {
    const std::string least = root_["asset"].value("minVersion", "2.0");
    if (least != "2.0")
      context_.fail("/asset/minVersion",
                    fmt::format("the file asks for version \"{}\"; what is read is 2.0", least));
  }

  void check_extensions() {
    for (const char* list : {"extensionsRequired", "extensionsUsed"}) {
      if (!root_.contains(list)) continue;
      for (std::size_t i = 0; i < root_[list].size(); ++i) {
        const std::string name = root_[list][i];
        const std::string pointer = fmt::format("/{}/{}", list, i);
        if (is_read_extension(name) || is_silent_extension(name)) continue;
        if (list == std::string_view("extensionsRequired"))
          context_.fail(pointer, fmt::format("the extension {} is not rendered, and the file cannot be shown "
                                             "without it",
                                             name));
        context_.warn(pointer, unread(name));
      }
    }
  }

  void check_object(Json& object, std::string_view kind, const std::string& pointer) {
    std::vector<std::string_view> known{"extensions", "extras", "name"};
    bool has_rule = false;
    for (const GltfRule& rule : gltf_rules()) {
      if (rule.object != kind) continue;
      has_rule = true;
      known.push_back(rule.property);
      const std::string property(rule.property);
      const std::string place = fmt::format("{}/{}", pointer, property);
      if (object.contains(property))
        check_property(object[property], rule, place);
      else if (rule.is_required)
        context_.fail(pointer.empty() ? "/" : pointer,
                      fmt::format("\"{}\" is missing, and required", property));
    }
    if (object.contains("name") && !object["name"].is_string())
      fail_of(object["name"], pointer + "/name", "text");
    if (kind == "camera") check_lens(object, pointer);
    if (kind == "mesh") check_targets(object, pointer);
    if (kind == "node") check_one_transform(object, pointer);
    if (kind == "node") check_weights_of_node(object, pointer);
    if (kind == "light") complete_spot(object, pointer);
    if (kind == "bufferView") check_stride(object, pointer);
    if (kind == "image" && object.contains("uri") && object.contains("bufferView"))
      context_.fail(pointer, "an image has its \"uri\" or its \"bufferView\"; not both");
    if (object.contains("extensions")) check_extensions_of(object["extensions"], kind, pointer);
    if (has_rule) warn_of_unknown(object, known, pointer);
  }

  void check_one_transform(const Json& node, const std::string& pointer) const {
    for (const char* part : {"translation", "rotation", "scale"})
      if (node.contains("matrix") && node.contains(part))
        context_.fail(pointer, "a node has a matrix, or a translation, rotation and scale; not both");
  }

  /// A camera has an object of the name that its type is.
  void check_lens(const Json& camera, const std::string& pointer) const {
    const std::string type = camera["type"];
    if (!camera.contains(type))
      context_.fail(pointer, fmt::format("\"{}\" is missing, and required of such a camera", type));
  }

  void check_stride(const Json& view, const std::string& pointer) const {
    if (view.contains("byteStride") && view["byteStride"].get<int>() % 4 != 0)
      fail_of(view["byteStride"], pointer + "/byteStride", "a multiple of 4 from 4 to 252");
  }

  /// Drafts of the extension let a spot light be without its angles.
  void complete_spot(Json& light, const std::string& pointer) {
    if (light["type"] != "spot" || light.contains("spot")) return;
    context_.warn(pointer, "a spot light needs \"spot\"; without one its angles are 0 and 45 degrees");
    light["spot"] = Json::object();
  }

  void warn_of_unknown(const Json& object, const std::vector<std::string_view>& known,
                       const std::string& pointer) {
    for (const auto& [name, value] : object.items()) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      const std::string nearest = nearest_name(name, known);
      context_.warn(pointer.empty() ? "/" : pointer,
                    nearest.empty()
                        ? fmt::format("\"{}\" is not a known name", name)
                        : fmt::format("\"{}\" is not a known name; did you mean \"{}\"?", name, nearest));
    }
  }

  void check_extensions_of(Json& extensions, std::string_view kind, const std::string& pointer) {
    const std::string place = pointer + "/extensions";
    if (!extensions.is_object()) fail_of(extensions, place, "an object");
    std::vector<std::string> misplaced;
    for (auto& [name, value] : extensions.items()) {
      const std::string own = place + "/" + escaped(name);
      if (!is_read_extension(name)) {
        warn_of_undeclared(name, own);
      } else if (!may_have_extension(kind, name)) {
        context_.warn(own,
                      fmt::format("{} has no effect here: it belongs to {}", name, owner_of_extension(name)));
        misplaced.push_back(name);
      } else {
        if (!value.is_object()) fail_of(value, own, "an object");
        check_object(value, rules_of(kind, name), own);
      }
    }
    for (const std::string& name : misplaced) extensions.erase(name);  // Its values were not checked.
    if (kind == "material") warn_of_excluded(extensions, place);
  }

  void warn_of_excluded(const Json& extensions, const std::string& pointer) {
    for (const std::string_view exclusive : exclusive_extensions) {
      if (!extensions.contains(std::string(exclusive))) continue;
      for (const auto& [name, value] : extensions.items())
        if (const std::string fault = fault_beside(exclusive, name); !fault.empty())
          context_.warn(pointer + "/" + escaped(name), fault);
      return;
    }
  }

  bool is_declared(const std::string& name) const {
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
      if (root_.contains(list) && root_[list].is_array() &&
          std::find(root_[list].begin(), root_[list].end(), name) != root_[list].end())
        return true;
    return false;
  }

  /// Those that are declared are told of there.
  void warn_of_undeclared(const std::string& name, const std::string& pointer) {
    if (!is_declared(name) && !is_silent_extension(name)) context_.warn(pointer, unread(name));
  }

  static std::string unread(const std::string& name) {
    const std::string nearest = nearest_extension(name);
    return nearest.empty() ? fmt::format("the extension {} is not rendered", name)
                           : fmt::format("the extension {} is not rendered; did you mean {}?", name, nearest);
  }

  [[noreturn]] void fail_of(const Json& value, const std::string& pointer, const std::string& valid) const {
    std::string text = value.is_structured() ? std::string(value.type_name()) : value.dump();
    constexpr std::size_t most = 40;
    if (text.size() > most) text = text.substr(0, most) + "...";
    context_.fail(pointer, fmt::format("this is {}; valid is {}", text, valid));
  }

  void check_property(Json& value, const GltfRule& rule, const std::string& pointer) {
    switch (rule.kind) {
      case GltfKind::passed:
        return;
      case GltfKind::flag:
        return value.is_boolean() ? void() : fail_of(value, pointer, "true or false");
      case GltfKind::text:
        return value.is_string() ? void() : fail_of(value, pointer, "text");
      case GltfKind::word:
        if (!value.is_string() || !has_word(rule.of, value.get_ref<const std::string&>()))
          fail_of(value, pointer, alternatives(rule.of));
        return;
      case GltfKind::number:
        return check_number(value, rule, pointer);
      case GltfKind::integer:
        return check_integer(value, rule.least, rule.most, pointer);
      case GltfKind::code:
        check_integer(value, 0, 2147483647.0, pointer);
        return has_word(rule.of, value.dump()) ? void() : fail_of(value, pointer, alternatives(rule.of));
      case GltfKind::index:
        return check_index(value, rule.of, pointer);
      case GltfKind::object:
        if (!value.is_object()) fail_of(value, pointer, "an object");
        return check_object(value, rule.of, pointer);
      case GltfKind::accessors:
        if (!value.is_object()) fail_of(value, pointer, "an object");
        return check_attributes(value, rule.object, pointer);
      default:
        return check_array(value, rule, pointer);
    }
  }

  void check_array(Json& value, const GltfRule& rule, const std::string& pointer) {
    if (!value.is_array()) fail_of(value, pointer, "an array");
    const bool is_sized = rule.kind == GltfKind::numbers;
    if (value.size() < rule.least_size || (is_sized && value.size() > rule.most_size))
      context_.fail(pointer,
                    rule.least_size == rule.most_size
                        ? fmt::format("{} numbers; valid are {}", value.size(), rule.most_size)
                        : fmt::format("{} elements; valid are {} and more", value.size(), rule.least_size));
    std::set<std::size_t> seen;
    for (std::size_t i = 0; i < value.size(); ++i) {
      Json& each = value[i];
      const std::string place = fmt::format("{}/{}", pointer, i);
      if (rule.kind == GltfKind::numbers) check_number(each, rule, place);
      if (rule.kind == GltfKind::texts && !each.is_string()) fail_of(each, place, "text");
      if (rule.kind == GltfKind::objects && !each.is_object()) fail_of(each, place, "an object");
      if (rule.kind == GltfKind::objects) check_element(each, rule.of, place);
      if (rule.kind != GltfKind::indices) continue;
      check_index(each, rule.of, place);
      if (!seen.insert(each.get<std::size_t>()).second)
        context_.fail(place, fmt::format("the index {} stands here a second time", each.dump()));
    }
  }

  void check_element(Json& object, std::string_view kind, const std::string& pointer) {
    if (kind != "target") return check_object(object, kind, pointer);
    check_attributes(object, kind, pointer);
  }

  void check_attributes(Json& attributes, std::string_view kind, const std::string& pointer) {
    for (auto& [name, each] : attributes.items()) {
      const std::string place = pointer + "/" + escaped(name);
      check_index(each, "accessors", place);
      if (const std::string fault = fault_of_attribute(kind, name); !fault.empty())
        context_.warn(place, fault);
      for (const std::string& other : needed_beside(name))
        if (!attributes.contains(other))
          context_.fail(place, fmt::format("{} is here, and {}, which it needs, is not", name, other));
    }
  }

  static std::size_t targets_of(const Json& primitive) {
    return primitive.contains("targets") ? primitive["targets"].size() : 0;
  }

  void check_targets(const Json& mesh, const std::string& pointer) const {
    const Json& primitives = mesh["primitives"];
    const std::size_t targets = targets_of(primitives[0]);
    for (std::size_t i = 0; i < primitives.size(); ++i)
      if (targets_of(primitives[i]) != targets)
        context_.fail(fmt::format("{}/primitives/{}", pointer, i),
                      fmt::format("{} morph targets, and primitive 0 has {}; all of a mesh must have as many",
                                  targets_of(primitives[i]), targets));
    check_weights(mesh, targets, pointer);
  }

  /// An empty list is none.
  void check_weights(const Json& object, std::size_t targets, const std::string& pointer) const {
    const std::size_t weights = object.contains("weights") ? object["weights"].size() : 0;
    if (weights > 0 && weights != targets)
      context_.fail(pointer + "/weights",
                    fmt::format("{} weights for {} morph targets; there must be as many", weights, targets));
  }

  /// The meshes were checked before.
  void check_weights_of_node(const Json& node, const std::string& pointer) {
    if (node.contains("mesh"))
      check_weights(node, targets_of(root_["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]),
                    pointer);
    else if (node.contains("weights"))
      context_.warn(pointer + "/weights", "weights of a node without a mesh have no effect");
  }

  void check_number(const Json& value, const GltfRule& rule, const std::string& pointer) const {
    const bool is_in =
        value.is_number() && value.get<double>() >= rule.least && value.get<double>() <= rule.most;
    if (!is_in) fail_of(value, pointer, fmt::format("a number from {:g} to {:g}", rule.least, rule.most));
  }

  /// Whole numbers may stand with a decimal point: they lose it.
  void check_integer(Json& value, double least, double most, const std::string& pointer) const {
    const double number = value.is_number() ? value.get<double>() : -1;
    const bool is_in = value.is_number() && number >= least && number <= most && number == std::floor(number);
    if (!is_in) fail_of(value, pointer, fmt::format("a whole number from {:.0f} to {:.0f}", least, most));
    if (value.is_number_float()) value = std::int64_t(number);
  }

  void check_index(Json& value, std::string_view array, const std::string& pointer) const {
    const std::string name(array);
    const std::size_t size = root_.contains(name) && root_[name].is_array() ? root_[name].size() : 0;
    if (size == 0) fail_of(value, pointer, fmt::format("none: the file has no {}", array));
    check_integer(value, 0, double(size - 1), pointer);
  }

  Json& root_;
  GltfContext& context_;
};

/// Takes the list out of the file: who reads the JSON must not read files.
std::vector<CheckedGltf::Source> take_sources(Json& root, const char* list) {
  std::vector<CheckedGltf::Source> sources;
  if (!root.contains(list)) return sources;
  for (Json& each : root[list])
    sources.push_back({each.value("uri", ""), each.value("byteLength", std::size_t(0)),
                       each.value("bufferView", -1), each.value("name", "")});
  root.erase(list);
  return sources;
}

/// Whether a list of indices has no bytes of its own: it is zeros, some of which others may replace.
bool has_no_bytes(const Json& root, const Json& accessor) {
  return !root["accessors"][accessor.get<std::size_t>()].contains("bufferView");
}

/// tinygltf wants a buffer view for all indices, and those that Draco compressed, or that are zeros, have
/// none: they go where it does not look.
void move_indices(Json& root) {
  if (!root.contains("meshes")) return;
  for (Json& mesh : root["meshes"])
    for (Json& primitive : mesh["primitives"]) {
      const bool has_extensions = primitive.contains("extensions");
      if (has_extensions) primitive["extensions"].erase(moved_indices);  // A stranger's was not checked.
      if (!primitive.contains("indices")) continue;
      const bool is_packed = has_extensions && primitive["extensions"].contains("KHR_draco_mesh_compression");
      if (!is_packed && !has_no_bytes(root, primitive["indices"])) continue;
      primitive["extensions"][is_packed ? "KHR_draco_mesh_compression" : moved_indices]["indices"] =
          primitive["indices"];
      primitive.erase("indices");
    }
}

}  // namespace

CheckedGltf check_gltf(const std::string& json, GltfContext& context) {
  Json root = parse(json, context);
  Checker(root, context).check();
  CheckedGltf checked;
  checked.buffers = take_sources(root, "buffers");
  checked.images = take_sources(root, "images");
  move_indices(root);
  checked.json = root.dump();
  return checked;
}

}  // namespace twinray
