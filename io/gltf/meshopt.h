// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace twinray {

struct GltfContext;

/// What EXT_meshopt_compression says of a buffer view.
struct MeshoptView {
  std::size_t count = 0, stride = 0;  ///< Elements, and bytes of one.
  std::string mode;                   ///< "ATTRIBUTES", "TRIANGLES" or "INDICES".
  std::string filter;                 ///< "" and "NONE": none.
};

/// The decompressed bytes of a view. Throws Error, with the place, before memory is taken where the data are
/// too short for so many elements, and where they are damaged.
std::string decode_meshopt(std::string_view bytes, const MeshoptView& view, const std::string& pointer,
                           const GltfContext& context);

}  // namespace twinray
