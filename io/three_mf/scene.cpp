// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/instance.h"
#include "io/mesh_scene.h"
#include "io/number_list.h"
#include "io/placed_mesh.h"
#include "io/scene_part.h"
#include "io/three_mf/mesh.h"
#include "io/three_mf/package.h"
#include "io/three_mf/properties.h"
#include "io/vertex_colors.h"

namespace twinray {
namespace {

/// Components within components.
constexpr std::size_t deepest = 100;
/// What a package shows; each of a few nested objects could show all of the next one twice.
constexpr std::size_t most_shown = 1000000;

const Transform z_up{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}}};

struct Unit {
  std::string_view name;
  double meters;
};
constexpr Unit units[] = {{"millimeter", 1e-3}, {"micron", 1e-6}, {"centimeter", 1e-2},
                          {"inch", 0.0254},     {"foot", 0.3048}, {"meter", 1}};

const Unit& unit_of(const XmlElement& model) {
  const std::string name = model.attribute("unit").value_or("millimeter");
  for (const Unit& unit : units)
    if (unit.name == name) return unit;
  throw error_at(
      model.attribute_place("unit"),
      fmt::format("\"{}\" is no unit of 3MF; valid are micron, millimeter, centimeter, inch, foot, meter",
                  name));
}

/// Of twelve numbers, the rows of a matrix that acts on rows.
Transform transform_of(const XmlElement& element) {
  const auto text = element.attribute("transform");
  if (!text) return {};
  const auto fail = [&](const std::string& message) {
    throw error_at(element.attribute_place("transform"), message);
  };
  std::vector<double> numbers;
  try {
    numbers = parse_doubles(*text);
  } catch (const NumberError& error) {
    fail(error.message);
  }
  if (numbers.size() != 12) fail(fmt::format("a transform has 12 numbers; here are {}", numbers.size()));
  Transform transform;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) transform.m[row][column] = numbers[3 * column + row];
  return transform;
}

/// Refuses a package that cannot be understood without an extension which is not read.
void check_extensions(const XmlElement& model) {
  const std::string required = model.attribute("requiredextensions").value_or("");
  for (std::size_t begin = 0; begin < required.size();) {
    const std::size_t end = std::min(required.find(' ', begin), required.size());
    const std::string prefix = required.substr(begin, end - begin);
    begin = end + 1;
    if (prefix.empty()) continue;
    const std::string space = model.attribute(("xmlns:" + prefix).c_str()).value_or("");
    if (space.find("/production/") != std::string::npos || space.find("/material/") != std::string::npos)
      continue;
    throw error_at(model.attribute_place("requiredextensions"),
                   fmt::format("the package requires the extension \"{}\" ({}), which is not read", prefix,
                               space.empty() ? "of no namespace" : space));
  }
}

/// The objects and properties of a document, by their numbers.
struct Resources {
  std::map<std::uint32_t, XmlElement> objects;
  std::optional<ThreeMfProperties> properties;
};

/// An object with a mesh, as often as it is shown.
struct ShownObject {
  std::string name;
  std::vector<ThreeMfPiece> pieces;
  std::vector<std::uint32_t> materials;                  ///< Of each piece.
  std::vector<std::pair<Transform, XmlElement>> places;  ///< And the item or component that says so.

  std::size_t triangles() const {
    std::size_t count = 0;
    for (const ThreeMfPiece& piece : pieces) count += piece.mesh.triangles.size();
    return count;
  }
};

class Builder {
 public:
  Builder(const std::string& path, const LoadOptions& options)
      : path_(path), options_(options), warnings_(options.strict), package_(path) {}

  LoadedScene load() {
    options_.add_file(path_);
    const XmlDocument& document = package_.model();
    const XmlElement model = document.root();
    if (!model.is("model"))
      model.fail(fmt::format("not 3MF: the root element is <{}>, not <model>", model.name()));
    const Unit& unit = unit_of(model);
    check_extensions(model);
    for (const XmlElement& item : model.required_child("build").children("item")) show(item, z_up, {});
    place_all();
    if (parts_.empty())
      throw Error(fmt::format("{}: what the package's <build> shows has no triangles", path_));
    LoadedScene loaded = mesh_scene(std::move(parts_), std::move(rest_), repairs_, std::move(instances_));
    loaded.summary.unit_name = unit.name;
    loaded.summary.unit_meters = unit.meters;
    loaded.summary.up_axis = 'Z';
    loaded.summary.repeated = repeated_;
    loaded.warnings = warnings_.items();
    return loaded;
  }

