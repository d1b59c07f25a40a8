// SPDX-License-Identifier: Apache-2.0
// The names of COLLADA 1.4 and 1.5 and of CS184's extensions, as one table. An element's rule is the one for
// "parent/name" if there is one, else that for "name"; an element without a rule has no children.
#include "io/collada/schema.h"

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
     "asset library_cameras library_controllers library_effects library_geometries library_images "
     "library_lights "
     "library_materials library_nodes library_visual_scenes scene extra !library_animations "
     "!library_animation_clips -library_formulas !library_force_fields !library_joints "
     "!library_kinematics_models !library_kinematics_scenes !library_articulated_systems "
     "!library_physics_materials !library_physics_models !library_physics_scenes",
     "version base"},
    {"asset",
     "-contributor -coverage -created -keywords -modified -revision -subject -title unit up_axis extra", ""},
    {"unit", "", "meter"},

    {"library_cameras", "asset camera extra", ""},
    {"camera", "asset optics -imager extra", ""},
    {"optics", "technique_common technique extra", ""},
    {"optics/technique_common", "perspective orthographic", ""},
    {"perspective", "xfov yfov aspect_ratio znear zfar", ""},
    {"orthographic", "xmag ymag aspect_ratio znear zfar", ""},

    {"library_lights", "asset light extra", ""},
    {"light", "asset technique_common technique extra", ""},
    {"light/technique_common", "ambient directional point spot", ""},
    {"light/CGL", "area ambient directional point spot", ""},
    {"area", "color", ""},
    {"ambient", "color", ""},
    {"directional", "color", ""},
    {"point", "color constant_attenuation linear_attenuation quadratic_attenuation", ""},
    {"spot",
     "color constant_attenuation linear_attenuation quadratic_attenuation falloff_angle falloff_exponent",
     ""},

    {"library_images", "asset image extra", ""},
    {"image", "asset -data -renderable -create_2d -create_3d -create_cube init_from extra",
     "format width height depth"},
    {"init_from", "-ref -hex", "mips_generate array_index mip_index depth face"},

    {"library_effects", "asset effect extra", ""},
    {"effect",
     "asset -annotate image -newparam profile_COMMON -profile_BRIDGE -profile_CG -profile_GLES "
     "-profile_GLES2 -profile_GLSL extra",
     ""},
    {"profile_COMMON", "asset image -newparam technique extra", "platform"},
    {"profile_COMMON/technique", "asset image -newparam constant lambert phong blinn extra", ""},
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

    {"library_materials", "asset material extra", ""},
    {"material", "asset instance_effect extra", ""},
    {"instance_effect", "-technique_hint -setparam extra", "url"},

    {"library_geometries", "asset geometry extra", ""},
    {"geometry", "asset mesh convex_mesh !spline !brep extra", ""},
    {"geometry/CGL", "sphere", ""},
    {"sphere", "radius", ""},
    {"mesh", "source vertices triangles polylist polygons tristrips trifans !lines !linestrips extra", ""},
    {"convex_mesh", "source vertices triangles polylist polygons tristrips trifans !lines !linestrips extra",
     "convex_hull_of"},
    {"source",
     "asset float_array -IDREF_array -Name_array -SIDREF_array -bool_array int_array -token_array "
     "technique_common technique",
     ""},
    {"source/technique_common", "accessor", ""},
    {"float_array", "", "count digits magnitude"},
    {"int_array", "", "count minInclusive maxInclusive"},
    {"accessor", "param", "count offset source stride"},
    {"accessor/param", "", "type semantic"},
    {"vertices", "input extra", ""},
    {"vertices/input", "", "semantic source"},
    {"input", "", "semantic source offset set"},
    {"triangles", "input p extra", "count material"},
    {"tristrips", "input p extra", "count material"},
    {"trifans", "input p extra", "count material"},
    {"polylist", "input vcount p extra", "count material"},
    {"polygons", "input p ph extra", "count material"},
    {"ph", "p h", ""},

    {"library_controllers", "asset controller extra", ""},
    {"controller", "asset skin morph extra", ""},
    {"skin", "bind_shape_matrix source -joints -vertex_weights extra", "source"},
    {"morph", "source targets extra", "source method"},
    {"targets", "input extra", ""},
    {"targets/input", "", "semantic source"},

    {"library_nodes", "asset node extra", ""},
    {"library_visual_scenes", "asset visual_scene extra", ""},
    {"visual_scene", "asset node evaluate_scene extra", ""},
    {"evaluate_scene", "asset render extra", "enable"},
    {"render", "-layer -instance_material -instance_effect extra", "camera_node"},
    {"node",
     "asset lookat matrix rotate scale skew translate instance_camera instance_controller instance_geometry "
     "instance_light instance_node node extra",
     "type layer"},
    {"instance_camera", "extra", "url"},
    {"instance_light", "extra", "url"},
    {"instance_node", "extra", "url proxy"},
    {"instance_geometry", "bind_material extra", "url"},
    {"instance_controller", "-skeleton bind_material extra", "url"},
    {"bind_material", "-param technique_common -technique extra", ""},
    {"bind_material/technique_common", "instance_material", ""},
    {"instance_material", "-bind bind_vertex_input extra", "symbol target"},
    {"bind_vertex_input", "", "semantic input_semantic input_set"},
    {"scene", "instance_visual_scene !instance_kinematics_scene !instance_physics_scene extra", ""},
    {"instance_visual_scene", "extra", "url"},

    {"extra", "-asset technique", "type"},
};

