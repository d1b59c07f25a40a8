// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/subsurface.h"
#include "core/textured_material.h"
#include "io/measured/brdf_file.h"
#include "io/output_file.h"
#include "io/pbrt/stand_in.h"
#include "io/pbrt/text.h"

namespace twinray {
namespace {

using enum MaterialInput;

/// The files of what was measured.
using BrdfFiles = std::map<const MeasuredBrdf*, std::string>;

/// The parameters of one material.
class Parameters {
 public:
  Parameters(const PbrtStandIn& made, PbrtTextureWriter& textures, BrdfFiles& brdf_files, SceneOutput& output,
             const std::vector<std::string>& names)
      : material_(made.material),
        made_(made),
        textures_(textures),
        brdf_files_(brdf_files),
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
    const bool is_body = has_subsurface(material_);
    type(is_body ? "subsurface" : "coateddiffuse");
    color("reflectance", reflectance,
          is_body ? emerging_of_base(model, model.reflectance) : model.reflectance);
    if (is_body)
      text_ += pbrt_rgb("mfp", material_.subsurface.radius) + pbrt_real("g", material_.subsurface.anisotropy);
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
  void add(const Measured& model) {
    type("measured");
    if (model.brdf->folds() > 1)
      output_.losses.add(
          "a material that was measured from a part of the azimuths is written as it is: pbrt "
          "refuses it",
          "{} materials that were measured from a part of the azimuths are written as they are: "
          "pbrt refuses them");
    std::string& file = brdf_files_[model.brdf.get()];
    if (file.empty())
      file = output_.add(fmt::format("-{}.bsdf", brdf_files_.size()),
                         [brdf = model.brdf](const std::string& path) {
                           write_file(path, brdf_file_bytes(*brdf, BrdfColors::spectra));
                         });
    text_ += pbrt_word("filename", file);
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
  BrdfFiles& brdf_files_;
  SceneOutput& output_;
  const std::vector<std::string>& names_;
  std::vector<TextureUse> uses_;  ///< Those that are not written yet.
  bool is_remapped_ = false;
  std::string text_;
};

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
  UniqueNames names;
  BrdfFiles brdf_files;
  const std::vector<bool> used = used_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (!used[i]) continue;
    const PbrtStandIn stand_in = pbrt_stand_in(scene.materials[i], output.losses);
    made.names[i] = names.unique(scene.materials[i].name, fmt::format("material {}", i));
    made.text += fmt::format("MakeNamedMaterial {}{}\n", pbrt_string(made.names[i]),
                             Parameters(stand_in, textures, brdf_files, output, made.names).text());
  }
  return made;
}

}  // namespace twinray