 private:
  const Resources& resources_of(const XmlDocument& document) {
    const auto [entry, is_new] = resources_.try_emplace(&document);
    if (!is_new) return entry->second;
    const auto resources = document.root().child("resources");
    if (!resources) document.root().fail("<model> has no <resources>");
    entry->second.properties.emplace(*resources, warnings_);
    for (const XmlElement& object : resources->children("object"))
      if (!entry->second.objects.try_emplace(object.required_index_attribute("id"), object).second)
        throw error_at(object.attribute_place("id"), "another object has this id");
    return entry->second;
  }

  /// What an <item> or a <component> names. `inherited` is worn by what wears nothing of its own.
  void show(const XmlElement& named_by, const Transform& around,
            const std::optional<ThreeMfProperty>& inherited) {
    const auto path = local_attribute(named_by, "path");
    const XmlDocument& document = path ? package_.part(*path, named_by.place()) : named_by.document();
    const Resources& resources = resources_of(document);
    const std::uint32_t id = named_by.required_index_attribute("objectid");
    const auto found = resources.objects.find(id);
    if (found == resources.objects.end())
      throw error_at(named_by.attribute_place("objectid"),
                     fmt::format("there is no object with the id {} in {}", id, document.file()));
    if (++shown_ > most_shown)
      named_by.fail(fmt::format("the package shows more than {} objects", most_shown));
    const XmlElement& object = found->second;
    if (std::find(around_.begin(), around_.end(), object) != around_.end())
      named_by.fail(fmt::format("the object {} contains itself", id));
    if (around_.size() == deepest)
      named_by.fail(fmt::format("components are nested deeper than {}", deepest));
    around_.push_back(object);
    show_object(named_by, object, around * transform_of(named_by), worn_by(object, resources, inherited));
    around_.pop_back();
  }

  void show_object(const XmlElement& named_by, const XmlElement& object, const Transform& to_world,
                   const std::optional<ThreeMfProperty>& own) {
    if (const auto components = object.child("components")) {
      for (const XmlElement& component : components->children("component")) show(component, to_world, own);
      return;
    }
    const auto mesh = object.child("mesh");
    if (!mesh) object.fail("an <object> holds a <mesh> or <components>");
    const std::string worn =
        own ? fmt::format("{} {} {} {}", own->color.r, own->color.g, own->color.b, own->name) : "";
    const auto [entry, is_new] = numbers_.try_emplace({object, worn}, objects_.size());
    if (is_new) {
      const std::string name = object.attribute("name").value_or("");
      objects_.push_back(
          {name.empty() ? fmt::format("object {}", object.required_attribute("id")) : name, {}, {}, {}});
      ThreeMfDefault worn_by_all{own};
      if (object.attribute("pid")) worn_by_all.group = object.required_index_attribute("pid");
      objects_.back().pieces =
          read_pieces(*mesh, objects_.back().name, *resources_of(object.document()).properties, worn_by_all);
    }
    objects_[entry->second].places.emplace_back(to_world, named_by);
  }

  static std::optional<ThreeMfProperty> worn_by(const XmlElement& object, const Resources& resources,
                                                const std::optional<ThreeMfProperty>& inherited) {
    if (!object.attribute("pid")) return inherited;
    const ThreeMfChoice choice{object.required_index_attribute("pid"), object.index_attribute("pindex", 0)};
    return resources.properties->find(object, choice);
  }

  void place_all() {
    for (ShownObject& object : objects_) {
      repeated_ += object.places.size() > 1;
      for (ThreeMfPiece& piece : object.pieces) object.materials.push_back(material_of(piece));
      const bool is_shared = are_stored_once(options_.instances, object.triangles(), object.places.size());
      const auto asset = std::uint32_t(rest_.assets.size());
      rest_.assets.push_back(object.name);
      if (is_shared)
        place_shared(object, asset);
      else
        for (const auto& [to_world, named_by] : object.places) place(object, asset, to_world, named_by, {});
    }
  }

