// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <tuple>

#include "io/picture/loaded_texture.h"
#include "io/picture/picture_meaning.h"

namespace twinray {

/// The pictures of a scene that is read for one moment after the other: of each file they are read once. Used
/// by one thread.
class KnownPictures {
 public:
  /// What `read()` gives: asked once for each picture, and whether a normal map is to stand for it.
  template <typename Read>
  const LoadedTexture& of(const PictureUse& picture, bool is_normal_map, const Read& read) {
    const auto& [path, meaning] = picture;
    const Key key(path, meaning.role, meaning.channels, is_normal_map);
    const auto found = textures_.find(key);
    return found != textures_.end() ? found->second : textures_.emplace(key, read()).first->second;
  }

 private:
  using Key = std::tuple<std::string, PictureRole, PictureChannels, bool>;
  std::map<Key, LoadedTexture> textures_;
};

}  // namespace twinray
