// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "io/default_camera.h"
#include "io/gzip.h"
#include "io/input_file.h"
#include "io/pbrt/builder.h"

namespace twinray {
namespace {

using enum PbrtDirective;

constexpr std::array before_world{accelerator,  camera,  film,           integrator,
                                  pixel_filter, sampler, transform_times};
constexpr std::array of_picture{camera, film, integrator, pixel_filter, sampler};
constexpr std::array within_world{
    area_light_source, attribute_begin, attribute_end, light_source,    make_named_material, material,
    named_material,    object_begin,    object_end,    object_instance, reverse_orientation, shape,
    texture,           import_begin};

constexpr std::array placed{camera, light_source, make_named_medium, object_instance, shape, texture};

template <std::size_t n>
bool is_among(PbrtDirective directive, const std::array<PbrtDirective, n>& list) {
  return std::find(list.begin(), list.end(), directive) != list.end();
}

/// The reader: each statement goes to whom it concerns.
class Reader {
 public:
  explicit Reader(PbrtContext& context)
      : context_(context), builder_(context), states_(context.options.time) {}

  void take(PbrtStatement& statement) {
    check_block(statement);
    statement.parameters.color_space = states_.now().color_space;
    if (states_.take_transform(statement, context_.warnings)) return;
    if (is_among(statement.directive, placed)) states_.place();
    if (take_state(statement) || take_view(statement)) return;
    take_world(statement);
  }

  /// At the end of the file.
  LoadedScene finish(const PbrtPlace& end) {
    states_.check_ended();
    if (!is_world_) end.fail("the file ends before WorldBegin: it describes no scene");
    LoadedScene loaded = builder_.finish(float(camera_.shutter.length()) * film_.iso / 100);
    states_.warn_of_unused_defaults(context_.warnings);
    loaded.summary.unit_name.clear();
    loaded.defaults = film_.defaults;
    loaded.scene.camera = camera_.is_given ? place_camera(camera_, film_, context_)
                                           : default_camera(loaded.scene.geometry->bounds());
    if (camera_.is_given) loaded.summary.camera = camera_.kind();
    if (camera_.is_given) loaded.summary.cameras.push_back(camera_.kind());
    if (const auto times = states_.times()) {
      loaded.summary.animation = AnimationSummary{times->first, times->second, context_.options.time, {}};
      if (!context_.options.time) loaded.summary.animation->shutter = camera_.shutter;
      loaded.defaults.shutter = camera_.shutter;
    }
    return loaded;
  }

 private:
  void check_block(const PbrtStatement& statement) const {
    if (is_world_ && is_among(statement.directive, before_world))
      statement.place.fail(fmt::format("{} belongs before WorldBegin", statement.name));
    if (is_world_ && statement.directive == world_begin)
      statement.place.fail("WorldBegin stands there a second time: a file describes one scene");
    if (!is_world_ && is_among(statement.directive, within_world))
      statement.place.fail(fmt::format("{} belongs behind WorldBegin", statement.name));
  }

  /// Statements that change what others mean.
  bool take_state(const PbrtStatement& statement) {
    switch (statement.directive) {
      case attribute_begin:
      case transform_begin:
      case import_begin:
        states_.begin(statement);
        return true;
      case attribute_end:
        states_.end(statement, attribute_begin);
        return true;
      case transform_end:
        states_.end(statement, transform_begin);
        return true;
      case import_end:
        states_.end(statement, import_begin);
        return true;
      case object_begin:
        states_.begin(statement);
        builder_.begin_object(statement.words[0], statement.place);
        return true;
      case object_end:
        states_.end(statement, object_begin);
        builder_.end_object();
        return true;
      case reverse_orientation:
        states_.now().is_reversed = !states_.now().is_reversed;
        return true;
      case attribute:
        states_.add_defaults(statement);
        return true;
      case color_space:
        set_color_space(statement);
        return true;
      default:
        return false;
    }
  }

  void set_color_space(const PbrtStatement& statement) {
    const auto space = color_space_named(statement.words[0]);
    if (!space)
      statement.place.fail(
          fmt::format("there is no color space \"{}\"; valid are srgb, dci-p3, rec2020 and "
                      "aces2065-1",
                      statement.words[0]));
    states_.now().color_space = *space;
  }

  /// Of the statements about the picture the last one of a kind counts.
  void note_again(const PbrtStatement& statement) {
    const auto [entry, is_new] = views_.try_emplace(statement.directive, statement.place);
    if (is_new) return;
    statement.place.warn(
        context_.warnings,
        fmt::format("a further {}: it replaces that of line {}{}", statement.name, entry->second.line,
                    entry->second.file == statement.place.file ? "" : " of " + entry->second.file->name));
    entry->second = statement.place;
  }

