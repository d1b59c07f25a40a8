// SPDX-License-Identifier: Apache-2.0
// The names of COLLADA 1.4.1 and of CS184's extensions, as one table. An element's rule is the one for
// "parent/name" if there is one, else that for "name"; an element without a rule has no children.
#include "io/collada_schema.h"

#include <fmt/format.h>

#include <algorithm>

namespace twinray {
namespace {

/// Names are separated by spaces. Before the name of a child: '-' passes over it and all that it holds, '!'
/// warns that it is not supported. Attributes id, name and sid are allowed everywhere.
struct Rule {
  std::string_view element, children, attributes;
};

constexpr std::string_view shading_children =
    "emission diffuse -ambient -specular -shininess -reflective -reflectivity -transparent -transparency "
    "-index_of_refraction extra";

constexpr Rule rules[] = {
    {"COLLADA",
     "asset library_cameras library_effects library_geometries library_lights library_materials "
     "library_nodes "
     "library_visual_scenes scene extra -library_images !library_animations !library_animation_clips "
     "!library_controllers !library_force_fields !library_physics_materials !library_physics_models "
     "!library_physics_scenes",
     "version base"},
    {"asset",
     "-contributor -coverage -created -keywords -modified -revision -subject -title unit up_axis extra", ""},
    {"unit", "", "meter"},

    {"library_cameras", "-asset camera extra", ""},
    {"camera", "-asset optics -imager extra", ""},
    {"optics", "technique_common technique extra", ""},
    {"optics/technique_common", "perspective orthographic", ""},
    {"perspective", "xfov yfov aspect_ratio znear zfar", ""},
    {"orthographic", "xmag ymag aspect_ratio znear zfar", ""},

    {"library_lights", "-asset light extra", ""},
    {"light", "-asset technique_common technique extra", ""},
    {"light/technique_common", "ambient directional point spot", ""},
    {"light/CGL", "area ambient directional point spot", ""},
    {"area", "color", ""},
    {"ambient", "color", ""},
    {"directional", "color", ""},
    {"point", "color constant_attenuation linear_attenuation quadratic_attenuation", ""},
    {"spot",
     "color constant_attenuation linear_attenuation quadratic_attenuation falloff_angle falloff_exponent",
     ""},

    {"library_effects", "-asset effect extra", ""},
    {"effect",
     "-asset -annotate -image -newparam profile_COMMON !profile_CG !profile_GLES !profile_GLSL extra", ""},
    {"profile_COMMON", "-asset -image -newparam technique extra", ""},
    {"profile_COMMON/technique", "-asset -image -newparam constant lambert phong blinn extra", ""},
    {"constant", shading_children, ""},
    {"lambert", shading_children, ""},
    {"phong", shading_children, ""},
    {"blinn", shading_children, ""},
    {"diffuse", "color param texture", ""},
    {"emission", "color param texture", ""},
    {"param", "", "ref"},
    {"texture", "extra", "texture texcoord"},
    {"effect/CGL", "emission mirror refraction glass microfacet", ""},
    {"CGL/emission", "radiance", ""},
    {"mirror", "reflectance", ""},
    {"refraction", "transmittance roughness ior", ""},
    {"glass", "transmittance reflectance roughness ior", ""},
    {"microfacet", "alpha eta k -reflectance", ""},

    {"library_materials", "-asset material extra", ""},
    {"material", "-asset instance_effect extra", ""},
    {"instance_effect", "-technique_hint !setparam extra", "url"},

    {"library_geometries", "-asset geometry extra", ""},
    {"geometry", "-asset mesh !convex_mesh !spline extra", ""},
    {"geometry/CGL", "sphere", ""},
    {"sphere", "radius", ""},
    {"mesh", "source vertices triangles polylist polygons tristrips trifans !lines !linestrips extra", ""},
    {"source",
     "-asset float_array -IDREF_array -Name_array -bool_array -int_array technique_common technique", ""},
    {"source/technique_common", "accessor", ""},
    {"float_array", "", "count digits magnitude"},
    {"accessor", "param", "count offset source stride"},
    {"accessor/param", "", "type semantic"},
    {"vertices", "input extra", ""},
    {"vertices/input", "", "semantic source"},
    {"input", "", "semantic source offset set"},
    {"triangles", "input p extra", "count material"},
    {"tristrips", "input p extra", "count material"},
    {"trifans", "input p extra", "count material"},
    {"polylist", "input vcount p extra", "count material"},
    {"polygons", "input p !ph extra", "count material"},

    {"library_nodes", "-asset node extra", ""},
    {"library_visual_scenes", "-asset visual_scene extra", ""},
    {"visual_scene", "-asset node -evaluate_scene extra", ""},
    {"node",
     "-asset lookat matrix rotate scale skew translate instance_camera instance_geometry instance_light "
     "instance_node !instance_controller node extra",
     "type layer"},
    {"instance_camera", "extra", "url"},
    {"instance_light", "extra", "url"},
    {"instance_node", "extra", "url"},
    {"instance_geometry", "bind_material extra", "url"},
    {"bind_material", "-param technique_common -technique extra", ""},
    {"bind_material/technique_common", "instance_material", ""},
    {"instance_material", "-bind -bind_vertex_input extra", "symbol target"},
    {"scene", "instance_visual_scene !instance_physics_scene extra", ""},
    {"instance_visual_scene", "extra", "url"},

    {"extra", "-asset technique", "type"},
};

/// Profiles of other programs: known, and without meaning here.
constexpr std::string_view foreign_profiles[] = {
    "blender",           "MAYA",        "MAX3D", "3DSMAX", "FCOLLADA", "OpenCOLLADA",      "OpenCOLLADAMaya",
    "OpenCOLLADA3dsMax", "GOOGLEEARTH", "XSI",   "AXE",    "PHYSX",    "NVIDIA_FXCOMPOSER"};

std::vector<std::string_view> words(std::string_view list) {
  std::vector<std::string_view> result;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    result.push_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return result;
}

const Rule* find_rule(std::string_view name) {
  const auto found =
      std::find_if(std::begin(rules), std::end(rules), [&](const Rule& r) { return r.element == name; });
  return found == std::end(rules) ? nullptr : &*found;
}

const Rule& rule_of(std::string_view parent, std::string_view name) {
  static constexpr Rule leaf{"", "", ""};
  if (const Rule* rule = find_rule(fmt::format("{}/{}", parent, name))) return *rule;
  const Rule* rule = find_rule(name);
  return rule ? *rule : leaf;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> known, const char* form) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "" : "; did you mean " + fmt::format(fmt::runtime(form), nearest) + "?";
}

class NameCheck {
 public:
  explicit NameCheck(ColladaDocument& document) : document_(document) {}

