// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/state.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/quaternion.h"

namespace twinray {
namespace {

using enum PbrtDirective;

Transform required(const std::optional<Transform>& t, const PbrtStatement& statement, const char* otherwise) {
  if (!t) statement.place.fail(otherwise);
  return *t;
}

Transform rotation(const PbrtStatement& statement) {
  const auto& n = statement.numbers;
  const Vec3 axis{float(n[1]), float(n[2]), float(n[3])};
  if (!(length(axis) > 0)) statement.place.fail("Rotate about 0 0 0; the axis needs a length");
  return Transform::rotation(axis, n[0]);
}

constexpr std::array<std::string_view, 5> targets{"shape", "light", "material", "medium", "texture"};

bool is_transform(PbrtDirective directive) {
  constexpr std::array directives{identity, translate, scale, rotate, look_at, transform, concat_transform};
  return std::find(directives.begin(), directives.end(), directive) != directives.end();
}

/// What a statement multiplies the transform with.
Transform factor_of(const PbrtStatement& statement) {
  const auto& n = statement.numbers;
  constexpr const char* not_affine =
      "this matrix is not affine: of its four columns the last numbers must be 0, 0, 0 and 1";
  switch (statement.directive) {
    case translate:
      return Transform::translation(n[0], n[1], n[2]);
    case scale:
      return Transform::scaling(n[0], n[1], n[2]);
    case rotate:
      return rotation(statement);
    case look_at:
      return required(twinray::look_at(n), statement,
                      "LookAt needs two points apart, and an up direction that is not the view's");
    case transform:
    case concat_transform:
      return required(affine(n), statement, not_affine);
    default:
      return {};
  }
}

}  // namespace

double PbrtStates::part() const {
  if (!time_ || *time_ <= first_) return 0;
  return *time_ < last_ ? (*time_ - first_) / (last_ - first_) : 1;
}

void PbrtStates::move(const PbrtMotion& motion) {
  if (motion.start == motion.end) {
    now_.space = {motion.start, {}};
    return;
  }
  now_.space = {interpolated(motion.start, motion.end, part()), motion};
}

void PbrtStates::stand(const PbrtSpace& space) {
  if (space.motion)
    move(*space.motion);  // It may have been named before the time was known.
  else
    now_.space = space;
}

template <typename Change>
void PbrtStates::change(const Change& change) {
  PbrtSpace& space = now_.space;
  if (!space.motion && now_.is_start_active && now_.is_end_active) {
    space.transform = change(space.transform);
    return;
  }
  PbrtMotion motion = space.motion.value_or(PbrtMotion{space.transform, space.transform});
  if (now_.is_start_active) motion.start = change(motion.start);
  if (now_.is_end_active) motion.end = change(motion.end);
  move(motion);
}

bool PbrtStates::take_transform(const PbrtStatement& statement, WarningList& warnings) {
  switch (statement.directive) {
    case active_transform:
      if (statement.words[0] != "All" && statement.words[0] != "StartTime" && statement.words[0] != "EndTime")
        statement.place.fail(
            fmt::format("ActiveTransform {} is not known; valid are StartTime, EndTime and "
                        "All",
                        statement.words[0]));
      now_.is_start_active = statement.words[0] != "EndTime";
      now_.is_end_active = statement.words[0] != "StartTime";
      return true;
    case transform_times:
      first_ = statement.numbers[0], last_ = statement.numbers[1];
      return true;
    case coordinate_system:
      systems_[statement.words[0]] = now_.space;
      return true;
    case coord_sys_transform:
      if (const auto found = systems_.find(statement.words[0]); found != systems_.end())
        stand(found->second);
      else
        statement.place.warn(warnings, fmt::format("no coordinate system \"{}\" was named before; the "
                                                   "transform stays as it is",
                                                   statement.words[0]));
      return true;
    default:
      break;
  }
  if (!is_transform(statement.directive)) return false;
  const Transform factor = factor_of(statement);
  const bool is_anew = statement.directive == identity || statement.directive == transform;
  change([&](const Transform& before) { return is_anew ? factor : before * factor; });
  return true;
}

void PbrtStates::add_defaults(const PbrtStatement& statement) {
  const auto found = std::find(targets.begin(), targets.end(), statement.words[0]);
  if (found == targets.end())
    statement.place.fail(
        fmt::format("Attribute \"{}\" is not known; valid are {}", statement.words[0], list_names(targets)));
  auto& defaults = now_.defaults[std::size_t(found - targets.begin())];
  auto more = std::make_shared<PbrtParameters>();
  if (defaults) more->append(*defaults);
  attributes_.push_back(statement.parameters);
  attributes_.back().watch();
  more->append(attributes_.back());
  defaults = std::move(more);
}

void PbrtStates::warn_of_unused_defaults(WarningList& warnings) const {
  for (const PbrtParameters& parameters : attributes_) parameters.warn_of_unused_defaults(warnings);
}

void PbrtStates::begin(const PbrtStatement& statement) {
  saved_.push_back({now_, statement.directive, statement.name, statement.place});
}

void PbrtStates::end(const PbrtStatement& statement, PbrtDirective begins) {
  if (saved_.empty()) statement.place.fail(fmt::format("{} ends what nothing began", statement.name));
  const Saved& last = saved_.back();
  if (last.directive != begins && begins == import_begin) check_ended();
  if (last.directive != begins)
    statement.place.fail(fmt::format("{} stands where the {} of line {} of {} should be ended first",
                                     statement.name, last.name, last.place.line, last.place.file->name));
  now_ = last.state;
  saved_.pop_back();
}

void PbrtStates::check_ended() const {
  if (saved_.empty()) return;
  const Saved& last = saved_.back();
  last.place.fail(fmt::format("this {} has no end", last.name));
}

std::optional<PbrtSpace> PbrtStates::camera_space() const {
  const PbrtSpace& space = now_.space;
  if (!space.motion) {
    const auto to_world = inverse(space.transform);
    return to_world ? std::optional(PbrtSpace{*to_world, {}}) : std::nullopt;
  }
  const auto start = inverse(space.motion->start), end = inverse(space.motion->end);
  if (!start || !end) return {};
  return PbrtSpace{interpolated(*start, *end, part()), PbrtMotion{*start, *end}};
}

void PbrtStates::name_camera() {
  if (const auto to_world = camera_space()) systems_["camera"] = *to_world;
}

void PbrtStates::begin_world() {
  now_.space = {};
  now_.is_start_active = now_.is_end_active = true;
  systems_["world"] = {};
}

}  // namespace twinray