  /// Statements about the picture.
  bool take_view(const PbrtStatement& statement) {
    const PbrtParameters& parameters = statement.parameters;
    if (is_among(statement.directive, of_picture)) note_again(statement);
    switch (statement.directive) {
      case camera:
        camera_ = read_camera(statement.words[0], parameters, context_);
        states_.open_shutter(camera_.shutter.open);
        camera_.to_world = states_.camera_transform();
        builder_.place_camera(camera_.to_world ? camera_.to_world->point({0, 0, 0}) : Vec3{},
                              states_.now().medium_outside);
        states_.name_camera();
        return true;
      case film: {
        const RenderDefaults before = film_.defaults;
        film_ = read_film(statement.words[0], parameters, context_);
        film_.defaults.samples = before.samples, film_.defaults.max_depth = before.max_depth;
        film_.defaults.filter = before.filter;
        return true;
      }
      case sampler:
        read_sampler(statement.words[0], parameters, film_.defaults, context_);
        return true;
      case integrator:
        read_integrator(statement.words[0], parameters, film_.defaults, context_);
        return true;
      case pixel_filter:
        read_filter(statement.words[0], parameters, film_.defaults, context_);
        return true;
      case accelerator:
      case option:
        return true;  // about pbrt's own work
      default:
        return false;
    }
  }

  void take_world(PbrtStatement& statement) {
    const std::string& type = statement.words.empty() ? none_ : statement.words[0];
    PbrtParameters& parameters = statement.parameters;
    PbrtState& state = states_.now();
    switch (statement.directive) {
      case world_begin:
        is_world_ = true;
        states_.begin_world();
        break;
      case shape:
        parameters.set_defaults(states_.defaults(PbrtTarget::shape));
        builder_.add_shape(type, parameters, state);
        break;
      case light_source:
        parameters.set_defaults(states_.defaults(PbrtTarget::light));
        builder_.add_light(type, parameters, state);
        break;
      case area_light_source:
        parameters.set_defaults(states_.defaults(PbrtTarget::light));
        state.area_light = std::make_shared<const PbrtAreaLight>(read_area_light(type, parameters, context_));
        break;
      case material:
        parameters.set_defaults(states_.defaults(PbrtTarget::material));
        state.material = builder_.materials().add(type, parameters);
        break;
      case make_named_material:
        parameters.set_defaults(states_.defaults(PbrtTarget::material));
        builder_.materials().add_named(type, parameters);
        break;
      case named_material:
        state.material = builder_.materials().named(type, statement.place);
        break;
      case texture:
        parameters.set_defaults(states_.defaults(PbrtTarget::texture));
        builder_.materials().textures.define(
            type, statement.words[1],
            {.texture_class = statement.words[2], .parameters = parameters, .to_world = states_.present()});
        break;
      case make_named_medium:
        parameters.set_defaults(states_.defaults(PbrtTarget::medium));
        builder_.media().define(type, parameters, states_.present());
        break;
      case medium_interface:
        state.medium_inside = builder_.media().named(statement.words.front(), statement.place);
        state.medium_outside = builder_.media().named(statement.words.back(), statement.place);
        break;
      case object_instance:
        builder_.add_instance(type, states_.present(), statement.place);
        break;
      default:
        break;
    }
  }

  PbrtContext& context_;
  PbrtBuilder builder_;
  PbrtStates states_;
  PbrtCamera camera_;
  PbrtFilm film_{.defaults = {.filter = usual_filter(FilterKind::gaussian)}};  ///< pbrt's own filter.
  std::map<PbrtDirective, PbrtPlace> views_;  ///< Where the last statement of each kind stands.
  const std::string none_;
  bool is_world_ = false;
};

}  // namespace

LoadedScene read_pbrt(std::string text, const std::string& name, const LoadOptions& options,
                      PbrtFiles::Read read) {
  PbrtContext context{PbrtFiles(name, std::move(read), options), options};
  PbrtParser parser({name, std::move(text)}, context.files);
  Reader reader(context);
  PbrtStatement statement;
  while (parser.next(statement)) reader.take(statement);
  LoadedScene loaded = reader.finish(statement.place);
  loaded.warnings = context.warnings.items();
  loaded.summary.notes = std::move(context.notes);
  return loaded;
}

LoadedScene load_pbrt(const std::string& path, const LoadOptions& options) {
  options.add_file(path);
  std::string text = read_input_file(path, "scene file");
  return read_pbrt(is_gzip(text) ? unpack_gzip(text, path) : std::move(text), path, options);
}

}  // namespace twinray
