// SPDX-License-Identifier: Apache-2.0
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include "io/gltf/document.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "io/gltf/container.h"
#include "io/gltf/meshopt.h"
#include "io/gltf/uri.h"

namespace twinray {

GltfDocument::GltfDocument(std::string bytes, GltfContext& context)
    : context_(context), model_(std::make_unique<tinygltf::Model>()) {
  GltfContainer container = open_gltf(std::move(bytes), context);
  CheckedGltf checked = check_gltf(container.json, context);
  sources_ = std::move(checked.buffers);
  images_ = std::move(checked.images);
  binary_chunk_ = std::move(container.buffer);
  byte_count_ = container.json.size() + (binary_chunk_ ? binary_chunk_->size() : 0);
  std::string error, warning;
  tinygltf::TinyGLTF reader;
  if (!reader.LoadASCIIFromString(model_.get(), &error, &warning, checked.json.data(),
                                  unsigned(checked.json.size()), ""))
    throw error_at({context.file}, "not a glTF file: " + error);
  buffers_.resize(sources_.size());
  views_.resize(model_->bufferViews.size());
}

GltfDocument::~GltfDocument() = default;

std::string_view GltfDocument::buffer(std::size_t index) {
  if (buffers_[index]) return *buffers_[index];
  const CheckedGltf::Source& source = sources_[index];
  const std::string pointer = fmt::format("/buffers/{}", index);
  if (!source.uri.empty()) {
    buffers_[index] = bytes_of_uri(source.uri, pointer + "/uri", context_);
    byte_count_ += buffers_[index]->size();
  } else if (index == 0 && binary_chunk_) {
    buffers_[index] = std::move(*binary_chunk_);
  } else {
    context_.fail(pointer, "the buffer has no \"uri\", and is not the first one of a binary file (.glb)");
  }
  if (buffers_[index]->size() < source.byte_length)
    context_.fail(pointer, fmt::format("the buffer has {} bytes, and its byteLength is {}",
                                       buffers_[index]->size(), source.byte_length));
  return *buffers_[index];
}

std::string_view GltfDocument::part_of(std::size_t index, std::size_t offset, std::size_t length,
                                       const std::string& pointer) {
  const std::string_view bytes = buffer(index).substr(0, sources_[index].byte_length);
  if (offset > bytes.size() || length > bytes.size() - offset)
    context_.fail(pointer, fmt::format("bytes {} to {} are asked for, and the buffer {} has {}", offset,
                                       offset + length, index, bytes.size()));
  return bytes.substr(offset, length);
}

std::string_view GltfDocument::buffer_view(std::size_t index) {
  const tinygltf::BufferView& view = model_->bufferViews[index];
  if (view.extensions.count("EXT_meshopt_compression") > 0) return decompressed(index);
  return part_of(std::size_t(view.buffer), view.byteOffset, view.byteLength,
                 fmt::format("/bufferViews/{}", index));
}

std::string_view GltfDocument::decompressed(std::size_t index) {
  if (views_[index]) return *views_[index];
  const tinygltf::Value& value =
      model_->bufferViews[index].extensions.find("EXT_meshopt_compression")->second;
  const auto number = [&](const char* name) {
    return value.Has(name) ? std::size_t(value.Get(name).GetNumberAsDouble()) : 0;
  };
  const auto word = [&](const char* name) {
    return value.Has(name) ? value.Get(name).Get<std::string>() : "";
  };
  const std::string pointer = fmt::format("/bufferViews/{}/extensions/EXT_meshopt_compression", index);
  const std::string_view bytes =
      part_of(number("buffer"), number("byteOffset"), number("byteLength"), pointer);
  views_[index] = decode_meshopt(bytes, {number("count"), number("byteStride"), word("mode"), word("filter")},
                                 pointer, context_);
  byte_count_ += views_[index]->size();
  return *views_[index];
}

}  // namespace twinray