  /// `context` is what the parent counts as: its name, or "CGL".
  void check(const XmlElement& element, std::string_view context) {
    const Rule& rule = rule_of(context, element.name());
    check_attributes(element, rule);
    check_children(element, rule, element.name());
  }

 private:
  void check_attributes(const XmlElement& element, const Rule& rule) {
    auto known = words(rule.attributes);
    for (const std::string_view everywhere : {"id", "name", "sid"}) known.push_back(everywhere);
    for (const std::string& name : element.attribute_names()) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      if (name.rfind("xmlns", 0) == 0 || name.rfind("xsi:", 0) == 0) continue;
      document_.warn([&] { return element.attribute_place(name); },
                     fmt::format("the attribute \"{}\" is not known in <{}>, and is left out{}", name,
                                 element.name(), did_you_mean(name, known, "\"{}\"")));
    }
  }

  void check_children(const XmlElement& element, const Rule& rule, std::string_view context) {
    const auto entries = words(rule.children);
    std::vector<std::string_view> known = entries;
    for (std::string_view& name : known)
      if (name[0] == '-' || name[0] == '!') name.remove_prefix(1);
    for (const XmlElement& child : element.children()) {
      const std::string name = child.name();
      const auto found = std::find(known.begin(), known.end(), name);
      if (found == known.end()) {
        document_.warn(child, fmt::format("<{}> is not known in <{}>, and is left out{}", name,
                                          element.name(), did_you_mean(name, known, "<{}>")));
        continue;
      }
      const char mark = entries[std::size_t(found - known.begin())][0];
      if (mark == '!') check_unsupported(child);
      if (name == "asset" && mark == '-') check_inner_asset(child, element);
      if (mark == '-' || mark == '!') continue;
      if (name == "extra") owner_ = element.name();
      if (name == "technique" && context != "profile_COMMON")
        check_technique(child, element);
      else
        check(child, context);
    }
  }

  /// Exporters write empty libraries.
  void check_unsupported(const XmlElement& element) {
    if (element.name().rfind("library_", 0) == 0 && element.children().empty()) return;
    document_.warn(element, fmt::format("<{}> is not supported, and is left out", element.name()));
  }

  void check_inner_asset(const XmlElement& asset, const XmlElement& owner) {
    for (const char* name : {"unit", "up_axis"})
      if (const auto setting = asset.child(name))
        document_.warn(
            *setting, fmt::format("<{}> is read from the <asset> of <COLLADA> only; that of <{}> is left out",
                                  name, owner.name()));
  }

  void check_technique(const XmlElement& technique, const XmlElement& parent) {
    static constexpr std::string_view ours[] = {"CGL", "CMU462"};
    const std::string profile = technique.attribute("profile").value_or("");
    if (std::find(std::begin(foreign_profiles), std::end(foreign_profiles), profile) !=
        std::end(foreign_profiles))
      return;
    if (!is_cgl_profile(profile) || !parent.is("extra")) {
      document_.warn(
          [&] { return technique.attribute_place("profile"); },
          fmt::format("the profile \"{}\" is not known in <{}>, and what it holds is left out{}", profile,
                      parent.name(), is_cgl_profile(profile) ? "" : did_you_mean(profile, ours, "\"{}\"")));
      return;
    }
    check_cgl(technique);
  }

  void check_cgl(const XmlElement& technique) {
    const Rule* rule = find_rule(fmt::format("{}/CGL", owner_));
    if (rule) return check_children(technique, *rule, "CGL");
    document_.warn(technique,
                   fmt::format("CGL extensions are known in <light>, <effect> and <geometry>, not in <{}>; "
                               "this one is left out",
                               owner_));
  }

  ColladaDocument& document_;
  std::string owner_;  ///< The element whose <extra> is being checked.
};

}  // namespace

void check_names(ColladaDocument& document) { NameCheck(document).check(document.root(), ""); }

}  // namespace twinray
