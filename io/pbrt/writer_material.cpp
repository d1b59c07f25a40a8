// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/textured_material.h"
#include "io/pbrt/stand_in.h"
#include "io/pbrt/text.h"

namespace twinray {
namespace {

using enum MaterialInput;

/// The parameters of one material.
class Parameters {
 public:
  Parameters(const PbrtStandIn& made, PbrtTextureWriter& textures, SceneOutput& output,
             const std::vector<std::string>& names)
      : material_(made.material),
        made_(made),
        textures_(textures),
        output_(output),
        names_(names),
        uses_(material_.textures) {
    is_remapped_ =
        !made.squares_roughness && std::any_of(uses_.begin(), uses_.end(), [](const TextureUse& use) {
          return use.meaning == InputMeaning::squared_roughness;
        });
  }

  std::string text() {
    std::visit([&](const auto& model) { add(model); }, material_.model);
    add_maps();
    for (const TextureUse& use : uses_) {
      const std::string name = input_name(use.input);
      output_.losses.add(fmt::format("a texture of a material's {} is left out", name),
                         fmt::format("{{}} textures of materials' {} are left out", name));
    }
    return text_;
  }

 private:
  void type(const char* name) { text_ += pbrt_word("type", name); }

  /// The use of a texture for an input; it counts as written.
  std::optional<TextureUse> take(MaterialInput input) {
    const auto found =
        std::find_if(uses_.begin(), uses_.end(), [&](const TextureUse& use) { return use.input == input; });
    if (found == uses_.end()) return std::nullopt;
    const TextureUse use = *found;
    uses_.erase(found);
    return use;
  }

  void color(const char* name, MaterialInput input, const Rgb& value) {
    const auto use = take(input);
    if (!use) {
      text_ += pbrt_rgb(name, value);
      return;
    }
    const bool is_base = input == reflectance || use->meaning == InputMeaning::metal_reflectance;
    const std::uint32_t texture = textures_.scaled(use->texture, is_base ? made_.base_weight : 1);
    text_ += pbrt_texture(name, textures_.named(texture, PbrtTextureKind::color));
  }

  /// A metal by its index, or by the texture of its reflectance.
  void metal(const std::string& prefix, const Rgb& eta_value, const Rgb& k_value) {
    const auto found = std::find_if(uses_.begin(), uses_.end(), [](const TextureUse& use) {
      return use.meaning == InputMeaning::metal_reflectance;
    });
    if (found != uses_.end()) return color("reflectance", found->input, {});
    color((prefix + "eta").c_str(), eta, eta_value);
    color((prefix + "k").c_str(), k, k_value);
  }

  /// One axis of a roughness: alpha or, where it is remapped, its square. `factor`: of a texture's.
  void axis(const std::string& name, const std::optional<TextureUse>& use, float alpha, float factor) {
    if (!use) {
      text_ += pbrt_real(name, is_remapped_ ? alpha * alpha : alpha);
      return;
    }
    const bool is_squared = made_.squares_roughness || (is_remapped_ && use->meaning == InputMeaning::value);
    text_ += pbrt_texture(name, is_squared ? textures_.squared(use->texture, factor)
                                           : textures_.named(use->texture, PbrtTextureKind::number));
  }

  /// `input`: that of both axes, which is followed by those of each.
  void rough(const std::string& prefix, MaterialInput input, const Roughness& alpha) {
    const auto both = take(input), u = take(MaterialInput(int(input) + 1)),
               v = take(MaterialInput(int(input) + 2));
    const Roughness factors = input == roughness ? made_.facet_factors : Roughness{1, 1};
    if (!u && !v && (both ? factors.x == factors.y : alpha.x == alpha.y)) {
      axis(prefix + "roughness", both, alpha.x, factors.x);
    } else {
      axis(prefix + "uroughness", u ? u : both, alpha.x, factors.x);
      axis(prefix + "vroughness", v ? v : both, alpha.y, factors.y);
    }
  }
  void remap() { text_ += pbrt_flag("remaproughness", is_remapped_); }

  void add(const Lambert& model) {
    type("diffuse");
    color("reflectance", reflectance, model.reflectance);
  }
  void add(const Dielectric& model) {
    type(model.is_thin ? "thindielectric" : "dielectric");
    text_ += pbrt_real("eta", model.ior);
    if (model.is_thin) return;
    rough("", roughness, model.roughness);
    remap();
  }
  void add(const Conductor& model) {
    type("conductor");
    metal("", model.eta, model.k);
    rough("", roughness, model.roughness);
    remap();
  }
  void add(const DiffuseTransmission& model) {
    type("diffusetransmission");
    color("reflectance", reflectance, model.reflectance);
    color("transmittance", transmittance, model.transmittance);
    text_ += pbrt_real("scale", 1);
  }
  void add(const CoatedDiffuse& model) {
    type("coateddiffuse");
    color("reflectance", reflectance, model.reflectance);
    text_ += pbrt_real("eta", model.ior);
    rough("", roughness, model.roughness);
    remap();
  }
  void add(const CoatedConductor& model) {
    type("coatedconductor");
    metal("conductor.", model.eta, model.k);
    rough("conductor.", roughness, model.roughness);
    text_ += pbrt_real("interface.eta", model.coat_ior);
    rough("interface.", coat_roughness, model.coat_roughness);
    remap();
  }
  void add(const Interface&) { type("interface"); }
  void add(const Mix& model) {
    type("mix");
    text_ += fmt::format(" \"string materials\" [ {} {} ]", pbrt_string(names_[model.first]),
                         pbrt_string(names_[model.second]));
    if (const auto use = take(amount))
      text_ += pbrt_texture("amount", textures_.named(use->texture, PbrtTextureKind::number));
    else
      text_ += pbrt_real("amount", model.amount);
  }
  /// All others became one of those above.
  template <typename Model>
  void add(const Model&) {}

