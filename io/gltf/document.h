// SPDX-License-Identifier: Apache-2.0
// A glTF file as tinygltf's values, whose types, ranges and indices were checked before, and the bytes of its
// buffers.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/context.h"
#include "io/gltf/schema.h"

namespace tinygltf {
class Model;
}

namespace twinray {

class GltfDocument {
 public:
  /// Takes the bytes of a .gltf or .glb file. Throws Error.
  GltfDocument(std::string bytes, GltfContext& context);
  ~GltfDocument();

  const tinygltf::Model& model() const { return *model_; }
  GltfContext& context() const { return context_; }
  const std::vector<CheckedGltf::Source>& images() const { return images_; }

  /// The bytes of a buffer view, decompressed where EXT_meshopt_compression says so. Throws Error, with the
  /// place, where its buffer cannot be read or ends before it.
  std::string_view buffer_view(std::size_t index);
  /// Of the file and of what was read and decompressed so far, whatever it says of the rest: what a count may
  /// rely on.
  std::size_t byte_count() const { return byte_count_; }

 private:
  std::string_view buffer(std::size_t index);
  std::string_view part_of(std::size_t buffer, std::size_t offset, std::size_t length,
                           const std::string& pointer);
  std::string_view decompressed(std::size_t view);

  GltfContext& context_;
  std::unique_ptr<tinygltf::Model> model_;
  std::vector<CheckedGltf::Source> sources_, images_;
  std::vector<std::optional<std::string>> buffers_, views_;  ///< Those that were read or decompressed.
  std::optional<std::string> binary_chunk_;
  std::size_t byte_count_ = 0;
};

}  // namespace twinray
