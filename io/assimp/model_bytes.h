// SPDX-License-Identifier: Apache-2.0
// Private: a model on its way from one process to another.
#pragma once
#include <string>
#include <string_view>

#include "io/obj/reader.h"

namespace twinray {

std::string model_bytes(const ObjModel& model);

/// The model again. Throws Error where the bytes are none: whoever wrote them is not trusted.
ObjModel model_of_bytes(std::string_view bytes);

}  // namespace twinray
