// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/instance_use.h"
#include "io/interpretation.h"
#include "io/picture/picture_meaning.h"

namespace twinray {

class KnownPictures;
class TextureStore;

/// What a reader of scene files makes of a file where more than one reading is sensible.
struct LoadOptions {
  bool strict = false;              ///< Whatever would be a warning is an Error.
  bool keep_both_lamps = false;     ///< Undoes the one-lamp rule (io/collada/lamp.h).
  std::string camera_name = {};     ///< Of the camera to see by, or its node; empty: the file's choice.
  std::optional<double> time = {};  ///< In seconds, when what moves is seen; none: as it rests.
  InstanceUse instances = InstanceUse::automatic;
  bool clip_as_file = false;  ///< The camera has the file's <znear> and <zfar>; else it sees any distance.
  /// A point or spot light without attenuation elements does not fall off, which is COLLADA's default; else
  /// it falls off with the squared distance.
  bool attenuation_as_file = false;
  Interpretation interpretation = Interpretation::standard;
  /// Leaves the lights out, and the shapes that area lights add to the scene: what CS184's picture of normals
  /// shows.
  bool surfaces_only = false;
  /// Not null: the files that are read are added here, each once or more often, those of pictures too.
  std::shared_ptr<std::vector<std::string>> files = {};
  /// Not null: pictures of surfaces are not read, but added here.
  std::shared_ptr<std::vector<PictureUse>> pictures = {};
  std::shared_ptr<TextureStore> textures = {};  ///< Keeps the pictures of surfaces; null: all in memory.

  std::shared_ptr<KnownPictures> known = {};  ///< Not null: keeps what was read for the next time.

  void add_file(const std::string& path) const {
    if (files && !path.empty()) files->push_back(path);
  }
};

}  // namespace twinray
