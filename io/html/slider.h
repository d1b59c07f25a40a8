// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace twinray::html {

/// A picture in a page.
struct Picture {
  std::string caption;  ///< Text.
  std::string address;  ///< As picture_address gives it.
  int width = 0;        ///< In pixels.
};

/// Two pictures of one size, one over the other: a slider shows the first on its left and the second on its
/// right. It moves by pointer and by arrow keys, by one line of script within the page.
std::string slider(const Picture& left, const Picture& right);

}  // namespace twinray::html
