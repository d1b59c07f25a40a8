// SPDX-License-Identifier: Apache-2.0
// What holds for the statements that follow: pbrt's graphics state, which AttributeBegin saves.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/pbrt/light.h"
#include "io/pbrt/medium.h"
#include "io/pbrt/parser.h"
#include "io/pbrt/transform.h"

namespace twinray {

/// What Attribute statements give defaults to.
enum class PbrtTarget { shape, light, material, medium, texture };

/// Where something that moves stands at the beginning and at the end (TransformTimes).
struct PbrtMotion {
  Transform start, end;
};

/// From object to world space (before WorldBegin: from world to camera space).
struct PbrtSpace {
  Transform transform;               ///< At the time that is shown.
  std::optional<PbrtMotion> motion;  ///< None of what stands still.
};

struct PbrtState {
  PbrtSpace space;
  /// Transforms change where all stands at the beginning, and at the end.
  bool is_start_active = true, is_end_active = true;
  bool is_reversed = false;
  std::uint32_t material = 0;
  PbrtMediumPointer medium_inside, medium_outside;  ///< Of closed shapes (MediumInterface).
  std::shared_ptr<const PbrtAreaLight> area_light;
  PbrtColorSpace color_space = PbrtColorSpace::srgb;
  std::array<std::shared_ptr<const PbrtParameters>, 5> defaults;  ///< By PbrtTarget.
};

/// The state, those that were saved, and the coordinate systems that have a name.
class PbrtStates {
 public:
  PbrtState& now() { return now_; }
  const PbrtState& now() const { return now_; }

  /// At a time or, as long as no shutter opens, at the beginning.
  explicit PbrtStates(std::optional<double> time) : time_(time) {}

  /// Changes the transform as a statement says, and returns whether the statement is one that does. Throws
  /// Error where it means no transform.
  bool take_transform(const PbrtStatement& statement, WarningList& warnings);
  const Transform& present() const { return now_.space.transform; }
  /// What follows is at this time, if no other one was asked for.
  void open_shutter(double time) { time_ = time_.value_or(time); }
  /// Something stands there.
  void place() { moves_ = moves_ || now_.space.motion; }
  /// From camera to world space, of a camera whose transform from world to camera space is the present one:
  /// what moves moves in the world. Nothing where it flattens.
  std::optional<Transform> camera_transform() const {
    const auto space = camera_space();
    return space ? std::optional(space->transform) : std::nullopt;
  }
  /// When what moves begins to and ends, in seconds; nothing where all has stood still so far.
  std::optional<std::pair<double, double>> times() const {
    return moves_ ? std::optional(std::pair(first_, last_)) : std::nullopt;
  }
  /// Adds an Attribute statement's parameters to the defaults of what it names.
  void add_defaults(const PbrtStatement& statement);
  /// Warns of those that none of the statements knew for which they were.
  void warn_of_unused_defaults(WarningList& warnings) const;
  const std::shared_ptr<const PbrtParameters>& defaults(PbrtTarget target) const {
    return now_.defaults[std::size_t(target)];
  }

  /// Saves the state for the statement that ends what this one begins.
  void begin(const PbrtStatement& statement);
  /// Goes back to the state that `begins` (a statement's name) saved. Throws Error where it was another one,
  /// or none.
  void end(const PbrtStatement& statement, PbrtDirective begins);
  /// Throws Error, at the statement that saved it, where a state was not gone back to.
  void check_ended() const;

  /// Names the space of a camera whose transform from world to camera space is the present one.
  void name_camera();
  /// The transform is the identity from here on, and the world has this space.
  void begin_world();

 private:
  struct Saved {
    PbrtState state;
    PbrtDirective directive;
    std::string_view name;
    PbrtPlace place;
  };

  std::optional<PbrtSpace> camera_space() const;
  /// Of the way from the beginning to the end, at the time that is shown.
  double part() const;
  void move(const PbrtMotion& motion);
  void stand(const PbrtSpace& space);
  template <typename Change>
  void change(const Change& change);

  std::optional<double> time_;
  double first_ = 0, last_ = 1;  ///< TransformTimes.
  bool moves_ = false;           ///< Whether something that was placed so far does.
  PbrtState now_;
  std::vector<Saved> saved_;
  std::vector<PbrtParameters> attributes_;  ///< Of each Attribute statement.
  std::map<std::string, PbrtSpace> systems_;
};

}  // namespace twinray
