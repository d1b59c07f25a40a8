// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/diagnostic.h"
#include "io/xml/reader.h"

namespace twinray {

/// Walks a whole file from its root and warns of each element, attribute and profile that is not known, with
/// the nearest known name, and of each that is known but not supported. What does not bear on a picture
/// (authors, dates, other programs' extras) is passed over silently.
void check_names(const XmlElement& root, WarningList& warnings);

/// Whether this is the profile of CS184's extensions.
bool is_cgl_profile(std::string_view profile);

}  // namespace twinray
