// SPDX-License-Identifier: Apache-2.0
#include "io/exchange/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "core/alpha_test.h"
#include "core/error.h"
#include "core/film.h"
#include "core/measured_brdf.h"
#include "core/parallel.h"
#include "core/scene_textures.h"
#include "io/exchange/camera.h"
#include "io/exchange/entry.h"
#include "io/exchange/texture.h"
#include "io/input_file.h"
#include "io/measured/brdf_file.h"
#include "io/mesh_scene.h"
#include "io/picture/image_file.h"
#include "io/ply/reader.h"

namespace twinray {
namespace {

SurfaceModel read_model(const Entry& entry) {
  return described_by<SurfaceModel>(
      entry, {Lambert{}, Mirror{}, Refraction{}, Glass{}, Microfacet{}, Dielectric{},
              Dielectric{.is_thin = true}, Conductor{}, DiffuseTransmission{}, RoughDiffuse{},
              CoatedDiffuse{}, CoatedConductor{}, Principled{}, Hair{}, Measured{}, Interface{}, Mix{}});
}

LightSource read_source(const Entry& entry) {
  return described_by<LightSource>(
      entry, {MeshLight{}, SphereLight{}, PointLight{}, SpotLight{}, DirectionalLight{}, AmbientLight{},
              EnvironmentLight{}, GoniometricLight{}, ProjectionLight{}, SunLight{}});
}

bool is_not_negative(const Rgb& pixel) { return at_least_zero(pixel) == pixel; }
/// Of what a mesh emits single channels may be negative.
bool has_luminance(const Rgb& pixel) { return luminance(pixel) >= 0; }

/// Reads one file.
class SceneReader {
 public:
  SceneReader(const std::string& path, const LoadOptions& options, const ExchangeRead& read)
      : path_(path), options_(options), read_(read), warnings_(options.strict) {}

  LoadedScene read(const std::string& text) {
    Entry::read(parse(text), path_, warnings_, [&](const Entry& file) {
      check_version(file);
      loaded_.scene.textures = read_textures(file, path_, options_, warnings_);
      if (file.has("densities")) file.for_each("densities", [&](const Entry& entry) { read_density(entry); });
      read_materials(file);
      if (file.has("atmosphere")) loaded_.scene.atmosphere = file.index("atmosphere");
      if (options_.surfaces_only)
        file.has("lights");  // A known key, though nothing of it is read.
      else
        read_lights(file);
      read_shapes(file);
      assemble({prototypes_, read_instances(file)});
      read_resolution(file);
      file.within("camera", [&](const Entry& entry) {
        const Camera camera = read_exchange_camera(entry, *loaded_.defaults.resolution);
        loaded_.scene.camera = options_.clip_as_file ? camera : without_clip(camera);
      });
      if (file.has("render")) file.within("render", [&](const Entry& entry) { read_render(entry); });
    });
    finish();
    return std::move(loaded_);
  }

 private:
  Json parse(const std::string& text) const {
    try {
      return Json::parse(text);
    } catch (const Json::exception& error) {
      const std::string_view what =
          error.what();  // "[json.exception.parse_error.101] parse error at line 1, ..."
      throw Error(fmt::format("{}: this is no JSON: {}", path_, what.substr(what.find(' ') + 1)));
    }
  }

  void check_version(const Entry& file) const {
    if (!file.has("format") || file.word("format") != "twinray scene")
      file.fail("format", "is not \"twinray scene\": this is another kind of JSON file");
    if (const std::uint32_t version = file.index("version"); version < 1 || version > 4)
      file.fail("version", fmt::format("is {}; versions 1 to 4 are known", version));
  }

