// SPDX-License-Identifier: Apache-2.0
// Names in UTF-8, as JSON needs them. Names of files, and in OBJ and PLY files, may be any bytes.
#pragma once
#include <string>

namespace twinray {

/// Whether the text is UTF-8, in its shortest form.
bool is_utf8(const std::string& text);

/// The text itself where it is UTF-8; else its bytes are taken for letters of Latin-1.
std::string as_utf8(const std::string& text);

}  // namespace twinray
