// SPDX-License-Identifier: Apache-2.0
// Private: the camera of the exchange form.
#pragma once
#include "core/camera.h"
#include "io/exchange/entry.h"
#include "io/render_defaults.h"

namespace twinray {

/// The camera that an object describes. Its frame, fitted to a picture of this size, is that of the file to
/// the bit. Throws Error with the place.
Camera read_exchange_camera(const Entry& entry, const RenderDefaults::Resolution& size);

Json exchange_camera_json(const Camera& camera);

}  // namespace twinray