  void read_materials(const Entry& file) {
    file.for_each("materials", [&](const Entry& entry) {
      Material material{.name = entry.word("name"), .model = read_model(entry), .textures = {}};
      if (auto* measured = std::get_if<Measured>(&material.model)) read_brdf(entry, *measured);
      if (entry.has("interior"))
        entry.within("interior", [&](const Entry& inside) {
          members(MemberReader(inside), material.interior);
          if (inside.has("density")) material.interior.density = inside.index("density");
          if (inside.has("glow"))
            inside.within("glow", [&](const Entry& glow) { read_glow(glow, material.interior.glow); });
        });
      if (entry.has("subsurface")) {
        if (!may_have_subsurface(material.model))
          entry.fail("subsurface",
                     "belongs to a \"coated_diffuse\" or an \"openpbr\" that is not thin-walled");
        entry.within("subsurface",
                     [&](const Entry& inside) { members(MemberReader(inside), material.subsurface); });
      }
      if (entry.has("textures"))
        entry.for_each("textures", [&](const Entry& each) {
          TextureUse use;
          members(MemberReader(each), use);
          material.textures.push_back(use);
        });
      if (entry.has("normal_map")) material.normal_map = entry.index("normal_map");
      if (entry.has("bump_map")) material.bump_map = entry.index("bump_map");
      if (entry.has("tangent_degrees")) material.tangent_degrees = entry.number("tangent_degrees");
      if (entry.has("tangent_map")) material.tangent_map = entry.index("tangent_map");
      loaded_.scene.materials.push_back(std::move(material));
    });
  }

  void read_brdf(const Entry& entry, Measured& model) const {
    const std::string path = entry.file_beside(path_);
    options_.add_file(path);
    model.brdf = at_place(entry.place(), [&] {
      return std::make_shared<const MeasuredBrdf>(read_brdf_file(read_(path), path));
    });
  }

  template <typename IsRadiance>
  std::shared_ptr<const Image> read_picture(const Entry& entry, const IsRadiance& is_radiance) const {
    const std::string path = entry.file_beside(path_);
    options_.add_file(path);
    const Image image = at_place(entry.place(), [&] { return decode_image(read_(path), path); });
    for (const Rgb& pixel : image.pixels)
      if (!is_finite(pixel) || !is_radiance(pixel))
        entry.fail("file", fmt::format("{} has a pixel that is no radiance", path));
    return std::make_shared<const Image>(image);
  }

  void read_picture(const Entry& entry, MeshLight& light) const {
    light.picture = read_picture(entry, has_luminance);
    picture_members(MemberReader(entry), light);
  }

  void read_glow(const Entry& entry, Glow& glow) const {
    members(MemberReader(entry), glow);
    if (entry.has("factor")) glow.factor = entry.index("factor");
    if (entry.has("temperature")) glow.temperature = entry.index("temperature");
  }

  /// The picture has a grid's slices, one above the other.
  void read_density(const Entry& entry) {
    const Json& sizes = entry.list("size", 3);
    DensityGrid::Size size{};
    for (std::size_t k = 0; k < 3; ++k)
      size[k] = int(entry.whole("size", sizes[k], 1, DensityGrid::most_cells));
    const std::shared_ptr<const Image> picture = read_picture(entry, is_not_negative);
    if (picture->width != size[0] || std::int64_t(picture->height) != std::int64_t(size[1]) * size[2])
      entry.fail("file", fmt::format("has {} x {} pixels; the grid needs {} x {}", picture->width,
                                     picture->height, size[0], std::int64_t(size[1]) * size[2]));
    std::vector<float> values;
    for (const Rgb& pixel : picture->pixels) values.push_back(pixel.r);
    const Transform to_unit = read_transform(entry, "to_unit");
    loaded_.scene.densities.push_back(
        at_place(entry.place(), [&] { return std::make_shared<const DensityGrid>(size, values, to_unit); }));
  }

  void read_lights(const Entry& file) {
    file.for_each("lights", [&](const Entry& entry) {
      Light light{entry.word("name"), read_source(entry)};
      if (auto* mesh = std::get_if<MeshLight>(&light.source); mesh && entry.has("file"))
        read_picture(entry, *mesh);
      else if (auto* environment = std::get_if<EnvironmentLight>(&light.source))
        environment->map = read_picture(entry, is_not_negative);
      else if (auto* goniometric = std::get_if<GoniometricLight>(&light.source))
        goniometric->map = read_picture(entry, is_not_negative);
      else if (auto* projection = std::get_if<ProjectionLight>(&light.source))
        projection->picture = read_picture(entry, is_not_negative);
      loaded_.scene.lights.push_back(std::move(light));
    });
  }

  static SphereSet read_spheres(const Entry& entry) {
    SphereSet set{.name = entry.word("name"), .spheres = {}};
    for (const Json& each : entry.list("spheres")) {
      if (!each.is_array() || each.size() != 4) entry.fail("spheres", "must be lists of 4 numbers");
      const auto at = [&](std::size_t i) { return entry.number("spheres", each[i]); };
      set.spheres.push_back({{at(0), at(1), at(2)}, entry.number("spheres", each[3], Valid::not_negative)});
    }
    return set;
  }

