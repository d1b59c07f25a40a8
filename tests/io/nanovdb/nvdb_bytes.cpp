// SPDX-License-Identifier: Apache-2.0
#include "tests/io/nanovdb/nvdb_bytes.h"

#define NANOVDB_USE_ZIP
#define NANOVDB_USE_BLOSC
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

#include <sstream>

namespace twinray::test {
namespace {

template <typename Made, typename Value>
nanovdb::GridHandle<> handle_of(const NvdbContent& content) {
  nanovdb::GridBuilder<Value, Made> builder(Value(content.background));
  auto accessor = builder.getAccessor();
  for (const auto& [at, value] : content.voxels)
    accessor.setValue(nanovdb::Coord(at[0], at[1], at[2]), Value(value));
  using nanovdb::GridClass;
  const GridClass fog = content.type == NvdbContent::Type::whole ? GridClass::Unknown : GridClass::FogVolume;
  builder.setGridClass(content.is_level_set ? GridClass::LevelSet : fog);
  builder.enableDithering(false);
  const auto& o = content.origin;
  return builder.getHandle(content.voxel_size, nanovdb::Vec3d(o[0], o[1], o[2]), content.name);
}

nanovdb::GridHandle<> handle_of(const NvdbContent& content) {
  using Type = NvdbContent::Type;
  switch (content.type) {
    case Type::fp4:
      return handle_of<nanovdb::Fp4, float>(content);
    case Type::fp8:
      return handle_of<nanovdb::Fp8, float>(content);
    case Type::fp16:
      return handle_of<nanovdb::Fp16, float>(content);
    case Type::fpn:
      return handle_of<nanovdb::FpN, float>(content);
    case Type::whole:
      return handle_of<std::int32_t, std::int32_t>(content);
    case Type::real:
      break;
  }
  return handle_of<float, float>(content);
}

}  // namespace

std::string nvdb_bytes(const std::vector<NvdbContent>& grids, NvdbPacking packing) {
  const auto codec = nanovdb::io::Codec(packing);
  nanovdb::io::Segment segment(codec);
  std::vector<nanovdb::GridHandle<>> handles;
  for (const NvdbContent& content : grids) handles.push_back(handle_of(content));
  std::stringstream packed;
  std::vector<std::string> bodies;
  for (const auto& handle : handles) {
    segment.add(handle);
    std::stringstream body;
    segment.meta.back().fileSize = nanovdb::io::Internal::write(body, handle, codec);
    bodies.push_back(body.str());
  }
  segment.write(packed);
  for (const std::string& body : bodies) packed << body;
  return packed.str();
}

}  // namespace twinray::test