  void place_shared(const ShownObject& object, std::uint32_t asset) {
    const std::uint32_t prototype = prototypes_++;
    const std::size_t first = parts_.size();
    place(object, asset, {}, object.places[0].second, prototype);
    Aabb box;
    for (std::size_t i = first; i < parts_.size(); ++i) box.extend(bounds_of(parts_[i].shape));
    for (const auto& [to_world, named_by] : object.places) {
      if (!can_place(to_world)) {
        place(object, asset, to_world, named_by, {});
        continue;
      }
      check_reach(box, to_world,
                  [&named_by = named_by](const std::string& message) { named_by.fail(message); });
      instances_.push_back({prototype, to_world});
    }
  }

  void place(const ShownObject& object, std::uint32_t asset, const Transform& to_world,
             const XmlElement& named_by, const std::optional<std::uint32_t>& prototype) {
    for (std::size_t i = 0; i < object.pieces.size(); ++i) {
      PlacedMesh placed = place_mesh(object.pieces[i].mesh, to_world,
                                     [&](const std::string& message) { named_by.fail(message); });
      repairs_.dropped_triangles += placed.dropped;
      if (placed.mesh.triangles.empty()) continue;
      ScenePart part;
      part.shape = std::move(placed.mesh);
      part.material = object.materials[i];
      part.asset = asset;
      part.prototype = prototype;
      parts_.push_back(std::move(part));
    }
  }

  /// Of a piece whose vertices have colours one with a picture of these; where it is too large for that, of
  /// their mean.
  std::uint32_t material_of(ThreeMfPiece& piece) {
    if (!piece.colors.empty() && can_draw_vertices(piece.mesh)) return painted(piece);
    if (!piece.colors.empty()) {
      const Rgb sum = std::accumulate(piece.colors.begin(), piece.colors.end(), Rgb{});
      piece.property = ThreeMfProperty{"mean", sum / float(piece.colors.size())};
      warnings_.add([&] { return Place{path_}; },
                    "an object has too many triangles whose corners differ in colour; "
                    "they have the mean colour");
    }
    if (!piece.property) return made({"none", Lambert{}});
    return made({piece.property->name, Lambert{piece.property->color}});
  }

  std::uint32_t painted(ThreeMfPiece& piece) {
    Material material{"colors of vertices", Lambert{}};
    material.textures.push_back({MaterialInput::reflectance, std::uint32_t(rest_.textures.size())});
    rest_.textures.push_back(
        {material.name, draw_vertices(piece.mesh, [&](std::uint32_t i) { return piece.colors[i]; })});
    set_drawn_uvs(piece.mesh);
    rest_.materials.push_back(std::move(material));
    return std::uint32_t(rest_.materials.size() - 1);
  }

  /// The number of a material without textures, made once.
  std::uint32_t made(const Material& material) {
    const Rgb& color = std::get<Lambert>(material.model).reflectance;
    const auto [entry, is_new] = materials_.try_emplace({material.name, color.r, color.g, color.b},
                                                        std::uint32_t(rest_.materials.size()));
    if (is_new) rest_.materials.push_back(material);
    return entry->second;
  }

  const std::string& path_;
  const LoadOptions& options_;
  WarningList warnings_;
  ThreeMfPackage package_;
  std::map<const XmlDocument*, Resources> resources_;
  std::vector<XmlElement> around_;  ///< The objects within which another one is shown.
  std::size_t shown_ = 0, repeated_ = 0;
  std::vector<ShownObject> objects_;
  std::map<std::pair<XmlElement, std::string>, std::size_t> numbers_;  ///< By object and what it inherits.
  std::map<std::tuple<std::string, float, float, float>, std::uint32_t> materials_;  ///< By name and colour.
  std::vector<ScenePart> parts_;
  std::vector<Instance> instances_;
  std::uint32_t prototypes_ = 0;
  MeshRepairs repairs_;
  Scene rest_;
};

}  // namespace

LoadedScene load_three_mf(const std::string& path, const LoadOptions& options) {
  return Builder(path, options).load();
}

}  // namespace twinray