  /// A mesh whose triangles are yet to be read.
  struct PendingMesh {
    std::size_t shape;
    std::string path;
    std::string place;  ///< In the file.
    MeshRepairs repairs = {};
  };

  void read_shapes(const Entry& file) {
    file.for_each("shapes", [&](const Entry& entry) {
      const std::string type = entry.word("type");
      if (type == "mesh") {
        meshes_.push_back(
            {.shape = shapes_.size(), .path = entry.file_beside(path_), .place = entry.place()});
        shapes_.emplace_back(Mesh{.name = entry.word("name")});
      } else if (type == "spheres") {
        shapes_.emplace_back(read_spheres(entry));
      } else {
        entry.fail("type", fmt::format("is \"{}\"; valid are mesh, spheres", type));
      }
      ShapeBinding binding{.material = entry.index("material")};
      if (entry.has("light") && !options_.surfaces_only) binding.light = entry.index("light");
      if (entry.has("alpha")) binding.alpha = alpha_of(entry);
      if (entry.has("asset")) binding.asset = asset_of(entry.word("asset"));
      loaded_.scene.bindings.push_back(binding);
      note_prototype(entry);
    });
    for (const PendingMesh& mesh : meshes_) options_.add_file(mesh.path);
    parallel_for(meshes_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) read_mesh(meshes_[i]);
    });
  }

  /// The texture that cuts holes into a shape; checked here, for the geometry looks it up.
  std::uint32_t alpha_of(const Entry& entry) const {
    const std::uint32_t index = entry.index("alpha");
    const std::size_t count = loaded_.scene.textures.size();
    if (index >= count) entry.fail("alpha", fmt::format("is {}; there are {} textures", index, count));
    return index;
  }

  /// The number of the asset of this name.
  std::uint32_t asset_of(const std::string& name) {
    std::vector<std::string>& assets = loaded_.scene.assets;
    const auto [asset, is_new] = assets_.try_emplace(name, std::uint32_t(assets.size()));
    if (is_new) assets.push_back(name);
    return asset->second;
  }

  /// Shapes of a prototype follow each other, behind those of the scene.
  void note_prototype(const Entry& entry) {
    const auto shape = std::uint32_t(shapes_.size() - 1);
    if (!entry.has("prototype")) {
      if (!prototypes_.empty()) entry.fail("stands behind shapes of prototypes, and is of none");
      return;
    }
    const std::uint32_t prototype = entry.index("prototype");
    if (prototypes_.empty() ? prototype != 0
                            : prototype != prototypes_.size() && prototype + 1 != prototypes_.size())
      entry.fail("prototype",
                 fmt::format("is {}; the shapes of prototypes follow each other, from 0 on", prototype));
    if (prototype == prototypes_.size()) prototypes_.push_back({shape, 0});
    ++prototypes_.back().count;
  }

  void read_mesh(PendingMesh& pending) {
    Mesh& mesh = std::get<Mesh>(shapes_[pending.shape]);
    std::string name = std::move(mesh.name);
    mesh = at_place(pending.place, [&] { return read_ply(read_(pending.path), pending.path).mesh; });
    mesh.name = std::move(name);
    // Normals that need none keep their bits.
    if (std::all_of(mesh.normals.begin(), mesh.normals.end(), is_unit))
      pending.repairs.dropped_triangles = drop_degenerate_triangles(mesh);
    else
      repair_mesh(mesh, pending.repairs);
  }

  void assemble(Instancing instancing) {
    Scene& scene = loaded_.scene;
    at_place(path_, [&] {
      check_textures(scene.textures);
      scene.geometry = std::make_shared<const Geometry>(
          cut_out(std::move(shapes_), scene.bindings, scene.textures, std::move(instancing)));
      check_scene(scene);
    });
    if (!options_.surfaces_only) check_emitters();
  }

