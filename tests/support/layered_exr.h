// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <vector>

namespace twinray::test {

/// The values of each channel, row by row.
using Channels = std::map<std::string, std::vector<float>>;

/// The bytes of an OpenEXR file of 32-bit floats, not compressed ("OpenEXR File Layout").
std::string layered_exr(int width, int height, const Channels& channels);

}  // namespace twinray::test