  void add_maps() {
    if (material_.normal_map != no_texture)
      text_ += pbrt_word("normalmap", textures_.normal_map(material_.normal_map));
    if (material_.bump_map != no_texture)
      text_ += pbrt_texture("displacement", textures_.named(material_.bump_map, PbrtTextureKind::number));
  }

  const Material& material_;
  const PbrtStandIn& made_;
  PbrtTextureWriter& textures_;
  SceneOutput& output_;
  const std::vector<std::string>& names_;
  std::vector<TextureUse> uses_;  ///< Those that are not written yet.
  bool is_remapped_ = false;
  std::string text_;
};

std::string medium_name(const std::string& material) { return "within " + material; }

std::string grid_text(const DensityGrid& grid) {
  const auto& [nx, ny, nz] = grid.size();
  std::string text = pbrt_integer("nx", nx) + pbrt_integer("ny", ny) + pbrt_integer("nz", nz);
  text += "\n  \"float density\" [";
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        text += fmt::format("{}{}", x % 16 == 0 ? "\n    " : " ", grid.value(x, y, z));
  return text + " ]";
}

/// Where the transform is the identity.
std::string medium_text(const Scene& scene, const std::string& name, const Interior& interior) {
  const auto statement = [&](const char* type, const std::string& grid) {
    return fmt::format("MakeNamedMedium {}{}{}{}{}{}\n", pbrt_string(name), pbrt_word("type", type),
                       pbrt_rgb("sigma_a", interior.absorption), pbrt_rgb("sigma_s", interior.scattering),
                       interior.anisotropy != 0 ? pbrt_real("g", interior.anisotropy) : "", grid);
  };
  if (interior.density == no_density) return statement("homogeneous", "");
  const DensityGrid& grid = *scene.densities[interior.density];
  return pbrt_transform(grid.to_unit().inverse()) + statement("uniformgrid", grid_text(grid)) + "Identity\n";
}

/// The media inside and outside of shapes.
std::string between(const std::string& inside, const std::string& outside) {
  return fmt::format("MediumInterface {} {}\n", pbrt_string(inside), pbrt_string(outside));
}

/// What fills a material's shapes.
void add_interior(const Scene& scene, const Material& material, std::size_t index, PbrtMaterialTexts& made,
                  Losses& losses) {
  if (material.interior.priority != 0)
    losses.add("the priority of a body that overlaps others is left out",
               "the priorities of {} materials of bodies that overlap are left out");
  if (is_black(material.interior.extinction()) || !lets_light_in(material)) return;
  const std::string name = medium_name(made.names[index]);
  made.text += medium_text(scene, name, material.interior);
  made.interior[index] = between(name, made.atmosphere);
}

/// What is clear within something that is not is parted from it: pbrt asks what a ray comes out into.
void add_clear_interiors(const Scene& scene, PbrtMaterialTexts& made) {
  std::string outside = made.atmosphere;
  if (outside.empty()) {
    const auto around = std::find_if(made.interior.begin(), made.interior.end(),
                                     [](const std::string& text) { return !text.empty(); });
    if (around == made.interior.end()) return;
    outside = medium_name(made.names[std::size_t(around - made.interior.begin())]);
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (scene.materials[i].interior.is_clear && !made.names[i].empty())
      made.interior[i] = between("", outside);
}

/// Those of shapes, and those that mixtures of them are made of.
std::vector<bool> used_materials(const Scene& scene) {
  std::vector<bool> used(scene.materials.size());
  for (const ShapeBinding& binding : scene.bindings) used[binding.material] = true;
  for (std::size_t i = used.size(); i > 0; --i)
    if (const auto* mix = std::get_if<Mix>(&scene.materials[i - 1].model); mix && used[i - 1])
      used[mix->first] = used[mix->second] = true;
  return used;
}

}  // namespace

PbrtMaterialTexts pbrt_materials(const Scene& scene, PbrtTextureWriter& textures, SceneOutput& output) {
  PbrtMaterialTexts made;
  made.names.resize(scene.materials.size());
  made.interior.resize(scene.materials.size());
  if (scene.atmosphere != no_material) {
    made.atmosphere = "around all shapes";
    made.view = medium_text(scene, made.atmosphere, scene.materials[scene.atmosphere].interior) +
                between(made.atmosphere, made.atmosphere);
  }
  UniqueNames names;
  const std::vector<bool> used = used_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (!used[i]) continue;
    const PbrtStandIn stand_in = pbrt_stand_in(scene.materials[i], output.losses);
    made.names[i] = names.unique(scene.materials[i].name, fmt::format("material {}", i));
    made.text += fmt::format("MakeNamedMaterial {}{}\n", pbrt_string(made.names[i]),
                             Parameters(stand_in, textures, output, made.names).text());
    add_interior(scene, stand_in.material, i, made, output.losses);
  }
  add_clear_interiors(scene, made);
  return made;
}

}  // namespace twinray