  /// Shapes that emit and their lights name each other.
  void check_emitters() const {
    const Scene& scene = loaded_.scene;
    std::vector<std::uint32_t> lights(scene.bindings.size(), no_light);
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
      const auto* mesh = std::get_if<MeshLight>(&scene.lights[i].source);
      const auto* sphere = std::get_if<SphereLight>(&scene.lights[i].source);
      if (mesh || sphere) lights[mesh ? mesh->shape : sphere->shape] = i;
    }
    for (std::size_t shape = 0; shape < lights.size(); ++shape)
      if (scene.bindings[shape].light != lights[shape])
        throw Error(
            fmt::format("{}: shapes[{}]: its \"light\" must be the one whose \"shape\" it is", path_, shape));
  }

  static Transform read_transform(const Entry& entry, const char* key) {
    Transform transform;
    const Json& rows = entry.list(key, 3);
    for (std::size_t row = 0; row < 3; ++row) {
      if (!rows[row].is_array() || rows[row].size() != 4) entry.fail(key, "must be 3 rows of 4 numbers");
      for (std::size_t column = 0; column < 4; ++column)
        transform.m[row][column] = entry.real(key, rows[row][column]);
    }
    return transform;
  }

  std::vector<Instance> read_instances(const Entry& file) const {
    std::vector<Instance> instances;
    if (!file.has("instances")) return instances;
    file.for_each("instances", [&](const Entry& entry) {
      instances.push_back({entry.index("prototype"), read_transform(entry, "to_world")});
    });
    return instances;
  }

  void read_resolution(const Entry& file) {
    constexpr std::uint32_t most = 65536;
    const Json& list = file.list("resolution", 2);
    loaded_.defaults.resolution = {int(file.whole("resolution", list[0], 1, most)),
                                   int(file.whole("resolution", list[1], 1, most))};
  }

  /// What the file says of the picture besides its size.
  void read_render(const Entry& entry) {
    RenderDefaults& defaults = loaded_.defaults;
    constexpr std::uint32_t most_events = 100;
    if (entry.has("samples"))
      defaults.samples = entry.whole("samples", entry.at("samples"), 1, Film::max_samples);
    if (entry.has("max_depth"))
      defaults.max_depth = int(entry.whole("max_depth", entry.at("max_depth"), 0, most_events));
    if (entry.has("crop")) read_crop(entry);
    if (entry.has("daylight_kelvin")) read_white(entry);
    if (!entry.has("filter")) return;
    PixelFilter filter;
    entry.within("filter", [&](const Entry& described) { members(MemberReader(described), filter); });
    at_place(entry.place() + ".filter", [&] { check(filter); });
    defaults.filter = filter;
  }

  void read_white(const Entry& entry) {
    const double kelvin = entry.real("daylight_kelvin", entry.at("daylight_kelvin"));
    if (!(kelvin >= least_white_kelvin && kelvin <= most_white_kelvin))
      entry.fail("daylight_kelvin", fmt::format("is {:g}; valid are {:g} to {:g}", kelvin, least_white_kelvin,
                                                most_white_kelvin));
    loaded_.defaults.daylight_kelvin = kelvin;
  }

  /// A part of the resolution, which is known.
  void read_crop(const Entry& entry) {
    const auto [width, height] = *loaded_.defaults.resolution;
    const Json& list = entry.list("crop", 4);
    std::array<int, 4> crop;
    for (std::size_t i = 0; i < 4; ++i) crop[i] = int(entry.whole("crop", list[i], i < 2 ? 0 : 1, 65536));
    if (crop[0] + crop[2] > width || crop[1] + crop[3] > height)
      entry.fail(fmt::format("\"crop\" is not a part of {} x {} pixels", width, height));
    loaded_.defaults.crop = crop;
  }

  void finish() {
    SceneSummary& summary = loaded_.summary;
    loaded_.warnings = warnings_.items();
    summary.unit_name.clear();
    summary.camera = "camera";
    summary.cameras = {"camera"};
    for (const PendingMesh& mesh : meshes_) summary.dropped_triangles += mesh.repairs.dropped_triangles;
    count_scene(loaded_.scene, summary);
  }

  const std::string path_;
  const LoadOptions& options_;
  const ExchangeRead& read_;
  WarningList warnings_;
  LoadedScene loaded_;
  std::vector<Shape> shapes_;
  std::vector<PendingMesh> meshes_;
  std::vector<ShapeRange> prototypes_;
  std::map<std::string, std::uint32_t> assets_;  ///< The numbers of their names.
};

}  // namespace

LoadedScene read_exchange(const std::string& json, const std::string& path, const LoadOptions& options,
                          const ExchangeRead& read) {
  return SceneReader(path, options, read).read(json);
}

LoadedScene load_exchange(const std::string& path, const LoadOptions& options) {
  options.add_file(path);
  return read_exchange(read_input_file(path, "scene file"), path, options,
                       [](const std::string& file) { return read_input_file(file, "file of a scene"); });
}

}  // namespace twinray