/// Profiles of other programs: known, and without meaning here but for what changes a surface's look.
constexpr std::string_view foreign_profiles[] = {
    "3DSMAX",          "AXE",
    "COLLADA_1_4_0",   "COLLADA_1_4_1",
    "FCOLLADA",        "GOOGLEEARTH",
    "MAX3D",           "MAYA",
    "MAYA3",           "MB",
    "MESHMOON",        "NVIDIA_FXCOMPOSER",
    "OpenCOLLADA",     "OpenCOLLADA3dsMax",
    "OpenCOLLADAMaya", "OpenCOLLADAXSI",
    "PHYSX",           "RenderMonkey",
    "SketchUp",        "XSI",
    "blender",
};

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
  explicit NameCheck(WarningList& warnings) : warnings_(warnings) {}

  /// `context` is what the parent counts as: its name, or "CGL".
  void check(const XmlElement& element, std::string_view context) {
    const Rule& rule = rule_of(context, element.name());
    check_attributes(element, rule);
    check_children(element, rule, element.name());
  }

 private:
  void warn(const XmlElement& at, const std::string& message) {
    warnings_.add([&] { return at.place(); }, message);
  }

  void check_attributes(const XmlElement& element, const Rule& rule) {
    auto known = words(rule.attributes);
    for (const std::string_view everywhere : {"id", "name", "sid"}) known.push_back(everywhere);
    for (const std::string& name : element.attribute_names()) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      if (name.rfind("xmlns", 0) == 0 || name.rfind("xsi:", 0) == 0) continue;
      warnings_.add([&] { return element.attribute_place(name); },
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
        warn(child, fmt::format("<{}> is not known in <{}>, and is left out{}", name, element.name(),
                                did_you_mean(name, known, "<{}>")));
        continue;
      }
      const char mark = entries[std::size_t(found - known.begin())][0];
      if (mark == '!') check_unsupported(child);
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
    warn(element, fmt::format("<{}> is not supported, and is left out", element.name()));
  }

  void check_technique(const XmlElement& technique, const XmlElement& parent) {
    static constexpr std::string_view ours[] = {"CGL", "CMU462"};
    const std::string profile = technique.attribute("profile").value_or("");
    if (std::find(std::begin(foreign_profiles), std::end(foreign_profiles), profile) !=
        std::end(foreign_profiles))
      return check_foreign(technique);
    if (!is_cgl_profile(profile) || !parent.is("extra")) {
      warnings_.add(
          [&] { return technique.attribute_place("profile"); },
          fmt::format("the profile \"{}\" is not known in <{}>, and what it holds is left out{}", profile,
                      parent.name(), is_cgl_profile(profile) ? "" : did_you_mean(profile, ours, "\"{}\"")));
      return;
    }
    check_cgl(technique);
  }

  void check_foreign(const XmlElement& technique) {
    if (const auto bump = technique.child("bump"); bump && bump->child("texture"))
      warn(*bump, "bump maps are not rendered; the surface stays smooth");
  }

  void check_cgl(const XmlElement& technique) {
    const Rule* rule = find_rule(fmt::format("{}/CGL", owner_));
    if (rule) return check_children(technique, *rule, "CGL");
    warn(technique, fmt::format("CGL extensions are known in <light>, <effect> and <geometry>, not in <{}>; "
                                "this one is left out",
                                owner_));
  }

  WarningList& warnings_;
  std::string owner_;  ///< The element whose <extra> is being checked.
};

}  // namespace

void check_names(const XmlElement& root, WarningList& warnings) { NameCheck(warnings).check(root, ""); }

bool is_cgl_profile(std::string_view profile) { return profile == "CGL" || profile == "CMU462"; }

}  // namespace twinray
