// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "io/gltf/context.h"

namespace twinray {
namespace {

/// The densest that the formats are: of attributes two bits say that 16 bytes are all alike; a triangle takes
/// a byte, and so does an index.
constexpr std::size_t most_bytes_a_byte = 64, most_indices_a_byte = 3;

/// Whether the library's decoders take elements of this size.
bool fits(const MeshoptView& view) {
  if (view.mode != "ATTRIBUTES") return view.stride == 2 || view.stride == 4;
  if (view.filter == "OCTAHEDRAL") return view.stride == 4 || view.stride == 8;
  if (view.filter == "QUATERNION") return view.stride == 8;
  return view.stride % 4 == 0;
}

/// Whether so many elements may come of so many bytes.
bool has_room(std::size_t bytes, const MeshoptView& view) {
  if (view.mode != "ATTRIBUTES") return view.count / most_indices_a_byte <= bytes;
  return view.count * view.stride / most_bytes_a_byte <= bytes;
}

int decode(std::string_view bytes, const MeshoptView& view, std::string& out) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  if (view.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, data, bytes.size());
  if (view.mode == "INDICES")
    return meshopt_decodeIndexSequence(out.data(), view.count, view.stride, data, bytes.size());
  return meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, data, bytes.size());
}

void apply_filter(const MeshoptView& view, std::string& out) {
  if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), view.count, view.stride);
  if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), view.count, view.stride);
  if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), view.count, view.stride);
}

}  // namespace

std::string decode_meshopt(std::string_view bytes, const MeshoptView& view, const std::string& pointer,
                           const GltfContext& context) {
  if (!fits(view))
    context.fail(pointer, fmt::format("{} of the filter \"{}\" do not have {} bytes an element", view.mode,
                                      view.filter.empty() ? "NONE" : view.filter, view.stride));
  if (view.mode == "TRIANGLES" && view.count % 3 != 0)
    context.fail(pointer, fmt::format("{} indices are not three a triangle", view.count));
  if (!has_room(bytes.size(), view))
    context.fail(pointer, fmt::format("{} elements of {} bytes cannot come of {} bytes", view.count,
                                      view.stride, bytes.size()));
  std::string out(view.count * view.stride, '\0');
  if (decode(bytes, view, out) != 0) context.fail(pointer, "the compressed data are damaged");
  apply_filter(view, out);
  return out;
}

}  // namespace twinray
