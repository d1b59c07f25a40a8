// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/collada_document.h"

namespace twinray {

/// Walks the whole document and warns of each element, attribute and profile that is not known, with the
/// nearest known name, and of each that is known but not supported. What does not bear on a picture (authors,
/// dates, other programs' extras) is passed over silently.
void check_names(ColladaDocument& document);

}  // namespace twinray
